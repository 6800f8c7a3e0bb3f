#include "strata/separated.hpp"

#include "closed/coefficients.hpp"
#include "closed/parts.hpp"
#include "closed/riemann.hpp"
#include "closed/statement.hpp"
#include "exact/lists.hpp"
#include "places/irrational.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using Answer = std::variant<std::monostate, SeparatedNowhere, Needs>;

constexpr long most_integers = 200; // values of n, and of the sum, that are looked at one by one

MFraction square_of(const ParametricPlace& p) {
  if (p.exponent == ExponentKind::rational) return {p.q.ring(), p.delta * p.delta};
  return -(p.chi[0] / p.chi[1]);
}

Coefficients<MFraction> fractions(const MPoly& f, std::size_t z) {
  Coefficients<MFraction> all;
  for (const MPoly& c : coefficients(f, z))
    all.emplace_back(c);
  return all;
}

// x0 + x1 c and y0 + y1 c at the two roots c of a quadratic polynomial: the sum of x(c) y(c'), and
// half of it is the norm for x = y.
struct TwoRoots {
  MFraction sum, product;
  [[nodiscard]] MFraction mixed(const Coefficients<MFraction>& x,
                                const Coefficients<MFraction>& y) const {
    return Rational(2) * x[0] * y[0] + (x[0] * y[1] + x[1] * y[0]) * sum +
           Rational(2) * x[1] * y[1] * product;
  }
};

// Delta^2 = X/Y with Y = q'^2 den/q^2, X = Y + 4 num at the roots of q, of degree 2: the sum of the two
// values and their product.
std::pair<MFraction, MFraction> squares_at_roots(const Scheme& s, const MPoly& q) {
  const MPoly w = exact_div(s.r.den(), q * q);
  const MPoly slope = derivative(q, s.z);
  const MPoly y = slope * slope * w;
  const MPoly four(s.r.ring(), Integer(4));
  const auto monic = fractions(q, s.z);
  const auto modulo_q = [&](const MPoly& f) {
    auto rest = divided(fractions(f, s.z), monic).second;
    rest.resize(2, MFraction(s.r.ring()));
    return rest;
  };
  const auto X = modulo_q(y + four * s.r.num());
  const auto Y = modulo_q(y);
  const TwoRoots roots{-(monic[1] / monic[2]), monic[0] / monic[2]};
  const MFraction norm = roots.mixed(Y, Y);
  return {Rational(2) * roots.mixed(X, Y) / norm, roots.mixed(X, X) / norm};
}

// ---- no natural number n is left

class Nowhere {
public:
  Nowhere(const ThreePlaces& t, const Scheme& s, const ParametrisedSet& region)
      : t_(t), s_(s), region_(region), square_(t.numbers.squares[0]), sum_(t.numbers.squares[1]),
        product_(t.numbers.squares[2]) {
    found_.pair = t.pair;
    found_.third = t.third;
    find_growth();
    find_sums();
  }

