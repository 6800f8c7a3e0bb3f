#include "exact/error.hpp"
#include "exact/meter.hpp"
#include "exact/multivariate.hpp"
#include "exact/quick_size.hpp"
#include "exact/to_poly.hpp"

#include <algorithm>

namespace kov {

/// The one door to the C struct, so that the free operators below need no friend list of their own.
class MFractionAccess {
public:
  static kov_mpoly_q* raw(MFraction& f) { return &f.v_; }
};

namespace {

// Measured, in units of the meter (docs/theory/work.md): for the gcds more than for the products.
constexpr double units_per_operand_term = 10;

using Binary = void (*)(kov_mpoly_q*, const kov_mpoly_q*, const kov_mpoly_q*,
                        const fmpz_mpoly_ctx_t);

MFraction combine(const MFraction& a, const MFraction& b, Binary op) {
  if (a.ring() != b.ring())
    throw InvalidArgument("two multivariate values from different rings cannot be combined");
  MFraction r(a.ring());
  const auto* ctx = r.ring()->ctx();
  charge(units_per_operand_term * (quick_size(&a.raw()->num) + quick_size(&a.raw()->den) +
                                   quick_size(&b.raw()->num) + quick_size(&b.raw()->den)));
  op(MFractionAccess::raw(r), a.raw(), b.raw(), ctx);
  if (fmpz_mpoly_degrees_fit_si(&r.raw()->num, ctx) == 0 ||
      fmpz_mpoly_degrees_fit_si(&r.raw()->den, ctx) == 0)
    throw DomainError("the exponents of a rational function are too large");
  return r;
}

} // namespace

MFraction::MFraction(Ring ring) : ring_(std::move(ring)) {
  if (ring_) kov_mpoly_q_init(&v_, ring_->ctx());
}
MFraction::MFraction(Ring ring, const Rational& c) : MFraction(std::move(ring)) {
  fmpz_mpoly_set_fmpz(&v_.num, fmpq_numref(c.raw()), ring_->ctx());
  fmpz_mpoly_set_fmpz(&v_.den, fmpq_denref(c.raw()), ring_->ctx());
}
MFraction::MFraction(const MPoly& num) : MFraction(num.ring()) {
  if (ring_) fmpz_mpoly_set(&v_.num, num.raw(), ring_->ctx());
}
MFraction::MFraction(const MPoly& num, const MPoly& den) : MFraction(den.ring()) {
  if (is_zero(den)) throw DomainError("division by the zero function");
  if (num.ring() && num.ring() != den.ring())
    throw InvalidArgument("two multivariate values from different rings cannot be combined");
  if (num.ring()) fmpz_mpoly_set(&v_.num, num.raw(), ring_->ctx());
  fmpz_mpoly_set(&v_.den, den.raw(), ring_->ctx());
  kov_mpoly_q_canonicalise(&v_, ring_->ctx());
}
MFraction::MFraction(const MFraction& o) : MFraction(o.ring_) {
  if (ring_) kov_mpoly_q_set(&v_, &o.v_, ring_->ctx());
}
MFraction::MFraction(MFraction&& o) noexcept : ring_(std::move(o.ring_)) { std::swap(v_, o.v_); }
MFraction& MFraction::operator=(MFraction o) noexcept {
  ring_.swap(o.ring_);
  std::swap(v_, o.v_);
  return *this;
}
MFraction::~MFraction() {
  if (ring_) kov_mpoly_q_clear(&v_, ring_->ctx());
}

MFraction MFraction::variable(const Ring& ring, std::size_t i) {
  return {MPoly::variable(ring, i)};
}
MFraction MFraction::variable(const Ring& ring, std::string_view name) {
  return {MPoly::variable(ring, name)};
}

MPoly MFraction::num() const {
  MPoly f(ring_);
  if (ring_) fmpz_mpoly_set(f.raw(), &v_.num, ring_->ctx());
  return f;
}
MPoly MFraction::den() const {
  KOV_ENSURE(ring_ != nullptr);
  MPoly f(ring_);
  fmpz_mpoly_set(f.raw(), &v_.den, ring_->ctx());
  return f;
}

MFraction operator+(const MFraction& a, const MFraction& b) {
  if (!a.ring_ || !b.ring_) return a.ring_ ? a : b;
  return combine(a, b, kov_mpoly_q_add);
}
MFraction operator-(const MFraction& a, const MFraction& b) {
  if (!b.ring_) return a;
  if (!a.ring_) return -b;
  return combine(a, b, kov_mpoly_q_sub);
}
MFraction operator*(const MFraction& a, const MFraction& b) {
  if (!a.ring_ || !b.ring_) return MFraction(a.ring_ ? a.ring_ : b.ring_);
  return combine(a, b, kov_mpoly_q_mul);
}
MFraction operator/(const MFraction& a, const MFraction& b) {
  if (is_zero(b)) throw DomainError("division by the zero function");
  if (!a.ring_) return MFraction(b.ring_);
  return combine(a, b, kov_mpoly_q_div);
}
MFraction operator-(const MFraction& a) {
  MFraction r(a.ring_);
  if (r.ring_) kov_mpoly_q_neg(&r.v_, &a.v_, r.ring_->ctx());
  return r;
}
MFraction operator*(const Rational& c, const MFraction& a) {
  return a.ring_ ? MFraction(a.ring_, c) * a : a;
}
bool operator==(const MFraction& a, const MFraction& b) {
  if (!a.ring_ || !b.ring_) return is_zero(a) && is_zero(b);
  if (a.ring_ != b.ring_) return false;
  return fmpz_mpoly_equal(&a.v_.num, &b.v_.num, a.ring_->ctx()) != 0 &&
         fmpz_mpoly_equal(&a.v_.den, &b.v_.den, a.ring_->ctx()) != 0;
}

bool is_zero(const MFraction& f) {
  return !f.ring() || fmpz_mpoly_is_zero(&f.raw()->num, f.ring()->ctx()) != 0;
}
bool is_one(const MFraction& f) {
  return f.ring() && fmpz_mpoly_is_one(&f.raw()->num, f.ring()->ctx()) != 0 &&
         fmpz_mpoly_is_one(&f.raw()->den, f.ring()->ctx()) != 0;
}
bool is_constant(const MFraction& f) {
  return !f.ring() || (is_constant(f.num()) && is_constant(f.den()));
}
Rational to_rational(const MFraction& f) {
  KOV_ENSURE(is_constant(f));
  if (is_zero(f)) return {};
  return {f.num().coefficient(0), f.den().coefficient(0)};
}

MFraction pow(const MFraction& f, long e) {
  if (!f.ring()) return f;
  if (e < 0) {
    if (is_zero(f)) throw DomainError("division by the zero function");
    return {pow(f.den(), static_cast<unsigned long>(-e)),
            pow(f.num(), static_cast<unsigned long>(-e))};
  }
  return {pow(f.num(), static_cast<unsigned long>(e)), pow(f.den(), static_cast<unsigned long>(e))};
}

MFraction derivative(const MFraction& f, std::size_t i) {
  if (!f.ring()) return f;
  const MPoly n = f.num();
  const MPoly d = f.den();
  if (!uses(d, i)) return {derivative(n, i), d};
  return {derivative(n, i) * d - n * derivative(d, i), d * d};
}

bool uses(const MFraction& f, std::size_t i) {
  return f.ring() && (uses(f.num(), i) || uses(f.den(), i));
}
std::vector<std::size_t> used_variables(const MFraction& f) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; f.ring() && i < f.ring()->size(); ++i)
    if (uses(f, i)) used.push_back(i);
  return used;
}

