#include "classify/bounded.hpp"

#include "exact/error.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long most_bounds = 16;        // Delta^2 up to 256
constexpr std::size_t most_values = 48; // each is studied by itself

/// The conditions on the real parameters of a set at which all differences are special.
class RealSet {
public:
  RealSet(const System& s, const Set& where) : s_(s), where_(where) {
    for (const MPoly& p : where.equations())
      known_.push_back({p, Sign::zero});
    for (const MPoly& p : where.proper_inequations())
      known_.push_back({p, Sign::nonzero});
    for (const Statement& x : where.statements()) {
      auto one = one_number(x);
      statements_.push_back(one && one->classes ? std::move(one) : std::nullopt);
    }
  }

  [[nodiscard]] std::optional<BoundedValues> values(std::size_t i) const {
    const auto& c = statements_[i];
    if (!c) return std::nullopt;
    std::vector<Condition> others = known_;
    for (std::size_t j = 0; j < statements_.size(); ++j)
      if (j != i && statements_[j]) add_distance(*statements_[j], others);
    BoundedValues all{i, {c->squares.front(), {}}, {}};
    const auto bound = least_bound(c->squares.front(), others, all.trusted);
    if (!bound) return std::nullopt;
    all.values.values = squares_in(*c->classes, *bound);
    if (all.values.values.size() > most_values) return std::nullopt;
    return all;
  }

private:
  // f is larger than k^2.
  static Condition larger(const MFraction& f, long k) {
    const MFraction over = f - MFraction(f.ring(), Rational(k * k));
    return {over.num() * over.den(), Sign::positive};
  }

  // The smallest k, of those that are tried, such that Delta^2 > k^2 is refuted.
  std::optional<long> least_bound(const MFraction& square, const std::vector<Condition>& others,
                                  std::vector<Trusted>& steps) const {
    const auto refuted = [&](long k) {
      auto all = others;
      all.push_back(larger(square, k));
      const auto proof = refuted_over_the_reals(s_, all);
      if (proof) steps = *proof;
      return proof.has_value();
    };
    long high = 1;
    while (high <= most_bounds && !refuted(high))
      high *= 2;
    if (high > most_bounds) return std::nullopt;
    for (long low = high / 2; high - low > 1;) {
      const long middle = (low + high) / 2;
      (refuted(middle) ? high : low) = middle;
    }
    return high;
  }

  // |Delta - v| >= 1/N for a value v that Delta never takes.
  void add_distance(const SomeIn& c, std::vector<Condition>& all) const {
    const auto delta = square_root(c.squares.front());
    if (!delta) return;
    const Integer n = denominator(*c.classes);
    for (long v = -2; v <= 2; ++v) {
      const MFraction away = *delta - MFraction(delta->ring(), Rational(v));
      if (is_zero(away) || !where_.is_nonzero(away.num())) continue;
      const MPoly scaled = MPoly(where_.ring(), n) * away.num();
      all.push_back({scaled * scaled - away.den() * away.den(), Sign::nonnegative});
    }
  }

  const System& s_;
  const Set& where_;
  std::vector<std::optional<SomeIn>> statements_; ///< set: on one number, in classes
  std::vector<Condition> known_;
};

} // namespace

std::optional<BoundedValues> bounded_values(const System& s, const Set& where) {
  const RealSet set(s, where);
  for (std::size_t i = 0; i < where.statements().size(); ++i)
    if (auto values = set.values(i)) return values;
  return std::nullopt;
}

} // namespace kov
