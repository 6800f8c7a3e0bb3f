#include "symbol/formula.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "symbol/written.hpp"

#include <algorithm>

namespace kov::trees {
namespace {

using Kind = Expression::Kind;

Expression one() { return Expression::made(Integer(1)); }
Expression zero() { return Expression::made(Integer(0)); }

// c T, T without a number in front of it.
struct Term {
  Rational c;
  Expression rest;
};

Term term_of(const Expression& e) {
  if (const auto c = as_rational(e)) return {*c, one()};
  switch (e.kind()) {
  case Kind::negate: {
    const Term t = term_of(e.operand(0));
    return {-t.c, t.rest};
  }
  case Kind::quotient: {
    const Term above = term_of(e.operand(0)), below = term_of(e.operand(1));
    const Rational c = above.c / below.c;
    if (is_number(below.rest, 1)) return {c, above.rest};
    return {c, Expression::made(Kind::quotient, {above.rest, below.rest})};
  }
  case Kind::product: {
    Rational c(1);
    std::vector<Expression> rest;
    for (const Expression& x : e.operands()) {
      const auto value = as_rational(x);
      if (value) c = c * *value;
      if (!value) rest.push_back(x);
    }
    if (rest.size() == 1) return {c, rest.front()};
    return {c, rest.empty() ? one() : Expression::made(Kind::product, std::move(rest))};
  }
  default:
    return {Rational(1), e};
  }
}

Expression many(Kind kind, std::vector<Expression> all) {
  return all.size() == 1 ? all.front() : Expression::made(kind, std::move(all));
}

// Powers of different bases, in the order in which they came.
class Powers {
public:
  void take(const Expression& e, const Expression& exponent) {
    if (const auto c = as_rational(e)) {
      const auto n = as_rational(exponent);
      if (n && is_integer(*n) && fits_long(n->num()) && abs(*n) <= Rational(200))
        return take_number(*c, to_long(n->num()));
    }
    switch (e.kind()) {
    case Kind::negate:
      if (const auto n = as_rational(exponent); n && is_integer(*n)) {
        if (!is_zero(n->num() - Integer(2) * floor_div(n->num(), Integer(2)))) c_ = -c_;
        return take(e.operand(0), exponent);
      }
      if (const auto n = as_rational(exponent); n && n->den() == Integer(2)) { // sqrt(-x)
        const Integer rest = n->num() - Integer(4) * floor_div(n->num(), Integer(4));
        units_ = (units_ + to_long(rest)) % 4;
        return take(e.operand(0), exponent);
      }
      break;
    case Kind::product:
      for (const Expression& x : e.operands())
        take(x, exponent);
      return;
    case Kind::quotient:
      take(e.operand(0), exponent);
      return take(e.operand(1), negative(exponent));
    case Kind::power:
      return take(e.operand(0), product({e.operand(1), exponent}));
    case Kind::call:
      if (e.name() == "sqrt" && e.operands().size() == 1)
        return take(e.operand(0), product({number(Rational(1, 2)), exponent}));
      if (e.name() == "exp" && e.operands().size() == 1)
        return take_exponential(product({e.operand(0), exponent}));
      break;
    default:
      break;
    }
    add(e, exponent);
  }

