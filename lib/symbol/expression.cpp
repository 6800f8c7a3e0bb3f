#include "symbol/expression.hpp"

#include "symbol/tokens.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

// Binding powers; a larger one binds closer.
constexpr int of_equation = 1;
constexpr int of_sum = 10;
constexpr int of_product = 20;
constexpr int of_minus = 25;
constexpr int of_power = 30;

Span join(Span a, Span b) { return make_span(a.offset, b.offset + b.length); }

bool has_one_argument(const std::string& function) {
  static const std::set<std::string> all{"sqrt", "exp",  "log",  "ln",  "sin",  "cos",
                                         "tan",  "cot",  "sec",  "csc", "sinh", "cosh",
                                         "tanh", "coth", "sech", "csch"};
  return all.contains(function);
}

} // namespace

Expression Expression::made(Kind kind, std::vector<Expression> operands, std::string name,
                            long order) {
  static const OriginPtr nowhere = origin_of_text("a formula", "");
  Node node{.kind = kind, .order = order, .name = std::move(name)};
  for (const Expression& x : operands)
    node.depth = std::max(node.depth, x.node_->depth + 1);
  node.operands = std::move(operands);
  return {std::make_shared<const Node>(std::move(node)), nowhere, Span{}};
}

Expression Expression::made(const Integer& n) {
  Expression e = made(Kind::number, {});
  Node node = *e.node_;
  node.number = n;
  e.node_ = std::make_shared<const Node>(std::move(node));
  return e;
}

namespace {

// The text of a token, as it was written.
std::string token_text(const Tokens& tokens, const Token& t) {
  return quoted(tokens.text().substr(t.span.offset, t.span.length));
}

[[noreturn]] void missing_operand(const Tokens& tokens, const Token& t) {
  throw tokens.error(t.span, t.kind == Token::Kind::end
                                 ? "the formula ends where a term is expected"
                                 : "a term is missing before " + token_text(tokens, t));
}

[[noreturn]] void unexpected_tail(const Tokens& tokens, const Token& t) {
  if (t.is(")")) throw tokens.error(t.span, "this ')' closes nothing");
  throw tokens.error(t.span, "unexpected " + token_text(tokens, t),
                     t.is(",") ? "write fractions as 1/2 and long numbers without separators" : "");
}

// 2z, 2(z+1), (z+1)(z-1), z w
void refuse_implied_product(const Expression& left, const Tokens& tokens, const Token& t) {
  const bool starts_a_term = t.kind == Token::Kind::number || t.kind == Token::Kind::decimal ||
                             t.kind == Token::Kind::name || t.is("(");
  if (!starts_a_term) return;
  const auto shown = [](std::string_view s) {
    return s.size() <= 24 ? std::string(s) : std::string("(...)");
  };
  throw tokens.error(t.span, "a '*' is missing before " + token_text(tokens, t),
                     "products are written out: " + shown(left.text()) + "*" +
                         (t.is("(") ? "(...)" : shown(t.text)));
}

bool is_zero_literal(const Expression& e) {
  return e.kind() == Expression::Kind::number && e.number() == Integer(0);
}

} // namespace

/// A Pratt parser: one loop, binding powers as above.  Of no use after an error.
class ExpressionParser {
public:
  ExpressionParser(Tokens tokens, const ParseLimits& limits)
      : tokens_(std::move(tokens)), limits_(limits) {}

  Expression read(bool allow_equation) {
    if (const std::size_t n = tokens_.text().size(); n > limits_.max_length)
      throw tokens_.error(Span{0, 1}, "a text of " + std::to_string(n) +
                                          " bytes is too long (limit " +
                                          std::to_string(limits_.max_length) + ")");
    allow_equation_ = allow_equation;
    advance();
    if (token_.kind == Token::Kind::end) throw tokens_.error(token_.span, "a formula is missing");
    Expression e = expression(0);
    if (token_.kind != Token::Kind::end) unexpected_tail(tokens_, token_);
    return e;
  }

private:
  using Kind = Expression::Kind;
  using Node = Expression::Node;

  void advance() {
    previous_end_ = token_.span.offset + token_.span.length;
    token_ = tokens_.next();
  }
  [[nodiscard]] bool at(std::string_view sign) const { return token_.is(sign); }

