#include "integrals/find.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrals/bounds.hpp"
#include "integrals/known.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_splits = 16;     // for Darboux polynomials of special parameters
constexpr long most_logarithmic_degree = 6; // with the degree of the denominator
constexpr long logarithmic_degree = 3;      // of g in g + sum l_i log f_i
constexpr long field_degree = 3;            // of the numerators of commuting fields
constexpr std::size_t most_field_columns = 200, most_without_parameters = 600;
constexpr std::size_t many_parameters =
    4;                               // the integrals of a linear system fall apart into many sets
constexpr double darboux_part = 0.4; // of the time that is left, for each of these searches

struct IntegralStage {
  enum class Kind : std::uint8_t {
    casimirs,
    hamiltonian,
    linear,
    integrals,
    darboux_polynomials,
    logarithms,
    fields
  };
  Kind kind;
  long degree = 0;
  std::optional<long> coefficients = {};
  bool plain = false; ///< without the denominator of the system, or of Darboux polynomials
};
using Candidates = std::vector<FoundIntegral>;

struct IntegralQuestion {
  IntegralQuestion(const System& s, const IntegralOptions& o)
      : options(o), space(s, o.budget), natural(natural_hamiltonian(space)) {
    if (o.darboux && !space.field.poisson) polynomial = polynomial_field(space);
  }

  IntegralOptions options;
  PhaseSpace space;
  std::optional<NaturalHamiltonian> natural;
  std::optional<PolynomialField> polynomial = {}; ///< if Darboux polynomials are looked for
};

// A Hamiltonian of degree 2: the equations of motion are linear.
bool is_linear(const PhaseSpace& p) {
  const VectorField& v = p.field;
  return p.is_canonical() && p.is_polynomial_ring() && is_one(p.denominator) &&
         degree_of(p, v.hamiltonian->num()) <= 2;
}

// X' J A^(2j - 1) X, A the matrix of X: constant, as A' J = -J A, and in involution, as powers of A commute.
Candidates integrals_of_linear(const PhaseSpace& p) {
  const VectorField& v = p.field;
  const std::size_t n = v.dimension() / 2;
  const auto times_a = [&](const std::vector<MFraction>& x) {
    std::vector<MFraction> y;
    for (const MFraction& f : v.components) {
      MFraction sum(v.ring);
      for (std::size_t j = 0; j < x.size(); ++j)
        sum += derivative(f, v.coordinates[j]) * x[j];
      y.push_back(std::move(sum));
    }
    return y;
  };
  Candidates all;
  std::vector<MFraction> x = times_a(v.components);
  for (std::size_t k = 1; k < n; ++k) {
    MFraction f(v.ring);
    for (std::size_t i = 0; i < n; ++i)
      f += v.components[i] * x[n + i] - v.components[n + i] * x[i];
    if (!is_zero(f)) all.push_back({MFraction(f.num()), degree_in_momenta(p, f.num())});
    x = times_a(times_a(x));
  }
  return all;
}

std::vector<IntegralStage> planned_stages(const IntegralQuestion& q, const IntegralBounds& bounds) {
  using Kind = IntegralStage::Kind;
  const PhaseSpace& p = q.space;
  const IntegralOptions& options = q.options;
  std::vector<IntegralStage> stages;
  if (!p.is_canonical() && p.field.poisson)
    for (long k = 1; k <= options.degree; ++k)
      stages.push_back({Kind::casimirs, k, bounds.highest});
  if (p.field.hamiltonian) stages.push_back({Kind::hamiltonian});
  if (options.until_integrable && p.parameters.size() >= many_parameters && is_linear(p))
    stages.push_back({Kind::linear});
  if (options.until_integrable && !bounds.bounded && p.is_canonical())
    for (long k = 1; k <= std::min(options.degree, 2L) && k < *bounds.highest; ++k)
      stages.push_back({Kind::integrals, k, k});
  if (options.until_integrable && !bounds.layered && !is_one(p.denominator))
    for (long k = 1; k <= options.degree; ++k)
      stages.push_back({Kind::integrals, k, bounds.coefficients(k), true});
  for (long k = 1; k <= options.degree; ++k)
    stages.push_back({Kind::integrals, k, bounds.coefficients(k)});
  if (!q.polynomial) return stages;
  stages.push_back({Kind::darboux_polynomials});
  stages.push_back({Kind::logarithms, logarithmic_degree, {}, true});
  stages.push_back({Kind::logarithms, logarithmic_degree});
  if (options.until_integrable && is_one(q.polynomial->multiplier))
    for (long k = 1; k <= field_degree; ++k)
      stages.push_back({Kind::fields, k});
  return stages;
}

