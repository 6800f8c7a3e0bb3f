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
};

inline namespace KOV_ISA {
namespace machine {

/// Numbers whose sums of products are one operation: dot(a, b, n) = sum of a[j] b[-j], j < n.
template <class T>
concept HasDot = requires(const T* a) {
  dot(a, a, 1);
};

template <int n, class T> inline void products(const Instruction& i, T* s, int k) {
  const T *a[n], *b[n];
  T sum[n]{};
  for (int m = 0; m < n; ++m) {
    a[m] = s + i.a[m];
    b[m] = s + i.b[m] + k;
  }
  for (int j = 0; j <= k; ++j)
    for (int m = 0; m < n; ++m)
      add_product(sum[m], a[m][j], b[m][-j]);
  for (int m = 0; m < n; ++m)
    s[i.out[m] + k] = sum[m];
}

// One product alone: two sums, so that an addition need not wait for the one before.
template <class T> inline void product(const Instruction& i, T* s, int k) {
  const T *a = s + i.a[0], *b = s + i.b[0] + k;
  T even{}, odd{};
  for (int j = 0; j < k; j += 2) {
    add_product(even, a[j], b[-j]);
    add_product(odd, a[j + 1], b[-j - 1]);
  }
  if (k % 2 == 0) add_product(even, a[k], b[-k]);
  s[i.out[0] + k] = even + odd;
}

template <int n, class T> inline void squares(const Instruction& i, T* s, int k) {
  const T* a[n];
  T sum[n]{};
  for (int m = 0; m < n; ++m)
    a[m] = s + i.a[m];
  for (int j = 0; 2 * j < k; ++j)
    for (int m = 0; m < n; ++m)
      add_product(sum[m], a[m][j], a[m][k - j]);
  for (int m = 0; m < n; ++m) {
    sum[m] += sum[m];
    if (k % 2 == 0) add_product(sum[m], a[m][k / 2], a[m][k / 2]);
    s[i.out[m] + k] = sum[m];
  }
}

template <class T>
inline void sum(const Instruction& i, const SumTerm* terms, const typename Lanes<T>::Real* numbers,
                T* s, int k) {
  T all{};
  if (k == 0 && i.a[1] != Instruction::none) all = Lanes<T>::all(numbers[i.a[1]]);
  for (std::uint32_t t = i.a[0]; t < i.b[0]; ++t)
    add_product(all, Lanes<T>::all(numbers[terms[t].number]), s[terms[t].reg + k]);
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
  T even{}, odd{};
  for (int j = 0; j + 1 < k; j += 2) {
    add_product(even, q[j], b[k - j]);
    add_product(odd, q[j + 1], b[k - j - 1]);
  }
  if (k % 2 == 1) add_product(even, q[k - 1], b[1]);
  q[k] = (rest - (even + odd)) * s[i.out[1]];
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
    return i.count == 1   ? product(i, s, k)
           : i.count == 2 ? products<2>(i, s, k)
           : i.count == 3 ? products<3>(i, s, k)
                          : products<4>(i, s, k);
  case Op::squares:
    return i.count == 1   ? squares<1>(i, s, k)
           : i.count == 2 ? squares<2>(i, s, k)
           : i.count == 3 ? squares<3>(i, s, k)
                          : squares<4>(i, s, k);
  case Op::sum:
    return sum(i, terms, numbers, s, k);
  case Op::scaled:
    s[i.out[0] + k] = s[i.a[0]] * s[i.b[0] + k];
    return;
  case Op::quotient:
    return quotient(i, s, k);
  }
}

} // namespace machine

/// What does not depend on the orbit.
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