  [[nodiscard]] Expression result() {
    if (is_zero(c_)) return zero();
    settle_roots();
    std::vector<Expression> above, below;
    if (!all_.empty() && texts_.front() == "I" && is_number(all_.front().second, 1)) {
      above.push_back(all_.front().first);
      all_.front().second = zero();
    }
    if (const auto root = common_root()) above.push_back(*root);
    for (const auto& [base, exponent] : all_) {
      if (is_number(exponent, 0)) continue;
      const Term t = term_of(exponent);
      const bool minus = sign(t.c) < 0;
      (minus ? below : above).push_back(written_power(base, minus ? negative(exponent) : exponent));
    }
    if (const Expression e = sum(exponential_); !is_number(e, 0))
      above.insert(std::ranges::find_if(above,
                                        [](const Expression& x) { // before cos and J_n
                                          return x.kind() == Kind::call && x.name() != "sqrt";
                                        }),
                   call("exp", {e}));
    const bool minus = sign(c_) < 0;
    const Integer n = minus ? -c_.num() : c_.num();
    if (!(n == Integer(1)) || above.empty()) above.insert(above.begin(), Expression::made(n));
    if (!(c_.den() == Integer(1))) below.insert(below.begin(), Expression::made(c_.den()));
    Expression e = many(Kind::product, std::move(above));
    if (!below.empty())
      e = Expression::made(Kind::quotient, {e, many(Kind::product, std::move(below))});
    return minus ? Expression::made(Kind::negate, {e}) : e;
  }

private:
  // exp(c log(u)) is u^c.
  void take_exponential(const Expression& e) {
    if (e.kind() == Kind::sum) {
      for (const Expression& x : e.operands())
        take_exponential(x);
      return;
    }
    const auto is_log = [](const Expression& x) {
      return x.kind() == Kind::call && x.name() == "log";
    };
    std::vector<Expression> factors{e};
    if (e.kind() == Kind::negate) factors = {number(-1), e.operand(0)};
    if (factors.back().kind() == Kind::quotient) {
      const Expression q = factors.back();
      factors.back() = q.operand(0);
      factors.insert(factors.begin(), power(q.operand(1), number(-1)));
    }
    if (factors.back().kind() == Kind::product) {
      const std::vector<Expression> inner = factors.back().operands();
      factors.pop_back();
      factors.insert(factors.end(), inner.begin(), inner.end());
    }
    const auto log = std::ranges::find_if(factors, is_log);
    if (log == factors.end()) {
      exponential_.push_back(e);
      return;
    }
    const Expression base = log->operand(0);
    factors.erase(log);
    take(base, product(factors));
  }
  void take_number(const Rational& c, long n) {
    if (n < 0 && is_zero(c)) throw DomainError("a formula divides by 0");
    for (long i = 0; i < (n < 0 ? -n : n); ++i)
      c_ = n < 0 ? c_ / c : c_ * c;
  }
  void add(const Expression& base, const Expression& exponent) {
    const std::string text = written(base);
    if (text == "I") {
      if (const auto n = as_rational(exponent); n && is_integer(*n)) {
        const Integer rest = n->num() - Integer(4) * floor_div(n->num(), Integer(4));
        const long k = to_long(rest) + units_;
        units_ = k % 4;
        return;
      }
    }
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (texts_[i] == text) {
        all_[i].second = sum({all_[i].second, exponent});
        return;
      }
    texts_.push_back(text);
    all_.emplace_back(base, exponent);
  }
  // 2^(3/2) is 2 sqrt(2); a root of a rational number below the line goes above it; I^2 is -1.
  void settle_roots() {
    if (units_ >= 2) c_ = -c_;
    if (units_ % 2 == 1) {
      texts_.insert(texts_.begin(), "I");
      all_.insert(all_.begin(), {name("I"), one()});
    }
    units_ = 0;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const auto c = as_rational(all_[i].first);
      const auto e = as_rational(all_[i].second);
      if (!c || !e) continue;
      const Integer whole = floor(*e);
      if (!fits_long(whole) || abs(Rational(whole)) > Rational(50)) continue;
      take_number(*c, to_long(whole));
      const Rational rest = *e - Rational(whole);
      if (is_zero(rest)) {
        all_[i].second = zero();
      } else if (rest == Rational(1, 2) && sign(*c) != 0) {
        const auto [s, n] = square_part(c->num() * c->den()); // sqrt(p/q) = sqrt(p q)/q
        c_ = c_ * Rational(s, c->den());
        const bool negative_root = sign(n) < 0;
        all_[i] = {Expression::made(negative_root ? -n : n), number(rest)};
        if (n == Integer(1) || n == Integer(-1)) all_[i].second = zero();
        if (negative_root) all_.emplace_back(name("I"), one()), texts_.emplace_back("I");
      } else {
        all_[i].second = number(rest);
      }
    }
  }
  // sqrt(2) sqrt(a)/sqrt(b) is sqrt(2 a/b).
  std::optional<Expression> common_root() {
    std::vector<Expression> above, below;
    bool has_name = false;
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const auto& [base, exponent] = all_[i];
      const bool plain = base.kind() == Kind::name || base.kind() == Kind::number;
      const bool root = is_number(exponent, Rational(1, 2));
      if (!plain || (!root && !is_number(exponent, Rational(-1, 2)))) continue;
      has_name = has_name || base.kind() == Kind::name;
      (root ? above : below).push_back(base);
      taken.push_back(i);
    }
    if (taken.size() < 2 || !has_name) return std::nullopt;
    for (const std::size_t i : taken)
      all_[i].second = zero();
    Expression inside = above.empty() ? one() : many(Kind::product, std::move(above));
    if (!below.empty())
      inside = Expression::made(Kind::quotient, {inside, many(Kind::product, std::move(below))});
    return Expression::made(Kind::call, {inside}, "sqrt");
  }
  static Expression written_power(const Expression& base, const Expression& exponent) {
    if (is_number(exponent, 1)) return base;
    if (is_number(exponent, Rational(1, 2))) return Expression::made(Kind::call, {base}, "sqrt");
    return Expression::made(Kind::power, {base, exponent});
  }

  Rational c_{1};
  long units_ = 0; ///< powers of I
  std::vector<std::string> texts_;
  std::vector<std::pair<Expression, Expression>> all_;
  std::vector<Expression> exponential_;
};

} // namespace

