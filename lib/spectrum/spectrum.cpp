#include "spectrum/spectrum.hpp"

#include "exact/error.hpp"
#include "exact/ideal.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "parameters/integers.hpp"
#include "spectrum/solve_for_energy.hpp"

#include <algorithm>

namespace kov::spectrum {
namespace {

using strata::ExponentialFamily;
using strata::GroupBound;
using strata::Leaf;
using strata::Part;
using strata::PolynomialPart;
using strata::Question;
using strata::Scheme;
using strata::Stratum;

// Is there a Liouvillian solution?  unknown also where that depends on whether it is reducible.
Truth has_solution(const std::optional<GaloisGroup>& group, GroupBound bound) {
  if (group) return truth(group->type != GroupType::SL2);
  switch (bound) {
  case GroupBound::unknown:
  case GroupBound::SL2_or_Borel:
    return Truth::unknown;
  default:
    return Truth::yes;
  }
}

// The polynomials known not to vanish, in the parameters that the equations of the stratum leave free.
ParametrisedSet region_of(const Question& q, const Stratum& s) {
  const auto is_free = [&](const MPoly& p) {
    const auto used = used_variables(p);
    return std::ranges::none_of(used, [&](std::size_t i) { return s.solved.contains(i); });
  };
  Assumptions all = q.assumptions;
  std::erase_if(all.conditions,
                [&](const Condition& c) { return c.sign == certify::Sign::zero || !is_free(c.p); });
  all.memberships.clear();
  ParametrisedSet region(q.r.ring(), all);
  for (const Condition& c : s.conditions)
    if (c.sign == certify::Sign::nonzero && is_free(c.p))
      for (const MPoly& p : irreducible_parts(c.p))
        region = region.where_nonzero(p);
  return region;
}

// false: the conditions contradict the values that are put in.
bool admits(const std::vector<Condition>& conditions, const Substitution& put) {
  return std::ranges::all_of(conditions, [&](const Condition& c) {
    const MFraction value = substitute(c.p, put);
    return !is_constant(value) || certify::allows(c.sign, sign(to_rational(value)));
  });
}

// false: a value that is put in is an integer where none is assumed, or no integer where one is.
bool admits(const std::vector<Membership>& memberships, const Substitution& put) {
  return std::ranges::none_of(memberships, [&](const Membership& m) {
    return violated(m, substitute(m.value, put)).has_value();
  });
}

bool admits(const Assumptions& all, const Substitution& put) {
  return admits(all.conditions, put) && admits(all.memberships, put);
}

// p, irreducible and in one parameter alone, has no root there that is (or is not) an integer as
// assumed: its root is rational and another number, or all are irrational.
bool has_no_admissible_root(const MPoly& p, const std::vector<Membership>& memberships) {
  const auto used = used_variables(p);
  if (used.size() != 1) return false;
  const auto c = coefficients(p, used[0]);
  if (c.size() == 2) {
    try {
      return !admits(memberships, {{used[0], -MFraction(c[0]) / MFraction(c[1])}});
    } catch (const DomainError&) { // what is assumed has no value there
      return true;
    }
  }
  return std::ranges::any_of(memberships, [&](const Membership& m) {
    return m.in_integers && used_variables(m.value) == used && is_constant(m.value.den()) &&
           degree(m.value.num(), used[0]) == 1;
  });
}

bool has_equation(const Assumptions& all) {
  return std::ranges::any_of(all.conditions,
                             [](const Condition& c) { return c.sign == certify::Sign::zero; });
}

// The irreducible factors of the conditions "p != 0", with the values put in.
std::vector<MPoly> nonzero_factors(const std::vector<Condition>& conditions,
                                   const Substitution& put) {
  std::vector<MPoly> all;
  for (const Condition& c : conditions) {
    if (!certify::excludes_zero(c.sign)) continue;
    const MFraction value = substitute(c.p, put);
    if (is_constant(value)) continue;
    std::ranges::copy(irreducible_parts(value.num()), std::back_inserter(all));
  }
  return all;
}

// The equations without what is known not to be 0, each factor once; unset: they contradict.
std::optional<std::vector<MPoly>> simplified(const std::vector<MPoly>& equations,
                                             const std::vector<MPoly>& nonzero,
                                             const std::vector<Membership>& memberships,
                                             const Budget& budget) {
  std::vector<MPoly> out;
  for (const MPoly& f : equations) {
    MPoly product(f.ring(), Integer(1));
    for (const MPoly& p : irreducible_parts(f))
      if (std::ranges::none_of(nonzero, [&](const MPoly& q) { return p == q || p == -q; }) &&
          !has_no_admissible_root(p, memberships))
        product *= p;
    if (is_constant(product)) return std::nullopt;
    out.push_back(product);
  }
  if (out.size() < 2) return out;
  MPoly common = out.front();
  for (const MPoly& f : out)
    common = gcd(common, f);
  const Ideal ideal(common.ring(), used_by_any(out), out, nonzero, budget);
  if (ideal.is_unit()) return std::nullopt;
  if (!is_constant(common) && ideal.contains(common)) return std::vector<MPoly>{common};
  return out;
}

// Might the local monodromy exchange two lines there?  docs/theory/spectrum.md, 2
bool may_exchange(const strata::ParametricPlace& p) {
  if (p.kind == PlaceKind::ramified) return true;
  if (p.kind != PlaceKind::regular) return false;
  return p.exponent != strata::ExponentKind::rational ||
         (is_integer(Rational(2) * p.delta) && !is_integer(p.delta));
}

// The group contains a torus and is not dihedral: too few places could exchange its two lines.
bool is_not_dihedral(const Scheme& s) {
  bool irregular = false;
  long exchanges = 0;
  for (std::size_t i = 0; i < number_of_places(s); ++i) {
    const auto& p = place_at(s, i);
    irregular = irregular || p.kind == PlaceKind::irregular;
    if (may_exchange(p)) exchanges += p.degree(s.z);
  }
  return irregular && exchanges < 2;
}

// A Liouvillian solution is there exactly if an exponential one is: no identity component is abelian,
// so that each group is SL(2, C) or all triangular matrices; or no group is finite or dihedral.
bool is_exponential_or_none(const Leaf& leaf) {
  if (leaf.scheme && is_not_dihedral(*leaf.scheme)) return true;
  if (leaf.parts.empty()) return leaf.abelian == Truth::no;
  return std::ranges::all_of(leaf.parts, [](const Part& p) { return p.abelian == Truth::no; });
}

Eigenfunction function_of(const PolynomialPart& part, const ExponentialFamily& f) {
  return {part.p, f.powers, f.exponent};
}

std::optional<Eigenfunction> smallest(const Scheme& s, const ParametrisedSet& region, long levels,
                                      const Budget& budget) {
  const strata::ExponentialFamilies families = families_of_exponents(s, budget);
  for (long d = 0; d <= 4 * (levels + 1); ++d)
    for (const ExponentialFamily& f : families.all) {
      if (!is_constant(f.degree) || to_rational(f.degree) != Rational(d)) continue;
      const PolynomialPart part = polynomial_part(s, f, d, region, budget);
      if (part.open.empty() && part.conditions.empty()) return function_of(part, f);
    }
  return std::nullopt;
}

// The eigenfunction of the smallest degree that is a number.
std::optional<Eigenfunction> eigenfunction(const Question& q, const Stratum& s,
                                           const Substitution& energy, long levels,
                                           const Budget& budget) {
  try {
    const MFraction r = substitute(substitute(q.r, s.solved), energy);
    if (is_zero(r)) return std::nullopt;
    ParametrisedSet region(q.r.ring(), {});
    auto places = strata::scheme(r, q.z, region, budget);
    while (const auto* needs = std::get_if<strata::Needs>(&places)) {
      region = region.where_nonzero(needs->p);
      places = strata::scheme(r, q.z, region, budget);
    }
    return smallest(std::get<Scheme>(places), region, levels, budget);
  } catch (const DomainError&) { // this N is not a level
    return std::nullopt;
  }
}

// A variable other than E, if there is one, with a constant coefficient.
std::optional<std::pair<std::size_t, MFraction>> solved_linearly(const MFraction& condition,
                                                                 std::size_t energy) {
  std::vector<std::size_t> order = used_variables(condition.num());
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return i != energy; });
  for (const std::size_t i : order) {
    const auto c = coefficients(condition.num(), i);
    if (c.size() == 2 && is_constant(c[1])) return std::pair(i, -MFraction(c[0]) / MFraction(c[1]));
  }
  return std::nullopt;
}

