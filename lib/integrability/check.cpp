#include "integrability/check.hpp"
#include "integrability/parameters.hpp"
#include "manifold/existence.hpp"
#include "variation/whole.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "strata/words.hpp"
#include "verdict/words.hpp"

#include <algorithm>
#include <chrono>

namespace kov {

std::string to_string(VerdictKind v) {
  return v == VerdictKind::non_integrable   ? "non-integrable"
         : v == VerdictKind::no_obstruction ? "no-obstruction"
         : v == VerdictKind::depends        ? "depends"
                                            : "undecided";
}

std::string first_integral_class(const RationalFunction& r) {
  bool irregular = !is_zero(r) && order_at_infinity(r) < 2;
  if (!is_zero(r) && degree(r.den()) > 0)
    for (const auto& f : squarefree_factors(r.den()))
      if (f.exponent > 2) irregular = true;
  return irregular ? "meromorphic also at the points at infinity of the phase curve"
                   : "meromorphic";
}

namespace {

const ReduceSpec* reduction_for(const System& s, const std::string& manifold) {
  for (const auto& r : s.reductions)
    if (r.manifold.empty() || r.manifold == manifold) return &r;
  return nullptr;
}

std::vector<SystemClaim> usable_integrals(const System& s, const std::vector<ClaimReport>& claims) {
  std::vector<SystemClaim> all;
  for (const auto& c : claims)
    if (c.result.proved && c.claim.on.empty() &&
        (c.claim.kind == SystemClaim::Kind::casimir || c.claim.kind == SystemClaim::Kind::integral))
      all.push_back(c.claim);
  if (s.field.hamiltonian) {
    SystemClaim h;
    h.name = "H";
    h.value = *s.field.hamiltonian;
    all.push_back(std::move(h));
  }
  return all;
}

/// Tries changes of variable for every cyclic vector and keeps the equation with the fewest
/// singular places.
class ChangeSearch {
public:
  ChangeSearch(const System& s, const InvariantManifold& m, const Budget& budget,
               BlockReport& block)
      : s_(s), m_(m), budget_(budget), block_(block) {
    for (const auto& e : block.scalar)
      divisors_.insert(divisors_.end(), e.divisors.begin(), e.divisors.end());
  }

  void given(const MFraction& phi) {
    attempt(phi);
    if (!block_.ode && better_)
      failures_ += "; the change z = " + to_string(*better_) + " would do";
    finish();
  }
  void proposed(const std::vector<MFraction>& changes) {
    for (const auto& phi : changes) {
      better_.reset();
      attempt(phi);
      if (better_ && !block_.ode) attempt(*better_);
    }
    finish();
  }

private:
  // A limit is one of this change: others may be easier.
  void attempt(const MFraction& phi) {
    budget_.check();
    try {
      find_equations(phi);
    } catch (const OutOfBudget& limit) {
      note({"z = " + to_string(phi) + ": " + limit.what()});
    }
  }
  void find_equations(const MFraction& phi) {
    // a map of much higher degree than one that works brings more singular places
    const auto field =
        FunctionField::make(s_.field, m_, s_.z, phi, divisors_, budget_, 2 * smallest_);
    if (const auto* failure = std::get_if<ChangeFailure>(&field)) return note(*failure);
    for (const auto& e : block_.scalar) {
      auto result = algebraize(std::get<FunctionField>(field), s_.z, phi, e);
      if (const auto* failure = std::get_if<ChangeFailure>(&result)) {
        note(*failure);
        continue;
      }
      auto& ode = std::get<AlgebraicOde>(result);
      smallest_ = std::min(smallest_, std::get<FunctionField>(field).algebra().dimension());
      if (!block_.ode || ode.singular_places < block_.ode->singular_places)
        block_.ode = std::move(ode);
    }
  }
  void note(const ChangeFailure& failure) {
    failures_ += (failures_.empty() ? "" : "; ") + failure.message;
    if (failure.better) better_ = failure.better;
  }
  void finish() {
    if (block_.ode) return;
    block_.note = failures_.empty() ? "no change of variable was found" : failures_;
    const auto factors = factors_on_components(m_);
    if (factors.empty()) return;
    std::string product;
    for (const MPoly& f : factors)
      product += (product.empty() ? "(" : "*(") + to_string(f) + ")";
    block_.note =
        "the phase curve has several components, " + product +
        " = 0 on it: study one of them, with one factor = 0 among the equations; on all " +
        "together " + block_.note;
  }

