#include "second_opinion.hpp"

#include "exact/error.hpp"
#include "integrability/study.hpp"
#include "integrability/variational_monodromy.hpp"

namespace kov::cli {
namespace {

constexpr long digits = 30;
constexpr double half = 0.5; // of the time: the answer is there already, and must be told
constexpr const char* nothing = "proves nothing: an equality is never concluded from enclosures";

std::string matrices(std::size_t count, const std::string& kind) {
  return count == 0   ? ""
         : count == 1 ? "the " + kind + " matrix"
                      : "the " + std::to_string(count) + " " + kind + " matrices";
}

std::string matrices(const MonodromyOpinion& o) {
  const std::string loops = matrices(o.loops, "monodromy"), stokes = matrices(o.stokes, "Stokes");
  if (loops.empty() && stokes.empty()) return "no finite singularity, so no monodromy";
  return loops + (loops.empty() || stokes.empty() ? "" : " and ") + stokes;
}

std::string proved(const MonodromyOpinion& o) {
  if (!o.limit.empty()) return "no monodromy matrices: " + o.limit;
  const std::string subject = matrices(o);
  if (o.loops + o.stokes == 0) return subject;
  const std::string verb = o.loops + o.stokes == 1 ? " proves" : " prove";
  if (o.sl2) return subject + verb + " that G = SL(2, C)";
  if (o.irreducible && o.infinite) return subject + verb + " that G is irreducible and infinite";
  if (o.irreducible) return subject + verb + " that G is irreducible";
  if (o.infinite) return subject + verb + " that G is infinite";
  return subject + verb + " nothing (no equality is concluded from enclosures)";
}

Json json_of(const MonodromyOpinion& o) {
  Json proves = Json::array();
  if (o.sl2) proves.push_back("SL2");
  if (o.irreducible) proves.push_back("irreducible");
  if (o.infinite) proves.push_back("infinite");
  return {{"by", "monodromy"}, {"digits", digits}, {"proves", proves}, {"text", proved(o)}};
}

void add_blocks(Json& all, const ManifoldReport& m, const Budget& budget) {
  for (const BlockReport& b : m.blocks) {
    if (b.equation && b.decision) all.push_back(second_opinion(b.equation->r, *b.decision, budget));
    for (const EnergyResult& e : b.energies)
      if (e.r && e.decision) all.push_back(second_opinion(*e.r, *e.decision, budget));
  }
}

Json whole_variation_opinion(const System& s, const ManifoldReport& m, const Budget& budget) {
  Json j{{"by", "monodromy"},
         {"of", "the whole variational equation"},
         {"digits", digits},
         {"proves", Json::array()}};
  try {
    const NumericalVariation v = numerical_variation(s, *m.manifold, m.variational, budget);
    const auto matrices = monodromy::monodromy(v.system, {digits, {}, budget});
    const bool found = prove_non_abelian(v.system, matrices, budget).has_value();
    if (found && m.verdict == VerdictKind::no_obstruction)
      throw InternalError(
          "the monodromy matrices prove that the identity component of the "
          "variational equation is not abelian, and the verdict is 'no obstruction'");
    if (found) j["proves"].push_back("not abelian");
    j["text"] = "the monodromy matrices of the whole variational equation (size " +
                std::to_string(v.system.size()) + ") " +
                (found ? "prove that its identity component is not abelian" : nothing);
  } catch (const InvalidArgument& e) {
    j["text"] = std::string("no monodromy matrices of the whole variational equation: ") + e.what();
  } catch (const OutOfBudget& e) {
    j["text"] = std::string("no monodromy matrices of the whole variational equation: ") + e.what();
  }
  return j;
}

} // namespace

Json second_opinion(const RationalFunction& r, const Decision& answer, const Budget& budget) {
  const MonodromyOpinion o = monodromy_opinion(r, digits, part_of_the_time(budget, half));
  const std::string against = contradiction(o, answer);
  if (!against.empty())
    throw InternalError("two answers contradict each other: " + proved(o) + ", and by algebra " +
                        against);
  return json_of(o);
}

Json second_opinion(const System& s, const ManifoldReport& m, const Budget& budget) {
  Json all = Json::array();
  if (!m.manifold) return all;
  add_blocks(all, m, budget);
  if (!m.matrices) // they are the first opinion already
    all.push_back(whole_variation_opinion(s, m, part_of_the_time(budget, half)));
  return all;
}

} // namespace kov::cli
