#include "strata/open_exponent.hpp"

#include "exact/error.hpp"
#include "strata/bounds.hpp"
#include "strata/irrational.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {
namespace {

using Values = std::set<Rational>;

bool is_natural(const Rational& x) { return is_integer(x) && sign(x) >= 0; }

// The least rational number of a list whose square is at least B.
Rational root_above(const Rational& b) {
  for (long k = 0;; ++k)
    if (Rational(k * k, 4) >= b) return Rational(k, 2);
}

Leaf no(const std::string& why, bool irreducible) {
  Leaf leaf;
  leaf.abelian = Truth::no;
  if (irreducible) leaf.group = GaloisGroup{GroupType::SL2, {}};
  leaf.group_text = irreducible ? describe(*leaf.group) : "SL(2, C) or the full triangular group";
  leaf.reason = why;
  return leaf;
}

class OpenJudge {
public:
  OpenJudge(const Scheme& s, const std::vector<const ParametricPlace*>& open,
            const std::string& torus, bool log, const Region& region, const Budget& budget)
      : s_(s), open_(open), torus_(torus), log_(log), region_(region), budget_(budget) {}

  std::variant<Leaf, Needs> run() {
    const InvariantBound four = invariant_bound(s_, 4);
    if (four.form) {
      auto excluded = exclude_invariant(s_, *four.form, region_, budget_);
      if (auto* n = std::get_if<Needs>(&excluded)) return std::move(*n);
      if (const auto* u = std::get_if<Unsettled>(&excluded)) return unsettled(*u, rational_text());
    }
    generic_ = four.form ? "Sym^4 has no rational solution" : four.why;
    for (const auto* p : open_)
      bounds_.push_back(bound_of_square(*p, region_));
    const bool bounded =
        std::all_of(bounds_.begin(), bounds_.end(), [](const auto& b) { return b.has_value(); });
    std::optional<Rational> largest; // of |Re Delta|^2: where Delta^2 is real
    const bool real =
        std::all_of(open_.begin(), open_.end(), [](const auto* p) { return p->chi.size() == 2; });
    for (const auto& b : bounds_)
      if (bounded && real && (!largest || *b > *largest)) largest = b;
    const ExponentialBound exponential = exponential_bound(s_, largest);
    irreducible_ = exponential.excludes();
    if (irreducible_ && log_)
      return no("there is a logarithm, and no exponential solution: its polynomial part would have "
                "a degree < 0",
                true);
    if (open_.size() == 1 && open_[0]->chi.size() == 2) return one_difference();
    if (!bounded || (torus_.empty() && !irreducible_)) return undecided(several_text());
    return several();
  }

private:
  [[nodiscard]] std::string where(const ParametricPlace& p) const {
    return "Delta at " + place_name(p, s_.z) + ", " + square_text(p);
  }

  // The multiples of 1/2 for which a product y1 y2 with rational square is possible.
  [[nodiscard]] std::optional<Values> half_integers(const Rational& most) const {
    const Families f = product_families(s_, *open_[0]);
    if (!f.complete) return std::nullopt;
    Values values;
    if (log_) return values; // no logarithms there
    for (long k = 1; Rational(k, 2) <= most; ++k)
      if (product_possible(f, k)) values.insert(Rational(k, 2));
    return values;
  }
  [[nodiscard]] bool product_possible(const Families& f, long k) const {
    const long n = open_[0]->degree(s_.z);
    for (const auto& fixed : f.fixed)
      for (long j = -n; j <= n; ++j)
        if (is_natural((fixed + Rational(j * k)) * Rational(1, 2))) return true;
    return false;
  }

