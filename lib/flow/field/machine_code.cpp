#include "flow/field/machine_code.hpp"

#include "flow/field/assembler.hpp"

#include <algorithm>
#include <cstring>
#include <set>
#include <utility>

#if defined(__x86_64__) && defined(__linux__)
#include <sys/mman.h>
#endif

namespace kov::flow {
namespace {

// rdi: the series, rsi: the numbers, rbx: tau, rbp: 1, 1/2, 1/3, ..., r10: the order k, rdx: k in bytes of a series,
// r9: the order to stop at.
//
// The low orders are straight: there k is known, and loops over a few terms would cost more than the terms.
class Emitter {
public:
  Emitter(const Tape<double>& tape, const MachineCode::Moving& moving, int lanes)
      : tape_(tape), moving_(moving), a_(lanes), shift_(lanes == 8 ? 6 : 5) {}

  std::vector<std::uint8_t> emit(int first, int end) {
    a_.push(rbx);
    a_.push(rbp);
    a_.move(rbx, rdx);
    a_.move(rbp, rcx);
    a_.move(r9, r8);
    std::vector<std::size_t> exits;
    set_pointers();
    for (k_ = first; k_ < end && (k_ < least_straight || a_.here() < straight_bytes); ++k_) {
      emit_order();
      a_.compare(r9, k_ + 1);
      exits.push_back(a_.forward_if_equal());
    }
    if (k_ < end) emit_other_orders();
    for (const std::size_t jump : exits)
      a_.land(jump);
    a_.pop(rbp);
    a_.pop(rbx);
    a_.leave();
    return a_.code();
  }

private:
  using Op = Instruction::Op;
  using enum Assembler::Gpr;

  // Below, the loop would have to do without its first two terms.
  static constexpr int least_straight = 6;
  static constexpr std::size_t straight_bytes = 24'000; // what stays in the cache

  struct One {
    std::uint32_t out, a, b;
  };
  /// The terms of the sum of a_j b_(k-j): those with 0 < j < k, or with 0 < j < k - j.
  enum class Range : std::uint8_t { inner, inner_to_half };

  void emit_order() {
    for (const Instruction* i = tape_.each; i != tape_.each_end;)
      i = emit_one(i);
    emit_moving();
  }

  void emit_other_orders() {
    a_.zero(r10);
    a_.add(r10, k_);
    a_.move(rdx, r10);
    a_.shift_left(rdx, shift_);
    k_ = unknown;
    const std::size_t order = a_.here();
    emit_order();
    a_.add(rdx, a_.width());
    a_.add(r10, 1);
    a_.compare(r10, r9);
    a_.back_if_less(order);
  }

  [[nodiscard]] std::int32_t place(std::uint32_t series, int k = 0) const {
    return (static_cast<std::int32_t>(series) + k) * a_.width();
  }
  // Coefficient k of a series.  In straight code other registers point into the storage, too, so that displacements
  // are short.
  [[nodiscard]] Assembler::Address at(std::uint32_t series, int k) const {
    const std::int32_t bytes = place(series, k);
    if (k_ == unknown || a_.width() != 64) return {rdi, -1, bytes};
    const auto part = static_cast<std::size_t>((bytes + reach / 2) / reach);
    if (part == 0 || part > parts_) return {rdi, -1, bytes};
    return {pointers[part - 1], -1, bytes - static_cast<std::int32_t>(part) * reach};
  }
  [[nodiscard]] Assembler::Address at_start(std::uint32_t series) const { return at(series, 0); }
  [[nodiscard]] Assembler::Address at_order(std::uint32_t series, int more = 0) const {
    if (k_ == unknown) return {rdi, rdx, place(series, more)};
    return at(series, k_ + more);
  }
  void set_pointers() {
    parts_ = a_.width() == 64 ? std::size(pointers) : 0;
    for (std::size_t part = 1; part <= parts_; ++part) {
      a_.move(pointers[part - 1], rdi);
      a_.add(pointers[part - 1], static_cast<std::int32_t>(part) * reach);
    }
  }
  [[nodiscard]] static Assembler::Address number(std::uint32_t n) {
    return {rsi, -1, static_cast<std::int32_t>(n * sizeof(double))};
  }

