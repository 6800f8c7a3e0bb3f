// kovacic check on a system file: claims, then one verdict per manifold and set of values.

#include "case_file.hpp"
#include "certificate_file.hpp"
#include "commands.hpp"
#include "integrability/certificate.hpp"
#include "integrability/expect.hpp"
#include "integrability/parameters.hpp"
#include "mechanics.hpp"
#include "present_strata.hpp"
#include "verdict/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace kov::cli {
namespace {

void put(std::ostringstream& out, const std::string& label, const std::string& text,
         std::size_t indent = 2) {
  const std::size_t column = indent + 10;
  out << std::string(indent, ' ') << label
      << std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') << wrapped(text, column)
      << "\n";
}

std::string headline(const ManifoldReport& m) {
  switch (m.verdict) {
  case VerdictKind::non_integrable:
    return "NON-INTEGRABLE  (" + m.theorem + ": " + m.statement + ")";
  case VerdictKind::no_obstruction:
    return "NO OBSTRUCTION  (the first-order test of " + m.theorem +
           " passes; this does not prove integrability)";
  case VerdictKind::depends:
    return "DEPENDS ON THE PARAMETERS  (" + m.theorem + "; " + m.statement + ")";
  default:
    return "UNDECIDED";
  }
}

void put_decision(std::ostringstream& out, const Decision& d, std::size_t indent) {
  std::string group = d.group ? "G = " + describe(*d.group) : "G not determined";
  if (d.component) group += ", identity component " + to_string(*d.component);
  group += d.abelian == Truth::yes  ? ", abelian"
           : d.abelian == Truth::no ? ", not abelian"
                                    : ", abelian or not: undecided";
  put(out, "group", group, indent);
  put(out, "because", reason(d), indent);
  Json steps = Json::object();
  put_trace(steps, d.trace);
  print_trace(out, steps);
}

void print(std::ostringstream& out, const strata::StrataAnswer& a) {
  Json j;
  put_strata(j, a);
  print_strata(out, j);
}

void put_block(std::ostringstream& out, const System& s, const BlockReport& b) {
  if (b.ode) {
    const std::string z = s.ring()->name(b.ode->z);
    put(out, "change", b.ode->change + ", y the variation of " + b.ode->unknown);
    put(out, "equation", "y'' = r(" + z + ") y,  r = " + to_factored_string(b.ode->r));
  }
  if (b.decision) put_decision(out, *b.decision, 2);
  if (b.strata) print(out, *b.strata);
  for (const auto& f : b.special)
    put(out, "merging", "singular places meet where " + to_string(f) + " = 0");
  for (const auto& e : b.energies) {
    put(out, "at", e.condition + "  (" + e.why + ")");
    if (e.decision) put_decision(out, *e.decision, 4);
    if (e.strata) print(out, *e.strata);
    if (!e.note.empty()) put(out, "note", e.note, 4);
  }
  if (!b.note.empty()) put(out, "note", b.note);
}

// On what the verdict rests; the steps of the strata are named with them.
void put_trust(std::ostringstream& out, const ManifoldReport& m) {
  const auto steps = trusted_steps(m);
  if (m.verdict == VerdictKind::undecided || steps.empty()) return;
  put(out, "trusted",
      steps.size() == 1
          ? "1 step: " + steps.front()
          : std::to_string(steps.size()) + " steps: " + steps.front() + ", and those named above");
}

void put_manifold(std::ostringstream& out, const System& s, const ManifoldReport& m, bool quiet) {
  out << s.file << "  [" << m.name << "]";
  for (const auto& [name, value] : s.values)
    out << "  " << name << " = " << to_string(value);
  out << "\n";
  if (m.failure) {
    put(out, "error", m.failure->message);
    return;
  }
  out << "  " << wrapped(headline(m), 2) << "\n";
  if (m.manifold)
    for (const auto& line : m.manifold->rewritten)
      put(out, "note", line);
  if (!m.not_checked.empty() && m.verdict != VerdictKind::undecided)
    put(out, "NOT CHECKED", m.not_checked);
  if (quiet && m.verdict != VerdictKind::undecided) return;
  for (const auto& e : m.reduced.eliminations)
    put(out, "reduced",
        "the variation of " + e.unknown + " by the linear integral d" + e.integral + " = 0");
  for (const auto& b : m.blocks)
    put_block(out, s, b);
  if (m.blocks.empty())
    for (const auto& r : m.reasons)
      put(out, "because", r);
  else if (m.verdict == VerdictKind::undecided && !m.not_studied.empty())
    put(out, "open", m.reasons.back());
  put_trust(out, m);
}

std::string text_of(const System& s, const ManifoldReport& m, bool quiet) {
  std::ostringstream out;
  put_manifold(out, s, m, quiet);
  return out.str();
}

Json json_of_report(const System& s, const CheckReport& report) {
  Json set = Json::object();
  for (const auto& [name, value] : s.values)
    set[name] = to_string(value);
  Json assumptions = Json::array();
  for (const auto& x : s.assumptions)
    assumptions.push_back(x.text);
  Json claims = Json::array();
  for (const auto& c : report.claims)
    claims.push_back(json_of(c));
  Json manifolds = Json::array();
  for (const auto& m : report.manifolds)
    manifolds.push_back(json_of(s, m));
  return Json{{"format", "kovacic-result/1"},
              {"input", Json{{"file", s.file}}},
              {"title", s.title},
              {"set", set},
              {"assumptions", assumptions},
              {"claims", claims},
              {"manifolds", manifolds},
              {"seconds", report.seconds}};
}

int exit_of(const Settings& settings, const CheckReport& report) {
  const auto any = [&](VerdictKind kind) {
    return std::any_of(report.manifolds.begin(), report.manifolds.end(),
                       [kind](const ManifoldReport& m) { return !m.failure && m.verdict == kind; });
  };
  for (const auto& m : report.manifolds)
    if (m.failure) return exit_input;
  const bool obstruction = any(VerdictKind::non_integrable);
  const bool open = any(VerdictKind::undecided);
  const bool none = !report.manifolds.empty() && !open && !any(VerdictKind::depends);
  return settings.exit_of(obstruction ? Truth::no
                          : none      ? Truth::yes
                                      : Truth::unknown,
                          obstruction || !open);
}

/// One reading of the file with its values: a report, and the expectations that apply to them.
class SystemRun {
public:
  SystemRun(const Settings& settings, const Entry& document)
      : settings_(settings), document_(document), base_(parameter_values(settings)) {
    options_.decide = settings.solver_options();
    options_.only_manifold = settings.manifold;
  }

