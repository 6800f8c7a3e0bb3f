#include "symbol/read_back.hpp"

#include "exact/error.hpp"
#include "exact/tried.hpp"
#include "symbol/approximation.hpp"
#include "symbol/ginac_door.hpp"
#include "symbol/written.hpp"

#include <acb_hypgeom.h>

#include <sstream>

namespace kov {
namespace {

using GiNaC::ex;

// The precision of the balls; the first is nearly always enough.
constexpr slong precisions[]{192, 800};
constexpr std::size_t longest = 20000;
constexpr long most_steps = 20000; // of an evaluation

using Numbers = std::map<std::string, ComplexBall>;
using Roots = std::map<std::string, Expression>;

class NoValueHere : public Error {
  using Error::Error;
};

void set(ComplexBall& to, const Rational& re, const Rational& im, slong bits) {
  arb_set_fmpq(acb_realref(to.raw()), re.raw(), bits);
  arb_set_fmpq(acb_imagref(to.raw()), im.raw(), bits);
}

Rational rational(const GiNaC::numeric& q) {
  if (!q.is_rational()) throw NoValueHere("an inexact number");
  std::ostringstream text;
  text << q;
  return Rational::parse(text.str());
}

// D_n(x), DLMF 12.7.
constexpr const char* cylinder =
    "2^(n/2)*exp(-x^2/4)*sqrt(pi)*(hyp1f1(-n/2, 1/2, x^2/2)*rgamma((1 - n)/2) - "
    "sqrt(2)*x*hyp1f1((1 - n)/2, 3/2, x^2/2)*rgamma(-n/2))";

class Values {
public:
  Values(const Numbers& at, const Roots& roots, slong bits) : at_(at), roots_(roots), bits_(bits) {}

  ComplexBall operator()(const ex& e) {
    // y, y' and y'' have most of their parts in common
    if (const auto it = known_.find(e); it != known_.end()) return it->second;
    return known_.emplace(e, value(e)).first->second;
  }

  // |e| and the largest of its terms.
  std::pair<Ball, Ball> with_size(const ex& e) {
    ComplexBall total;
    Ball largest, size;
    const auto take = [&](const ex& term) {
      const ComplexBall x = (*this)(term);
      acb_add(total.raw(), total.raw(), x.raw(), bits_);
      acb_abs(size.raw(), x.raw(), bits_);
      if (arb_gt(size.raw(), largest.raw()) != 0) largest = size;
    };
    if (GiNaC::is_a<GiNaC::add>(e))
      for (const ex& term : e)
        take(term);
    else
      take(e);
    acb_abs(size.raw(), total.raw(), bits_);
    if (acb_is_finite(total.raw()) == 0) arb_indeterminate(size.raw());
    return {size, largest};
  }

private:
  ComplexBall value(const ex& e) {
    if (++steps_ > most_steps) throw OutOfBudget("a solution is long");
    ComplexBall out;
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
      const auto& n = GiNaC::ex_to<GiNaC::numeric>(e);
      set(out, rational(n.real()), rational(n.imag()), bits_);
    } else if (e.is_equal(GiNaC::Pi)) {
      acb_const_pi(out.raw(), bits_);
    } else if (GiNaC::is_a<GiNaC::symbol>(e)) {
      return of_symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    } else if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
      const bool sum = GiNaC::is_a<GiNaC::add>(e);
      acb_set_si(out.raw(), sum ? 0 : 1);
      for (const ex& part : e)
        (sum ? acb_add : acb_mul)(out.raw(), out.raw(), (*this)(part).raw(), bits_);
    } else if (GiNaC::is_a<GiNaC::power>(e)) {
      const ComplexBall base = (*this)(e.op(0)), exponent = (*this)(e.op(1));
      acb_pow(out.raw(), base.raw(), exponent.raw(), bits_);
    } else if (GiNaC::is_a<GiNaC::function>(e)) {
      return of_function(GiNaC::ex_to<GiNaC::function>(e));
    } else {
      throw NoValueHere("an expression");
    }
    return out;
  }

  ComplexBall of_symbol(const std::string& name) {
    if (const auto it = at_.find(name); it != at_.end()) return it->second;
    const auto root = roots_.find(name);
    if (root == roots_.end()) throw NoValueHere(name);
    return near(root->second.operand(0), read_approximation(root->second.operand(1)));
  }

  // The root of p there: Newton's method.
  ComplexBall near(const Expression& p, const Point& there) const {
    const std::vector<std::string> letters = names_in(parse_expression(written(p), "p"));
    if (letters.size() != 1) throw NoValueHere("root");
    SymbolTable symbols;
    const ex f = to_ginac(p, symbols), slope = f.diff(symbols[letters.front()]);
    ComplexBall x, step;
    set(x, there.re, there.im, bits_);
    for (int i = 0; i < 40; ++i) {
      acb_get_mid(x.raw(), x.raw());
      const Numbers at{{letters.front(), x}};
      Values values(at, symbols.roots(), bits_);
      acb_div(step.raw(), values(f).raw(), values(slope).raw(), bits_);
      acb_sub(x.raw(), x.raw(), step.raw(), bits_);
    }
    acb_get_mid(x.raw(), x.raw());
    return x;
  }