  // --- grammar ------------------------------------------------------------------------------

  Expression expression(int binding) {
    if (++depth_ > limits_.max_depth) too_deep(token_.span);
    Expression left = prefix();
    for (;;) {
      if (at("'")) {
        left = primes(left);
      } else if (at("^") && binding <= of_power) { // <=: associates to the right
        advance();
        const Expression exponent = expression(of_power);
        if (is_zero_literal(left) && is_zero_literal(exponent))
          throw left.error("0^0 has no value");
        left = of(Kind::power, {left, exponent}, left.span());
      } else if ((at("*") || at("/")) && binding < of_product) {
        left = chain(left, of_product);
      } else if ((at("+") || at("-")) && binding < of_sum) {
        left = chain(left, of_sum);
      } else if (at("=") && binding < of_equation) {
        left = equation(left);
      } else {
        refuse_implied_product(left, tokens_, token_);
        --depth_;
        return left;
      }
    }
  }

  Expression prefix() {
    const Token t = token_;
    if (t.kind == Token::Kind::number) {
      Node n{.kind = Kind::number};
      n.number = Integer::parse(t.text);
      advance();
      return finish(std::move(n), t.span);
    }
    if (t.kind == Token::Kind::name || t.kind == Token::Kind::decimal) {
      advance();
      if (t.kind == Token::Kind::name && at("(")) return call(std::string(t.text), t.span);
      Node n{.kind = t.kind == Token::Kind::name ? Kind::name : Kind::decimal};
      n.name = t.text;
      return finish(std::move(n), t.span);
    }
    if (at("(")) return parenthesis();
    if (at("-") || at("+")) {
      advance();
      const Expression e = expression(of_minus);
      return t.is("+") ? e : of(Kind::negate, {e}, t.span);
    }
    missing_operand(tokens_, token_);
  }

  Expression parenthesis() {
    const Span open = token_.span;
    advance();
    Expression e = expression(0);
    close(open);
    e.span_ = make_span(open.offset, previous_end_); // carets cover the parentheses
    return e;
  }

  Expression call(std::string name, Span at_name) {
    const Span open = token_.span;
    Node n{.kind = Kind::call};
    n.name = std::move(name);
    // root(p, approx): the second argument only chooses a root, so it may be a decimal
    const int outer = tokens_.decimals_allowed;
    advance();
    if (at(")"))
      throw tokens_.error(join(at_name, token_.span),
                          quoted(std::string_view(n.name)) + " has no argument");
    for (;;) {
      n.operands.push_back(expression(0));
      if (!at(",")) break;
      tokens_.decimals_allowed = n.name == "root" ? 1 : outer;
      advance();
    }
    tokens_.decimals_allowed = outer;
    close(open);
    if (n.operands.size() != 1 && has_one_argument(n.name))
      throw tokens_.error(make_span(at_name.offset, previous_end_), n.name + " has one argument",
                          "write a root of another order as x^(1/3)");
    return finish(std::move(n), make_span(at_name.offset, previous_end_));
  }

  void close(Span open) {
    if (at(")")) return advance();
    if (token_.kind == Token::Kind::end)
      throw tokens_.error(open, "this parenthesis is never closed", "a ')' is missing");
    unexpected_tail(tokens_, token_);
  }

  // y'', and y''(z) as the derivative of y(z)
  Expression primes(const Expression& e) {
    Node n{.kind = Kind::derivative};
    for (; at("'"); advance())
      ++n.order;
    const bool argument = at("(") && e.kind() == Kind::name;
    n.operands = {argument ? call(e.name(), e.span()) : e};
    return finish(std::move(n), make_span(e.span().offset, previous_end_));
  }

  // a + b - c and a * b / c, left to right; runs of + and of * become one node
  Expression chain(const Expression& first, int level) {
    const std::string_view plus = level == of_sum ? "+" : "*";
    const std::string_view minus = level == of_sum ? "-" : "/";
    std::vector<Expression> run{first};
    const auto gathered = [&] {
      const Span begin = run.front().span();
      return run.size() == 1
                 ? run.front()
                 : of(level == of_sum ? Kind::sum : Kind::product, std::move(run), begin);
    };
    while (at(plus) || at(minus)) {
      const Token sign = token_;
      advance();
      const Expression next = expression(level);
      if (sign.is(plus))
        run.push_back(next);
      else if (level == of_sum)
        run.push_back(of(Kind::negate, {next}, sign.span));
      else
        run = {of(Kind::quotient, {gathered(), next}, first.span())};
    }
    return gathered();
  }