// Each replaced variable x_i = n_i/d_i is made homogeneous: with e_i the degree of f in x_i,
// f = (sum over terms of c * rest * prod n_i^a_i d_i^(e_i - a_i)) / prod d_i^e_i.
MFraction substitute(const MPoly& f, const Substitution& values) {
  if (!f.ring()) return {};
  const Ring& ring = f.ring();
  std::map<std::size_t, std::vector<MPoly>> blocks; // n^a d^(e-a) for a = 0..e
  MPoly bottom(ring, Integer(1));
  for (const auto& [i, value] : values) {
    const long e = degree(f, i);
    if (e <= 0) continue;
    const MPoly n = value.ring() ? value.num() : MPoly(ring);
    const MPoly d = value.ring() ? value.den() : MPoly(ring, Integer(1));
    auto& block = blocks[i];
    for (long a = 0; a <= e; ++a)
      block.push_back(pow(n, static_cast<unsigned long>(a)) *
                      pow(d, static_cast<unsigned long>(e - a)));
    bottom *= pow(d, static_cast<unsigned long>(e));
  }
  if (blocks.empty()) return {f};
  std::map<std::vector<unsigned long>, MPoly> groups; // by the exponents of the replaced variables
  for (long t = 0; t < f.length(); ++t) {
    auto rest = f.exponents(t);
    std::vector<unsigned long> key;
    for (const auto& [i, block] : blocks) {
      key.push_back(rest[i]);
      rest[i] = 0;
    }
    groups[key] += MPoly::term(ring, f.coefficient(t), rest);
  }
  MPoly top(ring);
  for (const auto& [key, coefficient] : groups) {
    MPoly product = coefficient;
    std::size_t k = 0;
    for (const auto& [i, block] : blocks)
      product *= block[key[k++]];
    top += product;
  }
  return {top, bottom};
}

