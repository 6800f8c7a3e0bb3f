#include "quadratures/obstruction.hpp"

#include "algebraize/function_field.hpp"
#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "galois/algebraic_solution.hpp"
#include "galois/exponential_form.hpp"
#include "galois/solutions.hpp"
#include "integrability/constants.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/parameters.hpp"
#include "linode/normal_form.hpp"
#include "manifold/existence.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace kov {
namespace {

using Element = PrimitiveExtension::Element;
using RationalMatrix = std::vector<std::vector<RationalFunction>>;

struct NotApplicable {
  std::string why;
};

/// The curve x_i = phi_i(z), dz/dt = speed, over one field of constants.
class RationalCurve {
public:
  RationalCurve(const System& s, const InvariantManifold& m, const MFraction& change,
                FunctionField field)
      : v_(s.field), m_(m), change_(change), field_(std::move(field)),
        constants_(ConstantField::make(s.field)), z_(s.z) {
    speed_ = in_z(field_.z_dot());
  }
  [[nodiscard]] const VectorField& v() const { return v_; }
  [[nodiscard]] const RationalFunction& speed() const { return *speed_; }
  [[nodiscard]] bool is_rational() const { return speed_.has_value(); }
  [[nodiscard]] std::string change() const { return to_string(change_); }

  /// A function on the phase space, along the curve.
  [[nodiscard]] RationalFunction value(const MFraction& f) const {
    const auto element = field_.evaluate(f);
    auto here = element ? in_z(*element) : std::nullopt;
    if (!here) throw NotApplicable{"a derivative of the field has a pole on the curve"};
    return *std::move(here);
  }

private:
  [[nodiscard]] std::optional<RationalFunction> in_z(const FunctionField::Element& a) const {
    const auto f = field_.in_z(a);
    if (!f) return std::nullopt;
    return constants_.convert(*f, z_);
  }
  const VectorField& v_;
  const InvariantManifold& m_;
  MFraction change_;
  FunctionField field_;
  ConstantField constants_;
  std::size_t z_;
  std::optional<RationalFunction> speed_;
};

/// A fundamental matrix of y1' = a11 y1 + a12 y2, y2' = a21 y1 + a22 y2 (' is d/dz):
/// (y, w) and (y h, w h + g), h' = a12 g / y.
struct Pair {
  std::size_t first = 0, second = 0; ///< coordinates
  RationalFunction y, w, g;
  Element h;
};

/// y' = B y for two unknowns, dy/dz.
class PairSolver {
public:
  PairSolver(const RationalMatrix& b, std::size_t i, std::size_t j, const Budget& budget)
      : b_(b), i_(i), j_(j), budget_(budget) {}

  /// A rational solution of the normal equation, and h' = b12 g/y.
  [[nodiscard]] std::pair<Pair, RationalFunction> with_one_line() const {
    const RationalFunction& b = b_[i_][j_];
    if (is_zero(b)) throw NotApplicable{"the normal unknowns are not coupled"};
    const RationalFunction slope = derivative(b) / b;
    const RationalFunction p = -(b_[i_][i_] + b_[j_][j_] + slope);
    const RationalFunction q =
        (slope + b_[j_][j_]) * b_[i_][i_] - derivative(b_[i_][i_]) - b * b_[j_][i_];
    const RationalFunction half(Rational(1, 2));
    const RationalFunction r = half * half * p * p + half * derivative(p) - q;
    const Classification group = classify(r, budget_);
    if (group.component != Connected::additive && group.component != Connected::trivial)
      throw NotApplicable{"the identity component of the normal equation is neither C nor trivial"};
    const auto lines = solutions(group, r, budget_);
    if (lines.empty() || !lines.front().exponential)
      throw NotApplicable{"the solution of the normal equation is not rational"};
    const auto y =
        with_logarithmic_derivative(lines.front().exponential->omega() - half * p, budget_);
    const auto wronskian = with_logarithmic_derivative(-p, budget_);
    if (!y || !wronskian)
      throw NotApplicable{"the solution of the normal equation is not rational"};
    const RationalFunction u = *wronskian / (*y * *y);
    Pair pair{i_, j_, *y, second(*y), u * *y / b, {}};
    return {std::move(pair), u};
  }

