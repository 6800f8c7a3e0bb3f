#include "elementary/homogeneous.hpp"

#include "elementary/antiderivative.hpp"
#include "elementary/rational_integral.hpp"
#include "exact/tried.hpp"
#include "galois/exponential_form.hpp"

namespace kov::elementary {
namespace {

Element of(const LettersPtr& letters, const MFraction& f) { return {letters, f}; }

// f exp(+- g), or f cos(g') and f sin(g') for g^2 = -g'^2; discriminant: of the characteristic equation.
Basis by_discriminant(const Element& centre, const Element& variable,
                      const MFraction& discriminant) {
  const LettersPtr& letters = centre.letters();
  const MFraction half = letters->number(Rational(1, 2));
  const Element f = exp(centre);
  if (is_zero(discriminant)) return {f, f * variable};
  if (sample(discriminant, *letters) > 0) {
    const Element g = half * letters->root(discriminant) * variable;
    return {exp(centre + g), exp(centre - g)};
  }
  const Element g = half * letters->root(-discriminant) * variable;
  return {f * cos(g), f * sin(g)};
}

/// re + im i, where i^2 = -1.
struct Complex {
  MFraction re, im;
};

/// Q or Q(sqrt d) with rational functions over it as pairs.
class FieldValues {
public:
  FieldValues(const Field& k, const LettersPtr& letters)
      : letters_(letters), re_(letters->number(0)), im_(re_) {
    if (k->degree() == 1) return;
    if (k->degree() > 2) throw NotElementary("a large field");
    const auto m = k->minpoly_coefficients();
    const Rational b(m[1]), d = b * b - Rational(4) * Rational(m[0]);
    const ComplexBall a = k->generator(64);
    const MFraction half = letters->number(Rational(1, 2));
    re_ = letters->number(-b / Rational(2));
    if (sign(d) < 0) {
      im_ = half * letters->root(letters->number(-d));
      if (arb_is_negative(acb_imagref(a.raw())) != 0) im_ = -im_;
      return;
    }
    const MFraction root = half * letters->root(letters->number(d));
    Ball centre;
    arb_set_fmpq(centre.raw(), (-b / Rational(2)).raw(), 64);
    re_ = re_ + (arb_lt(acb_realref(a.raw()), centre.raw()) != 0 ? -root : root);
  }

