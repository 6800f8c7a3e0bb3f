#pragma once
// The corpus files, and equations and groups as text, for the tests of the driver.

#include "verdict/decide.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace kov::testing {

using Json = nlohmann::json;

/// The entries of tests/corpus/FILE without free parameters.
[[nodiscard]] std::vector<Json> corpus(const std::string& file);
[[nodiscard]] NormalForm equation_of(const Json& entry);
/// r as text; `a` is a root of the second polynomial, if there is one.
[[nodiscard]] RationalFunction read(const std::string& r, const std::string& minpoly = {});
/// "SL2", "B", "T_12", "C_3", "A4_SL2", ... in the words of the corpus.
[[nodiscard]] std::string corpus_name(const GaloisGroup& g);
/// The group that the driver finds, in the same words; the reason if it finds none.
[[nodiscard]] std::string group_of(const RationalFunction& r, Method method = Method::automatic);

} // namespace kov::testing
