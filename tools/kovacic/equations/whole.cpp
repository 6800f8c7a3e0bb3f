#include "equations/whole.hpp"

#include "answer/notation.hpp"
#include "exact/tried.hpp"
#include "symbol/formula.hpp"

#include <utility>

namespace kov::cli {

void put_whole(Json& result, const std::string& unknown, const elementary::WholeAnswer& answer) {
  Json j{{"unknown", unknown}};
  const auto put = [&](const char* key, const std::optional<std::string>& text) {
    if (!text || text->empty()) return;
    const auto formula = tried<InputError>( // sentences are none
        [&] { return std::optional(parse_expression(std::string(*text), "a solution")); });
    j[key] = formula && answer::is_special(*formula) ? answer::for_people(trees::rebuilt(*formula))
                                                     : *text;
  };
  put("with_values", answer.with_values);
  put("integrals", answer.integrals);
  put("no_values", answer.no_values);
  put("general", answer.general);
  put("particular", answer.particular);
  if (!answer.special.empty()) j["special"] = answer.special;
  if (!answer.nonzero.empty()) j["nonzero"] = answer.nonzero;
  for (const std::string& what : answer.failed)
    result["failed"].push_back(what);
  result["whole"] = std::move(j);
}

std::vector<std::pair<std::string, std::string>> whole_lines(const Json& result) {
  std::vector<std::pair<std::string, std::string>> lines;
  if (!result.contains("whole")) return lines;
  const Json& whole = result.at("whole");
  const std::string y = whole.at("unknown").get<std::string>() + " = ";
  std::string label = "solution";
  const auto put = [&](const std::string& text) {
    lines.emplace_back(std::exchange(label, ""), text);
  };
  const auto formula = [&](const char* key) { return y + whole.at(key).get<std::string>(); };
  const bool one = whole.contains("with_values");
  if (one) {
    put(formula("with_values"));
    if (whole.contains("integrals")) put(whole.at("integrals").get<std::string>());
  } else if (whole.contains("general"))
    put(formula("general"));
  else if (whole.contains("particular") && !result.contains("answer")) // there it stands in the sum
    put(formula("particular") + ", one solution");
  for (const Json& s : one ? Json::array() : whole.value("special", Json::array()))
    put(y + s.get<std::string>());
  const Json answer = result.value("answer", Json::object());
  if (answers_whole(result) && answer.contains("functions"))
    put(answer.at("functions").get<std::string>());
  if (whole.contains("nonzero") && !lines.empty()) {
    std::string where;
    for (const Json& f : whole.at("nonzero"))
      where += (where.empty() ? "where " : ", ") + f.get<std::string>() + " != 0";
    put(where);
  }
  label = "values";
  if (whole.contains("no_values")) put(whole.at("no_values").get<std::string>());
  return lines;
}

bool answers_whole(const Json& result) {
  return result.contains("whole") &&
         (result.at("whole").contains("general") || result.at("whole").contains("with_values"));
}

} // namespace kov::cli
