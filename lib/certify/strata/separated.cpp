// strata_certificates.md 7.9: three places, two of them with an exponent difference d1, d2 that is not
// rational.  Abelian only if the third one is a natural number n with +-d1 +- d2 among n - 1, n - 3, ...,
// 1 - n.

#include "certify/strata/places.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr long max_integers = 1000; // of n

class SeparatedRule {
public:
  explicit SeparatedRule(const Places& places)
      : s_(places.stratum()), a_(s_.arithmetic()), leaf_(places.leaf()) {
    for (const ProvedPlace& x : places.all)
      if (!x.ordinary()) add(x);
    need(third_ && roots_ == 2, "there are not two irrational places and one other");
    find_pair();
    if (leaf_.growth) need_growth();
    find_sums();
  }

  void operator()() {
    if (sums_ && sums_->empty()) return;
    if (third_->delta) {
      const Rational& n = *third_->delta;
      if (!is_integer(n)) return;
      need_within(n <= Rational(max_integers), "a limit: the exponent difference");
      at(to_long(n.num()));
      return;
    }
    if (leaf_.growth) {
      for (long n = 1; below(n - 1, n); ++n)
        at(n);
      return;
    }
    const auto b = third_->largest();
    need(b.has_value(), "the third exponent difference has no bound");
    need_within(*b <= Rational(max_integers), "a limit: the bound");
    for (long n = 1; Rational(n) <= *b; ++n)
      at(n);
  }

private:
  void add(const ProvedPlace& x) {
    need(x.regular(), "a place is not regular");
    if (x.irrational) {
      pair_.push_back(&x);
      roots_ += x.n;
      return;
    }
    need(!third_ && x.n == 1, "there are more than three places");
    need(x.delta || x.linear(), "chi of the third place is not linear");
    third_ = &x;
  }

  // ---- c_2 T^2 + c_1 T + c_0 with the roots d1^2 and d2^2

  void find_pair() {
    const ProvedPlace& x = *pair_.front();
    if (pair_.size() == 2) {
      const ProvedPlace& y = *pair_.back();
      need(x.linear() && y.linear(), "chi is not linear");
      set_pair(x.chi, y.chi);
    } else if (x.linear()) {
      set_pair(x.chi, x.chi);
    } else {
      need(x.chi.size() == 3, "chi has another degree");
      pair_chi_ = x.chi;
      need_all_values(*x.q);
    }
  }
  void set_pair(const Coefficients& f, const Coefficients& g) {
    pair_chi_ = {a_.times(f[0], g[0]), a_.plus(a_.times(f[0], g[1]), a_.times(f[1], g[0])),
                 a_.times(f[1], g[1])};
  }
  // chi is up to a factor the product over both roots z of q of Y(z) T - X(z): with one of the
  // values twice, it would still vanish.
  void need_all_values(const MPoly& q) {
    const auto [X, Y] = difference_squared(s_, q);
    const Coefficients c = coefficients(q, 0);
    const long n = std::max({degree(X, 0), degree(Y, 0), 1L});
    const auto modulo = [&](const MPoly& f) { // c_2^(n-1) f modulo q
      Coefficients rest = coefficients(f, 0);
      rest.resize(static_cast<std::size_t>(n) + 1, MPoly(f.ring()));
      rest = Elimination(a_).pseudo_remainder(std::move(rest), c);
      rest.resize(2, MPoly(f.ring()));
      return std::pair(rest[0], rest[1]);
    };
    const auto [x0, x1] = modulo(X);
    const auto [y0, y1] = modulo(Y);
    const auto form = [&](const MPoly& u0, const MPoly& u1, const MPoly& v0, const MPoly& v1) {
      const MPoly cross = a_.plus(a_.times(u0, v1), a_.times(u1, v0));
      const MPoly squares =
          a_.plus(a_.times(c[2], a_.times(u0, v0)), a_.times(c[0], a_.times(u1, v1)));
      return a_.minus(scaled(squares, Integer(2)), a_.times(c[1], cross));
    }; // 2 c_2 N(u) for u = v
    const Coefficients values{form(x0, x1, x0, x1), scaled(form(x0, x1, y0, y1), Integer(-2)),
                              form(y0, y1, y0, y1)};
    for (const std::size_t i : {0U, 1U})
      need(a_.times(pair_chi_[i], values[2]) == a_.times(pair_chi_[2], values[i]),
           "chi has not the values at both roots");
  }
  // ---- n and k

