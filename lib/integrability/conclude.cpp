#include "integrability/conclude.hpp"

#include "decide/words.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "integrability/integral_class.hpp"
#include "integrability/matrices.hpp"
#include "integrability/parameters.hpp"
#include "integrability/way.hpp"
#include "manifold/existence.hpp"
#include "strata/words.hpp"

#include <algorithm>

namespace kov {

std::string to_string(Verdict v) {
  switch (v) {
  case Verdict::non_integrable:
    return "non-integrable";
  case Verdict::integrable:
    return "integrable";
  case Verdict::no_obstruction:
    return "no-obstruction";
  case Verdict::depends:
    return "depends";
  case Verdict::undecided:
    return "undecided";
  case Verdict::failed:
    return "failed";
  }
  return "";
}

namespace {

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
  const auto e = std::ranges::find_if(block.energies, [](const auto& x) {
    return x.strata && x.strata->decided() && somewhere_not_abelian(*x.strata);
  });
  return e == block.energies.end() ? nullptr : &*e;
}

/// Every block is decided, as a whole or on each of its strata (for one choice of the level).
bool by_strata(const ManifoldReport& report) {
  return std::ranges::all_of(report.blocks, [](const BlockReport& block) {
    return on_all_strata(block) || deciding_level(block);
  });
}

// The strata that decide a block whose answer is not the same everywhere: of all parameters, or of
// a level on which each is decided.  Any one such level is enough.
const strata::StrataAnswer* deciding_strata(const BlockReport& block) {
  if (block.abelian != Truth::unknown) return nullptr;
  if (block.strata && block.strata->decided()) return &*block.strata;
  const EnergyResult* level = deciding_level(block);
  return level ? &*level->strata : nullptr;
}

bool is_general(const std::vector<Condition>& all) {
  return std::ranges::none_of(all, [](const Condition& c) { return c.sign == Sign::zero; });
}

std::string in_equations(const std::vector<Condition>& all) {
  std::vector<Condition> equations;
  std::ranges::copy_if(all, std::back_inserter(equations),
                       [](const Condition& c) { return c.sign == Sign::zero; });
  return to_string(equations.empty() ? all : equations);
}

// The name of an exception.  For "C = A, A != 2" the equations are enough to name it; without
// equations, for a part that was told apart, the first statement that holds.
std::string named(const strata::Stratum& s) {
  if (is_general(s.conditions))
    for (const Statement& c : s.arithmetic)
      if (c.holds) return to_string(c);
  return in_equations(s.conditions);
}

/// Parameters where nothing follows.
struct Exception {
  std::string where;
  std::vector<MPoly> equations = {}; ///< empty: it is named otherwise
};

std::vector<MPoly> equations_of(const strata::Stratum& s) {
  std::vector<MPoly> all;
  for (const Condition& c : s.conditions)
    if (c.sign == Sign::zero) all.push_back(c.p);
  return all;
}

// "h = 0" says what "h = 0, b = a" says.
bool says(const Exception& a, const Exception& b) {
  if (a.where == b.where) return true;
  return !a.equations.empty() &&
         std::ranges::all_of(a.equations, [&](const MPoly& f) { return is_among(f, b.equations); });
}

void add(std::vector<Exception>& all, Exception one) {
  if (std::ranges::any_of(all, [&](const Exception& x) { return says(x, one); })) return;
  std::erase_if(all, [&](const Exception& x) { return says(one, x); });
  all.push_back(std::move(one));
}

// Strata without an obstruction, and those that a limit left open.
void add_exceptions(const strata::StrataAnswer& answer, const std::vector<strata::Stratum>& strata,
                    std::vector<Exception>& all) {
  for (const std::string& where : answer.unvisited)
    add(all, {where});
  for (const strata::Stratum& s : strata)
    if (s.leaf.abelian != Truth::no) add(all, {named(s), equations_of(s)});
}

// The strata of a level without its equation, which chooses an orbit and excepts nobody.
std::vector<strata::Stratum> beside_the_level(const strata::StrataAnswer& answer) {
  const auto everywhere = [&](const Condition& c) {
    return c.sign == Sign::zero &&
           std::ranges::all_of(answer.strata,
                               [&](const strata::Stratum& s) { return is_among(c, s.conditions); });
  };
  std::vector<strata::Stratum> beside = answer.told_apart();
  for (strata::Stratum& s : beside)
    std::erase_if(s.conditions, everywhere);
  return beside;
}

bool is_general(const strata::Stratum& s) {
  return is_general(s.conditions) &&
         std::ranges::none_of(s.arithmetic, [](const Statement& c) { return c.holds; });
}

// The strata of one block are enough where the general one has an obstruction.
const strata::StrataAnswer* excluding_strata(const ManifoldReport& report) {
  for (const BlockReport& b : report.blocks)
    if (b.abelian == Truth::unknown && b.strata)
      for (const strata::Stratum& s : b.strata->told_apart())
        if (s.leaf.abelian == Truth::no && is_general(s)) return &*b.strata;
  return nullptr;
}

// The parameters where nothing follows.
std::vector<Exception> not_excluded_by(const ManifoldReport& report) {
  std::vector<Exception> all;
  if (report.verdict != Verdict::depends) {
    if (const auto* answer = excluding_strata(report))
      add_exceptions(*answer, answer->told_apart(), all);
    return all;
  }
  for (const BlockReport& b : report.blocks)
    if (const auto* answer = deciding_strata(b))
      add_exceptions(
          *answer,
          b.strata && &*b.strata == answer ? answer->told_apart() : beside_the_level(*answer), all);
  return all;
}

std::string decided_where(const ManifoldReport& report) {
  std::string levels;
  for (const auto& block : report.blocks)
    if (!on_all_strata(block))
      levels += (levels.empty() ? ", by the level " : ", ") + sentence(deciding_level(block)->at);
  return levels;
}

// One block is enough, and one level of it.
std::string by_one_level(const ManifoldReport& report) {
  if (report.matrices) return "";
  const BlockReport* by = nullptr;
  for (const BlockReport& b : report.blocks)
    if (b.abelian == Truth::no && (by == nullptr || b.level.empty())) by = &b;
  return by == nullptr || by->level.empty() ? "" : ", by the level " + sentence(by->level);
}

Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::unknown;
}

