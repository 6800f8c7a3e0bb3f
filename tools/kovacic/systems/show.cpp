// kovacic show FILE --stage system|lowest|ve|nve|ode|r: one stage as exact text.

#include "commands.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "study/study.hpp"
#include "system/weights.hpp"
#include "systems/mechanics.hpp"

#include <sstream>

namespace kov::cli {
namespace {

void print_linear(const LinearSystem& s, std::ostringstream& out) {
  for (std::size_t i = 0; i < s.a.size(); ++i) {
    out << "  d" << s.names[i] << "' =";
    bool any = false;
    for (std::size_t j = 0; j < s.a.size(); ++j)
      if (!is_zero(s.a[i][j])) {
        out << (any ? " + " : " ") << "(" << to_string(s.a[i][j]) << ")*d" << s.names[j];
        any = true;
      }
    out << (any ? "\n" : " 0\n");
  }
}

void print_ode(const System& s, const AlgebraicOde& o, bool only_r, std::ostringstream& out) {
  const std::string z = s.ring()->name(o.z);
  out << "  " << o.change << "   (the variation of " << o.unknown << ")\n";
  if (o.z_dot_squared) out << "  z_dot_squared = " << to_factored_string(*o.z_dot_squared) << "\n";
  if (o.z_ddot) out << "  z_ddot = " << to_factored_string(*o.z_ddot) << "\n";
  if (!only_r && o.p)
    out << "  p = " << to_factored_string(*o.p) << "\n  q = " << to_factored_string(*o.q) << "\n";
  out << "  r = " << to_factored_string(o.r) << "\n";
  std::vector<std::string> nonzero;
  for (const auto& g : o.generic)
    add_once(nonzero, to_string(g) + " != 0");
  if (!nonzero.empty()) out << "  where " << joined(nonzero) << "\n";
}

Json lowest_json(const System& s, const LowestSystem& low) {
  const Json terms = list_of(low.hamiltonian, [](const auto& t) {
    return Json{{"degree", t.degree}, {"term", to_string(t.value)}};
  });
  Json field;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    field[s.field.name(j)] = to_string(low.components[j]);
  Json j{{"degree", low.degree}, {"field", field}, {"hamiltonian", terms}};
  j["bracket_degree"] = low.structure ? Json(*low.structure) : Json(nullptr);
  j["is_hamiltonian"] = low.is_hamiltonian;
  return j;
}

Report show_lowest(const System& s) {
  const LowestSystem low = lowest_system(s, s.expansion_terms);
  std::ostringstream out;
  for (const auto& t : low.hamiltonian)
    out << "H_" << t.degree << " = " << to_string(t.value) << "\n";
  out << "lowest-order field, of degree " << low.degree
      << (low.is_hamiltonian ? " (the Hamiltonian field of the first term)\n" : "\n");
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    out << "  " << s.field.name(j) << "' = " << to_string(low.components[j]) << "\n";
  if (low.structure)
    out << "the bracket lowers degrees by " << *low.structure
        << ": lowest terms of first integrals are first integrals of this field\n";
  return {exit_decided, out.str(), lowest_json(s, low)};
}

Report show_system(const System& s) {
  std::ostringstream out;
  if (s.field.hamiltonian) out << "H = " << to_string(*s.field.hamiltonian) << "\n";
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    out << s.field.name(j) << "' = " << to_string(s.field.components[j]) << "\n";
  for (const FunctionSymbol& f : s.field.functions)
    if (!f.meaning.empty()) out << s.ring()->name(f.variable) << " = " << f.meaning << "\n";
  for (const auto& f : s.field.relations)
    out << to_string(f) << " = 0\n";
  return {exit_decided, out.str(), json_of_field(s)};
}

Json stage_json(const std::string& stage, const System& s, const ManifoldReport& m) {
  Json one{{"name", m.name}};
  if (m.failure) {
    one["error"] = m.failure->message;
    return one;
  }
  if (stage == "ve") {
    one["coordinates"] = json_of_field(s).at("coordinates");
    one["parameters"] = json_of_field(s).at("parameters");
    one["ve"] = json_of(m.variational);
    const auto name = [&](std::size_t i) { return m.variational.names[i]; };
    one["blocks"] =
        list_of(m.variational_blocks, [&](const auto& block) { return list_of(block, name); });
  }
  if (stage == "nve") {
    one["coordinates"] = json_of_field(s).at("coordinates");
    one["parameters"] = json_of_field(s).at("parameters");
    one["nve"] = json_of(m.normal.system);
    one["linear_integrals"] = list_of(m.normal.integrals, [](const auto& i) {
      return Json{{"name", i.name}, {"coefficients", texts(i.coefficients)}};
    });
    one["reduced"] = json_of(m.reduced.system);
  }
  Json blocks = Json::array();
  for (const auto& b : m.blocks) {
    Json block{{"unknowns", b.unknowns}};
    if (stage == "ode")
      block["scalar"] = list_of(b.scalar, [](const auto& e) { return json_of(e); });
    if (b.ode && (stage == "ode" || stage == "r")) block.update(json_of(s, *b.ode));
    if (!b.missing.empty()) block["note"] = note(b.missing);
    blocks.push_back(std::move(block));
  }
  if (stage == "ode" || stage == "r") one["blocks"] = blocks;
  return one;
}

void print_stage(const std::string& stage, const System& s, const ManifoldReport& m,
                 std::ostringstream& out) {
  out << s.file << "  [" << m.name << "]\n";
  for (const std::string& constant : s.adjoined)
    out << "  where " << constant << "\n";
  if (m.failure) {
    out << "  " << m.failure->message << "\n";
    return;
  }
  if (stage == "ve") print_linear(m.variational, out);
  if (stage == "nve") {
    print_linear(m.normal.system, out);
    for (const auto& e : m.reduced.eliminations)
      out << "  eliminated by d" << e.integral << " = 0: d" << e.unknown << "\n";
    if (!m.reduced.eliminations.empty()) print_linear(m.reduced.system, out);
  }
  for (const auto& b : m.blocks) {
    if (stage == "ode")
      for (const auto& e : b.scalar)
        out << "  y = d" << e.unknown << ":  y'' + a1 y' + a0 y = 0\n    a1 = " << to_string(e.a1)
            << "\n    a0 = " << to_string(e.a0) << "\n";
    if (b.ode && (stage == "ode" || stage == "r")) print_ode(s, *b.ode, false, out);
    if (!b.missing.empty() && (stage == "ode" || stage == "r"))
      out << "  " << note(b.missing) << "\n";
  }
  for (const auto& r : reasons(m))
    if (m.blocks.empty()) out << "  " << r << "\n";
}

Report show_manifolds(const Settings& settings, const std::string& stage, const Entry& file) {
  CheckOptions options;
  options.decide = settings.solver_options();
  options.only_manifold = settings.manifold;
  options.stop_at_r = true;
  const auto studied = study::study(file, parameter_values(settings), {.check = options});
  const System& s = studied.system;
  const bool asks_for_r = stage == "r" || stage == "ode";
  Report result;
  result.json = Json::object();
  std::ostringstream out;
  Json all = Json::array();
  for (const auto& curve : studied.manifolds) {
    const ManifoldReport& m = curve.first;
    if (m.failure) result.exit = exit_input;
    all.push_back(stage_json(stage, s, m));
    print_stage(stage, s, m, out);
    for (const auto& b : m.blocks) {
      if (result.exit == exit_decided && asks_for_r && !b.ode && b.unknowns.size() > 1)
        result.exit = exit_undecided;
    }
  }
  if (studied.manifolds.empty()) {
    out << s.file << "\n  no such manifold in this file (see kovacic find-manifolds)\n";
    result.exit = exit_input;
  }
  // What there is one of stands at the top as well.
  if (all.size() == 1) result.json.update(all[0]);
  for (const Json& m : all)
    if (asks_for_r && m.contains("blocks"))
      for (const Json& b : m.at("blocks"))
        if (b.contains("r") && !result.json.contains("r")) result.json.update(b);
  result.json.erase("name");
  result.json["manifolds"] = all;
  result.text = out.str();
  return result;
}

} // namespace

int show(const Settings& settings, const std::string& file, const std::string& stage) {
  Report report = supervised(settings, file, [&] {
    const Entry document = settings.document(file);
    if (stage != "system" && stage != "lowest") return show_manifolds(settings, stage, document);
    const System s = read_system(document, parameter_values(settings));
    return stage == "system" ? show_system(s) : show_lowest(s);
  });
  if (!report.json.is_null()) {
    Json j{{"format", "kovacic-stage/1"}, {"stage", stage}, {"file", file}};
    j.update(report.json);
    report.json = std::move(j);
  }
  return written_report(settings, report);
}

} // namespace kov::cli
