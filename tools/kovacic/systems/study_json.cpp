#include "integrability/parameters.hpp"
#include "proofs/certificate_file.hpp"
#include "systems/classification_report.hpp"
#include "systems/study_report.hpp"

#include <filesystem>

namespace kov::cli {

Json json_of_round(const System& s) {
  Json set = Json::object();
  for (const auto& [name, value] : s.values)
    set[name] = to_string(value);
  return Json{{"format", "kovacic-result/1"},
              {"input", Json{{"file", s.file}}},
              {"title", s.title},
              {"set", set},
              {"assumptions", list_of(s.assumptions, [](const auto& x) { return x.text; })},
              {"claims", Json::array()},
              {"manifolds", Json::array()},
              {"seconds", 0}};
}

Json json_of_claims(const System& s, const std::vector<ClaimReport>& claims) {
  Json j{{"claims", Json::array()}, {"expected", Json::array()}};
  for (const ClaimReport& c : claims) {
    if (c.claim.line == 0) continue; // not of the file
    j["claims"].push_back(json_of(c));
    std::string where;
    for (const MPoly& g : not_excluded(s, c.result.generic))
      where += (where.empty() ? " where " : ", ") + to_string(g) + " != 0";
    j["expected"].push_back(
        {{"name", title_of(c.claim) + (c.claim.holds ? ": proved" + where : ": refuted")},
         {"found", is_met(c.claim, c.result) ? "" : c.result.detail},
         {"limit", !c.result.open.empty()}});
  }
  return j;
}

namespace {

// Nothing of the manifold but its name and its verdict stands twice.
Json json_of(const study::HigherOrders& h) {
  Json j{{"up_to", h.up_to}};
  if (!h.planes.open.empty() && !h.excluded) j["open"] = h.planes.open;
  if (!h.excluded) return j;
  const ExclusionReason& by = h.excluded->by;
  j["order"] = by.order;
  if (by.rule != Rule::quadratures) j["residue"] = to_string(h.planes.obstruction->logarithm.form);
  j["level"] = sentence(by.level);
  j["exceptions"] = exceptions(h);
  j["without"] = by.integrals.without;
  j["not_checked"] = text_or_null(by.unchecked);
  j["reason"] = by.reason;
  j["theorem"] = by.theorems.front()->name;
  j["trusted"] = sentences(by.trusted);
  return j;
}

} // namespace

Json json_of(const System& s, const study::CurveStudy& m) {
  Json j = json_of(s, m.first);
  j["verdict"] = to_string(m.headline.verdict);
  if (m.higher) j["higher_orders"] = json_of(*m.higher);
  for (const std::string& part : m.failed)
    j["failed"].push_back(part);
  return j;
}

Json json_of_together(const SystemClassification& c) {
  return {{"statement", c.excluded.empty() ? Json(nullptr) : Json(statement(c))},
          {"integrals_class", c.excluded.empty() ? Json(nullptr) : Json(integrals_class(c))},
          {"assumptions", c.assumptions},
          {"theorems", theorem_names(c.theorems)},
          {"trusted", sentences(c.trusted)},
          {"strata", strata_json(c)}};
}

void file_certificates(const Settings& settings, const System& s,
                       const std::vector<NamedCertificate>& proofs, Report& answer) {
  std::string values;
  for (const auto& [name, value] : s.values)
    values += "-" + name + "=" + to_string(value);
  Json& json = answer.json.at("manifold");
  json["certificate_files"] = Json::array();
  for (const NamedCertificate& c : proofs) {
    if (c.json.empty()) {
      json["no_certificate"].push_back(c.name + ": " + c.none);
      answer.text += labelled("no proof", "of " + c.name + ": " + c.none);
      continue;
    }
    const std::string path = file_certificate(
        settings, std::filesystem::path(s.file).stem().string() + values + "-" + c.name, c.json);
    json["certificate_files"].push_back(path);
    answer.text +=
        labelled("proof", "written to " + path + "; check it with: kovacic verify " + path);
  }
}

void put(Json& result, const study::Headline& h) {
  result["verdict"] = to_string(h.verdict);
  result["integrals_class"] = h.excluded.empty() ? Json(nullptr) : Json(sentence(h.excluded));
  result["trusted"] = h.trusted;
  result["not_checked"] = h.unchecked;
  result["complete"] = h.complete;
}

int exit_of(const Settings& settings, const study::Headline& h) {
  if (h.refused > 0) return exit_input;
  const Truth abelian = h.verdict == Verdict::non_integrable   ? Truth::no
                        : h.verdict == Verdict::no_obstruction ? Truth::yes
                                                               : Truth::unknown;
  return settings.exit_of(abelian, h.verdict != Verdict::undecided);
}

} // namespace kov::cli