  Answer run() {
    if (sums_ && sums_->empty()) return std::move(found_);
    if (const auto c = constant_value(square_)) {
      const auto n = exact_sqrt(*c);
      if (!n || !is_integer(*n) || sign(*n) <= 0) return std::move(found_);
      if (Rational(most_integers) < *n) return {};
      return at_most(to_long(n->num()), to_long(n->num()));
    }
    if (found_.growth) return at_most(1, last_below_growth());
    if (const auto& p = place_at(s_, t_.third); p.chi.size() == 2)
      if (const auto bound = exact_bound(p)) {
        found_.bound = bound->second;
        return at_most(1, bound->first);
      }
    return {};
  }

private:
  // k^2 = P +- 2 sqrt(Q) with 4 Q > P^2 leaves k^2 > 2 P only: P, Q the sum and the product of conjugate
  // complex squares.
  void find_growth() {
    if (t_.pair.size() != 1) return;
    const ParametricPlace& p = place_at(s_, t_.pair[0]);
    if (p.irrational != Irrationality::discriminant || p.chi.size() != 3) return;
    if (!(p.chi[1] == -sum_) || !(p.chi[0] == product_)) return; // by way of a relation
    const MFraction twice = Rational(2) * sum_;
    if (constant_value(square_) && constant_value(twice)) return;
    for (const Rational& factor : factors(twice)) {
      const MFraction rest = twice - factor * square_;
      if (const auto c = constant_value(rest))
        return found_.growth.emplace(Growth{factor, -*c}), void();
    }
    for (const long factor : {1, 2, 3, 4})
      for (const long shift : {0, 1, 2, 4, 8, 16, 32}) {
        const MFraction rest = twice - Rational(factor) * square_ + MFraction(s_.r.ring(), shift);
        if (is_real(rest) &&
            region_.exact_sign_of(rest.num()) * region_.exact_sign_of(MPoly(rest.den())) > 0)
          return found_.growth.emplace(Growth{Rational(factor), Rational(shift)}), void();
      }
  }
  using Growth = certify::Growth;
  [[nodiscard]] bool is_real(const MFraction& f) const {
    return region_.is_real(f.num()) && region_.is_real(f.den());
  }
  // The factors for which twice - factor Delta^2 may be constant.
  [[nodiscard]] std::vector<Rational> factors(const MFraction& twice) const {
    for (const std::size_t x : used_variables(square_)) {
      const MFraction slope = derivative(square_, x);
      if (is_zero(slope)) continue;
      const auto c = constant_value(derivative(twice, x) / slope);
      return c && !(*c < Rational(1)) ? std::vector{*c} : std::vector<Rational>{};
    }
    return {};
  }

  // The sums k that are possible, where they are few for a reason that has nothing to do with n.
  void find_sums() {
    if (const auto p = constant_value(sum_), q = constant_value(product_); p && q) {
      sums_.emplace();
      for (const Integer& k : integer_sums(NfElem(*p), NfElem(*q)))
        sums_->push_back(to_long(k));
      return;
    }
    const bool negative =
        std::ranges::all_of(t_.pair, [&](PlaceIndex i) { return place_at(s_, i).negative_square; });
    if (!negative) return; // else both are imaginary, and so is k
    if (is_plainly_nonzero(at_sum(0), region_))
      sums_.emplace();
    else
      sums_ = std::vector<long>{0};
    if (sums_->empty()) found_.nonzero.push_back(at_sum(0));
  }

  // 0 exactly where +-d1 +- d2 = k for some signs.
  [[nodiscard]] MPoly at_sum(long k) const {
    const MFraction f = MFraction(s_.r.ring(), Rational(k * k)) - sum_;
    const MFraction all = f * f - Rational(4) * product_;
    return is_zero(all) ? MPoly(s_.r.ring()) : all.num();
  }
  [[nodiscard]] MPoly at_difference(long n) const {
    const MFraction f = square_ - MFraction(s_.r.ring(), Rational(n * n));
    return is_zero(f) ? MPoly(s_.r.ring()) : f.num();
  }
  // The growth leaves k <= n - 1 with k^2 > factor n^2 - shift.
  [[nodiscard]] bool below_growth(long k, long n) const {
    const Rational least = found_.growth->factor * Rational(n * n) - found_.growth->shift;
    return least < Rational(k * k) && k > 0;
  }
  [[nodiscard]] long last_below_growth() const {
    const auto& g = *found_.growth;
    long n = 1;
    while (n <= most_integers && g.factor * Rational(n * n) - g.shift < Rational((n - 1) * (n - 1)))
      ++n;
    return n - 1;
  }
  // The largest n, and the bound.
  std::optional<std::pair<long, Rational>> exact_bound(const ParametricPlace& p) const {
    ParametrisedSet scratch(region_); // what Z3 says has no certificate
    const auto bound = bound_of_square(p, scratch);
    if (!bound || scratch.trusted().size() != region_.trusted().size()) return std::nullopt;
    long n = 0;
    while (Rational((n + 1) * (n + 1)) <= *bound)
      ++n;
    return std::pair{n, *bound};
  }

