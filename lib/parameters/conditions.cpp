#include "parameters/conditions.hpp"

#include "exact/joined.hpp"
#include "exact/linear_fraction.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "parameters/integers.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

void add_variable(std::vector<std::size_t>& all, std::optional<std::size_t> i) {
  if (i) add_once(all, *i);
}

} // namespace

void Assumptions::declare_real(const MFraction& f) {
  add_variable(real, variable_of_linear_fraction(f));
}

void Assumptions::declare_rational(const MFraction& f) {
  declare_real(f);
  add_variable(rational, variable_of_linear_fraction(f));
}

void Assumptions::require(const MFraction& f, Sign sign) {
  const MPoly num = f.num();
  const MPoly den = f.ring() ? f.den() : MPoly();
  const bool fraction = f.ring() && !is_constant(den);
  const auto add = [this](Condition c) {
    const bool holds = c.sign == Sign::nonzero && !is_zero(c.p) && is_constant(c.p);
    if (!holds && !is_among(c, conditions)) conditions.push_back(std::move(c));
  };
  if (fraction) add({den, Sign::nonzero});
  if (sign == Sign::zero || sign == Sign::nonzero) return add({num, sign});
  declare_real(f);
  if (fraction && !uses_only(den, real)) {
    if (sign == Sign::positive) add({num, Sign::nonzero});
    return;
  }
  add({fraction ? num * den : num, sign});
}

void Assumptions::require_integral(const MFraction& f, bool in_integers) {
  if (f.ring() && !is_constant(f.den())) require(MFraction(f.den()), Sign::nonzero);
  memberships.push_back({f, in_integers});
  for (Membership& m : memberships) { // half of an odd integer, if twice it is an integer
    if (m.in_integers || is_zero(m.value) || is_constant(m.value)) continue;
    const auto proof = integer_proof(memberships, Rational(2) * m.value);
    if (proof && proof->integral) m = {m.value - MFraction(f.ring(), Rational(1, 2)), true};
  }
}

namespace {

// x_i = ... for the last variable that is linear with a constant coefficient.
std::string solved(const MPoly& p, const char* relation) {
  const auto used = used_variables(p);
  for (auto i = used.rbegin(); i != used.rend(); ++i) {
    if (degree(p, *i) != 1) continue;
    const auto c = coefficients(p, *i);
    if (!is_constant(c[1])) continue;
    return p.ring()->name(*i) + relation + to_string(-(MFraction(c[0]) / MFraction(c[1])));
  }
  if (p.length() == 2 && !used.empty()) {
    const auto term = [&](long i) {
      return MFraction(MPoly::term(p.ring(), p.coefficient(i), p.exponents(i)));
    };
    const bool last_is_second = p.exponents(1)[used.back()] > 0;
    const MFraction left = term(last_is_second ? 1 : 0), right = term(last_is_second ? 0 : 1);
    const MFraction lead(p.ring(), Rational(p.coefficient(last_is_second ? 1 : 0)));
    const bool is_power = !uses(right.num(), used.back());
    const MFraction other = -(right / lead);
    if (is_power && (is_constant(other) || sign(other.num().coefficient(0)) > 0))
      return to_string(left / lead) + relation + to_string(other);
  }
  return to_string(p) + relation + "0";
}

} // namespace

std::string to_string(const Condition& c) {
  switch (c.sign) {
  case Sign::zero:
    return solved(c.p, " = ");
  case Sign::nonzero:
    return solved(c.p, " != ");
  default:
    return certify::text_of(c);
  }
}

std::string to_string(const std::vector<Condition>& all) {
  std::string s = joined(all, [&](const Condition& c) { return to_string(c); });
  return s.empty() ? "always" : s;
}

std::optional<MPoly> up_to_sign(const MPoly& p, const MPoly& q) {
  if (p.length() != 2 || q.length() != 2) return std::nullopt;
  MPoly both = p * q;
  return both.length() == 2 ? std::optional(std::move(both)) : std::nullopt;
}

std::optional<std::vector<Condition>> up_to_sign(const std::vector<Condition>& a,
                                                 const std::vector<Condition>& b) {
  for (const Condition& p : a)
    for (const Condition& q : b) {
      if (p.sign != Sign::zero || q.sign != Sign::zero) continue;
      const auto both = up_to_sign(p.p, q.p);
      const Condition not_p{p.p, Sign::nonzero}, not_q{q.p, Sign::nonzero};
      auto here = a, there = b;
      std::erase(here, p);
      std::erase(there, q);
      if (!is_among(not_p, there))
        std::erase(here, not_q);
      else
        std::erase(there, not_p);
      if (!both || here.size() != there.size() ||
          !std::ranges::all_of(here, [&](const Condition& c) { return is_among(c, there); }))
        continue;
      here.push_back({*both, Sign::zero});
      return here;
    }
  return std::nullopt;
}

std::vector<Condition> in_pairs(std::vector<Condition> all) {
  for (auto c = all.begin(); c != all.end(); ++c)
    for (auto d = c + 1; d != all.end() && c->sign == Sign::nonzero; ++d)
      if (const auto both = up_to_sign(c->p, d->p); both && d->sign == Sign::nonzero) {
        c->p = *both;
        all.erase(d);
        break;
      }
  return all;
}

std::vector<std::string> in_words(const Assumptions& all, const Ring& ring) {
  std::vector<std::string> list;
  std::set<std::size_t> told; // what has a sign is real, and an integer is rational
  for (const Condition& c : all.conditions) {
    list.push_back(to_string(c));
    if (certify::is_ordered(c.sign) && uses_only(c.p, all.real))
      for (const std::size_t i : used_variables(c.p))
        told.insert(i);
  }
  std::set<std::size_t> integers;
  for (const Membership& m : all.memberships) {
    list.push_back(to_string(m.value) + (m.in_integers ? " is an integer" : " is not an integer"));
    const auto used = used_variables(m.value);
    if (m.in_integers && used.size() == 1 && m.value == MFraction::variable(ring, used[0]))
      integers.insert(used[0]);
  }
  for (const std::size_t i : all.rational)
    if (integers.count(i) == 0 && integers.insert(i).second)
      list.push_back(ring->name(i) + " is rational");
  told.insert(integers.begin(), integers.end());
  for (const std::size_t i : all.real)
    if (told.insert(i).second) list.push_back(ring->name(i) + " is real");
  return list;
}

std::vector<MPoly> irreducible_parts(const MPoly& p) {
  std::vector<MPoly> parts;
  for (auto& f : factor(p).second)
    if (!is_constant(f.base)) parts.push_back(std::move(f.base));
  return parts;
}

} // namespace kov
