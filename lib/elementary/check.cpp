#include "elementary/check.hpp"

#include "symbol/constants.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/written.hpp"

#include <acb_poly.h>

#include <array>
#include <functional>
#include <optional>

namespace kov::elementary {
namespace {

constexpr slong bits = 300;
constexpr slong length = 8; // of power series: derivatives lose their last coefficients

/// A power series at a point.
class Series {
public:
  Series() { acb_poly_init(v_); }
  explicit Series(const acb_t c) : Series() { acb_poly_set_acb(v_, c); }
  explicit Series(const Rational& c) : Series() {
    acb_t value;
    acb_init(value);
    acb_set_fmpq(value, c.raw(), bits);
    acb_poly_set_acb(v_, value);
    acb_clear(value);
  }
  Series(const Series& o) : Series() { acb_poly_set(v_, o.v_); }
  Series(Series&& o) noexcept : Series() { acb_poly_swap(v_, o.v_); }
  Series& operator=(Series o) noexcept {
    acb_poly_swap(v_, o.v_);
    return *this;
  }
  ~Series() { acb_poly_clear(v_); }
  [[nodiscard]] const acb_poly_struct* raw() const { return v_; }
  [[nodiscard]] acb_poly_struct* raw() { return v_; }

  friend Series operator+(const Series& a, const Series& b) {
    Series c;
    acb_poly_add(c.v_, a.v_, b.v_, bits);
    return c;
  }
  friend Series operator-(const Series& a) {
    Series c;
    acb_poly_neg(c.v_, a.v_);
    return c;
  }
  friend Series operator*(const Series& a, const Series& b) {
    Series c;
    acb_poly_mullow(c.v_, a.v_, b.v_, length, bits);
    return c;
  }
  friend Series operator/(const Series& a, const Series& b) {
    Series c;
    acb_poly_div_series(c.v_, a.v_, b.v_, length, bits);
    return c;
  }
  using Function = void (*)(acb_poly_struct*, const acb_poly_struct*, slong, slong);
  [[nodiscard]] Series applied(Function f) const {
    Series c;
    f(c.v_, v_, length, bits);
    return c;
  }
  [[nodiscard]] Series derivative() const {
    Series c;
    acb_poly_derivative(c.v_, v_, bits);
    return c;
  }
  [[nodiscard]] ComplexBall constant() const {
    ComplexBall c;
    acb_poly_get_coeff_acb(c.raw(), v_, 0);
    return c;
  }

private:
  acb_poly_t v_;
};

Series exp(const Series& a) { return a.applied(acb_poly_exp_series); }
Series log(const Series& a) { return a.applied(acb_poly_log_series); }
Series sin(const Series& a) { return a.applied(acb_poly_sin_series); }
Series cos(const Series& a) { return a.applied(acb_poly_cos_series); }
Series atan(const Series& a) { return a.applied(acb_poly_atan_series); }

Series power(const Series& a, long n) {
  Series p{Rational(1)};
  for (long i = 0; i < std::abs(n); ++i)
    p = p * a;
  return n < 0 ? Series{Rational(1)} / p : p;
}

/// A value for each letter.
class Place {
public:
  Place(const LettersPtr& letters, long number) : letters_(letters) {
    const Ring& ring = letters->ring();
    for (std::size_t i = 0; i < ring->size(); ++i)
      values_.push_back(value_of(static_cast<long>(i), number));
    Series x = value_of(0, number);
    acb_t one;
    acb_init(one);
    acb_one(one);
    acb_poly_set_coeff_acb(x.raw(), 1, one);
    acb_clear(one);
    values_[Letters::x] = x;
    if (const auto pi = letters->pi()) {
      acb_t value;
      acb_init(value);
      acb_const_pi(value, bits);
      values_[*pi] = Series(value);
      acb_clear(value);
    }
    for (std::size_t i = 0; i < letters->radicands().size(); ++i)
      values_[Letters::first_root + i] = at(letters->radicands()[i]).applied(acb_poly_sqrt_series);
  }

  [[nodiscard]] const Series& letter(std::size_t i) const { return values_.at(i); }
  [[nodiscard]] std::optional<Series> named(const std::string& name) const {
    const auto i = letters_->ring()->find(name);
    return i ? std::optional(values_[*i]) : std::nullopt;
  }