  const System& s_;
  const InvariantManifold& m_;
  const Budget& budget_;
  BlockReport& block_;
  std::vector<MPoly> divisors_;
  std::string failures_;
  std::optional<MFraction> better_;
  std::size_t smallest_ = 100;
};

std::string parameter_names(const MFraction& f, const System& s) {
  std::string names;
  for (const std::size_t i : used_variables(f))
    if (std::find(s.field.parameters.begin(), s.field.parameters.end(), i) !=
        s.field.parameters.end())
      names += (names.empty() ? "" : ", ") + s.ring()->name(i);
  return names;
}

void decide_parameters(const System& s, const CheckOptions& options, BlockReport& block) {
  block.strata =
      strata::decide_strata(strata_question(s, *block.ode), strata_limits(s, *block.ode, options));
  block.abelian = block.strata->abelian();
}

// r has no parameters, but what was divided by on the way has: the answer holds where that is not
// 0.
void except_where_invalid(const System& s, const CheckOptions& options, BlockReport& block) {
  const AlgebraicOde& ode = *block.ode;
  const Truth generic = block.decision->abelian;
  if (s.field.parameters.empty() || ode.generic.empty()) return void(block.abelian = generic);
  if (s.field.constants.empty()) {
    decide_parameters(s, options, block);
    const auto& all = block.strata->strata;
    if (all.size() == 1 && !all.front().leaf.no_equation() && block.strata->unvisited.empty()) {
      block.strata.reset(); // valid for all parameters
      block.abelian = block.decision->abelian;
    } else {
      block.decision.reset();
    }
    return;
  }
  for (const MPoly& g : ode.generic)
    for (const std::size_t i : s.field.parameters)
      if (uses(g, i)) {
        block.abelian = Truth::unknown;
        block.note =
            "decided only where " + to_string(g) + " is not zero: " + reason(*block.decision);
        return;
      }
  block.abelian = generic;
}

// one_level: one value of the energy is enough, energies.cpp looks for it
void decide_block(const System& s, const CheckOptions& options, bool one_level,
                  BlockReport& block) {
  const AlgebraicOde& ode = *block.ode;
  const std::string names = parameter_names(ode.r, s);
  if (!names.empty()) {
    if (options.stop_at_r)
      block.note = "r depends on the parameter(s) " + names +
                   "; give values with --set to decide single equations";
    else if (!one_level)
      decide_parameters(s, options, block);
    return;
  }
  const ConstantField constants = ConstantField::make(s.field);
  NormalForm equation;
  equation.r = constants.convert(ode.r, ode.z);
  if (ode.p && parameter_names(*ode.p, s).empty() && parameter_names(*ode.q, s).empty()) {
    equation.p = constants.convert(*ode.p, ode.z);
    const NormalForm again = normal_form(equation.p, constants.convert(*ode.q, ode.z));
    KOV_ENSURE(again.r == equation.r); // two ways to r
  }
  block.equation = equation;
  if (options.stop_at_r) return;
  Options how = options.decide;
  how.variable = s.ring()->name(ode.z);
  block.decision = decide(equation, how);
  block.abelian = Truth::unknown; // until the exceptions are known, should a limit end that search
  except_where_invalid(s, options, block);
}

/// The diagonal blocks; two of order 1 that are coupled with each other and with nothing else are
/// studied together, because a triangular system of order 2 may have a non-abelian group.
std::vector<std::vector<std::size_t>> blocks_to_study(const LinearSystem& r,
                                                      const InvariantManifold& m) {
  auto parts = blocks(r, m);
  const auto coupled = [&](std::size_t i, std::size_t j) {
    return !m.vanishes_on_curve(r.a[i][j]) || !m.vanishes_on_curve(r.a[j][i]);
  };
  const auto neighbours = [&](std::size_t i) {
    std::vector<std::size_t> all;
    for (std::size_t j = 0; j < r.a.size(); ++j)
      if (j != i && coupled(i, j)) all.push_back(j);
    return all;
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].size() != 1) continue;
    const auto mine = neighbours(parts[k][0]);
    if (mine.size() != 1 || neighbours(mine[0]) != parts[k]) continue;
    const auto other = std::find(parts.begin(), parts.end(), mine);
    if (other == parts.end()) continue;
    parts[k] = {std::min(parts[k][0], mine[0]), std::max(parts[k][0], mine[0])};
    parts.erase(other);
    k = 0;
  }
  return parts;
}

Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::unknown;
}

} // namespace

