#include "manifold/directions.hpp"

#include "exact/error.hpp"
#include "exact/variables.hpp"
#include "manifold/zeros.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_degrees_of_freedom = 6;
constexpr std::size_t most_directions = 6;

bool is_positive(const MPoly& number) {
  return is_constant(number) && sign(to_rational(MFraction(number))) > 0;
}

/// q' = A p, p' = f(q), A constant.
struct SecondOrder {
  std::vector<std::size_t> q, p;
  std::vector<MFraction> acceleration; ///< A f
};

std::optional<SecondOrder> second_order(const VectorField& v) {
  const std::size_t n = v.dimension() / 2;
  if (v.dimension() != 2 * n || n > most_degrees_of_freedom) return std::nullopt;
  SecondOrder s{{v.coordinates.begin(), v.coordinates.begin() + static_cast<long>(n)},
                {v.coordinates.begin() + static_cast<long>(n), v.coordinates.end()},
                {}};
  std::vector<std::size_t> main = s.q;
  for (const FunctionSymbol& f : v.functions)
    main.push_back(f.variable);
  auto all = main;
  all.insert(all.end(), s.p.begin(), s.p.end());
  for (std::size_t i = 0; i < n; ++i) {
    if (uses_any(v.components[n + i], s.p)) return std::nullopt;
    MFraction a(v.ring), rest = v.components[i];
    for (std::size_t j = 0; j < n; ++j) {
      const MFraction slope = derivative(v.components[i], s.p[j]);
      if (uses_any(slope, all)) return std::nullopt;
      a += slope * v.components[n + j];
      rest = rest - slope * MFraction::variable(v.ring, s.p[j]);
    }
    if (!is_zero(rest)) return std::nullopt;
    s.acceleration.push_back(std::move(a));
  }
  return s;
}

/// The directions with d_k = 0 for k < chart and d_chart = 1.
class Chart {
public:
  Chart(const VectorField& v, const SecondOrder& s, std::size_t chart) : v_(v), s_(s), c_(chart) {
    auto names = v.ring->names();
    names.emplace_back("place on the line");
    for (std::size_t i = 0; i < s.q.size() + v.functions.size(); ++i)
      names.push_back("direction " + std::to_string(i));
    ring_ = make_ring(names);
  }

  void find(const std::vector<MFraction>& integrals, const Budget& budget, Directions& all) const {
    const Substitution line = on_line(fixed_by(integrals));
    std::vector<MPoly> equations;
    try {
      for (const MPoly& r : v_.relations)
        add_coefficients(substitute(transfer(MFraction(r), ring_), line), equations);
      const MFraction along = substitute(transfer(s_.acceleration[c_], ring_), line);
      for (std::size_t i = 0; i < s_.q.size(); ++i)
        add_coefficients(substitute(transfer(s_.acceleration[i], ring_), line) -
                             line.at(s_.q[i]) / place() * along,
                         equations);
    } catch (const DomainError&) { // a pole on all of these lines
      return;
    }
    std::vector<std::size_t> unknowns;
    for (const auto& [i, value] : line)
      for (const std::size_t u : used_variables(value))
        if (u > first()) unknowns.push_back(u);
    auto constants = quadratic_constants(v_);
    for (QuadraticConstant& c : constants)
      c.relation = transfer(MFraction(c.relation), ring_).num();
    ZeroSearch search(ring_, unknowns, std::move(constants), budget);
    for (const MPoly& den : denominators(v_)) // there is no solution at a pole
      for (const MFactor& f : factor(den).second)
        search.nonzero.push_back(substitute(substitute(transfer(MFraction(f.base), ring_), line),
                                            {{first(), MFraction(ring_, Rational(1))}})
                                     .num());
    search.run(equations, 0);
    // q -> -q with the same roots moves s rho to -s rho
    std::erase_if(search.zeros, [&](const Substitution& zero) {
      return !v_.functions.empty() && is_negative(line, zero, 0);
    });
    std::ranges::stable_sort(search.zeros, [&](const auto& a, const auto& b) {
      return negative_roots(line, a) < negative_roots(line, b);
    });
    for (const Substitution& zero : search.zeros)
      if (all.lines.size() < most_directions) add_line(line, zero, all);
    for (const MPoly& d : search.wanted)
      all.wanted.push_back(transfer(MFraction(d), v_.ring).num());
  }

private:
  [[nodiscard]] std::size_t first() const { return v_.ring->size(); }
  [[nodiscard]] MFraction place() const { return MFraction::variable(ring_, first()); }
  [[nodiscard]] MFraction direction(std::size_t i) const {
    return MFraction::variable(ring_, first() + 1 + i);
  }

