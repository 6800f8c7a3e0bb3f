#include "symbol/constants.hpp"

#include "exact/factor.hpp"
#include "exact/joined.hpp"
#include "symbol/approximation.hpp"
#include "symbol/rational_form.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using Kind = Expression::Kind;

// Text in our own notation without spaces and without parentheses around the whole: the key under which a
// constant is remembered, and the name of the field that it generates.  Two constants that were written in
// another notation may come from the same place of a text.
std::string key_of(const Expression& e) {
  std::string key = written(e);
  std::erase(key, ' ');
  const auto wrapped = [&] { // does the first parenthesis close at the very end?
    long depth = 0;
    for (std::size_t i = 0; i < key.size(); ++i) {
      depth += key[i] == '(' ? 1 : key[i] == ')' ? -1 : 0;
      if (depth == 0) return i > 0 && i + 1 == key.size();
    }
    return false;
  };
  while (wrapped())
    key = key.substr(1, key.size() - 2);
  return key;
}

// The n-th root that was adjoined, as text: of c^(p/q) that is c^(1/q).
std::string root_label(const Expression& at, unsigned long n) {
  if (at.kind() != Expression::Kind::power) return key_of(at);
  const std::string base = key_of(at.operand(0));
  const bool digits = base.find_first_not_of("0123456789") == std::string::npos;
  return "(" + (digits ? base : "(" + base + ")") + "^(1/" + std::to_string(n) + "))";
}

std::vector<Integer> primitive(const std::vector<Rational>& c) {
  Integer common(1);
  for (const Rational& q : c)
    common = lcm(common, q.den());
  std::vector<Integer> result;
  Integer content(0);
  for (const Rational& q : c) {
    result.push_back((q * Rational(common)).num());
    content = gcd(content, result.back());
  }
  for (Integer& n : result)
    n = exact_div(n, content);
  return result;
}

Poly polynomial(const std::vector<Integer>& c, const Field& k) {
  std::vector<NfElem> coefficients;
  for (const Integer& n : c)
    coefficients.emplace_back(Rational(n), k);
  return Poly::from_coefficients(coefficients);
}

Poly minimal_polynomial_over(const QQbar& a, const Field& k) {
  return polynomial(minimal_polynomial(a), k);
}

// f(t), coefficient by coefficient: an element of K as a polynomial in another element.
NfElem substitute(const NfElem& x, const NfElem& theta) {
  NfElem value(theta.field());
  for (long i = fmpq_poly_degree(x.raw()); i >= 0; --i)
    value = value * theta + NfElem(x.coeff(i));
  return value;
}

// The one of pairwise coprime factors over K that vanishes at alpha.
Poly vanishing_factor(const std::vector<Factor>& factors, const QQbar& alpha) {
  for (long bits = 64; bits < (1L << 20); bits *= 2) {
    const ComplexBall at = enclosure(alpha, bits);
    const Factor* candidate = nullptr;
    int candidates = 0;
    for (const Factor& f : factors)
      if (acb_contains_zero(evaluate(f.base, at, bits).raw())) {
        candidate = &f;
        ++candidates;
      }
    KOV_ENSURE(candidates > 0);
    if (candidates == 1) return candidate->base;
  }
  throw InternalError("no precision separates the factors at a root");
}

// The only common root, if there is exactly one.
std::optional<NfElem> common_root(const Poly& f, const Poly& g) {
  const Poly h = gcd(f, g);
  if (degree(h) != 1) return std::nullopt;
  return -h.coeff(0);
}

NfElem from_integer(const Integer& n) { return NfElem(Rational(n)); }

} // namespace

// --- definitions ----------------------------------------------------------------------------

