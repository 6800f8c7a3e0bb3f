#include "strata/leaf_certificate.hpp"

#include "closed/criteria.hpp"
#include "exact/error.hpp"
#include "exact/to_poly.hpp"
#include "places/irrational.hpp"
#include "strata/classical_certificate.hpp"
#include "strata/decide_leaf.hpp"

#include <algorithm>

namespace kov::strata {

const char* to_string(Gap gap) {
  switch (gap) {
  case Gap::rule:
    return "no rule for the theorem";
  case Gap::places:
    return "no exact proof that the places stay apart";
  case Gap::irrational:
    return "no exact proof that an exponent difference is irrational";
  case Gap::bound:
    return "no exact proof of a bound of an exponent difference";
  case Gap::difference:
    return "no exact proof that an exponent difference avoids a value";
  case Gap::degree:
    return "no rule for an open exponent difference of degree > 1";
  case Gap::invariant:
    return "no exact proof about a symmetric power";
  case Gap::logarithm:
    return "no exact proof of a logarithm, or no rule for it";
  case Gap::number:
    return "no certificate of the equation without parameters";
  case Gap::relation:
    return "an equation between parameters is used as a relation, and the format has no rule for "
           "relations";
  case Gap::division:
    return "division by a polynomial without an exact proof that it is not 0";
  case Gap::assumption:
    return "an assumed equation is not recognised";
  case Gap::emptiness:
    return "no exact proof that the stratum is empty";
  }
  return "";
}

std::string rule_name(Conclusion theorem) {
  switch (theorem) {
  case Conclusion::none:
    return "memberships that contradict each other";
  case Conclusion::half_integers:
    return "exponents in Z/2 without an invariant";
  case Conclusion::no_products:
    return "an exponent difference without a bound";
  case Conclusion::assumed_integers:
    return "an exponent difference that is not an integer";
  case Conclusion::classical:
    return "the classical criterion of a known equation";
  default:
    return "this theorem";
  }
}

certify::Certificate number_certificate(const Decision& d) {
  if (d.certificate.empty())
    throw NoProof(Gap::number,
                  d.no_certificate.empty() ? "no certificate was asked for" : d.no_certificate);
  return certify::read_certificate(d.certificate);
}

namespace {

using certify::AbsentInvariant;
using certify::ByInvariant;
using certify::ByPlaces;
using certify::LeafNode;
using certify::StratumPlace;

// The name of the rule that shows "not abelian" by the places, or null.
const char* rule_of(Conclusion by) {
  switch (by) {
  case Conclusion::torus_log:
    return "torus-log";
  case Conclusion::irreducible_log:
    return "irreducible-log";
  case Conclusion::torus:
    return "torus";
  case Conclusion::rational:
    return "rational";
  case Conclusion::one_open:
    return "one-open";
  case Conclusion::several_open:
    return "open";
  case Conclusion::separated:
    return "separated";
  default:
    return nullptr;
  }
}

// The polynomials chi_i of the format: chi without denominators.
std::vector<MPoly> cleared(const std::vector<MFraction>& chi, const Ring& ring) {
  MPoly common(ring, Integer(1));
  for (const auto& c : chi)
    if (!is_zero(c)) common = common * exact_div(c.den(), gcd(common, c.den()));
  std::vector<MPoly> all;
  all.reserve(chi.size());
  for (const auto& c : chi)
    all.push_back(is_zero(c) ? MPoly(ring) : (c * MFraction(common)).num());
  for (std::size_t i = 0; i < chi.size(); ++i) // num() keeps no integer denominator
    KOV_ENSURE(MFraction(all[i]) == chi[i] * MFraction(common));
  return all;
}

// A prime modulo which the polynomials in x have no common root.
std::optional<mp_limb_t> separating_prime(const std::vector<MPoly>& polynomials, std::size_t x) {
  mp_limb_t p = 1UL << 30;
  for (int attempt = 0; attempt < 20; ++attempt) {
    p = n_nextprime(p, 1);
    NmodPoly common = to_poly(polynomials.front(), x, p);
    if (kov::degree(common) != degree(polynomials.front(), x)) continue;
    for (const auto& f : polynomials)
      common = gcd(common, to_poly(f, x, p));
    if (kov::degree(common) <= 0) return p;
  }
  return std::nullopt;
}

class LeafWriter {
public:
  LeafWriter(const Leaf& leaf, const ParametrisedSet& region, KnownFacts& facts,
             std::vector<Lemma>& lemmas, const Budget& budget)
      : leaf_(leaf), s_(*leaf.scheme), region_(region), facts_(facts), lemmas_(lemmas),
        budget_(budget) {}

