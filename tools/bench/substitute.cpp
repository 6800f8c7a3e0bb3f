// substitute: does a claimed solution satisfy y'' = r y?  For tools/bench/peers; claims come from
// any program.
//
// One JSON object per line in, one out:
//   {"r": R, "y": Y}              a solution, with exp, log, sqrt, powers, erf, Ei, integrate(f,
//   x), ...
//   {"r": R, "omega": W}          a solution of the Riccati equation, W = y'/y
//   {"r": R, "polynomial": P}     P(x, omega) = 0 for every conjugate of such an omega
// answer {"verdict": "right" | "wrong" | "unreadable", "why": ...}.
//
// Everything is a power series at a complex point with ball coefficients.  A residual whose ball
// excludes 0 proves that the claim is false there; one that contains 0 with a radius below 2^-100
// of its terms is taken as true.  Functions have several branches: one point at which the claim
// holds is enough.

#include "exact/ball.hpp"
#include "symbol/expression.hpp"

#include <acb_hypgeom.h>
#include <acb_poly.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <stdexcept>

namespace {

using kov::Expression;
using Kind = Expression::Kind;
constexpr slong bits = 400;

class Series { // a power series with ball coefficients
public:
  Series() { acb_poly_init(v_); }
  explicit Series(const acb_t c) : Series() { acb_poly_set_acb(v_, c); }
  explicit Series(slong n) : Series() { acb_poly_set_si(v_, n); }
  Series(const Series& o) : Series() { acb_poly_set(v_, o.v_); }
  Series& operator=(const Series& o) {
    acb_poly_set(v_, o.v_);
    return *this;
  }
  ~Series() { acb_poly_clear(v_); }
  acb_poly_struct* raw() { return v_; }
  [[nodiscard]] const acb_poly_struct* raw() const { return v_; }
  [[nodiscard]] kov::ComplexBall at(slong i) const {
    kov::ComplexBall c;
    acb_poly_get_coeff_acb(c.raw(), v_, i);
    return c;
  }

private:
  acb_poly_t v_;
};

struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Evaluator {
public:
  Evaluator(std::map<std::string, Series> names, slong length)
      : names_(std::move(names)), length_(length) {}

  Series operator()(const Expression& e) const {
    Series s;
    switch (e.kind()) {
    case Kind::number:
      fmpz_t n;
      fmpz_init_set(n, e.number().raw());
      acb_poly_fit_length(s.raw(), 1);
      acb_set_fmpz(s.raw()->coeffs, n);
      _acb_poly_set_length(s.raw(), 1);
      fmpz_clear(n);
      return s;
    case Kind::name:
      return name(e.name());
    case Kind::sum:
      for (const Expression& term : e.operands())
        acb_poly_add(s.raw(), s.raw(), (*this)(term).raw(), bits);
      return s;
    case Kind::negate:
      acb_poly_neg(s.raw(), (*this)(e.operand(0)).raw());
      return s;
    case Kind::product:
      s = Series(1);
      for (const Expression& factor : e.operands())
        acb_poly_mullow(s.raw(), s.raw(), (*this)(factor).raw(), length_, bits);
      return s;
    case Kind::quotient:
      acb_poly_div_series(s.raw(), (*this)(e.operand(0)).raw(), (*this)(e.operand(1)).raw(),
                          length_, bits);
      return s;
    case Kind::power:
      return power(e);
    case Kind::call:
      return call(e);
    default:
      throw Unreadable("a derivative, a decimal number or an equation");
    }
  }

private:
  [[nodiscard]] Series name(const std::string& n) const {
    if (const auto at = names_.find(n); at != names_.end()) return at->second;
    kov::ComplexBall c;
    if (n == "I")
      acb_onei(c.raw());
    else if (n == "Pi" || n == "pi")
      acb_const_pi(c.raw(), bits);
    else
      throw Unreadable("unknown name " + n);
    return Series(c.raw());
  }

  [[nodiscard]] Series power(const Expression& e) const {
    Series s;
    const Series base = (*this)(e.operand(0));
    Expression exponent = e.operand(1);
    const bool negative = exponent.kind() == Kind::negate;
    if (negative) exponent = Expression(exponent.operand(0));
    if (exponent.kind() == Kind::number && exponent.number() < kov::Integer(1000000)) {
      const auto n = static_cast<ulong>(kov::to_long(exponent.number()));
      acb_poly_pow_ui_trunc_binexp(s.raw(), base.raw(), n, length_, bits);
      if (negative) acb_poly_inv_series(s.raw(), Series(s).raw(), length_, bits);
      return s;
    }
    acb_poly_pow_series(s.raw(), base.raw(), (*this)(e.operand(1)).raw(), length_, bits);
    return s;
  }

  [[nodiscard]] Series call(const Expression& e) const {
    const std::string& f = e.name();
    if (f == "root" && e.operands().size() == 2) return root(e);
    const Series x = (*this)(e.operand(0));
    Series s;
    if (f == "exp")
      acb_poly_exp_series(s.raw(), x.raw(), length_, bits);
    else if (f == "log" || f == "ln")
      acb_poly_log_series(s.raw(), x.raw(), length_, bits);
    else if (f == "sqrt")
      acb_poly_sqrt_series(s.raw(), x.raw(), length_, bits);
    else if (f == "sin")
      acb_poly_sin_series(s.raw(), x.raw(), length_, bits);
    else if (f == "cos")
      acb_poly_cos_series(s.raw(), x.raw(), length_, bits);
    else if (f == "tan")
      acb_poly_tan_series(s.raw(), x.raw(), length_, bits);
    else if (f == "sinh")
      acb_poly_sinh_series(s.raw(), x.raw(), length_, bits);
    else if (f == "cosh")
      acb_poly_cosh_series(s.raw(), x.raw(), length_, bits);
    else if (f == "atan" || f == "arctan")
      return atan(x);
    else if (f == "erf")
      acb_hypgeom_erf_series(s.raw(), x.raw(), length_, bits);
    else if (f == "erfi")
      acb_hypgeom_erfi_series(s.raw(), x.raw(), length_, bits);
    else if (f == "Ei")
      acb_hypgeom_ei_series(s.raw(), x.raw(), length_, bits);
    else if (f == "integrate" || f == "integral" || f == "int") // of its own variable, any constant
      acb_poly_integral(s.raw(), x.raw(), bits);
    else
      throw Unreadable("unknown function " + f);
    acb_poly_truncate(s.raw(), length_);
    return s;
  }

  // log((1 + i x)/(1 - i x))/(2 i)
  [[nodiscard]] Series atan(const Series& x) const {
    kov::ComplexBall i;
    acb_onei(i.raw());
    Series up;
    acb_poly_scalar_mul(up.raw(), x.raw(), i.raw(), bits);
    Series down;
    acb_poly_neg(down.raw(), up.raw());
    acb_poly_add_si(up.raw(), up.raw(), 1, bits);
    acb_poly_add_si(down.raw(), down.raw(), 1, bits);
    Series s;
    acb_poly_div_series(s.raw(), up.raw(), down.raw(), length_, bits);
    acb_poly_log_series(s.raw(), Series(s).raw(), length_, bits);
    acb_mul_2exp_si(i.raw(), i.raw(), 1);
    acb_poly_scalar_div(s.raw(), s.raw(), i.raw(), bits);
    return s;
  }

  // root(p(x), a + b*I): the root of p next to the given decimal number
  [[nodiscard]] static Series root(const Expression& e) {
    const auto names = kov::names_in(e.operand(0));
    if (names.size() != 1) throw Unreadable("root of a polynomial with parameters");
    Series t;
    acb_poly_set_coeff_si(t.raw(), 1, 1);
    const Series p = Evaluator({{names.front(), t}}, 200)(e.operand(0));
    const kov::ComplexBall near = decimal(e.operand(1));
    acb_ptr all = _acb_vec_init(p.raw()->length - 1);
    const slong n = acb_poly_find_roots(all, p.raw(), nullptr, 0, bits);
    kov::ComplexBall found;
    bool any = false;
    for (slong i = 0; i < n; ++i) {
      kov::ComplexBall distance;
      acb_sub(distance.raw(), all + i, near.raw(), bits);
      kov::Ball size;
      acb_abs(size.raw(), distance.raw(), bits);
      if (arf_cmpabs_2exp_si(arb_midref(size.raw()), -12) > 0) continue;
      acb_set(found.raw(), all + i);
      any = true;
    }
    _acb_vec_clear(all, p.raw()->length - 1);
    if (!any) throw Unreadable("no root there");
    return Series(found.raw());
  }

  static kov::ComplexBall decimal(const Expression& e) {
    kov::ComplexBall c;
    switch (e.kind()) {
    case Kind::decimal:
      arb_set_str(acb_realref(c.raw()), e.name().c_str(), bits);
      return c;
    case Kind::number:
    case Kind::name:
      return Evaluator({}, 1)(e).at(0);
    case Kind::negate:
      c = decimal(e.operand(0));
      acb_neg(c.raw(), c.raw());
      return c;
    case Kind::sum:
      for (const Expression& term : e.operands())
        acb_add(c.raw(), c.raw(), decimal(term).raw(), bits);
      return c;
    case Kind::product:
      acb_one(c.raw());
      for (const Expression& factor : e.operands())
        acb_mul(c.raw(), c.raw(), decimal(factor).raw(), bits);
      return c;
    default:
      throw Unreadable("not a decimal number");
    }
  }

  std::map<std::string, Series> names_;
  slong length_;
};

enum class Seen { holds, fails, unclear };

// a + b = 0?
Seen zero_sum(const kov::ComplexBall& a, const kov::ComplexBall& b) {
  kov::ComplexBall sum;
  acb_add(sum.raw(), a.raw(), b.raw(), bits);
  if (acb_is_finite(sum.raw()) == 0) return Seen::unclear;
  if (acb_contains_zero(sum.raw()) == 0) return Seen::fails;
  kov::Ball size;
  kov::Ball terms;
  acb_abs(size.raw(), sum.raw(), bits);
  acb_abs(terms.raw(), a.raw(), bits);
  arb_mul_2exp_si(terms.raw(), terms.raw(), -100);
  return arb_lt(size.raw(), terms.raw()) != 0 ? Seen::holds : Seen::unclear;
}

class Claim {
public:
  explicit Claim(const nlohmann::json& line)
      : r_(kov::parse_expression(line.at("r").get<std::string>(), "r")), kind_(kind(line)),
        text_(kov::parse_expression(line.at(kind_).get<std::string>(), kind_)) {}

