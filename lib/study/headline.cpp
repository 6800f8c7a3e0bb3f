#include "study/headline.hpp"

#include <algorithm>

namespace kov::study {

namespace {

// More is excluded, or the same with less trust.
bool is_better(const Headline& a, const Headline& b) {
  if (a.excluded.size() != 1 || b.excluded.size() != 1) return false;
  const IntegralClass &x = a.excluded.front(), &y = b.excluded.front();
  if (contains(x, y) != Truth::yes) return false;
  return contains(y, x) != Truth::yes || a.trusted + a.unchecked < b.trusted + b.unchecked;
}

const Headline* best_obstruction(std::span<const Headline> all) {
  const Headline* best = nullptr;
  for (const Headline& h : all)
    if (h.verdict == Verdict::non_integrable && (best == nullptr || is_better(h, *best))) best = &h;
  return best;
}

Verdict without_obstruction(std::span<const Headline> all, bool excludes) {
  const auto any = [&](Verdict v) {
    return std::ranges::any_of(all, [v](const Headline& h) { return h.verdict == v; });
  };
  for (const Verdict v : {Verdict::failed, Verdict::undecided, Verdict::depends})
    if (any(v)) return v;
  return all.empty() ? Verdict::undecided : excludes ? Verdict::depends : Verdict::no_obstruction;
}

} // namespace

Verdict verdict_of_sets(bool open, bool integrable, bool excluded) {
  if (open || !(integrable || excluded)) return Verdict::undecided;
  if (integrable && excluded) return Verdict::depends;
  return integrable ? Verdict::integrable : Verdict::non_integrable;
}

Headline headline(std::span<const Headline> manifolds, const Headline* together) {
  Headline whole;
  if (const Headline* by = best_obstruction(manifolds))
    whole = *by;
  else if (together != nullptr)
    whole = *together;
  else if (manifolds.size() == 1)
    whole = manifolds.front();
  if (whole.verdict != Verdict::non_integrable)
    whole.verdict =
        without_obstruction(manifolds, together != nullptr && !together->excluded.empty());
  whole.refused = 0;
  whole.complete = true;
  for (const Headline& h : manifolds) {
    whole.refused += h.refused;
    whole.complete = whole.complete && h.complete;
  }
  return whole;
}

} // namespace kov::study
