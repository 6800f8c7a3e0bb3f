#include "answer/read_back.hpp"

#include "exact/ball.hpp"
#include "exact/error.hpp"
#include "symbol/expression.hpp"
#include "symbol/written.hpp"

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb_fmpz_poly.h>
#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace kov::answer {
namespace {

using GiNaC::ex;
using Kind = Expression::Kind;

// The precision of the balls; the first is nearly always enough.
constexpr slong precisions[]{192, 800};
thread_local slong bits = precisions[0];
constexpr std::size_t longest = 20000;
constexpr long most_steps = 20000; // of an evaluation

class Valueless {}; // of a function, at this point

// The functions that GiNaC does not have, with their derivatives by the last argument.
std::vector<ex> integrands; // of integral(k, x)

DECLARE_FUNCTION_2P(besselj)
DECLARE_FUNCTION_2P(bessely)
DECLARE_FUNCTION_2P(besseli)
DECLARE_FUNCTION_2P(besselk)
DECLARE_FUNCTION_1P(airyai)
DECLARE_FUNCTION_1P(airybi)
DECLARE_FUNCTION_1P(airyaiprime)
DECLARE_FUNCTION_1P(airybiprime)
DECLARE_FUNCTION_2P(pcfd)
DECLARE_FUNCTION_3P(hyp1f1)
DECLARE_FUNCTION_3P(hyperu)
DECLARE_FUNCTION_4P(hyp2f1)
DECLARE_FUNCTION_3P(legenp)
DECLARE_FUNCTION_3P(legenq)
DECLARE_FUNCTION_1P(erf)
DECLARE_FUNCTION_1P(erfi)
DECLARE_FUNCTION_1P(Ei)
DECLARE_FUNCTION_2P(integral)

ex besselj_d(const ex& n, const ex& x, unsigned) {
  return besselj(n - 1, x) - n / x * besselj(n, x);
}
ex bessely_d(const ex& n, const ex& x, unsigned) {
  return bessely(n - 1, x) - n / x * bessely(n, x);
}
ex besseli_d(const ex& n, const ex& x, unsigned) {
  return besseli(n - 1, x) - n / x * besseli(n, x);
}
ex besselk_d(const ex& n, const ex& x, unsigned) {
  return -besselk(n - 1, x) - n / x * besselk(n, x);
}
ex airyai_d(const ex& x, unsigned) { return airyaiprime(x); }
ex airybi_d(const ex& x, unsigned) { return airybiprime(x); }
ex airyaiprime_d(const ex& x, unsigned) { return x * airyai(x); }
ex airybiprime_d(const ex& x, unsigned) { return x * airybi(x); }
ex pcfd_d(const ex& n, const ex& x, unsigned) { return x / 2 * pcfd(n, x) - pcfd(n + 1, x); }
ex hyp1f1_d(const ex& a, const ex& b, const ex& x, unsigned) {
  return a / b * hyp1f1(a + 1, b + 1, x);
}
ex hyperu_d(const ex& a, const ex& b, const ex& x, unsigned) {
  return -a * hyperu(a + 1, b + 1, x);
}
ex hyp2f1_d(const ex& a, const ex& b, const ex& c, const ex& x, unsigned) {
  return a * b / c * hyp2f1(a + 1, b + 1, c + 1, x);
}
ex legenp_d(const ex& n, const ex& m, const ex& x, unsigned) {
  return ((n + 1) * x * legenp(n, m, x) - (n - m + 1) * legenp(n + 1, m, x)) / (1 - x * x);
}
ex legenq_d(const ex& n, const ex& m, const ex& x, unsigned) {
  return ((n + 1) * x * legenq(n, m, x) - (n - m + 1) * legenq(n + 1, m, x)) / (1 - x * x);
}
ex erf_d(const ex& x, unsigned) { return 2 / GiNaC::sqrt(GiNaC::Pi) * GiNaC::exp(-x * x); }
ex erfi_d(const ex& x, unsigned) { return 2 / GiNaC::sqrt(GiNaC::Pi) * GiNaC::exp(x * x); }
ex Ei_d(const ex& x, unsigned) { return GiNaC::exp(x) / x; }
ex integral_d(const ex& k, const ex&, unsigned) {
  return integrands.at(static_cast<std::size_t>(GiNaC::ex_to<GiNaC::numeric>(k).to_int()));
}

REGISTER_FUNCTION(besselj, derivative_func(besselj_d))
REGISTER_FUNCTION(bessely, derivative_func(bessely_d))
REGISTER_FUNCTION(besseli, derivative_func(besseli_d))
REGISTER_FUNCTION(besselk, derivative_func(besselk_d))
REGISTER_FUNCTION(airyai, derivative_func(airyai_d))
REGISTER_FUNCTION(airybi, derivative_func(airybi_d))
REGISTER_FUNCTION(airyaiprime, derivative_func(airyaiprime_d))
REGISTER_FUNCTION(airybiprime, derivative_func(airybiprime_d))
REGISTER_FUNCTION(pcfd, derivative_func(pcfd_d))
REGISTER_FUNCTION(hyp1f1, derivative_func(hyp1f1_d))
REGISTER_FUNCTION(hyperu, derivative_func(hyperu_d))
REGISTER_FUNCTION(hyp2f1, derivative_func(hyp2f1_d))
REGISTER_FUNCTION(legenp, derivative_func(legenp_d))
REGISTER_FUNCTION(legenq, derivative_func(legenq_d))
REGISTER_FUNCTION(erf, derivative_func(erf_d))
REGISTER_FUNCTION(erfi, derivative_func(erfi_d))
REGISTER_FUNCTION(Ei, derivative_func(Ei_d))
REGISTER_FUNCTION(integral, derivative_func(integral_d))

// ----- from the text to GiNaC, the unknown being the solution

class Reader {
public:
  Reader(const ReadBackEquation& equation) : e_(equation) {}