std::vector<std::string> reasons_of(const BlockReport& block) {
  const std::string name = "block (" + joined(block.unknowns) + "): ";
  std::vector<std::string> all;
  if (!block.missing.empty()) all.push_back(name + note(block.missing));
  if (block.decision) all.push_back(name + reason(*block.decision));
  if (block.strata)
    for (const auto& x : block.strata->strata)
      all.push_back("where " + to_string(x.conditions) + ": " + strata::reason(x.leaf));
  for (const auto& e : block.energies)
    if (e.decision) all.push_back("at " + sentence(e.at) + ": " + reason(*e.decision));
  return all;
}

} // namespace

Verdict verdict_of(const ManifoldReport& report) {
  if (report.matrices) return Verdict::non_integrable;
  Truth all = Truth::yes;
  for (const auto& block : report.blocks)
    all = both(all, block.abelian);
  if (all == Truth::no) return Verdict::non_integrable;
  if (report.left_out) return Verdict::undecided;
  return all == Truth::yes   ? Verdict::no_obstruction
         : by_strata(report) ? Verdict::depends
                             : Verdict::undecided;
}

namespace {

// For some parameters at least.
bool excludes_integrals(const ManifoldReport& report) {
  return report.verdict == Verdict::non_integrable || report.verdict == Verdict::depends ||
         (report.verdict == Verdict::undecided && excluding_strata(report));
}

TheoremUsed theorem_of(const System& s, const ManifoldReport& report) {
  const bool of_manifold = report.matrices && report.matrices->keeps_casimirs;
  TheoremUsed by = used(s.field.poisson && !of_manifold ? morales_ramis() : ayoul_zung());
  by.integrals = excluded_integrals(s, report);
  if (std::string open = not_checked(report); !open.empty())
    by.hypotheses.push_back({std::move(open), Settled::open, ""});
  return by;
}

} // namespace