std::vector<Condition> all_conditions(const Question& q, const Stratum& stratum) {
  std::vector<Condition> all = stratum.conditions;
  all.insert(all.end(), q.assumptions.conditions.begin(), q.assumptions.conditions.end());
  return all;
}

// The polynomials that are not 0 on the stratum, with the values put in.
ParametrisedSet known(const Question& q, const Stratum& stratum, const Substitution& put) {
  ParametrisedSet region(q.r.ring(), {});
  for (const MPoly& p : nonzero_factors(all_conditions(q, stratum), put))
    region = region.where_nonzero(p);
  return region;
}

// The family with the values put in.
ExponentialFamily at(ExponentialFamily f, const Substitution& put) {
  f.omega = substitute(f.omega, put);
  f.exponent = substitute(f.exponent, put);
  for (auto& [base, power] : f.powers) {
    base = substitute(base, put).num();
    power = substitute(power, put);
  }
  return f;
}

class SpectrumStudy {
public:
  SpectrumStudy(const Question& q, std::size_t energy, const SpectrumOptions& options)
      : q_(q), energy_(energy), options_(options), budget_(options.strata.decide.budget) {}

  Piece piece(const Stratum& s) {
    Piece p;
    p.conditions = s.conditions;
    try {
      study(s, p);
    } catch (const OutOfBudget& limit) {
      p.status = Piece::Status::open;
      p.why_open = Piece::Open::limit;
      p.ended = limit.what();
    }
    return p;
  }

private:
  void study(const Stratum& s, Piece& p) {
    if (s.leaf.no_equation()) {
      p.status = Piece::Status::no_equation;
      return;
    }
    if (!s.leaf.parts.empty()) {
      by_parts(s, p);
      if (p.status == Piece::Status::open && is_exponential_or_none(s.leaf)) by_degrees(s, p);
      return;
    }
    if (s.leaf.group) p.groups = {*s.leaf.group};
    const Truth answer = has_solution(s.leaf.group, s.leaf.bound);
    if (answer != Truth::unknown)
      p.status = answer == Truth::yes ? Piece::Status::all : Piece::Status::none;
    else if (is_exponential_or_none(s.leaf))
      by_degrees(s, p);
    else
      p.why_open = Piece::Open::group;
  }