  // At the point (a + b i)/97.
  [[nodiscard]] Seen at(slong a, slong b) const {
    kov::ComplexBall point;
    acb_set_si_si(point.raw(), a, b);
    acb_div_si(point.raw(), point.raw(), 97, bits);
    Series x(point.raw());
    acb_poly_set_coeff_si(x.raw(), 1, 1);
    const Evaluator jet({{"x", x}, {"z", x}}, 3);
    kov::ComplexBall r = jet(r_).at(0);
    acb_neg(r.raw(), r.raw());
    if (kind_ == "y") {
      const Series y = jet(text_);
      if (acb_contains_zero(y.at(0).raw()) != 0) return Seen::unclear;
      kov::ComplexBall second = y.at(2);
      acb_mul_si(second.raw(), second.raw(), 2, bits);
      acb_mul(r.raw(), r.raw(), y.at(0).raw(), bits);
      return zero_sum(second, r);
    }
    if (kind_ == "omega") {
      const Series w = jet(text_);
      return riccati(w.at(0), w.at(1), r);
    }
    return every_root(point, x, r);
  }

private:
  static std::string kind(const nlohmann::json& line) {
    for (const char* key : {"y", "omega", "polynomial"})
      if (line.contains(key)) return key;
    throw Unreadable("no claim");
  }