  ex operator()(const Expression& e) {
    switch (e.kind()) {
    case Kind::number:
      return GiNaC::numeric(to_string(e.number()).c_str());
    case Kind::name:
      return of_name(e.name());
    case Kind::sum:
    case Kind::product: {
      const bool sum = e.kind() == Kind::sum;
      ex all = sum ? 0 : 1;
      for (const Expression& x : e.operands())
        all = sum ? all + (*this)(x) : all * (*this)(x);
      return all;
    }
    case Kind::negate:
      return -(*this)(e.operand(0));
    case Kind::quotient: {
      const ex below = (*this)(e.operand(1));
      if (below.is_zero()) throw Valueless{};
      return (*this)(e.operand(0)) / below;
    }
    case Kind::power:
      return GiNaC::pow((*this)(e.operand(0)), (*this)(e.operand(1)));
    case Kind::derivative:
      return derivative((*this)(e.operand(0)), e.order());
    case Kind::equation:
      return (*this)(e.operand(0)) - (*this)(e.operand(1));
    case Kind::call:
      return of_call(e);
    default:
      throw Valueless{};
    }
  }
  void solution(const ex& y) { y_ = y; }
  [[nodiscard]] const GiNaC::symbol& variable() { return symbol(e_.variable); }

private:
  // One for each name: two symbols of the same name would be different variables.
  const GiNaC::symbol& symbol(const std::string& name) {
    return symbols_.try_emplace(name, name).first->second;
  }
  // y'' is the derivative of y', which an equation has as well.
  ex derivative(const ex& e, long order) {
    if (order == 0) return e;
    const auto [it, is_new] = slopes_.try_emplace(e);
    if (is_new) it->second = e.diff(variable());
    return derivative(it->second, order - 1);
  }

  ex of_name(const std::string& name) {
    if (name == "I") return GiNaC::I;
    if (name == e_.unknown && y_) return *y_;
    if (const auto it = e_.values.find(name); it != e_.values.end()) return (*this)(it->second);
    if (name == "pi") return GiNaC::Pi;
    return symbol(name);
  }

