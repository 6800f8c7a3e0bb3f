#include "algebraize/cyclic_vector.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

using Element = FunctionField::Element;
using Form = std::array<MPoly, 3>; // of D: the coefficients of c1^2, c1 c2, c2^2

constexpr long longest = 2000; // terms: a remainder of more is slower than the equation

long length(const Form& f) { return f[0].length() + f[1].length() + f[2].length(); }

// The coordinates of D, with one denominator for all.
struct Determinant {
  std::vector<Form> forms;
  MPoly den;
};

std::optional<Determinant> determinant(const FunctionField& f, const LinearSystem& s,
                                       const std::vector<std::size_t>& block) {
  const std::size_t i = block[0], j = block[1];
  std::array<Element, 3> d;
  const std::array<MFraction, 3> entries{s.a[i][j], s.a[j][j] - s.a[i][i], -s.a[j][i]};
  Determinant all{{}, MPoly(f.algebra().ring(), Integer(1))};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto e = f.evaluate(entries[k]);
    if (!e) return std::nullopt;
    d[k] = f.algebra().multiply(*e, f.inverse_z_dot());
    for (const MFraction& x : d[k])
      all.den = exact_div(all.den * x.den(), gcd(all.den, x.den()));
  }
  for (std::size_t l = 0; l < d[0].size(); ++l) {
    Form form{d[0][l].num(), d[1][l].num(), d[2][l].num()};
    for (std::size_t k = 0; k < 3; ++k)
      form[k] *= exact_div(all.den, d[k][l].den());
    if (length(form) > longest) return std::nullopt;
    if (length(form) > 0) all.forms.push_back(std::move(form));
  }
  return all;
}

// The remainders of the three modulo p, each multiplied by the same power of its leading
// coefficient.
Form remainder(Form f, const MPoly& p, std::size_t z) {
  const long n = degree(p, z);
  const MPoly lead = coefficients(p, z).back();
  const MPoly x = MPoly::variable(p.ring(), z);
  for (long d = std::max({degree(f[0], z), degree(f[1], z), degree(f[2], z)}); d >= n; --d)
    for (MPoly& g : f) {
      const auto c = coefficients(g, z);
      g = lead * g;
      if (static_cast<long>(c.size()) > d)
        g = g - c[static_cast<std::size_t>(d)] * p * pow(x, static_cast<unsigned long>(d - n));
    }
  return f;
}

// The forms in (1, t) with coefficients without z: t takes the place of z.
void add_conditions(std::vector<MPoly>& all, const Form& f, std::size_t z) {
  std::array<std::vector<MPoly>, 3> c;
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = coefficients(f[k], z);
  const MPoly t = MPoly::variable(f[0].ring(), z);
  for (std::size_t d = 0; d < std::max({c[0].size(), c[1].size(), c[2].size()}); ++d) {
    MPoly sum(f[0].ring());
    for (std::size_t k = 0; k < 3; ++k)
      if (d < c[k].size()) sum += c[k][d] * pow(t, k);
    if (!is_zero(sum)) all.push_back(std::move(sum));
  }
}

// The roots t of all of them, as (c1, c2) with t = c2/c1.
void add_roots(std::vector<std::array<MPoly, 2>>& found, const std::vector<MPoly>& conditions,
               std::size_t z) {
  if (conditions.empty()) return;
  MPoly common = conditions.front();
  for (const MPoly& c : conditions) {
    if (degree(common, z) == 0) return;
    common = gcd(common, c);
  }
  for (const MFactor& g : factor(common).second) {
    const auto c = coefficients(g.base, z);
    if (c.size() != 2 || is_zero(c[0])) continue;
    const std::array<MPoly, 2> root{c[1], -c[0]};
    add_once(found, root);
  }
}

// The coefficients of the highest power of z that occurs.
std::vector<MPoly> at_infinity(const std::vector<Form>& forms, std::size_t z) {
  std::vector<MPoly> conditions;
  for (const Form& f : forms) {
    const long n = std::max({degree(f[0], z), degree(f[1], z), degree(f[2], z)});
    Form top;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto c = coefficients(f[k], z);
      top[k] =
          static_cast<long>(c.size()) > n ? c[static_cast<std::size_t>(n)] : MPoly(f[k].ring());
    }
    add_conditions(conditions, top, z);
  }
  return conditions;
}

} // namespace

std::vector<std::array<MPoly, 2>> cyclic_combinations(const FunctionField& f, std::size_t z,
                                                      const LinearSystem& s,
                                                      const std::vector<std::size_t>& block) {
  const auto d = determinant(f, s, block);
  std::vector<std::array<MPoly, 2>> found;
  if (!d) return found;
  for (const MFactor& p : factor(d->den).second) {
    if (degree(p.base, z) <= 0) continue;
    std::vector<MPoly> conditions;
    for (const Form& form : d->forms)
      add_conditions(conditions, remainder(form, p.base, z), z);
    add_roots(found, conditions, z);
  }
  add_roots(found, at_infinity(d->forms, z), z);
  return found;
}

} // namespace kov
