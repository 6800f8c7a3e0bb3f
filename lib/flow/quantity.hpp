#pragma once
// A number as a scene writes it: 8/9, sqrt(11)/24, 3*pi/2, 1e-9.  It keeps its text, so that every number
// type gets it with its own precision (and exact rationals exactly).
//
//   sum     = product (("+" | "-") product)*
//   product = signed (("*" | "/") signed)*
//   signed  = "-"* power                     power = atom ("^" "-"? digits)?       (-2^2 = -4)
//   atom    = digits | digits "e" "-"? digits | "pi" | "sqrt" "(" sum ")" | "(" sum ")"

#include "exact/error.hpp"
#include "exact/integer.hpp"
#include "flow/big_real.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace kov::flow {

/// Text that is not a quantity, or a number type that cannot hold it; offset counts from 0.
class QuantityError : public InvalidArgument {
public:
  QuantityError(const std::string& what, std::size_t offset)
      : InvalidArgument(what), offset_(offset) {}
  [[nodiscard]] std::size_t offset() const noexcept { return offset_; }

private:
  std::size_t offset_;
};

// How a number type makes an integer, a root and pi.
template <class R> struct QuantityTraits {
  static R integer(const std::string& digits) { return static_cast<R>(std::stold(digits)); }
  static R root(const R& x) { return std::sqrt(x); }
  static R pi() { return pi_of(R(0)); }
};
template <> struct QuantityTraits<BigReal> {
  static BigReal integer(const std::string& digits) {
    BigReal r;
    mpfr_set_str(r.raw(), digits.c_str(), 10, MPFR_RNDN);
    return r;
  }
  static BigReal root(const BigReal& x) { return sqrt(x); }
  static BigReal pi() { return pi_of(BigReal()); }
};
template <> struct QuantityTraits<Rational> {
  static Rational integer(const std::string& digits) { return Rational(Integer::parse(digits)); }
  static Rational root(const Rational& x) {
    const auto r = exact_sqrt(x);
    if (!r) throw InvalidArgument("sqrt(" + kov::to_string(x) + ") is not rational");
    return *r;
  }
  static Rational pi() { throw InvalidArgument("pi is not rational"); }
};

template <class R> class QuantityReader {
public:
  explicit QuantityReader(std::string_view text) : text_(text) {}
  R all() {
    R value = sum();
    if (at_ != text_.size()) fail("unexpected '" + std::string(1, text_[at_]) + "'");
    return value;
  }

private:
  using Traits = QuantityTraits<R>;
  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;

  [[noreturn]] void fail(const std::string& what) const {
    throw QuantityError(what + " in the number '" + std::string(text_) + "'", at_);
  }
  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ')
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(std::string_view word) {
    peek();
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  std::string digits() {
    peek();
    std::string d;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9')
      d += text_[at_++];
    if (d.empty()) fail(at_ == text_.size() ? "a number is missing at the end" : "a number is missing");
    if (d.size() > 1000) fail("a number of more than 1000 digits");
    return d;
  }
  R sum() {
    if (++depth_ > 200) fail("too many parentheses");
    R value = product();
    while (true) {
      if (take("+"))
        value = value + product();
      else if (take("-"))
        value = value - product();
      else
        break;
    }
    --depth_;
    return value;
  }
  R product() {
    R value = signed_power();
    while (true) {
      if (take("*")) {
        value = value * signed_power();
      } else if (take("/")) {
        const R d = signed_power();
        if (d == R(0)) fail("division by zero");
        value = value / d;
      } else {
        return value;
      }
    }
  }
  R signed_power() {
    bool negative = false;
    while (take("-"))
      negative = !negative;
    R value = power();
    return negative ? R(R(0) - value) : value;
  }
  R power() {
    R base = atom();
    return take("^") ? raised(base) : base;
  }
  R raised(const R& base) {
    const bool inverse = take("-");
    const std::string d = digits();
    if (d.size() > 4) fail("an exponent over 9999");
    R value(1);
    for (int n = std::stoi(d); n > 0; --n)
      value = value * base;
    if (!inverse) return value;
    if (value == R(0)) fail("division by zero");
    return R(1) / value;
  }
  R atom() {
    if (take("(")) return closed();
    if (take("sqrt")) {
      if (!take("(")) fail("'(' is missing after sqrt");
      const R x = closed();
      if (x < R(0)) fail("the root of a negative number");
      return Traits::root(x);
    }
    if (take("pi") || take("Pi")) return Traits::pi();
    const R value = Traits::integer(digits());
    if (at_ < text_.size() && text_[at_] == '.')
      fail("a decimal point (write a fraction such as 1/2)");
    return take("e") ? value * raised(R(10)) : value;
  }
  R closed() {
    R value = sum();
    if (!take(")")) fail("')' is missing");
    return value;
  }
};

struct Quantity {
  std::string text = "0";
  template <class R> [[nodiscard]] R as() const { return QuantityReader<R>(text).all(); }
};

} // namespace kov::flow
