#include "jets/words.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"

namespace kov::jets {

const std::string& theorem() {
  static const std::string name = "Morales-Ruiz, Ramis and Simo (2007)";
  return name;
}

std::string level(const HigherObstruction& o) {
  return o.energy ? "at the energy H = " + to_string(*o.energy)
                  : "for all but countably many values of the energy";
}

std::string reason(const HigherOrders& orders) {
  KOV_ENSURE(orders.obstruction.has_value());
  const HigherObstruction& o = *orders.obstruction;
  const std::string infinite =
      o.energy ? "it is decided: " + kov::reason(*o.group)
               : "that of its highest terms is, whose exponents belong to the first family";
  return "VE_" + std::to_string(o.logarithm.order) +
         " is the first with a logarithm at infinity on the curve (exponents " + to_string(o.rho1) +
         ", " + to_string(o.rho2) + (o.sign < 0 ? ", the place -infinity" : "") +
         "), with the residue R(c1, c2) = " + to_factored_string(o.logarithm.form) +
         "; no quadratic form but 0 commutes with R, and the group of the normal equation is "
         "infinite (" +
         infinite + ")";
}

} // namespace kov::jets
