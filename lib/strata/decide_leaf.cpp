#include "strata/decide_leaf.hpp"

#include "closed/criteria.hpp"
#include "closed/parts.hpp"
#include "closed/statement.hpp"
#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "places/irrational.hpp"
#include "strata/exponent_sums.hpp"
#include "strata/exponential_families.hpp"
#include "strata/first_case.hpp"
#include "strata/needed.hpp"
#include "strata/open_exponent.hpp"
#include "strata/uniform.hpp"

#include <algorithm>
#include <limits>

namespace kov::strata {

Leaf leaf_of(const Decision& d) {
  Leaf leaf;
  leaf.abelian = d.abelian;
  leaf.group = d.group;
  leaf.by = Conclusion::number;
  leaf.because.push_back(Number{d});
  if (d.abelian == Truth::unknown) leaf.open = OpenNumber{};
  leaf.trace = d.trace;
  return leaf;
}

bool has_irregular_place(const Leaf& leaf) {
  if (leaf.scheme) {
    const auto& all = leaf.scheme->finite;
    return leaf.scheme->infinity.order > 2 ||
           std::ranges::any_of(all, [](const auto& p) { return p.order > 2; });
  }
  if (const auto* other = evidence<OtherBlocks>(leaf)) return other->irregular;
  const auto* number = evidence<Number>(leaf);
  if (number == nullptr || is_zero(number->decision.r)) return false;
  const RationalFunction& r = number->decision.r;
  const auto places = squarefree_factors(r.den());
  return order_at_infinity(r) < 2 ||
         std::ranges::any_of(places, [](const Factor& f) { return f.exponent > 2; });
}

namespace {

using LeafAnswer = std::variant<Leaf, Needs>;

GaloisGroup sl2() { return {GroupType::SL2, {}}; }

// Can f = 0 be solved for a parameter, as a function of the others or as a number?
bool can_be_solved(const MPoly& f) {
  const auto factors = factor(f).second;
  return std::ranges::all_of(factors, [](const MFactor& one) {
    const auto used = used_variables(one.base);
    return used.size() == 1 ||
           std::ranges::any_of(used, [&](std::size_t x) { return kov::degree(one.base, x) == 1; });
  });
}

class LeafDecision {
public:
  LeafDecision(const Scheme& s, const ParametrisedSet& region, const Budget& budget)
      : s_(s), region_(region), budget_(budget) {
    for (PlaceIndex i = 0; i < number_of_places(s); ++i)
      if (place_at(s, i).exponent == ExponentKind::open) open_.push_back(i);
    find_torus();
    find_logarithm();
  }

  /// A torus and a logarithm are enough.
  std::optional<Leaf> at_once() const {
    return torus_ && log_ ? std::optional(torus_and_logarithm()) : std::nullopt;
  }

  LeafAnswer by_places() {
    if (torus_ && log_) return torus_and_logarithm();
    if (!open_.empty()) return with_open_exponents();
    return torus_ ? with_torus() : with_rational_exponents();
  }

private:
  template <class Property> [[nodiscard]] bool any_place(Property has) const {
    return has(s_.infinity) || std::ranges::any_of(s_.finite, has);
  }
  void find_torus() {
    for (PlaceIndex i = 0; i < number_of_places(s_) && !torus_; ++i) {
      const ParametricPlace& p = place_at(s_, i);
      if (p.kind == PlaceKind::irregular || p.kind == PlaceKind::ramified)
        torus_ = IrregularPlace{i};
      else if (p.exponent == ExponentKind::irrational)
        torus_ = IrrationalDifference{i};
    }
  }
  void find_logarithm() {
    for (PlaceIndex i = 0; i < number_of_places(s_) && !log_; ++i) {
      const ParametricPlace& p = place_at(s_, i);
      if (p.log == Truth::yes && p.exponent == ExponentKind::rational) log_ = Logarithm{i};
    }
  }

