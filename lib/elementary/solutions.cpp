#include "elementary/solutions.hpp"

#include "elementary/antiderivative.hpp"
#include "elementary/check.hpp"
#include "elementary/trig_form.hpp"
#include "elementary/undetermined.hpp"
#include "exact/tried.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace kov::elementary {
namespace {

using Trig = Monomial::Trig;
using Kind = Expression::Kind;

// c0, c1, c2 divided by c2, where they are rational functions.
std::optional<std::vector<MFraction>> rational_coefficients(const LinearEquation& e) {
  const auto c0 = e.c0.rational(), c1 = e.c1.rational(), c2 = e.c2.rational();
  if (!c0 || !c1 || !c2 || is_zero(*c2)) return std::nullopt;
  const Letters& letters = *e.right.letters();
  return std::vector{letters.reduced(*c0 / *c2), letters.reduced(*c1 / *c2), letters.number(1)};
}

bool has_integral(const Element& f) {
  return std::ranges::any_of(f.terms(), [](const auto& entry) {
    const Monomial& m = *entry.second.monomial;
    return has_integral(m.exponent) || has_integral(m.angle) ||
           std::ranges::any_of(m.kernels, [](const auto& k) {
             return k.kernel->name == Kernel::Name::integral || has_integral(k.kernel->argument);
           });
  });
}

Element wronskian(const Basis& b) {
  return simplified(b.first * derivative(b.second) - derivative(b.first) * b.second);
}

// Terms that solve the homogeneous equation are left out: numbers times a term of the basis.
Element without_homogeneous(Element y, const Basis& basis) {
  for (const Element* one : {&basis.first, &basis.second}) {
    if (one->terms().size() != 1) continue;
    const auto& [key, t] = *one->terms().begin();
    const auto at = y.terms().find(key);
    if (at == y.terms().end()) continue;
    const MFraction c = y.letters()->reduced(at->second.coefficient / t.coefficient);
    if (!uses(c, Letters::x)) y -= c * *one;
  }
  return y;
}

Element by_variation(const Basis& basis, const Element& f) {
  const Element g = f / wronskian(basis);
  const Element a = integral(simplified(basis.second * g)),
                b = integral(simplified(basis.first * g));
  return without_homogeneous(simplified(basis.second * b - basis.first * a), basis);
}

} // namespace

std::vector<std::string> dependent_where(const Basis& basis) {
  const Letters& letters = *basis.first.letters();
  std::vector<std::string> all;
  const Element w = wronskian(basis);
  for (const auto& [key, t] : w.terms())
    for (const auto& [base, e] : factor(t.coefficient.num()).second) {
      if (uses(base, Letters::x)) continue;
      std::string text = letters.text(base);
      for (std::size_t i = 0; i < letters.radicands().size(); ++i)
        if (base == MPoly::variable(letters.ring(), Letters::first_root + i))
          text = letters.text(letters.radicands()[i]);
      if (std::ranges::none_of(
              text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }))
        continue;
      if (!std::ranges::count(all, text)) all.push_back(text);
    }
  return all;
}

std::optional<Basis> homogeneous_basis(const LinearEquation& e) {
  if (is_zero(e.c0) && !is_zero(e.c2) && !rational_coefficients(e)) // y'' + p y' = 0
    return tried<NotElementary, DomainError>([&] {
      const Element one = e.right.number(1);
      return std::optional(Basis{one, second_solution(e, one)});
    });
  const auto c = rational_coefficients(e);
  if (!c) return std::nullopt;
  return characteristic_basis((*c)[1], (*c)[0], e.right.letters());
}

std::optional<Element> particular_solution(const LinearEquation& e,
                                           const std::optional<Basis>& basis) {
  if (is_zero(e.right)) return e.right;
  return tried<NotElementary, DomainError>([&]() -> std::optional<Element> {
    const Element f = e.right / e.c2;
    if (const auto c = rational_coefficients(e))
      if (auto y = undetermined(*c, f)) return y;
    if (!basis) return std::nullopt;
    return by_variation(*basis, f);
  });
}

InitialValue initial_value(const Expression& condition, const std::string& unknown,
                           const LettersPtr& letters) {
  if (condition.kind() != Kind::equation) throw NotElementary("no value");
  const Expression* at = &condition.operand(0);
  long order = 0;
  if (at->kind() == Kind::derivative) {
    order = at->order();
    at = &at->operand(0);
  }
  if (at->kind() != Kind::call || at->name() != unknown || at->operands().size() != 1)
    throw NotElementary("no value of " + unknown);
  InitialValue v{element(at->operand(0), letters), order, element(condition.operand(1), letters)};
  if (!is_constant(v.point) || !is_constant(v.value))
    throw NotElementary("a value that is not a constant");
  return v;
}

namespace {

Element at(Element f, const InitialValue& v) {
  for (long k = 0; k < v.order; ++k)
    f = derivative(f);
  return compose(f, v.point);
}

WithValues with_start(Element y, const InitialValue& v) {
  const bool integrals = has_integral(y);
  return {std::move(y), {}, integrals ? std::optional(v.point) : std::nullopt};
}

// Two equations for c1 and c2 that are one, or contradict each other: by Cramer's numerators.
std::string why_not_one(const Element& c1, const Element& c2) {
  if (is_zero(c1) && is_zero(c2)) return "more than one solution has these values";
  const Element zero(c1.letters());
  const bool is_certain = !are_equal_at_points(c1, zero) || !are_equal_at_points(c2, zero);
  return is_certain ? "no solution has these values: they contradict each other"
                    : "no solution, or more than one, has these values";
}

} // namespace