  [[nodiscard]] Complex operator()(const NfElem& e) const {
    const MFraction c0 = letters_->number(e.coeff(0));
    if (e.field()->degree() == 1) return {c0, letters_->number(0)};
    const MFraction c1 = letters_->number(e.coeff(1));
    return {c0 + c1 * re_, c1 * im_};
  }
  [[nodiscard]] Complex operator()(const Poly& p) const {
    Complex sum{letters_->number(0), letters_->number(0)};
    for (long i = 0; i <= degree(p); ++i) {
      const Complex c = (*this)(p.coeff(i));
      const MFraction power = pow(letters_->variable_value(), i);
      sum = {sum.re + c.re * power, sum.im + c.im * power};
    }
    return sum;
  }
  [[nodiscard]] Complex operator()(const RationalFunction& f) const {
    const Complex a = (*this)(f.num()), b = (*this)(f.den());
    const MFraction norm = letters_->reduced(b.re * b.re + b.im * b.im);
    return {letters_->reduced((a.re * b.re + a.im * b.im) / norm),
            letters_->reduced((a.im * b.re - a.re * b.im) / norm)};
  }

private:
  LettersPtr letters_;
  MFraction re_, im_; // of the generator
};

/// y = re + i im
struct ComplexElement {
  Element re, im;
};

// P exp(int theta)
ComplexElement exponential(const Poly& p, const RationalFunction& theta,
                           const LettersPtr& letters) {
  const LogarithmicParts parts = logarithmic_parts(theta);
  const FieldValues value(common_field(theta.field(), p.field()), letters);
  const Complex r = value(parts.rational_part), top = value(p);
  Element size = of(letters, r.re), angle = of(letters, r.im);
  for (const auto& [q, rho] : parts.residues) {
    if (degree(rho) > 0) throw NotElementary("conjugate residues");
    const Complex base = value(q), c = value(rho.coeff(0));
    if (!is_zero(base.im)) throw NotElementary("a complex place");
    const Element ell = log(of(letters, base.re));
    size += c.re * ell;
    angle += c.im * ell;
  }
  const Element e = exp(size);
  if (is_zero(angle)) return {of(letters, top.re) * e, of(letters, top.im) * e};
  const Element c = e * cos(angle), s = e * sin(angle);
  return {top.re * c - top.im * s, top.re * s + top.im * c};
}

Element real(const ComplexElement& y) {
  if (!is_zero(y.im)) throw NotElementary("a complex solution");
  return y.re;
}

Basis found_basis(const Classification& c, const std::vector<LiouvillianSolution>& found,
                  const RationalFunction& gauge, const LettersPtr& letters) {
  const auto with_gauge = [&](const RationalFunction& theta) {
    const Field& k = common_field(theta.field(), gauge.field());
    return coerce(theta, k) + coerce(gauge, k);
  };
  if (!found.empty() && found[0].exponential) {
    const ExponentialSolution& y = *found[0].exponential;
    const ComplexElement one = exponential(y.p, with_gauge(y.theta), letters);
    if (found.size() == 2 && !is_zero(one.im)) return {one.re, one.im};
    const Element first = real(one);
    if (found.size() == 2)
      return {first, real(exponential(found[1].exponential->p,
                                      with_gauge(found[1].exponential->theta), letters))};
    const Element w = real(exponential(Poly(1), RationalFunction(2) * gauge, letters));
    return {first, first * integral(w / (first * first))};
  }
  if (!c.pair) throw NotElementary("no exponential");
  // sqrt(v) exp(+- w/2 int 1/v)
  const FieldValues value(common_field(c.pair->v.field(), c.pair->w_squared.field()), letters);
  const Complex v = value(c.pair->v), w = value(c.pair->w_squared);
  if (!is_zero(v.im) || !is_zero(w.im)) throw NotElementary("a complex product");
  const auto inverse = antiderivative(of(letters, letters->number(1) / v.re));
  if (!inverse) throw NotElementary("an integral in an exponent");
  const Element front = power(of(letters, v.re), letters->number(Rational(1, 2))) *
                        real(exponential(Poly(1), gauge, letters));
  const Basis both = by_discriminant(Element(letters), *inverse, w.re);
  return {front * both.first, front * both.second};
}

} // namespace

std::optional<Basis> characteristic_basis(const MFraction& p, const MFraction& q,
                                          const LettersPtr& letters) {
  return tried<NotElementary>([&]() -> std::optional<Basis> {
    const MFraction x = letters->variable_value(), four = letters->number(4),
                    half = letters->number(Rational(1, 2));
    if (!uses(p, Letters::x) && !uses(q, Letters::x))
      return by_discriminant(of(letters, -half * p * x), of(letters, x),
                             letters->reduced(p * p - four * q));
    const MFraction b = p * x - letters->number(1), c = q * x * x; // m^2 + b m + c = 0
    if (uses(b, Letters::x) || uses(c, Letters::x)) return std::nullopt;
    const Element ell = log(of(letters, x));
    return by_discriminant(-half * b * ell, ell, letters->reduced(b * b - four * c));
  });
}

std::optional<Basis> basis_from(const Classification& c,
                                const std::vector<LiouvillianSolution>& found,
                                const RationalFunction& gauge, const LettersPtr& letters) {
  return tried<NotElementary, InvalidArgument, DomainError>(
      [&] { return std::optional(found_basis(c, found, gauge, letters)); });
}

} // namespace kov::elementary
