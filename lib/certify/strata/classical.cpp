// A classical equation after a change of variable: strata_certificates.md 7.8.

#include "certify/strata/classical.hpp"

#include "certify/strata/rules.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr std::size_t max_shown = 1000; // each number is compared with all of them
constexpr std::size_t max_members = 1000;

class ClassicalRule {
public:
  ClassicalRule(const Stratum& s, const ByClassical& leaf)
      : s_(s), leaf_(leaf), a_(s.arithmetic()), N_(leaf.equation.num), D_(leaf.equation.den) {}

  Truth operator()() {
    need_small();
    need_functions();
    need_change();
    if (leaf_.family == "whittaker" || leaf_.family == "bessel")
      need_confluent();
    else
      need_places();
    for (const ShownMembership& x : leaf_.shown) {
      s_.need_parameters(x.value.num);
      s_.need_parameters(x.value.den);
      s_.need_shown(x);
    }
    const ParameterFacts facts{[this](const Fraction& f) { return known(f); },
                               [this](const MPoly& p) { return s_.is_rational(p); },
                               [this](const MPoly& p) { return s_.is_positive(p); }};
    return criterion_holds(leaf_, facts, a_);
  }

private:
  // No family has more; before anything is expanded.
  void need_small() const {
    need(degree(N_, 0) <= 4 && degree(D_, 0) <= 6, "the equation is not that of the family");
    need(leaf_.numbers.size() <= 4, "these are not the numbers of the family");
    need_within(leaf_.shown.size() <= max_shown, "a limit: the number of integers shown");
    std::size_t members = 0;
    for (const ShownMembership& x : leaf_.shown)
      members += x.with.size();
    need_within(members <= max_members, "a limit: the number of memberships");
  }
  void need_functions() {
    for (const Fraction* f : {&leaf_.change, &leaf_.equation}) {
      s_.need_variables(f->num);
      s_.need_variables(f->den);
    }
    need(!is_zero(D_), "the equation has no denominator");
    for (const SquaredNumber& x : leaf_.numbers) {
      need_value(x.square);
      if (x.root) need_root(x);
    }
  }
  void need_value(const Fraction& f) const {
    s_.need_parameters(f.num);
    s_.need_parameters(f.den);
    need(s_.is_unit(f.den), "a denominator may vanish");
  }
  void need_root(const SquaredNumber& x) const {
    need_value(*x.root);
    need_equal({a_.times(x.root->num, x.root->num), a_.times(x.root->den, x.root->den)}, x.square,
               "the root has another square");
  }
  void need_equal(const Fraction& f, const Fraction& g, const char* why) const {
    need(a_.times(f.num, g.den) == a_.times(g.num, f.den), why);
  }

  // ---- r = f'^2 equation(f) - ((f''/f')' - (f''/f')^2/2)/2, f = p/q

  // f' = W/q^2, f''/f' = U/(W q)
  void need_change() const {
    const auto& [p, q] = leaf_.change;
    const MPoly W = a_.minus(a_.times(derivative(p, 0), q), a_.times(p, derivative(q, 0)));
    const Coefficients c = coefficients(W, 0);
    need(std::ranges::any_of(c, [&](const MPoly& f) { return s_.is_unit(f); }),
         "the change of variable may be constant");
    const MPoly U =
        a_.minus(a_.times(derivative(W, 0), q), scaled(a_.times(W, derivative(q, 0)), Integer(2)));
    const MPoly Wq = a_.times(W, q);
    const MPoly slope = a_.minus(a_.times(derivative(U, 0), Wq), a_.times(U, derivative(Wq, 0)));
    const MPoly schwarz = a_.minus(scaled(slope, Integer(2)), a_.times(U, U)); // 2 (W q)^2 S
    const long n = std::max({degree(N_, 0), degree(D_, 0), 0L});
    const Root at_change(a_, q, -p); // q^n N(p/q)
    const MPoly top = at_change(N_, 0, n);
    const MPoly bottom = at_change(D_, 0, n);
    const MPoly q2 = a_.times(q, q);
    const MPoly W2 = a_.times(W, W);
    const MPoly num = a_.minus(scaled(a_.times(a_.times(W2, W2), top), Integer(4)),
                               a_.times(a_.times(q2, bottom), schwarz));
    const MPoly den = scaled(a_.times(a_.times(W2, a_.times(q2, q2)), bottom), Integer(4));
    need_equal(s_.r(), {num, den}, "the change of variable gives another equation");
  }

  // ---- a + b/z + c/z^2, resp. b/z + c/z^2

