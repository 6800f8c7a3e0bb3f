// kovacic check FILE: the whole way from a system to one verdict per manifold.

#include "mechanics.hpp"
#include "mechanics_json.hpp"

#include <ostream>

namespace kov::cli {
namespace {

std::string heading(VerdictKind v) {
  return v == VerdictKind::non_integrable   ? "NON-INTEGRABLE"
         : v == VerdictKind::no_obstruction ? "NO OBSTRUCTION"
                                            : "UNDECIDED";
}

void print_decision(const Decision& d, const std::string& indent, std::ostream& out) {
  out << indent;
  if (d.group)
    out << "G = " << describe(*d.group) << ", ";
  else
    out << "G not determined, ";
  if (d.component) out << "identity component " << to_string(*d.component) << ", ";
  out << (d.abelian == Truth::yes  ? "abelian"
          : d.abelian == Truth::no ? "not abelian"
                                   : "abelian or not: undecided")
      << "\n"
      << indent << "because " << d.reason << "\n";
}

void print_block(const System& s, const BlockReport& b, std::ostream& out) {
  if (b.ode) {
    const std::string z = s.ring()->name(b.ode->z);
    out << "  " << b.ode->change << ",  unknown: the variation of " << b.ode->unknown << "\n"
        << "  y'' = r(" << z << ") y,  r = " << to_string(b.ode->r) << "\n";
  }
  if (b.decision) print_decision(*b.decision, "  ", out);
  for (const auto& f : b.special)
    out << "  singular places merge where " << to_string(f) << " = 0\n";
  for (const auto& e : b.energies) {
    out << "  at " << e.condition << " (" << e.why << ")\n";
    if (e.decision) print_decision(*e.decision, "    ", out);
    if (!e.note.empty()) out << "    " << e.note << "\n";
  }
  if (!b.note.empty()) out << "  " << b.note << "\n";
}

void print_manifold(const System& s, const ManifoldReport& m, std::ostream& out) {
  out << s.file << "  [" << m.name << "]";
  for (const auto& [name, value] : s.values)
    out << "  " << name << " = " << to_string(value);
  out << "\n  " << heading(m.verdict);
  if (m.verdict == VerdictKind::non_integrable)
    out << "  (" << m.theorem << "; no complete set of first integrals that are "
        << m.function_class << ")";
  if (m.verdict == VerdictKind::no_obstruction)
    out << "  (the first-order test of " << m.theorem
        << " passes; this does not prove integrability)";
  out << "\n";
  if (m.failure) {
    out << "  " << m.failure->message << "\n";
    return;
  }
  for (const auto& e : m.reduced.eliminations)
    out << "  the variation of " << e.unknown << " is eliminated by d" << e.integral << " = 0\n";
  for (const auto& b : m.blocks)
    print_block(s, b, out);
  if (m.blocks.empty())
    for (const auto& r : m.reasons)
      out << "  " << r << "\n";
}

void print_claim(const ClaimReport& c, std::ostream& out) {
  out << "  " << claim_kind(c.claim.kind) << " "
      << (c.claim.name.empty() ? c.claim.text : c.claim.name) << ": "
      << (c.result.proved ? "proved" : "REFUTED") << "  (" << c.result.detail << ")\n";
}

int exit_code(const MechanicsArguments& a, const CheckReport& report) {
  bool undecided = false;
  bool obstruction = false;
  bool refuted = false;
  for (const auto& m : report.manifolds) {
    if (m.failure) return 2;
    undecided = undecided || m.verdict == VerdictKind::undecided;
    obstruction = obstruction || m.verdict == VerdictKind::non_integrable;
  }
  for (const auto& c : report.claims)
    refuted = refuted || c.result.proved != c.claim.holds;
  if (refuted) return 1;
  if (a.exit_verdict) return obstruction ? 10 : undecided ? 0 : 20;
  return undecided && !obstruction ? 3 : 0;
}

} // namespace

int run_check(const MechanicsArguments& a, std::ostream& out) {
  const System s = read_system(a.file, a.set);
  CheckOptions options;
  options.decide = a.decide;
  options.only_manifold = a.manifold;
  const CheckReport report = check_system(s, options);
  if (a.format == "json") {
    Json j{{"format", "kovacic-result/1"}, {"input", Json{{"file", s.file}}}, {"title", s.title}};
    Json set = Json::object();
    for (const auto& [name, value] : s.values)
      set[name] = to_string(value);
    j["set"] = set;
    Json assumptions = Json::array();
    for (const auto& x : s.assumptions)
      assumptions.push_back(x.text);
    j["assumptions"] = assumptions;
    Json claims = Json::array();
    for (const auto& c : report.claims)
      claims.push_back(json_of(c));
    j["claims"] = claims;
    Json manifolds = Json::array();
    for (const auto& m : report.manifolds)
      manifolds.push_back(json_of(s, m));
    j["manifolds"] = manifolds;
    j["seconds"] = report.seconds;
    out << j.dump(2) << "\n";
    return exit_code(a, report);
  }
  for (const auto& m : report.manifolds)
    print_manifold(s, m, out);
  if (report.manifolds.empty())
    out << s.file << "\n  no manifold in this file (see kovacic find-manifolds)\n";
  if (!report.claims.empty()) out << "claims\n";
  for (const auto& c : report.claims)
    print_claim(c, out);
  return exit_code(a, report);
}

} // namespace kov::cli
