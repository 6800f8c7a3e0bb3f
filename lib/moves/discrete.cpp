#include "moves/discrete.hpp"
#include "exact/lists.hpp"
#include "exact/nmod_matrix.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace kov {
namespace {

constexpr std::size_t most_coordinates = 6;

using Exponents = std::vector<unsigned long>;

/// A polynomial in the coordinates over Q; the coefficients as they are.
using Terms = std::map<Exponents, Integer>;

// Unset: it has other variables.
std::optional<Terms> terms_in(const MPoly& f, const std::vector<std::size_t>& variables) {
  Terms all;
  for (long t = 0; t < f.length(); ++t) {
    auto rest = f.exponents(t);
    Exponents e;
    for (const std::size_t i : variables)
      e.push_back(std::exchange(rest[i], 0UL));
    if (std::ranges::any_of(rest, [](unsigned long k) { return k != 0; })) return std::nullopt;
    all[e] = f.coefficient(t);
  }
  return all;
}

/// x_i -> sign[i] x_place[i]
struct SignedPermutation {
  std::vector<std::size_t> place;
  std::vector<int> sign;
};

// Unset: a variable has no place yet.
std::optional<Terms> image(const Terms& f, const SignedPermutation& phi, int sign) {
  Terms all;
  for (const auto& [e, c] : f) {
    Exponents there(e.size(), 0);
    int s = sign;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (e[i] == 0) continue;
      if (i >= phi.place.size()) return std::nullopt;
      there[phi.place[i]] += e[i];
      if (e[i] % 2 != 0) s *= phi.sign[i];
    }
    all[there] = s > 0 ? c : -c;
  }
  return all;
}

/// Automorphisms and anti-automorphisms of a bracket: each entry is compared as soon as its variables have
/// places.
class Automorphisms {
public:
  static std::optional<Automorphisms> of(const VectorField& v) {
    Automorphisms a;
    if (!v.poisson) return std::nullopt;
    for (const auto& row : *v.poisson) {
      a.bracket_.emplace_back();
      for (const MFraction& entry : row) {
        auto terms = is_constant(MFraction(entry.den())) ? terms_in(entry.num(), v.coordinates)
                                                         : std::nullopt;
        if (!terms || !(entry.den() == MPoly(v.ring, Integer(1)))) return std::nullopt;
        a.bracket_.back().push_back(*std::move(terms));
      }
    }
    return a;
  }

  /// `take` is called with each.
  void all(int sign, const std::function<void(const SignedPermutation&)>& take) {
    sign_ = sign;
    SignedPermutation phi;
    extend(phi, take);
  }

private:
  void extend(SignedPermutation& phi, const std::function<void(const SignedPermutation&)>& take) {
    const std::size_t n = bracket_.size(), i = phi.place.size();
    if (i == n) return take(phi);
    for (std::size_t k = 0; k < n; ++k) {
      if (is_among(k, phi.place)) continue;
      for (const int s : {1, -1}) {
        phi.place.push_back(k);
        phi.sign.push_back(s);
        if (fits(phi)) extend(phi, take);
        phi.place.pop_back();
        phi.sign.pop_back();
      }
    }
  }
  [[nodiscard]] bool fits(const SignedPermutation& phi) const {
    const std::size_t n = phi.place.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto right = image(bracket_[i][j], phi, sign_);
        if (!right) continue;
        Terms left = bracket_[phi.place[i]][phi.place[j]];
        if (phi.sign[i] * phi.sign[j] < 0)
          for (auto& [e, c] : left)
            c = -c;
        if (left != *right) return false;
      }
    return true;
  }

  std::vector<std::vector<Terms>> bracket_;
  int sign_ = 1;
};

/// Terms of H in coordinates and parameters: numerator and denominator.
struct Term {
  int side = 0;
  Exponents x, p;
  Integer coefficient;
};

/// sigma for a phi: the permutation by comparing terms without their signs, then the signs.
class Matching {
public:
  Matching(const System& s, std::vector<std::size_t> parameters, const Budget& budget)
      : parameters_(std::move(parameters)), budget_(budget) {
    const MFraction& h = *s.field.hamiltonian;
    for (const int side : {0, 1}) {
      const MPoly& f = side == 0 ? h.num() : h.den();
      for (long t = 0; t < f.length(); ++t) {
        const auto e = f.exponents(t);
        Term term{side, {}, {}, f.coefficient(t)};
        for (const std::size_t i : s.field.coordinates)
          term.x.push_back(e[i]);
        for (const std::size_t i : parameters_)
          term.p.push_back(e[i]);
        terms_.push_back(std::move(term));
      }
    }
  }

