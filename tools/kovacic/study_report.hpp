#pragma once
// What `check` prints of a study (lib/study).

#include "mechanics.hpp"
#include "study/study.hpp"

namespace kov::cli {

enum class Detail : std::uint8_t {
  nothing, ///< where the line about what was expected says it all
  headline,
  brief, ///< equal answers together, no formula that fills a page
  whole
};

/// "  label     text", wrapped, as one line.
[[nodiscard]] std::string labelled(const std::string& label, const std::string& text,
                                   std::size_t indent = 2);
/// "file.toml  [N]  A = 1"
[[nodiscard]] std::string title_of_manifold(const System& s, const std::string& name);

[[nodiscard]] std::string text_of(const System& s, const study::CurveStudy& m, Detail detail);
[[nodiscard]] Json json_of(const System& s, const study::CurveStudy& m);
/// What all manifolds say together.
[[nodiscard]] std::string text_of(const System& s, const SystemClassification& c,
                                  study::Verdict verdict, Detail detail);
[[nodiscard]] Json json_of_together(const SystemClassification& c);

} // namespace kov::cli
