#include "monodromy/differential_system.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

// The least positive integer that makes f integral over Z[generator].
Integer denominator(const Poly& f) { return Integer(fmpq_poly_denref(f.raw())); }

Row make_row(const std::vector<RationalFunction>& a, const Field& k) {
  Poly den = coerce(Poly(1), k);
  for (const RationalFunction& f : a)
    den = lcm(den, coerce(f.den(), k));
  Row row{den, {}};
  Integer clear = denominator(den);
  for (const RationalFunction& f : a) {
    row.num.push_back(coerce(f.num(), k) * exact_div(den, coerce(f.den(), k)));
    clear = lcm(clear, denominator(row.num.back()));
  }
  const NfElem factor{Rational(clear)};
  row.den = scale(row.den, factor);
  for (Poly& f : row.num)
    f = scale(f, factor);
  return row;
}

} // namespace

DifferentialSystem make_system(const std::vector<std::vector<RationalFunction>>& a,
                               std::size_t largest) {
  if (a.empty()) throw InvalidArgument("a system of size 0 has no monodromy");
  if (a.size() > largest)
    throw InvalidArgument("a system of size " + std::to_string(a.size()) + ": the largest is " +
                          std::to_string(largest));
  Field k = rationals();
  for (const auto& row : a) {
    if (row.size() != a.size()) throw InvalidArgument("the matrix of a system is square");
    for (const RationalFunction& f : row)
      k = common_field(k, f.field());
  }
  DifferentialSystem s{k, {}};
  for (const auto& row : a)
    s.rows.push_back(make_row(row, k));
  return s;
}

DifferentialSystem companion(const RationalFunction& p, const RationalFunction& q) {
  return make_system({{RationalFunction(0), RationalFunction(1)}, {-q, -p}});
}

RationalFunction entry(const DifferentialSystem& s, std::size_t i, std::size_t j) {
  return {s.rows.at(i).num.at(j), s.rows.at(i).den};
}

std::vector<std::vector<std::size_t>> diagonal_blocks(const DifferentialSystem& s) {
  const std::size_t n = s.rows.size();
  std::vector<std::vector<bool>> uses(n, std::vector<bool>(n)); // directly or not (Warshall)
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      uses[i][j] = i == j || !is_zero(s.rows[i].num[j]);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (uses[i][k] && uses[k][j]) uses[i][j] = true;
  std::vector<std::vector<std::size_t>> blocks;
  for (std::size_t i = 0; i < n; ++i) {
    const auto same = [&](const std::vector<std::size_t>& block) {
      return uses[i][block.front()] && uses[block.front()][i];
    };
    const auto it = std::ranges::find_if(blocks, same);
    if (it == blocks.end())
      blocks.push_back({i});
    else
      it->push_back(i);
  }
  return blocks;
}

Poly common_denominator(const DifferentialSystem& s) {
  Poly common = coerce(Poly(1), s.field);
  for (const Row& row : s.rows)
    common = lcm(common, row.den);
  return common;
}

RationalFunction trace(const DifferentialSystem& s) {
  RationalFunction sum;
  for (std::size_t i = 0; i < s.rows.size(); ++i)
    sum += RationalFunction(s.rows[i].num[i], s.rows[i].den);
  return sum;
}

} // namespace kov::monodromy