MFraction substitute(const MFraction& f, const Substitution& values) {
  if (!f.ring()) return f;
  return substitute(f.num(), values) / substitute(f.den(), values);
}

namespace {

MPoly transfer(const MPoly& f, const Ring& ring) {
  MPoly g(ring);
  std::vector<std::optional<std::size_t>> place(f.ring()->size());
  for (const std::size_t i : used_variables(f))
    place[i] = ring->index(f.ring()->name(i));
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    std::vector<unsigned long> exponents(ring->size());
    for (std::size_t i = 0; i < e.size(); ++i)
      if (e[i] > 0) exponents[*place[i]] = e[i];
    fmpz_mpoly_push_term_fmpz_ui(g.raw(), f.coefficient(t).raw(), exponents.data(), g.ctx());
  }
  fmpz_mpoly_sort_terms(g.raw(), g.ctx());
  return g;
}

} // namespace

MFraction transfer(const MFraction& f, const Ring& ring) {
  if (!f.ring()) return MFraction(ring);
  if (f.ring() == ring) return f;
  return {transfer(f.num(), ring), transfer(f.den(), ring)};
}

namespace {

std::string quotient_text(const std::string& top, const std::string& bottom) {
  const auto wrap = [](const std::string& s, const char* marks) {
    return s.find_first_of(marks, 1) != std::string::npos ? "(" + s + ")" : s;
  };
  return bottom == "1" ? top : wrap(top, " ") + "/" + wrap(bottom, " */");
}

// Adds one term to a sum.
void append(std::string& sum, const std::string& term) {
  if (sum.empty())
    sum = term;
  else
    sum += term.front() == '-' ? " - " + term.substr(1) : " + " + term;
}

std::string by_powers(const MPoly& f, std::size_t variable) {
  const std::vector<MPoly> c = coefficients(f, variable);
  std::string sum;
  for (std::size_t i = c.size(); i-- > 0;) {
    if (is_zero(c[i])) continue;
    std::string term = to_string(c[i]);
    if (i > 0) {
      const std::string& name = f.ring()->name(variable);
      const std::string power = i == 1 ? name : name + "^" + std::to_string(i);
      if (term.find(' ') != std::string::npos) term = "(" + term + ")";
      term = term == "1" ? power : term == "-1" ? "-" + power : term + "*" + power;
    }
    append(sum, term);
  }
  return sum;
}

} // namespace

