#include "moves/equivalence.hpp"

#include "exact/error.hpp"
#include "exact/linear.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

/// u + r v
struct EvenAndOdd {
  MFraction even, odd;
};

// A polynomial in r with r^2 = square.
std::pair<MPoly, MPoly> halves(const Equivalence& e, const MPoly& f) {
  MPoly even(e.ring), odd(e.ring), power(e.ring, Integer(1));
  const MPoly square = transfer(MFraction(e.square), e.ring).num();
  const auto all = coefficients(f, *e.root);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k > 0 && k % 2 == 0) power = power * square;
    MPoly& side = k % 2 == 0 ? even : odd;
    side = side + all[k] * power;
  }
  return {even, odd};
}

EvenAndOdd halves(const Equivalence& e, const MFraction& f) {
  if (!e.root) return {f, MFraction(e.ring)};
  const auto [a, b] = halves(e, f.num());
  const auto [c, d] = halves(e, f.den());
  // (a + r b)/(c + r d) = (a + r b)(c - r d)/(c^2 - r^2 d^2)
  const MPoly square = transfer(MFraction(e.square), e.ring).num();
  const MFraction norm(c * c - square * d * d);
  return {MFraction(a * c - square * b * d) / norm, MFraction(b * c - a * d) / norm};
}

bool vanishes(const Equivalence& e, const MFraction& f) {
  if (is_zero(f)) return true;
  const EvenAndOdd h = halves(e, f);
  return is_zero(h.even) && is_zero(h.odd);
}

MFraction moved(const Equivalence& e, const MFraction& f, const Substitution& values) {
  return substitute(transfer(f, e.ring), values);
}

Substitution all_values(const System& s, const Equivalence& e) {
  Substitution values = e.parameters;
  for (std::size_t i = 0; i < s.field.dimension(); ++i)
    values[s.field.coordinates[i]] = e.phase[i];
  return values;
}

struct ModuloRoot : FieldArithmetic<MFraction> {
  const Equivalence& e;
  explicit ModuloRoot(const Equivalence& of) : e(of) {}
  [[nodiscard]] bool is_unit(const MFraction& x) const { return !vanishes(e, x); }
};

bool is_invertible(const System& s, const Equivalence& e) {
  const std::size_t n = s.field.dimension();
  Matrix rows(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      rows[i].push_back(derivative(e.phase[i], s.field.coordinates[j]));
  for (std::size_t c = 0; c < n; ++c) {
    if (!bring_pivot(rows, c, c, ModuloRoot{e})) return false;
    clear_column(rows, c, c, ModuloRoot{e}, c + 1);
  }
  return true;
}

std::optional<Statement> pulled_back(const Equivalence& e, Statement c) {
  for (MFraction& square : squares_of(c.says)) {
    auto here = kov::pulled_back(e, square);
    if (!here) return std::nullopt;
    square = *std::move(here);
  }
  return c;
}

bool is_of_parameters(const System& s, const MPoly& f) { return !uses_any(f, s.field.coordinates); }

// An integral as it is, or times r; and times what makes it a polynomial.
std::optional<FoundIntegral> pulled_back(const System& s, const Equivalence& e,
                                         const FoundIntegral& f) {
  const Substitution values = all_values(s, e);
  FoundIntegral g = f;
  const EvenAndOdd h = halves(e, moved(e, f.value, values));
  if (!is_zero(h.even) && !is_zero(h.odd)) return std::nullopt;
  g.value = transfer(is_zero(h.odd) ? h.even : h.odd, s.ring());
  if (e.root && is_of_parameters(s, g.value.den())) g.value *= MFraction(g.value.den());
  if (e.root && !f.logarithms.empty()) return std::nullopt;
  for (LogarithmicTerm& t : g.logarithms) {
    const MFraction of = moved(e, MFraction(t.of), values);
    if (!is_constant(MFraction(of.den()))) return std::nullopt;
    t = {transfer(moved(e, t.times, values), s.ring()), transfer(of, s.ring()).num()};
  }
  return g;
}

// The invariant set at the parameters before.  Unset: r occurs, and the file has no name for it.
std::optional<ManifoldSpec> pulled_back(const System& s, const Equivalence& e, ManifoldSpec m) {
  if (e.root) return std::nullopt;
  const Substitution values = all_values(s, e);
  for (auto* equations : {&m.equations, &m.levels})
    for (Equation& one : *equations) {
      one.difference = transfer(moved(e, one.difference, values), s.ring());
      one.text = to_string(one.difference) + " = 0";
    }
  for (MPoly& f : m.nonzero)
    f = transfer(moved(e, MFraction(f), values), s.ring()).num();
  m.name += ", moved by " + in_words(e);
  return m;
}

std::string with_words(const std::string& text, const Equivalence& e) {
  return text.empty() ? text : text + ", moved by " + in_words(e);
}

} // namespace