// The part on which Theorem 2 bounds the coefficients, and the rest.
std::vector<std::pair<Set, bool>> by_metric(const Set& all,
                                            const std::optional<NaturalHamiltonian>& natural) {
  if (!natural) return {{all, false}};
  std::vector<std::pair<Set, bool>> parts;
  if (const auto regular = all.where_nonzero(natural->determinant); !regular.is_empty())
    parts.emplace_back(regular, true);
  if (all.is_nonzero(natural->determinant)) return parts;
  if (const auto degenerate = all.where_zero(natural->determinant); !degenerate.is_empty())
    parts.emplace_back(degenerate, false);
  return parts;
}

bool same_answer(const IntegralsOfSet& a, const IntegralsOfSet& b) {
  const auto same = [](const FoundIntegral& f, const FoundIntegral& g) {
    return f.value == g.value && f.logarithms.empty() && g.logarithms.empty();
  };
  return a.searched == b.searched && a.liouville == b.liouville && a.complete == b.complete &&
         a.complete_for_smooth == b.complete_for_smooth && a.open == b.open &&
         std::ranges::equal(a.integrals, b.integrals, same);
}

// Sets on which nothing was found, with one and the same answer, are one: the complement of the
// others, which therefore must be known by their conditions alone.
void gather_elsewhere(IntegralSearch& result, const std::vector<MPoly>& everywhere) {
  if (!result.finished()) return;
  const auto is_plain = [](const IntegralsOfSet& s) { return s.found() == 0 && s.fields.empty(); };
  const auto last = std::find_if(result.sets.rbegin(), result.sets.rend(), is_plain);
  if (last == result.sets.rend()) return;
  IntegralsOfSet rest = *last;
  const auto is_rest = [&](const IntegralsOfSet& s) { return is_plain(s) && same_answer(s, rest); };
  const auto is_generic = [&](const IntegralsOfSet& s) { // "everywhere else" is not a thin set
    return is_rest(s) && s.equations == everywhere;
  };
  if (std::ranges::none_of(result.sets, is_generic)) return;
  std::erase_if(result.sets, is_rest);
  rest.equations.clear();
  rest.inequations.clear();
  result.elsewhere = std::move(rest);
}

// num/den up to a constant, in the simplest form that the equations of the set allow.
MFraction on_set(const PhaseSpace& p, const Set& where, const MPoly& num, const MPoly& den) {
  const MFraction below = where.restrict(den);
  if (is_zero(below)) return {num, den};
  const MFraction value = where.restrict(num) / below;
  const bool constant_below =
      std::ranges::none_of(p.variables, [&](std::size_t v) { return degree(value.den(), v) > 0; });
  return constant_below ? MFraction(value.num()) : value;
}

Candidates candidates(const PhaseSpace& p, const Set& where, const EchelonForm& e,
                      const Ansatz& ansatz, bool casimirs) {
  Candidates all;
  for (const auto& vector : kernel_basis(where, e)) {
    MPoly sum(p.field.ring);
    for (const auto& [j, c] : restricted(where, without_denominators(p.field.ring, vector)))
      sum += c * ansatz.numerators[j];
    const MFraction value = shortest_form(p.field, on_set(p, where, sum, ansatz.denominator));
    all.push_back({value, degree_in_momenta(p, value.num()), casimirs});
  }
  std::ranges::stable_sort(all, [](const FoundIntegral& a, const FoundIntegral& b) {
    return std::pair(a.degree, a.value.num().length()) <
           std::pair(b.degree, b.value.num().length());
  });
  return all;
}