  struct Sigma {
    std::vector<std::size_t> to; ///< p_j -> sign[j] p_to[j]
    std::vector<int> sign;
  };
  std::vector<Sigma> of(const SignedPermutation& phi) {
    std::vector<Sigma> all;
    for (const auto& to : permutations(phi.place))
      for (auto& sign : signs(phi, to))
        all.push_back({to, std::move(sign)});
    return all;
  }

private:
  using Key = std::pair<Exponents, Integer>;

  static Exponents moved(const Exponents& x, const std::vector<std::size_t>& place) {
    Exponents there(x.size(), 0);
    for (std::size_t i = 0; i < x.size(); ++i)
      there[place[i]] += x[i];
    return there;
  }

  // Counts the terms by all that no place of the other parameters changes: the exponents of x and of the
  // chosen parameters, the sorted exponents of the others, and the coefficient without its sign.
  [[nodiscard]] std::map<Key, long> projection(const std::vector<std::size_t>* place,
                                               const std::vector<std::size_t>& chosen) const {
    std::map<Key, long> all;
    for (const Term& t : terms_) {
      Exponents key{static_cast<unsigned long>(t.side)};
      const Exponents x = place != nullptr ? moved(t.x, *place) : t.x;
      key.insert(key.end(), x.begin(), x.end());
      Exponents rest = t.p;
      for (const std::size_t j : chosen)
        key.push_back(std::exchange(rest[j], 0UL));
      std::ranges::sort(rest);
      key.insert(key.end(), rest.begin(), rest.end());
      ++all[{key, kov::sign(t.coefficient) < 0 ? -t.coefficient : t.coefficient}];
    }
    return all;
  }

  // H(phi x; p) has the terms of H(x; sigma p): p_j of the right side is p_to[j] of the left one.
  const std::vector<std::vector<std::size_t>>& permutations(const std::vector<std::size_t>& place) {
    const auto [known, is_new] = permutations_.try_emplace(place);
    if (!is_new) return known->second;
    std::vector<std::size_t> to;
    extend(place, to, known->second);
    return known->second;
  }
  void extend(const std::vector<std::size_t>& place, std::vector<std::size_t>& to,
              std::vector<std::vector<std::size_t>>& all) {
    budget_.check();
    std::vector<std::size_t> first(to.size());
    std::iota(first.begin(), first.end(), 0UL);
    if (projection(&place, to) != projection(nullptr, first)) return;
    if (to.size() == parameters_.size()) return all.push_back(to);
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      if (is_among(k, to)) continue;
      to.push_back(k);
      extend(place, to, all);
      to.pop_back();
    }
  }

  // Equations over the field of two elements: each term keeps its sign, up to one for numerator and
  // denominator together.
  [[nodiscard]] std::vector<std::vector<int>> signs(const SignedPermutation& phi,
                                                    const std::vector<std::size_t>& to) const {
    const std::size_t n = parameters_.size();
    std::vector<std::vector<mp_limb_t>>
        rows; // columns: signs of p_0 ..., of both sides, right hand
    std::map<std::pair<int, Exponents>, mp_limb_t> negative;
    for (const Term& t : terms_)
      negative[{t.side, joined(t.x, t.p)}] = kov::sign(t.coefficient) < 0 ? 1 : 0;
    for (const Term& t : terms_) { // a term of H(x; sigma p), and the one of H(phi x; p) that it is
      Exponents p(n, 0);
      std::vector<mp_limb_t> row(n + 2, 0);
      for (std::size_t j = 0; j < n; ++j) {
        p[to[j]] = t.p[j];
        row[j] = t.p[j] % 2;
      }
      row[n] = 1;
      // phi x has the exponents x: which term of H has them before
      Exponents x(t.x.size(), 0);
      mp_limb_t sign_of_x = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = t.x[phi.place[i]];
        if (x[i] % 2 != 0 && phi.sign[i] < 0) sign_of_x ^= 1;
      }
      const auto source = negative.find({t.side, joined(x, p)});
      if (source == negative.end()) return {};
      row[n + 1] = sign_of_x ^ source->second ^ negative.at({t.side, joined(t.x, t.p)});
      rows.push_back(std::move(row));
    }
    return solutions(rows, n);
  }
  static Exponents joined(Exponents a, const Exponents& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
  static std::vector<std::vector<int>> solutions(const std::vector<std::vector<mp_limb_t>>& rows,
                                                 std::size_t n) {
    NmodMatrix m(rows.size(), n + 2, 2);
    static_cast<void>(
        m.fill([&](std::size_t i, std::size_t j) { return std::optional(rows[i][j]); }));
    const std::vector<std::size_t> pivots = m.row_reduce();
    if (is_among(n + 1, pivots)) return {};
    std::vector<std::size_t> free;
    for (std::size_t c = 0; c <= n; ++c)
      if (!is_among(c, pivots)) free.push_back(c);
    std::set<std::vector<int>> all; // the common sign of both sides says nothing
    for (std::size_t choice = 0; choice < (std::size_t{1} << free.size()); ++choice) {
      std::vector<mp_limb_t> bits(n + 1, 0);
      for (std::size_t k = 0; k < free.size(); ++k)
        bits[free[k]] = choice >> k & 1U;
      for (std::size_t i = 0; i < pivots.size(); ++i) {
        mp_limb_t value = m(i, n + 1);
        for (const std::size_t c : free)
          value ^= m(i, c) & bits[c];
        bits[pivots[i]] = value;
      }
      std::vector<int> sign(n);
      for (std::size_t j = 0; j < n; ++j)
        sign[j] = bits[j] != 0 ? -1 : 1;
      all.insert(std::move(sign));
    }
    return {all.begin(), all.end()};
  }

  std::vector<std::size_t> parameters_;
  const Budget& budget_;
  std::vector<Term> terms_;
  std::map<std::vector<std::size_t>, std::vector<std::vector<std::size_t>>> permutations_;
};

