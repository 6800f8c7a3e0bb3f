#pragma once
// Real intervals that contain the exact value (Arb), as a number type for the kernels: what comes out is proved.
// The precision is that of the thread (EnclosureScope).

#include "exact/ball.hpp"
#include "flow/number/lanes.hpp"

#include <concepts>
#include <string>

namespace kov::flow {

class Enclosure : public Ball {
public:
  Enclosure() = default;
  Enclosure(std::integral auto n) { arb_set_si(v_, n); }
  Enclosure(double x) { arb_set_d(v_, x); }

  [[nodiscard]] static slong bits() noexcept { return bits_; }
  /// The middle, rounded.
  explicit operator double() const { return arf_get_d(arb_midref(v_), ARF_RND_NEAR); }
  /// An upper bound of the radius.
  [[nodiscard]] double radius() const { return mag_get_d(arb_radref(v_)); }
  /// [low, high] of two exact doubles.
  [[nodiscard]] static Enclosure between(double low, double high) {
    return hull(Enclosure(low), Enclosure(high));
  }
  [[nodiscard]] static Enclosure hull(const Enclosure& a, const Enclosure& b) {
    Enclosure r;
    arb_union(r.v_, a.v_, b.v_, bits_);
    return r;
  }
  /// The middle as an exact number.
  [[nodiscard]] Enclosure middle() const {
    Enclosure m;
    arb_get_mid_arb(m.v_, v_);
    return m;
  }
  /// Wider by r >= 0 on both sides.
  [[nodiscard]] Enclosure widened(const Enclosure& r) const {
    Enclosure w(*this);
    arb_add_error(w.v_, r.v_);
    return w;
  }
  [[nodiscard]] bool contains_zero() const { return arb_contains_zero(v_) != 0; }
  [[nodiscard]] bool inside(const Enclosure& other) const { // strictly
    return arb_contains_interior(other.v_, v_) != 0;
  }
  [[nodiscard]] bool is_positive() const { return arb_is_positive(v_) != 0; }
  [[nodiscard]] bool is_negative() const { return arb_is_negative(v_) != 0; }

  Enclosure& operator+=(const Enclosure& b) { return arb_add(v_, v_, b.v_, bits_), *this; }
  Enclosure& operator-=(const Enclosure& b) { return arb_sub(v_, v_, b.v_, bits_), *this; }
  Enclosure& operator*=(const Enclosure& b) { return arb_mul(v_, v_, b.v_, bits_), *this; }
  Enclosure& operator/=(const Enclosure& b) { return arb_div(v_, v_, b.v_, bits_), *this; }
  friend Enclosure operator+(Enclosure a, const Enclosure& b) { return a += b; }
  friend Enclosure operator-(Enclosure a, const Enclosure& b) { return a -= b; }
  friend Enclosure operator*(Enclosure a, const Enclosure& b) { return a *= b; }
  friend Enclosure operator/(Enclosure a, const Enclosure& b) { return a /= b; }
  friend Enclosure operator-(Enclosure a) { return arb_neg(a.v_, a.v_), a; }
  // Comparisons are proofs: true means certainly.  (x == y only for exact equal numbers.)
  friend bool operator<(const Enclosure& a, const Enclosure& b) { return arb_lt(a.v_, b.v_) != 0; }
  friend bool operator>(const Enclosure& a, const Enclosure& b) { return arb_gt(a.v_, b.v_) != 0; }
  friend bool operator==(const Enclosure& a, const Enclosure& b) { return arb_eq(a.v_, b.v_) != 0; }

private:
  friend class EnclosureScope;
  inline static thread_local slong bits_ = 128;
};

/// The precision of the thread's operations on Enclosures, in bits, until the scope ends.
class EnclosureScope {
public:
  explicit EnclosureScope(long bits) : before_(Enclosure::bits_) { Enclosure::bits_ = bits; }
  ~EnclosureScope() { Enclosure::bits_ = before_; }
  EnclosureScope(const EnclosureScope&) = delete;
  EnclosureScope& operator=(const EnclosureScope&) = delete;

private:
  slong before_;
};

inline void add_product(Enclosure& acc, const Enclosure& a, const Enclosure& b) {
  arb_addmul(acc.raw(), a.raw(), b.raw(), Enclosure::bits());
}
inline void sub_product(Enclosure& acc, const Enclosure& a, const Enclosure& b) {
  arb_submul(acc.raw(), a.raw(), b.raw(), Enclosure::bits());
}
inline Enclosure sqrt(Enclosure a) { return arb_sqrt(a.raw(), a.raw(), Enclosure::bits()), a; }
inline Enclosure sin(Enclosure a) { return arb_sin(a.raw(), a.raw(), Enclosure::bits()), a; }
inline Enclosure cos(Enclosure a) { return arb_cos(a.raw(), a.raw(), Enclosure::bits()), a; }
inline Enclosure atan2(Enclosure y, const Enclosure& x) {
  return arb_atan2(y.raw(), y.raw(), x.raw(), Enclosure::bits()), y;
}
inline Enclosure pi_of(const Enclosure&) {
  Enclosure p;
  arb_const_pi(p.raw(), Enclosure::bits());
  return p;
}

} // namespace kov::flow
