#include "strata/open_exponent.hpp"

#include "certify/equation/bounds.hpp"
#include "exact/error.hpp"
#include "places/irrational.hpp"
#include "strata/bounds.hpp"
#include "strata/separated.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {
namespace {

using Values = std::set<Rational>;

bool is_natural(const Rational& x) { return is_integer(x) && sign(x) >= 0; }

class OpenDifferences {
public:
  OpenDifferences(const Scheme& s, const std::vector<PlaceIndex>& open,
                  const std::optional<Evidence>& torus, const std::optional<Logarithm>& log,
                  const ParametrisedSet& region, const Budget& budget)
      : s_(s), open_(open), torus_(torus), log_(log), region_(region), budget_(budget) {}

  std::variant<Leaf, Needs> run() {
    if (torus_)
      if (auto three = separated_leaf(s_, *torus_, region_))
        if (auto* leaf = std::get_if<Leaf>(&*three); leaf && leaf->abelian == Truth::no)
          return std::move(*leaf);
    NoInvariant four{4, invariant_bound(s_, 4)};
    if (four.bound.form) {
      auto excluded = exclude_invariant(s_, *four.bound.form, region_, budget_);
      if (auto* n = std::get_if<Needs>(&excluded)) return std::move(*n);
      if (auto* u = std::get_if<Unsettled>(&excluded))
        return open_leaf(MinorsVanish{std::move(u->together), some_difference()});
      four.excluded = std::get<Excluded>(std::move(excluded));
    }
    known_.emplace_back(std::move(four));
    find_bounds();
    if (exponential_.excludes() && log_) {
      known_.emplace_back(*log_);
      return not_abelian(Conclusion::irreducible_log, true);
    }
    if (open_.size() == 1 && first().chi.size() == 2) return one_difference();
    if (!bounded() || (!torus_ && !exponential_.excludes())) return open_leaf(some_difference());
    return several();
  }

private:
  [[nodiscard]] const ParametricPlace& first() const { return place_at(s_, open_[0]); }
  [[nodiscard]] bool bounded() const {
    return std::ranges::all_of(bounds_, [](const auto& b) { return b.has_value(); });
  }

  // The bounds are of |Re Delta|^2 where Delta^2 is real.
  void find_bounds() {
    bool real = true;
    for (const PlaceIndex i : open_) {
      const ParametricPlace& p = place_at(s_, i);
      real = real && p.chi.size() == 2;
      bounds_.push_back(bound_of_square(p, region_));
      if (bounds_.back()) known_.emplace_back(DifferenceBound{i, *bounds_.back()});
    }
    std::optional<Rational> largest;
    for (const auto& b : bounds_)
      if (bounded() && real && (!largest || *b > *largest)) largest = b;
    exponential_ = exponential_bound(s_, largest);
  }

  [[nodiscard]] Leaf not_abelian(Conclusion by, bool irreducible) const {
    Leaf leaf;
    leaf.abelian = Truth::no;
    leaf.by = by;
    leaf.because = known_;
    if (torus_) leaf.because.push_back(*torus_);
    if (exponential_.excludes()) leaf.because.emplace_back(NoExponential{exponential_});
    if (irreducible) leaf.group = GaloisGroup{GroupType::SL2, {}};
    leaf.bound = GroupBound::SL2_or_Borel;
    return leaf;
  }

  // The multiples of 1/2 for which a product y1 y2 with rational square is possible.
  [[nodiscard]] std::optional<Values> half_integers(const Rational& most) const {
    const Families f = product_families(s_, first());
    if (!f.complete) return std::nullopt;
    Values values;
    if (log_) return values; // no logarithms there
    for (long k = 1; Rational(k, 2) <= most; ++k)
      if (product_possible(f, k)) values.insert(Rational(k, 2));
    return values;
  }
  [[nodiscard]] bool product_possible(const Families& f, long k) const {
    const long n = first().degree(s_.z);
    for (const auto& fixed : f.fixed)
      for (long j = -n; j <= n; ++j)
        if (is_natural((fixed + Rational(j * k)) * Rational(1, 2))) return true;
    return false;
  }

  // Delta = a/N, N <= 5, with D_12 >= 0 and local orders that a finite primitive group has.
  [[nodiscard]] Values primitive(const Rational& most) const {
    Values values;
    if (log_) return values;
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i)
      if (const auto& p = place_at(s_, i);
          i != open_[0] && (p.exponent != ExponentKind::rational || p.delta.den() > Integer(5)))
        return values;
    for (long n = 1; n <= 5; ++n)
      for (long a = 1; Rational(a, n) <= most; ++a) {
        Scheme there = s_;
        for (auto* p : {&there.infinity})
          fix(*p, Rational(a, n));
        for (auto& p : there.finite)
          fix(p, Rational(a, n));
        if (invariant_bound(there, 12).form) values.insert(Rational(a, n));
      }
    return values;
  }
  static void fix(ParametricPlace& p, const Rational& delta) {
    if (p.exponent != ExponentKind::open) return;
    p.exponent = ExponentKind::rational;
    p.delta = delta;
    p.log = Truth::unknown;
  }

  // Delta with fixed + j Delta/2 a natural number; unset: possible for every Delta.
  [[nodiscard]] std::optional<Values> reducible(const Rational& most) const {
    const Families f = exponential_families(s_, first());
    if (!f.complete) return std::nullopt;
    const long n = first().degree(s_.z);
    Values values;
    for (const auto& fixed : f.fixed)
      for (long j = -n; j <= n; j += 2) {
        if (j == 0) {
          if (is_natural(fixed)) return std::nullopt;
          continue;
        }
        for (long d = 0; Rational(d) <= fixed + Rational(n, 2) * most; ++d) {
          const Rational delta = Rational(2) * (Rational(d) - fixed) / Rational(j);
          if (sign(delta) >= 0 && delta <= most) values.insert(delta);
        }
      }
    return values;
  }