  Report run() {
    const System file = read_system(document_, base_);
    report_.exit = settings_.nothing_yet();
    report_.json = Json{{"results", Json::array()}, {"expected", Json::array()}};
    std::vector<ParameterValues> rounds; // each set of values once
    for (const auto& x : file.expectations)
      if (base_.empty() && std::find(rounds.begin(), rounds.end(), x.where) == rounds.end())
        rounds.push_back(x.where);
    if (rounds.empty()) rounds.push_back(base_);
    for (const auto& values : rounds)
      round(values);
    return std::move(report_);
  }

private:
  void round(const ParameterValues& values) {
    const System s = read_system(document_, values);
    CheckReport report = check_system(s, options_);
    for (auto& m : report.manifolds)
      if (m.failure && is_fine_without(values, m.name)) degenerate(m);
    if (report_.json.at("results").empty()) claims(report);
    Json json = json_of_report(s, report);
    for (std::size_t i = 0; i < report.manifolds.size(); ++i) {
      report_.text += text_of(s, report.manifolds[i], settings_.quiet);
      if (!settings_.certificate.empty())
        file_certificates(s, report.manifolds[i], json.at("manifolds").at(i));
    }
    if (settings_.verbose > 0)
      report_.text += fmt::format("  time      {:.1f} ms\n", 1000 * report.seconds);
    report_.json.at("results").push_back(std::move(json));
    report_.exit = worse(report_.exit, exit_of(settings_, report));
    for (const auto& x : s.expectations)
      if (x.where == values || (values == base_ && x.where.empty()))
        expect(describe(x), unmet(x, report));
  }

  // Values can turn a curve into points; then they are the reason, and the file is not wrong.
  bool is_fine_without(const ParameterValues& values, const std::string& manifold) const {
    if (values.empty()) return false;
    const System file = read_system(document_, {});
    for (const auto& spec : file.manifolds)
      if (spec.name == manifold)
        return std::holds_alternative<InvariantManifold>(prove_invariant(file.field, spec));
    return false;
  }

  static void degenerate(ManifoldReport& m) {
    m.reasons = {"at these values " + m.failure->message};
    m.failure.reset();
  }

  void file_certificates(const System& s, const ManifoldReport& m, Json& json) {
    std::string values;
    for (const auto& [name, value] : s.values)
      values += "-" + name + "=" + to_string(value);
    json["certificate_files"] = Json::array();
    for (const NamedCertificate& c : certificates(s, m)) {
      if (c.json.empty()) {
        json["no_certificate"].push_back(c.name + ": " + c.none);
        std::ostringstream line;
        put(line, "no proof", "of " + c.name + ": " + c.none);
        report_.text += line.str();
        continue;
      }
      const std::string path = file_certificate(
          settings_, std::filesystem::path(s.file).stem().string() + values + "-" + c.name, c.json);
      json["certificate_files"].push_back(path);
      std::ostringstream line;
      put(line, "proof", path + "   verify: kovacic verify " + path);
      report_.text += line.str();
    }
  }

  void claims(const CheckReport& report) {
    for (const auto& c : report.claims) {
      const bool met = c.result.proved == c.claim.holds;
      std::string where;
      for (const MPoly& g : not_excluded(report.system, c.result.generic))
        where += (where.empty() ? " where " : ", ") + to_string(g) + " != 0";
      expect(title_of(c.claim) + (c.claim.holds ? ": proved" + where : ": refuted"),
             met ? "" : c.result.detail);
    }
    if (report.system.manifolds.empty())
      report_.text +=
          report.system.file + "  " + report.system.title +
          "\n  note      no [[manifold]] in this file; kovacic find-manifolds proposes some\n";
  }

  void expect(const std::string& name, const std::string& found) {
    report_.json.at("expected")
        .push_back(Json{{"name", name}, {"met", found.empty()}, {"found", found}});
  }

  const Settings& settings_;
  const Entry& document_;
  ParameterValues base_;
  CheckOptions options_;
  Report report_;
};

} // namespace

CaseReport check_system_file(const Settings& settings, const std::string& path) {
  const Report r = supervised(settings, path, [&] {
    const Entry document = read_document(path);
    return SystemRun(settings, document).run();
  });
  CaseReport report;
  report.exit = settings.exit_verdict && r.exit == exit_undecided ? exit_decided : r.exit;
  report.text = r.text;
  report.json = r.json;
  if (!r.json.contains("expected")) return report;
  report.json = r.json.at("results");
  for (const Json& e : r.json.at("expected"))
    report.expected.push_back({e.at("name"), e.at("met"), e.at("found")});
  return report;
}

// What is expected was compared on the way.
CaseReport test_system_file(const Settings& settings, const std::string& path) {
  CaseReport report = check_system_file(settings, path);
  if (report.json.is_object()) // a limit
    report.expected.push_back(
        {.name = "decided", .met = false, .found = report.json.value("reason", "a limit")});
  return report;
}

} // namespace kov::cli