  ex of_call(const Expression& e) {
    const std::string& f = e.name();
    if (f == e_.unknown && y_ && e.operands().size() == 1) return *y_;
    if (f == "diff" && e.operands().size() >= 2) {
      long order = 1;
      if (e.operands().size() == 3) {
        const Expression& last = e.operand(2);
        order = last.kind() == Kind::number ? to_long(last.number()) : 2;
      }
      return derivative((*this)(e.operand(0)), order);
    }
    if (f == "int" && e.operands().size() == 2) {
      integrands.push_back((*this)(e.operand(0)));
      return integral(static_cast<int>(integrands.size() - 1), variable());
    }
    std::vector<ex> a;
    for (const Expression& x : e.operands())
      a.push_back((*this)(x));
    using One = ex (*)(const ex&);
    static const std::map<std::string, One> of_one{
        {"sqrt", [](const ex& x) -> ex { return GiNaC::sqrt(x); }},
        {"exp", [](const ex& x) -> ex { return GiNaC::exp(x); }},
        {"log", [](const ex& x) -> ex { return GiNaC::log(x); }},
        {"ln", [](const ex& x) -> ex { return GiNaC::log(x); }},
        {"sin", [](const ex& x) -> ex { return GiNaC::sin(x); }},
        {"cos", [](const ex& x) -> ex { return GiNaC::cos(x); }},
        {"tan", [](const ex& x) -> ex { return GiNaC::tan(x); }},
        {"cot", [](const ex& x) -> ex { return 1 / GiNaC::tan(x); }},
        {"sec", [](const ex& x) -> ex { return 1 / GiNaC::cos(x); }},
        {"csc", [](const ex& x) -> ex { return 1 / GiNaC::sin(x); }},
        {"sinh", [](const ex& x) -> ex { return GiNaC::sinh(x); }},
        {"cosh", [](const ex& x) -> ex { return GiNaC::cosh(x); }},
        {"tanh", [](const ex& x) -> ex { return GiNaC::tanh(x); }},
        {"coth", [](const ex& x) -> ex { return 1 / GiNaC::tanh(x); }},
        {"sech", [](const ex& x) -> ex { return 1 / GiNaC::cosh(x); }},
        {"csch", [](const ex& x) -> ex { return 1 / GiNaC::sinh(x); }},
        {"atan", [](const ex& x) -> ex { return GiNaC::atan(x); }},
        {"asin", [](const ex& x) -> ex { return GiNaC::asin(x); }},
        {"acos", [](const ex& x) -> ex { return GiNaC::acos(x); }},
        {"asinh", [](const ex& x) -> ex { return GiNaC::asinh(x); }},
        {"acosh", [](const ex& x) -> ex { return GiNaC::acosh(x); }},
        {"atanh", [](const ex& x) -> ex { return GiNaC::atanh(x); }},
        {"erf", [](const ex& x) -> ex { return erf(x); }},
        {"erfi", [](const ex& x) -> ex { return erfi(x); }},
        {"Ei", [](const ex& x) -> ex { return Ei(x); }},
        {"airyai", [](const ex& x) -> ex { return airyai(x); }},
        {"airyaiprime", [](const ex& x) -> ex { return airyaiprime(x); }},
        {"airybiprime", [](const ex& x) -> ex { return airybiprime(x); }},
        {"airybi", [](const ex& x) -> ex { return airybi(x); }}};
    if (a.size() == 1)
      if (const auto it = of_one.find(f); it != of_one.end()) return it->second(a[0]);
    if (a.size() == 2) {
      if (f == "besselj") return besselj(a[0], a[1]);
      if (f == "bessely") return bessely(a[0], a[1]);
      if (f == "besseli") return besseli(a[0], a[1]);
      if (f == "besselk") return besselk(a[0], a[1]);
      if (f == "pcfd") return pcfd(a[0], a[1]);
    }
    if (a.size() == 3) {
      if (f == "hyp1f1") return hyp1f1(a[0], a[1], a[2]);
      if (f == "hyperu") return hyperu(a[0], a[1], a[2]);
      if (f == "legenp") return legenp(a[0], a[1], a[2]);
      if (f == "legenq") return legenq(a[0], a[1], a[2]);
    }
    if (a.size() == 4 && f == "hyp2f1") return hyp2f1(a[0], a[1], a[2], a[3]);
    throw Valueless{};
  }