  [[nodiscard]] Series at(const MPoly& p) const {
    Series sum;
    for (long i = 0; i < p.length(); ++i) {
      Series term{Rational(p.coefficient(i))};
      const auto e = p.exponents(i);
      for (std::size_t k = 0; k < e.size(); ++k)
        if (e[k] > 0) term = term * power(values_[k], static_cast<long>(e[k]));
      sum = sum + term;
    }
    return sum;
  }
  [[nodiscard]] Series at(const MFraction& f) const { return at(f.num()) / at(f.den()); }

  [[nodiscard]] Series at(const Element& f) const {
    Series sum;
    for (const auto& [key, t] : f.terms()) {
      const Monomial& m = *t.monomial;
      Series product = at(t.coefficient);
      for (const auto& [base, c] : m.powers)
        product = product * exp(at(c) * log(at(base)));
      if (!is_zero(m.exponent)) product = product * exp(at(m.exponent));
      if (m.trig == Monomial::Trig::cos) product = product * cos(at(m.angle));
      if (m.trig == Monomial::Trig::sin) product = product * sin(at(m.angle));
      for (const auto& k : m.kernels)
        product = product * power(at(*k.kernel, k.text), k.power);
      sum = sum + product;
    }
    return sum;
  }

private:
  // Some number with a small imaginary part, so that no real singular point is near.
  [[nodiscard]] static Series value_of(long letter, long number) {
    acb_t c;
    acb_init(c);
    const Rational re(37 + (letter * 29 + number * 43) % 71, 61);
    arb_set_fmpq(acb_realref(c), re.raw(), bits);
    if (letter == 0) {
      const Rational im(3 + number, 53);
      arb_set_fmpq(acb_imagref(c), im.raw(), bits);
    }
    Series s(c);
    acb_clear(c);
    return s;
  }

  [[nodiscard]] Series at(const Kernel& k, const std::string& name) const {
    const Series u = at(k.argument);
    switch (k.name) {
    case Kernel::Name::log:
      return log(u);
    case Kernel::Name::atan:
      return atan(u);
    case Kernel::Name::inverse:
      return Series{Rational(1)} / u;
    case Kernel::Name::integral: { // any constant of integration
      Series integral;
      acb_poly_integral(integral.raw(), u.raw(), bits);
      return integral +
             Series{Rational(static_cast<long>(std::hash<std::string>()(name) % 97), 31)};
    }
    }
    return u;
  }

  LettersPtr letters_;
  std::vector<Series> values_;
};

class NotKnown : public Error {
  using Error::Error;
};

/// An equation, term by term.
class EquationAt {
public:
  EquationAt(const Place& place, std::string unknown, const Series& y, std::string variable)
      : place_(place), unknown_(std::move(unknown)), y_(y), variable_(std::move(variable)) {}

  // Nothing: no value here.
  [[nodiscard]] std::optional<bool> holds(const Expression& equation) const {
    ComplexBall sum;
    Ball largest;
    for (const SignedTerm& t : terms_of(equation)) {
      const ComplexBall c = (*this)(t.term).constant();
      if (acb_is_finite(c.raw()) == 0) return std::nullopt;
      t.minus ? acb_sub(sum.raw(), sum.raw(), c.raw(), bits)
              : acb_add(sum.raw(), sum.raw(), c.raw(), bits);
      Ball size;
      acb_abs(size.raw(), c.raw(), bits);
      arb_max(largest.raw(), largest.raw(), size.raw(), bits);
    }
    return is_small(sum, largest);
  }

  static bool is_small(const ComplexBall& sum, const Ball& largest) {
    Ball size, bound;
    acb_abs(size.raw(), sum.raw(), bits);
    arb_set_si(bound.raw(), 10);
    arb_pow_ui(bound.raw(), bound.raw(), 25, bits);
    arb_mul(size.raw(), size.raw(), bound.raw(), bits);
    return arb_lt(size.raw(), largest.raw()) != 0 || acb_is_zero(sum.raw()) != 0;
  }

private:
  using Kind = Expression::Kind;