  /// The unknowns along the curve, where one solution is the velocity, and h'.
  [[nodiscard]] std::pair<Pair, RationalFunction> along(const RationalFunction& y) const {
    if (is_zero(y)) throw NotApplicable{"a coordinate of the curve is constant"};
    const auto g = with_logarithmic_derivative(b_[i_][i_] + b_[j_][j_], budget_);
    if (!g) throw NotApplicable{"the determinant of the tangential part is not rational"};
    Pair pair{i_, j_, y, second(y), *g / y, {}};
    const RationalFunction slope = b_[i_][j_] * pair.g / y;
    return {std::move(pair), slope};
  }

private:
  // The second component of the solution with the first component y; of y = 0 nothing is known.
  [[nodiscard]] RationalFunction second(const RationalFunction& y) const {
    if (is_zero(b_[i_][j_])) throw NotApplicable{"the tangential unknowns are not coupled"};
    return (derivative(y) - b_[i_][i_] * y) / b_[i_][j_];
  }
  const RationalMatrix& b_;
  std::size_t i_, j_;
  const Budget& budget_;
};

// (y, w)' = B (y, w), and (y h, w h + g)' = B (y h, w h + g).
void require_solution(const RationalMatrix& b, const Pair& p, const PrimitiveExtension& l) {
  const std::size_t i = p.first, j = p.second;
  KOV_ENSURE(derivative(p.y) == b[i][i] * p.y + b[i][j] * p.w);
  if (!(derivative(p.w) == b[j][i] * p.y + b[j][j] * p.w))
    throw NotApplicable{"the velocity is not a solution by itself"};
  KOV_ENSURE(l.derivative(p.h) == Element{b[i][j] * p.g / p.y});
  KOV_ENSURE(derivative(p.g) + p.w * b[i][j] * p.g / p.y == b[j][j] * p.g);
}

/// sum over monomials c1^a c2^b of elements of K[I].
using Jet = std::map<std::array<int, 2>, Element>;

Jet operator+(Jet a, const Jet& b) {
  for (const auto& [m, f] : b) {
    Element sum = a[m] + f;
    if (sum.empty())
      a.erase(m);
    else
      a[m] = std::move(sum);
  }
  return a;
}
Jet operator*(const Jet& a, const Jet& b) {
  Jet all;
  for (const auto& [m, f] : a)
    for (const auto& [n, g] : b)
      all = std::move(all) + Jet{{{m[0] + n[0], m[1] + n[1]}, f * g}};
  return all;
}
Jet scaled(const Element& c, Jet a) {
  for (auto& [m, f] : a)
    f = c * f;
  std::erase_if(a, [](const auto& x) { return x.second.empty(); });
  return a;
}
Jet scaled(const RationalFunction& c, const Jet& a) { return scaled(Element{c}, a); }

// Unknowns that are coupled, directly or by others.
std::vector<std::vector<std::size_t>> coupled_parts(const RationalMatrix& b) {
  const std::size_t n = b.size();
  std::vector<std::vector<std::size_t>> all;
  std::vector<bool> done(n, false);
  for (std::size_t first = 0; first < n; ++first) {
    if (done[first]) continue;
    std::vector<std::size_t> part{first};
    done[first] = true;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (std::size_t j = 0; j < n; ++j)
        if (!done[j] && (!is_zero(b[part[k]][j]) || !is_zero(b[j][part[k]]))) {
          done[j] = true;
          part.push_back(j);
        }
    all.push_back(std::move(part));
  }
  return all;
}

// alpha! of the multi-index.
Rational multiplicities(const std::vector<std::size_t>& indices) {
  Rational all(1);
  long same = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    same = i > 0 && indices[i] == indices[i - 1] ? same + 1 : 1;
    all = all * Rational(same);
  }
  return all;
}
// The part of order k of the product of these components of xi.
Jet product_of_order(const std::vector<std::size_t>& indices, int k,
                     const std::vector<std::vector<Jet>>& xi) {
  std::vector<Jet> by_order(static_cast<std::size_t>(k) + 1); // of the product so far
  by_order[0] = {{{0, 0}, {RationalFunction(1)}}};
  for (const std::size_t i : indices) {
    std::vector<Jet> next(by_order.size());
    for (std::size_t a = 0; a < by_order.size(); ++a)
      for (std::size_t b = 1; b < xi.size() && a + b < next.size(); ++b)
        if (!by_order[a].empty() && !xi[b][i].empty())
          next[a + b] = std::move(next[a + b]) + by_order[a] * xi[b][i];
    by_order = std::move(next);
  }
  return by_order.back();
}

