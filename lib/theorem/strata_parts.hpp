#pragma once
// A certificate about strata of complex parameters while its parts are put together: theorem_certificates.md 11 to 16.

#include "certify/theorem/integrable.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/cover_search.hpp"
#include "theorem/strata.hpp"

namespace kov {

/// The place of a part, in the names of the family.
struct PartPlace {
  Json at;
  certify::ParameterFunctions values;
  Substitution put;
  std::vector<Condition> equations, region, given;
  Substitution
      levels{}; ///< values of parameters that only the system of a certificate has, in its ring
};

/// The largest degree of a term, in all variables.
[[nodiscard]] long total_degree(const MPoly& f);
/// As a step says it.   Errors  DomainError: there is no rule for such integrals
[[nodiscard]] Json json_class(const IntegralClass& c);

/// The family as both sides read it, and what the certificate has so far.
class StrataParts {
public:
  StrataParts(const TheoremResult& t, std::string directory, const Budget& budget);

  void put_step(const std::string& id, const char* rule, Json::Object members);
  void add_region(const std::string& id, const PartPlace& x, bool excludes = true);

  /// Equations that are linear in a parameter, with a number before it, are solved.
  [[nodiscard]] PartPlace solved(const ParameterRegion& r) const;
  /// Errors  DomainError: parameters are put to quotients
  [[nodiscard]] PartPlace placed(const Substitution& put, std::vector<Condition> region) const;
  [[nodiscard]] PartPlace place_of(const NodeResult& n) const;
  /// Proved with a part of the work: the conditions hold in the regions alone.
  [[nodiscard]] bool is_covered(const std::vector<Condition>& there,
                                const std::vector<RegionOfPart>& by) const;
  /// f = 0 is solved for parameter i.
  static void put_in(Substitution& put, std::size_t i, const MPoly& f);

  /// In the names of the family as the judge has read it.
  [[nodiscard]] certify::PhaseFunction in_judge(const certify::PhaseFunction& f) const;
  [[nodiscard]] std::vector<Condition> in_judge(const std::vector<Condition>& all) const;
  [[nodiscard]] std::vector<bool> complex_there() const;

  const TheoremResult& theorem;
  std::string directory;
  const Budget& budget;
  StrataFamily family;
  std::string name; ///< of its system
  ComplexProof proof;
  Json json; ///< the family
  certify::Family checked;

  std::vector<Json> steps;
  std::vector<std::string> parts;     ///< of the cover: ids
  std::vector<RegionOfPart> regions;  ///< of these
  std::vector<RegionOfPart> excluded; ///< of parts that say "not integrable"
  StepsOnTrust on_trust;

private:
  void put_given(PartPlace& x) const;
};

} // namespace kov
