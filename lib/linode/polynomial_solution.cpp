#include "linode/polynomial_solution.hpp"

#include "exact/error.hpp"

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
