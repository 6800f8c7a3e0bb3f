#pragma once
// The entries of tests/corpus as parameters of tests.

#include "verdict/decide.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace kov {

using Json = nlohmann::json;

/// The entries of a file of tests/corpus without free parameters.
[[nodiscard]] std::vector<Json> corpus(const std::string& file);
[[nodiscard]] NormalForm equation_of(const Json& entry);
/// "T_12", "C_3", "A4_SL2", ... in the words of the corpus.
[[nodiscard]] std::string corpus_name(const GaloisGroup& g);
/// The id as the name of a test.
[[nodiscard]] std::string name_of(const testing::TestParamInfo<Json>& entry);

} // namespace kov