// energies.cpp
void study_energies(const System& s, const ManifoldSpec& spec, const ReduceSpec& reduce,
                    const std::vector<ClaimReport>& claims, const CheckOptions& options,
                    const std::vector<BlockReport>& generic, BlockReport& block);

namespace {

void study_block(const System& s, const InvariantManifold& m, const LinearSystem& reduced,
                 const std::vector<MPoly>& divisors, const std::vector<std::size_t>& members,
                 const CheckOptions& options, BlockReport& block) {
  for (const std::size_t i : members)
    block.unknowns.push_back(reduced.names[i]);
  if (members.size() == 1) {
    block.abelian = Truth::yes; // a first-order equation: its group is in the multiplicative group
    return;
  }
  if (members.size() > 2) {
    block.note = "a normal block of order " + std::to_string(members.size()) +
                 ": not reducible to second order by the invariant manifold, linear first "
                 "integrals or block structure";
    return;
  }
  const ReduceSpec* reduce = reduction_for(s, m.name);
  // The unknown asked for, if it is a cyclic vector; otherwise whatever is one.
  const std::string wish = reduce && reduce->unknown ? s.ring()->name(*reduce->unknown) : "";
  for (const bool wished : {true, false})
    for (const std::size_t i : members)
      if ((reduced.names[i] == wish) == wished)
        if (auto e = scalar_equation(s.field, m, reduced, members, i))
          if (block.scalar.empty() || block.scalar.front().unknown != wish)
            block.scalar.push_back(*std::move(e));
  KOV_ENSURE(!block.scalar.empty()); // the block is coupled
  for (auto& e : block.scalar)       // what was divided by before, too
    for (const auto& d : divisors)
      if (std::find(e.divisors.begin(), e.divisors.end(), d) == e.divisors.end())
        e.divisors.push_back(d);
  ChangeSearch search(s, m, options.decide.budget, block);
  if (reduce && reduce->change)
    search.given(*reduce->change);
  else
    search.proposed(propose_changes(s.field, m));
  if (!block.ode) return;
  for (const auto& g : m.curve->inverted())
    block.ode->generic.push_back(g);
  decide_block(s, options, reduce && reduce->energy == "auto", block);
}

// A limit leaves this block as it is, and the others are studied.
template <class Study> void within_limits(BlockReport& block, Study study) {
  try {
    study();
  } catch (const OutOfBudget& limit) {
    block.note += (block.note.empty() ? "" : "; ") + std::string(limit.what());
  }
}

// "Not abelian" of a block needs no knowledge of the rest.
WholeVariation coupling(const System& s, const ManifoldReport& report,
                        const std::vector<std::vector<std::size_t>>& parts) {
  try {
    return whole_variation(s.field, *report.manifold, report.normal, report.reduced, parts);
  } catch (const OutOfBudget& limit) {
    return {std::string("what couples the blocks was not studied: ") + limit.what(), {}};
  }
}

std::vector<const strata::StrataAnswer*> strata_of(const BlockReport& block) {
  std::vector<const strata::StrataAnswer*> all;
  if (block.strata) all.push_back(&*block.strata);
  for (const auto& e : block.energies)
    if (e.strata) all.push_back(&*e.strata);
  return all;
}

bool on_all_strata(const BlockReport& block) {
  return block.abelian != Truth::unknown || (block.strata && block.strata->decided());
}

/// A level on each of whose strata the block is decided.
const EnergyResult* deciding_level(const BlockReport& block) {
  const auto e = std::find_if(block.energies.begin(), block.energies.end(), [](const auto& x) {
    return x.strata && x.strata->decided() && somewhere_not_abelian(*x.strata);
  });
  return e == block.energies.end() ? nullptr : &*e;
}

/// Every block is decided, as a whole or on each of its strata (for one choice of the level).
bool by_strata(const ManifoldReport& report) {
  return std::all_of(report.blocks.begin(), report.blocks.end(), [](const BlockReport& block) {
    return on_all_strata(block) || deciding_level(block);
  });
}

std::string decided_where(const ManifoldReport& report) {
  std::string levels;
  for (const auto& block : report.blocks)
    if (!on_all_strata(block))
      levels += (levels.empty() ? " of the level " : ", ") + deciding_level(block)->condition;
  return "decided on every stratum" + levels;
}

void conclude(const System& s, const CheckOptions& options, ManifoldReport& report) {
  Truth all = Truth::yes;
  for (const auto& block : report.blocks) {
    all = both(all, block.abelian);
    std::string name;
    for (const auto& u : block.unknowns)
      name += (name.empty() ? "" : ", ") + u;
    if (!block.note.empty()) report.reasons.push_back("block (" + name + "): " + block.note);
    if (block.decision)
      report.reasons.push_back("block (" + name + "): " + reason(*block.decision));
    if (block.strata)
      for (const auto& x : block.strata->strata)
        report.reasons.push_back("where " + strata::to_string(x.conditions) + ": " + strata::reason(x.leaf));
    for (const auto& e : block.energies)
      if (e.decision) report.reasons.push_back("at " + e.condition + ": " + reason(*e.decision));
  }
  if (options.stop_at_r) return;
  const bool whole = report.not_studied.empty();
  report.verdict = all == Truth::no             ? VerdictKind::non_integrable
                   : whole && all == Truth::yes ? VerdictKind::no_obstruction
                   : whole && by_strata(report) ? VerdictKind::depends
                                                : VerdictKind::undecided;
  if (!whole && report.verdict == VerdictKind::undecided)
    report.reasons.push_back("an abelian identity component of every block decides nothing here: " +
                             report.not_studied);
  if (report.verdict == VerdictKind::depends) report.statement = decided_where(report);
  report.theorem = s.field.poisson ? "Morales-Ramis" : "Ayoul-Zung";
  report.function_class = "meromorphic";
  for (const auto& block : report.blocks) {
    if (block.equation && block.abelian == Truth::no)
      report.function_class = first_integral_class(block.equation->r);
    for (const auto& e : block.energies)
      if (e.r && e.decision && e.decision->abelian == Truth::no)
        report.function_class = first_integral_class(*e.r);
    for (const auto* answer : strata_of(block))
      for (const auto& x : answer->strata)
        if (x.leaf.abelian == Truth::no && strata::has_irregular_place(x.leaf))
          report.function_class = "meromorphic also at the points at infinity of the phase curve";
  }
  if (report.verdict != VerdictKind::non_integrable) return;
  std::string functions; // the class speaks of the variables of the file
  for (const auto& f : s.field.functions)
    functions += (functions.empty() ? "" : ", ") + s.ring()->name(f.variable);
  if (!functions.empty()) report.function_class += " (in the coordinates and " + functions + ")";
  report.statement =
      s.field.poisson
          ? "not integrable in Liouville's sense with first integrals that are " +
                report.function_class
          : "not integrable with first integrals and commuting vector fields that are " +
                report.function_class;
}

/// For some parameters that the file admits all coefficients of d may be 0.
bool may_vanish_identically(const System& s, const MPoly& d) {
  std::vector<MPoly> parts{d};
  for (const std::size_t i : s.field.main_variables()) {
    std::vector<MPoly> finer;
    for (const auto& p : parts)
      for (auto& c : coefficients(p, i))
        if (!is_zero(c)) finer.push_back(std::move(c));
    parts = std::move(finer);
  }
  return not_excluded(s, parts).size() == parts.size();
}

} // namespace

