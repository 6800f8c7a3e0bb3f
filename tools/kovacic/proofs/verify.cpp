// kovacic verify CERT...: the judge of lib/certify, which shares only lib/exact with the solver.
// Exit 0: all accepted; 1: one was rejected; 2: one is not a certificate.

#include "commands.hpp"
#include "equations/answer.hpp"
#include "proofs/verify_explain.hpp"

#include "certify/equation/statement.hpp"
#include "certify/homoclinic/check.hpp"
#include "certify/jets/check.hpp"
#include "certify/loops/check.hpp"
#include "certify/strata/check.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/check.hpp"
#include "exact/error.hpp"
#include "symbol/document.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace kov::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_certificate = std::size_t{256} << 20;

std::string trust(std::size_t steps) {
  return std::to_string(steps) + (steps == 1 ? " trusted step" : " trusted steps");
}

Json claim_of(const certify::Claim& c) {
  const auto optional = [](const auto& v) { return v ? Json(*v) : Json(nullptr); };
  return {{"group", optional(c.group)},
          {"n", c.n ? Json(to_string(*c.n)) : Json(nullptr)},
          {"component", optional(c.component)},
          {"abelian", optional(c.abelian)}};
}

Json rejected(Json r, const char* where, const certify::Rejected& no) {
  r["verdict"] = "rejected";
  r[where] = no.step;
  r["reason"] = no.why;
  return r;
}

std::string not_checked(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " hypothesis" : " hypotheses") + " NOT CHECKED";
}

Json accepted(Json r, std::size_t trusted, bool strict, std::size_t unchecked = 0) {
  const bool refused = strict && trusted + unchecked > 0;
  r["verdict"] = refused ? "rejected" : "accepted";
  r["trusted_steps"] = trusted;
  if (refused)
    r["reason"] = (trusted ? trust(trusted) : not_checked(unchecked)) + ", refused by --strict";
  return r;
}

Json judge_group(Json r, const std::string& certificate, bool strict) {
  const certify::Certificate c = certify::read_certificate(certificate);
  const auto verdict = certify::check(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "step", *no);
  r["steps"] = c.steps.size();
  r["statement"] = certify::statement(c);
  r = accepted(r, std::get<certify::Accepted>(verdict).trusted_steps, strict);
  r["limits"] = "one equation, over C(z)";
  r["claim"] = claim_of(c.claim);
  return r;
}

Json judge_strata(Json r, const std::string& certificate, bool strict) {
  const certify::StrataCertificate c = certify::read_strata_certificate(certificate);
  const auto verdict = certify::check_strata(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "node", *no);
  const auto& yes = std::get<certify::StrataAccepted>(verdict);
  r = accepted(r, yes.trusted, strict);
  r["statement"] = certify::statement(c, yes);
  r["strata"] = Json{{"abelian", yes.abelian},           {"not_abelian", yes.not_abelian},
                     {"by_criterion", yes.by_criterion}, {"undecided", yes.open},
                     {"not_admitted", yes.outside},      {"empty", yes.empty}};
  r["claim"] = {{"abelian", yes.claim ? Json(*yes.claim) : Json(nullptr)}};
  r["limits"] = "parameters with the conditions of the statement, without its exceptions" +
                std::string(yes.open > 0 ? "; undecided where it says so" : "");
  return r;
}

Json judge_system(Json r, const std::string& certificate, bool strict) {
  const certify::SystemCertificate c = certify::read_system_certificate(certificate);
  const auto verdict = certify::check_way(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "rule", *no);
  const auto& yes = std::get<certify::SystemAccepted>(verdict);
  r = accepted(r, yes.trusted, strict);
  r["statement"] = certify::statement(c, yes);
  r["system"] = yes.not_integrable ? "not integrable"
                : yes.somewhere    ? "not integrable for some parameters"
                                   : "nothing follows";
  r["claim"] = {{"not_integrable", yes.not_integrable}};
  r["uses"] = {yes.integrals.liouville && !c.way.normal.whole ? "Morales-Ramis" : "Ayoul-Zung"};
  r["limits"] = "first integrals that are " + sentence(yes.integrals) +
                ", along one phase curve; parameters without the exceptions of the statement";
  return r;
}

