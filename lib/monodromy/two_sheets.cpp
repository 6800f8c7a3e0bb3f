#include "monodromy/two_sheets.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

using Functions = std::vector<std::vector<RationalFunction>>;

Functions zeros(std::size_t n) {
  return Functions(n, std::vector<RationalFunction>(n, RationalFunction(0)));
}

// F'/(2F)
RationalFunction half_log(const RationalFunction& f) {
  return derivative(f) / (RationalFunction(2) * f);
}

// The matrix of the system for S and D.
Functions both_sheets(const EllipticSystem& s) {
  const RationalFunction f(s.f);
  const std::size_t n = s.size();
  Functions a = zeros(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] = a[n + i][n + j] = s.odd[i][j];
      a[i][n + j] = s.even[i][j];
      a[n + i][j] = s.even[i][j] / f;
    }
    a[n + i][n + i] -= half_log(f);
  }
  return a;
}

// The connected part ("uses or is used by") of S_i for each i that has nothing yet.
std::vector<std::size_t> enough(const Functions& a) {
  const std::size_t n = a.size() / 2;
  std::vector<std::size_t> kept;
  std::vector<bool> seen(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    if (seen[i] || seen[n + i]) continue;
    seen[i] = true;
    kept.push_back(i);
    for (std::size_t k = kept.size() - 1; k < kept.size(); ++k)
      for (std::size_t j = 0; j < 2 * n; ++j)
        if (!seen[j] && (!is_zero(a[kept[k]][j]) || !is_zero(a[j][kept[k]]))) {
          seen[j] = true;
          kept.push_back(j);
        }
  }
  std::ranges::sort(kept);
  return kept;
}

void ensure_square(const EllipticSystem& s) {
  if (s.size() == 0) throw InvalidArgument("a system of size 0 has no monodromy");
  for (const Functions* b : {&s.even, &s.odd})
    if (b->size() != s.size() ||
        std::ranges::any_of(*b, [&](const auto& row) { return row.size() != s.size(); }))
      throw InvalidArgument("a system on a curve has two square matrices of one size");
}

} // namespace

TwoSheets::TwoSheets(const EllipticSystem& s) : n_(s.size()), place_(2 * s.size()) {
  ensure_square(s);
  const Functions all = both_sheets(s);
  const std::vector<std::size_t> kept = enough(all);
  const std::size_t n = kept.size();
  if (n > largest_size)
    throw InvalidArgument("both sheets of the curve together give a system of size " +
                          std::to_string(n) + ": the largest is " + std::to_string(largest_size));
  time_ = static_cast<long>(n);
  Functions a = zeros(n + 2);
  for (std::size_t i = 0; i < n; ++i) {
    place_[kept[i]] = static_cast<long>(i);
    for (std::size_t j = 0; j < n; ++j)
      a[i][j] = all[kept[i]][kept[j]];
  }
  const RationalFunction f(s.f);
  a[n][n] = -half_log(f);
  a[n][n + 1] = RationalFunction(1) / f;
  system_ = make_system(a, largest_size + 2);
}

std::vector<TwoSheets::Part> TwoSheets::parts(std::size_t i) const {
  std::vector<Part> all;
  for (const bool is_d : {false, true})
    if (const auto& at = place_[i + (is_d ? n_ : 0)]) all.push_back({is_d, *at});
  return all;
}

BallMatrix TwoSheets::on_sheet(const BallMatrix& m, const ComplexBall& w, int sign,
                               long bits) const {
  BallMatrix y(static_cast<long>(n_));
  const auto add = [&](std::size_t i, const Part& to, std::size_t j, const Part& from) {
    ComplexBall x;
    acb_set(x.raw(), m.entry(to.at, from.at));
    if (to.is_d) acb_mul(x.raw(), x.raw(), w.raw(), bits);
    if (to.is_d && sign < 0) acb_neg(x.raw(), x.raw());
    if (from.is_d) acb_div(x.raw(), x.raw(), w.raw(), bits);
    if (is_double(j)) acb_mul_2exp_si(x.raw(), x.raw(), -1);
    acb_struct* sum = y.entry(static_cast<long>(i), static_cast<long>(j));
    acb_add(sum, sum, x.raw(), bits);
  };
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j)
      for (const Part& to : parts(i))
        for (const Part& from : parts(j))
          add(i, to, j, from);
  return y;
}

} // namespace kov::monodromy