WithValues with_values(const Basis& basis, const Element& particular,
                       const std::vector<InitialValue>& values) {
  if (values.size() != 2) return {{}, "two values are needed for one function"};
  const bool integrals = has_integral(particular) || has_integral(basis.second);
  if (integrals && !is_zero(values[0].point - values[1].point))
    return {{}, "the solutions have an integral, whose value is known at one point only"};
  std::vector<std::array<Element, 3>> rows;
  for (const InitialValue& v : values) {
    try {
      rows.push_back({at(basis.first, v), at(basis.second, v), v.value - at(particular, v)});
    } catch (const NotElementary&) {
      return {{}, "the solutions have no value at " + text(v.point)};
    }
  }
  try {
    const auto det = [&](std::size_t i, std::size_t j) {
      return simplified(rows[0][i] * rows[1][j] - rows[0][j] * rows[1][i]);
    };
    const Element d = det(0, 1);
    if (is_zero(d)) return {{}, why_not_one(det(2, 1), det(0, 2))};
    Element y = simplified(det(2, 1) / d * basis.first + det(0, 2) / d * basis.second + particular);
    for (const InitialValue& v : values)
      if (!are_equal_at_points(at(y, v), v.value))
        return {{}, "no solution was found that has these values"};
    return with_start(std::move(y), values[0]);
  } catch (const NotElementary& why) {
    return {{}, std::string("no solution was found that has these values (") + why.what() + ")"};
  }
}

FirstOrderSolutions first_order_solutions(const LinearEquation& e) {
  const Element p = simplified(e.c0 / e.c1), f = simplified(e.right / e.c1);
  const Element h = exp(-integral(p));
  if (is_zero(f)) return {h, f};
  if (const auto r = p.rational())
    if (const auto y = undetermined({*r, e.right.letters()->number(1)}, f)) return {h, *y};
  return {h, simplified(h * integral(simplified(f / h)))};
}

WithValues with_value(const FirstOrderSolutions& s, const InitialValue& v) {
  if (v.order != 0) return {{}, "the value of the function is needed, not of its derivative"};
  try {
    const Element c = (v.value - at(s.particular, v)) / at(s.homogeneous, v);
    Element y = simplified(c * s.homogeneous + s.particular);
    if (!are_equal_at_points(at(y, v), v.value))
      return {{}, "no solution was found that has this value"};
    return with_start(std::move(y), v);
  } catch (const NotElementary&) {
    return {{}, "the solutions have no value at " + text(v.point)};
  }
}

namespace {

// -u'/(a u)
Element riccati_of(const Element& u, const Element& a) {
  return simplified(-derivative(u) / (a * u));
}

// M cos(h) and M sin(h)?
std::optional<std::pair<Element, Element>> as_circle(const Basis& b) {
  if (b.first.terms().size() != 1 || b.second.terms().size() != 1) return std::nullopt;
  const auto &s = b.first.terms().begin()->second, &t = b.second.terms().begin()->second;
  if (s.monomial->trig != Trig::cos || t.monomial->trig != Trig::sin ||
      !(s.coefficient == t.coefficient) || !is_zero(s.monomial->angle - t.monomial->angle))
    return std::nullopt;
  Monomial m = *s.monomial;
  const Element angle = m.angle;
  m.trig = Trig::none;
  m.angle = Element(b.first.letters());
  Element rest(b.first.letters());
  rest.add(m, s.coefficient);
  if (!is_zero(b.second - rest * sin(angle))) return std::nullopt;
  return std::pair{rest, angle};
}

bool is_algebraic(const Element& f) {
  return std::ranges::all_of(f.terms(), [](const auto& entry) {
    const Monomial& m = *entry.second.monomial;
    return m.trig == Trig::none && is_zero(m.exponent) &&
           std::ranges::all_of(m.kernels, [](const auto& k) {
             return k.kernel->name == Kernel::Name::inverse && is_algebraic(k.kernel->argument);
           });
  });
}

} // namespace

RiccatiSolutions riccati_solutions(const Element& a, const Basis& basis,
                                   const std::string& constant) {
  const LettersPtr& letters = a.letters();
  const Element c(letters, MFraction::variable(letters->ring(), constant));
  RiccatiSolutions found{{}, c};
  if (const auto circle = as_circle(basis)) {
    const auto& [m, h] = *circle;
    const Element angle = h + c;
    found.general = -derivative(m) / (a * m) + derivative(h) / a * sin(angle) / cos(angle);
    return found;
  }
  const Element first = riccati_of(basis.first, a);
  if (is_algebraic(first)) found.special.push_back(first);
  if (!has_integral(basis.second))
    if (const Element second = riccati_of(basis.second, a); is_algebraic(second))
      found.special.push_back(second);
  const Element g = basis.second / basis.first;
  found.general = first - derivative(g) / (a * (c + g));
  return found;
}

WithValues riccati_with_value(const Element& a, const Basis& basis, const InitialValue& v) {
  if (v.order != 0) return {{}, "one value is needed for one function"};
  try {
    // u' + a y u = 0 at the point
    const Element here = compose(a, v.point) * v.value;
    const Element s = compose(derivative(basis.first), v.point) +
                      here * compose(basis.first, v.point),
                  t = compose(derivative(basis.second), v.point) +
                      here * compose(basis.second, v.point);
    const Element u = is_zero(s) ? basis.first : simplified(basis.second - t / s * basis.first);
    Element y = riccati_of(u, a);
    if (!are_equal_at_points(compose(y, v.point), v.value))
      return {{}, "no solution was found that has this value"};
    return with_start(std::move(y), v);
  } catch (const NotElementary&) {
    return {{}, "the solutions have no value at " + text(v.point)};
  }
}

} // namespace kov::elementary