Expression number(const Rational& c) {
  const bool minus = sign(c) < 0;
  Expression e = Expression::made(minus ? -c.num() : c.num());
  if (!(c.den() == Integer(1)))
    e = Expression::made(Kind::quotient, {e, Expression::made(c.den())});
  return minus ? Expression::made(Kind::negate, {e}) : e;
}

Expression name(std::string letter) { return Expression::made(Kind::name, {}, std::move(letter)); }

Expression call(std::string function, std::vector<Expression> arguments) {
  if (arguments.size() == 1) {
    const Expression& x = arguments.front();
    if (function == "exp" && is_number(x, 0)) return one();
    if (function == "log" && is_number(x, 1)) return zero();
    if (function == "log" && x.kind() == Kind::call && x.name() == "exp") return x.operand(0);
    if (function == "sqrt") return power(x, number(Rational(1, 2)));
    const bool minus = sign(term_of(x).c) < 0;
    if (minus && (function == "cos" || function == "cosh"))
      return call(std::move(function), {negative(x)});
  }
  if (arguments.size() == 2 &&
      function.starts_with("bessel")) { // J_(-n) = (-1)^n J_n, I_(-n) = I_n
    const auto n = as_rational(arguments.front());
    if (n && is_integer(*n) && sign(*n) < 0) {
      const bool signs = function.back() == 'j' || function.back() == 'y';
      const bool odd = signs && !is_zero(n->num() - Integer(2) * floor_div(n->num(), Integer(2)));
      return product({number(odd ? -1 : 1), call(function, {number(-*n), arguments.back()})});
    }
  }
  return Expression::made(Kind::call, std::move(arguments), std::move(function));
}

Expression sum(const std::vector<Expression>& terms) {
  std::vector<Term> all;
  std::vector<std::string> texts;
  Rational c(0);
  const std::function<void(const Expression&, const Rational&)> take = [&](const Expression& e,
                                                                           const Rational& factor) {
    if (e.kind() == Kind::sum) {
      for (const Expression& x : e.operands())
        take(x, factor);
      return;
    }
    if (e.kind() == Kind::negate) return take(e.operand(0), -factor);
    Term t = term_of(e);
    t.c = t.c * factor;
    if (is_number(t.rest, 1)) {
      c = c + t.c;
      return;
    }
    if (t.rest.kind() == Kind::sum && t.c == Rational(1)) return take(t.rest, t.c);
    std::string text = written(t.rest);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (texts[i] == text) {
        all[i].c = all[i].c + t.c;
        return;
      }
    texts.push_back(std::move(text));
    all.push_back(std::move(t));
  };
  for (const Expression& e : terms)
    take(e, Rational(1));
  std::vector<Expression> out;
  for (const Term& t : all)
    if (!is_zero(t.c)) out.push_back(product({number(t.c), t.rest}));
  if (!is_zero(c)) out.push_back(number(c));
  // a positive term first
  const auto positive =
      std::ranges::find_if(out, [](const Expression& e) { return sign(term_of(e).c) > 0; });
  if (positive != out.end()) std::rotate(out.begin(), positive, positive + 1);
  return out.empty() ? zero() : many(Kind::sum, std::move(out));
}

Expression product(const std::vector<Expression>& factors) {
  Powers powers;
  for (const Expression& e : factors)
    powers.take(e, one());
  return powers.result();
}

Expression power(const Expression& base, const Expression& exponent) {
  if (is_number(exponent, 0)) return one();
  Powers powers;
  powers.take(base, exponent);
  return powers.result();
}

Expression negative(const Expression& e) {
  if (e.kind() == Kind::negate) return e.operand(0);
  if (e.kind() == Kind::sum) {
    auto terms = mapped<Expression>(e.operands(), [&](const Expression& x) { return negative(x); });
    return sum(terms);
  }
  return product({number(-1), e});
}

Expression quotient(const Expression& above, const Expression& below) {
  return product({above, power(below, number(-1))});
}

bool is_number(const Expression& e, const Rational& c) {
  const auto value = as_rational(e);
  return value && *value == c;
}

Expression from(const MPoly& f) {
  std::vector<Expression> terms;
  for (long i = 0; i < f.length(); ++i) {
    std::vector<Expression> factors{number(Rational(f.coefficient(i)))};
    const auto exponents = f.exponents(i);
    for (std::size_t k = 0; k < exponents.size(); ++k)
      if (exponents[k] > 0)
        factors.push_back(power(name(f.ring()->name(k)), number(Rational(Integer(exponents[k])))));
    terms.push_back(product(factors));
  }
  return sum(terms);
}

