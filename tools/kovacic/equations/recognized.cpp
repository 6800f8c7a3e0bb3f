#include "equations/recognized.hpp"

#include "closed/whittaker_pull_back.hpp"
#include "decide/afterwards.hpp"
#include "exact/error.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "symbol/author_words.hpp"
#include "symbol/formula.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov::cli {
namespace {

// Beside the variable and the generator of the field; x where it is the variable itself stays x.
FreshLetters letters_for(const Recognized& found, const std::string& variable,
                         std::set<std::string> taken) {
  taken.merge(names_in_text(variable));
  FreshLetters letters(taken);
  const bool in_place = found.z_of_x && found.z_of_x->is_identity() && !found.centre;
  if (in_place && variable == "x") letters.keep("x");
  for (const auto& [name, value] : found.parameters)
    if (name == value) letters.keep(name);
  return letters;
}

} // namespace

Json group_json(const GaloisGroup& g) {
  Json j;
  j["type"] = to_string(g.type);
  j["n"] = g.n ? json_integer(*g.n) : Json(nullptr);
  return j;
}

Json closed_json(const ClosedAnswer& answer, const FreshLetters& letters) {
  Json j;
  j["abelian"] = word_of(answer.abelian);
  j["group"] = answer.group ? group_json(*answer.group) : Json(nullptr);
  j["reason"] = letters.in(answer.reason);
  return j;
}

Json recognized_json(const Decision& decision, const std::set<std::string>& taken,
                     const Budget& budget) {
  std::optional<Recognized> found;
  try {
    found = recognize(decision.r, budget, decision.places ? &*decision.places : nullptr);
    if (!found && decision.places)
      found = recognize_pull_back(*decision.places, decision.variable, budget);
  } catch (const OutOfBudget&) { // the answer itself is there
  }
  if (!found) return nullptr;
  const FreshLetters letters = letters_for(*found, decision.variable, taken);
  const std::string x = letters("x");
  Json j;
  j["family"] = to_string(found->family);
  j["equation"] = letters.in(found->equation);
  j["parameters"] = Json::object();
  for (const auto& [name, value] : found->parameters)
    j["parameters"][letters.in(name)] =
        found->family == Classical::polynomial ? renamed(value, {{"x", x}}) : value;
  j["change"] = nullptr;
  std::string left = decision.variable;
  if (found->centre)
    left = "(" + to_string(Poly::z() - Poly(*found->centre), decision.variable) + ")^2";
  if (found->z_of_x) j["change"] = left + " = " + to_string(*found->z_of_x, x);
  if (!found->z_of_x && !is_identifier(left)) j["change"] = left + " = " + x;
  j["closed_answer"] = nullptr;
  if (found->answer) {
    answer::ensure_agreement(*found->answer, decision);
    j["closed_answer"] = closed_json(*found->answer, letters);
  }
  return j;
}

Json symbolic_json(const strata::GenericForm& family, const EquationPart& part) {
  Json j = {{"family", to_string(family.answer.form.family)}, {"equation", family.equation}};
  j["parameters"] = Json::object();
  for (const auto& [name, value] : family.numbers)
    j["parameters"][name] = value;
  j["change"] = family.change.empty() ? Json(nullptr) : Json(family.change);
  j["abelian"] = word_of(family.abelian());
  j["summary"] = family.summary();
  j["cases"] = Json::array();
  for (const strata::Part& p : family.answer.parts)
    j["cases"].push_back({{"when", strata::in_words(p)},
                          {"group", p.group ? Json(to_string(p.group->type)) : Json(nullptr)},
                          {"abelian", word_of(p.abelian)}});
  std::vector<std::string> assuming;
  for (const MPoly& f : family.generic)
    assuming.push_back(to_string(f) + " != 0");
  for (const auto& [here, elsewhere] : part.where) // for other values it is another equation
    add_once(assuming, here);
  j["assuming"] = assuming;
  return j;
}

std::string recognized_text(const Json& j) {
  const auto words =
      std::ranges::find(classical_words, j.at("family").get<std::string>(), &ClassicalWords::name);
  std::string text = words->known_as;
  if (text.empty()) return {};
  if (words->family == Classical::heun) return text + " (" + words->equation + ")";
  // a person who knows the equation knows it without its canonical form, and these numbers by these names
  static const std::map<std::string, std::vector<std::pair<std::string, std::string>>> said{
      {"Bessel", {{"m", " of order "}}},
      {"Whittaker", {{"k", ", k = "}, {"m", ", m = "}}},
      {"Euler", {{"l", ", exponent difference "}}},
      {"Weber", {}},
      {"Airy", {}}};
  const Json& parameters = j.at("parameters");
  if (const auto these = said.find(words->name); these != said.end()) {
    for (const auto& [letter, before] : these->second)
      for (const auto& [name_here, value] : parameters.items()) // m_1 beside an m of the question
        if (name_here.substr(0, name_here.find('_')) == letter && name_here != value)
          text += before + value.get<std::string>();
    if (j.at("equation").get<std::string>().ends_with(" in sqrt(x)"))
      text += " in the square root of the variable";
  } else {
    const char* before = words->family == Classical::riemann ? ", exponent differences " : ", ";
    for (const auto& [parameter, value] : parameters.items()) {
      if (parameter == value) continue;
      const bool unnamed = // no condition on it
          words->family == Classical::riemann && !j.contains("summary");
      text += before + (unnamed ? "" : parameter + " = ") + value.get<std::string>();
      before = ", ";
    }
  }
  if (j.contains("summary")) {
    text += "; " + j.at("summary").get<std::string>();
    const char* assuming = "; assuming ";
    for (const Json& condition : j.at("assuming")) {
      text += assuming + condition.get<std::string>();
      assuming = ", ";
    }
  }
  if (!j.at("change").is_null()) {
    const std::string change = j.at("change").get<std::string>();
    const auto equals = change.find(" = ");
    const bool only_a_name =
        is_identifier(change.substr(0, equals)) && is_identifier(change.substr(equals + 3));
    if (!only_a_name)
      text += " after the change " +
              written(trees::rebuilt(parse_expression(change, "a change", true)));
  }
  return text;
}

} // namespace kov::cli
