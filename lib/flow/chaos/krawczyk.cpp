#include "flow/chaos/krawczyk.hpp"

#include <cmath>
#include <utility>

namespace kov::flow {

double bound_of(const Enclosure& x) {
  const double m = (std::abs(static_cast<double>(x)) + x.radius()) * (1 + 1e-15);
  return std::isfinite(m) ? m : INFINITY;
}

std::optional<BallMatrix> approximate_inverse(BallMatrix a) {
  const std::size_t n = a.size();
  BallMatrix b(n, BallVector(n, Enclosure(0)));
  for (std::size_t i = 0; i < n; ++i) {
    b[i][i] = Enclosure(1);
    for (Enclosure& x : a[i])
      x = x.middle();
  }
  const auto size = [](const Enclosure& x) { return std::abs(static_cast<double>(x)); };
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < n; ++k)
      if (size(a[k][i]) > size(a[pivot][i])) pivot = k;
    if (!(size(a[pivot][i]) > 0)) return std::nullopt;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    const Enclosure by = (Enclosure(1) / a[i][i]).middle();
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] = (a[i][j] * by).middle();
      b[i][j] = (b[i][j] * by).middle();
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i || size(a[k][i]) == 0) continue;
      const Enclosure factor = a[k][i];
      for (std::size_t j = 0; j < n; ++j) {
        a[k][j] = (a[k][j] - factor * a[i][j]).middle();
        b[k][j] = (b[k][j] - factor * b[i][j]).middle();
      }
    }
  }
  return b;
}

BallVector applied(const BallMatrix& c, const BallVector& b) {
  BallVector out;
  for (const BallVector& row : c) {
    Enclosure sum(0);
    for (std::size_t j = 0; j < b.size(); ++j)
      add_product(sum, row[j], b[j]);
    out.push_back(sum);
  }
  return out;
}

BallVector krawczyk_shift(const BallMatrix& c, const BallVector& value, const BallMatrix& slope,
                          const std::vector<double>& radius) {
  const std::size_t n = value.size();
  BallVector shift = applied(c, value);
  for (std::size_t i = 0; i < n; ++i) {
    shift[i] = -shift[i];
    for (std::size_t j = 0; j < n; ++j) {
      Enclosure entry(i == j ? 1 : 0);
      for (std::size_t k = 0; k < n; ++k)
        sub_product(entry, c[i][k], slope[k][j]);
      shift[i] += entry * Enclosure(0).widened(Enclosure(radius[j]));
    }
  }
  return shift;
}

bool shift_inside(const BallVector& shift, const std::vector<double>& radius) {
  for (std::size_t i = 0; i < shift.size(); ++i)
    if (!(bound_of(shift[i]) < radius[i])) return false;
  return true;
}

} // namespace kov::flow
