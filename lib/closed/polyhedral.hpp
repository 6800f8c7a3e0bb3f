#pragma once
// The three primitive finite subgroups of SL(2, C), made from generators: the binary tetrahedral,
// octahedral and icosahedral groups as unit quaternions, with exact coordinates.
//
// A unit quaternion q = w + xi + yj + zk is a matrix of SL(2, C) with trace 2w; its coordinates lie
// in Q(sqrt 2) or Q(sqrt 5) and are kept as integers (a, b) with 4 x = a + b sqrt(d).
//
// Source  [Klein1884] I.2; docs/theory/kimura.md

#include "exact/integer.hpp"
#include "galois/group.hpp"

#include <array>
#include <vector>

namespace kov {

/// (a + b sqrt(d))/4, d kept by whoever computes.
struct Surd {
  long a = 0;
  long b = 0;
  friend bool operator==(const Surd&, const Surd&) = default;
  friend auto operator<=>(const Surd&, const Surd&) = default; ///< an order without meaning
};

using Quaternion = std::array<Surd, 4>; ///< w, x, y, z

/// A group with all its elements.
/// Example PolyhedralGroup(GroupType::A5).elements().size()  // -> 120
/// Example PolyhedralGroup(GroupType::D).elements().size()  // -> throws InvalidArgument
class PolyhedralGroup {
public:
  /// A4, S4 or A5; otherwise InvalidArgument.
  /// Cost  the closure of two generators: |G|^2 products at most (|G| = 24, 48, 120)
  explicit PolyhedralGroup(GroupType type);

  [[nodiscard]] GroupType type() const noexcept { return type_; }
  [[nodiscard]] const std::vector<Quaternion>& elements() const noexcept { return elements_; }
  /// The exponent difference in [0, 1] that a place with this local monodromy has:
  /// the trace 2w is -2 cos(pi Delta).
  [[nodiscard]] const Rational& exponent(std::size_t element) const { return exponent_[element]; }
  /// The element with this real part has this exponent.
  [[nodiscard]] const Rational& exponent_of_real_part(const Surd& w) const;

  [[nodiscard]] Quaternion multiply(const Quaternion& p, const Quaternion& q) const;
  /// The real part of p q only.
  [[nodiscard]] Surd real_part_of_product(const Quaternion& p, const Quaternion& q) const;
  /// Do p and q generate an irreducible group?
  [[nodiscard]] bool irreducible(const Quaternion& p, const Quaternion& q) const;

private:
  void close(std::vector<Quaternion> generators);
  void set_exponents();
  [[nodiscard]] long order(const Quaternion& q) const;
  [[nodiscard]] bool less(const Surd& x, const Surd& y) const; ///< as real numbers
  [[nodiscard]] Surd product_sum(const std::array<Surd, 4>& x, const std::array<Surd, 4>& y) const;

  GroupType type_;
  long d_ = 2;
  std::vector<Quaternion> elements_;
  std::vector<Rational> exponent_;
  std::vector<std::pair<Surd, Rational>> by_real_part_;
};

} // namespace kov
