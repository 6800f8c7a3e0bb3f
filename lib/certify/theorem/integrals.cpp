// First integrals of a family, or of a level of functions: theorem_certificates.md 5.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"

namespace kov::certify {

namespace {

std::vector<PhaseFunction> read_functions(const Family& y, const Node& n) {
  return mapped<PhaseFunction>(n.items(), [&](const Node& x) { return read_function(y, x); });
}

} // namespace

Said rule::integrals(Keys& step, Derivation& d) {
  const Family& y = d.family(step);
  const PhaseSpace space(y.system, d.arithmetic());
  const auto field = space.field();
  ClaimedIntegrals all{&y, {}, read_functions(y, step.at("level"))};
  for (const PhaseFunction& g : all.level)
    space.need_cleared(space.along(field, g), {}, "the level is not invariant");
  const auto claims = step.at("claims").items();
  if (claims.empty()) step.at("claims").fail("nothing is claimed");
  for (const Node& n : claims) {
    Keys c(n);
    const PhaseFunction value = read_function(y, c.at("value"));
    const auto cofactors = read_functions(y, c.at("cofactors"));
    if (cofactors.size() != all.level.size()) n.fail("a cofactor for each function is expected");
    const Functions& in = space.in();
    space.need_cleared(in.minus(space.along(field, value), in.dot(cofactors, all.level)), {},
                       "not a first integral");
    all.claims.emplace_back(c.at("name").text(), value);
    c.done();
  }
  Said f{FactKind::integrals, &y, {{}}};
  f.integrals.push_back(std::move(all));
  return f;
}

} // namespace kov::certify
