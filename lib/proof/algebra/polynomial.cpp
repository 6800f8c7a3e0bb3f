// Polynomials of kovacic-strata/1 as text: terms joined by " + " and " - ", factors by "*"
// (strata_certificates.md 2).

#include "exact/error.hpp"
#include "proof/algebra/arithmetic.hpp"
#include "proof/text/json_node.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

class PolynomialReader {
public:
  PolynomialReader(const Ring& ring, std::string_view text) : ring_(ring), s_(text), f_(ring) {}

  MPoly operator()() {
    if (s_ == "0") return f_;
    bool negative = take("-");
    for (std::size_t terms = 1;; ++terms) {
      if (terms > max_terms) fail("more than 20000 terms");
      term(negative);
      if (s_.empty()) break;
      negative = take(" - ");
      if (!negative && !take(" + ")) fail("' + ' or ' - ' is expected");
    }
    fmpz_mpoly_sort_terms(f_.raw(), f_.ctx());
    fmpz_mpoly_combine_like_terms(f_.raw(), f_.ctx());
    return std::move(f_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidArgument("not a polynomial: " + what + " before '" +
                          std::string(s_.substr(0, 30)) + "'");
  }
  bool take(std::string_view w) {
    if (s_.substr(0, w.size()) != w) return false;
    s_.remove_prefix(w.size());
    return true;
  }
  template <class Is> std::string_view word(Is is) {
    const auto end = std::ranges::find_if_not(s_, is);
    const auto w = s_.substr(0, static_cast<std::size_t>(end - s_.begin()));
    s_.remove_prefix(w.size());
    return w;
  }
  static bool digit(char c) { return c >= '0' && c <= '9'; }
  static bool letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || digit(c);
  }

  void term(bool negative) {
    Integer c(1);
    std::vector<unsigned long> e(ring_->size());
    bool more = true;
    if (!s_.empty() && digit(s_[0])) {
      const auto digits = word(digit);
      if (digits != "0" && (!is_natural(digits) || digits.size() > max_digits))
        fail("a natural number of at most 10000 digits is expected");
      c = Integer::parse(digits);
      more = take("*");
    }
    for (; more; more = take("*"))
      factor(e);
    if (negative) c = -c;
    if (!is_zero(c)) fmpz_mpoly_push_term_fmpz_ui(f_.raw(), c.raw(), e.data(), f_.ctx());
  }

  void factor(std::vector<unsigned long>& e) {
    const auto name = word(letter);
    const auto i = ring_->find(name);
    if (!i) fail("'" + std::string(name) + "' is not a variable");
    unsigned long k = 1;
    if (take("^")) {
      const auto digits = word(digit);
      if (digits.empty() || digits.size() > 4 || (digits.size() > 1 && digits[0] == '0'))
        fail("an exponent below 10000 is expected");
      k = std::stoul(std::string(digits));
    }
    e[*i] += k;
    if (e[*i] >= max_exponent) fail("the exponents must be below 10000");
  }

  const Ring& ring_;
  std::string_view s_;
  MPoly f_;
};

} // namespace

MPoly read_polynomial(const Ring& ring, std::string_view text) {
  return PolynomialReader(ring, text)();
}

MPoly read_poly(const Ring& ring, const Node& n) {
  try {
    return read_polynomial(ring, n.text());
  } catch (const InvalidArgument& e) {
    n.fail(e.what());
  }
}

Ring ring_of(const Node& n, const std::vector<std::string>& names) {
  for (const std::string& s : names)
    if (!is_name(s) || std::ranges::count(names, s) != 1)
      n.fail("different names of letters, digits and _ are expected");
  return make_ring(names);
}

MPoly read_poly(const Ring& ring, const Node& n, const std::vector<bool>& names) {
  MPoly f = read_poly(ring, n);
  if (!is_in(f, names)) n.fail("a name that does not occur here");
  return f;
}

} // namespace kov::certify
