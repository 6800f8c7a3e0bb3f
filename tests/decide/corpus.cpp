#include "corpus.hpp"

#include "support/source_dir.hpp"
#include "symbol/constants.hpp"
#include "symbol/rational_form.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace kov {

std::vector<Json> corpus(const std::string& file) {
  std::ifstream in(test::in_source("/tests/corpus/") + file);
  std::vector<Json> entries;
  for (std::string line; std::getline(in, line);)
    if (Json entry = Json::parse(line); !entry.contains("parameters"))
      entries.push_back(std::move(entry));
  return entries;
}

NormalForm equation_of(const Json& entry) {
  const auto parse = [&](const char* key) {
    return parse_expression(entry.at(key).get<std::string>(), key);
  };
  Constants constants;
  if (entry.contains("minpoly")) constants.define_root("a", parse("minpoly"));
  Reading reading;
  reading.constants = &constants;
  if (entry.contains("r")) {
    const std::array<Expression, 1> r{parse("r")};
    constants.gather(r);
    return {.r = rational_function(r[0], reading), .p = RationalFunction()};
  }
  const std::array<Expression, 2> pq{parse("p"), parse("q")};
  constants.gather(pq);
  return normal_form(rational_function(pq[0], reading), rational_function(pq[1], reading));
}

std::string corpus_name(const GaloisGroup& g) {
  const std::string n = g.n ? to_string(*g.n) : "?";
  switch (g.type) {
  case GroupType::Borel:
    return "B";
  case GroupType::Gm:
    return "D";
  case GroupType::T:
    return n == "1" ? "Ga" : "T_" + n;
  case GroupType::cyclic:
    return n == "1" ? "trivial" : "C_" + n;
  case GroupType::D:
    return "D_" + n;
  case GroupType::A4:
    return "A4_SL2";
  case GroupType::S4:
    return "S4_SL2";
  case GroupType::A5:
    return "A5_SL2";
  default:
    return to_string(g.type);
  }
}

RationalFunction read(const std::string& r, const std::string& minpoly) {
  Json entry{{"r", r}};
  if (!minpoly.empty()) entry["minpoly"] = minpoly;
  return equation_of(entry).r;
}

std::string group_of(const RationalFunction& r) {
  const Decision d = decide({.r = r, .p = RationalFunction()});
  return d.group ? corpus_name(*d.group) : reason(d);
}

std::string name_of(const testing::TestParamInfo<Json>& entry) {
  std::string name = entry.param.at("id").get<std::string>();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

} // namespace kov
