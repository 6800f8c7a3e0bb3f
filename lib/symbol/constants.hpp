#pragma once
// The irrational constants of one input, and the one number field that holds them all.
//
//   I     sqrt(c)     root(p(x), approx)     c^(p/q)     a name with a minimal polynomial
//
// nested and combined at will.  The field K = Q(theta) grows by one constant alpha at a time: the
// minimal polynomial g of alpha over K is the factor (over K) that vanishes at alpha; if its degree
// is 1 then alpha lies in K already, else theta' = k theta + l alpha generates K(alpha) once its
// degree is [K:Q] deg g, and alpha is the only common root of two polynomials over Q(theta').  So
// equality of constants, e.g. sqrt(2)*sqrt(3) = sqrt(6), is decided by arithmetic in K.
//
// Which root is meant is decided with certified enclosures (QQbar); sqrt is the principal branch.

#include "exact/algebraic.hpp"
#include "exact/poly.hpp"
#include "symbol/expression.hpp"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace kov {

/// Given   const std::vector<Expression> input{
///             parse_expression("sqrt(2)*sqrt(3) - sqrt(6)", "-r")};
/// Given   Constants constants; constants.gather(input);
/// Example constants.field()->degree()  // -> 4
/// Example rational_function(input.front(), {"z", &constants, {}})  // -> 0
class Constants {
public:
  explicit Constants(long max_degree = 24) : max_degree_(max_degree) {}

  /// The name stands for a root of the polynomial, whose variable is the name itself; of the real
  /// roots the largest is meant, or the first in a fixed order if none is real.
  /// Errors  InputError if the polynomial is not a rational one in `name`, or is reducible
  void define_root(const std::string& name, const Expression& minpoly);
  /// The name stands for a constant expression (in names defined before).
  void define_value(const std::string& name, const Expression& value);
  /// The input uses this name for something else: no generator is called so.
  void reserve(const std::string& name) { taken_.insert(name); }
  /// Adjoins every irrational constant of the expressions.  Call it with all that belong to one
  /// input: generators get a name that none of them uses.
  /// Errors  InputError for a root of something that is not constant, a root() that says not which,
  ///         a field degree above the limit
  void gather(std::span<const Expression> all);

  [[nodiscard]] const Field& field() const noexcept { return field_; }
  /// The value of I, sqrt(c), root(p, approx), c^(p/q) or of a defined name; nothing for others.
  [[nodiscard]] std::optional<NfElem> value(const Expression& e) const;
  [[nodiscard]] bool is_defined(const std::string& name) const { return values_.contains(name); }
  [[nodiscard]] std::vector<std::string> defined_names() const;
  /// The definition of the generator that appears in results: "root(x^3 - 2, 1.26)"; "" over Q.
  [[nodiscard]] std::string definition() const;

private:
  void gather(const Expression& e);
  void gather_call(const Expression& e);
  void require_constant(const Expression& root, const Expression& argument) const;
  NfElem constant(const Expression& e) const;
  QQbar to_qqbar(const NfElem& x) const;
  NfElem nth_root(const NfElem& c, unsigned long n, const Expression& at);
  QQbar chosen_root(const Expression& e) const;
  NfElem adjoin(const QQbar& alpha, const Poly& f, const std::string& label, bool keep_label,
                const Expression& at);
  NfElem first_generator(const QQbar& alpha, const std::string& label, bool keep_label);
  NfElem extend(const QQbar& alpha, const Poly& g, const std::string& label);
  void move_to(const Field& k, const NfElem& theta);
  std::string fresh_name() const;

  long max_degree_;
  Field field_ = rationals();
  QQbar theta_;
  std::map<std::string, NfElem> values_; ///< by name, or by source text without spaces
  std::set<std::string> taken_;          ///< names that the input uses
};

/// "root(x^2 - 2, 1.414213562)" for the letter of k under its embedding; "" for Q.
[[nodiscard]] std::string generator_definition(const NumberField& k);

} // namespace kov