/// The variational equations of orders 1, 2, ... in the two constants of the normal solutions.
class EquationsByOrder {
public:
  EquationsByOrder(const RationalCurve& curve, const Budget& budget)
      : curve_(curve), budget_(budget), n_(curve.v().dimension()) {
    const VectorField& v = curve_.v();
    b_.assign(n_, std::vector<RationalFunction>(n_, RationalFunction(0)));
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j)
        b_[i][j] = curve_.value(partial(v, v.components[i], j)) / curve_.speed();
    std::vector<std::size_t> normal, along;
    for (const auto& part : coupled_parts(b_)) {
      const bool moves = std::ranges::any_of(
          part, [&](std::size_t j) { return !is_zero(curve_.value(v.components[j])); });
      auto& of_this_kind = moves ? along : normal;
      if (!of_this_kind.empty())
        throw NotApplicable{moves ? "the variations along the curve fall apart"
                                  : "there are several normal parts"};
      of_this_kind = part;
    }
    solve(normal, along);
  }

  [[nodiscard]] std::optional<QuadratureObstruction> obstruction(int largest) {
    first_order();
    for (int k = 2; k <= largest; ++k)
      if (auto found = next_order(k)) return found;
    return std::nullopt;
  }

private:
  void solve(const std::vector<std::size_t>& normal, const std::vector<std::size_t>& along) {
    if (normal.size() != 2 || along.empty() || along.size() > 2)
      throw NotApplicable{"there are other numbers of unknowns than two and at most two"};
    const bool turned = is_zero(b_[normal[0]][normal[1]]);
    add(PairSolver(b_, normal[turned ? 1 : 0], normal[turned ? 0 : 1], budget_).with_one_line());
    const auto velocity = [&](std::size_t j) { return curve_.value(curve_.v().components[j]); };
    if (along.size() == 1) {
      single_ = along[0];
      single_solution_ = velocity(along[0]);
      if (is_zero(single_solution_)) throw NotApplicable{"the curve does not move"};
      return;
    }
    const bool other = is_zero(b_[along[0]][along[1]]) || is_zero(velocity(along[0]));
    const std::size_t i = along[other ? 1 : 0], j = along[other ? 0 : 1];
    add(PairSolver(b_, i, j, budget_).along(velocity(i)));
  }

  // With h, for which I is adjoined if it is the first integral that is not rational.
  void add(std::pair<Pair, RationalFunction> solution) {
    auto& [pair, slope] = solution;
    auto h = in_l({slope});
    if (!h) throw NotApplicable{"the first order needs two integrals"};
    pair.h = *std::move(h);
    require_solution(b_, pair, l_);
    pairs_.push_back(std::move(pair));
  }

  // A primitive in L; the first one that is not rational generates L.
  [[nodiscard]] std::optional<Element> in_l(const Element& f, std::size_t* level = nullptr) {
    auto g = l_.primitive(f, budget_, level);
    if (g || !l_.is_none()) return g;
    l_ = *PrimitiveExtension::make(f.front(), budget_);
    return l_.primitive(f, budget_, level);
  }

  void first_order() {
    const Pair& p = pairs_.front();
    std::vector<Jet> xi(n_);
    const Element y{p.y}, w{p.w};
    xi[p.first] = {{{1, 0}, y}, {{0, 1}, y * p.h}};
    xi[p.second] = {{{1, 0}, w}, {{0, 1}, w * p.h + Element{p.g}}};
    for (Jet& jet : xi)
      std::erase_if(jet, [](const auto& x) { return x.second.empty(); });
    xi_ = {std::vector<Jet>(n_), std::move(xi)};
  }

  // xi_k = Phi int Phi^-1 S_k/speed.
  std::optional<QuadratureObstruction> next_order(int k) {
    const auto s = source(k);
    std::vector<Jet> next(n_);
    for (const Pair& p : pairs_) {
      const RationalFunction slope = p.w / p.y, over_g = RationalFunction(1) / p.g;
      const Jet c = scaled(over_g, s[p.second] + scaled(-slope, s[p.first]));
      const Jet a = scaled(RationalFunction(1) / p.y, s[p.first]) +
                    scaled(RationalFunction(-1), scaled(p.h, c));
      Jet int_a, int_c;
      for (const auto& [jet, integral] : {std::pair(&a, &int_a), {&c, &int_c}})
        if (auto found = integrate(*jet, p.second, k, *integral)) return found;
      next[p.first] = scaled(p.y, int_a + scaled(p.h, int_c));
      next[p.second] = scaled(p.w, int_a + scaled(p.h, int_c)) + scaled(p.g, int_c);
    }
    if (single_) {
      Jet integral;
      if (auto found = integrate(scaled(RationalFunction(1) / single_solution_, s[*single_]),
                                 *single_, k, integral))
        return found;
      next[*single_] = scaled(single_solution_, integral);
    }
    xi_.push_back(std::move(next));
    return std::nullopt;
  }

  // All coefficients, or an obstruction at one.
  std::optional<QuadratureObstruction> integrate(const Jet& f, std::size_t unknown, int k,
                                                 Jet& integral) {
    bool all = true;
    for (const auto& [monomial, element] : f) {
      if (const auto g = in_l(element)) {
        if (!g->empty()) integral[monomial] = *g;
        continue;
      }
      all = false;
      std::size_t level = 0;
      if (l_.primitive(by_the_primitive(element), budget_, &level)) continue;
      QuadratureObstruction o;
      o.order = k;
      o.u = l_.u();
      o.f = element;
      o.power = level;
      o.of = "c1^" + std::to_string(monomial[0]) + "*c2^" + std::to_string(monomial[1]) +
             " in the variation of " + curve_.v().name(unknown);
      return o;
    }
    if (!all)
      throw NotApplicable{"VE_" + std::to_string(k) +
                          " needs an integral that is not in K(I), which is not an obstruction"};
    return std::nullopt;
  }

  // The terms of degree >= 2 of the field in xi_1, ..., xi_(k-1) that have order k, over the speed.
  [[nodiscard]] std::vector<Jet> source(int k) const {
    std::vector<Jet> all(n_);
    const VectorField& v = curve_.v();
    using Derivatives = std::vector<std::pair<std::vector<std::size_t>, std::vector<MFraction>>>;
    Derivatives front{{{}, v.components}};
    for (int degree = 1; degree <= k; ++degree) {
      Derivatives next;
      for (const auto& [indices, components] : front)
        for (std::size_t j = indices.empty() ? 0 : indices.back(); j < n_; ++j) {
          budget_.check();
          auto longer = indices;
          longer.push_back(j);
          std::vector<MFraction> derived;
          for (const MFraction& f : components)
            derived.push_back(partial(v, f, j));
          next.emplace_back(std::move(longer), std::move(derived));
        }
      front = std::move(next);
      if (degree < 2) continue;
      for (const auto& [indices, components] : front) {
        const Jet power = product_of_order(indices, k, xi_);
        if (power.empty()) continue;
        const Rational weight = Rational(1) / multiplicities(indices);
        for (std::size_t i = 0; i < n_; ++i) {
          if (is_zero(components[i])) continue;
          const RationalFunction c =
              RationalFunction(weight) * curve_.value(components[i]) / curve_.speed();
          if (!is_zero(c)) all[i] = std::move(all[i]) + scaled(c, power);
        }
      }
    }
    return all;
  }
  const RationalCurve& curve_;
  const Budget& budget_;
  std::size_t n_;
  RationalMatrix b_; ///< of the first order, by z
  std::vector<Pair> pairs_;
  std::optional<std::size_t> single_;
  RationalFunction single_solution_;
  PrimitiveExtension l_ = PrimitiveExtension::none();
  std::vector<std::vector<Jet>> xi_; ///< by order, by coordinate
};