// Checks the symmetry by exact substitution, and not by the search.
bool is_symmetry(const System& s, const FamilySymmetry& y) {
  const VectorField& v = s.field;
  Substitution phi;
  for (std::size_t i = 0; i < v.dimension(); ++i)
    phi[v.coordinates[i]] =
        Rational(y.sign[i]) * MFraction::variable(v.ring, v.coordinates[y.place[i]]);
  if (!(substitute(*v.hamiltonian, phi) == substitute(*v.hamiltonian, y.parameters))) return false;
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const MFraction left = Rational(y.sign[i] * y.sign[j]) * (*v.poisson)[y.place[i]][y.place[j]];
      if (!is_zero(left - Rational(y.bracket) * substitute((*v.poisson)[i][j], phi))) return false;
    }
  return true;
}

} // namespace

// H(Phi x; sigma p) = H(x; p) for Phi = phi^-1: x_place[i] -> sign[i] x_i.
Equivalence equivalence(const System& s, const FamilySymmetry& y) {
  Equivalence e;
  e.ring = s.ring();
  e.phase.resize(y.place.size());
  for (std::size_t i = 0; i < y.place.size(); ++i)
    e.phase[y.place[i]] =
        Rational(y.sign[i]) * MFraction::variable(s.ring(), s.field.coordinates[i]);
  e.parameters = y.parameters;
  e.time = e.bracket = MFraction(s.ring(), Rational(y.bracket));
  return e;
}

std::vector<FamilySymmetry> family_symmetries(const System& s, const Budget& budget) {
  const VectorField& v = s.field;
  if (!v.hamiltonian || !v.functions.empty() || !v.relations.empty() || !v.constants.empty() ||
      v.dimension() > most_coordinates)
    return {};
  auto automorphisms = Automorphisms::of(v);
  if (!automorphisms) return {};
  std::vector<std::size_t> parameters;
  for (const std::size_t p : v.parameters)
    if (uses(*v.hamiltonian, p)) parameters.push_back(p);
  Matching matching(s, parameters, budget);
  std::vector<FamilySymmetry> all;
  for (const int bracket : {1, -1})
    automorphisms->all(bracket, [&](const SignedPermutation& phi) {
      for (const auto& sigma : matching.of(phi)) {
        FamilySymmetry y{phi.place, phi.sign, bracket, {}};
        for (std::size_t j = 0; j < parameters.size(); ++j)
          if (sigma.to[j] != j || sigma.sign[j] < 0)
            y.parameters[parameters[j]] =
                Rational(sigma.sign[j]) * MFraction::variable(s.ring(), parameters[sigma.to[j]]);
        if (is_symmetry(s, y)) all.push_back(std::move(y));
      }
    });
  return all;
}

bool keeps_assumptions(const System& s, const FamilySymmetry& symmetry) {
  for (const auto& [p, value] : symmetry.parameters)
    if (s.real.contains(s.ring()->name(p)) !=
        s.real.contains(s.ring()->name(used_variables(value).front())))
      return false;
  const auto is_said_of = [](const Assumption& a, const MFraction& f) {
    if (is_zero(a.value) || is_zero(f)) return is_zero(a.value) && is_zero(f);
    const MFraction ratio = a.value / f;
    if (!is_constant(ratio)) return false;
    const Rational c = to_rational(ratio);
    if (a.is_ordered()) return sign(c) > 0;
    return !(a.is(Sort::rational) || a.is(Sort::integer)) || abs(c) == Rational(1);
  };
  return std::ranges::all_of(s.assumptions, [&](const Assumption& moved) {
    const MFraction f = substitute(moved.value, symmetry.parameters);
    return std::ranges::any_of(
        s.assumptions, [&](const Assumption& a) { return a.is(moved.says) && is_said_of(a, f); });
  });
}

} // namespace kov