  Answer at_most(long first, long last) {
    if (last > most_integers) return {};
    for (long n = first; n <= last; ++n)
      for (long k = n - 1; k >= 0; k -= 2) {
        if (sums_ && !is_among(k, *sums_)) continue;
        if (found_.growth && !below_growth(k, n)) continue;
        if (auto needs = excluded(n, k)) return *std::move(needs);
        if (!possible_) continue;
        return {};
      }
    return std::move(found_);
  }
  std::optional<Needs> excluded(long n, long k) {
    possible_ = false;
    const MPoly difference = at_difference(n);
    const MPoly sum = at_sum(k);
    for (const MPoly& f : {difference, sum})
      if (!is_zero(f) && !region_.doubtful_factor(f)) {
        found_.nonzero.push_back(f);
        return std::nullopt;
      }
    const Event here{.kind = Event::Kind::difference_is,
                     .place = name_of(place_at(s_, t_.third), s_.z),
                     .value = Rational(n)};
    possible_ = is_zero(sum) && is_zero(difference);
    if (possible_) return std::nullopt;
    if (!is_zero(difference)) return Needs{*region_.doubtful_factor(difference), here};
    return Needs{*region_.doubtful_factor(sum), here};
  }

  const ThreePlaces& t_;
  const Scheme& s_;
  const ParametrisedSet& region_;
  MFraction square_, sum_, product_;
  SeparatedNowhere found_;
  std::optional<std::vector<long>> sums_;
  bool possible_ = false; ///< everywhere, for the n and k that were looked at last
};

} // namespace

std::optional<ThreePlaces> three_places(const Scheme& s) {
  ThreePlaces t;
  std::optional<PlaceIndex> third;
  for (PlaceIndex i = 0; i < number_of_places(s); ++i) {
    const ParametricPlace& p = place_at(s, i);
    if (p.kind == PlaceKind::ordinary) continue;
    if (p.kind != PlaceKind::regular) return std::nullopt;
    if (p.exponent == ExponentKind::irrational) {
      t.pair.push_back(i);
    } else {
      if (third || p.degree(s.z) != 1 || (p.exponent == ExponentKind::open && p.chi.size() != 2))
        return std::nullopt;
      third = i;
    }
  }
  if (!third || t.pair.empty() || t.pair.size() > 2) return std::nullopt;
  t.third = *third;
  t.numbers.squares = {square_of(place_at(s, t.third))};
  const ParametricPlace& first = place_at(s, t.pair[0]);
  if (t.pair.size() == 1) {
    if (first.degree(s.z) != 2) return std::nullopt;
    const auto [sum, product] = squares_at_roots(s, first.q);
    t.numbers.squares.insert(t.numbers.squares.end(), {sum, product});
    return t;
  }
  const ParametricPlace& other = place_at(s, t.pair[1]);
  if (first.degree(s.z) != 1 || other.degree(s.z) != 1 || first.chi.size() != 2 ||
      other.chi.size() != 2)
    return std::nullopt;
  const MFraction x = square_of(first);
  const MFraction y = square_of(other);
  t.numbers.squares.insert(t.numbers.squares.end(), {x + y, x * y});
  return t;
}

Answer separated_nowhere(const ThreePlaces& t, const Scheme& s, const ParametrisedSet& region) {
  return Nowhere(t, s, region).run();
}

std::optional<std::variant<Leaf, Needs>> separated_leaf(const Scheme& s, const Evidence& torus,
                                                        const ParametrisedSet& region) {
  const auto t = three_places(s);
  if (!t) return std::nullopt;
  auto answer = separated_nowhere(*t, s, region);
  if (auto* needs = std::get_if<Needs>(&answer)) return std::move(*needs);
  Leaf leaf;
  leaf.bound = GroupBound::SL2_or_Borel;
  leaf.by = Conclusion::separated;
  leaf.because.push_back(torus);
  if (auto* found = std::get_if<SeparatedNowhere>(&answer)) {
    leaf.abelian = Truth::no;
    leaf.because.emplace_back(std::move(*found));
    return leaf;
  }
  if (t->pair.size() == 2) return std::nullopt; // Riemann's answer says more
  Parts parts(region);
  parts.split(
      t->numbers, [&] { parts.add(GroupType::Gm); },
      [&] { parts.add(Truth::no, GroupBound::SL2_or_Borel); });
  leaf.parts = parts.take();
  if (leaf.parts.size() > 1) {
    leaf.bound = GroupBound::unknown;
    leaf.open = ByParts{};
    return leaf;
  }
  leaf.abelian = leaf.parts.front().abelian;
  leaf.group = leaf.parts.front().group;
  leaf.parts.clear();
  return leaf;
}

} // namespace kov::strata
