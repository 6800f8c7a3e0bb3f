#include "equation/algebraic_constants.hpp"

#include "exact/lists.hpp"
#include "parameters/parametrised_set.hpp"
#include "symbol/constants.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr long largest_prime = 1000000;

std::optional<Integer> integer(const Expression& e) {
  if (e.kind() == Kind::number) return e.number();
  if (e.kind() == Kind::negate && e.operand(0).kind() == Kind::number)
    return -e.operand(0).number();
  return std::nullopt;
}

bool calls_something(const Expression& e) {
  return e.kind() == Kind::call || std::ranges::any_of(e.operands(), calls_something);
}

std::string name_of_root(const Integer& p) { return "sqrt(" + to_string(p) + ")"; }

// f with x^d, x^(d+1), ... replaced by what p = 0 says of x^d; p of degree d in x, with a constant
// leading coefficient.
MFraction lowered(const MPoly& f, std::size_t x, const MPoly& p) {
  const auto line = coefficients(p, x);
  const std::size_t d = line.size() - 1;
  const auto c = coefficients(f, x);
  std::vector<MFraction> rest(c.begin(), c.end());
  for (std::size_t k = rest.size(); k-- > d;) {
    const MFraction top = rest[k] / MFraction(line[d]);
    rest[k] = MFraction(f.ring());
    for (std::size_t i = 0; i < d; ++i)
      rest[k - d + i] -= top * MFraction(line[i]);
  }
  MFraction sum(f.ring());
  for (std::size_t k = std::min(rest.size(), d); k-- > 0;)
    sum = sum * MFraction::variable(f.ring(), x) + rest[k];
  return sum;
}

} // namespace

std::optional<AlgebraicConstants> AlgebraicConstants::in(const EquationText& text) {
  AlgebraicConstants all;
  for (const Expression& e : formulas(text))
    if (!all.collect(e, text)) return std::nullopt;
  const auto& parameters = text.parameters;
  if (is_among("I", parameters)) all.i_ = false;
  all.minpoly_ = text.minpoly;
  if (text.minpoly) {
    const auto names = names_in(*text.minpoly);
    if (is_among("I", names))
      throw text.minpoly->error("I is the imaginary unit", "give the constant another name");
    if (all.i_ || !all.square_roots_.empty() || !all.parameter_roots_.empty())
      return std::nullopt; // not known to be independent
  }
  return all;
}

std::optional<AlgebraicConstants::SquareRoot> AlgebraicConstants::square_root(const Integer& n) {
  SquareRoot root;
  root.n = n;
  root.imaginary = sign(n) < 0;
  Integer rest = root.imaginary ? -n : n;
  if (is_zero(rest)) return std::nullopt;
  const auto divides = [&](const Integer& d) { return is_zero(rest - d * floor_div(rest, d)); };
  for (long p = 2; p <= largest_prime && Integer(p) * Integer(p) <= rest; ++p) {
    const Integer prime(p);
    for (; divides(prime * prime); rest = exact_div(rest, prime * prime))
      root.factor *= prime;
    if (!divides(prime)) continue;
    rest = exact_div(rest, prime);
    root.primes.push_back(prime);
  }
  if (rest > Integer(largest_prime) * Integer(largest_prime)) return std::nullopt;
  if (rest != Integer(1)) root.primes.push_back(rest);
  return root;
}

// A function of parameters alone, and of some.
bool AlgebraicConstants::collect_root(const Expression& argument, const EquationText& text) {
  const auto is_free = [&](const std::string& name) {
    const auto& all = text.parameters;
    return is_among(name, all) &&
           std::ranges::none_of(text.set, [&](const auto& value) { return value.first == name; });
  };
  const auto names = names_in(argument);
  if (names.empty() || !std::ranges::all_of(names, is_free) || calls_something(argument))
    return false;
  const MFraction value = evaluate(argument, ParameterScope(make_ring(names), {}));
  if (is_zero(value) || is_constant(value)) return false;
  const std::string name = "sqrt(" + to_string(value) + ")";
  if (std::ranges::none_of(parameter_roots_,
                           [&](const ParameterRoot& r) { return r.name == name; }))
    parameter_roots_.push_back({argument, name});
  return true;
}