  ComplexBall of_function(const GiNaC::function& e) {
    std::string f = e.get_name();
    std::vector<ComplexBall> a;
    std::size_t first = 0; // the arguments of `called` that are
    if (f == "called") {
      f = GiNaC::ex_to<GiNaC::symbol>(e.op(0)).get_name();
      if (f == "int") return of_integral(GiNaC::ex_to<GiNaC::numeric>(e.op(3)));
      first = 1;
    }
    for (std::size_t i = first; i < e.nops(); ++i)
      a.push_back((*this)(e.op(i)));
    ComplexBall out;
    const auto r = out.raw();
    // the last one is x(0)
    const auto x = [&](std::size_t i) { return a.at(a.size() - 1 - i).raw(); };
    using One = void (*)(acb_t, const acb_t, slong);
    static const std::map<std::string, One> of_one{
        {"exp", acb_exp},       {"log", acb_log},       {"sin", acb_sin},
        {"cos", acb_cos},       {"sinh", acb_sinh},     {"cosh", acb_cosh},
        {"atan", acb_atan},     {"asin", acb_asin},     {"acos", acb_acos},
        {"asinh", acb_asinh},   {"acosh", acb_acosh},   {"atanh", acb_atanh},
        {"tan", acb_tan},       {"tanh", acb_tanh},     {"erf", acb_hypgeom_erf},
        {"Ei", acb_hypgeom_ei}, {"rgamma", acb_rgamma}, {"erfi", acb_hypgeom_erfi}};
    if (const auto it = of_one.find(f); it != of_one.end())
      it->second(r, x(0), bits_);
    else if (f == "airyai")
      acb_hypgeom_airy(r, nullptr, nullptr, nullptr, x(0), bits_);
    else if (f == "airyaiprime")
      acb_hypgeom_airy(nullptr, r, nullptr, nullptr, x(0), bits_);
    else if (f == "airybi")
      acb_hypgeom_airy(nullptr, nullptr, r, nullptr, x(0), bits_);
    else if (f == "airybiprime")
      acb_hypgeom_airy(nullptr, nullptr, nullptr, r, x(0), bits_);
    else if (f == "besselj")
      acb_hypgeom_bessel_j(r, x(1), x(0), bits_);
    else if (f == "bessely")
      acb_hypgeom_bessel_y(r, x(1), x(0), bits_);
    else if (f == "besseli")
      acb_hypgeom_bessel_i(r, x(1), x(0), bits_);
    else if (f == "besselk")
      acb_hypgeom_bessel_k(r, x(1), x(0), bits_);
    else if (f == "hyp1f1")
      acb_hypgeom_m(r, x(2), x(1), x(0), 0, bits_);
    else if (f == "hyperu")
      acb_hypgeom_u(r, x(2), x(1), x(0), bits_);
    else if (f == "hyp2f1")
      acb_hypgeom_2f1(r, x(3), x(2), x(1), x(0), 0, bits_);
    else if (f == "legenp")
      acb_hypgeom_legendre_p(r, x(2), x(1), x(0), 0, bits_);
    else if (f == "legenq")
      acb_hypgeom_legendre_q(r, x(2), x(1), x(0), 0, bits_);
    else if (f == "pcfd")
      return of_formula(cylinder, {{"n", a.at(a.size() - 2)}, {"x", a.back()}});
    else
      throw NoValueHere(f);
    return out;
  }

  [[nodiscard]] ComplexBall of_formula(const char* text, const Numbers& at) const {
    SymbolTable symbols;
    return Values(at, roots_, bits_)(to_ginac(parse_expression(text, "a function"), symbols));
  }

  // Any constant of integration does.
  [[nodiscard]] ComplexBall of_integral(const GiNaC::numeric& number) const {
    ComplexBall out;
    set(out, rational(number) + Rational(7, 3), 0, bits_);
    return out;
  }

  const Numbers& at_;
  const Roots& roots_;
  slong bits_;
  std::map<ex, ComplexBall, GiNaC::ex_is_less> known_;
  long steps_ = 0;
};

// Numbers of 40 digits for the names of an expression, exact: n - n is 0.
class Points {
public:
  Points(const ex& e, const Roots& roots) {
    flint_randinit(state_);
    collect(e);
    for (const auto& [name, root] : roots)
      names_.erase(name);
  }
  Points(const Points&) = delete;
  Points& operator=(const Points&) = delete;
  ~Points() { flint_randclear(state_); }