  // Delta = a/N, N <= 5, with D_12 >= 0 and local orders that a finite primitive group has.
  [[nodiscard]] Values primitive(const Rational& most) const {
    Values values;
    if (log_) return values;
    for (const auto* p : every_place())
      if (p != open_[0] && (p->exponent != ExponentKind::rational || p->delta.den() > Integer(5)))
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
    const Families f = exponential_families(s_, *open_[0]);
    if (!f.complete) return std::nullopt;
    const long n = open_[0]->degree(s_.z);
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

  [[nodiscard]] std::vector<const ParametricPlace*> every_place() const {
    std::vector<const ParametricPlace*> all{&s_.infinity};
    for (const auto& p : s_.finite)
      all.push_back(&p);
    return all;
  }

  std::variant<Leaf, Needs> one_difference() {
    const ParametricPlace& p = *open_[0];
    if (!bounds_[0]) return unbounded();
    const Rational most = root_above(*bounds_[0]);
    const auto products = half_integers(most);
    if (!products) return undecided(several_text());
    Values values = *products;
    const auto lines = reducible(most);
    if (torus_.empty()) {
      if (!lines) return undecided(reducible_text());
      values.merge(Values(*lines));
      values.merge(primitive(most));
    }
    if (auto n = exclude(p, values)) return *std::move(n);
    return no(where(p) + ": " + text_of(values, *bounds_[0]), irreducible_ || lines.has_value());
  }

  // The differences are none of these: or the strata where they are come first.
  std::optional<Needs> exclude(const ParametricPlace& p, const Values& values) const {
    for (const auto& v : values) {
      const MPoly at = where_square_is(p, v * v);
      KOV_ENSURE(!is_zero(at)); // Delta^2 is not constant
      if (auto d = region_.doubtful_factor(at))
        return Needs{*std::move(d), "Delta = " + to_string(v) + " at " + place_name(p, s_.z)};
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string text_of(const Values& values, const Rational& bound) const {
    std::string list;
    for (const auto& v : values)
      list += (list.empty() ? "" : ", ") + to_string(v);
    std::string text = "not larger than " + to_string(bound) + "; ";
    text += torus_.empty() ? "if Delta is not rational, "
                           : torus_ + ", and unless 2*Delta is an "
                                      "integer, ";
    text += generic_ + "; an abelian identity component is possible only for ";
    text +=
        list.empty() ? "no value of Delta" : "Delta in {" + list + "}, none of which occurs here";
    return text;
  }

  std::variant<Leaf, Needs> several() {
    Values halves, others;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Rational most = root_above(*bounds_[i]);
      for (long k = 1; Rational(k, 2) <= most; ++k)
        halves.insert(Rational(k, 2));
      if (i == 0 && torus_.empty() && !log_)
        for (long n = 3; n <= 5; ++n)
          for (long a = 1; Rational(a, n) <= most; ++a)
            others.insert(Rational(a, n));
    }
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (auto n = exclude(*open_[i], halves)) return *std::move(n);
      if (i == 0)
        if (auto n = exclude(*open_[i], others)) return *std::move(n);
    }
    std::string text = torus_.empty() ? "there is no exponential solution" : torus_;
    for (const auto* p : open_)
      text += "; " + where(*p) + ", 2*Delta is not an integer";
    return no(text + "; " + generic_, irreducible_);
  }

  std::variant<Leaf, Needs> unbounded() {
    const ParametricPlace& p = *open_[0];
    const Families f = product_families(s_, p);
    if (torus_.empty() || !f.complete) return undecided(reducible_text());
    // y1 y2 needs 2 Delta = k, for which k?  (fixed + j k)/2 is natural for some |j| <= n: beyond
    // k = max |fixed| the sign is that of j, and the condition has period 2 in k.
    Rational largest;
    for (const auto& fixed : f.fixed)
      largest = std::max(largest, abs(fixed));
    if (largest > Rational(100000)) return undecided(reducible_text());
    bool odd = false;
    bool even = false;
    for (long k = 1; !(odd && even) && Rational(k) <= largest + Rational(4); ++k)
      if (product_possible(f, k)) (k % 2 != 0 ? odd : even) = true;
    if (!odd && !even)
      return no(torus_ + "; " + where(p) + "; no exponents of y1*y2 are possible", irreducible_);
    if (const auto g = exponent_difference(p)) {
      const MFraction twice = Rational(2) * *g;
      const bool none =
          region_.is_integral(twice) == Truth::no || (!odd && region_.is_integral(*g) == Truth::no);
      if (none)
        return no(torus_ + "; " + where(p) + ", and by assumption " + (odd ? "2*Delta" : "Delta") +
                      " is not an integer; " + generic_,
                  irreducible_);
    }
    return undecided(std::string(odd ? "2*Delta" : "Delta") + " is a positive integer, " +
                     where(p) + ", and Sym^4 has a rational solution");
  }

  [[nodiscard]] std::string reducible_text() const {
    const ParametricPlace& p = *open_[0];
    return "Delta is rational, " + where(p) +
           ", and the equation is reducible or a symmetric power has a rational solution";
  }
  // docs/theory/strata.md 6.4: a torus acts where some Delta is not rational, and its invariant has
  // exponents that are not generic.
  [[nodiscard]] std::string rational_text() const {
    std::string text = torus_.empty() ? "every Delta is rational or some 2*Delta is an integer"
                                      : "some 2*Delta is an integer";
    for (const auto* p : open_)
      text += ", " + where(*p);
    return text;
  }
  [[nodiscard]] std::string several_text() const {
    return rational_text() + ", and a symmetric power has a rational solution";
  }
  Leaf undecided(const std::string& condition) const {
    Leaf leaf;
    leaf.open_condition = "abelian only if " + condition;
    leaf.reason = "undecided: " + leaf.open_condition;
    return leaf;
  }

  const Scheme& s_;
  const std::vector<const ParametricPlace*>& open_;
  const std::string& torus_;
  bool log_;
  const Region& region_;
  const Budget& budget_;
  std::string generic_;
  std::vector<std::optional<Rational>> bounds_;
  bool irreducible_ = false;
};

} // namespace

std::variant<Leaf, Needs> judge_open_exponents(const Scheme& s,
                                               const std::vector<const ParametricPlace*>& open,
                                               const std::string& torus, bool log,
                                               const Region& region, const Budget& budget) {
  return OpenJudge(s, open, torus, log, region, budget).run();
}

} // namespace kov::strata
