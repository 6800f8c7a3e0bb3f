#include "symbol/written.hpp"

#include "exact/joined.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr int equation_binding = 1, sum_binding = 10, product_binding = 20, power_binding = 30,
              atom_binding = 40;

struct Piece {
  std::string text;
  int binding = atom_binding;
};

std::string at_least(const Piece& p, int binding) {
  return p.binding < binding ? "(" + p.text + ")" : p.text;
}

class Writer {
public:
  explicit Writer(const Instead& instead) : instead_(instead) {}

  [[nodiscard]] Piece operator()(const Expression& e) const {
    if (instead_)
      if (auto text = instead_(e)) return {*std::move(text), atom_binding};
    switch (e.kind()) {
    case Kind::number:
      return {to_string(e.number())};
    case Kind::decimal:
    case Kind::name:
      return {e.name()};
    case Kind::sum:
      return sum(terms_of(e));
    case Kind::negate:
      return {"-" + at_least((*this)(e.operand(0)), product_binding), sum_binding};
    case Kind::product:
      return product(e);
    case Kind::quotient: {
      Piece above = (*this)(e.operand(0)); // (-x)/y is -x/y
      const bool minus = takes_sign(e.operand(0), above);
      return {(minus ? "-" : "") + at_least(above, product_binding) + "/" +
                  at_least((*this)(e.operand(1)), power_binding),
              minus ? sum_binding : product_binding};
    }
    case Kind::power:
      return {at_least((*this)(e.operand(0)), atom_binding) + "^" +
                  at_least((*this)(e.operand(1)), atom_binding),
              power_binding};
    case Kind::call:
      return {e.name() + arguments(e)};
    case Kind::derivative:
      return derivative(e);
    case Kind::equation:
      return {(*this)(e.operand(0)).text + " = " + (*this)(e.operand(1)).text, equation_binding};
    }
    return {};
  }

  [[nodiscard]] Piece sum(const std::vector<SignedTerm>& terms) const {
    std::string text;
    for (const SignedTerm& t : terms) {
      Piece term = (*this)(t.term);
      bool minus = t.minus;
      if (takes_sign(t.term, term)) minus = !minus;
      text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
      text += at_least(term, product_binding);
    }
    return {text.empty() ? "0" : text, sum_binding};
  }

private:
  // The text without the sign that it begins with.
  static bool takes_sign(const Expression& e, Piece& p) {
    const bool may =
        e.kind() == Kind::negate || e.kind() == Kind::product || e.kind() == Kind::quotient;
    if (!may || p.binding != sum_binding) return false;
    p = {p.text.substr(1), product_binding};
    return true;
  }

  [[nodiscard]] Piece product(const Expression& e) const {
    bool minus = false; // (-x)*y is -x*y
    std::string text;
    for (const Expression& factor : e.operands()) {
      Piece p = (*this)(factor);
      if (text.empty()) minus = takes_sign(factor, p);
      const bool quotient = factor.kind() == Kind::quotient && !text.empty();
      text += (text.empty() ? "" : "*") + at_least(p, quotient ? power_binding : product_binding);
    }
    return {minus ? "-" + text : text, minus ? sum_binding : product_binding};
  }

  [[nodiscard]] std::string arguments(const Expression& e) const {
    return "(" + joined(e.operands(), [this](const Expression& x) { return (*this)(x).text; }) +
           ")";
  }

  [[nodiscard]] Piece derivative(const Expression& e) const {
    const Expression& f = e.operand(0);
    const std::string primes(static_cast<std::size_t>(e.order()), '\'');
    const bool plain = !instead_ || !instead_(f);
    if (f.kind() == Kind::call && plain) return {f.name() + primes + arguments(f)};
    return {at_least((*this)(f), atom_binding) + primes};
  }

  const Instead& instead_;
};

void gather(const Expression& e, bool minus, std::vector<SignedTerm>& terms) {
  switch (e.kind()) {
  case Kind::sum:
    for (const Expression& x : e.operands())
      gather(x, minus, terms);
    break;
  case Kind::negate:
    gather(e.operand(0), !minus, terms);
    break;
  case Kind::equation:
    gather(e.operand(0), minus, terms);
    gather(e.operand(1), !minus, terms);
    break;
  default:
    terms.push_back({minus, e});
  }
}

} // namespace

std::string written(const Expression& e, const Instead& instead) { return Writer(instead)(e).text; }

bool mentions_name(const Expression& e, const std::string& name) {
  const bool here = (e.kind() == Kind::name || e.kind() == Kind::call) && e.name() == name;
  return here || std::ranges::any_of(e.operands(),
                                     [&](const Expression& x) { return mentions_name(x, name); });
}

std::vector<SignedTerm> terms_of(const Expression& e) {
  std::vector<SignedTerm> terms;
  gather(e, false, terms);
  return terms;
}

std::string sum_of(const std::vector<SignedTerm>& terms, const Instead& instead) {
  return Writer(instead).sum(terms).text;
}

} // namespace kov