  // d1^2 and d2^2 are conjugate: (d1 +- d2)^2 is negative, or larger than 2 (d1^2 + d2^2), and positive.
  void need_growth() const {
    const auto& [factor, shift] = *leaf_.growth;
    need(factor >= Rational(1), "the factor is less than 1");
    need(third_->linear(), "chi of the third place is not given");
    const Coefficients& c = pair_chi_;
    const Coefficients& e = third_->chi;
    for (const MPoly& f : c)
      need(s_.is_real(f), "the squares are not known to be conjugate");
    need(s_.is_positive(a_.minus(scaled(a_.times(c[2], c[0]), Integer(4)), a_.times(c[1], c[1]))),
         "the squares are not known to be conjugate");
    const Integer d = a_.common_multiple(factor.den(), shift.den());
    const auto number = [&](const Rational& x) { return (x * Rational(d)).num(); };
    const MPoly room = a_.plus(a_.minus(a_.scaled(a_.times(c[2], e[0]), number(factor)),
                                        a_.scaled(a_.times(c[1], e[1]), number(Rational(2)))),
                               a_.scaled(a_.times(c[2], e[1]), number(shift)));
    if (is_zero(room)) return;
    need(s_.is_real(e[1]), "chi of the third place is not known to be real");
    need(s_.is_positive(a_.times(a_.times(room, c[2]), e[1])), "the growth is not proved");
  }
  // The growth leaves room for d1 +- d2 = k where the third difference is n.
  [[nodiscard]] bool below(long k, long n) const {
    a_.charge(work_of_a_rational);
    need_within(n <= max_integers, "a limit: the exponent difference");
    const auto& [factor, shift] = *leaf_.growth;
    return factor * Rational(n * n) - shift < Rational(k * k);
  }

  // (k^2 c_2 + c_1)^2 - 4 c_2 c_0: 0 exactly where +-d1 +- d2 = k
  [[nodiscard]] MPoly at_sum(long k) const {
    const Coefficients& c = pair_chi_;
    const MPoly f = a_.plus(a_.scaled(c[2], Integer(k) * Integer(k)), c[1]);
    return a_.minus(a_.times(f, f), scaled(a_.times(c[2], c[0]), Integer(4)));
  }
  [[nodiscard]] static bool is_negative(const ProvedPlace& x) {
    return x.linear() && (x.by == Irrational::positive || (x.square && kov::sign(*x.square) < 0));
  }
  // The integers +-d1 +- d2 where they are constant; both imaginary: only 0 is an integer.
  void find_sums() {
    const Coefficients& c = pair_chi_;
    if (!uses_parameters(c[1], c[2]) && !uses_parameters(c[0], c[2])) {
      find_constant_sums(value(c[1], c[2]) * Rational(-1), value(c[0], c[2]));
      return;
    }
    for (const ProvedPlace* x : pair_)
      if (!is_negative(*x)) return;
    sums_.emplace();
    if (!s_.is_unit(at_sum(0))) sums_->push_back(Rational(0));
  }

  // k^2 = P +- 2 sqrt(Q)
  void find_constant_sums(const Rational& P, const Rational& Q) {
    sums_.emplace();
    const auto q = kov::sign(Q) < 0 ? std::nullopt : exact_sqrt(Q);
    if (!q) return;
    for (const Rational& square : {P + Rational(2) * *q, P - Rational(2) * *q}) {
      const auto k = kov::sign(square) < 0 ? std::nullopt : exact_sqrt(square);
      if (k && is_integer(*k)) sums_->push_back(*k);
    }
  }
  // f/g is not constant.
  static bool uses_parameters(const MPoly& f, const MPoly& g) {
    return !is_zero(f) && !(scaled(f, g.coefficient(0)) == scaled(g, f.coefficient(0)));
  }
  static Rational value(const MPoly& f, const MPoly& g) {
    return is_zero(f) ? Rational(0) : Rational(f.coefficient(0), g.coefficient(0));
  }
  [[nodiscard]] bool is_sum(long k) const { return is_among(Rational(k), *sums_); }

  void at(long n) const {
    const Coefficients& e = third_->chi;
    if (!third_->delta && s_.is_unit(a_.plus(a_.scaled(e[1], Integer(n) * Integer(n)), e[0])))
      return;
    for (long k = n - 1; k >= 0; k -= 2) {
      if (sums_ && !is_sum(k)) continue;
      if (leaf_.growth && (k == 0 || !below(k, n))) continue;
      if (!s_.is_unit(at_sum(k)))
        throw Refused{"the exponent difference " + std::to_string(n) + " with the sum " +
                      std::to_string(k) + " is not excluded"};
    }
  }

  const Stratum& s_;
  Arithmetic& a_;
  const ByPlaces& leaf_;
  std::vector<const ProvedPlace*> pair_;
  long roots_ = 0; ///< of the places of the pair
  const ProvedPlace* third_ = nullptr;
  Coefficients pair_chi_;
  std::optional<std::vector<Rational>> sums_; ///< set: no others are possible
};

} // namespace

void check_separated(const Places& places) { SeparatedRule{places}(); }

} // namespace kov::certify