void Constants::define_root(const std::string& name, const Expression& minpoly) {
  const std::vector<Rational> c = rational_polynomial(minpoly, name);
  if (c.size() < 2)
    throw minpoly.error("the minimal polynomial of '" + name + "' is constant",
                        "write a polynomial in " + name + ", e.g. " + name + "^2 - 2");
  if (static_cast<long>(c.size()) - 1 > max_degree_)
    throw minpoly.error("a number field of degree " + std::to_string(c.size() - 1) +
                        " is larger than the limit " + std::to_string(max_degree_));
  const std::vector<Integer> m = primitive(c);
  const std::vector<Factor> factors = irreducible_factors(polynomial(m, rationals()));
  if (factors.size() > 1 || factors.front().exponent > 1) {
    const auto power = [&](const Factor& f) {
      return "(" + to_string(f.base, name) + ")" +
             (f.exponent > 1 ? "^" + std::to_string(f.exponent) : "");
    };
    throw minpoly.error("the minimal polynomial of '" + name + "' is reducible",
                        "it is a multiple of " + joined(factors, power, "*") +
                            "; write one of its factors");
  }
  taken_.insert(name);
  const QQbar alpha = roots(m).front();
  values_[name] = adjoin(alpha, coerce(minimal_polynomial_over(alpha, rationals()), field_), name,
                         true, minpoly);
}

void Constants::define_value(const std::string& name, const Expression& value) {
  gather(std::span(&value, 1));
  taken_.insert(name);
  values_[name] = constant(value);
}

void Constants::gather(std::span<const Expression> all) {
  for (const Expression& e : all)
    for (const std::string& name : names_in(e))
      taken_.insert(name);
  for (const Expression& e : all)
    gather(e);
}

void Constants::gather(const Expression& e) {
  if (e.kind() == Kind::name && e.name() == "I" && !values_.contains("I")) {
    const Poly f = Poly::monomial(NfElem(Rational(1), field_), 2) + Poly(1);
    values_["I"] = adjoin(QQbar::i(), f, "I", false, e);
  }
  if (e.kind() == Kind::call && (e.name() == "sqrt" || e.name() == "root")) return gather_call(e);
  for (const Expression& operand : e.operands())
    gather(operand);
  if (e.kind() != Kind::power) return;
  const auto exponent = as_rational(e.operand(1)); // c^(p/q)
  if (!exponent || is_integer(*exponent) || values_.contains(key_of(e))) return;
  require_constant(e, e.operand(0));
  const NfElem c = constant(e.operand(0));
  const Integer p = exponent->num();
  if (!fits_long(exponent->den()) || !fits_long(p) || std::abs(to_long(p)) > 1000)
    throw e.operand(1).error("this exponent is too large for a root of a constant");
  const auto q = static_cast<unsigned long>(to_long(exponent->den()));
  const NfElem root = nth_root(c, q, e);
  if (is_zero(root) && sign(p) < 0) throw e.error("division by zero");
  const auto size = static_cast<unsigned long>(std::abs(to_long(p)));
  values_[key_of(e)] = sign(p) < 0 ? inverse(pow(root, size)) : pow(root, size);
}

void Constants::gather_call(const Expression& e) {
  const std::string key = key_of(e);
  if (values_.contains(key)) return;
  if (e.name() == "sqrt") {
    if (e.operands().size() != 1) throw e.error("sqrt has one argument");
    require_constant(e, e.operand(0));
    gather(e.operand(0));
    values_[key] = nth_root(constant(e.operand(0)), 2, e);
    return;
  }
  const QQbar alpha = chosen_root(e);
  values_[key] = adjoin(alpha, minimal_polynomial_over(alpha, field_), key, false, e);
}

void Constants::require_constant(const Expression& root, const Expression& argument) const {
  for (const std::string& name : names_in(argument))
    if (name != "I" && !values_.contains(name))
      throw root.error(
          "'" + name + "' is not a constant, so this root is not a rational function",
          "roots are allowed of constants only; change the variable to remove this one");
}

std::optional<NfElem> Constants::value(const Expression& e) const {
  std::string key;
  switch (e.kind()) {
  case Kind::name:
    key = e.name();
    break;
  case Kind::call:
    key = key_of(e);
    break;
  case Kind::power: {
    const auto exponent = as_rational(e.operand(1));
    if (!exponent || is_integer(*exponent)) return std::nullopt;
    key = key_of(e);
    break;
  }
  default:
    return std::nullopt;
  }
  const auto found = values_.find(key);
  if (found == values_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> Constants::defined_names() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : values_)
    if (key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
        std::string::npos)
      names.push_back(key);
  return names;
}