Json judge_jets(Json r, const std::string& certificate, bool strict) {
  const certify::JetsCertificate c = certify::read_jets_certificate(certificate);
  const auto verdict = certify::check_jets(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "rule", *no);
  const auto& yes = std::get<certify::JetsAccepted>(verdict);
  r = accepted(r, yes.trusted, strict);
  r["statement"] = certify::statement(c, yes);
  r["system"] = "not integrable";
  r["uses"] = {"Morales-Ramis-Simo"};
  r["limits"] =
      "first integrals that are meromorphic near the phase curve, at the energies and for "
      "the parameters of the statement";
  return r;
}

Json judge_theorem(Json r, const std::string& certificate, bool strict) {
  const auto verdict = certify::check_theorem(certificate);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "rule", *no);
  const auto& yes = std::get<certify::TheoremAccepted>(verdict);
  r = accepted(r, yes.trusted, strict, yes.unchecked);
  r["statement"] = yes.statement;
  if (yes.open > 0) r["open_regions"] = yes.open;
  r["given"] = {{"theorems", yes.theorems.size()}, {"unchecked_hypotheses", yes.unchecked}};
  r["uses"] = yes.theorems;
  r["limits"] = (yes.excluded.empty() ? "" : first_integrals(yes.excluded) + "; ") +
                "parameters without the exceptions of the statement" +
                (yes.open > 0 ? "; nothing is said where it says so" : "");
  return r;
}

Json judge_loops(Json r, const std::string& certificate, bool strict) {
  const certify::LoopsCertificate c = certify::read_loops_certificate(certificate);
  const auto verdict = certify::check_loops(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "rule", *no);
  r["statement"] = certify::statement(c);
  r["limits"] = "one system Y' = A(z) Y, over C(z)";
  return accepted(r, std::get<certify::Accepted>(verdict).trusted_steps, strict);
}