  const ReadBackEquation& e_;
  std::optional<ex> y_;
  std::map<std::string, GiNaC::symbol> symbols_;
  GiNaC::exmap slopes_;
};

// ----- values

class Values {
public:
  explicit Values(const std::map<std::string, ComplexBall>& at) : at_(at) {}

  ComplexBall operator()(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return number(GiNaC::ex_to<GiNaC::numeric>(e));
    if (GiNaC::is_a<GiNaC::constant>(e)) {
      if (!e.is_equal(GiNaC::Pi)) throw Valueless{};
      ComplexBall out;
      acb_const_pi(out.raw(), bits);
      return out;
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
      const auto it = at_.find(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
      if (it == at_.end()) throw Valueless{};
      return it->second;
    }
    // y, y' and y'' have most of their parts in common
    if (const auto it = known_.find(e); it != known_.end()) return it->second;
    return known_.emplace(e, made_of_parts(e)).first->second;
  }

  // |e| and the largest of its terms.
  std::pair<ComplexBall, ComplexBall> with_size(const ex& e) {
    ComplexBall total, largest;
    const auto take = [&](const ex& term) {
      const ComplexBall x = (*this)(term);
      acb_add(total.raw(), total.raw(), x.raw(), bits);
      ComplexBall size;
      acb_abs(acb_realref(size.raw()), x.raw(), bits);
      if (arb_gt(acb_realref(size.raw()), acb_realref(largest.raw()))) largest = size;
    };
    if (GiNaC::is_a<GiNaC::add>(e))
      for (std::size_t i = 0; i < e.nops(); ++i)
        take(e.op(i));
    else
      take(e);
    acb_abs(acb_realref(total.raw()), total.raw(), bits);
    arb_zero(acb_imagref(total.raw()));
    return {total, largest};
  }

private:
  ComplexBall made_of_parts(const ex& e) {
    if (++steps_ > most_steps) throw OutOfBudget("a solution is long");
    ComplexBall out;
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
      const bool sum = GiNaC::is_a<GiNaC::add>(e);
      acb_set_si(out.raw(), sum ? 0 : 1);
      for (std::size_t i = 0; i < e.nops(); ++i) {
        const ComplexBall x = (*this)(e.op(i));
        (sum ? acb_add : acb_mul)(out.raw(), out.raw(), x.raw(), bits);
      }
      return out;
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
      const ComplexBall base = (*this)(e.op(0)), exponent = (*this)(e.op(1));
      acb_pow(out.raw(), base.raw(), exponent.raw(), bits);
      return out;
    }
    if (GiNaC::is_a<GiNaC::function>(e)) return function(GiNaC::ex_to<GiNaC::function>(e));
    throw Valueless{};
  }

  static ComplexBall number(const GiNaC::numeric& n) {
    ComplexBall out;
    const auto part = [](arb_ptr x, const GiNaC::numeric& q) {
      const auto is_short = [](const GiNaC::numeric& i) {
        return i.is_integer() && i < 1000000 && i > -1000000;
      };
      if (q.is_rational() && is_short(q.numer()) && is_short(q.denom())) {
        arb_set_si(x, q.numer().to_int());
        if (!q.is_integer()) arb_div_si(x, x, q.denom().to_int(), bits);
        return;
      }
      std::ostringstream text;
      text << q;
      fmpq_t value;
      fmpq_init(value);
      if (!q.is_rational() || fmpq_set_str(value, text.str().c_str(), 10) != 0) {
        fmpq_clear(value);
        throw Valueless{};
      }
      arb_set_fmpq(x, value, bits);
      fmpq_clear(value);
    };
    part(acb_realref(out.raw()), n.real());
    part(acb_imagref(out.raw()), n.imag());
    return out;
  }

