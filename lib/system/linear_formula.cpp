#include "system/linear_formula.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = Expression::Kind;

class NotLinear {};

// c[0] y + c[1] y' + ..., and a term without y.
struct Form {
  std::vector<MFraction> c;
  MFraction rest;
};

class Reader {
public:
  Reader(const std::string& unknown, std::size_t z, const Scope& scope)
      : unknown_(unknown), z_(z), scope_(scope) {}

  Form operator()(const Expression& e) const {
    if (!mentions(e)) return {{}, evaluate(e, scope_)};
    switch (e.kind()) {
    case Kind::name:
      return {{MFraction(scope_.ring(), Rational(1))}, MFraction(scope_.ring())};
    case Kind::sum:
      return sum(e);
    case Kind::negate:
      return scaled((*this)(e.operand(0)), MFraction(scope_.ring(), Rational(-1)));
    case Kind::product:
      return product(e);
    case Kind::quotient:
      if (mentions(e.operand(1))) throw NotLinear{};
      return scaled((*this)(e.operand(0)),
                    pow(evaluate(e.operand(1), scope_), -1)); // DomainError for 0
    case Kind::call:                                          // y(z)
      if (e.name() != unknown_) throw NotLinear{};
      return {{MFraction(scope_.ring(), Rational(1))}, MFraction(scope_.ring())};
    case Kind::derivative:
      return differentiated((*this)(e.operand(0)), e.order());
    case Kind::equation:
      return added((*this)(e.operand(0)),
                   scaled((*this)(e.operand(1)), MFraction(scope_.ring(), Rational(-1))));
    default:
      throw NotLinear{};
    }
  }

private:
  [[nodiscard]] bool mentions(const Expression& e) const {
    if (e.kind() == Kind::derivative || e.kind() == Kind::equation) return true;
    if ((e.kind() == Kind::name || e.kind() == Kind::call) && e.name() == unknown_) return true;
    if (e.kind() == Kind::call && e.name() == "diff") throw NotLinear{};
    return std::any_of(e.operands().begin(), e.operands().end(),
                       [&](const Expression& x) { return mentions(x); });
  }

  static Form added(Form a, const Form& b) {
    if (a.c.size() < b.c.size()) a.c.resize(b.c.size());
    for (std::size_t i = 0; i < b.c.size(); ++i)
      a.c[i] += b.c[i];
    a.rest += b.rest;
    return a;
  }
  static Form scaled(Form a, const MFraction& f) {
    for (MFraction& c : a.c)
      c *= f;
    a.rest *= f;
    return a;
  }
  [[nodiscard]] Form sum(const Expression& e) const {
    Form total{{}, MFraction(scope_.ring())};
    for (const Expression& term : e.operands())
      total = added(std::move(total), (*this)(term));
    return total;
  }
  [[nodiscard]] Form product(const Expression& e) const {
    MFraction factor(scope_.ring(), Rational(1));
    const Expression* linear = nullptr;
    for (const Expression& operand : e.operands()) {
      if (!mentions(operand)) {
        factor *= evaluate(operand, scope_);
        continue;
      }
      if (linear != nullptr) throw NotLinear{};
      linear = &operand;
    }
    return scaled((*this)(*linear), factor);
  }
  // (sum c_k y^(k))' = sum c_k' y^(k) + c_k y^(k+1)
  [[nodiscard]] Form differentiated(Form a, long order) const {
    if (order > 2) throw NotLinear{};
    for (; order > 0; --order) {
      Form b{std::vector<MFraction>(a.c.size() + 1, MFraction(scope_.ring())),
             derivative(a.rest, z_)};
      for (std::size_t k = 0; k < a.c.size(); ++k) {
        b.c[k] += derivative(a.c[k], z_);
        b.c[k + 1] += a.c[k];
      }
      a = std::move(b);
    }
    return a;
  }

  const std::string& unknown_;
  std::size_t z_;
  const Scope& scope_;
};

} // namespace

std::optional<ParametricSecondOrder> parametric_second_order(const Expression& equation,
                                                             const std::string& unknown,
                                                             std::size_t z, const Scope& scope) {
  try {
    Form form = Reader(unknown, z, scope)(equation);
    while (!form.c.empty() && is_zero(form.c.back()))
      form.c.pop_back();
    if (form.c.size() != 3 || !is_zero(form.rest)) return std::nullopt;
    return ParametricSecondOrder{form.c[0], form.c[1], form.c[2]};
  } catch (const NotLinear&) {
    return std::nullopt;
  }
}

} // namespace kov
