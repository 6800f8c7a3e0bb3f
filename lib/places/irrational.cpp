#include "places/irrational.hpp"

#include "exact/error.hpp"
#include "exact/square_root.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <array>

namespace kov::strata {
namespace {

bool has_parameters(const MFraction& c) { return !is_zero(c) && !is_constant(c); }

MPoly num_times_den(const MFraction& f) {
  return is_zero(f) ? MPoly() : is_constant(f.den()) ? f.num() : f.num() * f.den();
}

int sign_on(const ParametrisedSet& region, const MFraction& f, bool exact) {
  if (is_zero(f)) return 0;
  if (const int s = region.exact_sign_of(f.num()) * region.exact_sign_of(f.den())) return s;
  return exact ? 0 : region.sign_of(f.num()) * region.sign_of(f.den());
}

// num/den has the sign of num den where den is real: i/i = 1, and i i = -1.
bool is_positive(const ParametrisedSet& region, const MFraction& f) {
  if (sign_on(region, f, true) > 0) return true;
  return region.is_real(f.den()) && region.exact_sign_of(num_times_den(f)) > 0;
}

// chi(T) with T in the place of the variable z, cleared of denominators: one more real variable.
MPoly in_one_more_variable(const ParametricPlace& p, std::size_t z) {
  const Ring& ring = p.q.ring();
  MFraction sum(ring);
  MFraction power(ring, Rational(1));
  for (const auto& c : p.chi) {
    sum += c * power;
    power *= MFraction::variable(ring, z);
  }
  return sum.num();
}

std::size_t place_variable(const ParametricPlace& p) { return used_variables(p.q).back(); }

void set_irrational(ParametricPlace& p, Irrationality why) {
  p.exponent = ExponentKind::irrational;
  p.irrational = why;
}

// (c1^2 - 4 c0) with everything known about its factors: negative, negative where a factor is not
// zero, or neither.
struct DiscriminantSign {
  bool negative = false;
  std::optional<MPoly> doubt;
};
DiscriminantSign discriminant_sign(const ParametricPlace& p, const ParametrisedSet& region) {
  for (const auto& c : p.chi) // real coefficients
    for (const std::size_t i : used_variables(c))
      if (!region.is_real(i)) return {};
  const MFraction d = p.chi[1] * p.chi[1] - Rational(4) * p.chi[0];
  if (is_zero(d)) return {};
  int s = region.exact_sign_of(d.den());
  if (s == 0) return {};
  const auto [content, factors] = factor(d.num());
  s *= sign(content);
  DiscriminantSign result;
  for (const auto& f : factors) {
    if (f.exponent % 2 != 0) {
      s *= region.exact_sign_of(f.base);
      continue;
    }
    if (!region.provably_nonzero(f.base)) result.doubt = f.base;
  }
  if (s >= 0) return {};
  result.negative = true;
  return result;
}

void classify_constant(ParametricPlace& p) {
  if (p.chi.size() > 2) {
    set_irrational(p, Irrationality::constant);
    return;
  }
  const Rational square = is_zero(p.chi[0]) ? Rational(0) : -to_rational(p.chi[0]);
  if (const auto root = kov::exact_sqrt(square)) {
    p.exponent = ExponentKind::rational;
    p.delta = *root;
    return;
  }
  p.negative_square = sign(square) < 0;
  set_irrational(p, Irrationality::constant);
}

} // namespace

std::optional<Needs> classify_exponent(ParametricPlace& p, const ParametrisedSet& region) {
  KOV_ENSURE(p.chi.size() >= 2);
  if (std::ranges::none_of(p.chi, has_parameters)) {
    classify_constant(p);
    return std::nullopt;
  }
  p.exponent = ExponentKind::open;
  const std::size_t n = p.chi.size() - 1;
  for (const bool exact : {true, false}) {
    // no root T >= 0 where all coefficients are positive
    if (std::ranges::all_of(p.chi,
                            [&](const MFraction& c) { return sign_on(region, c, exact) > 0; })) {
      p.negative_square = n == 1;
      set_irrational(p, Irrationality::coefficients);
      return std::nullopt;
    }
    if (n != 2 || !exact) continue;
    const DiscriminantSign d = discriminant_sign(p, region);
    if (d.negative && d.doubt)
      return Needs{*d.doubt, {Event::Kind::difference_real, name_of(p, place_variable(p))}};
    if (d.negative) {
      set_irrational(p, Irrationality::discriminant);
      return std::nullopt;
    }
  }
  if (n == 1) return std::nullopt; // its sign was looked at
  const std::size_t t = place_variable(p);
  const MPoly f = in_one_more_variable(p, t);
  const auto used = used_variables(f);
  const bool real =
      std::ranges::all_of(used, [&](std::size_t i) { return i == t || region.is_real(i); });
  if (real &&
      region.refutes({{f, Sign::zero}, {MPoly::variable(p.q.ring(), t), Sign::nonnegative}}))
    set_irrational(p, Irrationality::refuted);
  return std::nullopt;
}

void eliminate_relations(std::vector<MFraction>& chi, const ParametrisedSet& region) {
  for (const auto& relation : region.relations()) {
    if (!any_uses(chi, relation.variable)) continue;
    // T is a new variable of a larger ring
    const Ring& ring = chi.back().ring();
    auto names = ring->names();
    names.emplace_back("T ");
    const Ring larger = make_ring(names);
    const std::size_t t = names.size() - 1;
    MFraction sum(larger);
    for (std::size_t i = chi.size(); i-- > 0;)
      sum = sum * MFraction::variable(larger, t) +
            (is_zero(chi[i]) ? MFraction(larger) : transfer(chi[i], larger));
    const MPoly p = transfer(MFraction(relation.p), larger).num();
    if (relation.p.length() * sum.num().length() > 400) return;
    const MPoly all = resultant(sum.num(), p, larger->index(ring->name(relation.variable)));
    std::vector<MPoly> in_t;
    for (const auto& f : irreducible_parts(all))
      if (uses(f, t)) in_t.push_back(f);
    if (in_t.size() != 1) return;
    const auto c = coefficients(in_t.front(), t);
    if (region.doubtful_factor(transfer(MFraction(c.back()), ring).num())) return;
    std::vector<MFraction> smaller;
    for (const auto& f : c)
      smaller.push_back(is_zero(f) ? MFraction(ring)
                                   : transfer(MFraction(f) / MFraction(c.back()), ring));
    chi = std::move(smaller);
  }
}

namespace {

constexpr std::array halves{1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 10L, 12L, 16L, 20L, 30L};
Rational bound_of_halves(long k) { return Rational(k * k, 4); }

} // namespace

std::optional<Rational> bound_of_square(const ParametricPlace& p, const ParametrisedSet& region) {
  if (p.chi.size() == 2)
    for (const long k : halves) {
      const MFraction room = MFraction(p.q.ring(), bound_of_halves(k)) + p.chi[0]; // B - Delta^2
      if (!is_zero(room) && is_positive(region, room)) return bound_of_halves(k);
    }
  const std::size_t t = place_variable(p);
  const MPoly f = in_one_more_variable(p, t);
  const auto used = used_variables(f);
  if (!std::ranges::all_of(used, [&](std::size_t i) { return i == t || region.is_real(i); }))
    return std::nullopt;
  // Z3: what is below a bound is below a larger one, so where the largest fails no other is asked
  const auto fails = [&](long k) {
    const MFraction above =
        MFraction::variable(p.q.ring(), t) - MFraction(p.q.ring(), bound_of_halves(k));
    return !region.refutes({{f, Sign::zero}, {above.num(), Sign::positive}});
  };
  if (fails(halves.back())) return std::nullopt;
  return bound_of_halves(*std::partition_point(halves.begin(), halves.end() - 1, fails));
}

std::optional<MFraction> exponent_difference(const ParametricPlace& p) {
  if (p.chi.size() != 2) return std::nullopt;
  if (is_zero(p.chi[0])) return MFraction(p.q.ring());
  return square_root(-p.chi[0]);
}

MPoly where_square_is(const ParametricPlace& p, const Rational& x) {
  MFraction sum(p.q.ring());
  Rational power(1);
  for (const auto& c : p.chi) {
    sum += power * c;
    power = power * x;
  }
  return is_zero(sum) ? MPoly(p.q.ring()) : sum.num();
}

} // namespace kov::strata