  // The leaf that is not abelian for these reasons, and without an exponential solution where
  // none is possible.
  [[nodiscard]] Leaf not_abelian(Conclusion by, std::vector<Evidence> because,
                                 const ExponentialBound& exponential) const {
    Leaf leaf;
    leaf.abelian = Truth::no;
    leaf.by = by;
    leaf.because = std::move(because);
    leaf.bound = GroupBound::SL2_or_Borel;
    if (exponential.excludes()) {
      leaf.because.push_back(NoExponential{exponential});
      leaf.group = sl2();
    }
    return leaf;
  }

  Leaf torus_and_logarithm() const {
    return not_abelian(Conclusion::torus_log, {*torus_, *log_}, exponential_bound(s_));
  }

  // Some Delta irrational or a place irregular, everywhere: only Sym^4 matters.
  LeafAnswer with_torus() {
    auto answer = no_invariant(4, GroupBound::torus_normaliser);
    if (auto* none = std::get_if<NoInvariant>(&answer))
      return not_abelian(Conclusion::torus, {*torus_, std::move(*none)}, exponential_bound(s_));
    return lift(std::move(answer));
  }

  using Searched = std::variant<NoInvariant, Leaf, Needs>;

  static LeafAnswer lift(Searched s) {
    if (auto* leaf = std::get_if<Leaf>(&s)) return std::move(*leaf);
    return std::get<Needs>(std::move(s));
  }

  // `other`: G0 may be abelian without an invariant of degree m, if Sym^other has one.
  Searched no_invariant(long m, GroupBound group, std::optional<long> other = {}) {
    NoInvariant none{m, invariant_bound(s_, m)};
    if (!none.bound.form) return none;
    const InvariantForm& form = *none.bound.form;
    if (form.degree >= most_unknowns) return open_leaf(TooManyUnknowns{m, form.degree});
    auto found = find_invariant(s_, form, region_, budget_);
    if (auto* needs = std::get_if<Needs>(&found)) return std::move(*needs);
    if (auto& v = std::get<0>(found)) return abelian_by(*std::move(v), group);
    auto excluded = exclude_invariant(s_, form, region_, budget_);
    if (auto* needs = std::get_if<Needs>(&excluded)) return std::move(*needs);
    if (auto* u = std::get_if<Unsettled>(&excluded)) {
      MinorsVanish open{std::move(u->together)};
      if (other) open.otherwise = *other;
      return open_leaf(std::move(open));
    }
    none.excluded = std::get<Excluded>(std::move(excluded));
    return none;
  }

  [[nodiscard]] Leaf abelian_by(ParametricInvariant v, GroupBound group) const {
    Leaf leaf;
    leaf.abelian = Truth::yes;
    leaf.by = Conclusion::invariant;
    leaf.bound = torus_ ? GroupBound::torus_normaliser : group;
    if (torus_) leaf.group = with_torus_and(v);
    leaf.because.push_back(InvariantFound{std::move(v)});
    return leaf;
  }

  // v is a power of y1 y2: Gm where y1 y2 is rational, Dinf where it is a square root (strata.md
  // 10.8).
  [[nodiscard]] std::optional<GaloisGroup> with_torus_and(const ParametricInvariant& v) const {
    if (v.form.m == 2) return GaloisGroup{GroupType::Gm, {}};
    if (v.form.m != 4) return std::nullopt;
    MFraction whole(v.p);
    for (std::size_t i = 0; i < s_.finite.size(); ++i)
      whole *= pow(MFraction(s_.finite[i].q), v.form.e[i]);
    std::vector<MPoly> odd;
    for (const MPoly& side : {whole.num(), whole.den()})
      for (const MFactor& f : factor(side).second)
        if (f.exponent % 2 != 0 && uses(f.base, s_.z)) odd.push_back(f.base);
    if (odd.empty()) return GaloisGroup{GroupType::Gm, {}};
    if (!stay_simple(odd)) return std::nullopt;
    return GaloisGroup{GroupType::Dinf, {}};
  }
  // One of these polynomials in z has simple roots everywhere, and none in common with the others.
  [[nodiscard]] bool stay_simple(const std::vector<MPoly>& all) const {
    return std::ranges::any_of(all, [&](const MPoly& f) {
      if (!is_plainly_nonzero(coefficients(f, s_.z).back(), region_)) return false;
      if (kov::degree(f, s_.z) > 1 && !is_plainly_nonzero(discriminant(f, s_.z), region_))
        return false;
      return std::ranges::all_of(all, [&](const MPoly& g) {
        return &f == &g || is_plainly_nonzero(resultant(f, g, s_.z), region_);
      });
    });
  }
  // An invariant of degree 4 over Q(parameters), if there is one.
  std::optional<LeafAnswer> degree_four(long most) {
    const auto four = invariant_bound(s_, 4).form;
    if (!four || four->degree >= most) return std::nullopt;
    auto found = find_invariant(s_, *four, region_, budget_);
    if (auto* needs = std::get_if<Needs>(&found)) return std::move(*needs);
    if (auto& v = std::get<0>(found))
      return abelian_by(*std::move(v), GroupBound::torus_normaliser_or_T);
    return std::nullopt;
  }

