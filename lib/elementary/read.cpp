#include "elementary/read.hpp"

#include "symbol/constants.hpp"
#include "symbol/formula.hpp"
#include "symbol/known_functions.hpp"
#include "symbol/linear_reader.hpp"

#include <algorithm>

namespace kov::elementary {
namespace {

using Kind = Expression::Kind;

class Reader {
public:
  explicit Reader(LettersPtr letters) : letters_(std::move(letters)) {}

  [[nodiscard]] Element operator()(const Expression& e) const {
    const auto operand = [&](std::size_t i) { return (*this)(e.operand(i)); };
    switch (e.kind()) {
    case Kind::number:
      return number(Rational(e.number()));
    case Kind::name:
      if (e.name() == "I") return {letters_, letters_->root(letters_->number(-1))};
      if (letters_->ring()->find(e.name()))
        return {letters_, MFraction::variable(letters_->ring(), e.name())};
      throw NotElementary("the name " + e.name());
    case Kind::sum: {
      Element sum(letters_);
      for (std::size_t i = 0; i < e.operands().size(); ++i)
        sum += operand(i);
      return sum;
    }
    case Kind::negate:
      return -operand(0);
    case Kind::product: {
      Element product = number(1);
      for (std::size_t i = 0; i < e.operands().size(); ++i)
        product *= operand(i);
      return product;
    }
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::power: {
      const auto exponent = operand(1).rational();
      if (!exponent || uses(*exponent, Letters::x))
        throw NotElementary("a power of x in an exponent");
      return power(operand(0), *exponent);
    }
    case Kind::call:
      if (e.operands().size() == 1) return call(e, operand(0));
      if (e.name() == "int" && e.operands().size() == 2 && e.operand(1).kind() == Kind::name &&
          e.operand(1).name() == letters_->variable())
        return unevaluated_integral(operand(0));
      [[fallthrough]];
    default:
      throw NotElementary("the formula " + std::string(e.text()));
    }
  }

private:
  [[nodiscard]] Element number(const Rational& c) const { return {letters_, c}; }

  [[nodiscard]] Element call(const Expression& e, const Element& u) const {
    const std::string& f = e.name();
    if (f == "sqrt") return power(u, letters_->number(Rational(1, 2)));
    if (f == "exp") return exp(u);
    if (f == "log") return log(u);
    if (f == "sin") return sin(u);
    if (f == "cos") return cos(u);
    if (f == "atan") return atan(u);
    if (f == "cosh") return (exp(u) + exp(-u)) / number(2);
    if (f == "sinh") return (exp(u) - exp(-u)) / number(2);
    if (const KnownFunction* known = known_function(f, 1); known != nullptr && known->means)
      return (*this)(trees::rebuilt(*known->means, {{"x", e.operand(0)}}));
    throw NotElementary("the function " + f);
  }

  LettersPtr letters_;
};

class Coefficients : public FieldOfCoefficients<Element> {
public:
  explicit Coefficients(LettersPtr letters) : letters_(std::move(letters)) {}
  [[nodiscard]] Element constant(long n) const override { return {letters_, Rational(n)}; }
  [[nodiscard]] Element value(const Expression& e) const override { return element(e, letters_); }
  [[nodiscard]] Element derivative(const Element& f) const override {
    return elementary::derivative(f);
  }
  [[nodiscard]] std::string text(const Element& f) const override { return elementary::text(f); }

private:
  LettersPtr letters_;
};

} // namespace

Element element(const Expression& e, const LettersPtr& letters) { return Reader(letters)(e); }

LinearEquation linear_equation(const Expression& equation, const std::string& unknown,
                               const LettersPtr& letters) {
  const Coefficients in(letters);
  LinearFormOver<Element> form =
      LinearReader<Element>(unknown, letters->variable(), in).form(equation);
  if (form.c.size() < 2 || form.c.size() > 3) throw NotElementary("another order than 1 or 2");
  form.c.resize(3, in.constant(0));
  return {form.c[0], form.c[1], form.c[2], -form.rest};
}

bool is_hyperbolic(const Expression& e) {
  static constexpr std::string_view names[] = {"cosh", "sinh", "tanh", "coth", "sech", "csch"};
  if (e.kind() == Kind::call && std::ranges::find(names, e.name()) != std::end(names)) return true;
  return std::ranges::any_of(e.operands(), is_hyperbolic);
}

} // namespace kov::elementary