  std::variant<Leaf, Needs> one_difference() {
    const PlaceIndex i = open_[0];
    if (!bounds_[0]) return unbounded();
    const Rational most = certify::root_above(*bounds_[0], Integer(2));
    const auto products = half_integers(most);
    if (!products) return open_leaf(some_difference());
    Values values = *products;
    const auto lines = reducible(most);
    if (!torus_) {
      if (!lines) return open_leaf(RationalDifference{i});
      values.merge(Values(*lines));
      values.merge(primitive(most));
    }
    if (auto n = exclude(i, values)) return *std::move(n);
    return not_abelian(Conclusion::one_open, exponential_.excludes() || lines.has_value());
  }

  // The differences are none of these: or the strata where they are come first.
  std::optional<Needs> exclude(PlaceIndex i, const Values& values, const Values& more = {}) {
    if (auto n = doubtful(place_at(s_, i), values)) return n;
    if (auto n = doubtful(place_at(s_, i), more)) return n;
    Values all = values;
    all.insert(more.begin(), more.end());
    known_.emplace_back(ExcludedDifferences{i, {all.begin(), all.end()}});
    return std::nullopt;
  }
  [[nodiscard]] std::optional<Needs> doubtful(const ParametricPlace& p,
                                              const Values& values) const {
    for (const auto& v : values) {
      const MPoly at = where_square_is(p, v * v);
      KOV_ENSURE(!is_zero(at)); // Delta^2 is not constant
      if (auto d = region_.doubtful_factor(at))
        return Needs{*std::move(d),
                     {.kind = Event::Kind::difference_is, .place = name_of(p, s_.z), .value = v}};
    }
    return std::nullopt;
  }

  // All multiples of 1/2 within the bound; of the first one also a/3, a/4, a/5.
  std::variant<Leaf, Needs> several() {
    Values halves, others;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Rational most = certify::root_above(*bounds_[i], Integer(2));
      for (long k = 1; Rational(k, 2) <= most; ++k)
        halves.insert(Rational(k, 2));
      if (i == 0 && !torus_ && !log_)
        for (long n = 3; n <= 5; ++n)
          for (long a = 1; Rational(a, n) <= most; ++a)
            others.insert(Rational(a, n));
    }
    for (const PlaceIndex i : open_)
      if (auto n = exclude(i, halves, i == open_[0] ? others : Values{})) return *std::move(n);
    return not_abelian(Conclusion::several_open, exponential_.excludes());
  }

  std::variant<Leaf, Needs> unbounded() {
    const PlaceIndex i = open_[0];
    if (torus_)
      if (auto three = separated_leaf(s_, *torus_, region_)) return *std::move(three);
    const Families f = product_families(s_, first());
    if (!torus_ || !f.complete) return open_leaf(RationalDifference{i});
    // y1 y2 needs 2 Delta = k, for which k?  (fixed + j k)/2 is natural for some |j| <= n: beyond
    // k = max |fixed| the sign is that of j, and the condition has period 2 in k.
    Rational largest;
    for (const auto& fixed : f.fixed)
      largest = std::max(largest, abs(fixed));
    if (largest > Rational(100000)) return open_leaf(RationalDifference{i});
    bool odd = false;
    bool even = false;
    for (long k = 1; !(odd && even) && Rational(k) <= largest + Rational(4); ++k)
      if (product_possible(f, k)) (k % 2 != 0 ? odd : even) = true;
    if (!odd && !even) {
      known_.emplace_back(NoProducts{i});
      return not_abelian(Conclusion::no_products, exponential_.excludes());
    }
    if (is_assumed_not_integer(odd)) {
      known_.emplace_back(AssumedNotInteger{i, odd});
      return not_abelian(Conclusion::assumed_integers, exponential_.excludes());
    }
    return open_leaf(IntegralDifference{i, odd});
  }

  // 2 Delta, or at least Delta where only even values of it matter.
  [[nodiscard]] bool is_assumed_not_integer(bool odd) const {
    const auto g = exponent_difference(first());
    return g && (region_.is_integral(Rational(2) * *g) == Truth::no ||
                 (!odd && region_.is_integral(*g) == Truth::no));
  }

  // docs/theory/strata.md 6.4: a torus acts where some Delta is not rational, and its invariant has
  // exponents that are not generic.
  [[nodiscard]] SomeDifference some_difference() const { return {open_, torus_.has_value()}; }

  const Scheme& s_;
  const std::vector<PlaceIndex>& open_;
  const std::optional<Evidence>& torus_;
  const std::optional<Logarithm>& log_;
  const ParametrisedSet& region_;
  const Budget& budget_;
  std::vector<std::optional<Rational>> bounds_; ///< parallel to open_
  ExponentialBound exponential_;
  std::vector<Evidence> known_;
};

} // namespace

std::variant<Leaf, Needs>
decide_open_exponents(const Scheme& s, const std::vector<PlaceIndex>& open,
                      const std::optional<Evidence>& torus, const std::optional<Logarithm>& log,
                      const ParametrisedSet& region, const Budget& budget) {
  return OpenDifferences(s, open, torus, log, region, budget).run();
}

} // namespace kov::strata