Expression from(const MFraction& f) {
  if (is_zero(f)) return zero();
  const auto factored = [](const MPoly& p) {
    const auto [content, factors] = factor(p);
    std::vector<Expression> all{number(Rational(content))};
    for (const MFactor& x : factors)
      all.push_back(power(from(x.base), number(x.exponent)));
    return product(all);
  };
  const auto factors = factor(f.num()).second;
  const bool powers = std::ranges::any_of(
      factors, [](const MFactor& x) { return x.exponent > 1 && x.base.length() > 1; });
  return quotient(powers ? factored(f.num()) : from(f.num()), factored(f.den()));
}

Expression rebuilt(const Expression& e, const std::map<std::string, Expression>& values) {
  const auto operands = [&] {
    return mapped<Expression>(e.operands(),
                              [&](const Expression& x) { return rebuilt(x, values); });
  };
  switch (e.kind()) {
  case Kind::name:
    if (const auto it = values.find(e.name()); it != values.end()) return it->second;
    return e;
  case Kind::sum:
    return sum(operands());
  case Kind::negate:
    return negative(rebuilt(e.operand(0), values));
  case Kind::product:
    return product(operands());
  case Kind::quotient:
    return quotient(rebuilt(e.operand(0), values), rebuilt(e.operand(1), values));
  case Kind::power:
    return power(rebuilt(e.operand(0), values), rebuilt(e.operand(1), values));
  case Kind::call:
    return call(e.name(), operands());
  case Kind::derivative:
  case Kind::equation:
    return Expression::made(e.kind(), operands(), e.name(), e.order());
  default:
    return e;
  }
}

std::size_t length_of(const Expression& e) { return written(e).size(); }

namespace {

// e = real + I imaginary, formally.
struct Split {
  Expression real, imaginary;
};

std::optional<Split> split(const Expression& e) {
  if (!mentions_name(e, "I")) return Split{e, zero()};
  switch (e.kind()) {
  case Kind::name:
    return Split{zero(), one()};
  case Kind::negate:
    if (const auto s = split(e.operand(0))) return Split{negative(s->real), negative(s->imaginary)};
    return std::nullopt;
  case Kind::sum: {
    std::vector<Expression> real, imaginary;
    for (const Expression& x : e.operands()) {
      const auto s = split(x);
      if (!s) return std::nullopt;
      real.push_back(s->real);
      imaginary.push_back(s->imaginary);
    }
    return Split{sum(real), sum(imaginary)};
  }
  case Kind::product: {
    Split all{one(), zero()};
    for (const Expression& x : e.operands()) {
      const auto s = split(x);
      if (!s) return std::nullopt;
      all = {sum({product({all.real, s->real}), negative(product({all.imaginary, s->imaginary}))}),
             sum({product({all.real, s->imaginary}), product({all.imaginary, s->real})})};
    }
    return all;
  }
  case Kind::quotient: {
    const auto s = split(e.operand(0));
    if (!s || mentions_name(e.operand(1), "I")) return std::nullopt;
    return Split{quotient(s->real, e.operand(1)), quotient(s->imaginary, e.operand(1))};
  }
  default:
    return std::nullopt;
  }
}

} // namespace

std::optional<Phase> phase_of(const Expression& e) {
  std::vector<Expression> moduli, angles;
  std::optional<Split> in_front;
  const std::function<bool(const Expression&, bool)> take = [&](const Expression& x, bool below) {
    const auto put = [&](const Expression& modulus, const Expression& angle) {
      moduli.push_back(below ? power(modulus, number(-1)) : modulus);
      angles.push_back(below ? negative(angle) : angle);
      return true;
    };
    if (!mentions_name(x, "I")) return put(x, zero());
    if (x.kind() == Kind::negate) {
      moduli.push_back(number(-1));
      return take(x.operand(0), below);
    }
    if (x.kind() == Kind::product)
      return std::ranges::all_of(x.operands(), [&](const Expression& y) { return take(y, below); });
    if (x.kind() == Kind::quotient) return take(x.operand(0), below) && take(x.operand(1), !below);
    if (x.kind() == Kind::sum && !below && !in_front) {
      in_front = split(x);
      return in_front.has_value();
    }
    if (x.kind() == Kind::call && x.name() == "exp") {
      const auto s = split(x.operand(0));
      return s && put(call("exp", {s->real}), s->imaginary);
    }
    if (x.kind() == Kind::power && !mentions_name(x.operand(0), "I")) {
      const auto s = split(x.operand(1));
      return s && put(power(x.operand(0), s->real),
                      product({s->imaginary, call("log", {x.operand(0)})}));
    }
    return false;
  };
  if (!mentions_name(e, "I") || !take(e, false)) return std::nullopt;
  if (!in_front) in_front = Split{one(), zero()};
  return Phase{product(moduli), in_front->real, in_front->imaginary, sum(angles)};
}

} // namespace kov::trees