std::string Constants::definition() const { return generator_definition(*field_); }

// --- the tower ------------------------------------------------------------------------------

NfElem Constants::constant(const Expression& e) const {
  const RationalFunction f =
      rational_function(e, {.variable = "", .constants = this, .budget = {}});
  return f.num().coeff(0) / f.den().coeff(0);
}

QQbar Constants::to_qqbar(const NfElem& x) const {
  return is_rational(x) ? QQbar(to_rational(x)) : evaluate(x.raw(), theta_);
}

NfElem Constants::nth_root(const NfElem& c, unsigned long n, const Expression& at) {
  if (is_zero(c)) return c;
  if (is_rational(c) && n == 2)
    if (const auto root = exact_sqrt(to_rational(c))) return {*root, field_};
  const QQbar x = to_qqbar(c);
  constexpr long largest = 200; // degree of a polynomial that may have to be factored
  if (n > largest || degree(x) * static_cast<long>(n) > largest)
    throw at.error("this root may have a degree above " + std::to_string(largest),
                   "the limit of the number field is degree " + std::to_string(max_degree_));
  const Poly f = Poly::monomial(NfElem(Rational(1), field_), static_cast<long>(n)) - Poly(c);
  return adjoin(principal_root(x, n), f, root_label(at, n), false, at);
}

QQbar Constants::chosen_root(const Expression& e) const {
  if (e.operands().size() > 2) throw e.error("root has two arguments: root(p(x), approximation)");
  const Expression& p = e.operand(0);
  const std::vector<std::string> names = names_in(p);
  if (names.size() != 1)
    throw p.error(names.empty() ? "this polynomial is constant"
                                : "a polynomial in one variable is expected",
                  "write e.g. root(x^3 - 2, 1.26)");
  const std::vector<Rational> c = rational_polynomial(p, names.front());
  if (c.size() < 2) throw p.error("this polynomial is constant", "write e.g. root(x^3 - 2, 1.26)");
  if (c.size() == 2 && e.operands().size() > 1)
    throw e.error("a polynomial of degree 1 has one root, which needs no approximation",
                  "write a cube root as " + names.front() + "^(1/3)");
  if (static_cast<long>(c.size()) - 1 > 4 * max_degree_)
    throw p.error("a polynomial of degree " + std::to_string(c.size() - 1) + " is too large here");
  const std::vector<QQbar> all = roots(primitive(c));
  if (all.size() > 1 && e.operands().size() < 2)
    throw e.error("root needs an approximation that says which of the " +
                      std::to_string(all.size()) + " roots is meant",
                  "e.g. root(" + std::string(p.text()) + ", " + approximate_text(all.front()) +
                      ")");
  if (all.size() == 1) return all.front();
  if (const auto root = nearest_root(all, read_approximation(e.operand(1)))) return *root;
  throw e.operand(1).error("two roots are equally near to this approximation");
}

NfElem Constants::adjoin(const QQbar& alpha, const Poly& f, const std::string& label,
                         bool keep_label, const Expression& at) {
  const Poly g = vanishing_factor(irreducible_factors(f), alpha);
  const long d = field_->degree() * degree(g);
  if (degree(g) == 1) return -g.coeff(0);
  if (d > max_degree_)
    throw at.error("with this constant the number field has degree " + std::to_string(d) +
                       ", above the limit " + std::to_string(max_degree_),
                   "use fewer independent roots");
  const NfElem value =
      field_->is_rational() ? first_generator(alpha, label, keep_label) : extend(alpha, g, label);
  KOV_ENSURE(equals(value, alpha));
  return value;
}

