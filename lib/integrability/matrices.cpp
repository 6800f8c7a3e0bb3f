#include "integrability/matrices.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "integrability/linearise.hpp"
#include "integrability/loops_certificate.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "integrability/way.hpp"
#include "variation/leaf.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long digits = 30;
constexpr double most_work = 1.5e9; // some seconds

// Level parameters in the equations of the manifold, all at one value.
Substitution at_level(const System& s, const ManifoldSpec& spec, const Rational& value) {
  Substitution level;
  for (const std::size_t i : level_parameters(s))
    if (std::ranges::any_of(spec.levels, [&](const Equation& e) { return uses(e.difference, i); }))
      level[i] = MFraction(s.ring(), value);
  return level;
}

// Parameters that are not a choice of a level have values: the matrices may not show them, but what
// was divided by does.
bool has_only_levels(const System& s) {
  const auto levels = level_parameters(s);
  return std::ranges::all_of(s.field.parameters,
                             [&](std::size_t i) { return is_among(i, levels); });
}

// The level is one that the file admits, and so are those near it.
bool is_admitted(const System& s, const Substitution& level) {
  return std::ranges::all_of(s.assumptions, [&](const Assumption& a) {
    if (!a.value.ring() ||
        std::ranges::none_of(level, [&](const auto& x) { return uses(a.value, x.first); }))
      return true;
    if (a.is(Sort::real) || a.is(Sort::rational)) return true;
    const MFraction there = substitute(a.value, level);
    return is_constant(there) && a.holds_near(to_rational(there));
  });
}

// The whole variational equation, or a diagonal block of its normal part.
struct Part {
  LinearSystem system;
  std::vector<std::string> block; ///< empty: the whole
  std::vector<MPoly> divisors;    ///< of the derivation
  UnknownsOfSystem unknowns;      ///< whole: on the whole Poisson manifold
};

std::optional<MatrixEvidence> matrices_of(const Study& study, const ManifoldReport& report,
                                          const Part& part, const Budget& budget) {
  const System& s = study.system;
  const InvariantManifold& manifold = *report.manifold;
  const auto v = numerical_variation(s, manifold, part.system, part.divisors, budget);
  const auto m = monodromy::monodromy(v.system, {digits, {}, budget});
  auto proof = prove_non_abelian(v.system, m, budget);
  if (!proof) return std::nullopt;
  MatrixEvidence found{*std::move(proof),
                       part.block,
                       v.system.size(),
                       v.names,
                       v.change,
                       part.unknowns.whole,
                       {},
                       {},
                       false,
                       {}};
  const std::string file = s.file.substr(s.file.rfind('/') + 1); // the same on every machine
  const LoopsProof written = not_abelian_certificate(
      found.proof, "the variational equation of " + file + " along " + manifold.name, v.system, m,
      budget);
  const LoopsOfWay way =
      certificate_of(study, report, v.rational, v.phi, part.unknowns, written.certificate);
  found.certificate = way.text;
  found.has_way = way.has_way;
  found.no_certificate = written.none;
  return found;
}

LinearSystem diagonal_block(const LinearSystem& s, const std::vector<std::size_t>& members) {
  LinearSystem block;
  for (const std::size_t i : members) {
    block.names.push_back(s.names[i]);
    block.a.emplace_back();
    for (const std::size_t j : members)
      block.a.back().push_back(s.a[i][j]);
  }
  return block;
}

// The combination with these coefficients of the unknowns of the normal part.
Differential combined(const ManifoldReport& report, const std::vector<MFraction>& c) {
  Differential d;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (!is_zero(c[i]))
      d.emplace_back(c[i], report.manifold->equations[report.normal.equations.at(i)].difference);
  return d;
}

Differential normal_unknown(const Study& study, const ManifoldReport& report,
                            const std::string& name) {
  std::vector<MFraction> c;
  for (const std::string& x : report.normal.system.names)
    c.emplace_back(study.system.ring(), Rational(x == name ? 1 : 0));
  return combined(report, c);
}

