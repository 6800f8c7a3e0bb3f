#include "symbol/rational_form.hpp"

#include "exact/lists.hpp"
#include "symbol/partial_fractions.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <cmath>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr double max_bits = 1UL << 28; // 32 MiB of coefficients in one polynomial
constexpr long largest_split_power = 64;

std::string shortened(const Integer& n) {
  const std::string s = to_string(n);
  return s.size() <= 40 ? s : s.substr(0, 20) + "... (" + std::to_string(s.size()) + " digits)";
}

// Bits of the longest coefficient, denominators included.
double coefficient_bits(const Poly& f) {
  return static_cast<double>(std::abs(_fmpz_vec_max_bits(f.raw()->coeffs, f.raw()->length)) +
                             static_cast<long>(fmpz_bits(f.raw()->den)) + 1);
}

// Bits that one more factor f adds to the longest coefficient of a power: log2 of the sum of the
// sizes of its coefficients, from above, and what the reduction modulo the minimal polynomial adds.
double growth_bits(const Poly& f) {
  long terms = 0;
  for (long i = 0; i < f.raw()->length; ++i)
    terms += !fmpz_is_zero(f.raw()->coeffs + i);
  const auto bits =
      static_cast<double>(std::abs(_fmpz_vec_max_bits(f.raw()->coeffs, f.raw()->length)));
  double growth = terms <= 1 && bits <= 1 ? 0 : bits + std::log2(static_cast<double>(terms));
  if (!fmpz_is_one(f.raw()->den)) growth += static_cast<double>(fmpz_bits(f.raw()->den));
  const fmpz_poly_struct* m = f.field()->minpoly();
  if (m->length > 2)
    growth += static_cast<double>(std::abs(_fmpz_vec_max_bits(m->coeffs, m->length)));
  return growth;
}

double length(const Poly& f) { return static_cast<double>(std::max(1L, f.raw()->length)); }

// c*z^k
struct TermInZ {
  NfElem c;
  long k = 0;
};

bool is_variable(const Expression& e, const Reading& reading) {
  return e.kind() == Kind::name && e.name() == reading.variable && !reading.variable.empty();
}

// c*z^k without an expansion; nothing for other shapes.
std::optional<TermInZ> monomial(const Expression& e, const Reading& reading) {
  const Field& field = reading.constants->field();
  switch (e.kind()) {
  case Kind::number:
    return TermInZ{NfElem(Rational(e.number()), field), 0};
  case Kind::name:
    if (is_variable(e, reading)) return TermInZ{NfElem(Rational(1), field), 1};
    if (const auto c = reading.constants->value(e)) return TermInZ{coerce(*c, field), 0};
    return std::nullopt;
  case Kind::negate:
    if (auto m = monomial(e.operand(0), reading)) return TermInZ{-m->c, m->k};
    return std::nullopt;
  case Kind::power: {
    const Expression& n = e.operand(1);
    if (!is_variable(e.operand(0), reading) || n.kind() != Kind::number || !fits_long(n.number()))
      return std::nullopt;
    const long k = to_long(n.number());
    reading.budget.check_degree(k);
    return TermInZ{NfElem(Rational(1), field), k};
  }
  case Kind::product: {
    TermInZ result{NfElem(Rational(1), field), 0};
    for (const Expression& factor : e.operands()) {
      const auto m = monomial(factor, reading);
      if (!m) return std::nullopt;
      result = {result.c * m->c, result.k + m->k};
      reading.budget.check_degree(result.k);
    }
    return result;
  }
  case Kind::quotient: {
    const auto a = monomial(e.operand(0), reading);
    const auto b = monomial(e.operand(1), reading);
    if (!a || !b || b->k != 0 || is_zero(b->c)) return std::nullopt;
    return TermInZ{a->c / b->c, a->k};
  }
  default:
    return std::nullopt;
  }
}

// Why a call is no rational function.
InputError no_rational_function(const Expression& e, const Reading& reading) {
  static const std::vector<std::string> roots{"sqrt", "root"};
  static const std::vector<std::string> others{"sin",  "cos",  "tan", "exp", "log", "ln",
                                               "sinh", "cosh", "sn",  "cn",  "dn",  "wp"};
  const std::string& f = e.name();
  if (f == reading.variable || reading.constants->is_defined(f))
    return e.error("'" + f + "' is not a function", "products are written out: " + f + "*(...)");
  if (is_among(f, others))
    return e.error("'" + f + "' is not a rational function",
                   "change the variable so that the coefficients become rational");
  if (f == "diff") return e.error("a derivative does not belong here");
  const auto near = nearest(f, roots);
  return e.error("unknown function '" + f + "'",
                 near ? "did you mean " + *near + "?" : "known functions are sqrt and root");
}

// ---- sizes

void check_product(const Poly& a, const Poly& b, const Budget& budget) {
  budget.check();
  budget.check_degree(std::max(0L, degree(a)) + std::max(0L, degree(b)));
  if ((length(a) + length(b)) * (coefficient_bits(a) + coefficient_bits(b)) > max_bits)
    throw OutOfBudget("size limit: the coefficients of a product would need more than " +
                      std::to_string(static_cast<long>(max_bits / 8 / 1048576)) + " MiB");
}