// Q(alpha): for a quadratic number the generator is sqrt(n), else alpha times its denominator.
NfElem Constants::first_generator(const QQbar& alpha, const std::string& label, bool keep_label) {
  if (degree(alpha) == 2 && !keep_label) {
    const Quadratic q = quadratic_parts(alpha);
    theta_ = principal_root(QQbar(Rational(q.n)), 2);
    move_to(field_of(theta_, q.n == Integer(-1) ? "I" : "sqrt(" + to_string(q.n) + ")"), NfElem(0));
    const NfElem root = NfElem::generator(field_);
    return (from_integer(q.u) + from_integer(q.v) * root) / from_integer(q.w);
  }
  const Integer lead = minimal_polynomial(alpha).back();
  theta_ = lead * alpha;
  move_to(field_of(theta_, label, lead), NfElem(0));
  return NfElem::generator(field_) / from_integer(lead);
}

// K(alpha), g the minimal polynomial of alpha over K, deg g > 1.
NfElem Constants::extend(const QQbar& alpha, const Poly& g, const std::string& label) {
  const long d = field_->degree() * degree(g);
  const Integer lead = minimal_polynomial(alpha).back();
  const QQbar integral = lead * alpha;
  struct Try {
    long k, l;
  };
  static constexpr std::array tries{Try{0, 1}, Try{1, 1},  Try{1, -1}, Try{1, 2}, Try{1, -2},
                                    Try{2, 1}, Try{2, -1}, Try{1, 3},  Try{3, 1}, Try{1, -3},
                                    Try{1, 5}, Try{1, 7},  Try{1, 11}, Try{1, 23}};
  for (const auto& [k, l] : tries) {
    const QQbar sum = k == 0 ? integral : Integer(k) * theta_ + Integer(l) * integral;
    if (degree(sum) != d) continue;
    const bool simple = k == 0 && lead == Integer(1) && label.size() <= 24;
    const Field bigger = field_of(sum, simple ? label : fresh_name());
    const NfElem generator = NfElem::generator(bigger);
    std::optional<NfElem> theta; // the old generator in the new field
    std::optional<NfElem> a;     // lead*alpha in the new field
    if (k == 0) {
      a = generator;
      const NfElem at = generator / from_integer(lead);
      Poly relation(bigger); // g(alpha), the old generator replaced by a variable
      NfElem power(Rational(1), bigger);
      for (long i = 0; i <= degree(g); ++i, power *= at)
        for (long j = 0; j < field_->degree(); ++j)
          relation += Poly::monomial(power * NfElem(g.coeff(i).coeff(j)), j);
      theta = common_root(relation, coerce(minimal_polynomial_over(theta_, rationals()), bigger));
    } else {
      const Poly line = scale(Poly(generator) - Poly::monomial(NfElem(Rational(l), bigger), 1),
                              NfElem(Rational(1, k)));
      a = common_root(compose(coerce(minimal_polynomial_over(theta_, rationals()), bigger), line),
                      coerce(minimal_polynomial_over(integral, rationals()), bigger));
      if (a) theta = evaluate(line, *a);
    }
    if (!a || !theta) continue;
    theta_ = sum;
    move_to(bigger, *theta);
    return *a / from_integer(lead);
  }
  throw InternalError("no primitive element of a number field was found");
}

void Constants::move_to(const Field& k, const NfElem& theta) {
  for (auto& [key, value] : values_)
    value = is_rational(value) ? coerce(value, k) : substitute(value, theta);
  field_ = k;
}

std::string Constants::fresh_name() const {
  for (const std::string name : {"a", "b", "c", "d", "s", "t", "u", "v", "w", "theta"})
    if (!taken_.contains(name)) return name;
  std::string name = "theta";
  for (int i = 0; taken_.contains(name); ++i)
    name = "theta" + std::to_string(i);
  return name;
}

std::string generator_definition(const NumberField& k) {
  if (k.is_rational()) return {};
  const QQbar theta = [&] {
    const ComplexBall chosen = k.generator(128);
    for (const QQbar& root : roots(k.minpoly_coefficients()))
      if (acb_overlaps(enclosure(root, 128).raw(), chosen.raw())) return root;
    throw InternalError("the generator of a field is not a root of its polynomial");
  }();
  const QQbar shown = QQbar(Rational(Integer(1), k.scale())) * theta;
  return "root(" + to_string(polynomial(minimal_polynomial(shown), rationals()), "x") + ", " +
         approximate_text(shown) + ")";
}

} // namespace kov