ManifoldReport check_manifold(const System& s, const ManifoldSpec& spec,
                              const std::vector<ClaimReport>& claims, const CheckOptions& options) {
  ManifoldReport report;
  report.name = spec.name;
  try {
    auto proved = prove_invariant(s.field, spec, options.decide.budget);
    if (auto* failure = std::get_if<ManifoldFailure>(&proved)) {
      report.failure = *failure;
      report.reasons.push_back(failure->message);
      return report;
    }
    report.manifold = std::get<InvariantManifold>(std::move(proved));
    const InvariantManifold& m = *report.manifold;
    if (const std::string functions = unchecked_functions(s.field, m); !functions.empty())
      report.not_checked = "that the phase curve has points for the functions meant by " +
                           functions + ": only their derivatives and relations are known";
    report.variational = variational_equations(s.field, m);
    report.variational_blocks = blocks(report.variational, m);
    report.normal = normal_system(s.field, m, usable_integrals(s, claims));
    const ReduceSpec* reduce = reduction_for(s, m.name);
    std::vector<std::string> keep;
    if (reduce && reduce->unknown) keep.push_back(s.ring()->name(*reduce->unknown));
    report.reduced = reduce_by_integrals(s.field, m, report.normal, keep);
    auto divisors = report.reduced.divisors;
    for (const auto& c : claims) // where the proofs of the integrals that were used hold
      if (c.result.proved && c.claim.on.empty() &&
          (c.claim.kind == SystemClaim::Kind::casimir ||
           c.claim.kind == SystemClaim::Kind::integral))
        divisors.insert(divisors.end(), c.result.generic.begin(), c.result.generic.end());
    const auto parts = blocks_to_study(report.reduced.system, m);
    auto whole = coupling(s, report, parts);
    report.not_studied = std::move(whole.missing);
    divisors.insert(divisors.end(), whole.divisors.begin(), whole.divisors.end());
    for (const auto& members : parts) {
      report.blocks.emplace_back();
      within_limits(report.blocks.back(), [&] {
        study_block(s, m, report.reduced.system, divisors, members, options, report.blocks.back());
      });
    }
    if (reduce && reduce->energy == "auto")
      for (auto& block : report.blocks)
        if (block.ode)
          within_limits(block, [&] {
            study_energies(s, spec, *reduce, claims, options, report.blocks, block);
          });
    for (auto& block : report.blocks) {
      if (block.strata) {
        decide_special_strata(s, spec, claims, options, report.blocks, block.unknowns,
                              *block.strata);
        block.abelian =
            some_level_is_not_abelian(s, *block.strata) ? Truth::no : block.strata->abelian();
      }
    }
    if (std::none_of(report.blocks.begin(), report.blocks.end(),
                     [](const BlockReport& b) { return b.ode.has_value(); }))
      for (const MPoly& d : whole.divisors) // nothing else asks where they vanish
        if (may_vanish_identically(s, d))
          report.not_studied =
              "the parameters for which " + to_string(d) + " is zero were not studied";
    conclude(s, options, report);
  } catch (const OutOfBudget& e) {
    report.reasons.emplace_back(e.what());
  } catch (const DomainError& e) {
    report.reasons.emplace_back(e.what());
  } catch (const InvalidArgument& e) {
    report.reasons.emplace_back(e.what());
  }
  return report;
}

