#pragma once
// The few instructions of x86-64 that sums of products of packs need, as bytes.
//
// Packs of four doubles are VEX-encoded (AVX2, FMA; 16 registers), packs of eight EVEX-encoded (AVX-512 F and DQ; 32
// registers).  Addresses are [base + index + displacement]; a displacement is one byte where it is short enough, which
// for packs of eight is counted in their lengths.
//
// Source  Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, chapter 2

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace kov::flow {

class Assembler {
public:
  explicit Assembler(int lanes) : wide_(lanes == 8) { code_.reserve(1 << 15); }

  enum Gpr : std::uint8_t { rax, rcx, rdx, rbx, rsp, rbp, rsi, rdi, r8, r9, r10, r11 };
  struct Address {
    Gpr base = rdi;
    int index = -1; ///< -1: none
    std::int32_t displacement = 0;
  };

  [[nodiscard]] int registers() const { return wide_ ? 32 : 16; }
  [[nodiscard]] std::int32_t width() const { return wide_ ? 64 : 32; }
  [[nodiscard]] const std::vector<std::uint8_t>& code() const noexcept { return code_; }

  // ---- packs: to, from: registers ----
  void load(int to, const Address& a) { memory(0x0f, 0x10, to, 0, a); }
  void store(const Address& a, int from) { memory(0x0f, 0x11, from, 0, a); }
  void clear(int to) { between(0x0f, 0x57, to, to, to); }
  void add(int to, int a, int b) { between(0x0f, 0x58, to, a, b); }
  void subtract(int to, int a, int b) { between(0x0f, 0x5c, to, a, b); }
  void multiply(int to, int a, int b) { between(0x0f, 0x59, to, a, b); }
  void multiply(int to, int a, const Address& b) { memory(0x0f, 0x59, to, a, b); }
  void divide(int to, int a, int b) { between(0x0f, 0x5e, to, a, b); }
  /// to += a b
  void add_product(int to, int a, int b) { between(0x38, 0xb8, to, a, b); }
  void add_product(int to, int a, const Address& b) { memory(0x38, 0xb8, to, a, b); }
  /// to -= a b
  void subtract_product(int to, int a, int b) { between(0x38, 0xbc, to, a, b); }
  void add(int to, int a, const Address& b) { memory(0x0f, 0x58, to, a, b); }
  void subtract(int to, int a, const Address& b) { memory(0x0f, 0x5c, to, a, b); }
  /// One double in all lanes.
  void broadcast(int to, const Address& a) {
    memory(0x38, 0x19, to, 0, a, wide_ ? 1 : 0, sizeof(double));
  }

  // ---- integers ----
  void move(Gpr to, Gpr from) { integer(0x89, from, to); }
  void zero(Gpr to) { integer(0x31, to, to); }
  void add(Gpr to, std::int32_t n) { immediate(0, to, n); }
  void subtract(Gpr to, std::int32_t n) { immediate(5, to, n); }
  void bits(Gpr a, std::int32_t mask) { ///< sets the zero flag if none of these bits is set
    put({rex(0, a), 0xf7, mod(0, a)});
    put32(mask);
  }
  void compare(Gpr a, std::int32_t n) { immediate(7, a, n); }
  void compare(Gpr a, Gpr b) { integer(0x39, b, a); }
  void push(Gpr a) { put({0x50 | (a & 7)}); } ///< not r8 to r11
  void pop(Gpr a) { put({0x58 | (a & 7)}); }
  void shift_left(Gpr to, std::uint8_t n) { put({rex(0, to), 0xc1, mod(4, to), n}); }
  void shift_right(Gpr to, std::uint8_t n) { put({rex(0, to), 0xc1, mod(5, to), n}); }
  void leave() { put({0xc5, 0xf8, 0x77, 0xc3}); } ///< vzeroupper, ret

  // ---- jumps ----
  [[nodiscard]] std::size_t here() const { return code_.size(); }
  void back_unless_zero(std::size_t to) {
    put({0x0f, 0x85});
    put32(static_cast<std::int32_t>(to) - static_cast<std::int32_t>(code_.size() + 4));
  }
  void back_if_less(std::size_t to) {
    put({0x0f, 0x8c});
    put32(static_cast<std::int32_t>(to) - static_cast<std::int32_t>(code_.size() + 4));
  }
  [[nodiscard]] std::size_t forward_if_equal() { return forward_if_zero(); }
  [[nodiscard]] std::size_t forward_if_zero() { return forward({0x0f, 0x84}); }
  [[nodiscard]] std::size_t forward_unless_zero() { return forward({0x0f, 0x85}); }
  void land(std::size_t jump) {
    const auto distance = static_cast<std::uint32_t>(code_.size() - jump);
    for (std::size_t i = 0; i < 4; ++i)
      code_[jump - 4 + i] = static_cast<std::uint8_t>(distance >> (8 * i));
  }

private:
  void put(std::initializer_list<int> bytes) {
    for (const int b : bytes)
      code_.push_back(static_cast<std::uint8_t>(b));
  }
  void put32(std::int32_t n) {
    const auto u = static_cast<std::uint32_t>(n);
    for (int i = 0; i < 4; ++i)
      code_.push_back(static_cast<std::uint8_t>(u >> (8 * i)));
  }
  std::size_t forward(std::initializer_list<int> bytes) {
    put(bytes);
    put32(0);
    return code_.size();
  }
  static int rex(int reg, int rm) { return 0x48 | (reg >= 8 ? 4 : 0) | (rm >= 8 ? 1 : 0); }
  static int mod(int reg, int rm) { return 0xc0 | (reg & 7) << 3 | (rm & 7); }
  void integer(int op, int reg, int rm) { put({rex(reg, rm), op, mod(reg, rm)}); }
  void immediate(int op, Gpr to, std::int32_t n) {
    put({rex(0, to), 0x81, mod(op, to)});
    put32(n);
  }

  // map: 0x0f or 0x38 (0f 38).  All have the prefix 66; w: W, which VEX ignores in the first map and 0 is usual.
  void prefix(int map, int reg, int other, bool x, bool b, int w) {
    const int m = map == 0x0f ? 1 : 2;
    if (wide_)
      put({0x62, (reg & 8 ? 0 : 0x80) | (x ? 0 : 0x40) | (b ? 0 : 0x20) | (reg & 16 ? 0 : 0x10) | m,
           w << 7 | (~other & 15) << 3 | 4 | 1, 0x40 | (other & 16 ? 0 : 8)});
    else
      put({0xc4, (reg & 8 ? 0 : 0x80) | (x ? 0 : 0x40) | (b ? 0 : 0x20) | m,
           (m == 1 ? 0 : w) << 7 | (~other & 15) << 3 | 4 | 1});
  }
  void between(int map, int op, int to, int a, int b) {
    prefix(map, to, a, (b & 16) != 0, (b & 8) != 0, 1);
    put({op, mod(to, b)});
  }
  // unit: bytes of what is read, in which a short displacement of EVEX is counted
  void memory(int map, int op, int reg, int other, const Address& a, int w = 1, int unit = 64) {
    prefix(map, reg, other, a.index >= 8, a.base >= 8, w);
    const int scale = wide_ ? unit : 1, brief = a.displacement / scale;
    const bool is_brief = a.displacement % scale == 0 && brief >= -128 && brief < 128;
    const int mode = is_brief ? 0x40 : 0x80;
    if (a.index < 0) {
      put({op, mode | (reg & 7) << 3 | (a.base & 7)});
    } else {
      put({op, mode | (reg & 7) << 3 | 4, (a.index & 7) << 3 | (a.base & 7)});
    }
    if (is_brief)
      put({brief & 0xff});
    else
      put32(a.displacement);
  }

  bool wide_;
  std::vector<std::uint8_t> code_;
};

} // namespace kov::flow