  ByInvariant invariant(const ParametricInvariant& v) {
    leading_coefficients();
    const auto c = coefficients(v.p, s_.z);
    if (std::ranges::none_of(c, [&](const MPoly& f) { return facts_.ensure_nonzero(f, lemmas_); }))
      throw NoProof(Gap::invariant, "the invariant may vanish");
    ByInvariant by{content(), v.p, {}, v.form.m};
    for (std::size_t i = 0; i < s_.finite.size(); ++i)
      by.places.push_back({s_.finite[i].q, s_.finite[i].order, Integer(v.form.e[i])});
    return by;
  }

  ByPlaces places() {
    leading_coefficients();
    separate_places();
    ByPlaces by{rule_of(leaf_.by), content(), {}, {}, {}};
    for (const auto& p : s_.finite) {
      by.places.push_back({.q = p.q, .order = p.order});
      describe(p, by.places.back());
    }
    describe(s_.infinity, by.infinity);
    for (const Evidence& e : leaf_.because) {
      if (const auto* bound = std::get_if<DifferenceBound>(&e))
        write(*bound, bound->place < by.places.size() ? by.places[bound->place] : by.infinity);
      if (const auto* values = std::get_if<ExcludedDifferences>(&e)) write(*values);
      if (const auto* nowhere = std::get_if<SeparatedNowhere>(&e)) {
        by.growth = nowhere->growth;
        write(*nowhere,
              nowhere->third < by.places.size() ? by.places[nowhere->third] : by.infinity);
        if (by.growth) write_growth(*nowhere, by);
      }
    }
    if (asks_open_places()) by.absent = absent();
    return by;
  }

  // No logarithm is known where the format cannot show it.
  [[nodiscard]] std::optional<Scheme> with_fewer_logarithms() {
    std::optional<Scheme> fewer;
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i) {
      const ParametricPlace& p = place_at(s_, i);
      if (!is_regular_logarithm(p) || p.delta == Rational(0)) continue;
      if (p.degree(s_.z) == 1 && facts_.ensure_nonzero(*p.log_norm, lemmas_)) continue;
      if (!fewer) fewer = s_;
      (i < s_.finite.size() ? fewer->finite[i] : fewer->infinity).log = Truth::unknown;
    }
    return fewer;
  }

private:
  static bool is_regular_logarithm(const ParametricPlace& p) {
    return p.kind == PlaceKind::regular && p.exponent == ExponentKind::rational &&
           p.log == Truth::yes;
  }

  void need(const MPoly& p, const char* what, Gap gap = Gap::places) {
    if (!facts_.ensure_nonzero(p, lemmas_))
      throw NoProof(gap, std::string(what) + ": " + brief(MFraction(p), 120) +
                             " != 0 has no exact proof");
  }

  [[nodiscard]] MPoly content() const {
    MPoly den = s_.r.den();
    for (const auto& p : s_.finite)
      den = exact_div(den, pow(p.q, static_cast<unsigned long>(p.order)));
    return den;
  }
  void leading_coefficients() {
    need(content(), "the content of the denominator");
    for (const auto& p : s_.finite)
      need(coefficients(p.q, s_.z).back(), "a leading coefficient");
  }
  void separate_places() {
    for (std::size_t i = 0; i < s_.finite.size(); ++i) {
      const MPoly& q = s_.finite[i].q;
      if (degree(q, s_.z) > 1) need(resultant(q, derivative(q, s_.z), s_.z), "a discriminant");
      for (std::size_t j = 0; j < i; ++j)
        need(resultant(q, s_.finite[j].q, s_.z), "a resultant");
      if (s_.finite[i].order != 2) need(resultant(q, s_.r.num(), s_.z), "the order of a pole");
    }
    const long o = s_.infinity.order;
    if (o == 1 || o >= 3) need(coefficients(s_.r.num(), s_.z).back(), "the order at infinity");
  }

