#include "kovacic/polynomial.hpp"

#include "exact/error.hpp"
#include "exact/linear.hpp"
#include "exact/nmod_matrix.hpp"
#include "kovacic/polynomial_kernel.hpp"

namespace kov::kovacic {
namespace {

struct PrimeField {
  using Elem = mp_limb_t;
  nmod_t mod;

  [[nodiscard]] Elem zero() const { return 0; }
  [[nodiscard]] Elem one() const { return 1; }
  [[nodiscard]] Elem from(long n) const {
    const Elem size = static_cast<Elem>(n < 0 ? -n : n) % mod.n;
    return n < 0 ? nmod_neg(size, mod) : size;
  }
  [[nodiscard]] bool is_zero(Elem a) const { return a == 0; }
  [[nodiscard]] Elem product(Elem a, Elem b) const { return nmod_mul(a, b, mod); }
  void add_product(Elem& sum, Elem a, Elem b) const {
    sum = nmod_add(sum, nmod_mul(a, b, mod), mod);
  }
  [[nodiscard]] long bits(Elem) const { return 0; }
  [[nodiscard]] Elem minus_inverse(Elem a) const { return nmod_neg(nmod_inv(a, mod), mod); }
  [[nodiscard]] std::vector<std::vector<Elem>> kernel(const std::vector<std::vector<Elem>>& rows,
                                                      std::size_t columns) const {
    NmodMatrix m(rows.size(), columns, mod.n);
    static_cast<void>(
        m.fill([&](std::size_t i, std::size_t j) { return std::optional(rows[i][j]); }));
    return m.kernel();
  }
};

struct ExactNumbers {
  using Elem = NfElem;

  [[nodiscard]] Elem zero() const { return {0}; }
  [[nodiscard]] Elem one() const { return {1}; }
  [[nodiscard]] Elem from(long n) const { return {n}; }
  [[nodiscard]] bool is_zero(const Elem& a) const { return kov::is_zero(a); }
  [[nodiscard]] Elem product(const Elem& a, const Elem& b) const { return a * b; }
  void add_product(Elem& sum, const Elem& a, const Elem& b) const {
    if (!kov::is_zero(a) && !kov::is_zero(b)) sum += a * b;
  }
  [[nodiscard]] long bits(const Elem& a) const {
    const long num = _fmpz_vec_max_bits(a.raw()->coeffs, a.raw()->length);
    return std::abs(num) + static_cast<long>(fmpz_bits(fmpq_poly_denref(a.raw())));
  }
  [[nodiscard]] Elem minus_inverse(const Elem& a) const { return -inverse(a); }
  [[nodiscard]] std::vector<std::vector<Elem>> kernel(const std::vector<std::vector<Elem>>& rows,
                                                      std::size_t columns) const {
    return kov::kernel(rows, columns, one());
  }
};

NmodPoly times(const NmodPoly& f, long n) { return scale(f, PrimeField{f.mod()}.from(n)); }
Poly times(const Poly& f, long n) { return scale(f, NfElem(n)); }

// The operator P -> P_{-1}: element k is the coefficient a_k of P^(k).
template <class Polynomial>
std::vector<Polynomial> step_operator(long m, const Polynomial& S, const Polynomial& H,
                                      const Polynomial& R, const Polynomial& one) {
  const Polynomial dS = derivative(S);
  std::vector<Polynomial> above; // P_{i+1}
  std::vector<Polynomial> now{times(one, -1)};
  for (long i = m; i >= 0; --i) {
    const Polynomial factor = times(dS, m - i) - H;
    std::vector<Polynomial> below(now.size() + 1, times(one, 0));
    for (std::size_t k = 0; k < now.size(); ++k) {
      below[k] = below[k] + factor * now[k] - S * derivative(now[k]);
      below[k + 1] = below[k + 1] - S * now[k];
    }
    for (std::size_t k = 0; k < above.size(); ++k)
      below[k] = below[k] - times(R * above[k], (m - i) * (i + 1));
    above = std::move(now);
    now = std::move(below);
  }
  return now;
}

template <class Polynomial> auto coefficients(const std::vector<Polynomial>& a) {
  std::vector<std::vector<decltype(a.front().coeff(0))>> all;
  for (const Polynomial& f : a) {
    auto& c = all.emplace_back();
    for (long i = 0; i <= degree(f); ++i)
      c.push_back(f.coeff(i));
  }
  return all;
}

} // namespace

PolynomialStep::PolynomialStep(long m, Poly S, const RationalFunction& r)
    : m_(m), S_(std::move(S)), R_(exact_div(r.num() * S_ * S_, r.den())),
      primes_(PrimeIdeals::large(common_field(S_.field(), r.field()))) {}

Poly PolynomialStep::times_S(const RationalFunction& theta) const {
  return theta.num() * exact_div(S_, theta.den());
}

const PolynomialStep::Image& PolynomialStep::image() {
  while (!image_) {
    const PrimeIdeal prime = primes_.next();
    auto S = prime.reduce(S_);
    auto R = prime.reduce(R_);
    if (S && R) image_ = Image{prime, *S, *R};
  }
  return *image_;
}

std::vector<Poly> PolynomialStep::solutions(const Poly& H, long d, const Budget& budget) {
  if (d < 0) return {};
  budget.check_degree(d);
  auto h = image().prime.reduce(H);
  while (!h) { // the prime divides a denominator: take another
    image_.reset();
    h = image().prime.reduce(H);
  }
  // A solution over K, scaled to be primitive at the prime, stays one modulo the prime.
  NmodPoly one(image_->prime.p);
  one.set_coeff(0, 1);
  const auto a = step_operator(m_, image_->S, *h, image_->R, one);
  if (PolynomialKernel(PrimeField{one.mod()}, coefficients(a), d, budget).basis().empty())
    return {};
  const auto exact = step_operator(m_, S_, H, R_, Poly(1));
  std::vector<Poly> found;
  for (const auto& c : PolynomialKernel(ExactNumbers{}, coefficients(exact), d, budget).basis())
    found.push_back(monic(Poly::from_coefficients(c)));
  for (const Poly& P : found)
    KOV_ENSURE(is_zero(chain(P, H).back()));
  return found;
}

std::vector<Poly> PolynomialStep::chain(const Poly& P, const Poly& H) const {
  const Poly dS = derivative(S_);
  std::vector<Poly> p{-P};
  for (long i = m_; i >= 0; --i) {
    const Poly& now = p.back();
    Poly below = (times(dS, m_ - i) - H) * now - S_ * derivative(now);
    if (i < m_) below -= times(R_ * p[p.size() - 2], (m_ - i) * (i + 1));
    p.push_back(std::move(below));
  }
  return p;
}

std::vector<RationalFunction> riccati_polynomial(const std::vector<Poly>& chain, const Poly& S) {
  KOV_ENSURE(is_zero(chain.back()));
  const long m = static_cast<long>(chain.size()) - 2;
  Integer factorial(1);
  Poly power = chain.front(); // S^(m-i) P_m
  std::vector<RationalFunction> descending;
  for (long i = m; i >= 0; --i) {
    if (i < m) {
      factorial *= Integer(m - i);
      power *= S;
    }
    const NfElem weight(Rational(Integer(1), factorial));
    descending.emplace_back(scale(chain[static_cast<std::size_t>(m - i)], weight), power);
  }
  return {descending.rbegin(), descending.rend()};
}

} // namespace kov::kovacic