// A rotation makes one of two parameters 0, the other one the root.
std::string in_words(const Equivalence& e) {
  std::string text, zero, root;
  for (const auto& [p, value] : e.parameters) {
    const std::string& name = e.ring->name(p);
    text += (text.empty() ? "" : ", ") + name + " -> " + to_string(value);
    if (is_zero(value)) zero = name + " = 0";
    if (e.root && value == MFraction::variable(e.ring, *e.root))
      root = name + " = sqrt(" + to_string(e.square) + ")";
  }
  return e.root ? "a rotation to " + zero + ", " + root : text;
}

bool holds(const System& s, const Equivalence& e) {
  const VectorField& v = s.field;
  const std::size_t n = v.dimension();
  if (e.phase.size() != n || is_zero(e.time) || is_zero(e.bracket)) return false;
  const Substitution values = all_values(s, e);
  const auto at_p = [&](const MFraction& f) { return transfer(f, e.ring); };
  for (std::size_t i = 0; i < n; ++i) {
    MFraction left(e.ring);
    for (std::size_t j = 0; j < n; ++j)
      left += derivative(e.phase[i], v.coordinates[j]) * at_p(v.components[j]);
    if (!vanishes(e, left - e.time * moved(e, v.components[i], values))) return false;
  }
  for (std::size_t i = 0; v.poisson && i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      MFraction left(e.ring);
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = 0; l < n; ++l)
          if (const MFraction& entry = (*v.poisson)[k][l]; !is_zero(entry))
            left += derivative(e.phase[i], v.coordinates[k]) *
                    derivative(e.phase[j], v.coordinates[l]) * at_p(entry);
      if (!vanishes(e, left - e.bracket * moved(e, (*v.poisson)[i][j], values))) return false;
    }
  return is_invertible(s, e);
}

std::optional<MPoly> pulled_back(const Equivalence& e, const MPoly& f) {
  const EvenAndOdd h = halves(e, moved(e, MFraction(f), e.parameters));
  if (!is_zero(h.even) && !is_zero(h.odd)) return std::nullopt;
  return transfer(is_zero(h.odd) ? h.even : h.odd, f.ring()).num();
}

MPoly pulled_back_for_some_sign(const Equivalence& e, const MPoly& f) {
  const EvenAndOdd h = halves(e, moved(e, MFraction(f), e.parameters));
  const MFraction square = transfer(MFraction(e.square), e.ring);
  return transfer(h.even * h.even - square * h.odd * h.odd, f.ring()).num();
}

std::optional<MFraction> pulled_back(const Equivalence& e, const MFraction& f) {
  const EvenAndOdd h = halves(e, moved(e, f, e.parameters));
  if (!is_zero(h.odd)) return std::nullopt;
  return transfer(h.even, f.ring());
}

namespace {

MapFacts facts(const System& s, const Equivalence& e) {
  MapFacts map{e.real};
  for (std::size_t i = 0; i < e.phase.size(); ++i) {
    std::vector<std::string>& used = map.uses[s.field.name(i)];
    for (std::size_t j = 0; j < s.field.dimension(); ++j)
      if (uses(e.phase[i], s.field.coordinates[j])) used.push_back(s.field.name(j));
  }
  return map;
}

} // namespace

std::optional<Preimage> carried(const System& s, const Equivalence& e, const ClassifiedStratum& x) {
  if (!x.constants.empty() || !x.fields.empty()) return std::nullopt; // known as text only
  Preimage c{{}, x};
  for (ExclusionReason& by : c.stratum.by) {
    auto integrals = carried(by.integrals, facts(s, e));
    if (!integrals) return std::nullopt;
    by.integrals = *std::move(integrals);
  }
  if (e.root) c.not_all_zero.push_back({e.square});
  try {
    bool sign_is_chosen = false;
    for (const MPoly& f : x.where.equations()) {
      auto here = pulled_back(e, f);
      if (!here) { // of r and -r the one serves for which it holds
        if (std::exchange(sign_is_chosen, true)) return std::nullopt;
        here = pulled_back_for_some_sign(e, f);
      }
      if (!is_zero(*here)) c.zero.push_back(*std::move(here));
    }
    for (const MPoly& f : x.where.inequations()) {
      const auto here = pulled_back(e, f);
      c.not_all_zero.push_back(
          {here ? *here : pulled_back_for_some_sign(e, f)}); // not 0 for both signs
    }
    for (const Statement& one : x.where.statements()) {
      auto here = pulled_back(e, one);
      if (!here) return std::nullopt;
      c.statements.push_back(*std::move(here));
    }
    c.stratum.integrals.clear();
    for (const FoundIntegral& f : x.integrals) {
      auto here = pulled_back(s, e, f);
      if (!here) return std::nullopt;
      c.stratum.integrals.push_back(*std::move(here));
    }
  } catch (const DomainError&) { // something has no value there
    return std::nullopt;
  }
  if (x.along) c.stratum.along = pulled_back(s, e, *x.along);
  c.stratum.from.reset(); // it is about the other parameters
  c.stratum.change.reset();
  for (ExclusionReason& by : c.stratum.by) {
    by.carried = true;
    by.solution = with_words(by.solution, e);
    for (std::string& curve : by.integrals.curves)
      curve = with_words(curve, e);
  }
  return c;
}

} // namespace kov