  // chi, irrational, log
  void describe(const ParametricPlace& p, StratumPlace& x) {
    if (p.kind != PlaceKind::regular) return;
    x.chi = cleared(p.chi, s_.r.ring());
    need(x.chi.back(), "chi");
    if (p.exponent == ExponentKind::irrational) x.irrational = irrational(x.chi);
    if (p.exponent == ExponentKind::open && x.chi.size() != 2 && asks_open_places())
      throw NoProof(Gap::degree, "an open exponent of degree > 1");
    x.log = is_regular_logarithm(p) && p.delta != Rational(0);
  }

  // The rule that shows it: the solver's own sign proofs may rest on Z3.
  std::string irrational(const std::vector<MPoly>& chi) {
    if (chi.size() == 2 && (is_zero(chi[0]) || is_constant(MFraction(chi[0], chi[1]))))
      return "constant";
    for (const bool negative : {false, true})
      if (std::ranges::all_of(chi, [&](const MPoly& c) {
            return facts_.ensure_positive(negative ? -c : c, lemmas_);
          }))
        return "positive";
    if (chi.size() == 3) {
      const MPoly four(s_.r.ring(), Integer(4));
      if (std::ranges::all_of(chi, [&](const MPoly& c) { return facts_.is_real(c); }) &&
          facts_.ensure_positive(four * chi[2] * chi[0] - chi[1] * chi[1], lemmas_))
        return "discriminant";
    }
    throw NoProof(Gap::irrational, "that an exponent is irrational has no exact proof");
  }

  // B - Delta^2 = (B chi_1 + chi_0) chi_1/chi_1^2
  void write(const DifferenceBound& bound, StratumPlace& x) {
    if (x.chi.size() != 2) throw NoProof(Gap::degree, "an open exponent of degree > 1");
    const MPoly num(s_.r.ring(), bound.square.num());
    const MPoly den(s_.r.ring(), bound.square.den());
    const MPoly room = (num * x.chi[1] + den * x.chi[0]) * x.chi[1];
    if (!is_zero(room) && !facts_.ensure_positive(room, lemmas_))
      throw NoProof(Gap::bound, "no bound of Delta^2 has an exact proof");
    x.bound = bound.square;
  }

  void write(const SeparatedNowhere& nowhere, StratumPlace& third) {
    if (nowhere.bound) write(DifferenceBound{nowhere.third, *nowhere.bound}, third);
    for (const MPoly& f : nowhere.nonzero)
      if (!facts_.ensure_nonzero(f, lemmas_))
        throw NoProof(Gap::difference, "an exponent difference is not excluded: " +
                                           brief(MFraction(f), 120) + " != 0 has no exact proof");
  }
  // 2 (d1^2 + d2^2) - factor Delta^2 + shift >= 0
  void write_growth(const SeparatedNowhere& nowhere, const ByPlaces& by) {
    const auto& third = nowhere.third < by.places.size() ? by.places[nowhere.third] : by.infinity;
    const auto& [factor, shift] = *by.growth;
    const auto& c = by.places[nowhere.pair.front()].chi;
    const auto& e = third.chi;
    const auto number = [&](const Rational& x, const MPoly& f) {
      return MFraction(s_.r.ring(), x) * MFraction(f);
    };
    const MFraction room = number(Rational(-2), c[1]) * MFraction(e[1]) +
                           number(factor, c[2]) * MFraction(e[0]) +
                           number(shift, c[2]) * MFraction(e[1]);
    const MPoly four(s_.r.ring(), Integer(4));
    if (!facts_.ensure_positive(four * c[2] * c[0] - c[1] * c[1], lemmas_))
      throw NoProof(Gap::irrational, "that two squares are conjugate has no exact proof");
    if (is_zero(room)) return;
    if (!facts_.is_real(e[1]) || !facts_.ensure_positive(room.num() * c[2] * e[1], lemmas_))
      throw NoProof(Gap::bound, "a bound of exponent differences has no exact proof");
  }