  // w' + w^2 - r = 0?
  static Seen riccati(const kov::ComplexBall& w, const kov::ComplexBall& dw,
                      const kov::ComplexBall& minus_r) {
    kov::ComplexBall left;
    acb_mul(left.raw(), w.raw(), w.raw(), bits);
    acb_add(left.raw(), left.raw(), dw.raw(), bits);
    return zero_sum(left, minus_r);
  }

  // omega' = -P_x/P_omega at each root of P(point, omega)
  [[nodiscard]] Seen every_root(const kov::ComplexBall& point, const Series& x,
                                const kov::ComplexBall& minus_r) const {
    Series t;
    acb_poly_set_coeff_si(t.raw(), 1, 1);
    const Series c(point.raw());
    const Series p = Evaluator({{"x", c}, {"z", c}, {"omega", t}}, 64)(text_);
    const slong degree = p.raw()->length - 1;
    if (degree < 1 || degree > 60) return Seen::unclear;
    acb_ptr roots = _acb_vec_init(degree);
    const slong n = acb_poly_find_roots(roots, p.raw(), nullptr, 0, bits);
    Seen seen = n == degree ? Seen::holds : Seen::unclear;
    for (slong i = 0; i < n && seen == Seen::holds; ++i) {
      kov::ComplexBall w;
      acb_set(w.raw(), roots + i);
      Series w_series(w.raw());
      const Series px = Evaluator({{"x", x}, {"z", x}, {"omega", w_series}}, 2)(text_);
      acb_poly_set_coeff_si(w_series.raw(), 1, 1);
      const Series pw = Evaluator({{"x", c}, {"z", c}, {"omega", w_series}}, 2)(text_);
      kov::ComplexBall slope = px.at(1);
      acb_div(slope.raw(), slope.raw(), pw.at(1).raw(), bits);
      acb_neg(slope.raw(), slope.raw());
      seen = riccati(w, slope, minus_r);
    }
    _acb_vec_clear(roots, degree);
    return seen;
  }

  Expression r_;
  std::string kind_;
  Expression text_;
};

std::pair<std::string, std::string> substituted(const nlohmann::json& line) {
  const Claim claim(line);
  bool failed = false;
  for (const auto& [a, b] :
       {std::pair(31, 0), {-213, 101}, {113, -67}, {509, 3}, {17, 290}, {-7, -5}}) {
    const Seen seen = claim.at(a, b);
    if (seen == Seen::holds) return {"right", ""};
    failed = failed || seen == Seen::fails;
  }
  if (failed) return {"wrong", "the residual is not 0"};
  return {"unreadable", "no point at which the claim has a value"};
}

} // namespace

int main() {
  for (std::string text; std::getline(std::cin, text);) {
    nlohmann::json answer;
    try {
      const auto line = nlohmann::json::parse(text);
      std::tie(answer["verdict"], answer["why"]) = substituted(line);
    } catch (const std::exception& e) {
      answer = {{"verdict", "unreadable"}, {"why", e.what()}};
    }
    std::cout << answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  }
  return 0;
}
