#include "answer/surd.hpp"

#include "strata/parametric_basis.hpp"
#include "symbol/written.hpp"

#include <algorithm>

namespace kov::answer {

Surd Surd::root(const MFraction& f) {
  Surd out;
  if (is_zero(f)) return out;
  const auto [square, rest] = strata::parts_of_root(f);
  if (is_one(rest)) return square;
  const Expression root = trees::call("sqrt", {trees::from(rest)});
  out.roots_.push_back({square, root, written(root)});
  return out;
}

Expression Surd::formula() const {
  if (roots_.empty()) return trees::from(a_);
  std::vector<Expression> terms;
  if (!is_zero(a_)) terms.push_back(trees::from(a_));
  for (const Root& r : roots_)
    terms.push_back(trees::product({trees::from(r.c), r.root}));
  return trees::sum(terms);
}

Surd operator+(Surd a, const Surd& b) {
  a.a_ += b.a_;
  for (const Surd::Root& r : b.roots_) {
    const auto same = std::ranges::find(a.roots_, r.text, &Surd::Root::text);
    if (same == a.roots_.end())
      a.roots_.push_back(r);
    else
      same->c += r.c;
  }
  std::erase_if(a.roots_, [](const Surd::Root& r) { return is_zero(r.c); });
  return a;
}

Surd operator-(const Surd& a) {
  Surd out = a;
  out.a_ = -out.a_;
  for (Surd::Root& r : out.roots_)
    r.c = -r.c;
  return out;
}

Surd operator*(const MFraction& c, Surd a) {
  a.a_ *= c;
  for (Surd::Root& r : a.roots_)
    r.c *= c;
  std::erase_if(a.roots_, [](const Surd::Root& r) { return is_zero(r.c); });
  return a;
}

bool is_zero(const Surd& a) { return a.is_fraction() && is_zero(a.rational_part()); }

std::optional<Rational> number_in(const Surd& a) {
  if (!a.is_fraction()) return std::nullopt;
  if (is_zero(a.rational_part())) return Rational(0);
  if (!is_constant(a.rational_part())) return std::nullopt;
  return to_rational(a.rational_part());
}

} // namespace kov::answer
