#include "flow/chaos/krawczyk.hpp"

#include <cmath>
#include <utility>

namespace kov::flow {

double bound_of(const Enclosure& x) {
  const double m = (std::abs(static_cast<double>(x)) + x.radius()) * (1 + 1e-15);
  return std::isfinite(m) ? m : INFINITY;
}

template <class R>
std::optional<std::vector<std::vector<R>>> approximate_inverse(std::vector<std::vector<R>> a) {
  const std::size_t n = a.size();
  std::vector<std::vector<R>> b(n, std::vector<R>(n, R(0)));
  for (std::size_t i = 0; i < n; ++i) {
    b[i][i] = R(1);
    for (R& x : a[i])
      x = x.middle();
  }
  const auto size = [](const R& x) { return std::abs(static_cast<double>(x)); };
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < n; ++k)
      if (size(a[k][i]) > size(a[pivot][i])) pivot = k;
    if (!(size(a[pivot][i]) > 0)) return std::nullopt;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    const R by = (R(1) / a[i][i]).middle();
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] = (a[i][j] * by).middle();
      b[i][j] = (b[i][j] * by).middle();
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i || size(a[k][i]) == 0) continue;
      const R factor = a[k][i];
      for (std::size_t j = 0; j < n; ++j) {
        a[k][j] = (a[k][j] - factor * a[i][j]).middle();
        b[k][j] = (b[k][j] - factor * b[i][j]).middle();
      }
    }
  }
  return b;
}

template <class R>
std::vector<R> applied(const std::vector<std::vector<R>>& c, const std::vector<R>& b) {
  std::vector<R> out;
  for (const std::vector<R>& row : c) {
    R sum(0);
    for (std::size_t j = 0; j < b.size(); ++j)
      add_product(sum, row[j], b[j]);
    out.push_back(sum);
  }
  return out;
}

template <class R>
std::vector<R> krawczyk_shift(const std::vector<std::vector<R>>& c, const std::vector<R>& value,
                              const std::vector<std::vector<R>>& slope,
                              const std::vector<double>& radius) {
  const std::size_t n = value.size();
  std::vector<R> shift = applied(c, value);
  for (std::size_t i = 0; i < n; ++i) {
    shift[i] = -shift[i];
    for (std::size_t j = 0; j < n; ++j) {
      R entry(i == j ? 1 : 0);
      for (std::size_t k = 0; k < n; ++k)
        sub_product(entry, c[i][k], slope[k][j]);
      shift[i] += entry * R(0).widened(R(radius[j]));
    }
  }
  return shift;
}

template <class R>
bool shift_inside(const std::vector<R>& shift, const std::vector<double>& radius) {
  for (std::size_t i = 0; i < shift.size(); ++i)
    if (!(bound_of(shift[i]) < radius[i])) return false;
  return true;
}

#define KOV_KRAWCZYK(R)                                                                            \
  template std::optional<std::vector<std::vector<R>>> approximate_inverse(                         \
      std::vector<std::vector<R>>);                                                                \
  template std::vector<R> applied(const std::vector<std::vector<R>>&, const std::vector<R>&);      \
  template std::vector<R> krawczyk_shift(                                                          \
      const std::vector<std::vector<R>>&, const std::vector<R>&,                                   \
      const std::vector<std::vector<R>>&, const std::vector<double>&);                             \
  template bool shift_inside(const std::vector<R>&, const std::vector<double>&)
KOV_KRAWCZYK(Enclosure);
KOV_KRAWCZYK(DoubleBall);

} // namespace kov::flow
