#include "strata/sample_check.hpp"

#include "closed/recognize.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::strata {

bool allows(GroupBound bound, const GaloisGroup& g) {
  using enum GroupType;
  const auto is = [&](std::initializer_list<GroupType> types) { return is_among(g.type, types); };
  switch (bound) {
  case GroupBound::unknown:
    return true;
  case GroupBound::SL2_or_Borel:
    return is({SL2, Borel});
  case GroupBound::torus_normaliser:
    return is({Gm, cyclic, Dinf, D});
  case GroupBound::torus_normaliser_or_T:
    return is({Gm, cyclic, Dinf, D, T});
  case GroupBound::finite_or_normaliser_or_T:
    return !is({SL2, Borel});
  case GroupBound::triangular_or_cyclic:
    return is({T, cyclic});
  case GroupBound::finite:
    return is({cyclic, D, A4, S4, A5});
  }
  return true;
}

namespace {

constexpr std::size_t most_points = 2;
constexpr std::size_t most_tries = 8;

// Small numbers, each parameter another one.
Substitution point(const std::vector<std::size_t>& variables, std::size_t k, const Ring& ring) {
  static const std::vector<Rational> values{Rational(2),     Rational(3),     Rational(7, 3),
                                            Rational(-2),    Rational(5),     Rational(1, 4),
                                            Rational(-1, 3), Rational(11, 2), Rational(1)};
  Substitution at;
  for (std::size_t i = 0; i < variables.size(); ++i)
    at[variables[i]] = MFraction(ring, values[(k + i * (k + 1)) % values.size()]);
  return at;
}

// The answer that holds at the point: that of its part, or of the whole leaf.
Part answer_at(const Leaf& leaf, const Substitution& at) {
  const ValueAt value = [&](const MFraction& f) {
    const MFraction v = substitute(f, at);
    return NfElem(is_zero(v) ? Rational(0) : to_rational(v));
  };
  for (const Part& p : leaf.parts)
    if (std::ranges::all_of(p.where, [&](const ArithmeticCondition& c) { return is_so(c, value); }))
      return p;
  return {{}, leaf.abelian, leaf.group, leaf.bound};
}

bool differ(const Part& p, const Recognized& known) {
  const ClosedAnswer& other = *known.answer;
  if (p.abelian != Truth::unknown && other.abelian != Truth::unknown && p.abelian != other.abelian)
    return true;
  if (!other.group || known.centre) return false;
  if (!p.group) return !allows(p.bound, *other.group);
  const bool same_n = !p.group->n || !other.group->n || *p.group->n == *other.group->n;
  return p.group->type != other.group->type || !same_n;
}

std::string text(const Substitution& at, const Ring& ring) {
  return joined(at,
                [&](const auto& x) { return ring->name(x.first) + " = " + to_string(x.second); });
}

} // namespace

std::optional<std::string> disagreement(const Leaf& leaf, const MFraction& r, std::size_t z,
                                        const Region& region, const Budget& budget) {
  std::vector<std::size_t> variables;
  for (std::size_t i = 0; i < r.ring()->size(); ++i)
    if (i != z) variables.push_back(i);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < most_tries && compared < most_points; ++k)
    try {
      const Substitution at = point(variables, k, r.ring());
      if (!region.admits(at)) continue;
      const auto known = recognize(to_rational_function(substitute(r, at), z), budget);
      if (!known || !known->answer) continue;
      ++compared;
      if (differ(answer_at(leaf, at), *known)) return text(at, r.ring());
    } catch (const DomainError&) {
      continue; // a denominator vanishes there
    } catch (const OutOfBudget&) {
      budget.check();
    }
  return std::nullopt;
}

} // namespace kov::strata