  const Instruction* emit_one(const Instruction* i) {
    switch (i->op) {
    case Op::products:
    case Op::squares:
      return emit_products(i);
    case Op::sum:
      emit_sum(*i);
      break;
    case Op::scaled:
      a_.load(0, at_order(i->b[0]));
      a_.multiply(0, 0, at_start(i->a[0]));
      a_.store(at_order(i->out[0]), 0);
      break;
    case Op::quotient:
    case Op::root:
      return emit_rests(i);
    case Op::power:
      emit_power(*i);
      break;
    case Op::copy:
      if (k_ == 0) break;
      a_.load(0, at_order(i->a[0]));
      a_.store(at_order(i->out[0]), 0);
    }
    return i + 1;
  }

  // x_(k+1) = x'_k tau/(k + 1)
  void emit_moving() {
    if (moving_.empty()) return;
    broadcast_of_order(1, rbp, 0);
    a_.multiply(1, 1, {rbx, -1, 0});
    for (const auto& [variable, derivative] : moving_) {
      a_.multiply(0, 1, at_order(derivative));
      a_.store(at_order(variable, 1), 0);
    }
  }

  // The products and squares from i on that do not need each other.
  const Instruction* emit_products(const Instruction* i) {
    std::vector<One> products, squares;
    std::set<std::uint32_t> made;
    const auto needs_them = [&](const Instruction& next) {
      for (std::size_t m = 0; m < next.count; ++m)
        if (made.contains(next.a[m]) || made.contains(next.b[m])) return true;
      return false;
    };
    for (;
         i != tape_.each_end && (i->op == Op::products || i->op == Op::squares) && !needs_them(*i);
         ++i)
      for (std::size_t m = 0; m < i->count; ++m) {
        (i->op == Op::products ? products : squares).push_back({i->out[m], i->a[m], i->b[m]});
        made.insert(i->out[m]);
      }
    in_parts(products, [&](const One* first, int n) {
      emit_terms(first, n, Range::inner);
      emit_ends(first, n, true);
      store_sums(first, n);
    });
    in_parts(squares, [&](const One* first, int n) {
      emit_terms(first, n, Range::inner_to_half);
      emit_middle(first, n);
      emit_ends_of_squares(first, n);
      store_sums(first, n);
    });
    return i;
  }

  // Two registers for each product and two more for factors.
  template <class F> void in_parts(const std::vector<One>& all, const F& emit) const {
    const int most = (a_.registers() - 2) / 2, n = static_cast<int>(all.size());
    const int parts = (n + most - 1) / most;
    for (int part = 0, first = 0; part < parts; ++part) {
      const int count = (n - first) / (parts - part);
      emit(all.data() + first, count);
      first += count;
    }
  }

  void store_sums(const One* first, int n) {
    for (int m = 0; m < n; ++m)
      a_.store(at_order(first[m].out), 2 * m);
  }

  // The first terms of the even and of the odd sum are products, the others are added to them.
  void term(int sum, int factor, const Assembler::Address& b, bool begins) {
    if (begins)
      a_.multiply(sum, factor, b);
    else
      a_.add_product(sum, factor, b);
  }

  // Register 2 m: the sum of the terms of product m.
  void emit_terms(const One* products, int n, Range range) {
    if (k_ == unknown)
      loop_over_terms(products, n, range);
    else
      straight_terms(products, n, range);
  }

  void straight_terms(const One* products, int n, Range range) {
    constexpr int first = 1;
    const int most = std::max(k_ - 1, 0), count = range == Range::inner ? most : most / 2;
    for (int t = 0; t < count; ++t) {
      const int odd = t % 2, factor = a_.registers() - 2 + odd, j = first + t;
      for (int m = 0; m < n; ++m) {
        if (m == 0 || products[m].a != products[m - 1].a) a_.load(factor, at(products[m].a, j));
        term(2 * m + odd, factor, at(products[m].b, k_ - j), t < 2);
      }
    }
    for (int m = 0; m < n && count == 0; ++m)
      a_.clear(2 * m);
    for (int m = 0; m < n && count >= 2; ++m)
      a_.add(2 * m, 2 * m, 2 * m + 1);
  }

