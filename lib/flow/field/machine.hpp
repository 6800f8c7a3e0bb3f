#pragma once
// The machine that runs a Program: its registers are series of packs, one order at a time.
//
// Everything an order does is here; there is no instruction for what a system has not.  Cost of order k: k + 1
// products for a product or quotient, half of that for a square, a few for the rest.

#include "flow/field/instruction.hpp"
#include "flow/number/lanes.hpp"
#include "flow/number/twin.hpp"

namespace kov::flow {

/// A Program for one order of the series: registers have become places in the storage.  Plain pointers, so that
/// code for one instruction set shares nothing with that for another.
template <class R> struct Tape {
  const Instruction *once = nullptr, *once_end = nullptr;
  const Instruction *each = nullptr, *each_end = nullptr;
  const SumTerm* terms = nullptr;
  const R* numbers = nullptr;
  std::uint32_t one = 0; ///< which of the numbers is 1; 2, 3, ... follow
  /// The instructions `each` as code of the processor (machine_code.hpp) for packs of one size, or null: up to
  /// the order `to`.  What moves has x_(k+1) = x'_k tau reciprocals[k] after each of them.
  using Code = void (*)(void* series, const R* numbers, const void* tau, const R* reciprocals,
                        long to);
  Code code = nullptr;
};

inline namespace KOV_ISA {
namespace machine {

/// Numbers whose sums of products are one operation: dot(a, b, n) = sum of a[j] b[-j], j < n.
template <class T>
concept HasDot = requires(const T* a) {
  dot(a, a, 1);
};

// The sum of a[j] b[-j], first <= j < end, in two sums, of the even and of the odd terms.
template <class T> inline T sum_of_terms(const T* a, const T* b, int first, int end) {
  if (first >= end) return T{};
  T even = a[first] * b[-first];
  if (first + 1 == end) return even;
  T odd = a[first + 1] * b[-first - 1];
  int j = first + 2;
  for (; j + 1 < end; j += 2) {
    add_product(even, a[j], b[-j]);
    add_product(odd, a[j + 1], b[-j - 1]);
  }
  if (j < end) add_product(even, a[j], b[-j]);
  return even + odd;
}

// The sum of 0 < j < k, and the terms a_0 b_k and a_k b_0; b: of order k.
template <class T> inline T with_ends(T sum, const T* a, const T* b, int k) {
  if (k == 0) return a[0] * b[0];
  add_product(sum, a[0], b[0]);
  add_product(sum, a[k], b[-k]);
  return sum;
}

// The terms with what is newest, a_0 b_k and a_k b_0, come last: the others need nothing of this order, and the
// processor has summed them before those are known.  What comes out does not depend on how many products one
// instruction has.
template <int n, class T> inline void products(const Instruction& i, T* s, int k) {
  const T *a[n], *b[n];
  T even[n]{}, odd[n]{};
  for (int m = 0; m < n; ++m) {
    a[m] = s + i.a[m];
    b[m] = s + i.b[m] + k;
    if (k > 1) even[m] = a[m][1] * b[m][-1];
    if (k > 2) odd[m] = a[m][2] * b[m][-2];
  }
  int j = 3;
  for (; j + 1 < k; j += 2)
    for (int m = 0; m < n; ++m) {
      add_product(even[m], a[m][j], b[m][-j]);
      add_product(odd[m], a[m][j + 1], b[m][-j - 1]);
    }
  for (int m = 0; m < n; ++m) {
    if (j < k) add_product(even[m], a[m][j], b[m][-j]);
    s[i.out[m] + k] = with_ends(k > 2 ? T(even[m] + odd[m]) : even[m], a[m], b[m], k);
  }
}

// Twice the terms 0 < j < k - j, and the one in the middle.
template <class T> inline T inner_square(const T* a, int k) {
  T sum = sum_of_terms(a, a + k, 1, (k + 1) / 2);
  sum += sum;
  if (k > 0 && k % 2 == 0) add_product(sum, a[k / 2], a[k / 2]);
  return sum;
}

template <class T> inline T square_terms(const T* a, int k) {
  if (k == 0) return a[0] * a[0];
  T sum = inner_square(a, k);
  add_product(sum, a[0] + a[0], a[k]);
  return sum;
}

template <class T> inline void squares(const Instruction& i, T* s, int k) {
  for (std::size_t m = 0; m < i.count; ++m)
    s[i.out[m] + k] = square_terms(s + i.a[m], k);
}

template <class T>
inline void sum(const Instruction& i, const SumTerm* terms, const typename Lanes<T>::Real* numbers,
                T* s, int k) {
  T all{};
  if (k == 0 && i.b[1] > i.b[0]) { // a difference, with the low parts last
    for (std::uint32_t t = i.b[0]; t < i.b[1]; ++t) {
      if (t == i.b[2] && i.a[1] != Instruction::none) all += Lanes<T>::all(numbers[i.a[1]]);
      add_product(all, Lanes<T>::all(numbers[terms[t].number]), s[terms[t].reg]);
    }
    s[i.out[0]] = all * Lanes<T>::all(numbers[i.a[2]]);
    return;
  }
  if (i.a[0] != i.b[0]) {
    const SumTerm& first = terms[i.a[0]];
    all = Lanes<T>::all(numbers[first.number]) * s[first.reg + k];
    for (std::uint32_t t = i.a[0] + 1; t < i.b[0]; ++t)
      add_product(all, Lanes<T>::all(numbers[terms[t].number]), s[terms[t].reg + k]);
  }
  if (k == 0 && i.a[1] != Instruction::none) all += Lanes<T>::all(numbers[i.a[1]]);
  s[i.out[0] + k] = all;
}

// b_0 q_k = a_k - sum_(j<k) q_j b_(k-j)
template <class T> inline void quotient(const Instruction& i, T* s, int k) {
  const T* b = s + i.b[0];
  T* q = s + i.out[0];
  T rest = s[i.a[0] + k];
  if (k == 0) {
    q[0] = rest / b[0];
    s[i.out[1]] = Lanes<T>::all(typename Lanes<T>::Real(1)) / b[0];
    return;
  }
  if constexpr (HasDot<T>) {
    q[k] = (rest - dot(q, b + k, k)) * s[i.out[1]];
    return;
  }
  T sum = sum_of_terms(q, b + k, 1, k);
  add_product(sum, q[0], b[k]);
  q[k] = (rest - sum) * s[i.out[1]];
}

// r^2 = a:  2 r_0 r_k = a_k - sum_(0<j<k) r_j r_(k-j); r_0 is given
template <class T> inline void root(const Instruction& i, T* s, int k) {
  T* r = s + i.out[0];
  if (k == 0) {
    s[i.out[1]] = Lanes<T>::all(typename Lanes<T>::Real(1)) / (r[0] + r[0]);
    return;
  }
  r[k] = (s[i.a[0] + k] - inner_square(r, k)) * s[i.out[1]];
}

// p = r^n, of r = sqrt(a), c = n/2:  a_0 p_k = c sum_(j<k) p_j a_(k-j) - ((c + 1)/k) sum_(j<k) j p_j a_(k-j), where a_0 is
// r_0^2: near a collision r has digits that a, a sum of squares of differences, has not
template <class T>
inline void power(const Instruction& i, const typename Lanes<T>::Real* numbers, T* s, int k) {
  using Real = typename Lanes<T>::Real;
  const auto all = [](const Real& x) { return Lanes<T>::all(x); };
  T *p = s + i.out[0], *e = s + i.out[2];
  const T* a = s + i.a[0];
  if (k == 0) {
    const T r = s[i.b[0]];
    T value = r;
    for (int n = 1; n < (i.exponent < 0 ? -i.exponent : i.exponent); ++n)
      value = value * r;
    p[0] = i.exponent < 0 ? T(all(Real(1)) / value) : value;
    s[i.out[1]] = all(Real(1)) / (r * r);
    e[0] = T{};
    return;
  }
  T sum, weighted{};
  if constexpr (HasDot<T>) {
    sum = dot(p, a + k, k);
    weighted = dot(e, a + k, k);
  } else {
    sum = sum_of_terms(a, p + k, 1, k);
    weighted = sum_of_terms(a, e + k, 1, k);
    add_product(sum, a[k], p[0]);
  }
  const T c = all(numbers[i.a[1]]), by = all(Real(numbers[i.a[2]] * Real(Real(1) / Real(k))));
  T rest = c * sum;
  sub_product(rest, by, weighted);
  p[k] = rest * s[i.out[1]];
  e[k] = p[k] * all(Real(k));
}

template <class T> inline void dots(const Instruction& i, T* s, int k) {
  for (std::size_t m = 0; m < i.count; ++m) {
    const T* b = i.op == Instruction::Op::squares ? s + i.a[m] : s + i.b[m];
    s[i.out[m] + k] = dot(s + i.a[m], b + k, k + 1);
  }
}

template <class T>
inline void execute(const Instruction& i, const SumTerm* terms,
                    const typename Lanes<T>::Real* numbers, T* s, int k) {
  using Op = Instruction::Op;
  if constexpr (HasDot<T>)
    if (i.op == Op::products || i.op == Op::squares) return dots(i, s, k);
  switch (i.op) {
  case Op::products:
    return i.count == 1   ? products<1>(i, s, k)
           : i.count == 2 ? products<2>(i, s, k)
           : i.count == 3 ? products<3>(i, s, k)
                          : products<4>(i, s, k);
  case Op::squares:
    return squares(i, s, k);
  case Op::sum:
    return sum(i, terms, numbers, s, k);
  case Op::scaled:
    s[i.out[0] + k] = s[i.a[0]] * s[i.b[0] + k];
    return;
  case Op::quotient:
    return quotient(i, s, k);
  case Op::root:
    return root(i, s, k);
  case Op::power:
    return power(i, numbers, s, k);
  case Op::copy:
    if (k > 0) s[i.out[0] + k] = s[i.a[0] + k];
    return;
  }
}

} // namespace machine

/// Computes what does not depend on the orbit.
template <class T> void run_once(const Tape<typename Lanes<T>::Real>& t, T* s) {
  for (const Instruction* i = t.once; i != t.once_end; ++i)
    machine::execute(*i, t.terms, t.numbers, s, 0);
}

/// The coefficients of order k of all nodes, from those of the variables up to k and of the nodes below k.
template <class T> inline void run_order(const Tape<typename Lanes<T>::Real>& t, T* s, int k) {
  for (const Instruction* i = t.each; i != t.each_end; ++i)
    machine::execute(*i, t.terms, t.numbers, s, k);
}

} // namespace KOV_ISA
} // namespace kov::flow
