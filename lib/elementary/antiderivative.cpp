#include "elementary/antiderivative.hpp"

#include "elementary/check.hpp"
#include "elementary/rational_integral.hpp"
#include "elementary/split_root.hpp"
#include "elementary/trig_form.hpp"
#include "elementary/undetermined.hpp"
#include "exact/tried.hpp"

#include <algorithm>
#include <functional>

namespace kov::elementary {
namespace {

using Trig = Monomial::Trig;
using Name = Kernel::Name;

MFraction letter(const LettersPtr& letters, std::size_t i) {
  return MFraction::variable(letters->ring(), i);
}

// int f(u) du at u = g; f has `sine` or `cosine` for u.
std::optional<Element> by_substitution(const MFraction& f, std::size_t u, const Element& g,
                                       bool near_zero) {
  const LettersPtr& letters = g.letters();
  const auto inner =
      rational_integral(substitute(f, {{u, letters->variable_value()}}), letters, near_zero);
  if (!inner) return std::nullopt;
  return compose(*inner, g);
}

// p(-x) = +-p(x)?
bool is_even_or_odd(const MPoly& p, std::size_t i) {
  const auto c = coefficients(p, i);
  for (std::size_t k = 1; k < c.size(); k += 2) // below the highest one
    if (!is_zero(c[c.size() - 1 - k])) return false;
  return true;
}

// int f(cos h) dh.  f = E(c^2) + c O(c^2) with a denominator in c^2: the integrals of O(1 - u^2) at u = sin h and of
// E(1/(1 + u^2))/(1 + u^2) at u = tan h; others at u = tan(h/2).
std::optional<Element> of_cosine(const MFraction& f, const Element& h) {
  const LettersPtr& letters = h.letters();
  const MFraction one = letters->number(1), two = letters->number(2),
                  u = letter(letters, Letters::sine);
  if (!is_even_or_odd(f.den(), Letters::cosine)) {
    const Element half = (one / two) * h;
    const MFraction c = (one - u * u) / (one + u * u);
    return by_substitution(two * substitute(f, {{Letters::cosine, c}}) / (one + u * u),
                           Letters::sine, sin(half) / cos(half), false);
  }
  const auto [even, odd] = split_root(f, Letters::cosine, u);
  const auto a =
      by_substitution(substitute(odd, {{Letters::sine, one - u * u}}), Letters::sine, sin(h), true);
  const auto b =
      by_substitution(substitute(even, {{Letters::sine, one / (one + u * u)}}) / (one + u * u),
                      Letters::sine, sin(h) / cos(h), false);
  if (!a || !b) return std::nullopt;
  return *a + *b;
}

// With h' = rate: f(cos h), and g(cos h) sin h by u = cos h.
std::optional<Element> of_sine_and_cosine(const Element& f) {
  const LettersPtr& letters = f.letters();
  const auto form = trig_form(f);
  if (!form || form->parts.size() != 1) return std::nullopt;
  const auto& [key, part] = *form->parts.begin();
  const auto rate = derivative(form->angle).rational();
  if (!key.empty() || !rate || uses(*rate, Letters::x) || uses(part.even, Letters::x) ||
      uses(part.odd, Letters::x))
    return std::nullopt;
  const auto a = by_substitution(-part.odd, Letters::cosine, cos(form->angle), true);
  const auto b = of_cosine(part.even, form->angle);
  if (!a || !b) return std::nullopt;
  return (letters->number(1) / *rate) * (*a + *b);
}

/// f as a rational function of one letter: `degree` is the power of u that a monomial without 1/v is.
std::optional<MFraction>
rational_in(const Element& f, const std::function<std::optional<long>(const Monomial&)>& degree) {
  const LettersPtr& letters = f.letters();
  MFraction sum = letters->number(0);
  for (const auto& [key, t] : f.terms()) {
    Monomial m = *t.monomial;
    MFraction value = t.coefficient;
    std::vector<Monomial::KernelPower> others;
    for (const auto& k : m.kernels) {
      if (k.kernel->name != Name::inverse) {
        others.push_back(k);
        continue;
      }
      const auto below = rational_in(k.kernel->argument, degree);
      if (!below || is_zero(*below)) return std::nullopt;
      value = value / pow(*below, k.power);
    }
    m.kernels = others;
    const auto n = degree(m);
    if (!n) return std::nullopt;
    sum += value * pow(letter(letters, Letters::cosine), *n);
  }
  return letters->reduced(sum);
}

// The first of all exponents, also inside of 1/u.
std::optional<Element> an_exponent(const Element& f) {
  for (const auto& [key, t] : f.terms()) {
    if (!is_zero(t.monomial->exponent)) return t.monomial->exponent;
    for (const auto& k : t.monomial->kernels)
      if (auto inside = an_exponent(k.kernel->argument)) return inside;
  }
  return std::nullopt;
}

std::optional<Element> of_exponential(const Element& f) {
  const LettersPtr& letters = f.letters();
  const auto first = an_exponent(f);
  if (!first) return std::nullopt;
  for (const long part : {1, 2, 3}) { // of the first exponent
    const Element g = letters->number(Rational(1, part)) * *first;
    const auto rate = derivative(g).rational();
    if (!rate || uses(*rate, Letters::x)) return std::nullopt;
    const auto r = rational_in(f, [&](const Monomial& m) -> std::optional<long> {
      if (m.trig != Trig::none || !m.powers.empty() || !m.kernels.empty()) return std::nullopt;
      if (is_zero(m.exponent)) return 0;
      const auto n = ratio(m.exponent, g);
      if (!n || !is_integer(*n) || abs(*n) > Rational(40)) return std::nullopt;
      return to_long(n->num());
    });
    if (!r || uses(*r, Letters::x)) continue;
    const MFraction u = letter(letters, Letters::cosine);
    return by_substitution(*r / (*rate * u), Letters::cosine, exp(g), false);
  }
  return std::nullopt;
}

std::optional<Element> of_logarithm(const Element& f) {
  const LettersPtr& letters = f.letters();
  const Element x(letters, letters->variable_value()), ell = log(x);
  const std::string name = ell.terms().begin()->second.monomial->kernels.front().text;
  const auto r = rational_in(f, [&](const Monomial& m) -> std::optional<long> {
    if (m.trig != Trig::none || !m.powers.empty() || !is_zero(m.exponent) || m.kernels.size() > 1)
      return std::nullopt;
    if (m.kernels.empty()) return 0;
    if (m.kernels.front().text != name) return std::nullopt;
    return m.kernels.front().power;
  });
  if (!r) return std::nullopt;
  const MFraction inside = *r * letters->variable_value();
  if (uses(inside, Letters::x)) return std::nullopt;
  return by_substitution(inside, Letters::cosine, ell, false);
}

// int R(x) sqrt(Q) for a polynomial Q = A x^2 + B x + C, by a function u of x and sqrt(Q) of which both are rational
// functions (Euler).
std::optional<Element> of_square_root(const Element& f) {
  const LettersPtr& letters = f.letters();
  const auto& [m, r] = f.terms().begin()->second;
  const MFraction one = letters->number(1), two = letters->number(2), half = one / two,
                  u = letter(letters, Letters::cosine), x = letters->variable_value();
  MPoly q(letters->ring(), Integer(1));
  for (const auto& [base, e] : m->powers) {
    if (!(e == half)) return std::nullopt;
    q *= base;
  }
  const auto c = coefficients(q, Letters::x);
  if (f.terms().size() != 1 || c.size() < 2 || c.size() > 3) return std::nullopt;
  const Element root = power(Element(letters, MFraction(q)), half);
  MFraction at = one, root_at = u; // x and sqrt(Q) as functions of u
  Element value = root;
  if (c.size() == 2) {
    at = (u * u - MFraction(c[0])) / MFraction(c[1]);
  } else if (sample(MFraction(c[2]), *letters) > 0) {
    const MFraction s = letters->root(MFraction(c[2]));
    at = (u * u - MFraction(c[0])) / (MFraction(c[1]) + two * s * u);
    root_at = u - s * at;
    value = root + Element(letters, s * x);
  } else if (m->powers.size() == 2) {
    const auto p = coefficients(m->powers[0].base, Letters::x),
               d = coefficients(m->powers[1].base, Letters::x);
    at = (MFraction(d[0]) * u * u - MFraction(p[0])) / (MFraction(p[1]) - MFraction(d[1]) * u * u);
    root_at = u * (MFraction(d[1]) * at + MFraction(d[0]));
    value = root / Element(letters, MFraction(m->powers[1].base));
  } else {
    const MFraction s = letters->root(MFraction(c[0]));
    at = (two * s * u - MFraction(c[1])) / (MFraction(c[2]) - u * u);
    root_at = at * u + s;
    value = (root - Element(letters, s)) / Element(letters, x);
  }
  const MFraction there =
      substitute(r, {{Letters::x, at}}) * root_at * derivative(at, Letters::cosine);
  return by_substitution(letters->reduced(there), Letters::cosine, value, false);
}

// Terms with rational derivatives.
std::optional<Element> of_plain(const Element& f) {
  const LettersPtr& letters = f.letters();
  const std::vector<MFraction> derivative{letters->number(0), letters->number(1)};
  if (auto all = undetermined(derivative, f)) return all;
  Element sum(letters);
  for (const auto& [key, t] : f.terms()) {
    Element one(letters);
    one.add(*t.monomial, t.coefficient);
    const bool root = t.monomial->trig == Trig::none && is_zero(t.monomial->exponent) &&
                      t.monomial->kernels.empty();
    auto part = f.terms().size() > 1 ? undetermined(derivative, one) : std::nullopt;
    if (!part && root) part = of_square_root(one);
    if (!part) return std::nullopt;
    sum += *part;
  }
  return sum;
}

std::optional<Element> found(const Element& f) {
  const LettersPtr& letters = f.letters();
  Element rational(letters), plain(letters), others(letters);
  for (const auto& [key, t] : f.terms())
    (key.empty()                             ? rational
     : has_rational_derivatives(*t.monomial) ? plain
                                             : others)
        .add(*t.monomial, t.coefficient);
  Element sum(letters);
  if (const auto r = rational.rational(); !is_zero(*r)) {
    auto part = rational_integral(*r, letters);
    if (!part) return std::nullopt;
    sum += *part;
  }
  if (!is_zero(plain)) {
    const auto part = of_plain(plain);
    if (!part) return std::nullopt;
    sum += *part;
  }
  if (is_zero(others)) return sum;
  auto part = of_sine_and_cosine(others);
  if (!part) part = of_exponential(others);
  if (!part) part = of_logarithm(others);
  if (!part) return std::nullopt;
  return sum + *part;
}

} // namespace

std::optional<Element> antiderivative(const Element& f) {
  if (is_zero(f)) return f;
  auto y = tried<NotElementary, DomainError>([&] { return found(f); });
  return y && is_derivative_at_points(*y, f) ? y : std::nullopt;
}

Element integral(const Element& f) {
  if (const auto y = antiderivative(f)) return *y;
  const bool minus = sign(f.terms().begin()->second.coefficient.num().coefficient(0)) < 0;
  return minus ? -unevaluated_integral(-f) : unevaluated_integral(f);
}

} // namespace kov::elementary