std::vector<Differential> eliminating(const ManifoldReport& report) {
  std::vector<Differential> all;
  for (const Elimination& e : report.reduced.eliminations)
    for (const LinearIntegral& f : report.normal.integrals)
      if (f.name == e.integral) all.push_back(combined(report, f.coefficients));
  return all;
}

// The blocks of order three and more that the symplectic leaf sees; those of order two are decided
// by algebra.
std::vector<Part> large_blocks(const Study& study, const ManifoldReport& report) {
  const auto eliminated = eliminating(report);
  const LinearSystem& reduced = report.reduced.system;
  std::vector<Part> all;
  for (const auto& members : blocks(reduced, *report.manifold)) {
    if (members.size() <= 2) continue;
    Part part{diagonal_block(reduced, members), {}, divisors_of(study, report), {}};
    part.block = part.system.names;
    for (const std::string& name : part.block)
      part.unknowns.unknowns.push_back(normal_unknown(study, report, name));
    part.unknowns.eliminated = eliminated;
    const auto& normal = report.normal.divisors;
    part.divisors.insert(part.divisors.end(), normal.begin(), normal.end());
    std::vector<std::string> used;
    for (const std::size_t i : used_by(reduced, *report.manifold, members))
      used.push_back(reduced.names[i]);
    const bool is_seen =
        study.system.kind == SystemKind::hamiltonian ||
        seen_on_the_leaf(study.system.field, *report.manifold, report.normal,
                         {used, report.reduced.eliminations}, part.block, part.divisors);
    if (is_seen) all.push_back(std::move(part));
  }
  return all;
}

// The normal part with f = dF for the Casimir function F that took an unknown u away: f' = 0, and u is
// put in from f = sum c_i y_i.  (f = 0 is the reduced system.)
std::optional<Part> with_the_casimir(const Study& study, const ManifoldReport& report) {
  const auto& gone = report.reduced.eliminations;
  if (gone.size() != 1 || !gone.front().casimir) return std::nullopt;
  const LinearSystem& normal = report.normal.system;
  const auto& all = report.normal.integrals;
  const auto f = std::ranges::find_if(
      all, [&](const LinearIntegral& x) { return x.casimir && x.name == gone.front().integral; });
  const auto u = std::ranges::find(normal.names, gone.front().unknown);
  if (f == all.end() || u == normal.names.end()) return std::nullopt;
  const auto e = static_cast<std::size_t>(u - normal.names.begin());
  const MFraction& c = f->coefficients[e];
  if (is_zero(c)) return std::nullopt;
  const MFraction zero(study.system.ring());
  Part part{{}, {}, divisors_of(study, report), {}};
  part.unknowns.whole = true;
  const auto& more = report.normal.divisors;
  part.divisors.insert(part.divisors.end(), more.begin(), more.end());
  add_divisors(part.divisors, c);
  LinearSystem& kept = part.system;
  for (std::size_t i = 0; i < normal.names.size(); ++i) {
    if (i == e) continue;
    kept.names.push_back(normal.names[i]);
    part.unknowns.unknowns.push_back(normal_unknown(study, report, normal.names[i]));
    auto& row = kept.a.emplace_back();
    for (std::size_t j = 0; j < normal.names.size(); ++j)
      if (j != e) row.push_back(normal.a[i][j] - normal.a[i][e] * f->coefficients[j] / c);
    row.push_back(normal.a[i][e] / c);
  }
  kept.names.push_back("d" + f->name);
  part.unknowns.unknowns.push_back(combined(report, f->coefficients));
  kept.a.emplace_back(kept.names.size(), zero);
  part.block = kept.names;
  return part;
}

// Is it a system on one leaf?  For a Poisson system the variation on the leaf is needed.
bool is_on_one_leaf(const System& s) {
  return s.kind == SystemKind::hamiltonian || !s.field.poisson;
}

enum class Of : std::uint8_t { leaf, manifold };