void check_power(const RationalFunction& base, const Integer& k, const Budget& budget) {
  if (!fits_long(k))
    throw OutOfBudget("size limit: the exponent " + shortened(k) + " is too large");
  const long d = std::max(degree(base.num()), degree(base.den()));
  const double size = std::abs(fmpz_get_d(k.raw()));
  if (d > 0 && static_cast<double>(d) * size > static_cast<double>(budget.max_degree))
    throw OutOfBudget("degree limit: a power of degree " + to_string(Integer(d) * k) +
                      " would be needed, the limit is " + std::to_string(budget.max_degree));
  const double terms = 1 + static_cast<double>(d) * size;
  for (const Poly* f : {&base.num(), &base.den()})
    if (terms * size * growth_bits(*f) > max_bits)
      throw OutOfBudget("size limit: a power with exponent " + to_string(k) +
                        " would have numbers that are too long");
}

bool is_unit_or_zero(const RationalFunction& f) {
  return is_zero(f) || f == RationalFunction(1) || f == RationalFunction(-1);
}

// Sums and products of many: of the two halves.
template <class Join>
RationalFunction halved(const std::vector<RationalFunction>& all, std::size_t from, std::size_t to,
                        const Join& join) {
  if (to - from == 1) return all[from];
  const std::size_t middle = from + (to - from) / 2;
  const RationalFunction a = halved(all, from, middle, join);
  return join(a, halved(all, middle, to, join));
}

class RationalEvaluator {
public:
  explicit RationalEvaluator(const Reading& reading) : reading_(reading) {}

  RationalFunction operator()(const Expression& e) const {
    switch (e.kind()) {
    case Kind::number:
      return constant(NfElem(Rational(e.number())));
    case Kind::decimal:
      throw e.error("a decimal number is not exact");
    case Kind::name:
      return name(e);
    case Kind::sum:
      return sum(e);
    case Kind::negate:
      return -(*this)(e.operand(0));
    case Kind::product:
      return product(e);
    case Kind::quotient:
      return quotient(e);
    case Kind::power:
      return power(e);
    case Kind::call:
      return call(e);
    case Kind::derivative:
      throw e.error("a derivative does not belong here");
    case Kind::equation:
      throw e.error("an equation does not belong here", "write only the expression");
    }
    throw InternalError("unknown kind of expression");
  }

private:
  [[nodiscard]] const Field& field() const { return reading_.constants->field(); }
  [[nodiscard]] RationalFunction constant(const NfElem& c) const {
    return RationalFunction(Poly(coerce(c, field())));
  }
  RationalFunction name(const Expression& e) const {
    if (is_variable(e, reading_)) return RationalFunction(coerce(Poly::z(), field()));
    if (const auto c = reading_.constants->value(e)) return constant(*c);
    throw unknown_name(e, reading_);
  }

  RationalFunction call(const Expression& e) const {
    if (const auto c = reading_.constants->value(e)) return constant(*c);
    throw no_rational_function(e, reading_);
  }

  // --- sums ---------------------------------------------------------------------------------

  RationalFunction sum(const Expression& e) const {
    std::vector<NfElem> coefficients;
    std::vector<RationalFunction> others;
    PartialFractions fractions(field(), reading_.budget);
    for (const Expression& term : e.operands()) {
      reading_.budget.check();
      const auto m = monomial(term, reading_);
      if (!m) {
        SplitFraction fraction{NfElem(Rational(1), field()), {}};
        if (split(term, 1, fraction))
          fractions.add(std::move(fraction));
        else
          others.push_back((*this)(term));
        continue;
      }
      const auto k = static_cast<std::size_t>(m->k);
      if (coefficients.size() <= k) coefficients.resize(k + 1, NfElem(field()));
      coefficients[k] += m->c;
    }
    if (!coefficients.empty())
      others.emplace_back(coerce(Poly::from_coefficients(coefficients), field()));
    if (!fractions.empty()) others.push_back(fractions.sum());
    return halved(others, 0, others.size(), [&](const auto& a, const auto& b) {
      check_product(a.num(), b.den(), reading_.budget);
      check_product(b.num(), a.den(), reading_.budget);
      check_product(a.den(), b.den(), reading_.budget);
      return a + b;
    });
  }

  // Multiplies `out` by e^n if e is written as a product of powers of constants and linear
  // polynomials.  Nothing is expanded.
  bool split(const Expression& e, long n, SplitFraction& out) const {
    switch (e.kind()) {
    case Kind::negate:
      if (n % 2 != 0) out.unit = -out.unit;
      return split(e.operand(0), n, out);
    case Kind::product:
      return std::ranges::all_of(e.operands(),
                                 [&](const Expression& factor) { return split(factor, n, out); });
    case Kind::quotient:
      return split(e.operand(0), n, out) && split(e.operand(1), -n, out);
    case Kind::power: {
      const Expression& k = e.operand(1);
      return k.kind() == Kind::number && k.number() <= Integer(largest_split_power) &&
             split(e.operand(0), n * to_long(k.number()), out);
    }
    default:
      return split_linear(e, n, out);
    }
  }