  void write(const ExcludedDifferences& excluded) {
    const ParametricPlace& p = place_at(s_, excluded.place);
    if (p.chi.size() != 2) throw NoProof(Gap::degree, "an open exponent of degree > 1");
    for (const Rational& v : excluded.values)
      if (!facts_.ensure_nonzero(where_square_is(p, v * v), lemmas_))
        throw NoProof(Gap::difference, "Delta != " + kov::to_string(v) + " has no exact proof");
  }

  // A logarithm with a torus or without a line is enough, whatever the other places are.
  [[nodiscard]] bool asks_open_places() const {
    return leaf_.by != Conclusion::torus_log && leaf_.by != Conclusion::irreducible_log;
  }

  std::vector<AbsentInvariant> absent() {
    std::vector<AbsentInvariant> all;
    for (const Evidence& e : leaf_.because)
      if (const auto* none = std::get_if<NoInvariant>(&e); none != nullptr && none->excluded)
        all.push_back(absent(none->m, *none->excluded));
    if (const auto m = implied_degree())
      if (const auto form = invariant_bound(s_, *m).form) all.push_back(implied(*form));
    return all;
  }

  // If Sym^12 has no solution, Sym^m has none for the divisors m of 12: v^(12/m) would be one.
  // The rule "rational" wants to see the minors of Sym^m all the same.
  [[nodiscard]] std::optional<long> implied_degree() const {
    if (leaf_.by != Conclusion::rational || evidence<NoExponential>(leaf_) != nullptr ||
        evidence<NoFamilies>(leaf_) != nullptr)
      return std::nullopt;
    const long m = to_long(common_denominator(s_));
    const bool shown = std::ranges::any_of(leaf_.because, [&](const Evidence& e) {
      const auto* none = std::get_if<NoInvariant>(&e);
      return none != nullptr && none->m == m;
    });
    return shown ? std::nullopt : std::optional(m);
  }
  AbsentInvariant implied(const InvariantForm& form) {
    const auto answer = exclude_invariant(s_, form, region_, budget_);
    const auto* excluded = std::get_if<Excluded>(&answer);
    if (excluded == nullptr)
      throw NoProof(Gap::invariant, "Sym^" + std::to_string(form.m) + " is not excluded");
    return absent(form.m, *excluded);
  }

  AbsentInvariant absent(long m, const Excluded& excluded) {
    const MPoly one(s_.r.ring(), Integer(1));
    AbsentInvariant x{m, {}, {}};
    for (const auto& minor : excluded.minors)
      x.minors.push_back({minor.rows, one});
    if (excluded.minors.size() == 1)
      need(excluded.minors.front().value, "a minor", Gap::invariant);
    else
      x.prime = without_common_root(excluded.minors);
    return x;
  }

  // A prime modulo which the minors, without the factors that are known, stay without a common
  // root.
  mp_limb_t without_common_root(const std::vector<MaximalMinor>& minors) {
    std::vector<MPoly> rest;
    for (const auto& minor : minors) {
      for (const auto& f : irreducible_parts(minor.value))
        (void)facts_.ensure_nonzero(f, lemmas_);
      rest.push_back(facts_.without_known_factors(minor.value));
    }
    const auto p = separating_prime(rest, used_variables(minors.front().value).front());
    if (!p) throw NoProof(Gap::invariant, "no prime separates the minors");
    return *p;
  }