  void need_confluent() const {
    const bool whittaker = leaf_.family == "whittaker";
    Coefficients c = coefficients(N_, 0);
    const Coefficients e = coefficients(D_, 0);
    need(e.size() == 3 && is_zero(e[0]) && is_zero(e[1]) && s_.is_unit(e[2]),
         "the denominator is not that of the family");
    need(c.size() == (whittaker ? 3U : 2U) && s_.is_unit(c.back()),
         "the numerator is not that of the family");
    need(leaf_.factors.empty() && leaf_.numbers.size() == (whittaker ? 2U : 1U),
         "these are not the numbers of the family");
    const MPoly delta = a_.plus(e[2], scaled(c[0], Integer(4))); // times e
    const Fraction square{delta, whittaker ? scaled(e[2], Integer(4)) : e[2]};
    need_equal(leaf_.numbers.back().square, square, "another number");
    if (!whittaker) return;
    const Fraction k{a_.times(c[1], c[1]), scaled(a_.times(c[2], e[2]), Integer(4))};
    need_equal(leaf_.numbers[0].square, k, "another number");
  }

  // ---- N/(e P^2), P the product of the finite places

  void need_places() const {
    const bool lame = leaf_.family == "lame";
    MPoly P(N_.ring(), Integer(1));
    for (const MPoly& q : leaf_.factors) {
      s_.need_variables(q);
      need(degree(q, 0) >= 1 && degree(q, 0) <= 3, "a place has no roots, or too many");
      P = a_.times(P, q);
      need(degree(P, 0) <= 3, "there are too many places");
    }
    const long n = degree(P, 0);
    need(n == 3 || (n == 2 && !lame), "there are not enough places");
    need(s_.is_unit(lead(P)), "a place may disappear");
    const MPoly slope = derivative(P, 0);
    need(s_.is_unit(Elimination(a_).resultant(coefficients(P, 0), coefficients(slope, 0))),
         "places may meet");
    const auto e = a_.quotient(D_, a_.times(P, P));
    need(e && !uses(*e, 0) && s_.is_unit(*e), "the denominator is not that of the family");
    need(degree(N_, 0) <= (lame ? 4 : 2), "another place");
    const bool infinity = lame || n == 2;
    need(leaf_.numbers.size() == leaf_.factors.size() + (infinity ? 1 : 0),
         "these are not the numbers of the family");
    const MPoly scale = a_.times(*e, a_.times(slope, slope));
    for (std::size_t i = 0; i < leaf_.factors.size(); ++i) {
      need_difference(leaf_.factors[i], leaf_.numbers[i].square, scale);
      need(!lame || constant_value(leaf_.numbers[i].square) == Rational(1, 4),
           "a difference is not 1/2");
    }
    if (infinity) need_at_infinity(a_.times(*e, a_.times(lead(P), lead(P))), 2 * n - 2);
  }
  // 4 N = (square - 1) e P'^2 at the roots of q
  void need_difference(const MPoly& q, const Fraction& square, const MPoly& scale) const {
    const MPoly f = a_.minus(scaled(a_.times(N_, square.den), Integer(4)),
                             a_.times(a_.minus(square.num, square.den), scale));
    need(Elimination(a_).pseudo_remainder(coefficients(f, 0), coefficients(q, 0)).empty(),
         "another exponent difference");
  }
  void need_at_infinity(const MPoly& scale, long n) const {
    const Coefficients c = coefficients(N_, 0);
    const auto top = static_cast<std::size_t>(n);
    const MPoly lead = top < c.size() ? c[top] : MPoly(N_.ring());
    const MPoly square = a_.plus(scale, scaled(lead, Integer(4))); // times scale
    const Integer four(leaf_.family == "lame" ? 4 : 1);            // 2n + 1 = 2 (n + 1/2)
    need_equal(leaf_.numbers.back().square, {scaled(square, four), scale},
               "another exponent difference at infinity");
  }

  // ---- integers

  // f, up to its sign and an integer, is one of the values shown.
  [[nodiscard]] Truth known(const Fraction& f) const {
    for (const ShownMembership& x : leaf_.shown)
      for (const long sign : {1L, -1L}) {
        const auto c = constant_value(combined(f, Rational(sign), x.value, a_));
        if (c && is_integer(*c)) return truth(x.integral);
      }
    return Truth::unknown;
  }

  const Stratum& s_;
  const ByClassical& leaf_;
  Arithmetic& a_;
  const MPoly &N_, &D_;
};

} // namespace

Truth check_classical(const Stratum& s, const ByClassical& leaf) {
  return ClassicalRule(s, leaf)();
}

} // namespace kov::certify