std::vector<std::string> trusted_steps(const ManifoldReport& m) {
  std::vector<std::string> all;
  const auto add = [&](const std::string& step) {
    if (std::find(all.begin(), all.end(), step) == all.end()) all.push_back(step);
  };
  for (const BlockReport& b : m.blocks) {
    if (b.ode) add("the way from the system to r(z), along the manifold " + m.name);
    for (const auto* answer : strata_of(b))
      for (const std::string& step : answer->trusted)
        add(step);
  }
  return all;
}

std::vector<const ManifoldSpec*> manifolds_to_check(const System& s, const CheckOptions& options) {
  const std::string& only = options.only_manifold;
  std::vector<const ManifoldSpec*> all;
  std::string names;
  for (const auto& spec : s.manifolds) {
    names += (names.empty() ? "" : ", ") + spec.name;
    if (only.empty() || only == spec.name) all.push_back(&spec);
  }
  if (!only.empty() && all.empty())
    throw InvalidArgument("there is no manifold '" + only +
                          "'; manifolds: " + (names.empty() ? "none" : names));
  return all;
}

std::vector<ClaimReport> decide_claims(const System& s, const CheckOptions& options) {
  std::vector<ClaimReport> all;
  for (const auto& claim : s.claims)
    all.push_back({claim, decide_claim(s, claim, options.decide.budget)});
  return all;
}

namespace {

// An equal share of the time that is left, so that one manifold does not take that of the others.
CheckOptions for_one_of(std::size_t manifolds, CheckOptions options) {
  auto& deadline = options.decide.budget.deadline;
  const auto now = Budget::Clock::now();
  if (deadline && *deadline > now)
    deadline = now + (*deadline - now) / static_cast<long>(manifolds);
  return options;
}

} // namespace

CheckReport check_system(const System& s, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckReport report;
  report.system = s;
  report.claims = decide_claims(s, options);
  auto left = manifolds_to_check(s, options);
  for (; !left.empty(); left.erase(left.begin()))
    report.manifolds.push_back(
        check_manifold(s, *left.front(), report.claims, for_one_of(left.size(), options)));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace kov