bool AlgebraicConstants::collect(const Expression& e, const EquationText& text) {
  if (e.kind() == Kind::name && e.name() == "I") i_ = true;
  if (e.kind() == Kind::call && e.name() == "root") return false;
  if (e.kind() == Kind::call && e.name() == "sqrt") {
    const auto n = e.operands().size() == 1 ? integer(e.operand(0)) : std::nullopt;
    if (!n && e.operands().size() == 1) return collect_root(e.operand(0), text);
    const auto root = n ? square_root(*n) : std::nullopt;
    if (!root) return false;
    i_ = i_ || root->imaginary;
    const bool known =
        std::ranges::any_of(square_roots_, [&](const SquareRoot& r) { return r.n == *n; });
    if (!known) square_roots_.push_back(*root);
    return true;
  }
  return std::ranges::all_of(e.operands(), [&](const Expression& x) { return collect(x, text); });
}

std::vector<Integer> AlgebraicConstants::primes() const {
  std::vector<Integer> all;
  for (const SquareRoot& r : square_roots_)
    for (const Integer& p : r.primes)
      add_once(all, p);
  return all;
}

std::vector<std::string> AlgebraicConstants::names() const {
  std::vector<std::string> all;
  if (i_) all.emplace_back("I");
  for (const Integer& p : primes())
    all.push_back(name_of_root(p));
  for (const ParameterRoot& r : parameter_roots_)
    all.push_back(r.name);
  if (minpoly_) std::ranges::copy(names_in(*minpoly_), std::back_inserter(all));
  return all;
}

std::vector<FunctionMeaning> AlgebraicConstants::functions(const Ring& ring) const {
  std::vector<FunctionMeaning> all;
  for (const SquareRoot& r : square_roots_) {
    MFraction value(ring, Rational(r.factor));
    if (r.imaginary) value *= MFraction::variable(ring, "I");
    for (const Integer& p : r.primes)
      value *= MFraction::variable(ring, name_of_root(p));
    all.push_back({0, "sqrt", MFraction(ring, Rational(r.n)), value});
  }
  for (const ParameterRoot& r : parameter_roots_)
    all.push_back({0, "sqrt", evaluate(r.argument, ParameterScope(ring, {})),
                   MFraction::variable(ring, r.name)});
  return all;
}

std::vector<std::pair<std::size_t, MPoly>> AlgebraicConstants::equations(const Scope& scope) const {
  const Ring& ring = scope.ring();
  std::vector<std::pair<std::size_t, MPoly>> all;
  const auto square_is = [&](const std::string& name, const Integer& n) {
    const MFraction x = MFraction::variable(ring, name);
    all.emplace_back(ring->index(name), (x * x - MFraction(ring, Rational(n))).num());
  };
  if (i_) square_is("I", Integer(-1));
  for (const Integer& p : primes())
    square_is(name_of_root(p), p);
  for (const ParameterRoot& r : parameter_roots_) {
    const MFraction x = MFraction::variable(ring, r.name);
    all.emplace_back(ring->index(r.name),
                     (x * x - evaluate(r.argument, ParameterScope(ring, {}))).num());
  }
  if (minpoly_) {
    const MPoly p = evaluate(*minpoly_, scope).num();
    const auto factors = is_zero(p) ? std::vector<MFactor>{} : factor(p).second;
    if (factors.size() != 1 || factors.front().exponent != 1)
      throw minpoly_->error("the minimal polynomial of a constant is reducible",
                            "write one of its factors");
    for (const auto& name : names_in(*minpoly_))
      if (uses(p, ring->index(name))) all.emplace_back(ring->index(name), p);
  }
  return all;
}

void AlgebraicConstants::assume(Assumptions& all, const Scope& scope) const {
  for (const ParameterRoot& r : parameter_roots_) {
    const MFraction f = evaluate(r.argument, ParameterScope(scope.ring(), {}));
    if (!is_constant(f.den())) all.require(MFraction(f.den()), Sign::nonzero);
  }
  for (const auto& [x, p] : equations(scope))
    all.require(MFraction(p), Sign::zero);
  for (const Integer& p : primes())
    all.real.push_back(scope.ring()->index(name_of_root(p)));
}

void AlgebraicConstants::assume_signs(Assumptions& all, const Scope& scope) const {
  for (const ParameterRoot& r : parameter_roots_) {
    const MFraction f = evaluate(r.argument, ParameterScope(scope.ring(), {}));
    if (ParametrisedSet(scope.ring(), all).exact_sign_of(f.num() * f.den()) > 0)
      all.require(MFraction::variable(scope.ring(), r.name), Sign::positive);
  }
}

MFraction AlgebraicConstants::reduced(const MFraction& f, const Scope& scope) const {
  MFraction num(f.num());
  MFraction den(f.den());
  for (const auto& [x, p] : equations(scope)) {
    if (!is_zero(num)) num = lowered(num.num(), x, p) / MFraction(num.den());
    if (!is_zero(den)) den = lowered(den.num(), x, p) / MFraction(den.den());
  }
  return num / den;
}

} // namespace kov
