#include "integrals/find.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrals/darboux.hpp"
#include "integrals/independence.hpp"

#include <algorithm>

namespace kov {
namespace {

// A denominator as its factors, or by the number of its terms.
std::string denominator_text(const MPoly& den) {
  constexpr std::size_t longest = 80;
  const std::string factors = to_factored_string(MFraction(den));
  return factors.size() <= longest ? factors
                                   : "a denominator of " + std::to_string(den.length()) + " terms";
}

// The largest number of unknowns of the ansatz with the bounds of Theorem 3, with and without
// parameters; if it would be larger, a smaller ansatz is chosen.
constexpr std::size_t most_with_parameters = 600;
constexpr std::size_t most_without = 2000;
// Integrals that depend on others, which quadratic polynomials may contain.
constexpr std::size_t most_dependent = 8;
constexpr std::size_t most_splits = 16; // for Darboux polynomials of special parameters
constexpr long logarithmic_degree = 3;  // of g in g + sum l_i log f_i
constexpr long field_degree = 3;        // of the numerators of commuting fields
constexpr std::size_t most_field_columns = 200;
constexpr double darboux_part = 0.4; // of the time that is left, for each of these searches

std::vector<std::vector<MFraction>> bracket_fields(const VectorField& v) {
  std::vector<std::vector<MFraction>> all;
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    all.emplace_back();
    for (std::size_t i = 0; i < v.dimension(); ++i)
      all.back().push_back((*v.poisson)[i][j]);
  }
  return all;
}

class Search {
public:
  Search(const System& s, const IntegralOptions& o)
      : options_(o), space_(s, o.budget), natural_(natural_hamiltonian(space_)),
        mechanical_(s.kind == SystemKind::hamiltonian) {
    if (o.darboux && !space_.field.poisson) polynomial_ = polynomial_field(space_);
  }

  IntegralSearch run() {
    ParameterSet all(space_.field.ring, space_.parameters, options_.budget);
    for (const MPoly& f : space_.nonzero)
      all = all.where_nonzero(f);
    for (const auto* zero : {&space_.equations, &space_.assumed_equations})
      for (const MPoly& f : *zero)
        all = all.where_zero(f);
    if (all.is_empty())
      throw InvalidArgument("no parameter value satisfies the relations and assumptions");
    result_.not_covered = space_.not_covered;
    result_.assumed_equations = space_.assumed_equations;
    for (const MPoly& f : space_.nonzero)
      if (!is_among(f, space_.not_covered)) result_.assumed.push_back(f);
    for (const auto& [where, natural] : by_metric(all)) {
      choose_bounds(natural);
      plan_stages();
      start(where);
    }
    gather_elsewhere(all.equations());
    return std::move(result_);
  }

  std::string generic_class() {
    choose_bounds(natural_.has_value());
    return searched();
  }

private:
  struct Stage {
    enum class Kind : std::uint8_t {
      casimirs,
      hamiltonian,
      integrals,
      darboux_polynomials,
      logarithms,
      fields
    };
    Kind kind;
    long degree = 0;
    std::optional<long> coefficients = {};
    bool plain = false; ///< without the denominator of the system
  };
  struct State {
    ParameterSet where;
    std::vector<FoundIntegral> found;
    IndependentRows gradients;
    std::vector<std::size_t> commuting = {}; ///< indices of integrals in involution
    std::vector<MFraction> dependent = {};   ///< some that depend on those found
    std::vector<DarbouxPolynomial> darboux = {};
    std::vector<std::vector<MFraction>> fields = {}; ///< beside that of the system
    std::size_t combined = 0; ///< what `progress` was when functions of them were looked at last
  };
  using Candidates = std::vector<FoundIntegral>;

  void plan_stages() {
    stages_.clear();
    if (!mechanical_ && space_.field.poisson)
      for (long k = 1; k <= options_.degree; ++k)
        stages_.push_back({Stage::Kind::casimirs, k, coefficients_});
    if (space_.field.hamiltonian) stages_.push_back({Stage::Kind::hamiltonian});
    if (options_.until_integrable && !bounded_ && mechanical_)
      for (long k = 1; k <= std::min(options_.degree, 2L) && k < *coefficients_; ++k)
        stages_.push_back({Stage::Kind::integrals, k, k});
    if (options_.until_integrable && !layered_ && !is_one(space_.denominator))
      for (long k = 1; k <= options_.degree; ++k)
        stages_.push_back({Stage::Kind::integrals, k, coefficients(k), true});
    for (long k = 1; k <= options_.degree; ++k)
      stages_.push_back({Stage::Kind::integrals, k, coefficients(k)});
    if (!polynomial_) return;
    stages_.push_back({Stage::Kind::darboux_polynomials});
    stages_.push_back({Stage::Kind::logarithms, logarithmic_degree});
    if (options_.until_integrable && is_one(polynomial_->multiplier))
      for (long k = 1; k <= field_degree; ++k)
        stages_.push_back({Stage::Kind::fields, k});
  }