  // even(m), odd(m): their next terms.  rax: j, r8: k - j, in bytes.
  void loop_terms(const One* products, int n, int odd, bool begins) {
    const int factor = a_.registers() - 2 + odd;
    for (int m = 0; m < n; ++m) {
      if (m == 0 || products[m].a != products[m - 1].a)
        a_.load(factor, {rdi, rax, place(products[m].a, odd)});
      term(2 * m + odd, factor, {rdi, r8, place(products[m].b, -odd)}, begins);
    }
  }

  // rcx: how many terms are left after the first two; destroys r11.
  void loop_over_terms(const One* products, int n, Range range) {
    a_.move(rcx, r10);
    a_.subtract(rcx, range == Range::inner ? 3 : 5);
    if (range == Range::inner_to_half) a_.shift_right(rcx, 1);
    a_.zero(rax);
    a_.add(rax, a_.width());
    a_.move(r8, rdx);
    a_.subtract(r8, a_.width());
    loop_terms(products, n, 0, true);
    loop_terms(products, n, 1, true);
    a_.move(r11, rcx);
    a_.shift_right(rcx, 1);
    const std::size_t no_pair = a_.forward_if_zero();
    const std::size_t loop = a_.here();
    a_.add(rax, 2 * a_.width());
    a_.subtract(r8, 2 * a_.width());
    loop_terms(products, n, 0, false);
    loop_terms(products, n, 1, false);
    a_.subtract(rcx, 1);
    a_.back_unless_zero(loop);
    a_.land(no_pair);
    a_.bits(r11, 1);
    const std::size_t even = a_.forward_if_zero();
    a_.add(rax, 2 * a_.width());
    a_.subtract(r8, 2 * a_.width());
    loop_terms(products, n, 0, false);
    a_.land(even);
    for (int m = 0; m < n; ++m)
      a_.add(2 * m, 2 * m, 2 * m + 1);
  }

  // a_0 b_k, and a_k b_0 if that is `last`.
  void emit_ends(const One* products, int n, bool last) {
    for (const bool other : {false, true}) {
      const int factor = a_.registers() - 2 + (other ? 1 : 0);
      for (int m = 0; m < n && (last || !other); ++m) {
        if (m == 0 || products[m].a != products[m - 1].a)
          a_.load(factor, other ? at_order(products[m].a) : at_start(products[m].a));
        if (other && k_ == 0) continue;
        term(2 * m, factor, other ? at_start(products[m].b) : at_order(products[m].b), k_ == 0);
      }
    }
  }
  void emit_ends_of_squares(const One* squares, int n) {
    for (int m = 0; m < n; ++m) {
      a_.load(2 * m + 1, at_start(squares[m].a));
      if (k_ != 0) a_.add(2 * m + 1, 2 * m + 1, 2 * m + 1);
      term(2 * m, 2 * m + 1, at_order(squares[m].a), k_ == 0);
    }
  }

  // Twice the sum, and the square in the middle where k is even.
  void emit_middle(const One* squares, int n) {
    for (int m = 0; m < n; ++m)
      a_.add(2 * m, 2 * m, 2 * m);
    if (k_ != unknown) {
      for (int m = 0; m < n && k_ > 0 && k_ % 2 == 0; ++m) {
        a_.load(2 * m + 1, at(squares[m].a, k_ / 2));
        a_.add_product(2 * m, 2 * m + 1, 2 * m + 1);
      }
      return;
    }
    a_.bits(r10, 1);
    const std::size_t odd = a_.forward_unless_zero();
    a_.move(rax, rdx);
    a_.shift_right(rax, 1);
    for (int m = 0; m < n; ++m) {
      a_.load(2 * m + 1, {rdi, rax, place(squares[m].a)});
      a_.add_product(2 * m, 2 * m + 1, 2 * m + 1);
    }
    a_.land(odd);
  }

