#pragma once
// A formula at a point, with the derivatives that an equation of the second order asks for: power series in h whose
// coefficients are balls.

#include "exact/ball.hpp"
#include "symbol/expression.hpp"

#include <acb_poly.h>

#include <climits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kov {

/// c0 + c1 h + ..., of which the first `known` coefficients are known.
class PowerSeries {
public:
  PowerSeries() { acb_poly_init(v_); }
  /// A constant.
  explicit PowerSeries(const ComplexBall& c) : PowerSeries() { acb_poly_set_acb(v_, c.raw()); }
  /// c + h
  [[nodiscard]] static PowerSeries at(const ComplexBall& c, slong known = 3);
  PowerSeries(const PowerSeries& o) : known(o.known) {
    acb_poly_init(v_);
    acb_poly_set(v_, o.v_);
  }
  PowerSeries& operator=(PowerSeries o) noexcept {
    known = o.known;
    acb_poly_swap(v_, o.v_);
    return *this;
  }
  ~PowerSeries() { acb_poly_clear(v_); }
  [[nodiscard]] const acb_poly_struct* raw() const { return v_; }
  [[nodiscard]] acb_poly_struct* raw() { return v_; }
  [[nodiscard]] ComplexBall coefficient(slong i) const;

  static constexpr slong whole = LONG_MAX;
  slong known = whole;

private:
  acb_poly_t v_;
};

class NoValueHere : public Error {
  using Error::Error;
};

/// Functions as in known_functions.hpp, roots of polynomials, derivatives; int(f, x) has any constant of integration,
/// the same wherever it stands.
/// Given   ComplexBall two; acb_set_si(two.raw(), 2);
/// Given   const AtPoint at_2({{"x", PowerSeries::at(two)}}, 128);
/// Example *at_2.holds(parse_expression("diff(x^3, x) = 12", "e", true))  // -> yes
/// Example *at_2.holds(parse_expression("besselj(1, x) + diff(besselj(0, x), x) = 0", "e", true))  // -> yes
/// Example at_2(parse_expression("f(x)", "e")).known  // -> throws NoValueHere
class AtPoint {
public:
  using Values = std::map<std::string, PowerSeries>;
  AtPoint(Values values, slong bits) : values_(std::move(values)), bits_(bits) {}

  /// Errors  NoValueHere: a name or a function that has none
  [[nodiscard]] PowerSeries operator()(const Expression& e) const;
  /// Is left = right?  yes: the sum of all terms is below 10^-25 of the largest one; no: it is above, for certain;
  /// nothing: the balls are too large, or there is no value.
  [[nodiscard]] std::optional<bool> holds(const Expression& equation) const;

private:
  [[nodiscard]] PowerSeries named(const std::string& name) const;
  [[nodiscard]] PowerSeries called(const Expression& e) const;
  [[nodiscard]] PowerSeries power(const Expression& e) const;
  [[nodiscard]] PowerSeries root(const Expression& e) const;

  Values values_;
  slong bits_;
};

/// Numbers for names: between 1/2 and 3/2, exact, none of them special; `number` chooses them.  The variable has a small
/// imaginary part, and the others have one if they are complex.
[[nodiscard]] AtPoint::Values some_values(const std::vector<std::string>& names,
                                          const std::string& variable, long number,
                                          bool complex = true);

} // namespace kov