void conclude(const System& s, const CheckOptions& options, ManifoldReport& report) {
  if (options.stop_at_r) return;
  report.verdict = verdict_of(report);
  report.by = theorem_of(s, report);
}

std::string statement(const ManifoldReport& m) {
  if (!m.by || !excludes_integrals(m)) return "";
  return "not integrable " + std::string(m.by->integrals.liouville ? "in Liouville's sense " : "") +
         "with " + first_integrals({m.by->integrals}) +
         (m.verdict == Verdict::depends          ? decided_where(m)
          : m.verdict == Verdict::non_integrable ? by_one_level(m)
                                                 : "");
}

std::string not_checked(const ManifoldReport& m) {
  const std::string points = existence_not_checked(m.meant_functions);
  if (!m.components_open || m.matrices) return points; // one component that excludes is enough
  return points + (points.empty() ? "" : "; ") +
         "that the phase curve has no other components at special values of the parameters";
}

std::vector<std::string> reasons(const ManifoldReport& m) {
  if (m.failure) return {m.failure->message};
  auto all = mapped<std::string>(m.missing, [&](const Missing& x) { return sentence(x); });
  if (std::ranges::any_of(m.missing, [](const Missing& x) { return x.ends_all(); })) return all;
  if (m.matrices) all.push_back(reason(*m.matrices));
  for (const auto& block : m.blocks)
    std::ranges::move(reasons_of(block), std::back_inserter(all));
  if (m.by && m.verdict == Verdict::undecided && m.left_out)
    all.push_back("every block has an abelian identity component, which is not enough here; " +
                  sentence(*m.left_out));
  return all;
}

std::string note(const std::vector<Missing>& all) {
  return joined(
      all, [&](const Missing& m) { return sentence(m); }, "; ");
}

std::string why(const EnergyResult& e) { return e.sample ? "sample" : "singular places merge"; }

std::string exceptions(const ManifoldReport& report, bool possibly) {
  const std::string begin = possibly ? "except possibly where " : "except where ";
  std::string text;
  for (const Exception& e : not_excluded_by(report))
    text += (text.empty() ? begin : "; or ") + e.where;
  return text;
}

namespace {

void add_trusted(const strata::StrataAnswer& a, std::vector<Trusted>& all) {
  for (const auto& special : a.special)
    add_trusted(*special, all);
  add_each_once(all, a.trusted);
}

// An answer that no certificate repeats.
void add_trusted(const std::optional<Decision>& d, std::vector<Trusted>& all) {
  if (d && d->abelian != Truth::unknown && !d->checked)
    add_each_once(all, {{Trusted::Step::uncertified_answer,
                         (d->no_certificate.empty() ? "" : " (" + d->no_certificate + ")") + ": " +
                             reason(*d)}});
}

// The verdict is partial and rests on one arithmetic part of the general stratum.
bool rests_on_a_part(const ManifoldReport& m) {
  if (m.verdict != Verdict::undecided) return false;
  const auto* answer = excluding_strata(m);
  return answer && std::ranges::any_of(answer->strata, [](const auto& s) {
           return s.leaf.abelian == Truth::unknown && !s.leaf.parts.empty();
         });
}

} // namespace

std::vector<Trusted> trusted_steps(const ManifoldReport& m) {
  std::vector<Trusted> all;
  const std::string along = ", along the manifold " + m.name;
  if (m.matrices && !m.matrices->certificate.empty() && !m.matrices->has_way)
    all.push_back(
        {Trusted::Step::way_to_matrices, equation_of(*m.matrices) + " over K(z)" + along});
  if (m.matrices && m.matrices->certificate.empty())
    all.push_back({Trusted::Step::enclosures, equation_of(*m.matrices) + along});
  add_each_once(all, uncertified_way(m));
  if (rests_on_a_part(m)) add_each_once(all, {{Trusted::Step::closed_answer}});
  for (const BlockReport& b : m.blocks) {
    for (const auto* answer : strata_of(b))
      add_trusted(*answer, all);
    add_trusted(b.decision, all);
    for (const EnergyResult& e : b.energies)
      add_trusted(e.decision, all);
  }
  return all;
}

} // namespace kov
