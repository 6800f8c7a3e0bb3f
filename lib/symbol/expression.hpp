#pragma once
// The text of a formula as a small immutable tree.  Nothing is computed here and no name has a
// meaning yet: whoever evaluates the tree decides (rational_form.hpp, lib/equation, lib/system).
//
//   equation   expression '=' expression                        (only where the caller allows it)
//   +  -       left;   a - b is sum(a, negate(b))
//   *  /       left
//   unary -    below ^:  -a^2 = -(a^2),  2^-3^2 = 2^(-(3^2))
//   ^  **      right
//   '          derivative of what stands before it:  y'', y''(z)
//   atoms      digits, names, name(args), (expression)
//
// Decimals and implied multiplication are refused with the text to write instead.

#include "exact/integer.hpp"
#include "symbol/input_error.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kov {

/// A node with its source text.  A value: cheap to copy, never changes.
class Expression {
public:
  enum class Kind : std::uint8_t {
    number,     ///< number(): an integer >= 0
    decimal,    ///< name(): digits as written; only in the second argument of root(p, approx)
    name,       ///< name()
    sum,        ///< operands(), two or more
    negate,     ///< operand(0)
    product,    ///< operands(), two or more
    quotient,   ///< operand(0) / operand(1)
    power,      ///< operand(0) ^ operand(1)
    call,       ///< name()(operands())
    derivative, ///< operand(0) with order() primes
    equation    ///< operand(0) = operand(1)
  };

  /// Trees that no text was read into.  Of a call, a derivative, a name: what it is called, its primes.
  [[nodiscard]] static Expression made(Kind kind, std::vector<Expression> operands,
                                       std::string name = {}, long order = 0);
  /// Requires n >= 0.
  [[nodiscard]] static Expression made(const Integer& n);

  [[nodiscard]] Kind kind() const noexcept { return node_->kind; }
  [[nodiscard]] const Integer& number() const noexcept { return node_->number; }
  [[nodiscard]] const std::string& name() const noexcept { return node_->name; }
  [[nodiscard]] const std::vector<Expression>& operands() const noexcept { return node_->operands; }
  [[nodiscard]] const Expression& operand(std::size_t i) const { return node_->operands.at(i); }
  [[nodiscard]] long order() const noexcept { return node_->order; }
  [[nodiscard]] Span span() const noexcept { return span_; }
  [[nodiscard]] const Origin& origin() const noexcept { return *origin_; }
  /// The same for copies of one node, different for different nodes of one tree.
  [[nodiscard]] const void* id() const noexcept { return node_.get(); }
  /// The piece of source that this node was read from.
  [[nodiscard]] std::string_view text() const;
  /// The error at this node.
  [[nodiscard]] InputError error(std::string message, std::string hint = {}) const {
    return {*origin_, span_, std::move(message), std::move(hint)};
  }

private:
  struct Node {
    Kind kind = Kind::number;
    long order = 0;
    long depth = 1;
    Integer number{};
    std::string name{};
    std::vector<Expression> operands{};
  };
  friend class ExpressionParser;
  Expression(std::shared_ptr<const Node> node, OriginPtr origin, Span span)
      : node_(std::move(node)), origin_(std::move(origin)), span_(span) {}

  std::shared_ptr<const Node> node_;
  OriginPtr origin_;
  Span span_;
};

struct ParseLimits {
  std::size_t max_length = std::size_t{4} << 20; ///< bytes of one expression
  long max_depth = 400;                          ///< nesting of parentheses, powers, quotients
};

/// Reads `text`, which stands at `origin->offset` in `origin->text`.
///
/// Errors  InputError with the place, a caret and a hint: a character that does not belong, a
///         decimal number, implied multiplication, a missing operand or parenthesis, an '=' where
///         `equation` is false, a limit of `limits`
/// Cost    linear in the text, except for the conversion of long numbers
[[nodiscard]] Expression parse_expression(std::string_view text, OriginPtr origin,
                                          bool allow_equation = false,
                                          const ParseLimits& limits = {});
/// The same for a text by itself; `name` is what messages call it, e.g. "-r".
/// Example parse_expression("z^2*y'' + z*y' = 0", "-e", true).kind()  // -> Kind::equation
/// Example parse_expression("2z", "-r").kind()  // -> throws InputError
[[nodiscard]] Expression parse_expression(std::string text, const std::string& name,
                                          bool allow_equation = false,
                                          const ParseLimits& limits = {});

/// Every name that stands for a value in the tree, sorted, once each: not those of functions, and
/// not the variable inside root(p(x), approx).
/// Example names_in(parse_expression("a*z^2 + sin(q)", "-r"))  // -> {a, q, z}
[[nodiscard]] std::vector<std::string> names_in(const Expression& e);
/// The first place where the name stands in e, or null.  It lives as long as e.
[[nodiscard]] const Expression* find_name(const Expression& e, const std::string& name);

/// p/q for an expression made of integers, -, * and / only; nothing for others.
/// Example as_rational(parse_expression("-3/(4*2)", "-r"))  // -> -3/8
[[nodiscard]] std::optional<Rational> as_rational(const Expression& e);

} // namespace kov