  // As the beginning of machine::sum.
  void emit_difference(const Instruction& i) {
    a_.clear(0);
    for (std::uint32_t t = i.b[0]; t < i.b[1]; ++t) {
      if (t == i.b[2] && i.a[1] != Instruction::none) {
        a_.broadcast(1, number(i.a[1]));
        a_.add(0, 0, 1);
      }
      a_.broadcast(1, number(tape_.terms[t].number));
      a_.add_product(0, 1, at_start(tape_.terms[t].reg));
    }
    a_.broadcast(1, number(i.a[2]));
    a_.multiply(0, 0, 1);
    a_.store(at_order(i.out[0]), 0);
  }

  void emit_sum(const Instruction& i) {
    if (k_ == 0 && i.b[1] > i.b[0]) return emit_difference(i);
    if (i.a[0] == i.b[0]) a_.clear(0);
    for (std::uint32_t t = i.a[0]; t < i.b[0]; ++t) {
      const SumTerm& term = tape_.terms[t];
      const double c = tape_.numbers[term.number];
      const Assembler::Address x = at_order(term.reg);
      if (t == i.a[0] && c == 1) {
        a_.load(0, x);
      } else if (t == i.a[0]) {
        a_.broadcast(0, number(term.number));
        a_.multiply(0, 0, x);
      } else if (c == 1) {
        a_.add(0, 0, x);
      } else if (c == -1) {
        a_.subtract(0, 0, x);
      } else {
        a_.broadcast(1, number(term.number));
        a_.add_product(0, 1, x);
      }
    }
    if (k_ == 0 && i.a[1] != Instruction::none) {
      a_.broadcast(1, number(i.a[1]));
      a_.add(0, 0, 1);
    }
    a_.store(at_order(i.out[0]), 0);
  }

  // Quotients, or roots, from i on that do not need each other.
  const Instruction* emit_rests(const Instruction* i) {
    const Instruction* first = i;
    std::set<std::uint32_t> made;
    for (; i != tape_.each_end && i->op == first->op && !made.contains(i->a[0]) &&
           !(i->op == Op::quotient && made.contains(i->b[0]));
         ++i)
      made.insert(i->out[0]);
    if (k_ == 0)
      for (const Instruction* one = first; one != i; ++one)
        first->op == Op::quotient ? begin_quotient(*one) : begin_root(*one);
    else
      emit_all_rests(first, i);
    return i;
  }

  void begin_quotient(const Instruction& i) {
    a_.load(0, at_start(i.a[0]));
    a_.load(1, at_start(i.b[0]));
    a_.divide(0, 0, 1);
    a_.store(at_start(i.out[0]), 0);
    a_.broadcast(0, number(tape_.one));
    a_.divide(0, 0, 1);
    a_.store(at_start(i.out[1]), 0);
  }

  void begin_root(const Instruction& i) {
    a_.load(1, at_start(i.out[0]));
    a_.add(1, 1, 1);
    a_.broadcast(0, number(tape_.one));
    a_.divide(0, 0, 1);
    a_.store(at_start(i.out[1]), 0);
  }

  // As machine::quotient and machine::root: (a_k - the sum of the terms that are known) times the number that is kept
  void emit_all_rests(const Instruction* first, const Instruction* end) {
    const bool roots = first->op == Op::root;
    std::vector<One> sums;
    for (const Instruction* i = first; i != end; ++i)
      sums.push_back({0, i->out[0], roots ? i->out[0] : i->b[0]});
    in_parts(sums, [&](const One* part, int n) {
      emit_terms(part, n, roots ? Range::inner_to_half : Range::inner);
      roots ? emit_middle(part, n) : emit_ends(part, n, false);
      for (int m = 0; m < n; ++m) {
        const Instruction& i = first[part - sums.data() + m];
        a_.load(2 * m + 1, at_order(i.a[0]));
        a_.subtract(2 * m, 2 * m + 1, 2 * m);
        a_.multiply(2 * m, 2 * m, at_start(i.out[1]));
        a_.store(at_order(i.out[0]), 2 * m);
      }
    });
  }

