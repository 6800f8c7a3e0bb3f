#include "linode/polynomial_solution.hpp"

#include "exact/error.hpp"
#include "exact/modular.hpp"

#include <algorithm>
#include <vector>

namespace kov {
namespace {

// The equation as a recurrence on coefficients: z^j contributes
//   (j(j-1) c2_(i+2) + j c1_(i+1) + c0_i) z^(j+i)   for  i = s, s-1, ...
class TopDown {
public:
  TopDown(const Poly& c2, const Poly& c1, const Poly& c0)
      : top_(std::max({degree(c2) - 2, degree(c1) - 1, degree(c0)})) {
    for (long i = top_; i >= -2; --i) {
      second_.push_back(c2.coeff(i + 2));
      first_.push_back(c1.coeff(i + 1));
      zeroth_.push_back(c0.coeff(i));
    }
  }

  [[nodiscard]] long width() const { return static_cast<long>(second_.size()); }
  /// contribution of z^j to z^(j + top - k)
  [[nodiscard]] NfElem weight(long j, long k) const {
    const auto i = static_cast<std::size_t>(k);
    NfElem w = zeroth_[i];
    if (!is_zero(first_[i])) w += first_[i] * NfElem(j);
    if (!is_zero(second_[i])) w += second_[i] * NfElem(Rational(Integer(j) * Integer(j - 1)));
    return w;
  }

private:
  long top_;
  std::vector<NfElem> second_;
  std::vector<NfElem> first_;
  std::vector<NfElem> zeroth_;
};

// The coefficients d, d-1, ..., 0 with p_d given, choosing 0 (or 1 at `one_at`) where the pivot
// vanishes; the list of vanishing pivots below d is appended to `free`.
std::vector<NfElem> descend(const TopDown& recurrence, long d, long start, std::vector<long>* free,
                            const Budget& budget) {
  std::vector<NfElem> p(static_cast<std::size_t>(d) + 1);
  p[static_cast<std::size_t>(start)] = NfElem(1);
  for (long j = start - 1; j >= 0; --j) {
    if (j % 64 == 0) budget.check();
    NfElem sum;
    for (long k = 1; k < recurrence.width() && j + k <= start; ++k) {
      const NfElem& c = p[static_cast<std::size_t>(j + k)];
      if (is_zero(c)) continue;
      const NfElem w = recurrence.weight(j + k, k);
      if (!is_zero(w)) sum += w * c;
    }
    const NfElem pivot = recurrence.weight(j, 0);
    if (is_zero(pivot)) {
      if (free != nullptr) free->push_back(j);
      continue;
    }
    if (!is_zero(sum)) p[static_cast<std::size_t>(j)] = -(sum / pivot);
  }
  return p;
}

// c2 f'' + c1 f' + c0 f modulo one prime.
class ModularOperator {
public:
  ModularOperator(NmodPoly c2, NmodPoly c1, NmodPoly c0)
      : c2_(std::move(c2)), c1_(std::move(c1)), c0_(std::move(c0)),
        top_(std::max({degree(c2_) - 2, degree(c1_) - 1, degree(c0_)})) {}

