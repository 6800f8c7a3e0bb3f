#include "integrability/monodromy_opinion.hpp"

#include "monodromy/stokes.hpp"

namespace kov {
namespace {

bool is_reducible(GroupType t) {
  return t == GroupType::Borel || t == GroupType::T || t == GroupType::Gm || t == GroupType::cyclic;
}

bool is_finite(GroupType t) {
  return t == GroupType::cyclic || t == GroupType::D || t == GroupType::A4 || t == GroupType::S4 ||
         t == GroupType::A5;
}

std::string against_sl2(const Decision& d) {
  if (d.group && d.group->type != GroupType::SL2) return "the group is " + describe(*d.group);
  if (d.component && *d.component != Connected::sl2)
    return "the identity component is " + to_string(*d.component);
  if (d.abelian == Truth::yes) return "the identity component is abelian";
  if (d.kovacic_case && *d.kovacic_case != 4)
    return "Kovacic's case " + std::to_string(*d.kovacic_case) + " occurs";
  return {};
}

} // namespace

MonodromyOpinion monodromy_opinion(const RationalFunction& r, long digits, const Budget& budget,
                                   bool with_certificate) {
  MonodromyOpinion o;
  try {
    const RationalFunction none(0);
    const monodromy::Request request{digits, {}, budget};
    const monodromy::Monodromy loops = monodromy::monodromy(none, -r, request);
    monodromy::Monodromy m = loops; // elements of the group
    o.loops = m.loops.size();
    if (const auto stokes = monodromy::stokes_at_infinity(none, -r, m.base, request))
      for (const monodromy::StokesMatrix& s : stokes->matrices)
        m.loops.push_back({{}, s.matrix});
    o.stokes = m.loops.size() - o.loops;
    o.sl2 = monodromy::prove_sl2(m, budget);
    if (o.sl2) {
      if (with_certificate)
        o.proof = sl2_certificate("y'' = r y, r = " + to_string(r), monodromy::companion(none, -r),
                                  loops, budget);
      return o;
    }
    o.irreducible = monodromy::prove_irreducible(m);
    o.infinite = monodromy::prove_infinite(m, budget);
  } catch (const OutOfBudget& limit) {
    o.limit = limit.what();
  }
  return o;
}

std::string contradiction(const MonodromyOpinion& o, const Decision& d) {
  if (o.sl2) return against_sl2(d);
  if (o.irreducible && d.group && is_reducible(d.group->type))
    return "the group is " + describe(*d.group) + ", which is reducible";
  if (o.irreducible && d.kovacic_case && *d.kovacic_case == 1)
    return "an exponential solution exists";
  if (o.infinite && d.group && is_finite(d.group->type))
    return "the group is " + describe(*d.group) + ", which is finite";
  if (o.infinite && d.component && *d.component == Connected::trivial)
    return "the identity component is trivial";
  return {};
}

} // namespace kov
