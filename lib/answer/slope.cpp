#include "answer/slope.hpp"

#include "symbol/formula.hpp"
#include "symbol/known_functions.hpp"
#include "symbol/written.hpp"

#include <functional>
#include <map>

namespace kov::answer {

using Kind = Expression::Kind;
using trees::number;
using trees::product;

// B1^e1 B2^e2 ...
std::vector<std::pair<Expression, Expression>> powers_in(const Expression& e) {
  std::vector<std::pair<Expression, Expression>> all;
  const std::function<void(const Expression&, const Rational&)> take = [&](const Expression& x,
                                                                           const Rational& sign) {
    const bool root = x.kind() == Kind::call && x.name() == "sqrt";
    if (x.kind() == Kind::product) {
      for (const Expression& y : x.operands())
        take(y, sign);
    } else if (x.kind() == Kind::quotient) {
      take(x.operand(0), sign);
      take(x.operand(1), -sign);
    } else if (x.kind() == Kind::negate) {
      all.emplace_back(number(-1), number(1));
      take(x.operand(0), sign);
    } else if (x.kind() == Kind::power || root) {
      const Expression exponent = root ? number(Rational(1, 2)) : x.operand(1);
      all.emplace_back(x.operand(0), product({number(sign), exponent}));
    } else {
      all.emplace_back(x, number(sign));
    }
  };
  take(e, Rational(1));
  return all;
}

Expression distributed(const Expression& factor, const Expression& e) {
  if (e.kind() != Kind::sum) return product({factor, e});
  std::vector<Expression> terms;
  for (const Expression& x : e.operands())
    terms.push_back(product({factor, x}));
  return trees::sum(terms);
}

namespace {

std::optional<Expression> slope_of_call(const Expression& e, const std::string& x) {
  if (e.name() == "int" && e.operands().size() == 2 && written(e.operand(1)) == x)
    return e.operand(0);
  const KnownFunction* f = known_function(e.name(), e.operands().size());
  if (f == nullptr) return std::nullopt;
  std::map<std::string, Expression> values;
  for (std::size_t i = 0; i < f->arguments.size(); ++i)
    values.emplace(f->arguments[i], e.operand(i));
  if (f->means) return slope(trees::rebuilt(*f->means, values), x);
  const auto inner = slope(e.operands().back(), x);
  if (!inner) return std::nullopt;
  return distributed(*inner, trees::rebuilt(*f->slope, values));
}

} // namespace

std::optional<Expression> slope(const Expression& e, const std::string& x) {
  if (!mentions_name(e, x)) return number(0);
  switch (e.kind()) {
  case Kind::name:
    return number(1);
  case Kind::negate:
  case Kind::sum: {
    std::vector<Expression> terms;
    for (const Expression& y : e.operands()) {
      const auto d = slope(y, x);
      if (!d) return std::nullopt;
      terms.push_back(e.kind() == Kind::negate ? trees::negative(*d) : *d);
    }
    return trees::sum(terms);
  }
  case Kind::call:
    if (e.name() != "sqrt") return slope_of_call(e, x);
    [[fallthrough]];
  default: { // products and powers
    const auto all = powers_in(e);
    std::vector<Expression> terms;
    for (const auto& [base, exponent] : all) {
      if (!mentions_name(base, x)) continue;
      const auto d = slope(base, x);
      if (!d || mentions_name(exponent, x)) return std::nullopt;
      terms.push_back(distributed(product({e, exponent, trees::power(base, number(-1))}), *d));
    }
    return trees::sum(terms);
  }
  }
}

} // namespace kov::answer