  // The parts cover the stratum: solutions are there outside those with SL(2, C).
  void by_parts(const Stratum& s, Piece& p) {
    const Part* without = nullptr;
    for (const Part& part : s.leaf.parts) {
      const Truth answer = has_solution(part.group, part.bound);
      if (answer == Truth::unknown) {
        p.why_open = Piece::Open::group_of_a_part;
        return;
      }
      if (answer == Truth::yes && part.group) p.groups.push_back(*part.group);
      if (answer == Truth::no && without != nullptr) {
        p.why_open = Piece::Open::several_without;
        return;
      }
      if (answer == Truth::no) without = &part;
    }
    p.status = without == nullptr ? Piece::Status::all : Piece::Status::conditions;
    if (without == nullptr) return;
    for (Statement c : without->where) {
      c.holds = !c.holds;
      p.where.push_back(c);
      const auto* sum = c.holds ? std::get_if<SumIn>(&c.says) : nullptr;
      auto solved = sum != nullptr ? solve_for_energy(*sum, energy_) : std::vector<Series>{};
      if (solved.empty()) p.unsolved.push_back(c);
      for (Series& x : solved) {
        if (x.value) x.first = first_levels(s, x);
        p.series.push_back(std::move(x));
      }
    }
  }

  // The eigenfunctions for N = 0, 1, ..., where E is a function of the parameters alone.
  std::vector<Level> first_levels(const Stratum& s, const Series& series) {
    std::vector<Level> out;
    for (long n = 0; n < options_.levels; ++n) {
      const Ring& wide = series.equation.ring();
      const Substitution put{{series.n, MFraction(wide, Rational(n))}};
      if (is_zero(substitute(series.value->den(), put))) continue; // no level
      const MFraction value = substitute(*series.value, put);
      for (const std::size_t i : used_variables(value))
        if (!q_.r.ring()->find(wide->name(i))) return {}; // a square root
      Level level;
      level.n = n;
      level.fixed = {energy_, transfer(value, q_.r.ring())};
      const Substitution there{{energy_, level.fixed->second}};
      if (!admits(s.conditions, there) || !admits(q_.assumptions, there)) continue;
      level.y = eigenfunction(q_, s, there, options_.levels, budget_);
      out.push_back(std::move(level));
    }
    return out;
  }

  void by_degrees(const Stratum& s, Piece& p) {
    p.why_open.reset();
    p.groups.clear();
    if (has_equation(q_.assumptions)) {
      p.why_open = Piece::Open::assumed_equations;
      return;
    }
    if (!s.leaf.scheme) {
      p.why_open = Piece::Open::no_places;
      return;
    }
    const strata::ExponentialFamilies families = families_of_exponents(*s.leaf.scheme, budget_);
    if (!families.missing.empty()) {
      p.why_open = Piece::Open::families;
      p.ended = families.missing;
      return;
    }
    p.status = Piece::Status::none;
    const ParametrisedSet region = region_of(q_, s);
    for (const ExponentialFamily& f : families.all) {
      DegreeFamily found = levels_of(s, f, region);
      if (found.first.empty() && found.open.empty()) continue; // none, proved
      p.families.push_back(std::move(found));
      p.status = Piece::Status::degrees;
    }
  }