std::string to_string(const MFraction& f) {
  return is_zero(f) ? "0" : quotient_text(to_string(f.num()), to_string(f.den()));
}

std::string to_string_by_powers(const MFraction& f, std::size_t variable) {
  if (is_zero(f)) return "0";
  const std::string bottom = by_powers(f.den(), variable);
  if (bottom.front() != '-') return quotient_text(by_powers(f.num(), variable), bottom);
  return quotient_text(by_powers(-f.num(), variable), by_powers(-f.den(), variable));
}

namespace {

// content * prod base^exponent; the sign stands in front
std::string factored(const MPoly& f) {
  const auto [content, factors] = factor(f);
  std::string s;
  for (const auto& [base, exponent] : factors) {
    std::string text = to_string(base);
    if (text.find(' ') != std::string::npos) text = "(" + text + ")";
    s += (s.empty() ? "" : "*") + text;
    if (exponent > 1) s += "^" + std::to_string(exponent);
  }
  if (s.empty()) return to_string(content);
  if (content == Integer(1)) return s;
  if (content == Integer(-1)) return "-" + s;
  return to_string(content) + "*" + s;
}

} // namespace

std::string to_factored_string(const MFraction& f) {
  if (is_zero(f)) return "0";
  const std::string top = factored(f.num());
  if (is_one(f.den())) return top;
  const std::string bottom = factored(f.den());
  const auto [content, factors] = factor(f.den());
  const bool one_factor = factors.empty() || (factors.size() == 1 && content == Integer(1));
  return top + "/" + (one_factor ? bottom : "(" + bottom + ")");
}

std::string brief(const MFraction& f, std::size_t length) {
  const std::string text = to_string(f);
  if (text.size() <= length) return text;
  return text.substr(0, length) + " ... (" + std::to_string(f.num().length()) + " terms over " +
         std::to_string(f.den().length()) + ")";
}

Poly to_poly(const MPoly& f, std::size_t z, const Field& k,
             const std::map<std::size_t, NfElem>& values) {
  if (is_zero(f)) return Poly(k);
  std::vector<NfElem> c(static_cast<std::size_t>(degree(f, z) + 1), NfElem(k));
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    NfElem term(Rational(f.coefficient(t)), k);
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (e[i] == 0 || i == z) continue;
      const auto value = values.find(i);
      if (value == values.end())
        throw InvalidArgument("the function still depends on '" + f.ring()->name(i) +
                              "'; a value is needed for it");
      term *= pow(value->second, e[i]);
    }
    c[e[z]] += term;
  }
  return Poly::from_coefficients(c);
}

NmodPoly to_poly(const MPoly& f, std::size_t x, mp_limb_t p) {
  return *PrimeIdeal{p, 0}.reduce(to_poly(f, x, rationals(), {}));
}

RationalFunction to_rational_function(const MFraction& f, std::size_t i,
                                      const std::optional<AlgebraicConstant>& a) {
  const Field& k = a ? a->field : rationals();
  if (is_zero(f)) return {Poly(k)};
  std::map<std::size_t, NfElem> values;
  if (a) values.emplace(a->variable, NfElem::generator(k));
  return {to_poly(f.num(), i, k, values), to_poly(f.den(), i, k, values)};
}

namespace {

MFraction from_poly(const Poly& f, const Ring& ring, std::size_t i) {
  MFraction sum(ring);
  for (long k = 0; k <= degree(f); ++k)
    sum += to_rational(f.coeff(k)) * pow(MFraction::variable(ring, i), k);
  return sum;
}

} // namespace

MFraction from_rational_function(const RationalFunction& f, const Ring& ring, std::size_t i) {
  if (!f.field()->is_rational())
    throw InvalidArgument("only functions over Q have a multivariate form");
  return from_poly(f.num(), ring, i) / from_poly(f.den(), ring, i);
}

} // namespace kov