  Expression equation(const Expression& left) {
    if (!allow_equation_)
      throw tokens_.error(token_.span, "an '=' does not belong here", "write only the expression");
    const Token sign = token_;
    advance();
    if (at("="))
      throw tokens_.error(join(sign.span, token_.span), "unexpected '=='", "write a single =");
    const Expression right = expression(of_equation);
    if (at("=")) throw tokens_.error(token_.span, "a second '='", "an equation has one = sign");
    return of(Kind::equation, {left, right}, left.span());
  }

  Expression of(Kind kind, std::vector<Expression> operands, Span begin) {
    Node n{.kind = kind};
    const Span span = join(begin, operands.back().span());
    n.operands = std::move(operands);
    return finish(std::move(n), span);
  }

  Expression finish(Node n, Span span) {
    for (const Expression& e : n.operands)
      n.depth = std::max(n.depth, e.node_->depth + 1);
    if (n.depth > limits_.max_depth) too_deep(span);
    return {std::make_shared<const Node>(std::move(n)), tokens_.origin(), span};
  }

  [[noreturn]] void too_deep(Span where) const {
    throw tokens_.error({where.offset, 1},
                        "this is nested more than " + std::to_string(limits_.max_depth) + " deep");
  }

  Tokens tokens_;
  ParseLimits limits_;
  bool allow_equation_ = false;
  long depth_ = 0;
  std::size_t previous_end_ = 0;
  Token token_;
};

std::string_view Expression::text() const {
  const std::string_view all = origin_->text;
  const std::size_t begin = std::min(origin_->offset + span_.offset, all.size());
  return all.substr(begin, span_.length);
}

Expression parse_expression(std::string_view text, OriginPtr origin, bool allow_equation,
                            const ParseLimits& limits) {
  return ExpressionParser(Tokens(text, std::move(origin)), limits).read(allow_equation);
}

Expression parse_expression(std::string text, const std::string& name, bool allow_equation,
                            const ParseLimits& limits) {
  const OriginPtr origin = origin_of_text(name, std::move(text));
  return parse_expression(origin->text, origin, allow_equation, limits);
}

Expression parse_tokens(Tokens tokens, const ParseLimits& limits, bool allow_equation) {
  return ExpressionParser(std::move(tokens), limits).read(allow_equation);
}

namespace {

void gather_names(const Expression& e, std::set<std::string>& names) {
  if (e.kind() == Expression::Kind::name) names.insert(e.name());
  if (e.kind() == Expression::Kind::call && e.name() == "root") return; // its variable is bound
  for (const Expression& operand : e.operands())
    gather_names(operand, names);
}

} // namespace

const Expression* find_name(const Expression& e, const std::string& name) {
  if (e.kind() == Expression::Kind::name && e.name() == name) return &e;
  for (const Expression& operand : e.operands())
    if (const Expression* found = find_name(operand, name)) return found;
  return nullptr;
}

std::vector<std::string> names_in(const Expression& e) {
  std::set<std::string> names;
  gather_names(e, names);
  return {names.begin(), names.end()};
}

std::optional<Rational> as_rational(const Expression& e) {
  using Kind = Expression::Kind;
  switch (e.kind()) {
  case Kind::number:
    return Rational(e.number());
  case Kind::negate:
    if (const auto a = as_rational(e.operand(0))) return -*a;
    return std::nullopt;
  case Kind::product: {
    Rational product(1);
    for (const Expression& factor : e.operands()) {
      const auto a = as_rational(factor);
      if (!a) return std::nullopt;
      product *= *a;
    }
    return product;
  }
  case Kind::quotient: {
    const auto a = as_rational(e.operand(0));
    const auto b = as_rational(e.operand(1));
    if (!a || !b || is_zero(*b)) return std::nullopt;
    return *a / *b;
  }
  default:
    return std::nullopt;
  }
}

} // namespace kov
