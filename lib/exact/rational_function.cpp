#include "exact/rational_function.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

bool is_monic(const Poly& f) {
  const fmpq_poly_struct* flat = f.raw();
  return fmpq_poly_degree(flat) == degree(f) * f.stride() &&
         fmpz_equal(flat->coeffs + flat->length - 1, flat->den) != 0;
}

// f/d for d | f
Poly without(const Poly& f, const Poly& d) { return degree(d) == 0 ? f : exact_div(f, d); }

} // namespace

RationalFunction::RationalFunction(const Poly& num, const Poly& den) {
  if (is_zero(den)) throw DomainError("division by the zero function");
  if (is_zero(num)) {
    const Field& k = common_field(num.field(), den.field());
    num_ = Poly(k);
    den_ = coerce(Poly(1), k);
    return;
  }
  const Poly g = gcd(num, den);
  *this = from_coprime(without(num, g), without(den, g));
}

RationalFunction RationalFunction::from_coprime(Poly num, Poly den) {
  const Field k = common_field(num.field(), den.field());
  if (num.field() != k) num = coerce(num, k);
  if (is_zero(num)) return RationalFunction(std::move(num));
  if (den.field() != k) den = coerce(den, k);
  if (!is_monic(den)) {
    num = scale(num, inverse(lead(den)));
    den = monic(den);
  }
  RationalFunction f(std::move(num));
  f.den_ = std::move(den);
  return f;
}

// Henrici's rules: gcds of the given numerators and denominators only, never of their products.
RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  if (is_one(a.den_) && is_one(b.den_)) return RationalFunction(a.num_ + b.num_);
  if (a.den_ == b.den_) return {a.num_ + b.num_, a.den_};
  const Poly g = gcd(a.den_, b.den_);
  if (degree(g) == 0)
    return RationalFunction::from_coprime(a.num_ * b.den_ + b.num_ * a.den_, a.den_ * b.den_);
  const Poly a_rest = exact_div(a.den_, g);
  const Poly num = a.num_ * exact_div(b.den_, g) + b.num_ * a_rest;
  if (is_zero(num)) return {num, g};
  const Poly common = gcd(num, g); // whatever cancels, cancels against g
  if (degree(common) == 0) return RationalFunction::from_coprime(num, a_rest * b.den_);
  return RationalFunction::from_coprime(exact_div(num, common), a_rest * exact_div(b.den_, common));
}

RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return a + -b; }

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  if (is_zero(a.num_) || is_zero(b.num_) || (is_one(a.den_) && is_one(b.den_)))
    return RationalFunction(a.num_ * b.num_);
  const Poly g = gcd(a.num_, b.den_);
  const Poly h = gcd(b.num_, a.den_);
  return RationalFunction::from_coprime(without(a.num_, g) * without(b.num_, h),
                                        without(a.den_, h) * without(b.den_, g));
}

RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  if (is_zero(b.num_)) throw DomainError("division by the zero function");
  return a * RationalFunction::from_coprime(b.den_, b.num_);
}

RationalFunction operator-(RationalFunction a) {
  a.num_ = -a.num_;
  return a;
}

// A pole of order k becomes one of order k+1: den times its squarefree part is the denominator.
RationalFunction derivative(const RationalFunction& f) {
  if (is_one(f.den())) return RationalFunction(derivative(f.num()));
  const Poly slope = derivative(f.den());
  const Poly multiple = gcd(f.den(), slope);
  const Poly squarefree = without(f.den(), multiple);
  return RationalFunction::from_coprime(
      derivative(f.num()) * squarefree - f.num() * without(slope, multiple), f.den() * squarefree);
}

RationalFunction pow(const RationalFunction& f, long e) {
  if (e < 0) return pow(RationalFunction(1) / f, -e);
  const auto n = static_cast<unsigned long>(e);
  return RationalFunction::from_coprime(pow(f.num(), n), pow(f.den(), n));
}

RationalFunction compose(const RationalFunction& f, const RationalFunction& g) {
  // f(g) = (sum n_i N^i D^(d-i)) / (sum d_i N^i D^(d-i)), homogenised to the larger degree
  const long d = std::max(degree(f.num()), degree(f.den()));
  const auto homogeneous = [&](const Poly& p) {
    Poly sum(common_field(p.field(), g.field()));
    Poly power(1); // D^(d-i)
    for (long i = d; i >= 0; --i) {
      sum = sum * g.num() + power * Poly(p.coeff(i));
      power *= g.den();
    }
    return sum;
  };
  return {homogeneous(f.num()), homogeneous(f.den())};
}

RationalFunction coerce(const RationalFunction& f, const Field& k) {
  if (f.field() == k) return f;
  return {coerce(f.num(), k), coerce(f.den(), k)};
}

long order_at_infinity(const RationalFunction& f) {
  KOV_ENSURE(!is_zero(f));
  return degree(f.den()) - degree(f.num());
}

namespace {

// A common denominator of what is shown.
Integer shown_denominator(const Poly& f) {
  Integer common(1);
  if (f.stride() == 1) {
    fmpz_set(common.raw(), fmpq_poly_denref(f.raw()));
    return common;
  }
  for (long i = 0; i <= degree(f); ++i)
    for (const Rational& c : shown_coefficients(f.coeff(i)))
      common = lcm(common, c.den());
  return common;
}

} // namespace

std::string to_string(const RationalFunction& f, const std::string& variable) {
  // Without denominators in what is shown; den is monic, so that no common factor is left.
  const Integer common = lcm(shown_denominator(f.num()), shown_denominator(f.den()));
  const auto shown = [&](const Poly& p) {
    return to_string(common == Integer(1) ? p : scale(p, NfElem(Rational(common))), variable);
  };
  const std::string top = shown(f.num());
  if (is_one(f.den()) && common == Integer(1)) return top;
  const std::string bottom = shown(f.den());
  const auto wrap = [](const std::string& s, const char* marks) {
    return s.find_first_of(marks, 1) != std::string::npos ? "(" + s + ")" : s;
  };
  return wrap(top, " ") + "/" + wrap(bottom, " */");
}

} // namespace kov
