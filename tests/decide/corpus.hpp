#pragma once
// The entries of tests/corpus as parameters of tests; equations and groups as text.

#include "decide/words.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace kov {

using Json = nlohmann::json;

/// The entries of a file of tests/corpus without free parameters.
[[nodiscard]] std::vector<Json> corpus(const std::string& file);
[[nodiscard]] NormalForm equation_of(const Json& entry);
/// r as text; `a` is a root of the second polynomial, if there is one.
[[nodiscard]] RationalFunction read(const std::string& r, const std::string& minpoly = {});
/// "T_12", "C_3", "A4_SL2", ... in the words of the corpus.
[[nodiscard]] std::string corpus_name(const GaloisGroup& g);
/// The group that the driver finds, in the same words; the reason if it finds none.
[[nodiscard]] std::string group_of(const RationalFunction& r);
/// The id as the name of a test.
[[nodiscard]] std::string name_of(const testing::TestParamInfo<Json>& entry);

} // namespace kov