  ComplexBall function(const GiNaC::function& f) {
    const std::string name = f.get_name();
    if (name == "integral") { // any constant of integration does
      ComplexBall out = number(GiNaC::numeric(7, 3));
      const ComplexBall k = (*this)(f.op(0));
      acb_add(out.raw(), out.raw(), k.raw(), bits);
      return out;
    }
    std::vector<ComplexBall> a;
    for (std::size_t i = 0; i < f.nops(); ++i)
      a.push_back((*this)(f.op(i)));
    ComplexBall out;
    const auto r = out.raw();
    const auto x = [&](std::size_t i) { return a.at(i).raw(); };
    using One = void (*)(acb_t, const acb_t, slong);
    static const std::map<std::string, One> of_one{
        {"exp", acb_exp},           {"log", acb_log},      {"sin", acb_sin},
        {"cos", acb_cos},           {"tan", acb_tan},      {"sinh", acb_sinh},
        {"cosh", acb_cosh},         {"tanh", acb_tanh},    {"atan", acb_atan},
        {"asin", acb_asin},         {"acos", acb_acos},    {"asinh", acb_asinh},
        {"acosh", acb_acosh},       {"atanh", acb_atanh},  {"erf", acb_hypgeom_erf},
        {"erfi", acb_hypgeom_erfi}, {"Ei", acb_hypgeom_ei}};
    if (const auto it = of_one.find(name); it != of_one.end()) {
      it->second(r, x(0), bits);
      return out;
    }
    if (name == "airyai") return acb_hypgeom_airy(r, nullptr, nullptr, nullptr, x(0), bits), out;
    if (name == "airyaiprime")
      return acb_hypgeom_airy(nullptr, r, nullptr, nullptr, x(0), bits), out;
    if (name == "airybi") return acb_hypgeom_airy(nullptr, nullptr, r, nullptr, x(0), bits), out;
    if (name == "airybiprime")
      return acb_hypgeom_airy(nullptr, nullptr, nullptr, r, x(0), bits), out;
    if (name == "besselj") return acb_hypgeom_bessel_j(r, x(0), x(1), bits), out;
    if (name == "bessely") return acb_hypgeom_bessel_y(r, x(0), x(1), bits), out;
    if (name == "besseli") return acb_hypgeom_bessel_i(r, x(0), x(1), bits), out;
    if (name == "besselk") return acb_hypgeom_bessel_k(r, x(0), x(1), bits), out;
    if (name == "hyp1f1") return acb_hypgeom_m(r, x(0), x(1), x(2), 0, bits), out;
    if (name == "hyperu") return acb_hypgeom_u(r, x(0), x(1), x(2), bits), out;
    if (name == "hyp2f1") return acb_hypgeom_2f1(r, x(0), x(1), x(2), x(3), 0, bits), out;
    if (name == "legenp") return acb_hypgeom_legendre_p(r, x(0), x(1), x(2), 0, bits), out;
    if (name == "legenq") return acb_hypgeom_legendre_q(r, x(0), x(1), x(2), 0, bits), out;
    if (name == "pcfd") return cylinder(a[0], a[1]);
    throw Valueless{};
  }

