#include "classify/variables.hpp"

#include "classify/shares.hpp"
#include "decide/afterwards.hpp"
#include "exact/joined.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"
#include "moves/axes.hpp"
#include "study/pieces.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <tuple>

namespace kov {

bool decides_something(const SystemClassification& c) {
  return c.almost_all || std::ranges::any_of(c.strata, [](const ClassifiedStratum& s) {
           return s.status != StratumStatus::open;
         });
}

namespace {

constexpr std::size_t longest_integral = 200; // as text, in the user's variables

bool is_open(const ClassifiedStratum& s) { return s.status == StratumStatus::open; }

bool has_open(const SystemClassification& c) { return std::ranges::any_of(c.strata, is_open); }
// The larger the sets that are open, and the more they are, the worse.
bool is_better(const SystemClassification& a, const SystemClassification& b) {
  const auto openness = [](const SystemClassification& c) {
    std::pair<long, std::size_t> largest{std::numeric_limits<long>::min(), 0};
    for (const ClassifiedStratum& s : c.strata)
      if (is_open(s)) {
        const long size =
            -static_cast<long>(s.where.equations().size() + s.where.statements().size());
        largest = {std::max(largest.first, size), largest.second + 1};
      }
    return std::tuple(largest.first, !c.almost_all, largest.second);
  };
  return openness(a) < openness(b);
}

/// One question after the other, each in its variables; the best answer so far is told.
class InTurn {
public:
  InTurn(const System& s, const ClassifyOptions& options, const StatedSolutions& stated,
         const CanonicalChange& change)
      : s_(s), options_(options), stated_(stated), change_(change) {}

  SystemClassification run() {
    static_cast<void>(attempt([&] { return here(share::here_first); }) ||
                      attempt([&] { return there(share::there); }) ||
                      attempt([&] { return here(1); }));
    if (!best_) std::rethrow_exception(first_);
    if (error_ && !decides_something(*best_)) std::rethrow_exception(error_);
    if (!limit_.empty() && has_open(*best_))
      best_->notes.push_back({ClassificationNote::What::limit, limit_});
    return *std::move(best_);
  }

private:
  bool attempt(const std::function<SystemClassification()>& study) {
    try {
      return answered(study());
    } catch (const Contradiction&) {
      throw;
    } catch (const OutOfBudget& limit) {
      limit_ = limit.what();
      if (!first_) first_ = std::current_exception();
    } catch (const Error& error) {
      limit_ = failure_of("the study in one choice of variables", error.what());
      error_ = std::current_exception();
      if (!first_) first_ = error_;
    }
    return false;
  }

  [[nodiscard]] ClassifyOptions options(double part) const {
    ClassifyOptions all = options_;
    all.check.decide.budget = part_of_the_work(options_.check.decide.budget, part);
    return all;
  }

  SystemClassification here(double part) {
    ClassifyOptions all = options(part);
    if (options_.so_far) all.so_far = [&](const SystemClassification& c) { tell(c); };
    return classify_in_these_variables(s_, all, stated_);
  }

  SystemClassification there(double part) {
    ClassifyOptions all = options(part);
    if (options_.so_far)
      all.so_far = [&](const SystemClassification& c) { tell(said_of_the_old(c, s_, change_)); };
    return said_of_the_old(classify_in_these_variables(change_.system, all, {}), s_, change_);
  }

  // True: nothing is open any more.
  bool answered(SystemClassification c) {
    const double seconds = c.seconds + (best_ ? best_->seconds : 0);
    if (!best_ || is_better(c, *best_)) best_ = std::move(c);
    best_->seconds = seconds;
    return !has_open(*best_);
  }

  void tell(const SystemClassification& c) const {
    if (!best_ || is_better(c, *best_)) return options_.so_far(c);
    SystemClassification told = *best_;
    told.at_work = c.at_work;
    options_.so_far(told);
  }

