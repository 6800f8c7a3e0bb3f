// Special values of a parameter that only labels the level (the energy): where singular places of r
// merge the group may be easier to find, and one level with a non-abelian identity component proves
// non-integrability.  The paper's 1 + A - h^2 = 0 is such a value.

#include "integrability/check.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {

std::vector<MPoly> merging_locus(const MFraction& r, std::size_t z, std::size_t h) {
  std::vector<MPoly> places;
  for (auto& f : factor(r.den()).second)
    if (uses(f.base, z)) places.push_back(std::move(f.base));
  std::vector<MPoly> events;
  for (std::size_t i = 0; i < places.size(); ++i) {
    events.push_back(coefficients(places[i], z).back());
    if (degree(places[i], z) > 1) events.push_back(discriminant(places[i], z));
    for (std::size_t j = 0; j < i; ++j)
      events.push_back(resultant(places[i], places[j], z));
  }
  std::vector<MPoly> locus;
  for (const auto& e : events) {
    if (is_zero(e) || !uses(e, h)) continue;
    for (auto& f : factor(e).second)
      if (uses(f.base, h) && std::find(locus.begin(), locus.end(), f.base) == locus.end())
        locus.push_back(std::move(f.base));
  }
  std::sort(locus.begin(), locus.end(), [&](const MPoly& a, const MPoly& b) {
    return degree(a, h) != degree(b, h) ? degree(a, h) < degree(b, h) : compare(a, b) < 0;
  });
  return locus;
}

namespace {

// r, and what was assumed not to vanish, at one value of h.
EnergyResult decide_at(const AlgebraicOde& ode, std::size_t h, const ConstantField& constants,
                       const NfElem& value, const CheckOptions& options) {
  EnergyResult result;
  ConstantField at = constants;
  at.set_field(value.field());
  at.set(h, value);
  try {
    for (const auto& g : ode.generic)
      if (is_zero(at.convert(MFraction(g), ode.z))) {
        result.note = "the reduction divided by " + to_string(g) + ", which is 0 here";
        return result;
      }
    NormalForm equation;
    equation.r = at.convert(ode.r, ode.z);
    if (ode.p) equation.p = at.convert(*ode.p, ode.z);
    result.r = equation.r;
    if (!options.stop_at_r) {
      Options how = options.decide;
      how.variable = ode.r.ring()->name(ode.z);
      result.decision = decide(equation, how);
    }
  } catch (const DomainError& e) {
    result.note = e.what();
  }
  return result;
}

std::string unique_name(const Ring& ring, const std::string& wish) {
  return ring->find(wish) ? wish + "_root" : wish;
}

} // namespace

void study_energies(const System& s, const ReduceSpec& reduce, const CheckOptions& options,
                    BlockReport& block) {
  const auto h = s.ring()->find(reduce.energy_parameter);
  if (!h || !uses(block.ode->r, *h)) {
    block.note += (block.note.empty() ? "" : "; ") +
                  std::string("r does not depend on the energy '") + reduce.energy_parameter + "'";
    return;
  }
  block.special = merging_locus(block.ode->r, block.ode->z, *h);
  const auto used = used_variables(block.ode->r);
  if (std::any_of(used.begin(), used.end(), [&](std::size_t i) {
        return i != *h && std::find(s.field.parameters.begin(), s.field.parameters.end(), i) !=
                              s.field.parameters.end();
      }))
    return; // other parameters are free: the locus is the answer
  const ConstantField constants = ConstantField::make(s.field);
  const auto run = [&](const NfElem& value, std::string condition, std::string why) {
    EnergyResult e = decide_at(*block.ode, *h, constants, value, options);
    e.condition = std::move(condition);
    e.why = std::move(why);
    if (e.decision && e.decision->abelian == Truth::no) block.abelian = Truth::no;
    block.energies.push_back(std::move(e));
  };
  for (const auto& f : block.special) {
    if (used_variables(f).size() != 1 || !constants.field()->is_rational()) continue;
    const Poly minimal = to_rational_function(MFraction(f), *h).num();
    const auto [field, root] =
        field_of_root(minimal, unique_name(s.ring(), reduce.energy_parameter));
    run(root, to_string(f) + " = 0", "singular places merge");
    if (block.abelian == Truth::no) return;
  }
  for (const Rational& sample : {Rational(1), Rational(2), Rational(1, 2)}) {
    const NfElem value(sample, constants.field());
    run(value, reduce.energy_parameter + " = " + to_string(sample), "sample");
    if (block.abelian == Truth::no) return;
  }
}

} // namespace kov
