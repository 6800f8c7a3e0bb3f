#include "symbol/operators.hpp"

#include "exact/lists.hpp"
#include "symbol/one_name.hpp"
#include "symbol/tokens.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr long max_operator_order = 20; // higher derivatives are left to the reader's own message

/// An operator, applied to a function: both are texts.
class Application {
public:
  Application(const Derivation& d, std::size_t longest) : d_(d), longest_(longest) {}

  [[nodiscard]] std::string operator()(const Expression& e, const std::string& y) const {
    if (y.size() > longest_) throw too_long(e);
    if (!mentions_name(e, d_.name)) return "((" + written(e) + ")*" + y + ")";
    switch (e.kind()) {
    case Kind::name:
      return d_.euler ? "(" + d_.variable + "*(" + y + ")')" : "(" + y + ")'";
    case Kind::negate:
      return "(-" + (*this)(e.operand(0), y) + ")";
    case Kind::sum:
      return sum(e, y);
    case Kind::product:
      return product(e.operands(), y);
    case Kind::quotient:
      if (mentions_name(e.operand(1), d_.name)) throw no_operator(e);
      return "(" + (*this)(e.operand(0), y) + "/(" + written(e.operand(1)) + "))";
    case Kind::power:
      return power(e, y);
    case Kind::equation:
      return (*this)(e.operand(0), y) + " = " + (*this)(e.operand(1), y);
    default:
      throw no_operator(e);
    }
  }

  [[nodiscard]] std::string product(const std::vector<Expression>& factors, std::string y) const {
    for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor)
      y = (*this)(*factor, y);
    return y;
  }

private:
  [[nodiscard]] static InputError too_long(const Expression& e) {
    return e.error("this product of operators is too long");
  }
  [[nodiscard]] InputError no_operator(const Expression& e) const {
    return e.error("this is not an operator in " + d_.name,
                   "write polynomials in " + d_.name + ", with the coefficients on the left");
  }
  [[nodiscard]] std::string sum(const Expression& e, const std::string& y) const {
    std::string result;
    for (const Expression& term : e.operands()) {
      result += (result.empty() ? "(" : "+") + (*this)(term, y);
      if (result.size() > longest_) throw too_long(e);
    }
    return result + ")";
  }
  [[nodiscard]] std::string power(const Expression& e, std::string y) const {
    const Expression& n = e.operand(1);
    if (n.kind() != Kind::number || n.number() > Integer(max_operator_order))
      throw n.error("the exponent of an operator is a small number");
    for (long i = to_long(n.number()); i > 0; --i)
      y = (*this)(e.operand(0), y);
    return y;
  }

  const Derivation& d_;
  std::size_t longest_;
};

// The function at the right end of a term: y of D^2*y.
std::optional<std::string> function_of(const Expression& term) {
  static constexpr std::array<std::string_view, 4> usual{"y", "u", "w", "f"};
  const Expression& last = term.kind() == Kind::product ? term.operands().back() : term;
  const bool named = last.kind() == Kind::name || last.kind() == Kind::call;
  if (!named || !is_among(last.name(), usual)) return std::nullopt;
  return last.name();
}

// The one function of all terms in which d stands.
std::optional<std::string> function_in(const std::vector<SignedTerm>& terms, const std::string& d) {
  std::optional<std::string> found;
  for (const auto& [minus, term] : terms) {
    if (!mentions_name(term, d)) continue;
    const auto here = function_of(term);
    if (!here || (found && *found != *here)) return std::nullopt;
    found = here;
  }
  return found;
}

// L y = f, f without y.
std::string with_function(const std::vector<SignedTerm>& terms, const std::string& y,
                          const Application& apply) {
  std::string text;
  for (const auto& [minus, term] : terms) {
    text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
    if (!mentions_name(term, y)) {
      text += "(" + written(term) + ")";
      continue;
    }
    if (function_of(term) != y)
      throw term.error("'" + y + "' is expected at the right end of a term");
    if (term.kind() != Kind::product) {
      text += written(term);
      continue;
    }
    std::vector<Expression> factors = term.operands();
    const std::string function = written(factors.back());
    factors.pop_back();
    text += apply.product(factors, function);
  }
  return text + " = 0";
}

} // namespace

bool differentiates(const Expression& e) {
  return e.kind() == Kind::derivative || (e.kind() == Kind::call && e.name() == "diff") ||
         std::ranges::any_of(e.operands(), differentiates);
}

std::optional<Derivation> derivation_in(const Expression& e) {
  std::optional<Derivation> found;
  for (const std::string& name : names_in(e)) {
    const bool letter = name.size() > 1 && name.front() == 'D' && is_one_name(name.substr(1));
    if (!letter) continue;
    if (found) return std::nullopt;
    found = Derivation{name, name.substr(1)};
  }
  return !found || differentiates(e) ? std::nullopt : found;
}

Expression applied(const Expression& e, const Derivation& d, std::size_t longest) {
  const Application apply(d, longest);
  const auto terms = terms_of(e);
  const auto function = function_in(terms, d.name);
  std::string text;
  if (function) {
    text = with_function(terms, *function, apply);
  } else {
    const std::string y = mentions_name(e, "y") ? "u" : "y";
    text = apply(e, d.variable.empty() ? y : y + "(" + d.variable + ")");
  }
  // Messages point at the operator as it was written.
  Tokens cut(text, origin_of_text(e.origin().file, text));
  cut.decimals_allowed = 1;
  std::vector<Token> tokens;
  do {
    tokens.push_back(cut.next());
    tokens.back().span = e.span();
  } while (tokens.back().kind != TokenKind::end);
  const OriginPtr origin = std::make_shared<const Origin>(e.origin());
  return parse_tokens(Tokens(origin->text, origin, std::move(tokens)), ParseLimits{});
}

} // namespace kov