  const Leaf& leaf_;
  const Scheme& s_;
  const ParametrisedSet& region_;
  KnownFacts& facts_;
  std::vector<Lemma>& lemmas_;
  const Budget& budget_;
};

// The leaf by the places alone, without the classical criteria; a classical criterion may have been taken
// because that is a long search.
Leaf by_places(const Leaf& leaf, const std::shared_ptr<const Scheme>& s,
               const ParametrisedSet& region, const Budget& budget, const NoProof& otherwise) {
  constexpr double short_search = 1e6;
  Budget allowed = budget;
  if (leaf.by == Conclusion::classical) allowed.max_work = std::min(budget.max_work, short_search);
  try {
    auto answer = decide_by_places(s, region, allowed);
    if (const auto* other = std::get_if<Leaf>(&answer); other && other->abelian == leaf.abelian)
      return *other;
  } catch (const OutOfBudget&) {
    budget.check();
  }
  throw otherwise;
}

// The classical criterion of the classical equation that a leaf is, if it is one.
std::optional<ClassicalAnswer> closed_answer(const Leaf& leaf, const ParametrisedSet& region,
                                             const Budget& budget) {
  if (evidence<ClassicalForm>(leaf) == nullptr) return std::nullopt;
  auto answer = classical_answer(*leaf.scheme, ParametrisedSet(region), budget);
  auto* found = std::get_if<ClassicalAnswer>(&answer);
  return found != nullptr ? std::optional(std::move(*found)) : std::nullopt;
}

} // namespace

LeafNode leaf_certificate(const Leaf& leaf, const MFraction& r, const ParametrisedSet& region,
                          KnownFacts& facts, std::vector<Lemma>& lemmas, const Budget& budget) {
  if (const auto* number = evidence<Number>(leaf))
    return {leaf.abelian == Truth::yes, certify::ByNumber{number_certificate(number->decision)}};
  const NoProof no_rule(Gap::rule, "the format has no rule for " + rule_name(leaf.by));
  if (!leaf.scheme || !(leaf.scheme->r == r)) throw no_rule;
  const auto written = [&](const Leaf& one) -> std::optional<LeafNode> {
    LeafWriter writer(one, region, facts, lemmas, budget);
    if (const auto* found = evidence<InvariantFound>(one))
      return LeafNode{true, writer.invariant(found->v)};
    if (rule_of(one.by) == nullptr) return std::nullopt;
    return LeafNode{false, writer.places()};
  };
  const auto by_rules = [&]() -> std::optional<LeafNode> {
    const bool invariant = evidence<InvariantFound>(leaf) != nullptr;
    auto fewer = invariant
                     ? std::nullopt
                     : LeafWriter(leaf, region, facts, lemmas, budget).with_fewer_logarithms();
    if (fewer) {
      const auto weaker = std::make_shared<const Scheme>(*std::move(fewer));
      const NoProof no_log(Gap::logarithm, "a logarithm has no exact proof that the format shows");
      return written(by_places(leaf, weaker, region, budget, no_log));
    }
    if (leaf.by == Conclusion::classical)
      return written(by_places(leaf, leaf.scheme, region, budget, no_rule));
    return written(leaf);
  };
  // the places first: they say more of the equation than a classical criterion does
  const auto closed = [&]() -> std::optional<LeafNode> {
    const auto answer = closed_answer(leaf, region, budget);
    if (!answer) return std::nullopt;
    return classical_leaf(*answer, leaf.abelian, region, facts, lemmas);
  };
  try {
    if (auto node = by_rules()) return *std::move(node);
  } catch (const NoProof&) {
    if (auto node = closed()) return *std::move(node);
    throw;
  }
  if (auto node = closed()) return *std::move(node);
  throw no_rule;
}

std::optional<LeafNode> criterion_certificate(const Leaf& leaf, const MFraction& r,
                                              const ParametrisedSet& region, KnownFacts& facts,
                                              std::vector<Lemma>& lemmas, const Budget& budget) {
  const bool told = !leaf.parts.empty() && std::ranges::none_of(leaf.parts, [](const Part& p) {
    return p.abelian == Truth::unknown;
  });
  if (!told || !leaf.scheme || !(leaf.scheme->r == r)) return std::nullopt;
  const auto answer = closed_answer(leaf, region, budget);
  if (!answer) return std::nullopt;
  return classical_leaf(*answer, Truth::unknown, region, facts, lemmas);
}

} // namespace kov::strata
