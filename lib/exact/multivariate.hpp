#pragma once
// Z[x1, ..., xn] and Q(x1, ..., xn): the exact values of the mechanics wing.
//
// All variables of one problem (coordinates, parameters, function symbols, the new independent
// variable) live in one Variables object, in a fixed order that the text output follows; two values
// may be combined when they share that object.  A default-constructed value is a zero without
// variables and may be combined with everything.

#include "exact/integer.hpp"
#include "exact/multivariate_c.h"
#include "exact/rational_function.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kov {

/// The names of the variables, in their fixed order, with FLINT's context (lexicographic order).
class Variables {
public:
  /// Throws InvalidArgument for an empty or repeated name.
  explicit Variables(std::vector<std::string> names);
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;
  ~Variables();

  [[nodiscard]] std::size_t size() const noexcept { return names_.size(); }
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_.at(i); }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// Throws InvalidArgument for an unknown name.
  [[nodiscard]] std::size_t index(std::string_view name) const;
  [[nodiscard]] const fmpz_mpoly_ctx_struct* ctx() const noexcept { return ctx_; }

private:
  std::vector<std::string> names_;
  fmpz_mpoly_ctx_t ctx_;
};

using Ring = std::shared_ptr<const Variables>;
/// The ring of these variables.  Throws InvalidArgument for an empty or repeated name.
[[nodiscard]] Ring make_ring(std::vector<std::string> names);

/// A polynomial with integer coefficients.
class MPoly {
public:
  MPoly() = default; ///< zero, without variables
  explicit MPoly(Ring ring);
  MPoly(Ring ring, const Integer& c);
  MPoly(const MPoly& o);
  MPoly(MPoly&& o) noexcept;
  MPoly& operator=(MPoly o) noexcept;
  ~MPoly();

  [[nodiscard]] static MPoly variable(const Ring& ring, std::size_t i);
  [[nodiscard]] static MPoly variable(const Ring& ring, std::string_view name);
  /// c x^e, exponents by index.
  [[nodiscard]] static MPoly term(const Ring& ring, const Integer& c,
                                  const std::vector<unsigned long>& exponents);

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] const fmpz_mpoly_struct* raw() const noexcept { return v_; }
  [[nodiscard]] fmpz_mpoly_struct* raw() noexcept { return v_; }
  [[nodiscard]] const fmpz_mpoly_ctx_struct* ctx() const noexcept { return ring_->ctx(); }

  [[nodiscard]] long length() const noexcept; ///< number of terms
  [[nodiscard]] Integer coefficient(long i) const;
  [[nodiscard]] std::vector<unsigned long> exponents(long i) const;

  friend MPoly operator+(const MPoly& a, const MPoly& b);
  friend MPoly operator-(const MPoly& a, const MPoly& b);
  friend MPoly operator*(const MPoly& a, const MPoly& b);
  friend MPoly operator-(const MPoly& a);
  MPoly& operator+=(const MPoly& b) { return *this = *this + b; }
  MPoly& operator-=(const MPoly& b) { return *this = *this - b; }
  MPoly& operator*=(const MPoly& b) { return *this = *this * b; }
  friend bool operator==(const MPoly& a, const MPoly& b);

private:
  Ring ring_; ///< null for the zero without variables; v_ is then not initialised
  fmpz_mpoly_t v_ = {};
};

[[nodiscard]] bool is_zero(const MPoly& f);
[[nodiscard]] bool is_one(const MPoly& f);
[[nodiscard]] bool is_constant(const MPoly& f);
[[nodiscard]] MPoly pow(const MPoly& f, unsigned long e);
[[nodiscard]] MPoly derivative(const MPoly& f, std::size_t i);
[[nodiscard]] long degree(const MPoly& f, std::size_t i); ///< in x_i; -1 for 0
[[nodiscard]] bool uses(const MPoly& f, std::size_t i);
[[nodiscard]] std::vector<std::size_t> used_variables(const MPoly& f);
[[nodiscard]] MPoly gcd(const MPoly& a, const MPoly& b); ///< positive leading coefficient
[[nodiscard]] MPoly exact_div(const MPoly& a,
                              const MPoly& b); ///< the remainder must be 0 (checked)
[[nodiscard]] std::optional<MPoly> divides(const MPoly& b, const MPoly& a); ///< a/b, if it exists
/// Coefficients of f in x_i, ascending; empty for 0.
[[nodiscard]] std::vector<MPoly> coefficients(const MPoly& f, std::size_t i);
/// With respect to x_i; free of it.  Throws DomainError for exponents beyond a machine word.
[[nodiscard]] MPoly resultant(const MPoly& a, const MPoly& b, std::size_t i);
[[nodiscard]] MPoly discriminant(const MPoly& f, std::size_t i);

