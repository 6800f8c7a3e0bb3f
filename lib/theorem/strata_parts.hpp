#pragma once
// The certificate of a theorem while its parts are put together: theorem_certificates.md 4, 7, 8, 11 to 16.

#include "certify/theorem/computed.hpp"
#include "theorem/bundle.hpp"
#include "theorem/bundle_place.hpp"

#include <list>

namespace kov {

/// The largest degree of a term, in all variables.
[[nodiscard]] long total_degree(const MPoly& f);
/// As a step says it.   Errors  DomainError: there is no rule for such integrals
[[nodiscard]] Json json_class(const IntegralClass& c);

/// The id of the step that carries the certificate of a case.
[[nodiscard]] inline std::string certificate_step(const std::string& id) { return id + "-step"; }
/// The first step, a cover of all parameters.   Errors  DomainError: it is another one
[[nodiscard]] const NodeResult& cover_of_all(const TheoremResult& t);

/// The family as both sides read it, and what the certificate has so far.
class StrataParts {
public:
  StrataParts(const TheoremResult& t, std::string directory, const Budget& budget);
  /// The same about another family.
  StrataParts(const StrataParts& of, const System& s, const std::string& name);

  /// The steps of another one, and the families that they are about.
  void take(StrataParts& other);
  /// more: the members after these
  void put_step(const std::string& id, const char* rule, Json::Object members,
                Json::Object more = {});
  /// The fact of a step about y as one about x, there.   Errors  DomainError: what is not shown; OutOfBudget
  void put_place(const std::string& id, const std::string& of, const BundleFamily& x,
                 const PartPlace& there, const PlaceMap& map, const certify::Target& y);
  /// The last step.  symmetries: the members of their steps; tree: its leaves are regions of the parts
  void put_cover(const std::string& id, const std::vector<Json::Object>& symmetries, Json tree);
  /// The file, with all families.
  [[nodiscard]] std::string text(Json (BundleFamily::*json)());
  void add_region(const std::string& id, std::vector<Condition> conditions, bool excludes = true);

  /// Equations that are linear in a parameter, with a number before it, are solved.
  [[nodiscard]] PartPlace solved(const Assumptions& r) const;
  [[nodiscard]] PartPlace place_of(const NodeResult& n) const;
  /// Proved with a part of the work: the conditions hold in these regions alone.
  [[nodiscard]] bool is_covered(const std::vector<Condition>& region,
                                const std::vector<RegionOfPart>& by) const;
  /// f = 0 is solved for parameter i.
  static void put_in(Substitution& put, std::size_t i, const MPoly& f);

  const TheoremResult& theorem;
  std::string directory;
  const Budget& budget;
  std::list<BundleFamily> families; ///< about which steps are, this one first
  BundleFamily& family;
  ComplexProof proof;

  std::vector<Json> steps;
  std::vector<std::string> parts;     ///< of the cover: ids
  std::vector<RegionOfPart> regions;  ///< of these
  std::vector<RegionOfPart> excluded; ///< of parts that say "not integrable"
  StepsOnTrust on_trust;
};

} // namespace kov