  // The part on which Theorem 2 bounds the coefficients, and the rest.
  std::vector<std::pair<ParameterSet, bool>> by_metric(const ParameterSet& all) const {
    if (!natural_) return {{all, false}};
    std::vector<std::pair<ParameterSet, bool>> parts;
    if (const auto regular = all.where_nonzero(natural_->determinant); !regular.is_empty())
      parts.emplace_back(regular, true);
    if (all.is_nonzero(natural_->determinant)) return parts;
    if (const auto degenerate = all.where_zero(natural_->determinant); !degenerate.is_empty())
      parts.emplace_back(degenerate, false);
    return parts;
  }

  // natural: where the metric is regular.
  void choose_bounds(bool natural) {
    layered_ = natural && !(natural_->even && natural_->polynomial);
    bounded_ = natural && natural_->twice_step && !options_.coefficients;
    coefficients_ = coefficients(options_.degree);
  }

  // For integrals of this degree; unset: those of Theorems 2 and 3.
  std::optional<long> coefficients(long degree) const {
    if (bounded_ && (!layered_ || is_small(degree))) return std::nullopt;
    return options_.coefficients ? options_.coefficients : options_.degree;
  }
  // The ansatz of Theorem 3, by itself or beside the one that is chosen otherwise.
  bool is_small(long degree) const {
    const std::size_t most = space_.parameters.empty() ? most_without : most_with_parameters;
    const auto size = unknowns(degree, std::nullopt);
    return size && (*size <= most || *size <= unknowns(degree, options_.degree).value_or(*size));
  }
  // Unset: too many.
  std::optional<std::size_t> unknowns(long degree, std::optional<long> coefficients) const {
    return tried<OutOfBudget>([&] {
      return std::optional(
          make_ansatz(space_, {degree, coefficients, layered_}, natural_).numerators.size());
    });
  }

  std::string searched() const {
    const std::string d = std::to_string(options_.degree);
    if (layered_) return searched_in_layers();
    const MPoly den = ansatz_denominator(space_, options_.degree);
    const long more = degree_of(space_, den);
    const std::string over = more > 0 ? ", over " + denominator_text(den) : "";
    if (!mechanical_)
      return "polynomials of degree <= " + std::to_string(options_.degree + more) +
             " in the phase variables" + over;
    const std::string first = "polynomials of degree <= " + d + " in the momenta";
    if (!coefficients_) return first;
    return first + ", their coefficients polynomials of degree <= " +
           std::to_string(*coefficients_ + more) + " in the other variables" + over;
  }

  // Statements of theorems about the highest part, and about denominators and degrees, need no
  // words.
  std::string searched_in_layers() const {
    const std::string first =
        "polynomials of degree <= " + std::to_string(options_.degree) + " in the momenta";
    if (!coefficients_)
      return first + (natural_->polynomial
                          ? ""
                          : ", their coefficients rational functions of the coordinates");
    const long more = degree_of(space_, space_.denominator);
    const std::string c = std::to_string(*coefficients_);
    const std::string step = natural_->even ? "2" : "1";
    const std::string text = first + ", their other coefficients polynomials of degree <= " + c;
    if (more == 0) return text + " in the other variables";
    return text + " + " + std::to_string(more) + "*j over (" +
           denominator_text(space_.denominator) + ")^j, " + step +
           "*j degrees below the highest one";
  }

  static bool same_answer(const IntegralsOfSet& a, const IntegralsOfSet& b) {
    const auto same = [](const FoundIntegral& f, const FoundIntegral& g) {
      return f.value == g.value && f.logarithms.empty() && g.logarithms.empty();
    };
    return a.searched == b.searched && a.liouville == b.liouville && a.complete == b.complete &&
           a.complete_for_smooth == b.complete_for_smooth && a.open == b.open &&
           std::ranges::equal(a.integrals, b.integrals, same);
  }

