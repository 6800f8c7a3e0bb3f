#include "equations/recognized.hpp"

#include "exact/lists.hpp"

#include "algebraize/algebraize.hpp"
#include "closed/symbolic_family.hpp"
#include "closed/whittaker_pull_back.hpp"
#include "decide/afterwards.hpp"
#include "equation/linear_form.hpp"
#include "equation/read_equation.hpp"
#include "exact/error.hpp"
#include "exact/letters.hpp"
#include "symbol/author_words.hpp"
#include "symbol/written.hpp"
#include "system/linear_formula.hpp"
#include "system/parameter_scope.hpp"

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

void ensure_agreement(const ClosedAnswer& closed, const Decision& d) {
  const bool agree = (closed.abelian == Truth::unknown || d.abelian == Truth::unknown ||
                      closed.abelian == d.abelian) &&
                     (!closed.group || !d.group || describe(*closed.group) == describe(*d.group)) &&
                     (!closed.component || !d.component || *closed.component == *d.component);
  if (!agree)
    throw Contradiction("the answer and the formula for the classical equation contradict each "
                        "other");
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
    ensure_agreement(*found->answer, decision);
    j["closed_answer"] = closed_json(*found->answer, letters);
  }
  return j;
}

namespace {

// r of y'' = r y in Q(parameters)(z), z first in the ring; nothing if it cannot be read.
std::optional<MFraction> symbolic_r(const EquationText& text) {
  const auto [variable, unknown] = equation_names(text);
  std::vector<std::string> names{variable};
  std::map<std::string, Rational> numbers;
  for (const auto& [name, value] : text.set) {
    const auto number = as_rational(value);
    if (!number) return std::nullopt;
    numbers.emplace(name, *number);
  }
  for (const std::string& name : text.parameters)
    if (!numbers.contains(name) && name != variable) names.push_back(name);
  const Ring ring = make_ring(names);
  std::map<std::string, MFraction> values;
  for (const auto& [name, number] : numbers)
    values.emplace(name, MFraction(ring, number));
  const ParameterScope scope(ring, values);
  if (text.r) return evaluate(*text.r, scope);
  if (text.p && text.q)
    return normal_form_of(evaluate(*text.p, scope), evaluate(*text.q, scope), 0);
  if (!text.ode) return std::nullopt;
  const auto form = parametric_second_order(*text.ode, unknown, 0, scope);
  return normal_form_of(form.c1 / form.c2, form.c0 / form.c2, 0);
}

} // namespace

Json symbolic_json(const EquationText& text, const Budget& budget) {
  if (text.minpoly) return nullptr;
  std::optional<SymbolicFamily> family;
  try {
    if (const auto r = symbolic_r(text)) family = symbolic_family(*r, 0, budget);
  } catch (const Error&) { // roots, unknown names: the answer stays what it is
  }
  if (!family) return nullptr;
  Json j = {{"family", to_string(family->family)}, {"equation", family->equation}};
  j["parameters"] = Json::object();
  for (const auto& [name, value] : family->parameters)
    j["parameters"][name] = value;
  j["change"] = nullptr;
  j["abelian"] = word_of(family->abelian());
  j["summary"] = family->summary();
  j["cases"] = Json::array();
  for (const FamilyCase& c : family->cases)
    j["cases"].push_back({{"when", c.when},
                          {"group", c.group ? Json(to_string(*c.group)) : Json(nullptr)},
                          {"abelian", word_of(c.abelian)}});
  j["assuming"] = Json::array();
  for (const MPoly& f : family->generic)
    j["assuming"].push_back(to_string(f) + " != 0");
  if (text.change && text.change->nonzero) { // for other values it is another equation
    const Json there = written(*text.change->nonzero) + " != 0";
    Json& assuming = j["assuming"];
    if (!is_among(there, assuming)) assuming.push_back(there);
  }
  return j;
}

bool decide_for_all(Json& result) {
  const Json& known = result.at("recognized");
  if (known.is_null() || !known.at("assuming").empty() || known.at("abelian") == "undecided")
    return false;
  result["abelian"] = known.at("abelian");
  const Json& cases = known.at("cases");
  if (cases.size() != 1 || cases[0].at("group").is_null()) return false;
  for (const GroupType type : {GroupType::SL2, GroupType::Gm}) // what such families have
    if (to_string(type) == cases[0].at("group").get<std::string>()) {
      const GaloisGroup g{type, {}};
      result["group"] = group_json(g);
      result["identity_component"] = to_string(identity_component(g));
      result["case"] = kovacic_case(g);
      result["reason"] = "for all values of the parameters: " + recognized_text(known);
      return true;
    }
  return false;
}

std::string recognized_text(const Json& j) {
  static const std::map<std::string, std::string> names{
      {"Lame", "Lame's equation"},     {"Riemann", "Riemann's (hypergeometric) equation"},
      {"Euler", "Euler's equation"},   {"Heun", "Heun's equation"},
      {"Bessel", "Bessel's equation"}, {"Whittaker", "Whittaker's equation"},
      {"Weber", "Weber's equation"},   {"Airy", "Airy's equation"}};
  const auto name = names.find(j.at("family").get<std::string>());
  if (name == names.end()) return {};
  std::string text = name->second;
  if (name->first == "Heun") return text + " (four regular places and nothing else)";
  if (name->first != "Riemann") text += " " + j.at("equation").get<std::string>();
  const char* before = name->first == "Riemann" ? ", exponent differences " : ", ";
  for (const auto& [parameter, value] : j.at("parameters").items()) {
    if (parameter == value.get<std::string>()) continue; // the letter is that of the question
    const bool unnamed = name->first == "Riemann" && !j.contains("summary"); // no condition on it
    text += before + (unnamed ? "" : parameter + " = ") + value.get<std::string>();
    before = ", ";
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
    if (!only_a_name) text += "; " + change;
  }
  return text;
}

} // namespace kov::cli