  bool split_linear(const Expression& e, long n, SplitFraction& out) const {
    if (std::abs(n) > largest_split_power) return false;
    NfElem constant(field());
    NfElem slope(field());
    const auto take = [&](const Expression& term) {
      const auto m = monomial(term, reading_);
      if (!m || m->k > 1) return false;
      (m->k == 0 ? constant : slope) += m->c;
      return true;
    };
    const bool linear = e.kind() == Kind::sum ? std::ranges::all_of(e.operands(), take) : take(e);
    if (!linear) return false;
    const NfElem& lead = is_zero(slope) ? constant : slope;
    if (is_zero(lead)) return false;
    const auto size = static_cast<unsigned long>(std::abs(n));
    out.unit = n > 0 ? out.unit * pow(lead, size) : out.unit / pow(lead, size);
    if (!is_zero(slope)) out.times(Poly::from_coefficients({constant / slope, NfElem(1)}), n);
    return true;
  }

  // --- products -----------------------------------------------------------------------------

  RationalFunction product(const Expression& e) const {
    if (const auto m = monomial(e, reading_))
      return RationalFunction(coerce(Poly::monomial(m->c, m->k), field()));
    std::vector<RationalFunction> factors;
    for (const Expression& factor : e.operands())
      factors.push_back((*this)(factor));
    return halved(factors, 0, factors.size(), [&](const auto& a, const auto& b) {
      check_product(a.num(), b.num(), reading_.budget);
      check_product(a.den(), b.den(), reading_.budget);
      return a * b;
    });
  }

  RationalFunction quotient(const Expression& e) const {
    const RationalFunction a = (*this)(e.operand(0));
    const RationalFunction b = (*this)(e.operand(1));
    if (is_zero(b)) throw e.operand(1).error("division by zero");
    check_product(a.num(), b.den(), reading_.budget);
    check_product(a.den(), b.num(), reading_.budget);
    return a / b;
  }

  RationalFunction power(const Expression& e) const {
    if (const auto c = reading_.constants->value(e)) return constant(*c); // c^(p/q)
    if (const auto m = monomial(e, reading_))
      return RationalFunction(coerce(Poly::monomial(m->c, m->k), field()));
    const Expression& exponent = e.operand(1);
    const RationalFunction n = (*this)(exponent);
    const bool constant_exponent = degree(n.num()) <= 0 && degree(n.den()) == 0;
    if (!constant_exponent || !is_rational(n.num().coeff(0)) ||
        !is_integer(to_rational(n.num().coeff(0))))
      throw exponent.error("the exponent is not an integer",
                           "only rational functions can be solved; roots of constants are written "
                           "sqrt(c) or root(p, approx)");
    const Integer k = to_rational(n.num().coeff(0)).num();
    const RationalFunction base = (*this)(e.operand(0));
    if (is_zero(base) && sign(k) < 0) throw e.error("division by zero");
    if (is_zero(base) && is_zero(k)) throw e.error("0^0 has no value");
    if (is_zero(k)) return constant(NfElem(1));
    if (is_unit_or_zero(base)) return fmpz_is_even(k.raw()) ? base * base : base;
    check_power(base, k, reading_.budget);
    return pow(base, to_long(k));
  }

  const Reading& reading_;
};

} // namespace

RationalFunction rational_function(const Expression& e, const Reading& reading) {
  return coerce(RationalEvaluator(reading)(e), reading.constants->field());
}

std::vector<Rational> rational_polynomial(const Expression& e, const std::string& variable) {
  const Constants none;
  const RationalFunction f =
      rational_function(e, {.variable = variable, .constants = &none, .budget = {}});
  if (degree(f.den()) > 0)
    throw e.error("this is not a polynomial" + (variable.empty() ? "" : " in " + variable));
  std::vector<Rational> c;
  for (long i = 0; i <= degree(f.num()); ++i)
    c.push_back(to_rational(f.num().coeff(i)));
  return c;
}

InputError unknown_name(const Expression& at, const Reading& reading) {
  return unknown_name(at, reading.constants->defined_names(), reading.variable);
}

InputError unknown_name(const Expression& at, std::vector<std::string> known,
                        const std::string& variable) {
  const std::string& name = at.name();
  if (name == "Pi" || name == "pi" || name == "E" || name == "e")
    return at.error("unknown name '" + name + "'",
                    "constants are algebraic numbers: rationals, I, sqrt(c), root(p(x), approx)");
  if (name == "i" || name == "j")
    return at.error("unknown name '" + name + "'", "the imaginary unit is I");
  if (!variable.empty()) known.push_back(variable);
  std::string hint =
      variable.empty() ? "a constant is expected here" : "the variable is " + variable;
  if (const auto near = nearest(name, known)) hint += "; did you mean " + *near + "?";
  if (!variable.empty())
    hint += "; another name is a parameter (--parameter " + name +
            ": decided for all values), has a value (--set) or a minimal polynomial (--minpoly)";
  return at.error("unknown name '" + name + "'", hint);
}

} // namespace kov
