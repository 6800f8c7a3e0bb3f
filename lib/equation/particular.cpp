#include "equation/particular.hpp"

#include "exact/linear.hpp"
#include "exact/tried.hpp"
#include "symbol/written.hpp"
#include "system/linear_formula.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr long more_degrees = 6; // above those of the right side
constexpr std::size_t most_unknowns = 120;

/// exp(g), or exp(g) cos(h) and exp(g) sin(h): what derivatives lead back to.
struct Type {
  MFraction g, h;
  [[nodiscard]] std::size_t size() const { return is_zero(h) ? 1 : 2; }
};
/// Rational functions times the members of one type.
using Vector = std::vector<MFraction>;

class Particular {
public:
  Particular(const Expression& ode, const std::string& unknown, const std::string& x)
      : ring_(make_ring({x})), scope_(ring_, {}), x_(x),
        form_(parametric_second_order(ode, unknown, 0, scope_)) {}

  std::optional<std::string> operator()(const Expression& right) {
    for (const SignedTerm& t : terms_of(right))
      take(t);
    std::string all;
    for (const auto& [name, part] : parts_) {
      const auto y = solution(part.type, part.f);
      if (!y) return std::nullopt;
      for (std::size_t i = 0; i < y->size(); ++i)
        if (!is_zero((*y)[i])) all += (all.empty() ? "" : " + ") + text((*y)[i], part.type, i);
    }
    return all.empty() ? "0" : all;
  }

private:
  struct Part {
    Type type;
    Vector f;
  };

  [[nodiscard]] MFraction number(const Rational& c) const { return {ring_, c}; }
  [[nodiscard]] MFraction value(const Expression& e) const { return evaluate(e, scope_); }

  // One term of the right side, into its part.
  void take(const SignedTerm& t) {
    Type type{MFraction(ring_), MFraction(ring_)};
    MFraction factor = number(Rational(t.minus ? -1 : 1));
    int trig = -1; // 0: cos, 1: sin
    gather(t.term, false, type, factor, trig);
    if (!is_zero(type.h) && sign(type.h.num().coefficient(0)) < 0) { // sin(-h) = -sin(h)
      type.h = -type.h;
      if (trig == 1) factor = -factor;
    }
    const std::string name = to_string(type.g) + " " + to_string(type.h);
    auto [at, is_new] = parts_.try_emplace(name, Part{type, Vector(type.size(), MFraction(ring_))});
    at->second.f[trig == 1 ? 1 : 0] += factor;
  }

  void gather(const Expression& e, bool below, Type& type, MFraction& factor, int& trig) {
    const bool called = e.kind() == Kind::call && e.operands().size() == 1;
    if (called && e.name() == "exp") {
      const MFraction g = value(e.operand(0));
      type.g = below ? type.g - g : type.g + g;
    } else if (called && (e.name() == "sin" || e.name() == "cos") && trig < 0 && !below) {
      type.h = value(e.operand(0));
      trig = e.name() == "sin" ? 1 : 0;
    } else if (e.kind() == Kind::product) {
      for (const Expression& x : e.operands())
        gather(x, below, type, factor, trig);
    } else if (e.kind() == Kind::quotient) {
      gather(e.operand(0), below, type, factor, trig);
      gather(e.operand(1), !below, type, factor, trig);
    } else if (e.kind() == Kind::negate) {
      factor = -factor;
      gather(e.operand(0), below, type, factor, trig);
    } else {
      const MFraction f = value(e);
      factor = below ? factor / f : factor * f;
    }
  }

  // (sum f_i b_i)'
  [[nodiscard]] Vector differentiated(const Vector& f, const Type& t) const {
    const MFraction g = derivative(t.g, 0), h = derivative(t.h, 0);
    Vector d;
    for (const MFraction& x : f)
      d.push_back(derivative(x, 0) + g * x);
    if (f.size() == 2) {
      d[0] += h * f[1];
      d[1] -= h * f[0];
    }
    return d;
  }
  [[nodiscard]] Vector applied(const Vector& y, const Type& t) const {
    const Vector y1 = differentiated(y, t), y2 = differentiated(y1, t);
    Vector sum;
    for (std::size_t i = 0; i < y.size(); ++i)
      sum.push_back(form_.c2 * y2[i] + form_.c1 * y1[i] + form_.c0 * y[i]);
    return sum;
  }

