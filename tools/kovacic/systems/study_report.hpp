#pragma once
// What `check` prints of a study (lib/study).

#include "output/page_width.hpp"
#include "study/study.hpp"
#include "systems/mechanics.hpp"

// What a child tells its parent: written and read by these names.
namespace kov {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(IntegralClass, kind, near, curves, on_leaf, functions, without,
                                   through, frame, liouville)
} // namespace kov
namespace kov::study {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Headline, verdict, excluded, trusted, unchecked, refused,
                                   complete)
} // namespace kov::study

namespace kov::cli {

enum class Detail : std::uint8_t {
  nothing, ///< where the line about what was expected says it all
  headline,
  brief, ///< equal answers together, no formula that fills a page
  whole
};

/// "file.toml  [N]  A = 1"
[[nodiscard]] std::string title_of_manifold(const System& s, const std::string& name);

[[nodiscard]] Meaning meaning_of(Verdict v);
[[nodiscard]] std::string text_of(const System& s, const study::CurveStudy& m, Detail detail);
[[nodiscard]] Json json_of(const System& s, const study::CurveStudy& m);
/// What all manifolds say together.
[[nodiscard]] std::string text_of(const System& s, const SystemClassification& c, Verdict verdict,
                                  Detail detail);
[[nodiscard]] Json json_of_together(const SystemClassification& c);

/// The answer for one set of values, empty.
[[nodiscard]] Json json_of_round(const System& s);
/// "claims", and "expected": that they hold, or not.
[[nodiscard]] Json json_of_claims(const System& s, const std::vector<ClaimReport>& claims);
/// verdict, class of integrals (in words), trusted, not_checked, complete.
void put(Json& result, const study::Headline& h);
/// Writes them (--certificate); the answer names the files.
void file_certificates(const Settings& settings, const System& s,
                       const std::vector<NamedCertificate>& proofs, Report& answer);
/// A manifold that is none is an error of the file, whatever else is proved.
[[nodiscard]] int exit_of(const Settings& settings, const study::Headline& h);

/// "r = sqrt(x^2 + y^2)": the roots to which the file gives names, which answers keep.
[[nodiscard]] std::vector<std::string> named_roots(const System& s);
/// Square roots without a name as the file writes them: sqrt(x^2 + y^2) where the text has the name of its symbol.
/// A sentence, and all texts of an answer, in the same way.
[[nodiscard]] std::string in_written_names(const System& s, const std::string& sentence);
void put_written_names(const System& s, Json& j);
[[nodiscard]] std::string with_written_roots(const System& s, const std::string& text);

} // namespace kov::cli