  // D_n(x) = 2^(n/2) e^(-x^2/4) sqrt(pi) (M(-n/2, 1/2, x^2/2)/G((1-n)/2) - sqrt(2) x M((1-n)/2, 3/2, x^2/2)/G(-n/2))
  static ComplexBall cylinder(const ComplexBall& n, const ComplexBall& x) {
    ComplexBall square, a, b, even, odd, out;
    acb_mul(square.raw(), x.raw(), x.raw(), bits);
    acb_mul_2exp_si(square.raw(), square.raw(), -1);
    const auto term = [&](ComplexBall& to, const ComplexBall& first, const ComplexBall& gamma_of,
                          slong twice_b) {
      ComplexBall second, gamma;
      acb_set_si(second.raw(), twice_b);
      acb_mul_2exp_si(second.raw(), second.raw(), -1);
      acb_hypgeom_m(to.raw(), first.raw(), second.raw(), square.raw(), 0, bits);
      acb_rgamma(gamma.raw(), gamma_of.raw(), bits);
      acb_mul(to.raw(), to.raw(), gamma.raw(), bits);
    };
    acb_mul_2exp_si(a.raw(), n.raw(), -1);
    acb_neg(a.raw(), a.raw()); // -n/2
    ComplexBall shift;
    acb_set_d(shift.raw(), 0.5);
    acb_add(b.raw(), a.raw(), shift.raw(), bits); // (1-n)/2
    term(even, a, b, 1);
    term(odd, b, a, 3);
    ComplexBall root;
    acb_set_si(root.raw(), 2);
    acb_sqrt(root.raw(), root.raw(), bits);
    acb_mul(odd.raw(), odd.raw(), x.raw(), bits);
    acb_mul(odd.raw(), odd.raw(), root.raw(), bits);
    acb_sub(out.raw(), even.raw(), odd.raw(), bits);
    ComplexBall factor, two;
    acb_mul_2exp_si(factor.raw(), square.raw(), -1);
    acb_neg(factor.raw(), factor.raw());
    acb_exp(factor.raw(), factor.raw(), bits);
    acb_mul(out.raw(), out.raw(), factor.raw(), bits);
    acb_set_si(two.raw(), 2);
    acb_neg(a.raw(), a.raw());
    acb_pow(factor.raw(), two.raw(), a.raw(), bits);
    acb_mul(out.raw(), out.raw(), factor.raw(), bits);
    return out;
  }

  const std::map<std::string, ComplexBall>& at_;
  std::map<ex, ComplexBall, GiNaC::ex_is_less> known_;
  long steps_ = 0;
};

// A number between 1/8 and 9/8 with 40 digits, exact: n - n is 0.
class Random {
public:
  arb_srcptr operator()(arb_ptr out) {
    fmpz_t digits;
    fmpz_init(digits);
    for (int i = 0; i < 4; ++i) {
      state_ = state_ * 6364136223846793005U + 1442695040888963407U;
      fmpz_mul_2exp(digits, digits, 33);
      fmpz_add_ui(digits, digits, static_cast<ulong>(state_ >> 31));
    }
    arb_set_fmpz(out, digits);
    arb_mul_2exp_si(out, out, -132);
    arb_t eighth;
    arb_init(eighth);
    arb_set_d(eighth, 0.125);
    arb_add(out, out, eighth, bits);
    arb_clear(eighth);
    fmpz_clear(digits);
    return out;
  }

private:
  std::uint64_t state_ = 20260;
};

void collect(const ex& e, std::set<std::string>& names) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) names.insert(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
  for (std::size_t i = 0; i < e.nops(); ++i)
    collect(e.op(i), names);
}