  // With the denominators 1, d, d^2, d the finite singular places.
  [[nodiscard]] std::optional<Vector> solution(const Type& t, const Vector& f) const {
    MFraction d = number(Rational(1));
    for (const MFraction& c : {form_.c1 / form_.c2, form_.c0 / form_.c2})
      for (const MFactor& x : factor(c.den()).second)
        if (!divides(x.base, d.num())) d = d * MFraction(x.base);
    for (const MFraction& c : f)
      for (const MFactor& x : is_zero(c) ? std::vector<MFactor>{} : factor(c.den()).second)
        if (!divides(x.base, d.num())) d = d * MFraction(x.base);
    for (long k = 0; k <= (degree(d.num(), 0) > 0 ? 2 : 0); ++k)
      if (auto y = with_denominator(t, f, pow(d, k))) return y;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Vector> with_denominator(const Type& t, const Vector& f,
                                                       const MFraction& d) const {
    long size = more_degrees + degree(d.num(), 0);
    for (const MFraction& c : f)
      size = std::max(size, more_degrees + degree(d.num(), 0) + degree(c.num(), 0));
    const auto terms = static_cast<std::size_t>(size) + 1;
    if (terms * f.size() > most_unknowns) return std::nullopt;
    std::vector<Vector> unknowns, images;
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t k = 0; k < terms; ++k) {
        Vector y(f.size(), MFraction(ring_));
        y[i] = pow(MFraction::variable(ring_, 0), static_cast<long>(k)) / d;
        images.push_back(applied(y, t));
        unknowns.push_back(std::move(y));
      }
    const auto c = solved(images, f);
    if (!c) return std::nullopt;
    Vector y(f.size(), MFraction(ring_));
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      for (std::size_t i = 0; i < f.size(); ++i)
        y[i] += (*c)[j] * unknowns[j][i];
    const Vector image = applied(y, t);
    for (std::size_t i = 0; i < f.size(); ++i)
      if (!is_zero(image[i] - f[i])) return std::nullopt;
    return y;
  }

  // Rational numbers c with sum c_j images_j = f.
  [[nodiscard]] std::optional<std::vector<Rational>> solved(const std::vector<Vector>& images,
                                                            const Vector& f) const {
    MFraction common = number(Rational(1));
    const auto widen = [&](const Vector& v) {
      for (const MFraction& x : v)
        common = common * MFraction((x * common).den());
    };
    std::ranges::for_each(images, widen);
    widen(f);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Rational>>
        rows; // by component and power
    const auto enter = [&](const Vector& v, std::size_t column) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        const MFraction p = v[i] * common;
        const auto c = coefficients(p.num(), 0);
        for (std::size_t k = 0; k < c.size(); ++k) {
          auto& row = rows[{i, k}];
          row.resize(images.size() + 1);
          row[column] = to_rational(MFraction(c[k]) / MFraction(p.den()));
        }
      }
    };
    for (std::size_t j = 0; j < images.size(); ++j)
      enter(images[j], j);
    enter(f, images.size());
    std::vector<std::vector<Rational>> matrix;
    for (auto& [place, row] : rows)
      matrix.push_back(std::move(row));
    return kov::solution(std::move(matrix), images.size());
  }

  [[nodiscard]] static std::string text(const MFraction& c, const Type& t, std::size_t member) {
    std::string functions;
    if (!is_zero(t.g)) functions = "exp(" + to_string(t.g) + ")";
    if (!is_zero(t.h))
      functions += (functions.empty() ? "" : "*") + std::string(member == 0 ? "cos(" : "sin(") +
                   to_string(t.h) + ")";
    const std::string factor = to_string(c);
    if (functions.empty()) return factor;
    if (is_one(c)) return functions;
    const bool atom = factor.find_first_of("+-*/ ") == std::string::npos;
    return (atom ? factor : "(" + factor + ")") + "*" + functions;
  }

  Ring ring_;
  ParameterScope scope_;
  std::string x_;
  ParametricSecondOrder form_;
  std::map<std::string, Part> parts_;
};

} // namespace

std::optional<std::string> particular_solution(const Expression& homogeneous,
                                               const std::string& unknown,
                                               const std::string& variable,
                                               const Expression& right_side) {
  // nothing: other names, roots, functions, or a division by zero
  return tried<InputError, DomainError>(
      [&] { return Particular(homogeneous, unknown, variable)(right_side); });
}

} // namespace kov