  const System& s_;
  const ClassifyOptions& options_;
  const StatedSolutions& stated_;
  const CanonicalChange& change_;
  std::optional<SystemClassification> best_;
  std::string limit_;        ///< or error of the program, the last one
  std::exception_ptr first_; ///< of both; the answer, where there is no other
  std::exception_ptr error_; ///< of the program; the answer, where nothing is proved
};

FoundIntegral in_old(const FoundIntegral& f, const System& old, const CanonicalChange& change) {
  FoundIntegral g = f;
  g.value = f.hamiltonian ? *old.field.hamiltonian : in_old_variables(change, old.ring(), f.value);
  g.logarithms.clear();
  for (const LogarithmicTerm& t : f.logarithms) {
    const MFraction of = in_old_variables(change, old.ring(), MFraction(t.of));
    const MFraction times = in_old_variables(change, old.ring(), t.times);
    g.logarithms.push_back({times, of.num()});
    if (!is_constant(MFraction(of.den()))) g.logarithms.push_back({-times, of.den()});
  }
  if (!g.hamiltonian && g.logarithms.empty()) g.value = shortest_form(old.field, g.value);
  return g;
}

// Each new variable is a linear combination of the old ones, with rational numbers, and a constant.
bool is_affine(const System& old, const CanonicalChange& change) {
  const auto main = old.field.main_variables();
  return change.functions.empty() && std::ranges::all_of(change.variables, [&](const MFraction& f) {
           return std::ranges::all_of(main,
                                      [&](std::size_t i) { return is_constant(derivative(f, i)); });
         });
}
bool is_linear_at(const System& old, const MFraction& f) {
  Substitution origin;
  for (const std::size_t i : old.field.coordinates)
    origin[i] = MFraction(old.ring());
  return is_zero(substitute(f, origin));
}

// The same set of solutions.
ManifoldSpec in_old(ManifoldSpec m, const System& old, const CanonicalChange& change) {
  const VectorField& now = change.system.field;
  const auto moved = [&](const MFraction& f) {
    auto names = old.ring()->names();
    for (const std::string& name : f.ring()->names()) // levels
      if (!old.ring()->find(name) && std::ranges::none_of(now.coordinates, [&](std::size_t i) {
            return now.ring->name(i) == name;
          }))
        names.push_back(name);
    const Ring ring = make_ring(names);
    return in_old_variables(change, ring, f);
  };
  for (Equation& e : m.equations) {
    const MPoly f = moved(e.difference).num();
    e = {MFraction(f), to_string(f) + " = 0"};
  }
  for (Equation& e : m.levels)
    e.difference = moved(e.difference);
  for (MPoly& f : m.nonzero)
    f = moved(MFraction(f)).num();
  m.name = joined(m.equations, &Equation::text);
  return m;
}

void tell_variables(const CanonicalChange& change, const System& old, bool has_integrals,
                    SystemClassification& c) {
  c.variables = in_words(change);
  const std::string all = joined(c.variables);
  const bool affine = is_affine(old, change);
  const bool linear = affine && std::ranges::all_of(change.variables, [&](const MFraction& f) {
                        return is_linear_at(old, f);
                      });
  // Meromorphic functions of the new variables are those of the old ones.
  const auto tell = [&](IntegralClass& said) {
    const bool has_names =
        !said.functions.empty() || !said.without.empty() || !said.through.empty();
    const bool moves =
        said.kind == IntegralClass::Kind::real_analytic || said.near == IntegralClass::Near::origin;
    if (!affine || has_names || (moves && !linear)) said.frame = all;
  };
  std::ranges::for_each(c.excluded, tell);
  c.are_curves_old = affine && has_integrals;
  const auto shared = std::make_shared<const CanonicalChange>(change);
  for (ClassifiedStratum& s : c.strata) {
    for (ExclusionReason& by : s.by)
      tell(by.integrals);
    if (!c.are_curves_old || !s.along) continue;
    s.along = in_old(*s.along, old, change);
    if (s.from) s.change = shared;
  }
  if (c.almost_all) tell(c.almost_all->by.integrals);
}

} // namespace

SystemClassification said_of_the_old(SystemClassification c, const System& old,
                                     const CanonicalChange& change) {
  auto strata = c.strata;
  bool is_short = true, integrable = true;
  for (ClassifiedStratum& s : strata) {
    integrable = integrable && s.status == StratumStatus::integrable;
    for (FoundIntegral& f : s.integrals) {
      f = in_old(f, old, change);
      is_short = is_short && (f.hamiltonian || to_string(f).size() <= longest_integral);
    }
  }
  if (is_short) c.strata = std::move(strata);
  if (is_short && integrable) return c;
  tell_variables(change, old, is_short, c);
  return c;
}

namespace {

// No denominator that the file does not have may vanish at special parameters: there the change would
// say nothing.  Nor a radicand.
bool is_defined_for_all_parameters(const System& s, const CanonicalChange& change) {
  std::vector<MPoly> all;
  for (const MFraction& f : change.variables)
    all.push_back(f.den());
  for (const auto& [i, value] : change.functions)
    all.push_back(value.den());
  const VectorField& now = change.system.field;
  std::ranges::copy(denominators(now), std::back_inserter(all));
  for (const MPoly& r : now.relations)
    for (const FunctionSymbol& f : now.functions)
      if (change.functions.contains(f.variable) && uses(r, f.variable))
        all.push_back(coefficients(r, f.variable).front());
  const auto known = denominators(s.field);
  const auto is_known = [&](const MPoly& f) {
    const auto used = used_variables(f);
    if (!std::ranges::all_of(
            used, [&](std::size_t i) { return s.ring()->find(f.ring()->name(i)).has_value(); }))
      return false;
    const MPoly here = transfer(MFraction(f), s.ring()).num();
    return std::ranges::any_of(known, [&](const MPoly& k) { return divides(here, k).has_value(); });
  };
  for (const MPoly& d : all)
    for (const MFactor& f : factor(d).second)
      if (!is_known(f.base) &&
          may_vanish_identically(d.ring() == now.ring ? change.system : s, f.base))
        return false;
  return true;
}

std::optional<CanonicalChange> simpler(const System& s, const Budget& budget) {
  if (s.kind == SystemKind::hamiltonian) return simplified(s, budget);
  return tried<OutOfBudget>([&] { return on_principal_axes(s, budget); }); // else unchanged
}

SystemClassification classified(const System& s, const ClassifyOptions& options) {
  const StatedSolutions stated = stated_solutions(s, options);
  std::optional<CanonicalChange> change;
  if (options.change_variables && options.search_solutions && !stated.decided)
    change = simpler(s, part_of_the_work(options.check.decide.budget, share::change));
  if (!change || !is_defined_for_all_parameters(s, *change))
    return classify_in_these_variables(s, options, stated);
  return InTurn(s, options, stated, *change).run();
}

// A limit that falls before the first stage.
SystemClassification all_open(const System& s, const std::string& limit) {
  SystemClassification c = nothing_known(s);
  leave_open({all_parameters(s, level_parameters(s), {}, c), {}}, c);
  finish(s, c);
  c.notes.push_back({ClassificationNote::What::rest_is_open, limit});
  return c;
}

} // namespace

SystemClassification classify_system(const System& s, const ClassifyOptions& options) {
  SystemClassification c;
  try {
    c = classified(with_signs_that_follow(s), options);
  } catch (const OutOfBudget& limit) {
    c = all_open(s, limit.what());
  }
  const bool is_decided =
      std::ranges::none_of(c.strata, [](const auto& x) { return x.status == StratumStatus::open; });
  c.complete = is_decided || !options.check.decide.budget.is_cut_short();
  if (!c.complete) c.notes.push_back({ClassificationNote::What::clock});
  return c;
}

} // namespace kov