// A root of p near approx, where the meaning is root(p(x), approx).
std::optional<ComplexBall> value_of_constant(const std::string& meaning) {
  const Expression e = parse_expression(meaning, "a constant");
  if (e.kind() != Kind::call || e.name() != "root" || e.operands().size() != 2) return std::nullopt;
  const std::vector<std::string> letters = names_in(parse_expression(written(e.operand(0)), "p"));
  if (letters.size() != 1) return std::nullopt;
  // Newton's method from the approximate value, on GiNaC's polynomial
  const ReadBackEquation none{e.operand(0), "", letters.front(), {}, {}};
  Reader reader(none);
  const ex p = reader(e.operand(0)), slope = p.diff(reader.variable());
  std::map<std::string, ComplexBall> at;
  ComplexBall x;
  const std::function<void(const Expression&, ComplexBall&)> read = [&](const Expression& a,
                                                                        ComplexBall& to) {
    ComplexBall other;
    switch (a.kind()) {
    case Kind::decimal:
      arb_set_str(acb_realref(to.raw()), a.name().c_str(), bits);
      return;
    case Kind::number:
      arb_set_str(acb_realref(to.raw()), to_string(a.number()).c_str(), bits);
      return;
    case Kind::name:
      if (a.name() != "I") throw Valueless{};
      acb_onei(to.raw());
      return;
    case Kind::negate:
      read(a.operand(0), to);
      acb_neg(to.raw(), to.raw());
      return;
    case Kind::sum:
    case Kind::product: {
      const bool sum = a.kind() == Kind::sum;
      acb_set_si(to.raw(), sum ? 0 : 1);
      for (const Expression& y : a.operands()) {
        ComplexBall part;
        read(y, part);
        (sum ? acb_add : acb_mul)(to.raw(), to.raw(), part.raw(), bits);
      }
      return;
    }
    default:
      throw Valueless{};
    }
  };
  read(e.operand(1), x);
  for (int i = 0; i < 40; ++i) {
    acb_get_mid(x.raw(), x.raw());
    at.insert_or_assign(letters.front(), x);
    const ComplexBall value = Values(at)(p), rate = Values(at)(slope);
    ComplexBall step;
    acb_div(step.raw(), value.raw(), rate.raw(), bits);
    acb_sub(x.raw(), x.raw(), step.raw(), bits);
  }
  acb_get_mid(x.raw(), x.raw());
  return x;
}

bool is_small(const ComplexBall& value, const ComplexBall& size) {
  arb_t bound;
  arb_init(bound);
  arb_set_si(bound, 10);
  arb_pow_ui(bound, bound, 25, bits);
  arb_mul(bound, bound, acb_realref(value.raw()), bits);
  const bool small = arb_le(bound, acb_realref(size.raw())) != 0;
  arb_clear(bound);
  return small;
}

ReadBack at_points(const ex& residue, const std::set<std::string>& names,
                   const ReadBackEquation& equation) {
  Random random;
  for (int point = 0; point < 2; ++point) {
    std::map<std::string, ComplexBall> at;
    for (const std::string& name : names) {
      if (const auto it = equation.constants.find(name); it != equation.constants.end()) {
        const auto value = value_of_constant(it->second);
        if (!value) return ReadBack::unknown;
        at.emplace(name, *value);
        continue;
      }
      ComplexBall x;
      random(acb_realref(x.raw()));
      random(acb_imagref(x.raw()));
      acb_mul_2exp_si(x.raw(), x.raw(), name == equation.variable ? -1 : 0);
      at.emplace(name, x);
    }
    Values values(at);
    const auto [value, size] = values.with_size(residue);
    const bool known = acb_is_finite(value.raw()) != 0;
    if (known && is_small(value, size)) continue;
    const bool apart = known && arb_contains_zero(acb_realref(value.raw())) == 0;
    return apart ? ReadBack::differs : ReadBack::unknown; // the balls are too large
  }
  return ReadBack::solves;
}

} // namespace

ReadBack read_back(const std::string& text, const ReadBackEquation& equation) {
  if (text.size() > longest) return ReadBack::too_long;
  integrands.clear();
  try {
    Reader reader(equation);
    const Expression printed = parse_expression(text, "a solution");
    reader.solution(reader(printed));
    const ex residue = reader(equation.ode);
    std::set<std::string> names;
    collect(residue, names);
    ReadBack result = ReadBack::unknown;
    for (const slong precision : precisions) {
      bits = precision;
      result = at_points(residue, names, equation);
      if (result != ReadBack::unknown) break;
    }
    return result;
  } catch (const Valueless&) {
    return ReadBack::unknown;
  } catch (const InputError&) {
    return ReadBack::unknown;
  } catch (const OutOfBudget&) {
    return ReadBack::too_long;
  } catch (const std::exception&) { // of GiNaC: a pole at a point
    return ReadBack::unknown;
  }
}

} // namespace kov::answer