  // Re and Im between 1/8 and 9/8, half of it for the variable; where all are positive, Re between 1/2 and 3/2 and
  // no imaginary part but a small one of the variable.
  Numbers operator()(const std::string& variable, bool positive) {
    Numbers at;
    for (const std::string& name : names_) {
      ComplexBall x;
      if (positive) {
        random(acb_realref(x.raw()), 0.5);
        if (name == variable) random(acb_imagref(x.raw()), 0.125);
        arb_mul_2exp_si(acb_imagref(x.raw()), acb_imagref(x.raw()), -3);
      } else {
        random(acb_realref(x.raw()), 0.125);
        random(acb_imagref(x.raw()), 0.125);
        acb_mul_2exp_si(x.raw(), x.raw(), name == variable ? -1 : 0);
      }
      at.emplace(name, x);
    }
    return at;
  }

private:
  void collect(const ex& e) {
    if (GiNaC::is_a<GiNaC::symbol>(e)) names_.insert(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    for (std::size_t i = is_called(e) ? 1 : 0; i < e.nops(); ++i)
      collect(e.op(i));
  }
  static bool is_called(const ex& e) {
    return GiNaC::is_a<GiNaC::function>(e) &&
           GiNaC::ex_to<GiNaC::function>(e).get_name() == "called";
  }
  void random(arb_ptr x, double from) {
    arb_t shift;
    arb_init(shift);
    arb_set_d(shift, from);
    arf_urandom(arb_midref(x), state_, 132, ARF_RND_DOWN);
    arb_add(x, x, shift, 192);
    arb_clear(shift);
  }

  flint_rand_t state_;
  std::set<std::string> names_;
};

ReadBack at_points(const ex& residue, const Roots& roots, const std::string& variable,
                   bool positive, slong bits) {
  Points points(residue, roots);
  for (int point = 0; point < 2; ++point) {
    const Numbers at = points(variable, positive);
    const auto [value, size] = Values(at, roots, bits).with_size(residue);
    Ball scaled;
    arb_set_si(scaled.raw(), 10);
    arb_pow_ui(scaled.raw(), scaled.raw(), 25, bits);
    arb_mul(scaled.raw(), scaled.raw(), value.raw(), bits);
    if (arb_le(scaled.raw(), size.raw()) != 0) continue;
    const bool apart = arb_is_finite(value.raw()) != 0 && arb_contains_zero(value.raw()) == 0;
    return apart ? ReadBack::differs : ReadBack::unknown; // the balls are too large
  }
  return ReadBack::solves;
}

ReadBack at_points(const Expression& equation, const std::string& variable,
                   std::map<std::string, Expression> values, bool positive) {
  try {
    SymbolTable symbols(std::move(values), variable);
    const ex residue = to_ginac(equation, symbols);
    ReadBack result = ReadBack::unknown;
    for (const slong bits : precisions) {
      result = at_points(residue, symbols.roots(), variable, positive, bits);
      if (result != ReadBack::unknown) break;
    }
    return result;
  } catch (const OutOfBudget&) {
    return ReadBack::too_long;
  } catch (const std::exception&) { // of GiNaC: a pole at a point
    return ReadBack::unknown;
  }
}

} // namespace

ReadBack read_back(const std::string& text, const ReadBackEquation& equation) {
  if (text.size() > longest) return ReadBack::too_long;
  const auto printed =
      tried<InputError>([&] { return std::optional(parse_expression(text, "a solution")); });
  if (!printed) return ReadBack::unknown;
  std::map<std::string, Expression> values = equation.values;
  for (const auto& [name, meaning] : equation.constants)
    values.emplace(name, parse_expression(meaning, "a constant"));
  values.insert_or_assign(equation.unknown, *printed);
  return at_points(equation.ode, equation.variable, std::move(values), false);
}

ReadBack holds_where_positive(const Expression& equation, const std::string& variable,
                              std::map<std::string, Expression> values) {
  return at_points(equation, variable, std::move(values), true);
}

std::optional<int> sign_at(const Expression& e, const std::map<std::string, Rational>& point,
                           const std::string& variable, std::map<std::string, Expression> values) {
  return tried<std::exception>([&]() -> std::optional<int> {
    SymbolTable symbols(std::move(values), variable);
    const ex f = to_ginac(e, symbols);
    Numbers at;
    for (const auto& [name, value] : point)
      arb_set_fmpq(acb_realref(at[name].raw()), value.raw(), precisions[0]);
    const ComplexBall found = Values(at, symbols.roots(), precisions[0])(f);
    const arb_struct* real = acb_realref(found.raw());
    if (acb_is_finite(found.raw()) == 0) return std::nullopt;
    return arb_is_positive(real) != 0 ? 1 : arb_is_negative(real) != 0 ? -1 : 0;
  });
}

bool has_value_somewhere(const Expression& e) {
  return tried<std::exception>([&] {
    SymbolTable symbols;
    const ex value = to_ginac(e, symbols);
    const Roots& roots = symbols.roots();
    const Numbers at = Points(value, roots)("", false);
    return acb_is_finite(Values(at, roots, precisions[0])(value).raw()) != 0;
  });
}

} // namespace kov