  [[nodiscard]] NmodPoly operator()(const NmodPoly& f) const {
    return c2_ * derivative(derivative(f)) + c1_ * derivative(f) + c0_ * f;
  }
  [[nodiscard]] long top() const { return top_; }
  /// Contribution of z^j to z^(j + top - k).
  [[nodiscard]] mp_limb_t weight(long j, long k) const {
    const nmod_t mod = c2_.mod();
    const auto n = static_cast<mp_limb_t>(j);
    mp_limb_t w = nmod_mul(coeff(c2_, top_ - k + 2), nmod_mul(n, j > 0 ? n - 1 : 0, mod), mod);
    w = nmod_addmul(w, coeff(c1_, top_ - k + 1), n, mod);
    return nmod_add(w, coeff(c0_, top_ - k), mod);
  }
  /// z^start + ... with the coefficients that the recurrence gives, 0 where the pivot vanishes; the
  /// places of vanishing pivots are appended to `free`.
  [[nodiscard]] NmodPoly descend(long start, std::vector<long>& free) const {
    const nmod_t mod = c2_.mod();
    NmodPoly f(mod.n);
    f.set_coeff(start, 1);
    for (long j = start - 1; j >= 0; --j) {
      mp_limb_t sum = 0;
      for (long k = 1; k <= top_ + 2 && j + k <= start; ++k)
        sum = nmod_addmul(sum, weight(j + k, k), f.coeff(j + k), mod);
      const mp_limb_t pivot = weight(j, 0);
      if (pivot == 0)
        free.push_back(j);
      else
        f.set_coeff(j, nmod_neg(nmod_div(sum, pivot, mod), mod));
    }
    return f;
  }

private:
  static mp_limb_t coeff(const NmodPoly& f, long i) { return i < 0 ? 0 : f.coeff(i); }

  NmodPoly c2_, c1_, c0_;
  long top_;
};

bool linearly_independent(const NmodPoly& f, const NmodPoly& g) {
  if (is_zero(f) || is_zero(g)) return false;
  return !is_zero(scale(f, g.coeff(degree(g))) - scale(g, f.coeff(degree(g))));
}

// Below this degree the solution itself is found as quickly.
constexpr long large_degree = 64;

// Absence of a solution of degree d, by one prime (docs/theory/riccati_one_place.md, 9): false
// proves nothing.
bool provably_none(const Poly& c2, const Poly& c1, const Poly& c0, const TopDown& recurrence,
                   long d) {
  const Field& k = common_field(common_field(c2.field(), c1.field()), c0.field());
  const PrimeIdeal prime = PrimeIdeals::large(k).next();
  const auto a2 = prime.reduce(c2), a1 = prime.reduce(c1), a0 = prime.reduce(c0);
  if (!a2 || !a1 || !a0) return false;
  const ModularOperator L(*a2, *a1, *a0);
  if (L.top() + 3 != recurrence.width()) return false;
  std::vector<long> free;
  const NmodPoly defect = L(L.descend(d, free));
  if (free.size() > 1 || is_zero(defect)) return false;
  if (free.empty()) return true;
  if (!is_zero(recurrence.weight(free[0], 0))) return false; // zero modulo the prime only
  std::vector<long> none;
  return linearly_independent(L(L.descend(free[0], none)), defect);
}

} // namespace

std::optional<Poly> polynomial_solution(const Poly& c2, const Poly& c1, const Poly& c0, long d,
                                        const Budget& budget) {
  KOV_ENSURE(d >= 0);
  budget.check_degree(d);
  const TopDown recurrence(c2, c1, c0);
  const auto residual = [&](const Poly& f) {
    return c2 * derivative(derivative(f)) + c1 * derivative(f) + c0 * f;
  };
  if (!is_zero(recurrence.weight(d, 0))) return std::nullopt;
  if (d >= large_degree && provably_none(c2, c1, c0, recurrence, d)) return std::nullopt;
  std::vector<long> free;
  const Poly particular = Poly::from_coefficients(descend(recurrence, d, d, &free, budget));
  const Poly defect = residual(particular);
  if (is_zero(defect)) return particular;
  // A second order equation has at most one other exponent at infinity: at most one free
  // coefficient.
  if (free.size() != 1) return std::nullopt;
  const Poly other = Poly::from_coefficients(descend(recurrence, d, free[0], nullptr, budget));
  const Poly slope = residual(other);
  if (is_zero(slope)) return std::nullopt;
  const long i = degree(slope);
  const NfElem factor = -(defect.coeff(i) / slope.coeff(i));
  const Poly solution = particular + scale(other, factor);
  if (!is_zero(residual(solution))) return std::nullopt;
  return solution;
}

} // namespace kov
