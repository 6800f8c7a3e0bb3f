#pragma once
// All polynomials P of degree <= d with sum_k a_k P^(k) = 0, over any field: used once with F_p and
// once with K.
//
// sum_k a_k d^k maps z^j to sum_s c_s(j) z^(j+s), c_s(j) = sum_k [z^(k+s)] a_k * j(j-1)...(j-k+1).
// With t the largest s that occurs, the equation at z^(j+t) gives the coefficient p_j from the
// higher ones unless c_t(j) = 0; then p_j is a free parameter and the equation a condition on the
// parameters.  The equations below z^t are conditions as well.

#include "exact/budget.hpp"

#include <algorithm>
#include <vector>

namespace kov::kovacic {

/// Arithmetic of the field: types and operations are given by `A` (see polynomial.cpp).
template <class A> class PolynomialKernel {
public:
  using Elem = typename A::Elem;
  using Vector = std::vector<Elem>; ///< coordinates with respect to the free parameters

  /// Shape  a[k][i] = [z^i] a_k
  PolynomialKernel(A arithmetic, std::vector<std::vector<Elem>> a, long d, const Budget& budget)
      : A_(std::move(arithmetic)), a_(std::move(a)), d_(d), budget_(budget) {
    for (std::size_t k = 0; k < a_.size(); ++k)
      if (!a_[k].empty())
        top_ = std::max(top_, static_cast<long>(a_[k].size()) - 1 - static_cast<long>(k));
  }

  /// Ascending coefficients of a basis of the solutions.
  [[nodiscard]] std::vector<std::vector<Elem>> basis() {
    p_.resize(static_cast<std::size_t>(d_ + 1));
    equations_.resize(static_cast<std::size_t>(std::max(0L, d_ + top_ + 1)));
    for (long j = d_; j >= 0; --j)
      descend(j);
    for (Vector& rest : equations_)
      if (!rest.empty()) conditions_.push_back(std::move(rest));
    for (Vector& row : conditions_)
      row.resize(parameters_, A_.zero());
    return combine(A_.kernel(conditions_, parameters_));
  }

private:
  [[nodiscard]] long order() const { return static_cast<long>(a_.size()) - 1; }

  // c_s(j) for s = top, top-1, ..., -order
  [[nodiscard]] std::vector<Elem> images(long j) const {
    std::vector<Elem> c(static_cast<std::size_t>(top_ + order() + 1), A_.zero());
    Elem falling = A_.one();
    for (long k = 0; k <= std::min(order(), j); ++k) {
      const auto& a = a_[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < a.size(); ++i) {
        const long s = static_cast<long>(i) - k;
        A_.add_product(c[static_cast<std::size_t>(top_ - s)], a[i], falling);
      }
      falling = A_.product(falling, A_.from(j - k));
    }
    return c;
  }

  // Finds p_j from the equation at z^(j+t), which all higher coefficients have entered by now, and
  // lets it enter the lower ones.
  void descend(long j) {
    budget_.check();
    const std::vector<Elem> c = images(j);
    Vector& p = p_[static_cast<std::size_t>(j)];
    if (j + top_ >= 0) p = std::move(equations_[static_cast<std::size_t>(j + top_)]);
    if (A_.is_zero(c.front())) {
      if (!p.empty()) conditions_.push_back(std::move(p));
      p.assign(++parameters_, A_.zero());
      p.back() = A_.one();
    } else {
      const Elem factor = A_.minus_inverse(c.front());
      for (Elem& x : p)
        x = A_.product(x, factor);
    }
    if (p.empty()) return;
    check_size(p);
    for (std::size_t i = 1; i < c.size(); ++i) {
      const long e = j + top_ - static_cast<long>(i);
      if (e < 0) break;
      if (A_.is_zero(c[i])) continue;
      Vector& sum = equations_[static_cast<std::size_t>(e)];
      sum.resize(parameters_, A_.zero());
      for (std::size_t l = 0; l < p.size(); ++l)
        A_.add_product(sum[l], c[i], p[l]);
    }
  }

  // Exact coefficients grow with the degree; P has one common denominator.
  void check_size(const Vector& p) {
    constexpr long limit = 1L << 30;
    ++nonzero_;
    for (const Elem& x : p)
      bits_ = std::max(bits_, A_.bits(x));
    if (bits_ > limit / nonzero_)
      throw OutOfBudget("size limit: the coefficients of a polynomial of degree " +
                        std::to_string(d_) + " take more than 128 MB");
  }

  [[nodiscard]] std::vector<std::vector<Elem>> combine(const std::vector<Vector>& kernel) const {
    std::vector<std::vector<Elem>> found;
    for (const Vector& v : kernel) {
      auto& f = found.emplace_back(p_.size(), A_.zero());
      for (std::size_t j = 0; j < p_.size(); ++j)
        for (std::size_t l = 0; l < p_[j].size(); ++l)
          A_.add_product(f[j], p_[j][l], v[l]);
    }
    return found;
  }

  A A_;
  std::vector<std::vector<Elem>> a_;
  long d_;
  const Budget& budget_;
  long top_ = -1000000000;
  std::size_t parameters_ = 0;
  long bits_ = 0;
  long nonzero_ = 0;
  std::vector<Vector> p_;         // the coefficients of P; an empty vector is zero
  std::vector<Vector> equations_; // at z^e: what is known of it so far
  std::vector<Vector> conditions_;
};

} // namespace kov::kovacic