  // As machine::power.
  void begin_power(const Instruction& i) {
    a_.load(0, at_start(i.b[0]));
    a_.load(1, at_start(i.b[0]));
    for (int n = 1; n < std::abs(i.exponent); ++n)
      a_.multiply(0, 0, 1);
    a_.broadcast(1, number(tape_.one));
    if (i.exponent < 0) a_.divide(0, 1, 0);
    a_.store(at_start(i.out[0]), 0);
    a_.load(0, at_start(i.b[0]));
    a_.multiply(0, 0, 0);
    a_.divide(0, 1, 0);
    a_.store(at_start(i.out[1]), 0);
    a_.clear(0);
    a_.store(at_start(i.out[2]), 0);
  }

  // A number beside those of order 0, for the present order.  Destroys rax where the order is not known.
  void broadcast_of_order(int to, Assembler::Gpr base, std::int32_t first) {
    if (k_ == unknown) {
      a_.move(rax, r10);
      a_.shift_left(rax, 3);
      a_.broadcast(to, {base, rax, first});
    } else {
      a_.broadcast(to, {base, -1, first + static_cast<std::int32_t>(sizeof(double)) * k_});
    }
  }

  void emit_power(const Instruction& i) {
    if (k_ == 0) return begin_power(i);
    const One sums[] = {{0, i.a[0], i.out[0]}, {0, i.a[0], i.out[2]}};
    emit_terms(sums, 2, Range::inner);
    a_.load(1, at_order(i.a[0]));
    a_.add_product(0, 1, at_start(i.out[0]));
    constexpr auto size = static_cast<std::int32_t>(sizeof(double));
    broadcast_of_order(1, rbp, -size); // 1/k
    a_.broadcast(3, number(i.a[2]));
    a_.multiply(1, 3, 1);
    a_.broadcast(3, number(i.a[1]));
    a_.multiply(0, 3, 0);
    a_.subtract_product(0, 1, 2);
    a_.multiply(0, 0, at_start(i.out[1]));
    a_.store(at_order(i.out[0]), 0);
    broadcast_of_order(1, rsi, (static_cast<std::int32_t>(tape_.one) - 1) * size); // k
    a_.multiply(0, 0, 1);
    a_.store(at_order(i.out[2]), 0);
  }

  static constexpr int unknown = -1;
  const Tape<double>& tape_;
  const MachineCode::Moving& moving_;
  Assembler a_;
  std::uint8_t shift_;
  int k_ = 0; ///< the order, where the code is straight
  /// Registers that point to the middle of 256 packs each; those that loops use are free in straight code.
  static constexpr std::int32_t reach = 256 * 64;
  static constexpr Assembler::Gpr pointers[] = {rax, rcx, rdx, r8, r10, r11};
  std::size_t parts_ = 0;
};

} // namespace

#if defined(__x86_64__) && defined(__linux__)

MachineCode::MachineCode(const Tape<double>& tape, const Moving& moving, int lanes, int first,
                         int end) {
  if ((lanes != 4 && lanes != 8) || tape.each == tape.each_end) return;
  const std::vector<std::uint8_t> bytes = Emitter(tape, moving, lanes).emit(first, end);
  void* pages =
      mmap(nullptr, bytes.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return;
  std::memcpy(pages, bytes.data(), bytes.size());
  if (mprotect(pages, bytes.size(), PROT_READ | PROT_EXEC) != 0) {
    munmap(pages, bytes.size());
    return;
  }
  pages_ = pages;
  size_ = bytes.size();
  code_ = reinterpret_cast<Tape<double>::Code>(pages);
}

MachineCode::~MachineCode() {
  if (pages_ != nullptr) munmap(pages_, size_);
}

#else

MachineCode::MachineCode(const Tape<double>&, const Moving&, int, int, int) {}
MachineCode::~MachineCode() = default;

#endif

} // namespace kov::flow