// The level parameters that the manifold has.
std::vector<std::size_t> levels_of(const System& s, const ManifoldSpec& m) {
  std::vector<std::size_t> all = level_parameters(s);
  std::erase_if(all, [&](std::size_t h) {
    const auto has = [h](const Equation& e) { return uses(e.difference, h); };
    return std::ranges::none_of(m.equations, has) && std::ranges::none_of(m.levels, has);
  });
  return all;
}

// All levels at one value.
ManifoldSpec at_level(const System& s, const ManifoldSpec& m, const Rational& value) {
  ManifoldSpec there = m;
  Substitution values;
  for (const std::size_t h : level_parameters(s))
    values[h] = MFraction(s.ring(), value);
  for (auto* list : {&there.equations, &there.levels})
    for (Equation& e : *list)
      e.difference = substitute(e.difference, values);
  return there;
}

// Coordinates and functions that change along the curve, and quotients and products of two of them.
std::vector<MFraction> changes(const System& s, const InvariantManifold& m) {
  std::vector<std::size_t> names = s.field.coordinates;
  for (const FunctionSymbol& f : s.field.functions)
    names.push_back(f.variable);
  std::vector<MFraction> moving, all;
  for (const std::size_t i : names) {
    const MFraction x = MFraction::variable(s.ring(), i);
    if (!m.solved.count(i) && !m.vanishes_on_curve(lie_derivative(s.field, x))) moving.push_back(x);
  }
  all = moving;
  for (const MFraction& x : moving)
    for (const MFraction& y : moving)
      if (!(x == y)) all.push_back(x / y);
  for (std::size_t i = 0; i < moving.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      all.push_back(moving[i] * moving[j]);
  return all;
}

std::optional<RationalCurve> rational_curve(const System& s, const InvariantManifold& m,
                                            const Budget& budget) {
  for (const MFraction& change : changes(s, m)) {
    budget.check();
    auto field = FunctionField::make(s.field, m, s.z, change, {}, budget);
    auto* made = std::get_if<FunctionField>(&field);
    if (made == nullptr || made->degree() != 1) continue;
    RationalCurve curve(s, m, change, std::move(*made));
    if (curve.is_rational()) return curve;
  }
  return std::nullopt;
}

// At one level: the curve, and what was found.
std::optional<QuadratureOrders> study(const System& s, const ManifoldSpec& m, int order,
                                      const Rational& level, const Budget& budget) {
  const auto proved = prove_invariant(s.field, at_level(s, m, level), budget);
  const auto* manifold = std::get_if<InvariantManifold>(&proved);
  if (manifold == nullptr) throw NotApplicable{std::get<ManifoldFailure>(proved).message};
  if (const std::string wrong = contradicted_function(s.field, *manifold); !wrong.empty())
    throw NotApplicable{"the phase curve has no points: " + wrong};
  const auto curve = rational_curve(s, *manifold, budget);
  if (!curve) return std::nullopt;
  EquationsByOrder orders(*curve, budget);
  QuadratureOrders result;
  result.obstruction = orders.obstruction(order);
  if (!result.obstruction) {
    result.open = "no obstruction by quadratures up to VE_" + std::to_string(order);
    return result;
  }
  result.obstruction->variable = curve->change();
  result.obstruction->unchecked = existence_not_checked(s.field, *manifold);
  result.obstruction->integrals =
      excluded_integrals(s, m.name, manifold, IntegralClass::Near::closed_curve, false);
  for (const std::size_t h : levels_of(s, m))
    result.obstruction->level.push_back({s.ring()->name(h), to_string(level)});
  return result;
}

std::optional<QuadratureOrders> at_one_level(const System& s, const ManifoldSpec& m, int order,
                                             const Rational& level, const Budget& budget) {
  try {
    return study(s, m, order, level, budget);
  } catch (const NotApplicable& no) {
    return QuadratureOrders{{}, no.why};
  }
}

bool has_parameters(const System& s) {
  return s.field.parameters.size() > level_parameters(s).size();
}

} // namespace

QuadratureOrders orders_by_quadratures(const System& s, const ManifoldSpec& m, int order,
                                       const Budget& budget) {
  try {
    if (has_parameters(s)) return {};
    if (s.field.poisson && s.kind != SystemKind::hamiltonian)
      return {{}, "quadratures are not for brackets that may be degenerate"};
    QuadratureOrders all{{}, "no coordinate parametrises the curve rationally"};
    for (const Rational& level : {Rational(1), Rational(0), Rational(-1), Rational(1, 2)}) {
      if (auto result = at_one_level(s, m, order, level, budget)) all = *std::move(result);
      if (all.obstruction || levels_of(s, m).empty()) break;
    }
    return all;
  } catch (const InvalidArgument& no) { // constants that generate no field
    return {{}, no.what()};
  } catch (const OutOfBudget& limit) {
    return {{}, limit.what()};
  }
}

std::string reason(const QuadratureObstruction& o) {
  return "VE_" + std::to_string(o.order) +
         " needs the integral of f in K(I), I' = u by z = " + o.variable + " (" + o.of +
         "), and df/dI is not a derivative in K(I): at I^" + std::to_string(o.power) +
         " Hermite's reduction leaves simple poles";
}

} // namespace kov
