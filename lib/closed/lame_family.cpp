#include "closed/lame_family.hpp"

#include "closed/coefficients.hpp"
#include "closed/half.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

using Polynomial = Coefficients<MFraction>;

struct FractionInZ {
  Polynomial num, den; ///< trimmed
};

// x^-4 r(c + 1/x): coefficients of the Taylor expansions at c in reversed order.
FractionInZ turned(const FractionInZ& r, const MFraction& c) {
  Polynomial num = shifted(r.num, c);
  Polynomial den = shifted(r.den, c);
  const long power = static_cast<long>(den.size()) - static_cast<long>(num.size()) - 4; // of x
  std::reverse(num.begin(), num.end());
  std::ranges::reverse(den);
  Polynomial& times = power > 0 ? num : den;
  const MFraction zero(c.ring());
  times.insert(times.begin(), static_cast<std::size_t>(std::abs(power)), zero);
  num = trimmed(std::move(num));
  den = trimmed(std::move(den));
  while (!num.empty() && is_zero(num.front()) && is_zero(den.front())) {
    num.erase(num.begin());
    den.erase(den.begin());
  }
  return {std::move(num), std::move(den)};
}

void make_monic(FractionInZ& r) {
  const MFraction lead = r.den.back();
  for (Polynomial* p : {&r.num, &r.den})
    for (MFraction& c : *p)
      c = c / lead;
}

// The cubic P with P^2 = d, d monic of degree 6.
std::optional<Polynomial> square_root(const Polynomial& d) {
  if (d.size() != 7) return std::nullopt;
  const MFraction p2 = half * d[5];
  const MFraction p1 = half * (d[4] - p2 * p2);
  const MFraction p0 = half * (d[3] - Rational(2) * (p1 * p2));
  const Polynomial p{p0, p1, p2, d[6]};
  const Polynomial square = product(p, p);
  for (std::size_t i = 0; i < d.size(); ++i)
    if (!(i < square.size() ? square[i] == d[i] : is_zero(d[i]))) return std::nullopt;
  return p;
}

struct Form {
  MFraction alpha;
  LameParameters<MFraction> p;
  MFraction shift; ///< x here is x + shift there
};

std::optional<Form> lame_form(FractionInZ r) {
  make_monic(r);
  const auto cubic = square_root(r.den);
  if (!cubic) return std::nullopt;
  const MFraction shift = Rational(-1, 3) * (*cubic)[2];
  const Polynomial f = sum({}, shifted(*cubic, shift), Rational(4));
  const Polynomial slope = derivative(f);
  Polynomial left = sum({}, shifted(r.num, shift), Rational(256));
  left = sum(std::move(left), product(f, derivative(slope)), Rational(-4));
  left = sum(std::move(left), product(slope, slope), Rational(3));
  const auto [line, rest] = divided(std::move(left), sum({}, f, Rational(16)));
  if (!rest.empty() || line.size() > 2) return std::nullopt;
  const MFraction zero(shift.ring());
  const auto at = [&](const Polynomial& p, std::size_t i) { return i < p.size() ? p[i] : zero; };
  return Form{at(line, 1), {at(line, 0), -at(f, 1), -at(f, 0)}, shift};
}

class LameRecognizer {
public:
  LameRecognizer(const MFraction& r, std::size_t z) : ring_(r.ring()), z_(z) { note(r.den()); }

  // r in the variable w, z or (z - c)^2
  std::optional<LameFamilyForm> try_all(const FractionInZ& r, const std::vector<MFraction>& places,
                                        const MFraction& w) {
    if (r.num.size() > 10 || r.den.size() > 12) return std::nullopt;
    if (const auto form = lame_form(r)) return found(*form, w - form->shift);
    for (const MFraction& c : places) {
      const auto form = lame_form(turned(r, c));
      if (!form) continue;
      note(c.den());
      return found(*form, pow(w - c, -1) - form->shift);
    }
    return std::nullopt;
  }