Json judge_homoclinic(Json r, const std::string& certificate, bool strict) {
  const certify::HomoclinicCertificate c = certify::read_homoclinic_certificate(certificate);
  const auto verdict = certify::check_homoclinic(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return rejected(r, "rule", *no);
  const auto& yes = std::get<certify::HomoclinicAccepted>(verdict);
  r = accepted(r, yes.trusted, strict);
  r["statement"] = certify::statement(c, yes);
  r["system"] = "transverse homoclinic point";
  r["limits"] =
      "first integrals that are real-analytic near the closure of one orbit, on one level";
  return r;
}

// The outcome of one text: "accepted", "rejected" or "malformed", with its reason.
Json judge_text(const std::string& path, const std::string& certificate, bool strict) {
  Json r{{"file", path}};
  try {
    const auto format = certify::format_of(certificate);
    if (format == "kovacic-strata/1") return judge_strata(r, certificate, strict);
    if (format == "kovacic-system/1") return judge_system(r, certificate, strict);
    if (format == "kovacic-jets/1") return judge_jets(r, certificate, strict);
    if (format == "kovacic-loops/1") return judge_loops(r, certificate, strict);
    if (format == "kovacic-homoclinic/1") return judge_homoclinic(r, certificate, strict);
    if (format == "kovacic-theorem/1") return judge_theorem(r, certificate, strict);
    return judge_group(r, certificate, strict);
  } catch (const Error& e) {
    r["verdict"] = "malformed";
    r["reason"] = e.what();
  }
  return r;
}

// With what must be believed, and the steps.
Json judge(const std::string& path, const std::string& certificate, const Settings& settings) {
  std::optional<certify::CheckedSteps> steps;
  if (settings.needs || settings.explain) steps.emplace();
  Json r = judge_text(path, certificate, settings.strict);
  if (steps && r["verdict"] == "accepted") {
    if (settings.explain) r["explain"] = explained(steps->all());
    if (settings.needs)
      r["needs"] = needed(steps->all(), r.value("uses", std::vector<std::string>{}),
                          r["trusted_steps"].get<std::size_t>(), r["limits"].get<std::string>());
  }
  r.erase("uses");
  r.erase("limits");
  return r;
}

// The same in a process of its own: a text made to exhaust the memory is refused like any other.
Json judge_file(const Settings& settings, const std::string& path) {
  std::string certificate;
  try {
    certificate = read_text(path, largest_certificate);
  } catch (const InputError& e) {
    return {{"file", path}, {"verdict", "malformed"}, {"reason", e.message()}};
  }
  const TextAnswer a = limited(settings, [&](std::ostream& out) {
    out << dump(judge(path, certificate, settings));
    return 0;
  });
  if (!a.text.empty()) return Json::parse(a.text);
  const std::string why = a.exit == exit_interrupted ? "interrupted" : a.limit + a.internal;
  return {{"file", path}, {"verdict", "rejected"}, {"reason", why}};
}

std::string claim_text(const Json& claim) {
  std::string s;
  const auto add = [&](const std::string& part) { s += (s.empty() ? "" : ", ") + part; };
  if (!claim["group"].is_null()) {
    const std::string n = claim["n"].is_null() ? "" : "_" + claim["n"].get<std::string>();
    add("G = " + claim["group"].get<std::string>() + n);
  }
  if (!claim["component"].is_null())
    add("identity component " + claim["component"].get<std::string>());
  if (!claim["abelian"].is_null())
    add(std::string("identity component ") + (claim["abelian"].get<bool>() ? "" : "not ") +
        "abelian");
  return s;
}

// "13 strata: 1 abelian, 12 not abelian": the strata without points are left out.
std::string strata_text(const Json& strata) {
  std::size_t all = 0;
  std::string s;
  for (const auto& [key, name] : {std::pair("abelian", "abelian"),
                                  {"not_abelian", "not abelian"},
                                  {"by_criterion", "by a criterion"},
                                  {"undecided", "undecided"}}) {
    const auto n = strata[key].get<std::size_t>();
    all += n;
    if (n > 0) s += (s.empty() ? ": " : ", ") + std::to_string(n) + " " + name;
  }
  return std::to_string(all) + (all == 1 ? " stratum" : " strata") + s;
}

// "given 3 theorems of the literature and 1 hypothesis NOT CHECKED; 0 trusted steps"
std::string given_text(const Json& given, std::size_t trusted) {
  const auto n = given["theorems"].get<std::size_t>();
  const auto open = given["unchecked_hypotheses"].get<std::size_t>();
  std::string s =
      "given " + std::to_string(n) + (n == 1 ? " theorem" : " theorems") + " of the literature";
  if (open > 0) s += " and " + not_checked(open);
  return s + "; " + trust(trusted);
}

// One line, and the statement: what a certificate says cannot look like another line.
std::string text(const Json& r) {
  std::string s = printable(r["file"].get<std::string>()) + ": " + r["verdict"].get<std::string>();
  if (r.contains("strata"))
    s +=
        " (" + strata_text(r["strata"]) + "; " + trust(r["trusted_steps"].get<std::size_t>()) + ")";
  else if (r.contains("given"))
    s += " (" + given_text(r["given"], r["trusted_steps"].get<std::size_t>()) + ")";
  else if (r.contains("system"))
    s += " (" + r["system"].get<std::string>() + "; " +
         trust(r["trusted_steps"].get<std::size_t>()) + ")";
  else if (r.contains("claim"))
    s += " (" + claim_text(r["claim"]) + "; " + std::to_string(r["steps"].get<std::size_t>()) +
         " steps, " + trust(r["trusted_steps"].get<std::size_t>()) + ")";
  else if (r.contains("trusted_steps"))
    s += " (" + trust(r["trusted_steps"].get<std::size_t>()) + ")";
  if (r.contains("step") && !r["step"].get<std::string>().empty())
    s += ": step '" + printable(r["step"].get<std::string>()) + "'";
  for (const char* where : {"node", "rule"})
    if (r.contains(where)) s += ": " + r[where].get<std::string>();
  if (r.contains("reason")) s += ": " + printable(r["reason"].get<std::string>());
  s += "\n";
  if (r["verdict"] != "accepted") return s;
  for (const auto& line : r["statement"])
    s += "  " + line.get<std::string>() + "\n";
  for (const char* more : {"explain", "needs"})
    for (const auto& line : r.value(more, Json::array()))
      s += "  " + line.get<std::string>() + "\n";
  return s;
}

} // namespace

int verify(const Settings& settings, const std::vector<std::string>& files) {
  std::string out;
  int code = exit_decided;
  for (const std::string& f : files) {
    const Json r = judge_file(settings, f);
    const bool accepted = r["verdict"] == "accepted";
    code = std::max<int>(code, accepted                     ? exit_decided
                               : r["verdict"] == "rejected" ? exit_no
                                                            : exit_input);
    out += settings.format == "json" ? r.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"
                                     : text(r);
  }
  if (!settings.quiet) write_output(settings, out);
  return code;
}

} // namespace kov::cli