  [[nodiscard]] Series operator()(const Expression& e) const {
    const auto operand = [&](std::size_t i) { return (*this)(e.operand(i)); };
    switch (e.kind()) {
    case Kind::number:
      return Series{Rational(e.number())};
    case Kind::name:
      return name(e);
    case Kind::sum: {
      Series sum;
      for (std::size_t i = 0; i < e.operands().size(); ++i)
        sum = sum + operand(i);
      return sum;
    }
    case Kind::negate:
      return -operand(0);
    case Kind::product: {
      Series product{Rational(1)};
      for (std::size_t i = 0; i < e.operands().size(); ++i)
        product = product * operand(i);
      return product;
    }
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::power:
      if (const auto n = as_rational(e.operand(1)); n && is_integer(*n) && abs(*n) < Rational(1000))
        return power(operand(0), to_long(n->num()));
      return exp(operand(1) * log(operand(0)));
    case Kind::derivative:
      return differentiated(operand(0), e.order());
    case Kind::call:
      return call(e);
    default:
      throw NotKnown("");
    }
  }

  [[nodiscard]] Series name(const Expression& e) const {
    if (e.name() == unknown_) return y_;
    if (e.name() == "I") {
      acb_t i;
      acb_init(i);
      acb_onei(i);
      Series s(i);
      acb_clear(i);
      return s;
    }
    if (auto value = place_.named(e.name())) return *value;
    throw NotKnown(e.name());
  }

  static Series differentiated(Series s, long order) {
    for (; order > 0; --order)
      s = s.derivative();
    return s;
  }

  [[nodiscard]] Series call(const Expression& e) const {
    if (e.name() == unknown_) return y_;
    if (is_diff(e) && e.operands().size() <= 3) {
      const auto n = e.operands().size() == 3 ? as_rational(e.operand(2)) : Rational(1);
      if (!n || *n > Rational(4)) throw NotKnown("");
      return differentiated((*this)(e.operand(0)), to_long(n->num()));
    }
    if (e.operands().size() != 1) throw NotKnown("");
    const Series u = (*this)(e.operand(0)), one{Rational(1)}, half{Rational(1, 2)};
    const std::string& f = e.name();
    if (f == "exp") return exp(u);
    if (f == "log" || f == "ln") return log(u);
    if (f == "sqrt") return exp(half * log(u));
    if (f == "sin") return sin(u);
    if (f == "cos") return cos(u);
    if (f == "tan") return sin(u) / cos(u);
    if (f == "cot") return cos(u) / sin(u);
    if (f == "sec") return one / cos(u);
    if (f == "csc") return one / sin(u);
    const Series up = exp(u), down = exp(-u), sum = up + down, difference = up + -down;
    if (f == "cosh") return half * sum;
    if (f == "sinh") return half * difference;
    if (f == "tanh") return difference / sum;
    if (f == "coth") return sum / difference;
    if (f == "sech") return one / (half * sum);
    if (f == "csch") return one / (half * difference);
    if (f == "atan" || f == "arctan") return atan(u);
    throw NotKnown(f);
  }

  const Place& place_;
  std::string unknown_;
  const Series& y_;
  std::string variable_;
};

// Does it hold wherever there is a value?
template <class Holds> bool everywhere(const Holds& holds) {
  long values = 0;
  for (long number = 0; number < 6 && values < 3; ++number) {
    const std::optional<bool> here = holds(number);
    if (here == false) return false;
    values += here ? 1 : 0;
  }
  return values > 0;
}

} // namespace

namespace {

bool agree(const Element& f, const Element& g, bool differentiate) {
  return everywhere([&](long number) -> std::optional<bool> {
    const Place place(g.letters(), number);
    const Series y = place.at(f);
    const ComplexBall a = (differentiate ? y.derivative() : y).constant(),
                      b = place.at(g).constant();
    if (acb_is_finite(a.raw()) == 0 || acb_is_finite(b.raw()) == 0) return std::nullopt;
    ComplexBall difference;
    acb_sub(difference.raw(), a.raw(), b.raw(), bits);
    Ball size;
    acb_abs(size.raw(), b.raw(), bits);
    arb_add_si(size.raw(), size.raw(), 1, bits);
    return EquationAt::is_small(difference, size);
  });
}

} // namespace

bool is_derivative_at_points(const Element& f, const Element& g) { return agree(f, g, true); }
bool are_equal_at_points(const Element& f, const Element& g) { return agree(f, g, false); }

bool holds_at_points(const Expression& equation, const std::string& unknown, const Element& y) {
  try {
    return everywhere([&](long number) {
      const Place place(y.letters(), number);
      const Series value = place.at(y);
      return EquationAt(place, unknown, value, y.letters()->variable()).holds(equation);
    });
  } catch (const NotKnown&) {
    return false;
  }
}

} // namespace kov::elementary