  void note(const MPoly& f) {
    if (is_constant(f)) return;
    for (const MFactor& factor : factor(f).second)
      if (!uses(factor.base, z_) && !is_among(factor.base, generic_))
        generic_.push_back(factor.base);
  }

private:
  LameFamilyForm found(const Form& form, MFraction map) {
    for (const MFraction* f : {&form.alpha, &form.p.b, &form.p.g2, &form.p.g3, &form.shift})
      if (f->ring()) note(f->den());
    return {form.alpha, form.p, z_, std::move(map), false, generic_};
  }

  Ring ring_;
  std::size_t z_;
  std::vector<MPoly> generic_;
};

std::vector<MFraction> rational_places(const MPoly& den, std::size_t z) {
  std::vector<MFraction> places;
  for (const MFactor& factor : factor(den).second)
    if (degree(factor.base, z) == 1) {
      const auto c = coefficients(factor.base, z);
      places.push_back(-MFraction(c[0], c[1]));
    }
  return places;
}

// The even part; nothing if there are odd terms.
std::optional<Polynomial> halved(const Polynomial& p) {
  Polynomial even;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i % 2 == 1 && !is_zero(p[i])) return std::nullopt;
    if (i % 2 == 0) even.push_back(p[i]);
  }
  return even;
}

// rho/(4w) - 3/(16 w^2) for r(z) = rho((z-c)^2): (4 w N - 3 D)/(16 w^2 D).
std::optional<FractionInZ> in_the_square(const FractionInZ& r, const MFraction& c) {
  const auto num = halved(shifted(r.num, c));
  const auto den = halved(shifted(r.den, c));
  if (!num || !den) return std::nullopt;
  const MFraction zero(c.ring());
  const MFraction one(c.ring(), Rational(1));
  FractionInZ w{sum(product(Polynomial{zero, Rational(4) * one}, *num), *den, Rational(-3)),
                product(Polynomial{zero, zero, Rational(16) * one}, *den)};
  w.num = trimmed(std::move(w.num));
  while (!w.num.empty() && is_zero(w.num.front()) && is_zero(w.den.front())) {
    w.num.erase(w.num.begin());
    w.den.erase(w.den.begin());
  }
  return w;
}

// A rational function of w back as an element of the ring, z in the place of w.
MFraction assembled(const FractionInZ& r, const Ring& ring, std::size_t z) {
  const MFraction w = MFraction::variable(ring, z);
  const auto value = [&](const Polynomial& p) {
    MFraction sum(ring);
    for (std::size_t i = p.size(); i-- > 0;)
      sum = sum * w + p[i];
    return sum;
  };
  return value(r.num) / value(r.den);
}

} // namespace

std::optional<LameFamilyForm> recognize_lame(const MFraction& r, std::size_t z,
                                             const Budget& budget) {
  if (is_zero(r)) return std::nullopt;
  budget.check();
  constexpr long largest = 18; // four double places in the square, and its own 0
  if (degree(r.num(), z) > largest || degree(r.den(), z) > largest) return std::nullopt;
  const FractionInZ direct{in_z(r.num(), z), in_z(r.den(), z)};
  const MFraction x = MFraction::variable(r.ring(), z);
  if (auto form = LameRecognizer(r, z).try_all(direct, rational_places(r.den(), z), x)) return form;
  const Polynomial& d = direct.den;
  if (d.size() < 2) return std::nullopt;
  const MFraction centre =
      Rational(-1, static_cast<long>(d.size()) - 1) * (d[d.size() - 2] / d.back());
  const auto squared = in_the_square(direct, centre);
  if (!squared) return std::nullopt;
  budget.check();
  const MFraction rho = assembled(*squared, r.ring(), z);
  LameRecognizer recognizer(r, z);
  recognizer.note(centre.den());
  auto form = recognizer.try_all({in_z(rho.num(), z), in_z(rho.den(), z)},
                                 rational_places(rho.den(), z), pow(x - centre, 2));
  if (form) form->squared = true;
  return form;
}

} // namespace kov