  // Sets on which nothing was found, with one and the same answer, are one: the complement of the
  // others, which therefore must be known by their conditions alone.
  void gather_elsewhere(const std::vector<MPoly>& everywhere) {
    if (std::ranges::any_of(result_.sets, [](const IntegralsOfSet& s) { return !s.open.empty(); }))
      return;
    const auto is_plain = [](const IntegralsOfSet& s) {
      return s.found() == 0 && s.fields.empty();
    };
    const auto last = std::find_if(result_.sets.rbegin(), result_.sets.rend(), is_plain);
    if (last == result_.sets.rend()) return;
    IntegralsOfSet rest = *last;
    const auto is_rest = [&](const IntegralsOfSet& s) {
      return is_plain(s) && same_answer(s, rest);
    };
    const auto is_generic = [&](const IntegralsOfSet& s) { // "everywhere else" is not a thin set
      return is_rest(s) && s.equations == everywhere;
    };
    if (std::ranges::none_of(result_.sets, is_generic)) return;
    std::erase_if(result_.sets, is_rest);
    rest.equations.clear();
    rest.inequations.clear();
    result_.elsewhere = std::move(rest);
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

  void start(const ParameterSet& where) { enter({where, {}, IndependentRows(space_)}, 0); }

  void enter(State s, std::size_t stage) {
    if (result_.sets.size() >= options_.max_sets)
      return conclude(std::move(s), "more than " + std::to_string(options_.max_sets) +
                                        " sets of parameter values");
    if (options_.until_integrable && is_integrable(s)) return conclude(std::move(s));
    const bool last = stage == stages_.size();
    if ((last || options_.until_integrable) && may_combine(s)) return combine(std::move(s), stage);
    if (last) return conclude(std::move(s));
    switch (stages_[stage].kind) {
    case Stage::Kind::hamiltonian: {
      const MFraction& value = *space_.field.hamiltonian;
      return take(std::move(s), {{value, degree_in_momenta(value), false, true}}, stage + 1);
    }
    case Stage::Kind::darboux_polynomials:
      return look_for_darboux_polynomials(std::move(s), stage);
    case Stage::Kind::logarithms:
      return look_for_logarithms(std::move(s), stage);
    case Stage::Kind::fields:
      return look_for_fields(std::move(s), stage, 0);
    default:
      return look(s, stage);
    }
  }

  Ansatz ansatz_of(const Stage& stage) const {
    PhaseSpace space = space_;
    if (stage.kind == Stage::Kind::casimirs)
      space.denominator = space.of_bracket;
    else if (stage.plain)
      space.denominator = MPoly(space.field.ring, Integer(1));
    return make_ansatz(space, {stage.degree, stage.coefficients, layered_}, natural_);
  }

  // The integrals of one degree, on each part of the set.
  void look(const State& s, std::size_t stage) {
    try {
      const Stage& here = stages_[stage];
      if (here.kind == Stage::Kind::casimirs && options_.until_integrable && has_all_casimirs(s))
        return enter(s, stage + 1);
      const Ansatz ansatz = ansatz_of(here);
      EchelonForm e = equations(s, ansatz, stages_[stage]);
      if (independent_modulo_a_prime(e)) return enter(s, stage + 1);
      const auto part_of = [&](const ParameterSet& where) {
        State part = s;
        part.where = where;
        return part;
      };
      share_among_kernels(
          s.where, std::move(e),
          {.leaf =
               [&](const ParameterSet& where, const EchelonForm& done, const Budget& budget) {
                 const Within within(options_.budget, budget);
                 Candidates all =
                     candidates(where, done, ansatz, here.kind == Stage::Kind::casimirs);
                 take(part_of(where), std::move(all), stage + 1);
               },
           .open = [&](const ParameterSet& where,
                       const OutOfBudget& limit) { conclude(part_of(where), limit.what()); }},
          options_.budget);
    } catch (const OutOfBudget& limit) {
      conclude(s, limit.what());
    }
  }

  // ---- fields without a bracket

  [[nodiscard]] bool has_all_integrals(const State& s) const {
    return s.found.size() + 1 >= space_.field.dimension();
  }
  [[nodiscard]] Budget share() const { return part_of_the_work(options_.budget, darboux_part); }

  // Darboux polynomials for all parameters of the set; it is divided where special ones have more.
  void look_for_darboux_polynomials(State s, std::size_t stage) {
    if (has_all_integrals(s)) return enter(std::move(s), stage + 1);
    bool is_left = true;
    tried<OutOfBudget>([&] { // at a limit what was found is right
      s.darboux = darboux_polynomials(space_, *polynomial_, s.where, share());
      for (const DarbouxPolynomial& f : s.darboux)
        for (const MPoly& condition : special_conditions(s.where, f)) {
          if (splits_ == most_splits) break;
          ++splits_;
          if (const auto zero = s.where.where_zero(condition); !zero.is_empty()) start(zero);
          s.where = s.where.where_nonzero(condition);
          is_left = !s.where.is_empty();
          if (!is_left) return;
        }
    });
    if (!is_left) return;
    std::erase_if(s.darboux, [&](const DarbouxPolynomial& f) { return !is_darboux(s.where, f); });
    enter(std::move(s), stage + 1);
  }
  // The first equation, by its factors, if it may hold somewhere on the set and not everywhere; then
  // where the cofactor may have no value, or the polynomial be 0.
  std::vector<MPoly> special_conditions(const ParameterSet& where,
                                        const DarbouxPolynomial& f) const {
    if (!is_zero(f.cofactor) && !where.vanishes(f.cofactor.den()))
      if (auto poles = where.doubtful_factors(f.cofactor.den()); !poles.empty()) return poles;
    if (f.equations.empty())
      return is_nowhere_zero(where, f.polynomial)
                 ? std::vector<MPoly>{}
                 : where.doubtful_factors(some_coefficient(where, f.polynomial));
    const MPoly equation = where.restrict(f.equations.front()).num();
    return is_zero(equation) ? std::vector<MPoly>{} : where.doubtful_factors(equation);
  }
  [[nodiscard]] bool is_darboux(const ParameterSet& where, const DarbouxPolynomial& f) const {
    const MFraction value(f.polynomial);
    return is_nowhere_zero(where, f.polynomial) &&
           (is_zero(f.cofactor) || where.is_nonzero(f.cofactor.den())) &&
           space_.vanishes(where, MFraction(polynomial_->multiplier) *
                                          lie_derivative(space_.field, value) -
                                      f.cofactor * value);
  }
  // At no parameter value f is the zero polynomial.
  [[nodiscard]] bool is_nowhere_zero(const ParameterSet& where, const MPoly& f) const {
    const auto all = space_.coefficients(f, nullptr);
    return std::ranges::any_of(all, [&](const auto& c) { return where.is_nonzero(c.second); });
  }
  [[nodiscard]] MPoly some_coefficient(const ParameterSet& where, const MPoly& f) const {
    for (const auto& [m, c] : space_.coefficients(f, nullptr))
      if (!is_zero(where.restrict(c))) return c;
    return MPoly(f.ring(), Integer(1));
  }

  using KernelParts = std::vector<std::pair<ParameterSet, EchelonForm>>;
  // All parts or none.
  KernelParts kernel_parts(const ParameterSet& where, const EchelonForm& e) const {
    KernelParts parts;
    try {
      const Budget budget = share();
      for_each_kernel(
          where, e,
          [&](const ParameterSet& set, const EchelonForm& done) { parts.emplace_back(set, done); },
          budget);
    } catch (const OutOfBudget&) {
      parts.clear();
    }
    return parts;
  }

  void look_for_logarithms(State s, std::size_t stage) {
    if (has_all_integrals(s) || s.darboux.empty()) return enter(std::move(s), stage + 1);
    LogarithmicAnsatz ansatz{s.darboux,
                             monomials(space_.field.ring, space_.variables, stages_[stage].degree)};
    ansatz.monomials.erase(ansatz.monomials.begin()); // 1
    const auto parts = kernel_parts(s.where, equations_of(space_, *polynomial_, ansatz));
    if (parts.empty()) return enter(std::move(s), stage + 1);
    for (const auto& [where, done] : parts) {
      State part = s;
      part.where = where;
      Candidates all;
      for (const auto& vector : kernel_basis(where, done))
        all.push_back(integral_of(ansatz, vector));
      take(std::move(part), all, stage + 1);
    }
  }

  // The integral of this vector; without logarithms where a product of powers says the same.
  FoundIntegral integral_of(const LogarithmicAnsatz& ansatz,
                            const std::map<std::size_t, MFraction>& vector) const {
    FoundIntegral f{.value = MFraction(space_.field.ring)};
    const std::size_t first = ansatz.polynomials.size();
    MPoly den(space_.field.ring, Integer(1));
    for (const auto& [j, c] : vector)
      den = exact_div(den * c.den(), gcd(den, c.den()));
    for (const auto& [j, c] : vector)
      if (const MFraction times = c * MFraction(den); j < first)
        f.logarithms.push_back({times, ansatz.polynomials[j].polynomial});
      else
        f.value += times * MFraction(ansatz.monomials[j - first]);
    if (const auto product = product_of_powers(f)) f = {.value = *product};
    f.degree = degree_in_momenta(f.value);
    return f;
  }
  static std::optional<MFraction> product_of_powers(const FoundIntegral& f) {
    constexpr long highest = 12;
    if (f.logarithms.empty() || !is_zero(f.value)) return std::nullopt;
    Integer den(1);
    for (const LogarithmicTerm& t : f.logarithms) {
      if (!is_constant(t.times)) return std::nullopt;
      den = lcm(den, to_rational(t.times).den());
    }
    MFraction product(f.value.ring(), Rational(1));
    for (const LogarithmicTerm& t : f.logarithms) {
      const Rational power = to_rational(t.times) * Rational(den);
      if (abs(power) > Rational(highest)) return std::nullopt;
      product *= pow(MFraction(t.of), to_long(power.num()));
    }
    return product;
  }

  // Numerators of one degree over a product of Darboux polynomials: none, one, all of them.
  void look_for_fields(State s, std::size_t stage, std::size_t denominator) {
    const auto done = [&] { return is_integrable(s) || denominator >= s.darboux.size() + 2; };
    if (done()) return enter(std::move(s), stage + 1);
    const auto numerators = monomials(space_.field.ring, space_.variables, stages_[stage].degree);
    const MFraction below = product(s, denominator);
    const std::size_t columns = numerators.size() * space_.variables.size();
    KernelParts parts;
    if (columns <= most_field_columns) {
      std::vector<std::vector<MFraction>> gradients;
      for (const FoundIntegral& f : s.found)
        gradients.push_back(gradient(space_.field, f));
      parts = kernel_parts(s.where, commuting_fields(space_, *polynomial_, numerators,
                                                     cofactor(s, denominator), gradients, share()));
    }
    if (parts.empty()) return look_for_fields(std::move(s), stage, denominator + 1);
    for (const auto& [where, kernel] : parts) {
      State part = s;
      part.where = where;
      std::vector<std::vector<MFraction>> all;
      for (const auto& vector : kernel_basis(where, kernel)) {
        all.emplace_back(space_.variables.size(), MFraction(space_.field.ring));
        for (const auto& [j, c] : vector)
          all.back()[j / numerators.size()] +=
              c * MFraction(numerators[j % numerators.size()]) / below;
      }
      if (take_fields(part, all)) look_for_fields(std::move(part), stage, denominator + 1);
    }
  }
  MFraction product(const State& s, std::size_t denominator) const {
    MFraction p(space_.field.ring, Rational(1));
    for (std::size_t i = 0; i < s.darboux.size(); ++i)
      if (denominator == i + 1 || denominator == s.darboux.size() + 1)
        p *= MFraction(s.darboux[i].polynomial);
    return p;
  }
  MFraction cofactor(const State& s, std::size_t denominator) const {
    MFraction k(space_.field.ring);
    for (std::size_t i = 0; i < s.darboux.size(); ++i)
      if (denominator == i + 1 || denominator == s.darboux.size() + 1) k += s.darboux[i].cofactor;
    return k;
  }

  // Takes the fields that are independent of the ones before and commute with them.  False: nothing
  // is left of the set.
  bool take_fields(State& s, const std::vector<std::vector<MFraction>>& all) {
    for (const auto& y : all) {
      if (is_integrable(s)) break;
      verify(s, y);
      if (!std::ranges::all_of(s.fields, [&](const auto& z) { return commute(s.where, y, z); }))
        continue;
      for (;;) {
        IndependentRows frame(space_);
        auto answer = frame.add(s.where, space_.field.components, options_.budget);
        for (const auto& z : s.fields)
          if (answer.taken) answer = frame.add(s.where, z, options_.budget);
        if (answer.taken) answer = frame.add(s.where, y, options_.budget);
        if (answer.taken) s.fields.push_back(y);
        if (!answer.split) break;
        if (const auto zero = s.where.where_zero(*answer.split); !zero.is_empty()) start(zero);
        s.where = s.where.where_nonzero(*answer.split);
        if (s.where.is_empty()) return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool commute(const ParameterSet& where, const std::vector<MFraction>& y,
                             const std::vector<MFraction>& z) const {
    const auto bracket = commutator(space_.field, y, z);
    return std::ranges::all_of(bracket,
                               [&](const MFraction& f) { return space_.vanishes(where, f); });
  }
  void verify(const State& s, const std::vector<MFraction>& y) const {
    KOV_ENSURE(commute(s.where, space_.field.components, y));
    for (const FoundIntegral& f : s.found) {
      const auto d = gradient(space_.field, f);
      MFraction along(space_.field.ring);
      for (std::size_t i = 0; i < d.size(); ++i)
        along += d[i] * y[i];
      KOV_ENSURE(space_.vanishes(s.where, along));
    }
  }

  // ---- brackets

  [[nodiscard]] bool may_combine(const State& s) const {
    return space_.field.poisson && s.commuting.size() < s.found.size() &&
           s.combined < progress(s) && !is_integrable(s);
  }
  static std::size_t progress(const State& s) { return s.found.size() + s.commuting.size(); }

  // Quadratic polynomials in the known integrals that commute with those that were chosen: they
  // take the place of integrals that do not (Lemma 1 of docs/theory/integrals.md).
  void combine(State s, std::size_t stage) {
    s.combined = progress(s);
    try {
      const Ansatz ansatz = quadratic_in(s);
      for_each_kernel(
          s.where, equations_of(space_, ansatz, fields_of_chosen(s), options_.budget),
          [&](const ParameterSet& where, const EchelonForm& done) {
            State part = s;
            part.where = where;
            const Candidates more = candidates(where, done, ansatz, false);
            if (more.empty()) return enter(std::move(part), stage);
            const Candidates all = commuting_first(part, more);
            part.found.clear();
            part.commuting.clear();
            part.gradients = IndependentRows(space_);
            take(std::move(part), all, stage);
          },
          options_.budget);
    } catch (const OutOfBudget& limit) {
      conclude(std::move(s), limit.what());
    }
  }

  // An ansatz of degree 1 and 2 in the known integrals, but for functions of those in involution.
  Ansatz quadratic_in(const State& s) const {
    std::vector<MFraction> known;
    for (const FoundIntegral& f : s.found)
      known.push_back(f.value);
    known.insert(known.end(), s.dependent.begin(), s.dependent.end());
    std::vector<MFraction> all;
    const auto is_chosen = [&](std::size_t i) { return is_among(i, s.commuting); };
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!is_chosen(i)) all.push_back(known[i]);
      for (std::size_t j = i; j < known.size(); ++j)
        if (!is_chosen(i) || !is_chosen(j)) all.push_back(known[i] * known[j]);
    }
    Ansatz ansatz{
        .numerators = {}, .denominator = MPoly(space_.field.ring, Integer(1)), .column = {}};
    for (const MFraction& f : all)
      ansatz.denominator =
          exact_div(ansatz.denominator * f.den(), gcd(ansatz.denominator, f.den()));
    for (const MFraction& f : all)
      ansatz.numerators.push_back((f * MFraction(ansatz.denominator)).num());
    return ansatz;
  }

  // Only some of the candidates, in involution: others of them, and sums, come when these are
  // chosen.
  Candidates commuting_first(const State& s, const Candidates& more) const {
    Candidates all;
    for (const std::size_t i : s.commuting)
      all.push_back(s.found[i]);
    for (const FoundIntegral& f : more)
      if (std::ranges::all_of(all, [&](const FoundIntegral& g) {
            return space_.vanishes(s.where, poisson_bracket(space_.field, f.value, g.value));
          }))
        all.push_back(f);
    for (std::size_t i = 0; i < s.found.size(); ++i)
      if (!is_among(i, s.commuting)) all.push_back(s.found[i]);
    return all;
  }

  // The equations, without the columns that known integrals allow to be left out.
  EchelonForm equations(const State& s, const Ansatz& ansatz, const Stage& stage) {
    const auto fields = stage.kind == Stage::Kind::casimirs ? bracket_fields(space_.field)
                                                            : fields_to_commute_with(s);
    EchelonForm e = equations_of(space_, ansatz, fields, options_.budget);
    EchelonForm known{e.columns, products(s, ansatz, stage.degree)};
    for (const std::size_t j : gauge_columns(s.where, std::move(known), options_.budget))
      e.rows.push_back({{j, MPoly(space_.field.ring, Integer(1))}});
    return e;
  }

  // The fields of the system and of the integrals that were chosen.
  std::vector<std::vector<MFraction>> fields_to_commute_with(const State& s) const {
    std::vector<std::vector<MFraction>> fields{space_.field.components};
    if (options_.until_integrable && space_.field.poisson)
      std::ranges::move(fields_of_chosen(s), std::back_inserter(fields));
    return fields;
  }
  // The fields of the chosen integrals, without those of Casimirs and of the Hamiltonian.
  std::vector<std::vector<MFraction>> fields_of_chosen(const State& s) const {
    std::vector<std::vector<MFraction>> fields;
    for (const std::size_t i : s.commuting)
      if (const FoundIntegral& f = s.found[i]; !f.casimir && !f.hamiltonian)
        fields.push_back(hamiltonian_field(space_.field, *space_.field.poisson, f.value));
    return fields;
  }

  // Products of known integrals inside the ansatz, and 1 where it is not a constant term there.
  std::vector<SparseRow> products(const State& s, const Ansatz& ansatz, long degree) const {
    std::vector<SparseRow> rows;
    const MFraction one(space_.field.ring, Rational(1));
    add_products(s, ansatz, 0, one, degree, rows);
    return rows;
  }
  void add_products(const State& s, const Ansatz& ansatz, std::size_t i, const MFraction& product,
                    long left, std::vector<SparseRow>& rows) const {
    if (rows.size() > 400) return;
    if (i == s.found.size()) {
      if (auto row = coordinates(space_, ansatz, product); row && !row->empty())
        rows.push_back(std::move(*row));
      return;
    }
    MFraction power = product;
    const long step = std::max(s.found[i].degree, 1L);
    for (long rest = left; rest >= 0; rest -= step) {
      add_products(s, ansatz, i + 1, power, rest, rows);
      if (rest >= step) power *= s.found[i].value;
    }
  }

  Candidates candidates(const ParameterSet& where, const EchelonForm& e, const Ansatz& ansatz,
                        bool casimirs) const {
    Candidates all;
    for (const auto& vector : kernel_basis(where, e)) {
      MPoly den(space_.field.ring, Integer(1));
      for (const auto& [j, x] : vector)
        den = exact_div(den * x.den(), gcd(den, x.den()));
      SparseRow row;
      for (const auto& [j, x] : vector)
        row.emplace(j, (x * MFraction(den)).num());
      MPoly sum(space_.field.ring);
      for (const auto& [j, c] : restricted(where, row))
        sum += c * ansatz.numerators[j];
      const MFraction value = shortest_form(space_.field, on_set(where, sum, ansatz.denominator));
      all.push_back({value, degree_in_momenta(value), casimirs});
    }
    std::ranges::stable_sort(all, [](const FoundIntegral& a, const FoundIntegral& b) {
      return std::pair(a.degree, a.value.num().length()) <
             std::pair(b.degree, b.value.num().length());
    });
    return all;
  }

  // num/den up to a constant, in the simplest form that the equations of the set allow.
  MFraction on_set(const ParameterSet& where, const MPoly& num, const MPoly& den) const {
    const MFraction below = where.restrict(den);
    if (is_zero(below)) return {num, den};
    const MFraction value = where.restrict(num) / below;
    const bool constant_below = std::ranges::none_of(
        space_.variables, [&](std::size_t v) { return degree(value.den(), v) > 0; });
    return constant_below ? MFraction(value.num()) : value;
  }

  // Takes the candidates that are independent of what is known; the parameters are split where that
  // depends on them.
  void take(State s, const Candidates& all, std::size_t stage) {
    try {
      for (const FoundIntegral& f : all) {
        verify(s.where, f);
        for (;;) {
          const auto answer = s.gradients.add(s.where, gradient(space_.field, f), options_.budget);
          if (answer.taken) add(s, f);
          if (!answer.taken && !answer.split && s.dependent.size() < most_dependent &&
              f.logarithms.empty())
            s.dependent.push_back(f.value);
          if (!answer.split) break;
          if (const auto zero = s.where.where_zero(*answer.split); !zero.is_empty()) {
            const Within within(options_.budget, part_of_the_work(options_.budget, 0.5));
            start(zero);
          }
          s.where = s.where.where_nonzero(*answer.split);
          if (s.where.is_empty()) return;
        }
      }
    } catch (const OutOfBudget& limit) {
      return conclude(std::move(s), limit.what());
    }
    enter(std::move(s), stage);
  }

  void add(State& s, const FoundIntegral& f) const {
    s.found.push_back(f);
    if (space_.field.poisson && commutes(s.where, s.found, s.commuting, f))
      s.commuting.push_back(s.found.size() - 1);
  }
  bool commutes(const ParameterSet& where, const std::vector<FoundIntegral>& all,
                const std::vector<std::size_t>& chosen, const FoundIntegral& f) const {
    return std::ranges::all_of(chosen, [&](std::size_t j) {
      return space_.vanishes(where, poisson_bracket(space_.field, f.value, all[j].value));
    });
  }

  // By the formulas of lib/system.
  void verify(const ParameterSet& where, const FoundIntegral& f) const {
    MFraction derivative = lie_derivative(space_.field, f.value);
    for (const LogarithmicTerm& t : f.logarithms)
      derivative += t.times * lie_derivative(space_.field, MFraction(t.of)) / MFraction(t.of);
    KOV_ENSURE(space_.vanishes(where, derivative));
    if (!f.casimir) return;
    for (const MFraction& x : hamiltonian_field(space_.field, *space_.field.poisson, f.value))
      KOV_ENSURE(space_.vanishes(where, x));
  }

  void conclude(State s, std::string open = {}) {
    IntegralsOfSet set;
    set.searched = searched();
    set.equations = s.where.equations();
    set.open = std::move(open);
    set.liouville = space_.field.poisson && is_liouville(s.where, s.found, s.commuting.size());
    set.integrals = std::move(s.found);
    set.commuting = std::move(s.commuting);
    set.fields = std::move(s.fields);
    if (set.commuting.size() > casimirs_of(set.integrals) + 1 && options_.until_integrable)
      set.searched += ", in involution with those found";
    set.only_declared_relations = !space_.is_polynomial_ring();
    const bool ended_early = options_.until_integrable && set.liouville;
    set.complete = set.open.empty() && space_.is_polynomial_ring() && !ended_early;
    set.complete_for_smooth = set.complete && natural_ && natural_->polynomial && !coefficients_;
    try {
      set.inequations = s.where.proper_inequations();
      if (space_.field.poisson && !set.liouville) find_commuting(s.where, set);
    } catch (const OutOfBudget& limit) {
      if (set.inequations.empty()) set.inequations = s.where.inequations();
      if (set.open.empty()) set.open = limit.what();
    }
    result_.sets.push_back(std::move(set));
  }

  // The first set that the order of discovery gives, with the Hamiltonian in it.
  void find_commuting(const ParameterSet& where, IntegralsOfSet& set) const {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < set.integrals.size(); ++i)
      if (commutes(where, set.integrals, chosen, set.integrals[i])) chosen.push_back(i);
    if (chosen.size() < set.commuting.size()) return;
    set.commuting = std::move(chosen);
    set.liouville = is_liouville(where, set.integrals, set.commuting.size());
  }

  static std::size_t casimirs_of(const std::vector<FoundIntegral>& all) {
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [](const FoundIntegral& f) { return f.casimir; }));
  }
  bool is_liouville(const ParameterSet& where, const std::vector<FoundIntegral>& all,
                    std::size_t commuting) const {
    const std::size_t casimirs = casimirs_of(all);
    const std::size_t leaf = space_.field.dimension() - casimirs;
    return leaf % 2 == 0 && commuting == casimirs + leaf / 2 && bracket_has_rank(where, leaf);
  }
  // Is the set integrable in the sense of the option?
  bool is_integrable(const State& s) const {
    return space_.field.poisson ? is_liouville(s.where, s.found, s.commuting.size())
                                : s.found.size() + s.fields.size() + 1 >= space_.field.dimension();
  }
  bool has_all_casimirs(const State& s) const {
    return bracket_has_rank(s.where, space_.field.dimension() - casimirs_of(s.found));
  }