  // A degree that is a number: one level at most.
  DegreeFamily levels_of(const Stratum& stratum, const ExponentialFamily& f,
                         const ParametrisedSet& region) {
    const Scheme& s = *stratum.leaf.scheme;
    DegreeFamily out{f.degree, {}, {}};
    if (!is_constant(f.degree)) return levels_by_degree(stratum, f, std::move(out));
    const Rational d = to_rational(f.degree);
    if (!is_integer(d) || sign(d) < 0) return out;
    if (d > Rational(most_unknowns)) {
      out.open = "a polynomial of degree " + kov::to_string(d) + " is needed, the limit is " +
                 std::to_string(most_unknowns);
      return out;
    }
    add_level(stratum, s, f, to_long(floor(d)), region, std::nullopt, out);
    return out;
  }

  // degree = N is solved for a parameter.
  DegreeFamily levels_by_degree(const Stratum& stratum, const ExponentialFamily& f,
                                DegreeFamily out) {
    const Scheme& s = *stratum.leaf.scheme;
    for (long n = 0; n < options_.levels; ++n) {
      const MFraction condition = f.degree - MFraction(s.r.ring(), Rational(n));
      const auto fixed = solved_linearly(condition, energy_);
      if (!fixed) {
        out.open = "the degree is linear in no parameter";
        return out;
      }
      const Substitution put{{fixed->first, fixed->second}};
      try {
        if (!admits(stratum.conditions, put) || !admits(q_.assumptions, put)) continue;
        Scheme there = s;
        there.r = substitute(s.r, put);
        add_level(stratum, there, at(f, put), n, known(q_, stratum, put), fixed, out);
      } catch (const DomainError&) {
        out.open = "degree " + std::to_string(n) + " is at the edge of the stratum";
        return out;
      }
      if (!out.open.empty()) return out;
    }
    out.open = "N >= " + std::to_string(options_.levels) + " was not looked at (--levels)";
    return out;
  }

  void add_level(const Stratum& stratum, const Scheme& s, const ExponentialFamily& f, long n,
                 const ParametrisedSet& region,
                 std::optional<std::pair<std::size_t, MFraction>> fixed, DegreeFamily& out) {
    PolynomialPart part = polynomial_part(s, f, n, region, budget_);
    if (!part.open.empty()) {
      out.open = part.open;
      return;
    }
    const Substitution put = fixed ? Substitution{{fixed->first, fixed->second}} : Substitution{};
    auto equations = simplified(part.conditions, nonzero_factors(all_conditions(q_, stratum), put),
                                q_.assumptions.memberships, budget_);
    if (!equations) return; // no such point
    Level level;
    level.n = n;
    level.fixed = std::move(fixed);
    level.y = function_of(part, f);
    level.equations = *std::move(equations);
    out.first.push_back(std::move(level));
  }

  static constexpr long most_unknowns = 24;

  const Question& q_;
  std::size_t energy_;
  const SpectrumOptions& options_;
  Budget budget_;
};

} // namespace

std::string open_reason(const Piece& p) {
  if (!p.why_open) return "";
  switch (*p.why_open) {
  case Piece::Open::group:
    return "the group is not known there";
  case Piece::Open::group_of_a_part:
    return "the group is not known on a part";
  case Piece::Open::several_without:
    return "several parts are without solutions";
  case Piece::Open::assumed_equations:
    return "equations between constants or parameters are assumed, which the search of exponential "
           "solutions does not know";
  case Piece::Open::no_places:
    return "the places of the equation are not at hand";
  case Piece::Open::families:
  case Piece::Open::limit:
    return p.ended;
  }
  return "";
}

bool AlgebraicSpectrum::decided() const {
  return strata.unvisited.empty() && std::ranges::none_of(pieces, [](const Piece& p) {
           return p.status == Piece::Status::open ||
                  std::ranges::any_of(p.families,
                                      [](const DegreeFamily& f) { return !f.open.empty(); });
         });
}

AlgebraicSpectrum algebraic_spectrum(const Question& q, std::size_t energy,
                                     const SpectrumOptions& options) {
  if (energy == q.z) throw InvalidArgument("the energy is the variable of the equation");
  AlgebraicSpectrum out;
  out.strata = strata::decide_strata(q, options.strata);
  out.trusted = out.strata.trusted;
  SpectrumStudy study(q, energy, options);
  for (const Stratum& s : out.strata.strata)
    out.pieces.push_back(study.piece(s));
  const auto is = [&](Piece::Status x) {
    return std::ranges::any_of(out.pieces, [&](const Piece& p) { return p.status == x; });
  };
  if (is(Piece::Status::degrees)) out.trusted.push_back({Trusted::Step::exponential_families});
  if (is(Piece::Status::conditions)) out.trusted.push_back({Trusted::Step::solved_for_the_energy});
  return out;
}

} // namespace kov::spectrum