  // All Delta are rational constants and all places regular.
  LeafAnswer with_rational_exponents() {
    const ExponentialBound exponential = exponential_bound(s_);
    if (log_ && exponential.excludes())
      return not_abelian(Conclusion::irreducible_log, {*log_}, exponential);
    if (auto needs = logarithm_first()) return *std::move(needs);
    if (auto answer = all_integral()) return *std::move(answer);
    if (auto answer = degree_four(std::numeric_limits<long>::max())) return *std::move(answer);
    return by_invariants(exponential);
  }

  // A logarithm that leaves no exponential solution is all that is needed.  So the set without it is
  // told apart before an invariant with many unknowns is looked for, if its equations can be solved.
  [[nodiscard]] std::optional<Needs> logarithm_first() const {
    constexpr long many_unknowns = 8;
    const auto form = invariant_bound(s_, 12).form;
    if (!form || form->degree < many_unknowns) return std::nullopt;
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i) {
      const auto& p = place_at(s_, i);
      if (p.log == Truth::unknown && p.log_norm && can_be_solved(*p.log_norm) &&
          exponential_bound(with_logarithm(i)).excludes())
        return Needs{*p.log_norm, {Event::Kind::logarithm_vanishes, name_of(p, s_.z)}};
    }
    return std::nullopt;
  }
  [[nodiscard]] Scheme with_logarithm(PlaceIndex i) const {
    Scheme with = s_;
    (i < with.finite.size() ? with.finite[i] : with.infinity).log = Truth::yes;
    return with;
  }
  std::optional<LeafAnswer> all_integral() const {
    if (any_place([](const ParametricPlace& p) { return !is_integer(p.delta); }))
      return std::nullopt;
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i)
      if (const auto& p = place_at(s_, i); p.log == Truth::unknown && p.log_norm)
        return Needs{*p.log_norm, {Event::Kind::logarithm_vanishes, name_of(p, s_.z)}};
    if (any_place([](const ParametricPlace& p) { return p.log != Truth::no; })) return std::nullopt;
    const bool odd = std::ranges::all_of(
        s_.finite, [](const auto& p) { return fmpz_is_odd(p.delta.num().raw()) != 0; });
    Leaf leaf;
    leaf.abelian = Truth::yes;
    leaf.by = Conclusion::half_integers;
    leaf.group = GaloisGroup{GroupType::cyclic, Integer(odd ? 1 : 2)};
    if (const auto two = invariant_bound(s_, 2).form; two && two->degree < most_unknowns)
      if (auto found = find_invariant(s_, *two, region_, budget_);
          found.index() == 0 && std::get<0>(found))
        leaf.because.push_back(InvariantFound{*std::get<0>(std::move(found))}); // for a certificate
    return leaf;
  }

  // Some choice of exponents leaves a natural number for the polynomial part.
  [[nodiscard]] bool lines_possible() const {
    const Families f = exponential_families(s_);
    return !f.complete || std::ranges::any_of(f.fixed, [](const Rational& d) {
      return is_integer(d) && sign(d) >= 0;
    });
  }

