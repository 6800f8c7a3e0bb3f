#include "moves/axes.hpp"

#include "canonical/form.hpp"
#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/tried.hpp"
#include "moves/e3.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using Vector = std::vector<MFraction>; // of three

MFraction product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A root in the fractions.
std::optional<MFraction> root(const MFraction& f) {
  const auto [content, factors] = factor(f.num() * f.den());
  const auto number = exact_sqrt(content);
  if (!number) return std::nullopt;
  MPoly all(f.num().ring(), *number);
  for (const MFactor& one : factors) {
    if (one.exponent % 2 != 0) return std::nullopt;
    all *= pow(one.base, static_cast<unsigned long>(one.exponent / 2));
  }
  return MFraction(all, f.den());
}

std::optional<Vector> unit(Vector v) {
  const MFraction square = product(v, v);
  if (is_zero(square)) return std::nullopt;
  const auto length = root(square);
  if (!length) return std::nullopt;
  for (MFraction& x : v)
    x = x / *length;
  return v;
}

/// A quadratic form of three momenta, and a linear one of Gamma.
class Body {
public:
  explicit Body(const VectorField& v) : v_(v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const MFraction slope = derivative(*v.hamiltonian, v.coordinates[i]);
      a_.emplace_back();
      for (std::size_t j = 0; j < 3; ++j)
        a_.back().push_back(at_origin(derivative(slope, v.coordinates[j])));
      lever_.push_back(at_origin(derivative(*v.hamiltonian, v.coordinates[i + 3])));
    }
  }

  /// Orthonormal, a right-handed basis; unset: the coordinates have it, or there is none.
  [[nodiscard]] std::optional<std::vector<Vector>> axes(const Budget& budget) const {
    std::vector<Vector> all;
    std::vector<Vector> plane;
    for (const MFraction& value : eigenvalues()) {
      auto space = null_space(less(value), 3, v_.ring, budget);
      if (space.size() == 1) {
        const auto axis = unit(space.front());
        if (!axis) return std::nullopt;
        all.push_back(*axis);
      } else {
        plane = std::move(space);
      }
    }
    if (plane.size() == 2 && all.size() == 1) {
      const auto first = in_plane(all.front());
      if (!first) return std::nullopt;
      all.insert(all.begin(), {*first, cross(all.front(), *first)});
    }
    if (all.size() != 3 || !is_turned(all)) return std::nullopt;
    return in_order(std::move(all));
  }

private:
  [[nodiscard]] MFraction at_origin(const MFraction& f) const {
    Substitution origin;
    for (const std::size_t i : v_.coordinates)
      origin[i] = MFraction(v_.ring);
    return substitute(f, origin);
  }
  [[nodiscard]] Matrix less(const MFraction& value) const {
    Matrix m = a_;
    for (std::size_t i = 0; i < 3; ++i)
      m[i][i] -= value;
    return m;
  }
  // Each in the fractions once.
  [[nodiscard]] std::vector<MFraction> eigenvalues() const {
    auto names = v_.ring->names();
    names.emplace_back("|");
    const Ring larger = make_ring(names);
    const std::size_t t = names.size() - 1;
    Matrix m;
    for (std::size_t i = 0; i < 3; ++i) {
      m.emplace_back();
      for (std::size_t j = 0; j < 3; ++j)
        m.back().push_back(transfer(a_[i][j], larger));
      m.back()[i] -= MFraction::variable(larger, t);
    }
    std::vector<MFraction> all;
    for (const MFactor& f : factor(determinant(m, larger).num()).second)
      if (const auto c = coefficients(f.base, t); c.size() == 2)
        all.push_back(transfer(-MFraction(c[0], c[1]), v_.ring));
    return all;
  }
  // Orthogonal to the axis: the lever without its part along it, or any.
  [[nodiscard]] std::optional<Vector> in_plane(const Vector& axis) const {
    Vector lever = lever_;
    for (std::size_t i = 0; i < 3; ++i)
      lever[i] -= product(lever_, axis) * axis[i];
    if (!is_zero(lever))
      if (auto one = unit(lever)) return one;
    for (std::size_t k = 0; k < 3; ++k) { // the reflection of an axis of the coordinates
      Vector mirror = axis;
      mirror[k] -= MFraction(v_.ring, Rational(1));
      if (is_zero(mirror)) return basis((k + 1) % 3);
      const MFraction square = product(mirror, mirror);
      if (is_zero(square)) continue;
      Vector one = basis((k + 1) % 3);
      const MFraction times = Rational(2) * mirror[(k + 1) % 3] / square;
      for (std::size_t i = 0; i < 3; ++i)
        one[i] -= times * mirror[i];
      return one;
    }
    return std::nullopt;
  }
  [[nodiscard]] Vector basis(std::size_t k) const {
    Vector e(3, MFraction(v_.ring));
    e[k] = MFraction(v_.ring, Rational(1));
    return e;
  }
  // Right-handed, with what is an axis of the coordinates at its place.
  [[nodiscard]] std::vector<Vector> in_order(std::vector<Vector> axes) const {
    std::size_t free = 2; // an axis that may be reversed
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        if (is_zero(cross(axes[i], basis(k)))) {
          std::swap(axes[i], axes[k]);
          axes[k] = basis(k);
          free = (k + 1) % 3;
        }
    if (product(cross(axes[0], axes[1]), axes[2]) == MFraction(v_.ring, Rational(-1)))
      for (MFraction& x : axes[free])
        x = -x;
    return axes;
  }
  // Some axis is not one of the coordinates.
  static bool is_turned(const std::vector<Vector>& axes) {
    return std::ranges::any_of(axes, [](const Vector& axis) {
      return std::ranges::count_if(axis, [](const MFraction& x) { return !is_zero(x); }) > 1;
    });
  }

  const VectorField& v_;
  Matrix a_;
  Vector lever_;
};

CanonicalChange turned(const System& s, const std::vector<Vector>& axes) {
  Form form{s.field, {}};
  const auto& x = s.field.coordinates;
  for (const std::size_t i : x)
    form.forward.push_back(form.variable(i));
  Substitution old, now;
  for (const std::size_t begin : {0, 3})
    for (std::size_t i = 0; i < 3; ++i) {
      MFraction there(s.ring()), here(s.ring());
      for (std::size_t j = 0; j < 3; ++j) {
        there += axes[i][j] * form.variable(x[begin + j]);
        here += axes[j][i] * form.variable(x[begin + j]);
      }
      now[x[begin + i]] = there;
      old[x[begin + i]] = here;
    }
  return finished(s, changed(form, old, now));
}

} // namespace

std::optional<CanonicalChange> on_principal_axes(const System& s, const Budget& budget) {
  const VectorField& v = s.field;
  if (!v.hamiltonian || !has_bracket_of_e3(v) || !v.functions.empty() || !v.relations.empty())
    return std::nullopt;
  using Change = std::optional<CanonicalChange>;
  return tried<DomainError>([&]() -> Change { // a pole at the origin
    const auto axes = Body(v).axes(budget);
    if (!axes) return std::nullopt;
    CanonicalChange change = turned(s, *axes);
    return is_canonical(s, change, budget) ? Change(std::move(change)) : std::nullopt;
  });
}

} // namespace kov