  // The flow of sum p_j (L q)_j moves d by L d: the component j is 0 where (L d)_j may be anything.
  [[nodiscard]] std::vector<bool> fixed_by(const std::vector<MFraction>& integrals) const {
    std::vector<bool> fixed(s_.q.size(), false);
    for (const MFraction& f : integrals)
      for (std::size_t j = c_ + 1; j < s_.q.size(); ++j) {
        const MFraction slope = derivative(derivative(f, s_.p[j]), s_.q[c_]);
        if (is_zero(slope) || uses_any(slope, s_.q) || uses_any(slope, s_.p) || fixed[j]) continue;
        fixed[j] = true;
        break;
      }
    return fixed;
  }

  // q = s d, r = s rho.
  [[nodiscard]] Substitution on_line(const std::vector<bool>& fixed) const {
    Substitution line;
    for (std::size_t i = 0; i < s_.q.size(); ++i)
      line[s_.q[i]] = i < c_ || fixed[i] ? MFraction(ring_)
                      : i == c_          ? place()
                                         : place() * direction(i);
    for (std::size_t k = 0; k < v_.functions.size(); ++k)
      line[v_.functions[k].variable] = place() * direction(s_.q.size() + k);
    return line;
  }

  void add_coefficients(const MFraction& f, std::vector<MPoly>& all) const {
    for (MPoly& c : coefficients(f.num(), first()))
      if (!is_zero(c)) all.push_back(std::move(c));
  }

  [[nodiscard]] bool is_negative(const Substitution& line, const Substitution& zero,
                                 std::size_t k) const {
    const MFraction rho = substitute(line.at(v_.functions[k].variable) / place(), zero);
    return is_constant(rho) && !is_zero(rho) && sign(to_rational(rho)) < 0;
  }
  [[nodiscard]] std::size_t negative_roots(const Substitution& line,
                                           const Substitution& zero) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < v_.functions.size(); ++k)
      count += is_negative(line, zero, k) ? 1 : 0;
    return count;
  }

  // The velocities take the place of the momenta: then the variations of the equations are y' = y~, and
  // those of the velocities, y~' = F y.
  void add_line(const Substitution& line, const Substitution& zero, Directions& all) const {
    std::vector<Equation> positions, velocities, roots;
    const auto ratio = [&](std::size_t i) {
      return transfer(substitute(line.at(i) / place(), zero), v_.ring);
    };
    const MFraction q = MFraction::variable(v_.ring, s_.q[c_]);
    try {
      for (std::size_t i = 0; i < s_.q.size(); ++i) {
        if (i == c_) continue;
        const MFraction d = ratio(s_.q[i]);
        const std::string multiple = is_one(d) ? "" : in_product(d);
        positions.push_back(equation(s_.q[i], d * q));
        velocities.push_back(
            {v_.components[i] - d * v_.components[c_],
             v_.name(i) + "' = " + (is_zero(d) ? "0" : multiple + v_.name(c_) + "'")});
      }
      for (const FunctionSymbol& f : v_.functions)
        roots.push_back(equation(f.variable, ratio(f.variable) * q));
    } catch (const DomainError&) { // infinite there
      return;
    }
    for (const auto* part : {&velocities, &roots})
      positions.insert(positions.end(), part->begin(), part->end());
    all.lines.push_back(std::move(positions));
  }
  static std::string in_product(const MFraction& d) {
    const std::string text = to_string(d);
    return (text.find_first_of("+- /") == std::string::npos ? text : "(" + text + ")") + "*";
  }
  [[nodiscard]] Equation equation(std::size_t i, const MFraction& value) const {
    return {MFraction::variable(v_.ring, i) - value, v_.ring->name(i) + " = " + to_string(value)};
  }

  const VectorField& v_;
  const SecondOrder& s_;
  std::size_t c_;
  Ring ring_;
};

} // namespace

Directions find_directions(const VectorField& v, const std::vector<MFraction>& integrals,
                           const Budget& budget) {
  Directions all;
  const auto s = second_order(v);
  if (!s) return all;
  for (std::size_t c = 0; c < s->q.size(); ++c)
    Chart(v, *s, c).find(integrals, budget, all);
  std::ranges::stable_sort(all.wanted, [](const MPoly& a, const MPoly& b) {
    if (!is_positive(a) || !is_positive(b)) return is_positive(a) > is_positive(b); // real first
    return to_rational(MFraction(a)) < to_rational(MFraction(b));
  });
  all.wanted.erase(std::unique(all.wanted.begin(), all.wanted.end()), all.wanted.end());
  return all;
}

} // namespace kov
