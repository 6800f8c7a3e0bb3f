#include "symbol/written.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr int of_equation = 1, of_sum = 10, of_product = 20, of_power = 30, of_atom = 40;

struct Piece {
  std::string text;
  int binding = of_atom;
};

std::string at_least(const Piece& p, int binding) {
  return p.binding < binding ? "(" + p.text + ")" : p.text;
}

class Writer {
public:
  explicit Writer(const Instead& instead) : instead_(instead) {}

  [[nodiscard]] Piece operator()(const Expression& e) const {
    if (instead_)
      if (auto text = instead_(e)) return {*std::move(text), of_atom};
    switch (e.kind()) {
    case Kind::number:
      return {to_string(e.number())};
    case Kind::decimal:
    case Kind::name:
      return {e.name()};
    case Kind::sum:
      return sum(terms_of(e));
    case Kind::negate:
      return {"-" + at_least((*this)(e.operand(0)), of_product), of_sum};
    case Kind::product:
      return product(e);
    case Kind::quotient:
      return {at_least((*this)(e.operand(0)), of_product) + "/" +
                  at_least((*this)(e.operand(1)), of_power),
              of_product};
    case Kind::power:
      return {at_least((*this)(e.operand(0)), of_atom) + "^" +
                  at_least((*this)(e.operand(1)), of_atom),
              of_power};
    case Kind::call:
      return {e.name() + arguments(e)};
    case Kind::derivative:
      return derivative(e);
    case Kind::equation:
      return {(*this)(e.operand(0)).text + " = " + (*this)(e.operand(1)).text, of_equation};
    }
    return {};
  }

  [[nodiscard]] Piece sum(const std::vector<SignedTerm>& terms) const {
    std::string text;
    for (const SignedTerm& t : terms) {
      const std::string term = at_least((*this)(t.term), of_product);
      text += text.empty() ? (t.minus ? "-" : "") : (t.minus ? " - " : " + ");
      text += term;
    }
    return {text.empty() ? "0" : text, of_sum};
  }

private:
  [[nodiscard]] Piece product(const Expression& e) const {
    std::string text;
    for (const Expression& factor : e.operands()) {
      const Piece p = (*this)(factor);
      const bool quotient = factor.kind() == Kind::quotient && !text.empty();
      text += (text.empty() ? "" : "*") + at_least(p, quotient ? of_power : of_product);
    }
    return {text, of_product};
  }

  [[nodiscard]] std::string arguments(const Expression& e) const {
    std::string text;
    for (const Expression& x : e.operands())
      text += (text.empty() ? "(" : ", ") + (*this)(x).text;
    return text + ")";
  }

  [[nodiscard]] Piece derivative(const Expression& e) const {
    const Expression& f = e.operand(0);
    const std::string primes(static_cast<std::size_t>(e.order()), '\'');
    const bool plain = !instead_ || !instead_(f);
    if (f.kind() == Kind::call && plain) return {f.name() + primes + arguments(f)};
    return {at_least((*this)(f), of_atom) + primes};
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
  return here || std::any_of(e.operands().begin(), e.operands().end(),
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
