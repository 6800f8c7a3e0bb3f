#include "integrability/translations.hpp"

#include <algorithm>

namespace kov {
namespace {

using Components = std::vector<MFraction>;

bool are_constants(const Components& all) {
  return std::ranges::all_of(all, [](const MFraction& f) { return is_zero(f) || is_constant(f); });
}

std::vector<Components> translations(const System& s, const std::vector<ClaimReport>& claims) {
  std::vector<Components> all;
  if (!s.field.poisson) return all;
  for (const ClaimReport& c : claims)
    if (c.claim.kind == SystemClaim::Kind::integral && c.result.proved && c.claim.on.empty() &&
        c.result.generic.empty())
      if (Components x = hamiltonian_field(s.field, *s.field.poisson, c.claim.value);
          are_constants(x))
        all.push_back(std::move(x));
  return all;
}

MFraction along(const VectorField& v, const Components& x, const MFraction& f) {
  MFraction sum(v.ring);
  for (std::size_t j = 0; j < x.size(); ++j)
    if (!is_zero(x[j])) sum += x[j] * partial(v, f, j);
  return sum;
}

// f_j - (w_j/w_i) f_i for the others with w_j != 0; the ideal stays the same.
void adapt(const VectorField& v, const Components& x, std::vector<Equation>& equations) {
  Components w;
  for (const Equation& e : equations)
    w.push_back(along(v, x, e.difference));
  if (!are_constants(w)) return;
  const auto moves = [](const MFraction& f) { return !is_zero(f); };
  const auto first = std::ranges::find_if(w, moves);
  if (first == w.end()) return;
  const Equation& one = equations[static_cast<std::size_t>(first - w.begin())];
  for (auto other = std::find_if(first + 1, w.end(), moves); other != w.end();
       other = std::find_if(other + 1, w.end(), moves)) {
    Equation& e = equations[static_cast<std::size_t>(other - w.begin())];
    e.difference = e.difference - *other / *first * one.difference;
    e.text = to_string(e.difference) + " = 0";
  }
}

} // namespace

ManifoldSpec adapted_to_translations(const System& s, ManifoldSpec m,
                                     const std::vector<ClaimReport>& claims) {
  const ReduceSpec* asked = reduction_for(s, m.name);
  if (asked != nullptr && (asked->unknown || !asked->normal.empty())) return m;
  for (const Components& x : translations(s, claims))
    adapt(s.field, x, m.equations);
  return m;
}

} // namespace kov
