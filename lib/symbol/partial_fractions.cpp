#include "symbol/partial_fractions.hpp"

#include "exact/factor.hpp"

#include <algorithm>

namespace kov {
namespace {

using Factors = std::vector<SplitFraction::Factor>;

bool before(const SplitFraction::Factor& a, const SplitFraction::Factor& b) {
  return compare(a.base, b.base) < 0;
}

Poly expanded(const Factors& factors, const Field& k) {
  std::vector<Poly> powers{coerce(Poly(1), k)};
  for (const auto& [base, e] : factors)
    powers.push_back(pow(base, static_cast<unsigned long>(e)));
  return product(std::move(powers));
}

// The factors of lcm(a, b), and what is missing in a and in b.
struct Common {
  Factors all, not_in_a, not_in_b;
};

Common common(const Factors& a, const Factors& b) {
  Common c;
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && before(*i, *j))) {
      c.all.push_back(*i);
      c.not_in_b.push_back(*i++);
    } else if (i == a.end() || before(*j, *i)) {
      c.all.push_back(*j);
      c.not_in_a.push_back(*j++);
    } else {
      const long e = std::max(i->exponent, j->exponent);
      c.all.push_back({i->base, e});
      if (i->exponent < e) c.not_in_a.push_back({i->base, e - i->exponent});
      if (j->exponent < e) c.not_in_b.push_back({j->base, e - j->exponent});
      ++i;
      ++j;
    }
  }
  return c;
}

} // namespace

void SplitFraction::times(const Poly& base, long exponent) {
  if (exponent == 0) return;
  const Factor factor{base, exponent};
  const auto at = std::ranges::lower_bound(factors, factor, before);
  if (at == factors.end() || !(at->base == base)) {
    factors.insert(at, factor);
  } else if ((at->exponent += exponent) == 0) {
    factors.erase(at);
  }
}

struct PartialFractions::Partial {
  Poly num;
  Factors den;
};

PartialFractions::Partial PartialFractions::sum(std::size_t from, std::size_t to) const {
  budget_.check();
  if (to - from == 1) {
    Factors top;
    Factors den;
    for (const auto& [base, e] : terms_[from].factors)
      (e > 0 ? top : den).push_back({base, std::abs(e)});
    return {scale(expanded(top, k_), terms_[from].unit), std::move(den)};
  }
  const std::size_t middle = from + (to - from) / 2;
  const Partial a = sum(from, middle);
  const Partial b = sum(middle, to);
  Common c = common(a.den, b.den);
  long degree = 0;
  for (const auto& factor : c.all)
    degree += factor.exponent;
  budget_.check_degree(degree);
  return {a.num * expanded(c.not_in_a, k_) + b.num * expanded(c.not_in_b, k_), std::move(c.all)};
}

RationalFunction PartialFractions::sum() const {
  const Partial total = sum(0, terms_.size());
  return {total.num, expanded(total.den, k_)};
}

} // namespace kov
