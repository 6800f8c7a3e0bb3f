// The statement of an accepted certificate of the whole way, as lines of text made from the parsed
// data alone: docs/theory/system_certificates.md 8.  The Python checker prints the same.

#include "certify/equation/statement.hpp"

#include "certify/system/check.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::certify {

std::string to_string(const PhaseFunction& f) {
  return f.n == Integer(1) ? to_string(f.p) : "(" + to_string(f.p) + ")/" + to_string(f.n);
}

namespace {

std::string zeros(const std::vector<PhaseFunction>& all) {
  std::vector<std::string> said;
  for (const PhaseFunction& f : all)
    said.push_back(to_string(f) + " = 0");
  return joined(said, ", ");
}

std::string where_text(const std::vector<std::string>& all) {
  return all.empty() ? "" : ", where " + joined(all, ", ");
}

std::string shown_field(const PhaseSystem& s) {
  const auto& names = s.ring->names();
  std::vector<std::string> all;
  for (const PhaseBracket& b : s.brackets)
    all.push_back("{" + names[b.first] + ", " + names[b.second] + "} = " + to_string(b.value));
  if (s.hamiltonian) all.push_back("H = " + to_string(*s.hamiltonian));
  for (std::size_t i = 0; i < s.field.size(); ++i)
    all.push_back(names[i] + "' = " + to_string(s.field[i]));
  return joined(all, ", ");
}

} // namespace

std::string shown_element(const PhaseCurve& c, const CurveFunction& f) {
  std::vector<std::string> below;
  if (f.n != Integer(1)) below.push_back(to_string(f.n));
  for (std::size_t k = 0; k < f.over.size(); ++k)
    if (f.over[k] > 0)
      below.push_back("(" + to_string(c.denominators[k]) + ")" +
                      (f.over[k] > 1 ? "^" + std::to_string(f.over[k]) : ""));
  if (below.empty()) return to_string(f.p);
  return "(" + to_string(f.p) + ")/(" + joined(below, "*") + ")";
}

std::string shown_step(const PhaseCurve& c, std::size_t i) {
  return c.ring->name(c.variable(i)) + "^" + std::to_string(c.tower[i].degree) + " = " +
         shown_element(c, c.tower[i].value);
}

std::vector<std::string> shown_system(const PhaseSystem& s) {
  std::vector<std::string> lines{shown_field(s)};
  const auto& names = s.ring->names();
  for (std::size_t i = 0; i < s.functions.size(); ++i) {
    std::vector<std::string> gradient;
    const std::string& f = names[s.dimension + i];
    for (const auto& [j, g] : s.functions[i].gradient)
      if (!is_zero(g.p)) gradient.push_back("d" + f + "/d" + names[j] + " = " + to_string(g));
    lines.push_back(f + " " + quoted(s.functions[i].meaning) + ": " +
                    (gradient.empty() ? "constant" : joined(gradient, ", ")));
  }
  for (std::size_t i = 0; i < s.inverses.size(); ++i)
    lines.push_back(names[s.first_inverse() + i] + " = 1/(" + to_string(s.inverses[i]) + ")");
  for (const MPoly& r : s.relations)
    lines.push_back(to_string(r) + " = 0");
  return lines;
}

std::set<std::string> names_in(const PhaseCurve& c, const CurveFunction& f) {
  std::set<std::string> names;
  std::vector<const CurveFunction*> left{&f};
  while (!left.empty()) {
    const CurveFunction& x = *left.back();
    left.pop_back();
    std::vector<std::size_t> used = used_variables(x.p);
    for (std::size_t k = 0; k < x.over.size(); ++k)
      if (x.over[k] > 0)
        for (const std::size_t i : used_variables(c.denominators[k]))
          used.push_back(i);
    for (const std::size_t i : used)
      if (names.insert(c.ring->name(i)).second && i < c.z())
        left.push_back(&c.tower[c.z() - 1 - i].value);
  }
  return names;
}

// The functions meant take these values on the curve, where what they depend on has those.
FunctionsThere functions_there(const SystemCertificate& c, const SystemAccepted& found) {
  const PhaseSystem& s = c.way.system;
  const PhaseCurve& x = c.way.curve;
  FunctionsThere all;
  std::vector<std::string> values, where;
  for (std::size_t i = 0; i < s.first_inverse(); ++i)
    for (const auto& [k, value] : x.values) {
      if (k != i || !found.seen_by_functions[i]) continue;
      (i < s.dimension ? where : values)
          .push_back(s.ring->name(i) + " = " + shown_element(x, value));
      const auto names = names_in(x, value);
      all.names.insert(names.begin(), names.end());
      if (found.seen_by_free_functions[i]) all.chosen.insert(names.begin(), names.end());
    }
  if (values.empty()) return all;
  all.short_text = "for functions with " + joined(values, ", ") + " there" + where_text(where);
  for (std::size_t i = 0; i < x.tower.size(); ++i)
    if (all.names.contains(x.ring->name(x.variable(i)))) where.push_back(shown_step(x, i));
  all.text = {"for functions with " + joined(values, ", ") + " there" + where_text(where)};
  return all;
}

std::string phase_curve(const SystemCertificate& c) {
  const PhaseCurve& x = c.way.curve;
  return "the phase curve with " + x.ring->name(x.z()) + " = " + to_string(x.change) + " on " +
         quoted(x.manifold) + (x.equations.empty() ? "" : ": " + zeros(x.equations)) +
         (x.levels.empty() ? "" : "; levels " + zeros(x.levels));
}

std::vector<std::string> statement(const SystemCertificate& c, const SystemAccepted& found) {
  const PhaseSystem& s = c.way.system;
  const PhaseCurve& x = c.way.curve;
  const auto parameters = s.parameters();
  std::vector<std::string> lines{
      "the system " + quoted(c.way.title) +
      (parameters.empty() ? "" : " with parameters " + joined(parameters))};
  for (const std::string& line : shown_system(s))
    lines.push_back("  " + line);
  for (const ClaimedFunction& f : c.way.claims)
    lines.push_back(std::string(f.casimir ? "  Casimir function " : "  first integral ") +
                    quoted(f.name) + ": " + to_string(f.value));
  lines.push_back("along " + phase_curve(c));
  const std::string there = functions_there(c, found).short_text;
  if (!there.empty()) lines.push_back("  " + there);
  for (std::size_t i = 0; i < x.tower.size(); ++i)
    lines.push_back("  " + shown_step(x, i));
  for (const MPoly& d : x.denominators) {
    const auto used = used_variables(d);
    if (std::ranges::any_of(used, [&](std::size_t i) { return i > x.z(); }))
      add_once(lines, "  except where " + to_string(d) + " = 0 for all " + x.ring->name(x.z()));
  }
  lines.push_back(
      !found.somewhere
          ? "nothing follows from"
          : "is not integrable" + (there.empty() ? " " : ", " + there + ", ") +
                std::string(s.hamiltonian ? "in Liouville's sense " : "") + "with " +
                first_integrals({found.integrals}) +
                (s.hamiltonian && !c.way.normal.whole ? " (Morales-Ramis)" : " (Ayoul-Zung)") +
                (c.not_integrable ? ", as" : " where the identity component is not abelian:"));
  for (const std::string& line : found.lines)
    lines.push_back("  " + line);
  return lines;
}

} // namespace kov::certify