std::optional<MatrixEvidence> matrices_at(const Study& general, const Substitution& level, Of what,
                                          const Budget& budget) {
  const System s = at_values(general.system, level);
  const ManifoldSpec spec = at_values(general.manifold, level);
  const auto claims = at_values(general.claims, level);
  const Study study{s, spec, claims, general.options};
  ManifoldReport report;
  report.name = spec.name;
  auto proved = prove_invariant(s.field, spec, budget);
  if (!std::holds_alternative<InvariantManifold>(proved)) return std::nullopt;
  report.manifold = std::get<InvariantManifold>(std::move(proved));
  std::optional<MatrixEvidence> found;
  const auto look = [&](const Part& part) {
    if (!found) // nothing where it is too large, or has no change of variable
      found = tried<InvalidArgument, DomainError>(
          [&] { return matrices_of(study, report, part, budget); });
  };
  if (what == Of::manifold) {
    linearise(study, report);
    if (const auto part = with_the_casimir(study, report)) look(*part);
  } else if (is_on_one_leaf(s)) {
    UnknownsOfSystem all;
    for (const std::size_t x : s.field.coordinates)
      all.unknowns.push_back(
          {{MFraction(s.ring(), Rational(1)), MFraction::variable(s.ring(), x)}});
    look({variational_equations(s.field, *report.manifold), {}, {}, std::move(all)});
  }
  if (!found && what == Of::leaf) {
    linearise(study, report);
    for (const Part& part : large_blocks(study, report))
      look(part);
  }
  if (!found) return std::nullopt;
  for (const auto& [i, value] : level)
    found->level.push_back({s.ring()->name(i), to_string(value)});
  return found;
}

void ask(const Study& study, ManifoldReport& report, Of what) {
  if (!report.manifold || !has_only_levels(study.system)) return;
  const Budget budget = at_most(part_of_the_work(study.options.decide.budget, 0.5), most_work);
  for (const Rational& value : {Rational(1), Rational(2), Rational(-1, 3)}) {
    const Substitution level = at_level(study.system, study.manifold, value);
    bool admitted = true;
    // what could not be computed proves nothing
    auto found = tried<OutOfBudget, InvalidArgument, DomainError>([&] {
      admitted = is_admitted(study.system, level);
      return admitted ? matrices_at(study, level, what, budget) : std::nullopt;
    });
    if (found) report.matrices = std::make_shared<const MatrixEvidence>(*std::move(found));
    if (found || (admitted && level.empty())) return;
  }
}

// With a finite group on the leaf the variation of a Casimir function adds a vector group only.
bool may_have_more(const ManifoldReport& report) {
  return std::ranges::any_of(report.blocks, [](const BlockReport& b) {
    return b.decision && b.decision->component && *b.decision->component != Connected::trivial;
  });
}

} // namespace

void ask_the_matrices(const Study& study, ManifoldReport& report) { ask(study, report, Of::leaf); }

void ask_with_the_casimir(const Study& study, ManifoldReport& report) {
  if (study.system.field.poisson && may_have_more(report)) ask(study, report, Of::manifold);
}

std::string equation_of(const MatrixEvidence& by) {
  if (by.part.empty()) return "the whole variational equation";
  std::string names = joined(by.part);
  return "the variation of " + names + (by.keeps_casimirs ? " on the whole Poisson manifold" : "");
}

std::string reason(const MatrixEvidence& by) {
  return "the monodromy matrices of " + equation_of(by) + " (size " + std::to_string(by.size) +
         ", " + by.change + (by.level.empty() ? "" : ", at the level " + sentence(by.level)) +
         ") prove that its identity " + "component is not abelian: " +
         (by.proof.unipotent ? std::string("two unipotent elements of the group do not commute")
                             : "a diagonal block is dense in SL(2, C), up to scalars") +
         " (enclosures with " + std::to_string(digits) + " digits)" +
         (by.keeps_casimirs
              ? "; the symplectic leaf alone says nothing: there may be an integral of it"
              : "");
}

} // namespace kov