/// Another budget, for a while.
class Within {
public:
  Within(Budget& budget, Budget other) : budget_(budget), before_(std::move(budget)) {
    budget_ = std::move(other);
  }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;
  ~Within() { budget_ = std::move(before_); }

private:
  Budget& budget_;
  Budget before_;
};

Set allowed_parameters(const IntegralQuestion& q) {
  Set all(q.space.field.ring, q.space.parameters, q.options.budget);
  for (const MPoly& f : q.space.nonzero)
    all = all.where_nonzero(f);
  for (const auto* zero : {&q.space.equations, &q.space.assumed_equations})
    for (const MPoly& f : *zero)
      all = all.where_zero(f);
  if (all.is_empty())
    throw InvalidArgument("no parameter value satisfies the relations and assumptions");
  return all;
}

Ansatz ansatz_of(const PhaseSpace& p, const IntegralBounds& bounds, const IntegralStage& stage) {
  PhaseSpace space = p;
  if (stage.kind == IntegralStage::Kind::casimirs)
    space.denominator = space.of_bracket;
  else if (stage.plain)
    space.denominator = MPoly(space.field.ring, Integer(1));
  return bounds.ansatz(space, stage.degree, stage.coefficients);
}

// The fields along which the functions are constant: of all coordinates for Casimirs, else that of the system and
// those of the integrals that were chosen.
std::vector<std::vector<MFraction>> fields_of(const IntegralQuestion& q, const KnownIntegrals& s,
                                              const IntegralStage& stage) {
  const VectorField& v = q.space.field;
  std::vector<std::vector<MFraction>> fields;
  if (stage.kind == IntegralStage::Kind::casimirs) {
    for (std::size_t j = 0; j < v.dimension(); ++j)
      std::ranges::transform(*v.poisson, std::back_inserter(fields.emplace_back()),
                             [&](const auto& row) { return row[j]; });
    return fields;
  }
  if (q.options.until_integrable && v.poisson) fields = s.fields_of_chosen();
  fields.insert(fields.begin(), v.components);
  return fields;
}

// The equations, without the columns that known integrals allow to be left out.
EchelonForm equations(const IntegralQuestion& q, const KnownIntegrals& s, const Ansatz& ansatz,
                      const IntegralStage& stage, const Budget& budget) {
  EchelonForm e = equations_of(q.space, ansatz, fields_of(q, s, stage), budget);
  EchelonForm known{e.columns, s.products(ansatz, stage.degree)};
  for (const std::size_t j : gauge_columns(s.where, std::move(known), budget))
    e.rows.push_back({{j, MPoly(q.space.field.ring, Integer(1))}});
  return e;
}

IntegralsOfSet answer_of(const IntegralQuestion& q, const IntegralBounds& bounds, KnownIntegrals s,
                         const std::string& open, const Budget& budget) {
  IntegralsOfSet set;
  set.searched = bounds.searched();
  set.equations = s.where.equations();
  set.open = open;
  set.liouville = q.space.field.poisson && s.is_liouville(budget);
  if (s.commuting.size() > s.casimirs() + 1 && q.options.until_integrable)
    set.searched += ", in involution with those found";
  set.only_declared_relations = !q.space.is_polynomial_ring();
  const bool ended_early = q.options.until_integrable && set.liouville;
  set.complete = set.open.empty() && q.space.is_polynomial_ring() && !ended_early;
  set.complete_for_smooth = set.complete && q.natural && q.natural->polynomial && !bounds.highest;
  try {
    set.inequations = s.where.proper_inequations();
    if (q.space.field.poisson && !set.liouville) set.liouville = s.is_liouville_in_order(budget);
  } catch (const OutOfBudget& limit) {
    if (set.inequations.empty()) set.inequations = s.where.inequations();
    if (set.open.empty()) set.open = limit.what();
  }
  set.integrals = std::move(s.found);
  set.commuting = std::move(s.commuting);
  set.fields = std::move(s.fields);
  return set;
}

