#include "strata/domain.hpp"

#include "closed/statement.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

class DomainOf {
public:
  explicit DomainOf(const Question& q) : q_(q), region_(q.r.ring(), q.assumptions) {}

  Domain operator()() {
    for (const Genericity& g : q_.generic)
      add(g.not_all_zero);
    if (is_zero(q_.r) || is_constant(q_.r.den())) return std::move(domain_);
    for (const MFactor& f : factor(q_.r.den()).second) // one of them is 0 for all z
      add(coefficients(f.base, q_.z));
    return std::move(domain_);
  }

private:
  void add(std::vector<MPoly> group) {
    std::erase_if(group, [](const MPoly& f) { return is_zero(f); });
    if (group.empty()) return;
    MPoly common(q_.r.ring());
    for (const MPoly& f : group)
      common = gcd(common, f);
    for (MPoly& f : irreducible_parts(common))
      if (may_vanish(f) && !is_among(f, domain_.nonzero)) domain_.nonzero.push_back(std::move(f));
    for (MPoly& f : group)
      f = exact_div(f, common);
    std::ranges::reverse(group); // the highest power of z first
    if (std::ranges::all_of(group, [&](const MPoly& f) { return may_vanish(f); }) &&
        !is_among(group, domain_.not_all_zero))
      domain_.not_all_zero.push_back(std::move(group));
  }

  [[nodiscard]] bool may_vanish(const MPoly& f) const {
    return !is_constant(f) && !is_plainly_nonzero(f, region_) && !is_number_that_is_not_zero(f);
  }
  // sqrt(2), or I + 1: no common root with the equation of the constant
  [[nodiscard]] bool is_number_that_is_not_zero(const MPoly& f) const {
    const auto& all = q_.assumptions.conditions;
    return std::ranges::any_of(all, [&](const Condition& c) {
      return c.sign == Sign::zero && !is_zero(c.p) && used_variables(c.p).size() == 1 &&
             used_variables(c.p) == used_variables(f) && is_constant(gcd(c.p, f));
    });
  }

  const Question& q_;
  ParametrisedSet region_;
  Domain domain_;
};

bool is_assumed(const MPoly& p, const Assumptions& all) { // p = 0
  return std::ranges::any_of(all.conditions, [&](const Condition& c) {
    return c.sign == Sign::zero && (c.p == p || c.p == -p);
  });
}

} // namespace

Domain domain(const StrataAnswer& a) {
  const bool whole =
      std::ranges::none_of(a.strata, [](const Stratum& s) { return s.leaf.no_equation(); });
  return whole || !a.question ? Domain{} : DomainOf(*a.question)();
}

std::vector<std::string> in_words(const Domain& d) {
  std::vector<std::string> all;
  const auto is_nonzero = [](const MPoly& f) { return to_string(Condition{f, Sign::nonzero}); };
  for (const MPoly& f : d.nonzero)
    all.push_back(is_nonzero(f));
  for (const auto& group : d.not_all_zero)
    all.push_back(joined(group, is_nonzero, " or "));
  return all;
}

StrataAnswer on_domain(StrataAnswer a) {
  const Domain there = domain(a);
  std::erase_if(a.strata, [](const Stratum& s) { return s.leaf.no_equation(); });
  for (Stratum& s : a.strata)
    std::erase_if(s.conditions, [&](const Condition& c) {
      const bool assumed =
          a.question && c.sign == Sign::zero && is_assumed(c.p, a.question->assumptions);
      return assumed || (c.sign == Sign::nonzero && is_among(c.p, there.nonzero));
    });
  return a;
}

} // namespace kov::strata