  LeafAnswer by_invariants(const ExponentialBound& exponential) {
    std::vector<Evidence> because;
    std::vector<long> degrees;
    if (log_) because.push_back(*log_);
    if (!log_) degrees.push_back(12);
    if (!exponential.excludes() && !lines_possible()) because.push_back(NoFamilies{});
    if (!exponential.excludes() && lines_possible()) {
      const Integer n = common_denominator(s_);
      if (n > Integer(200)) return open_leaf(LargeDenominator{n});
      if (log_ || n != Integer(12)) degrees.push_back(to_long(n));
    }
    for (const long m : degrees) {
      // Sym^12 is asked first: where it has no solution Sym^n may have one
      auto answer = no_invariant(
          m, m == 12 ? GroupBound::finite_or_normaliser_or_T : GroupBound::triangular_or_cyclic,
          m == degrees.back() ? std::nullopt : std::optional(degrees.back()));
      if (auto* none = std::get_if<NoInvariant>(&answer))
        because.push_back(std::move(*none));
      else
        return lift(std::move(answer));
    }
    Leaf leaf = not_abelian(Conclusion::rational, std::move(because), exponential);
    leaf.group = sl2();
    return leaf;
  }

  LeafAnswer with_open_exponents() {
    // An invariant of degree 4 for generic exponents settles all of them.
    if (auto answer = degree_four(most_unknowns)) return *std::move(answer);
    return decide_open_exponents(s_, open_, torus_, log_, region_, budget_);
  }

  const Scheme& s_;
  const ParametrisedSet& region_;
  const Budget& budget_;
  std::vector<PlaceIndex> open_;
  std::optional<Evidence> torus_; ///< why G0 contains a torus, if that is known
  std::optional<Logarithm> log_;
};

// ---- parts: strata.md, 10

// Is one of the open exponent differences without a bound?  Then those that matter are infinitely
// many, and no strata p = 0.
bool is_unbounded(const Scheme& s,
                  ParametrisedSet region) { // a copy: what it trusts proves nothing here
  for (PlaceIndex i = 0; i < number_of_places(s); ++i)
    if (const auto& p = place_at(s, i);
        p.exponent == ExponentKind::open && !bound_of_square(p, region))
      return true;
  return false;
}

bool has_real_parameters(const Scheme& s, const ParametrisedSet& region) {
  const auto used = used_variables(s.r);
  return std::ranges::any_of(used, [&](std::size_t i) { return region.is_real(i); });
}

// Yes or no on all parts; else unknown.
Truth common_answer(const std::vector<Part>& parts) {
  const Truth first = parts.front().abelian;
  const bool same = std::ranges::all_of(parts, [&](const Part& p) { return p.abelian == first; });
  return same ? first : Truth::unknown;
}

// A leaf says what it says, also where the classical criterion says it with another proof.  A part that
// says something else has no points, which was not seen: then nothing is added.
void add_closed_answer(Leaf& leaf, ClassicalAnswer answer) {
  const bool agree = std::ranges::all_of(answer.parts, [&](const Part& p) {
    return leaf.abelian == Truth::unknown || p.abelian == leaf.abelian;
  });
  if (!agree) return;
  // for the group alone a stratum is not cut into many parts
  if (leaf.abelian != Truth::unknown && answer.parts.size() > 2) return;
  const Truth common = common_answer(answer.parts);
  if (leaf.abelian == Truth::unknown && common != Truth::unknown) {
    leaf.abelian = common;
    leaf.by = Conclusion::classical;
    leaf.open.reset();
    leaf.because.clear();
  }
  leaf.because.emplace_back(std::move(answer.form));
  if (answer.parts.size() > 1) {
    leaf.parts = std::move(answer.parts);
    return;
  }
  if (!leaf.group) leaf.group = answer.parts.front().group;
  if (!leaf.group) leaf.bound = answer.parts.front().bound;
}

Leaf closed_leaf(ClassicalAnswer answer) {
  Leaf leaf = open_leaf(ByParts{});
  add_closed_answer(leaf, std::move(answer));
  return leaf;
}

