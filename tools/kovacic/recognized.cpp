#include "recognized.hpp"

#include "exact/error.hpp"

#include <map>

namespace kov::cli {
namespace {

const char* text_of(Truth t) {
  return t == Truth::yes ? "yes" : t == Truth::no ? "no" : "undecided";
}

} // namespace

Json group_json(const GaloisGroup& g) {
  Json n = nullptr;
  if (g.n) n = fits_long(*g.n) ? Json(to_long(*g.n)) : Json(to_string(*g.n));
  return {{"type", to_string(g.type)}, {"n", n}};
}

Json closed_json(const ClosedAnswer& answer) {
  return {{"abelian", text_of(answer.abelian)},
          {"group", answer.group ? group_json(*answer.group) : Json(nullptr)},
          {"reason", answer.reason}};
}

void ensure_agreement(const ClosedAnswer& closed, const Decision& d) {
  if (closed.abelian != Truth::unknown && d.abelian != Truth::unknown)
    KOV_ENSURE(closed.abelian == d.abelian);
  if (closed.group && d.group) KOV_ENSURE(describe(*closed.group) == describe(*d.group));
}

Json recognized_json(const GivenEquation& equation, const Decision& decision,
                     const Budget& budget) {
  std::optional<Recognized> found;
  try {
    found = recognize(equation.normal_form.r, budget);
  } catch (const OutOfBudget&) { // the answer itself is there
  }
  if (!found) return nullptr;
  Json j = {{"family", found->family}, {"equation", found->equation}};
  j["parameters"] = Json::object();
  for (const auto& [name, value] : found->parameters)
    j["parameters"][name] = value;
  j["change"] = nullptr;
  std::string left = equation.variable;
  if (found->centre)
    left = "(" + to_string(Poly::z() - Poly(*found->centre), equation.variable) + ")^2";
  if (found->z_of_x) j["change"] = left + " = " + to_string(*found->z_of_x, "x");
  j["closed_answer"] = nullptr;
  if (found->answer) {
    ensure_agreement(*found->answer, decision);
    j["closed_answer"] = closed_json(*found->answer);
  }
  return j;
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
    text += before + (name->first == "Riemann" ? "" : parameter + " = ") + value.get<std::string>();
    before = ", ";
  }
  if (!j.at("change").is_null()) {
    const std::string change = j.at("change").get<std::string>();
    if (!change.ends_with(" = x")) text += "; " + change;
  }
  return text;
}

} // namespace kov::cli