// Unset: its degree is too large.
std::optional<LogarithmicAnsatz> logarithmic_ansatz(const PhaseSpace& p,
                                                    const std::vector<DarbouxPolynomial>& darboux,
                                                    const IntegralStage& stage) {
  const Ring& ring = p.field.ring;
  LogarithmicAnsatz ansatz{darboux, {}, MPoly(ring, Integer(1)), MFraction(ring)};
  for (const DarbouxPolynomial& f : darboux) {
    if (stage.plain) break;
    ansatz.below *= f.polynomial;
    ansatz.cofactor += f.cofactor;
  }
  const long degree = stage.degree + degree_of(p, ansatz.below);
  if (degree > most_logarithmic_degree) return std::nullopt;
  ansatz.monomials = monomials(ring, p.variables, degree);
  if (stage.plain) ansatz.monomials.erase(ansatz.monomials.begin()); // 1
  return ansatz;
}

/// The stages one after the other on a set of parameters, which is divided where special ones have more.
class Search {
public:
  explicit Search(const IntegralQuestion& q) : q_(q), p_(q.space), budget_(q.options.budget) {}

  IntegralSearch run() {
    const Set all = allowed_parameters(q_);
    result_.not_covered = p_.not_covered;
    result_.assumed_equations = p_.assumed_equations;
    for (const MPoly& f : p_.nonzero)
      if (!is_among(f, p_.not_covered)) result_.assumed.push_back(f);
    for (const auto& [where, is_regular] : by_metric(all, q_.natural)) {
      bounds_.emplace(p_, q_.natural, q_.options, is_regular);
      stages_ = planned_stages(q_, *bounds_);
      start(where);
    }
    gather_elsewhere(result_, all.equations());
    return std::move(result_);
  }

private:
  void start(const Set& where) { enter({.space = &p_, .where = where}, 0); }
  // Leaves the part where the condition is not 0; the other is looked at before.  False: nothing is left.
  bool divide(Set& where, const MPoly& condition) {
    if (const auto zero = where.where_zero(condition); !zero.is_empty()) start(zero);
    where = where.where_nonzero(condition);
    return !where.is_empty();
  }

  void conclude(KnownIntegrals s, const std::string& open = {}) {
    result_.sets.push_back(answer_of(q_, *bounds_, std::move(s), open, budget_));
  }
  [[nodiscard]] Budget share() const { return part_of_the_work(budget_, darboux_part); }

  void enter(KnownIntegrals s, std::size_t stage) {
    using Kind = IntegralStage::Kind;
    if (result_.sets.size() >= q_.options.max_sets)
      return conclude(std::move(s), "more than " + std::to_string(q_.options.max_sets) +
                                        " sets of parameter values");
    if (q_.options.until_integrable && s.is_integrable(budget_)) return conclude(std::move(s));
    const bool last = stage == stages_.size();
    if ((last || q_.options.until_integrable) && p_.field.poisson &&
        s.commuting.size() < s.found.size() && s.combined < s.found_and_chosen() &&
        !s.is_integrable(budget_))
      return combine(std::move(s), stage);
    if (last) return conclude(std::move(s));
    const IntegralStage& here = stages_[stage];
    if (here.kind == Kind::hamiltonian) {
      const MFraction& value = *p_.field.hamiltonian;
      return take(std::move(s), {{value, degree_in_momenta(p_, value.num()), false, true}},
                  stage + 1);
    }
    if (here.kind == Kind::linear) return take(std::move(s), integrals_of_linear(p_), stage + 1);
    if (here.kind == Kind::fields) return look_for_fields(std::move(s), stage, 0);
    if (here.kind == Kind::casimirs || here.kind == Kind::integrals) return look(s, stage);
    if (s.found.size() + 1 >= p_.field.dimension()) // all integrals are known
      return enter(std::move(s), stage + 1);
    here.kind == Kind::logarithms ? look_for_logarithms(std::move(s), stage)
                                  : look_for_darboux_polynomials(std::move(s), stage);
  }