/// base^exponent.
struct MFactor {
  MPoly base; ///< primitive, positive leading coefficient
  long exponent = 1;
};
/// f = content * prod base^exponent with irreducible bases over Q, in a fixed order.
/// Requires f != 0.
/// Given   const Ring ring = make_ring({"x", "y"});
/// Given   const MPoly x = MPoly::variable(ring, "x"), y = MPoly::variable(ring, "y");
/// Example factor(x*x*y - pow(y, 3))  // -> {1, {{y, 1}, {x - y, 1}, {x + y, 1}}}
[[nodiscard]] std::pair<Integer, std::vector<MFactor>> factor(const MPoly& f);
/// Descending lexicographic order of terms; the expression parser reads it back.
[[nodiscard]] std::string to_string(const MPoly& f);
/// A total order without meaning, the same in every run.
[[nodiscard]] int compare(const MPoly& a, const MPoly& b);

/// A rational function num/den over Q: coprime, integer content removed, leading coefficient of den
/// positive; a canonical form, so that == decides equality.
/// Example MFraction(x*x - y*y, x - y)  // -> x + y
class MFraction {
public:
  MFraction() = default; ///< zero, without variables
  explicit MFraction(Ring ring);
  MFraction(Ring ring, const Rational& c);
  MFraction(const MPoly& num);                   // NOLINT: a polynomial is a rational function
  MFraction(const MPoly& num, const MPoly& den); ///< Throws DomainError for den = 0.
  MFraction(const MFraction& o);
  MFraction(MFraction&& o) noexcept;
  MFraction& operator=(MFraction o) noexcept;
  ~MFraction();

  [[nodiscard]] static MFraction variable(const Ring& ring, std::size_t i);
  [[nodiscard]] static MFraction variable(const Ring& ring, std::string_view name);

  [[nodiscard]] const Ring& ring() const noexcept { return ring_; }
  [[nodiscard]] MPoly num() const;
  [[nodiscard]] MPoly den() const; ///< Requires a ring.
  [[nodiscard]] const kov_mpoly_q* raw() const noexcept { return &v_; }

  friend MFraction operator+(const MFraction& a, const MFraction& b);
  friend MFraction operator-(const MFraction& a, const MFraction& b);
  friend MFraction operator*(const MFraction& a, const MFraction& b);
  friend MFraction operator/(const MFraction& a, const MFraction& b); ///< Throws DomainError for 0.
  friend MFraction operator-(const MFraction& a);
  friend MFraction operator*(const Rational& c, const MFraction& a);
  MFraction& operator+=(const MFraction& b) { return *this = *this + b; }
  MFraction& operator-=(const MFraction& b) { return *this = *this - b; }
  MFraction& operator*=(const MFraction& b) { return *this = *this * b; }
  friend bool operator==(const MFraction& a, const MFraction& b);

private:
  friend class MFractionAccess;
  Ring ring_;
  kov_mpoly_q v_ = {};
};

[[nodiscard]] bool is_zero(const MFraction& f);
[[nodiscard]] bool is_one(const MFraction& f);
[[nodiscard]] bool is_constant(const MFraction& f);
[[nodiscard]] Rational to_rational(const MFraction& f);  ///< Requires is_constant(f).
[[nodiscard]] MFraction pow(const MFraction& f, long e); ///< Throws DomainError for 0 and e < 0.
[[nodiscard]] MFraction derivative(const MFraction& f, std::size_t i);
[[nodiscard]] bool uses(const MFraction& f, std::size_t i);
[[nodiscard]] std::vector<std::size_t> used_variables(const MFraction& f);

using Substitution = std::map<std::size_t, MFraction>;
/// f with x_i replaced by values[i], all at the same time.  Throws DomainError when the denominator
/// becomes 0.  Cost: polynomial arithmetic with one gcd at the end.
/// Example substitute(MFraction(x, y), {{0, MFraction(y)}, {1, MFraction(x)}})  // -> y/x
[[nodiscard]] MFraction substitute(const MFraction& f, const Substitution& values);
[[nodiscard]] MFraction substitute(const MPoly& f, const Substitution& values);

/// The same function in another ring that has all variables that f uses (matched by name).
[[nodiscard]] MFraction transfer(const MFraction& f, const Ring& ring);

/// Text that the expression parser reads back.
[[nodiscard]] std::string to_string(const MFraction& f);
/// The same by falling powers of one variable: ((2*a^2 - 1)*z^4 + a*z^3)/z^2.
[[nodiscard]] std::string to_string_by_powers(const MFraction& f, std::size_t variable);

/// The same function with numerator and denominator factored over Q; parses back as well.
[[nodiscard]] std::string to_factored_string(const MFraction& f);
/// The text, cut in the middle of nowhere when it is long, with the number of terms: for messages.
[[nodiscard]] std::string brief(const MFraction& f, std::size_t length = 300);

/// A constant a with its field Q(a), for conversions out of the multivariate world.
struct AlgebraicConstant {
  std::size_t variable;
  Field field; ///< the generator is the constant
};
/// f as an element of K(z), z = x_i, K = Q or Q(a).  Requires that f uses no other variables;
/// otherwise InvalidArgument, naming one.
/// Example to_rational_function(MFraction(x, y), 0)  // -> throws InvalidArgument
[[nodiscard]] RationalFunction to_rational_function(const MFraction& f, std::size_t i,
                                                    const std::optional<AlgebraicConstant>& a = {});
/// The way back, for K = Q.
[[nodiscard]] MFraction from_rational_function(const RationalFunction& f, const Ring& ring,
                                               std::size_t i);

} // namespace kov
