#include "jets/words.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "literature/literature.hpp"

namespace kov::jets {

const std::string& theorem() { return morales_ramis_simo().name; }

std::vector<std::string> trusted(const HigherObstruction& o) {
  if (!o.certificate.empty()) return {};
  std::vector<std::string> all{"the series of the higher variational equations"};
  if (o.group && !o.group->checked) all.emplace_back("the group of the normal equation");
  return all;
}

std::string level(const HigherObstruction& o) {
  switch (o.because) {
  case InfiniteGroup::decided:
    return "at the energy H = " + to_string(*o.energy);
  case InfiniteGroup::homogeneous:
    return "for all but finitely many values of the energy";
  default:
    return "for all but countably many values of the energy";
  }
}

namespace {

std::string why_infinite(const HigherObstruction& o) {
  switch (o.because) {
  case InfiniteGroup::decided:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite: " +
           kov::reason(*o.group);
  case InfiniteGroup::homogeneous:
    return "the identity component of the group of the normal equation, which is homogeneous with "
           "exponents in the first family, is Ga, and its quadratic form does not commute with R";
  case InfiniteGroup::equilibria:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite: not all of its exponents at equilibria are rational, because the sum of "
           "their "
           "squares is not a sum of " +
           std::to_string(o.place.degree - 1) + " squares of rational numbers";
  default:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite, as that of its highest terms is, whose exponents are in the first family";
  }
}

// "R(c1, c2) = 3*c2*c1^3", and what stands for the energy if it occurs
std::string residue(const HigherOrders& orders) {
  const InvariantPlane& plane = *orders.plane;
  const MFraction& form = orders.obstruction->logarithm.form;
  const auto name = [&](std::size_t i) { return plane.ring->name(i); };
  return "R(" + name(plane.c1) + ", " + name(plane.c2) + ") = " + to_factored_string(form) +
         (uses(form, plane.energy) ? ", " + name(plane.energy) + " the energy" : "");
}

} // namespace

std::string reason(const HigherOrders& orders) {
  KOV_ENSURE(orders.obstruction.has_value());
  const HigherObstruction& o = *orders.obstruction;
  return "VE_" + std::to_string(o.logarithm.order) +
         " is the first with a logarithm at infinity on the curve (exponents " +
         to_string(o.place.rho1) + ", " + to_string(o.place.rho2) +
         (o.place.sign < 0 ? ", the place -infinity" : "") +
         (o.within.empty() ? "" : ", in the subspace " + o.within) + "), with the residue " +
         residue(orders) + "; " + why_infinite(o);
}

} // namespace kov::jets
