#pragma once
// Numbers that depend on parameters: a + sum c_i sqrt(f_i), a, c_i, f_i in Q(parameters).

#include "exact/multivariate.hpp"
#include "symbol/formula.hpp"

#include <string>
#include <vector>

namespace kov::answer {

class Surd {
public:
  Surd() = default;
  Surd(const MFraction& a) : a_(a) {} // NOLINT: a fraction is one
  /// Example Surd::root(MFraction(Rational(4)*a*a), 0).formula()  // -> 2*a
  [[nodiscard]] static Surd root(const MFraction& f);

  [[nodiscard]] const MFraction& rational_part() const noexcept { return a_; }
  [[nodiscard]] bool is_fraction() const noexcept { return roots_.empty(); }
  [[nodiscard]] Expression formula() const;

  friend Surd operator+(Surd a, const Surd& b);
  friend Surd operator-(const Surd& a);
  friend Surd operator-(const Surd& a, const Surd& b) { return a + -b; }
  friend Surd operator*(const MFraction& c, Surd a);

private:
  struct Root {
    MFraction c;
    Expression root; ///< without a number, a fraction or a square in front
    std::string text;
  };
  MFraction a_;
  std::vector<Root> roots_;
};

[[nodiscard]] bool is_zero(const Surd& a);
/// A rational number that it is.
[[nodiscard]] std::optional<Rational> number_in(const Surd& a);

} // namespace kov::answer
