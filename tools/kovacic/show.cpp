// kovacic show FILE --stage system|lowest|ve|nve|ode|r: one stage as exact text.

#include "mechanics.hpp"
#include "mechanics_json.hpp"
#include "system/weights.hpp"

#include <ostream>

namespace kov::cli {
namespace {

void print_linear(const LinearSystem& s, std::ostream& out) {
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

void print_ode(const System& s, const AlgebraicOde& o, bool only_r, std::ostream& out) {
  const std::string z = s.ring()->name(o.z);
  out << "  " << o.change << "   (the variation of " << o.unknown << ")\n";
  if (o.z_dot_squared) out << "  z_dot_squared = " << to_string(*o.z_dot_squared) << "\n";
  if (o.z_ddot) out << "  z_ddot = " << to_string(*o.z_ddot) << "\n";
  if (!only_r && o.p) out << "  p = " << to_string(*o.p) << "\n  q = " << to_string(*o.q) << "\n";
  out << "  r = " << to_string(o.r) << "\n";
  for (const auto& g : o.generic)
    out << "  where " << to_string(g) << " is not 0\n";
}

Json lowest_json(const System& s, const LowestSystem& low) {
  Json terms = Json::array();
  for (const auto& t : low.hamiltonian)
    terms.push_back(Json{{"degree", t.degree}, {"term", to_string(t.value)}});
  Json field;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    field[s.field.name(j)] = to_string(low.components[j]);
  Json j{{"degree", low.degree}, {"field", field}, {"hamiltonian", terms}};
  j["bracket_degree"] = low.structure ? Json(*low.structure) : Json(nullptr);
  j["is_hamiltonian"] = low.is_hamiltonian;
  return j;
}

int show_lowest(const MechanicsArguments& a, const System& s, std::ostream& out) {
  const LowestSystem low = lowest_system(s, s.expansion_terms);
  if (a.format == "json") {
    Json j{{"format", "kovacic-stage/1"}, {"stage", "lowest"}, {"file", s.file}};
    j.update(lowest_json(s, low));
    out << j.dump(2) << "\n";
    return 0;
  }
  for (const auto& t : low.hamiltonian)
    out << "H_" << t.degree << " = " << to_string(t.value) << "\n";
  out << "lowest-order field, of degree " << low.degree
      << (low.is_hamiltonian ? " (the Hamiltonian field of the first term)\n" : "\n");
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    out << "  " << s.field.name(j) << "' = " << to_string(low.components[j]) << "\n";
  if (low.structure)
    out << "the bracket lowers degrees by " << *low.structure
        << ": lowest terms of first integrals are first integrals of this field\n";
  return 0;
}

int show_system(const MechanicsArguments& a, const System& s, std::ostream& out) {
  if (a.format == "json") {
    Json j{{"format", "kovacic-stage/1"}, {"stage", "system"}, {"file", s.file}};
    j.update(json_of_field(s));
    out << j.dump(2) << "\n";
    return 0;
  }
  if (s.field.hamiltonian) out << "H = " << to_string(*s.field.hamiltonian) << "\n";
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    out << s.field.name(j) << "' = " << to_string(s.field.components[j]) << "\n";
  for (const auto& f : s.field.relations)
    out << to_string(f) << " = 0\n";
  return 0;
}

Json stage_json(const MechanicsArguments& a, const System& s, const ManifoldReport& m) {
  Json one{{"name", m.name}};
  if (m.failure) {
    one["error"] = m.failure->message;
    return one;
  }
  if (a.stage == "ve") {
    one["ve"] = json_of(m.variational);
    Json all = Json::array();
    for (const auto& block : m.variational_blocks) {
      Json names = Json::array();
      for (const std::size_t i : block)
        names.push_back(m.variational.names[i]);
      all.push_back(names);
    }
    one["blocks"] = all;
  }
  if (a.stage == "nve") {
    one["nve"] = json_of(m.normal.system);
    Json integrals = Json::array();
    for (const auto& i : m.normal.integrals) {
      Json c = Json::array();
      for (const auto& f : i.coefficients)
        c.push_back(to_string(f));
      integrals.push_back(Json{{"name", i.name}, {"coefficients", c}});
    }
    one["linear_integrals"] = integrals;
    one["reduced"] = json_of(m.reduced.system);
  }
  Json blocks = Json::array();
  for (const auto& b : m.blocks) {
    Json block{{"unknowns", b.unknowns}};
    if (a.stage == "ode") {
      Json scalar = Json::array();
      for (const auto& e : b.scalar)
        scalar.push_back(json_of(e));
      block["scalar"] = scalar;
    }
    if (b.ode && (a.stage == "ode" || a.stage == "r")) block.update(json_of(s, *b.ode));
    if (!b.note.empty()) block["note"] = b.note;
    blocks.push_back(std::move(block));
  }
  if (a.stage == "ode" || a.stage == "r") one["blocks"] = blocks;
  return one;
}

void print_stage(const MechanicsArguments& a, const System& s, const ManifoldReport& m,
                 std::ostream& out) {
  out << s.file << "  [" << m.name << "]\n";
  if (m.failure) {
    out << "  " << m.failure->message << "\n";
    return;
  }
  if (a.stage == "ve") print_linear(m.variational, out);
  if (a.stage == "nve") {
    print_linear(m.normal.system, out);
    for (const auto& e : m.reduced.eliminations)
      out << "  eliminated by d" << e.integral << " = 0: d" << e.unknown << "\n";
    if (!m.reduced.eliminations.empty()) print_linear(m.reduced.system, out);
  }
  for (const auto& b : m.blocks) {
    if (a.stage == "ode")
      for (const auto& e : b.scalar)
        out << "  y = d" << e.unknown << ":  y'' + a1 y' + a0 y = 0\n    a1 = " << to_string(e.a1)
            << "\n    a0 = " << to_string(e.a0) << "\n";
    if (b.ode && (a.stage == "ode" || a.stage == "r")) print_ode(s, *b.ode, false, out);
    if (!b.note.empty() && (a.stage == "ode" || a.stage == "r")) out << "  " << b.note << "\n";
  }
  for (const auto& r : m.reasons)
    if (m.blocks.empty()) out << "  " << r << "\n";
}

} // namespace

int run_show(const MechanicsArguments& a, std::ostream& out) {
  const System s = read_system(a.file, a.set);
  if (a.stage == "system") return show_system(a, s, out);
  if (a.stage == "lowest") return show_lowest(a, s, out);
  CheckOptions options;
  options.decide = a.decide;
  options.only_manifold = a.manifold;
  options.stop_at_r = true;
  const CheckReport report = check_system(s, options);
  int code = 0;
  Json all = Json::array();
  for (const auto& m : report.manifolds) {
    if (m.failure) code = 2;
    if (a.format == "json")
      all.push_back(stage_json(a, s, m));
    else
      print_stage(a, s, m, out);
    const bool asks_for_r = a.stage == "r" || a.stage == "ode";
    for (const auto& b : m.blocks)
      if (code == 0 && asks_for_r && !b.ode && b.unknowns.size() > 1) code = 3;
  }
  if (a.format == "json") {
    Json j{{"format", "kovacic-stage/1"}, {"stage", a.stage}, {"file", s.file}};
    // The one equation of a file with one block stands at the top as well.
    for (const auto& m : report.manifolds)
      for (const auto& b : m.blocks)
        if (b.ode && !j.contains("r") && (a.stage == "ode" || a.stage == "r"))
          j.update(json_of(s, *b.ode));
    j["manifolds"] = all;
    out << j.dump(2) << "\n";
  }
  return code;
}

} // namespace kov::cli