  // The integrals of one degree, on each part of the set.
  void look(const KnownIntegrals& s, std::size_t stage) {
    try {
      const bool casimirs = stages_[stage].kind == IntegralStage::Kind::casimirs;
      if (casimirs && q_.options.until_integrable && s.has_all_casimirs(budget_))
        return enter(s, stage + 1);
      const Ansatz ansatz = ansatz_of(p_, *bounds_, stages_[stage]);
      EchelonForm e = equations(q_, s, ansatz, stages_[stage], budget_);
      if (independent_modulo_a_prime(e)) return enter(s, stage + 1);
      share_among_kernels(
          s.where, std::move(e),
          {.leaf =
               [&](const Set& where, const EchelonForm& done, const Budget& budget) {
                 const Within within(budget_, budget);
                 take(s.on(where), candidates(p_, where, done, ansatz, casimirs), stage + 1);
               },
           .open = [&](const Set& where,
                       const OutOfBudget& limit) { conclude(s.on(where), limit.what()); }},
          budget_);
    } catch (const OutOfBudget& limit) {
      conclude(s, limit.what());
    }
  }

  // Darboux polynomials for all parameters of the set; it is divided where special ones have more.
  void look_for_darboux_polynomials(KnownIntegrals s, std::size_t stage) {
    bool is_left = true;
    tried<OutOfBudget>([&] { // at a limit what was found is right
      s.darboux = darboux_polynomials(p_, *q_.polynomial, s.where, share());
      for (const DarbouxPolynomial& f : s.darboux)
        for (const MPoly& condition : special_conditions(s, f)) {
          if (splits_++ >= most_splits) break;
          is_left = divide(s.where, condition);
          if (!is_left) return;
        }
    });
    if (!is_left) return;
    std::erase_if(s.darboux,
                  [&](const DarbouxPolynomial& f) { return !is_darboux(s, *q_.polynomial, f); });
    enter(std::move(s), stage + 1);
  }

  void look_for_logarithms(KnownIntegrals s, std::size_t stage) {
    if (s.darboux.empty()) return enter(std::move(s), stage + 1);
    const auto ansatz = logarithmic_ansatz(p_, s.darboux, stages_[stage]);
    if (!ansatz) return enter(std::move(s), stage + 1);
    const EchelonForm e = equations_of(p_, *q_.polynomial, *ansatz);
    const auto parts = kernel_parts(s, e, share());
    if (parts.empty()) return enter(std::move(s), stage + 1);
    for (const auto& [part, kernel] : parts)
      take(part, logarithmic_integrals(part, *ansatz, kernel), stage + 1);
  }

  // Numerators of one degree over a product of Darboux polynomials: none, one, all of them.
  void look_for_fields(KnownIntegrals s, std::size_t stage, std::size_t denominator) {
    if (s.is_integrable(budget_) || denominator >= s.darboux.size() + 2)
      return enter(std::move(s), stage + 1);
    const FieldAnsatz ansatz(s, stages_[stage].degree, denominator);
    std::vector<std::pair<KnownIntegrals, EchelonForm>> parts;
    if (ansatz.numerators.size() * p_.variables.size() <=
        (p_.parameters.empty() ? most_without_parameters : most_field_columns)) {
      std::vector<std::vector<MFraction>> gradients;
      for (const FoundIntegral& f : s.found)
        gradients.push_back(gradient(p_.field, f));
      const EchelonForm e = commuting_fields(p_, *q_.polynomial, ansatz.numerators, ansatz.cofactor,
                                             gradients, share());
      parts = kernel_parts(s, e, share());
    }
    if (parts.empty()) return look_for_fields(std::move(s), stage, denominator + 1);
    for (auto& [part, kernel] : parts)
      if (take_fields(part, ansatz.fields(part, kernel)))
        look_for_fields(std::move(part), stage, denominator + 1);
  }