// Bessel's equation: one condition, where the places leave an exponent open.
std::optional<Leaf> bessel_leaf(const Scheme& s, const ParametrisedSet& region,
                                const Budget& budget) {
  if (s.finite.size() != 1 || s.infinity.order <= 2) return std::nullopt;
  const ParametricPlace& zero = s.finite.front();
  if (zero.order != 2 || zero.degree(s.z) != 1 || zero.exponent == ExponentKind::irrational)
    return std::nullopt;
  const ParametrisedSet scratch(region); // what is asked in vain is not a trusted step
  for (const ParametrisedSet* there : {&scratch, &region}) {
    auto answer = classical_answer(s, *there, budget);
    auto* found = std::get_if<ClassicalAnswer>(&answer);
    if (found == nullptr || found->form.family != Classical::bessel) return std::nullopt;
    if (there == &region) return closed_leaf(std::move(*found));
  }
  return std::nullopt;
}

// Statements of which one holds where the identity component is abelian.
std::vector<Assertion> necessary(const Leaf& leaf) {
  const auto some = needed(leaf);
  if (!some) return {};
  std::vector<Assertion> all;
  if (some->classes)
    for (const MFraction& x : some->squares)
      all.emplace_back(SumIn{{x}, *some->classes});
  if (!some->classes || some->or_all_rational) all.emplace_back(AllRational{some->squares});
  return all;
}

// An open leaf is not abelian where what it needs fails.
void tell_open_apart(Leaf& leaf, const ParametrisedSet& region) {
  if (!leaf.scheme) return;
  std::vector<Statement> none;
  for (const Assertion& s : necessary(leaf)) {
    const Truth known = holds_on(s, none, region);
    if (known == Truth::yes) return leaf.parts.clear();
    if (known == Truth::no) continue;
    std::vector<Statement> here = none;
    here.push_back({s, true});
    leaf.parts.push_back({std::move(here)});
    none.push_back({s, false});
  }
  if (none.empty()) return;
  leaf.parts.push_back({std::move(none), Truth::no, {}, GroupBound::SL2_or_Borel});
}

// Not abelian: SL(2) where there is no exponential solution.
void tell_irreducible(Leaf& leaf, const Scheme& s, const ParametrisedSet& region) {
  if (leaf.abelian != Truth::no || leaf.group || !leaf.parts.empty()) return;
  const auto needs = exponential_needs(s);
  if (!needs) return;
  const auto* sum = std::get_if<SumIn>(&*needs);
  const Truth possible = sum == nullptr ? Truth::no : holds_on(*sum, {}, region);
  if (possible == Truth::no) leaf.group = sl2();
  if (possible != Truth::unknown) return;
  leaf.parts = {{{{*sum, true}}, Truth::no, {}, GroupBound::SL2_or_Borel},
                {{{*sum, false}}, Truth::no, sl2()}};
}

constexpr double short_search = 2e7; // products of terms: the same on every machine

// Not abelian: all triangular matrices where there is an exponential solution for all parameters, SL(2) where
// there is none.
void tell_exponential(LeafAnswer& answer, const Scheme& s, const ParametrisedSet& region,
                      const Options& options) {
  auto* leaf = std::get_if<Leaf>(&answer);
  if (leaf == nullptr || leaf->abelian != Truth::no || leaf->group || !leaf->parts.empty()) return;
  if (has_real_parameters(s, region)) return; // the group alone is not worth questions about them
  try {
    Budget little = options.budget;
    little.max_work = std::min(little.max_work, short_search);
    ExponentialSolutions found = exponential_solutions(s, region, little);
    if (found.w) {
      leaf->group = GaloisGroup{GroupType::Borel, {}};
      leaf->because.emplace_back(ExponentialFound{*std::move(found.w)});
    } else if (found.none) {
      leaf->group = sl2();
      leaf->because.emplace_back(NoFamilies{});
    } else if (options.want_group && found.needs && can_be_solved(*found.needs)) {
      answer = Needs{*std::move(found.needs), {.kind = Event::Kind::exponential_appears}};
    }
  } catch (const OutOfBudget&) { // the group is not known, the verdict is
    options.budget.check();
  }
}

