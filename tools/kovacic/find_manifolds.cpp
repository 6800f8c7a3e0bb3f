// kovacic find-manifolds FILE: invariant sets, as [[manifold]] blocks to paste.

#include "manifold/find.hpp"

#include "commands.hpp"
#include "mechanics.hpp"
#include "render.hpp"

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

std::vector<MFraction> proved_integrals(const System& s, const Budget& budget) {
  std::vector<MFraction> integrals;
  if (s.field.hamiltonian) integrals.push_back(*s.field.hamiltonian);
  for (const auto& claim : s.claims)
    if ((claim.kind == SystemClaim::Kind::integral || claim.kind == SystemClaim::Kind::casimir) &&
        claim.on.empty() && decide_claim(s, claim, budget).proved)
      integrals.push_back(claim.value);
  return integrals;
}

std::string counted(int n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
std::string size(const FoundManifold& m) {
  return "dimension " + std::to_string(m.dimension) + ", " + counted(m.integrals, "integral");
}
std::string equations(const FoundManifold& m, const char* quote) {
  std::string text;
  for (const auto& e : m.equations)
    text += (text.empty() ? "" : ", ") + (quote + e.text) + quote;
  return text;
}
void comment(const std::string& text, const char* start, std::ostringstream& out) {
  std::istringstream lines(wrapped(text, 2, 96));
  for (std::string line; std::getline(lines, line);)
    out << start << line << "\n";
}

void print_block(const FoundManifold& m, std::ostringstream& out) {
  const bool named = m.kind != "coordinate subspace";
  out << "\n";
  comment((named ? m.kind + ": " : "") + size(m) +
              (m.equilibria             ? "; equilibria only"
               : m.leaf_dimension() > 1 ? "; no phase curve by levels alone"
                                        : ""),
          "# ", out);
  out << "[[manifold]]\nequations = [" << equations(m, "\"") << "]\n";
}

// Is there a set among the first n that contains this one by its equations?
bool is_inside(const std::vector<const FoundManifold*>& all, std::size_t n) {
  const auto has = [](const FoundManifold& m, const Equation& e) {
    return std::any_of(m.equations.begin(), m.equations.end(),
                       [&](const Equation& other) { return other.text == e.text; });
  };
  return std::any_of(all.begin(), all.end(), [&](const FoundManifold* other) {
    return other != all[n] && other->equations.size() < all[n]->equations.size() &&
           std::all_of(other->equations.begin(), other->equations.end(),
                       [&](const Equation& e) { return has(*all[n], e); });
  });
}

// Sets that are of no use for `check`, a line each; those inside others are counted.
void print_list(const char* title, const std::vector<const FoundManifold*>& all,
                std::ostringstream& out) {
  if (all.empty()) return;
  out << "\n# " << title << "\n";
  int inside = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_inside(all, i))
      ++inside;
    else
      comment(equations(*all[i], ""), "#   ", out);
  }
  if (inside > 0) out << "#   and " << counted(inside, "set") << " inside these (--verbose)\n";
}

// What levels cut phase curves out of as blocks to paste, then the others.
void print(const std::vector<FoundManifold>& found, bool whole, std::ostringstream& out) {
  std::vector<const FoundManifold*> large, still;
  for (const auto& m : found) {
    if (m.equilibria && !whole)
      still.push_back(&m);
    else if (m.leaf_dimension() > 1 && !whole)
      large.push_back(&m);
    else
      print_block(m, out);
  }
  print_list("levels of the integrals are no phase curves there:", large, out);
  print_list("equilibria only:", still, out);
}

Json as_json(const FoundManifold& m) {
  std::vector<std::string> equations;
  for (const auto& e : m.equations)
    equations.push_back(e.text);
  return Json{{"equations", equations},
              {"kind", m.kind},
              {"dimension", m.dimension},
              {"integrals", m.integrals},
              {"leaf_dimension", m.leaf_dimension()},
              {"equilibria", m.equilibria}};
}

} // namespace

int find_manifolds(const Settings& settings, const std::string& file) {
  const Report report = supervised(settings, file, [&] {
    const System s = read_system(settings.document(file), parameter_values(settings));
    const Budget budget = settings.solver_options().budget;
    const auto found = kov::find_manifolds(s.field, proved_integrals(s, budget), budget);
    std::ostringstream out;
    out << "# " << found.proved.size()
        << " invariant sets, each proved; looked for: x_i = c_i, x_i = x_j or -x_j, lines; others "
           "may "
           "exist\n";
    for (const std::string& limit : found.left_out)
      out << "# left out: " << limit << "\n";
    print(found.proved, settings.verbose > 0, out);
    Json all = Json::array();
    for (const auto& m : found.proved)
      all.push_back(as_json(m));
    Json json{{"format", "kovacic-manifolds/1"}, {"file", file}, {"manifolds", all}};
    if (!found.left_out.empty()) json["left_out"] = found.left_out;
    return Report{found.left_out.empty() ? exit_decided : exit_undecided, out.str(), json, {}};
  });
  write_output(settings,
               settings.format == "json" && !report.json.is_null()
                   ? report.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                   : report.text);
  return report.exit;
}

} // namespace kov::cli