  // Takes the fields that are independent of the ones before and commute with them.  False: nothing
  // is left of the set.
  bool take_fields(KnownIntegrals& s, const std::vector<std::vector<MFraction>>& all) {
    for (const auto& y : all) {
      if (s.is_integrable(budget_)) break;
      s.verify(y);
      if (!std::ranges::all_of(s.fields, [&](const auto& z) { return s.commute(y, z); })) continue;
      while (const auto condition = s.add(y, budget_))
        if (!divide(s.where, *condition)) return false;
    }
    return true;
  }

  // Quadratic polynomials in the known integrals that commute with those that were chosen: they
  // take the place of integrals that do not (Lemma 1 of docs/theory/integrals.md).
  void combine(KnownIntegrals s, std::size_t stage) {
    s.combined = s.found_and_chosen();
    try {
      const Ansatz ansatz = s.quadratic();
      for_each_kernel(
          s.where, equations_of(p_, ansatz, s.fields_of_chosen(), budget_),
          [&](const Set& where, const EchelonForm& done) {
            KnownIntegrals part = s.on(where);
            const Candidates more = candidates(p_, where, done, ansatz, false);
            if (more.empty()) return enter(std::move(part), stage);
            const Candidates all = part.commuting_first(more);
            part.found.clear();
            part.commuting.clear();
            part.gradients = IndependentRows(p_);
            take(std::move(part), all, stage);
          },
          budget_);
    } catch (const OutOfBudget& limit) {
      conclude(std::move(s), limit.what());
    }
  }

  // Takes the candidates that are independent of what is known; the parameters are split where that
  // depends on them.
  void take(KnownIntegrals s, const Candidates& all, std::size_t stage) {
    try {
      for (const FoundIntegral& f : all) {
        s.verify(f);
        while (const auto condition = s.add(f, budget_)) {
          const Within within(budget_, part_of_the_work(budget_, 0.5));
          if (!divide(s.where, *condition)) return;
        }
      }
    } catch (const OutOfBudget& limit) {
      return conclude(std::move(s), limit.what());
    }
    enter(std::move(s), stage);
  }

  const IntegralQuestion& q_;
  const PhaseSpace& p_;
  Budget budget_;
  std::size_t splits_ = 0;               ///< for Darboux polynomials
  std::optional<IntegralBounds> bounds_; ///< on the part that is looked at
  std::vector<IntegralStage> stages_;
  IntegralSearch result_;
};

} // namespace

std::size_t IntegralsOfSet::found() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      integrals, [](const FoundIntegral& f) { return !f.casimir && !f.hamiltonian; }));
}

bool IntegralsOfSet::integrable(const VectorField& v) const {
  return v.poisson ? liouville : integrals.size() + fields.size() + 1 >= v.dimension();
}

std::vector<MFraction> gradient(const VectorField& v, const FoundIntegral& f) {
  auto all = gradient(v, f.value);
  for (const LogarithmicTerm& t : f.logarithms) {
    const auto more = gradient(v, MFraction(t.of));
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] += t.times * more[i] / MFraction(t.of);
  }
  return all;
}

bool IntegralSearch::finished() const {
  return std::ranges::all_of(sets, [](const IntegralsOfSet& s) { return s.open.empty(); });
}

IntegralSearch find_integrals(const System& s, const IntegralOptions& options) {
  return Search(IntegralQuestion(s, options)).run();
}

bool is_bounded_by_a_theorem(const System& s, const IntegralOptions& options) {
  const IntegralQuestion q(s, options);
  return !IntegralBounds(q.space, q.natural, options, q.natural.has_value()).highest;
}

std::string searched_class(const System& s, const IntegralOptions& options) {
  const IntegralQuestion q(s, options);
  return IntegralBounds(q.space, q.natural, options, q.natural.has_value()).searched();
}

} // namespace kov
