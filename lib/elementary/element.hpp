#pragma once
// Elementary functions of one variable as values: sums of
//
//   rational function * q^c * exp(g) * cos(h) or sin(h) * log(u)^n, atan(u)^n, (1/u)^n, int(u)^n
//
// over Q(parameters, square roots of constants); products of sines and cosines are sums of them at once, so that
// sin^2 + cos^2 is 1.  What is equal may be written in two ways (1/u beside u): equality is decided by nobody here;
// check.hpp compares at points.

#include "exact/error.hpp"
#include "exact/multivariate.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kov::elementary {

/// The variable, the parameters, and letters for square roots of constants, which are taken as they are needed.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{"a"});
/// Example letters->text(letters->root(MFraction(letters->ring(), Rational(8))))  // -> 2*sqrt(2)
class Letters {
public:
  /// pi: which of the parameters is the number, or "".
  Letters(const std::string& variable, const std::vector<std::string>& parameters,
          const std::string& pi = {});

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const std::string& variable() const noexcept { return ring_->name(x); }
  static constexpr std::size_t x = 0;    ///< the variable
  static constexpr std::size_t sine = 1; ///< two letters for a while
  static constexpr std::size_t cosine = 2;
  static constexpr std::size_t first_root = 3; ///< then max_roots, then the parameters
  static constexpr std::size_t max_roots = 6;
  static constexpr std::size_t first_parameter = first_root + max_roots;

  [[nodiscard]] MFraction number(const Rational& c) const { return {ring_, c}; }
  [[nodiscard]] MFraction variable_value() const { return MFraction::variable(ring_, x); }
  /// A square root of what is free of x.  Throws NotElementary where there are too many.
  [[nodiscard]] MFraction root(const MFraction& radicand);
  [[nodiscard]] std::optional<std::size_t> pi() const noexcept { return pi_; }
  /// The radicands of the letters that are taken.
  [[nodiscard]] const std::vector<MFraction>& radicands() const noexcept { return radicands_; }
  /// Without squares of root letters, and without them in the denominator.
  [[nodiscard]] MFraction reduced(MFraction f) const;
  [[nodiscard]] std::string text(const MFraction& f) const;
  /// Factored where that is how a coefficient is read.
  [[nodiscard]] std::string text(const MPoly& f) const;

private:
  Ring ring_;
  Ring printed_; ///< the same names in the order in which they are read
  std::vector<MFraction> radicands_;
  std::optional<std::size_t> pi_;
};
using LettersPtr = std::shared_ptr<Letters>;

/// A function that does not fit in this form, or has no value.
class NotElementary : public Error {
  using Error::Error;
};

struct Monomial;
using MonomialPtr = std::shared_ptr<const Monomial>;

class Element {
public:
  Element() = default; ///< zero, which goes with all letters
  explicit Element(LettersPtr letters) : letters_(std::move(letters)) {}
  Element(LettersPtr letters, const MFraction& f);
  Element(LettersPtr letters, const Rational& c);

  struct Term {
    MonomialPtr monomial;
    MFraction coefficient;
  };
  [[nodiscard]] const std::map<std::string, Term>& terms() const noexcept { return terms_; }
  [[nodiscard]] const LettersPtr& letters() const noexcept { return letters_; }
  /// The rational function that it is, if it is one.
  [[nodiscard]] std::optional<MFraction> rational() const;
  [[nodiscard]] Element number(long n) const { return {letters_, Rational(n)}; }

  friend Element operator+(Element a, const Element& b);
  friend Element operator-(Element a, const Element& b);
  friend Element operator*(const Element& a, const Element& b);
  friend Element operator/(const Element& a, const Element& b); ///< Throws NotElementary for 0.
  friend Element operator-(Element a);
  friend Element operator*(const MFraction& c, Element a);
  Element& operator+=(const Element& b) { return *this = *this + b; }
  Element& operator-=(const Element& b) { return *this = *this - b; }
  Element& operator*=(const Element& b) { return *this = *this * b; }

  /// One more term.
  void add(const Monomial& m, const MFraction& c);

private:
  LettersPtr letters_;
  std::map<std::string, Term> terms_; ///< by the text of the monomial
};

struct Kernel {
  enum class Name : std::uint8_t { log, atan, inverse, integral };
  Name name = Name::log;
  Element argument;
};

struct Monomial {
  struct Power {
    MPoly base; ///< irreducible, not a number where it can be helped
    MFraction exponent;
  };
  struct KernelPower {
    std::shared_ptr<const Kernel> kernel;
    std::string text;
    long power = 1;
  };
  enum class Trig : std::uint8_t { none, cos, sin };

  std::vector<Power> powers;
  Element exponent; ///< 0: no exponential
  Trig trig = Trig::none;
  Element angle;
  std::vector<KernelPower> kernels; ///< by their texts
};

[[nodiscard]] bool is_zero(const Element& f);
/// Does x occur?
[[nodiscard]] bool is_constant(const Element& f);
/// a/b, where that is a rational number.  Requires both not 0.
[[nodiscard]] std::optional<Rational> ratio(const Element& a, const Element& b);
[[nodiscard]] Element pow(const Element& f, long n);
[[nodiscard]] Element derivative(const Element& f);
/// A sum of rational functions and logarithms with constant factors becomes powers.
[[nodiscard]] Element exp(const Element& f);
[[nodiscard]] Element cos(const Element& f);
[[nodiscard]] Element sin(const Element& f);
/// The logarithm of a product is a sum of logarithms, real where x and the bases are positive.
[[nodiscard]] Element log(const Element& f);
[[nodiscard]] Element atan(const Element& f);
/// int(f, x), which stays as it is.
[[nodiscard]] Element unevaluated_integral(const Element& f);
/// q^c for each factor.  Throws NotElementary unless f is one product and c is a constant.
[[nodiscard]] Element power(const Element& f, const MFraction& c);
/// f(g(x)); for a constant g each integral starts there.
[[nodiscard]] Element compose(const Element& f, const Element& g);
/// The terms over one denominator in sines and cosines of one angle, in lowest terms.
[[nodiscard]] Element simplified(const Element& f);

/// In our grammar.  hyperbolic: exp(g) + exp(-g) is 2 cosh(g).
[[nodiscard]] std::string text(const Element& f, bool hyperbolic = false);
/// a + 1, ...: irreducible polynomials in the parameters, 0 where a coefficient has no value.
[[nodiscard]] std::vector<std::string> excluded(const Element& f);

} // namespace kov::elementary