  bool bracket_has_rank(const ParameterSet& where, std::size_t rank) const {
    if (mechanical_) return true;
    IndependentRows rows(space_);
    for (const auto& row : *space_.field.poisson)
      static_cast<void>(rows.add(where, row, options_.budget));
    return rows.size() == rank;
  }

  long degree_in_momenta(const MFraction& f) const {
    const MPoly num = f.num();
    unsigned long degree = 0;
    for (long t = 0; t < num.length(); ++t) {
      const auto e = num.exponents(t);
      unsigned long here = 0;
      for (std::size_t i = 0; i < space_.variables.size(); ++i)
        if (!mechanical_ || space_.momentum[i]) here += e[space_.variables[i]];
      degree = std::max(degree, here);
    }
    return static_cast<long>(degree);
  }

  IntegralOptions options_;
  PhaseSpace space_;
  std::optional<NaturalHamiltonian> natural_;
  std::optional<long> coefficients_; ///< of the highest degree, on the part that is looked at
  bool layered_ = false;             ///< the ansatz, on that part
  bool bounded_ = false;             ///< by a theorem, where that leaves a small ansatz
  bool mechanical_;
  std::optional<PolynomialField> polynomial_ = {}; ///< if Darboux polynomials are looked for
  std::size_t splits_ = 0;                         ///< for these
  std::vector<Stage> stages_;
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

namespace {

// "+ c*x" after other terms; c*1 is c.
void add_term(std::string& text, const MFraction& c, const std::string& x) {
  const bool minus = c.num().length() == 1 && to_string(c).front() == '-';
  const MFraction size = minus ? -c : c;
  std::string factor = is_one(size) ? "" : to_string(size);
  if (factor.find_first_of("+-/ ") != std::string::npos) factor = "(" + factor + ")";
  const std::string sign = minus ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
  text += sign + factor + (factor.empty() ? "" : "*") + x;
}

// Products of powers as such.
std::string short_text(const MFraction& f) {
  const std::string plain = to_string(f);
  const std::string factored = to_factored_string(f);
  return 2 * factored.size() < plain.size() ? factored : plain;
}

} // namespace

MFraction shortest_form(const VectorField& v, const MFraction& f) {
  const auto size = [](const MFraction& g) { return g.num().length() + g.den().length(); };
  MFraction best = f;
  for (const MPoly& relation : v.relations)
    for (const FunctionSymbol& x : v.functions) {
      if (degree(relation, x.variable) != 2) continue;
      const std::vector<MPoly> r = coefficients(relation, x.variable);
      if (!is_constant(r[2]) || !is_zero(r[1])) continue;
      const MFraction square = MFraction(-r[0]) / MFraction(r[2]);
      const auto lowered = [&](const MPoly& p) {
        const std::vector<MPoly> c = coefficients(p, x.variable);
        MFraction sum(p.ring());
        for (std::size_t i = 0; i < c.size(); ++i)
          sum += MFraction(c[i]) * pow(square, static_cast<long>(i / 2)) *
                 pow(MFraction::variable(p.ring(), x.variable), static_cast<long>(i % 2));
        return sum;
      };
      const MFraction below = lowered(best.den());
      if (is_zero(below)) continue;
      const MFraction g = lowered(best.num()) / below;
      if (is_zero(g)) return g;
      if (size(g) < size(best)) best = sign(g.num().coefficient(0)) < 0 ? -g : g;
    }
  return best;
}

std::string to_string(const FoundIntegral& f) {
  if (f.logarithms.empty()) return short_text(f.value);
  std::string text = is_zero(f.value) ? "" : to_string(f.value);
  for (const LogarithmicTerm& t : f.logarithms)
    add_term(text, t.times, "log(" + to_string(t.of) + ")");
  return text;
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

std::string field_text(const VectorField& v, const std::vector<MFraction>& field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!is_zero(field[i])) add_term(text, field[i], "d/d" + v.name(i));
  return text;
}

bool IntegralSearch::finished() const {
  return std::ranges::all_of(sets, [](const IntegralsOfSet& s) { return s.open.empty(); });
}

IntegralSearch find_integrals(const System& s, const IntegralOptions& options) {
  return Search(s, options).run();
}

std::string searched_class(const System& s, const IntegralOptions& options) {
  return Search(s, options).generic_class();
}

} // namespace kov