LeafAnswer with_parts(LeafAnswer answer, const Scheme& s, const ParametrisedSet& region,
                      const Budget& budget) {
  auto* leaf = std::get_if<Leaf>(&answer);
  if (leaf != nullptr && evidence<ClassicalForm>(*leaf) != nullptr) return answer;
  if (leaf != nullptr && leaf->abelian != Truth::unknown && leaf->group) return answer;
  // the group alone is not worth questions about real numbers
  const bool maps =
      leaf == nullptr || leaf->abelian == Truth::unknown || !has_real_parameters(s, region);
  auto closed = classical_answer(s, region, budget, maps);
  if (leaf == nullptr && (closed.index() == 0 || !is_unbounded(s, region))) return answer;
  if (auto* needs = std::get_if<Needs>(&closed)) return std::move(*needs);
  if (auto* found = std::get_if<ClassicalAnswer>(&closed)) {
    if (leaf == nullptr) return closed_leaf(std::move(*found));
    add_closed_answer(*leaf, std::move(*found));
  } else if (leaf->open) {
    tell_open_apart(*leaf, region);
  } else {
    tell_irreducible(*leaf, s, region);
  }
  return answer;
}

// A decision by the places comes with a certificate; where that is a long search, the classical criterion
// of a classical equation is taken first.
LeafAnswer places_or_closed_answer(const std::shared_ptr<const Scheme>& s,
                                   const ParametrisedSet& region, const Budget& budget) {
  try {
    Budget little = budget;
    little.max_work = std::min(budget.max_work, short_search);
    return decide_by_places(s, region, little);
  } catch (const OutOfBudget&) {
    budget.check();
  }
  const ParametrisedSet scratch(region); // what is asked in vain is not a trusted step
  if (classical_answer(*s, scratch, budget).index() == 0)
    return decide_by_places(s, region, budget);
  auto closed = classical_answer(*s, region, budget);
  if (auto* needs = std::get_if<Needs>(&closed)) return std::move(*needs);
  return closed_leaf(std::get<ClassicalAnswer>(std::move(closed)));
}

bool depends_on_parameters(const MFraction& r, std::size_t z) {
  const auto used = used_variables(r);
  return std::ranges::any_of(used, [&](std::size_t i) { return i != z; });
}

// p = 0 is not a stratum with one parameter less, nor a number.
bool cannot_be_solved(const MPoly& p, const ParametrisedSet& region) {
  return used_variables(p).size() > 1 &&
         std::holds_alternative<ParametrisedSet::Stuck>(region.where_zero(p));
}

LeafAnswer with_scheme(LeafAnswer answer, const std::shared_ptr<const Scheme>& s) {
  if (auto* leaf = std::get_if<Leaf>(&answer)) leaf->scheme = s;
  return answer;
}

} // namespace

LeafAnswer decide_by_places(const std::shared_ptr<const Scheme>& s, const ParametrisedSet& region,
                            const Budget& budget) {
  return with_scheme(LeafDecision(*s, region, budget).by_places(), s);
}

LeafAnswer decide_leaf(const MFraction& r, std::size_t z, const ParametrisedSet& region,
                       const Options& options) {
  if (is_zero(r) || !depends_on_parameters(r, z)) {
    NormalForm equation;
    if (!is_zero(r)) equation.r = to_rational_function(r, z);
    return leaf_of(decide(equation, options));
  }
  auto places = scheme(r, z, region, options.budget);
  if (auto* needs = std::get_if<Needs>(&places)) {
    if (cannot_be_solved(needs->p, region))
      if (auto leaf = abelian_for_all(r, z, region, options.budget)) return *std::move(leaf);
    return std::move(*needs);
  }
  const auto s = std::make_shared<const Scheme>(std::get<Scheme>(std::move(places)));
  auto first = LeafDecision(*s, region, options.budget).at_once();
  if (!first) first = bessel_leaf(*s, region, options.budget);
  auto answer = first ? *std::move(first) : places_or_closed_answer(s, region, options.budget);
  answer = with_scheme(with_parts(std::move(answer), *s, region, options.budget), s);
  tell_exponential(answer, *s, region, options);
  if (auto* leaf = std::get_if<Leaf>(&answer); leaf != nullptr && options.want_trace)
    leaf->trace = first_case(*s, region, options.budget);
  return answer;
}

} // namespace kov::strata
