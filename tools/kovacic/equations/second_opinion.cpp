#include "equations/second_opinion.hpp"

#include "exact/share.hpp"

#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "integrability/loops_certificate.hpp"
#include "integrability/variational_monodromy.hpp"

namespace kov::cli {
namespace {

constexpr long digits = 30;
constexpr double most_work = 2e9; // some seconds: the answer is there already, and must be told
constexpr const char* nothing = "prove nothing: numbers with error bounds never prove an equality";

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

Json as_json(const MonodromyOpinion& o) {
  Json proves = Json::array();
  if (o.sl2) proves.push_back("SL2");
  if (o.irreducible) proves.push_back("irreducible");
  if (o.infinite) proves.push_back("infinite");
  return {{"by", "monodromy"}, {"digits", digits}, {"proves", proves}, {"text", proved(o)}};
}

// The format has no rule for less than SL(2, C).
NamedCertificate proof_of(const MonodromyOpinion& o) {
  if (o.proof && o.proof->certificate.empty() && o.stokes > 0)
    return {{}, {}, "certificates replay loops, and no Stokes matrices"};
  if (o.proof) return {{}, o.proof->certificate, o.proof->none};
  if (!o.irreducible && !o.infinite) return {};
  return {{}, {}, "certificates of matrices have no rule for less than SL(2, C)"};
}

SecondOpinion told(Json json, NamedCertificate proof) {
  if (!proof.none.empty()) json["no_certificate"] = proof.none;
  return {std::move(json), std::move(proof)};
}

class OfManifold {
public:
  OfManifold(const System& s, const ManifoldReport& m, const Budget& budget, bool with_proof)
      : s_(s), m_(m), budget_(budget), with_proof_(with_proof) {}

  std::vector<SecondOpinion> operator()() {
    for (const BlockReport& b : m_.blocks) {
      if (b.equation && b.decision) add_block(b.equation->r, *b.decision);
      for (const EnergyResult& e : b.energies)
        if (e.r && e.decision) add_block(*e.r, *e.decision);
    }
    if (!m_.matrices) // they are the first opinion already
      add(whole(at_most(budget_, most_work)), "-loops-whole");
    return std::move(all_);
  }

private:
  void add_block(const RationalFunction& r, const Decision& answer) {
    add(second_opinion(r, answer, budget_, with_proof_), "-loops-" + std::to_string(++blocks_));
  }
  void add(SecondOpinion o, const std::string& role) {
    o.proof.name = m_.name + role;
    all_.push_back(std::move(o));
  }

  [[nodiscard]] SecondOpinion whole(const Budget& budget) const {
    Json j{{"by", "monodromy"},
           {"of", "the whole variational equation"},
           {"digits", digits},
           {"proves", Json::array()}};
    try {
      const NumericalVariation v =
          numerical_variation(s_, *m_.manifold, m_.variational, {}, budget);
      const auto matrices = monodromy::monodromy(v.system, {digits, {}, budget});
      const auto found = prove_non_abelian(v.system, matrices, budget);
      if (found && m_.verdict == Verdict::no_obstruction)
        throw Contradiction(
            "the monodromy matrices prove that the identity component of the "
            "variational equation is not abelian, and the verdict is 'no obstruction'");
      if (found) j["proves"].push_back("not abelian");
      j["text"] = "the monodromy matrices of the whole variational equation (size " +
                  std::to_string(v.system.size()) + ") " +
                  (found ? "prove that its identity component is not abelian" : nothing);
      if (found && with_proof_) return told(j, proof_of(*found, v, matrices, budget));
    } catch (const InvalidArgument& e) {
      j["text"] = none_of_whole + e.what();
    } catch (const OutOfBudget& e) {
      j["text"] = none_of_whole + e.what();
    }
    return told(j, {});
  }

  [[nodiscard]] NamedCertificate proof_of(const NonAbelianVariation& found,
                                          const NumericalVariation& v,
                                          const monodromy::Monodromy& matrices,
                                          const Budget& budget) const {
    const LoopsProof p = not_abelian_certificate(
        found, "the variational equation of " + s_.file + " along " + m_.name, v.system, matrices,
        budget);
    return {{}, p.certificate, p.none};
  }

  static inline const std::string none_of_whole =
      "no monodromy matrices of the whole variational equation: ";
  const System& s_;
  const ManifoldReport& m_;
  const Budget& budget_;
  bool with_proof_;
  std::size_t blocks_ = 0;
  std::vector<SecondOpinion> all_;
};

} // namespace

SecondOpinion second_opinion(const RationalFunction& r, const Decision& answer,
                             const Budget& budget, bool with_proof) {
  const MonodromyOpinion o = monodromy_opinion(r, digits, at_most(budget, most_work), with_proof);
  const std::string against = contradiction(o, answer);
  if (!against.empty())
    throw Contradiction("two answers contradict each other: " + proved(o) + ", and by algebra " +
                        against);
  return told(as_json(o), with_proof ? proof_of(o) : NamedCertificate{});
}

std::vector<SecondOpinion> second_opinion(const System& s, const ManifoldReport& m,
                                          const Budget& budget, bool with_proof) {
  if (!m.manifold) return {};
  return OfManifold(s, m, budget, with_proof)();
}

} // namespace kov::cli
