// kovacic find-manifolds FILE: invariant sets, as [[manifold]] blocks to paste.

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "manifold/find.hpp"

#include "commands.hpp"
#include "output/render.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"
#include "systems/mechanics.hpp"

#include <algorithm>
#include <set>
#include <sstream>

namespace kov::cli {
namespace {

// With a name that formulas can use, or "".
struct Integrals {
  std::vector<MFraction> values;
  std::vector<std::string> names;
};

Integrals proved_integrals(const System& s, const Budget& budget) {
  Integrals integrals;
  const auto add = [&](const MFraction& f, const std::string& name) {
    integrals.values.push_back(f);
    integrals.names.push_back(is_identifier(name) ? name : "");
  };
  const auto h = s.named.find("H"); // unless the file calls something else so
  if (s.field.hamiltonian)
    add(*s.field.hamiltonian, h != s.named.end() && h->second == *s.field.hamiltonian ? "H" : "");
  for (const auto& claim : s.claims)
    if ((claim.kind == SystemClaim::Kind::integral || claim.kind == SystemClaim::Kind::casimir) &&
        claim.on.empty() && decide_claim(s, claim, budget).proved)
      add(claim.value, claim.name);
  return integrals;
}

// A parameter that no formula of the system has: declared as the value of a level.
bool is_for_levels(const System& s, const std::string& letter) {
  const auto i = s.ring()->find(letter);
  const auto has = [&](const auto& f) { return uses(f, *i); };
  const auto& v = s.field;
  return i && is_among(*i, v.parameters) && std::ranges::none_of(v.components, has) &&
         std::ranges::none_of(v.relations, has) &&
         std::ranges::none_of(s.named, [&](const auto& f) { return has(f.second); });
}

// The first letter for the value of a level that is not taken, nor a mistake in writing for one that is.
std::string free_letter(std::string_view letters, const System& s,
                        const std::set<std::string>& given) {
  std::vector<std::string> taken;
  for (std::size_t i = 0; i < s.ring()->size(); ++i)
    taken.push_back(s.ring()->name(i));
  for (const auto& [name, value] : s.named)
    if (name != "H") taken.push_back(name);
  for (const auto& claim : s.claims)
    taken.push_back(claim.name);
  const auto is_free = [&](const std::string& letter) {
    return !given.contains(letter) && (is_for_levels(s, letter) || !nearest(letter, taken));
  };
  for (std::string more;; more += "_")
    for (const char letter : letters)
      if (std::string all = letter + more; is_free(all)) return all;
}

// level = ["H = h", ...] with letters that are free; "" where no level is needed, or none helps.
std::string levels(const FoundManifold& m, const Integrals& integrals, const System& s) {
  if (m.leaf_dimension() != 1 || m.equilibria || m.integrals == 0) return {};
  std::string text;
  std::set<std::string> given;
  for (const std::size_t i : m.independent) {
    const std::string name =
        integrals.names.at(i).empty() ? to_string(integrals.values.at(i)) : integrals.names.at(i);
    const std::string letter = free_letter(name == "H" ? "hEe" : "cdefgk", s, given);
    given.insert(letter);
    text += (text.empty() ? "\"" : ", \"") + name + " = " + letter + "\"";
  }
  return text;
}

std::string counted(int n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
std::string size(const FoundManifold& m) {
  return "dimension " + std::to_string(m.dimension) + ", " + counted(m.integrals, "integral");
}
std::string equations(const FoundManifold& m, const char* quote) {
  return joined(m.equations, [&](const auto& e) { return (quote + text_in_file(e)) + quote; });
}
void comment(const std::string& text, const char* start, std::ostringstream& out) {
  std::istringstream lines(wrapped(text, 2, 96));
  for (std::string line; std::getline(lines, line);)
    out << start << line << "\n";
}

void print_block(const FoundManifold& m, const std::string& level, std::ostringstream& out) {
  const bool named = m.kind != "coordinate subspace";
  out << "\n";
  comment((named ? m.kind + ": " : "") + size(m) +
              (m.equilibria             ? "; equilibria only"
               : m.leaf_dimension() > 1 ? "; no phase curve by levels alone"
                                        : ""),
          "# ", out);
  out << "[[manifold]]\nequations = [" << equations(m, "\"") << "]\n";
  if (!level.empty()) out << "level     = [" << level << "]\n";
}

// Is there a set among the first n that contains this one by its equations?
bool is_inside(const std::vector<const FoundManifold*>& all, std::size_t n) {
  const auto has = [](const FoundManifold& m, const Equation& e) {
    return std::ranges::any_of(m.equations,
                               [&](const Equation& other) { return other.text == e.text; });
  };
  return std::ranges::any_of(all, [&](const FoundManifold* other) {
    return other != all[n] && other->equations.size() < all[n]->equations.size() &&
           std::ranges::all_of(other->equations,
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
void print(const std::vector<FoundManifold>& found, const Integrals& integrals, const System& s,
           bool whole, std::ostringstream& out) {
  std::vector<const FoundManifold*> large, still;
  for (const auto& m : found) {
    if (m.equilibria && !whole)
      still.push_back(&m);
    else if (m.leaf_dimension() > 1 && !whole)
      large.push_back(&m);
    else
      print_block(m, levels(m, integrals, s), out);
  }
  print_list("levels of the integrals are not phase curves there:", large, out);
  print_list("equilibria only:", still, out);
}

Json as_json(const FoundManifold& m) {
  std::vector<std::string> equations;
  for (const auto& e : m.equations)
    equations.push_back(text_in_file(e));
  return Json{{"equations", equations},
              {"kind", m.kind},
              {"dimension", m.dimension},
              {"integrals", m.integrals},
              {"leaf_dimension", m.leaf_dimension()},
              {"equilibria", m.equilibria}};
}

} // namespace

ProposedManifolds propose_manifolds(const Settings& settings, const std::string& file) {
  constexpr std::size_t most = 6;
  const Report report = supervised(settings, file, [&] {
    const System s = read_system(settings.document(file), parameter_values(settings));
    const Budget budget = settings.solver_options().budget;
    const Integrals integrals = proved_integrals(s, budget);
    std::ostringstream out;
    std::size_t blocks = 0;
    const auto found = kov::find_manifolds(s.field, integrals.values, budget);
    for (const FoundManifold& m : found.proved) {
      if (m.leaf_dimension() != 1 || m.equilibria) continue;
      if (++blocks <= most) print_block(m, levels(m, integrals, s), out);
    }
    return Report{
        exit_decided, out.str(), Json{{"blocks", blocks}, {"left_out", found.left_out}}, {}};
  });
  if (!report.limit.empty())
    return {"", "the search for invariant sets did not end (" + report.limit + ")"};
  if (report.exit != exit_decided) return {"", "the search for invariant sets failed"};
  std::string note;
  const auto blocks = report.json.at("blocks").get<std::size_t>();
  if (blocks > most) note = "the first " + std::to_string(most) + " of " + std::to_string(blocks);
  for (const std::string left : report.json.at("left_out"))
    note += (note.empty() ? "left out: " : "; left out: ") + left;
  if (!note.empty()) note = " (" + note + ")";
  const char* said =
      blocks > 0 ? "those of find-manifolds are studied"
                 : "no invariant set was found on which levels of the integrals are phase curves";
  return {report.text, said + note};
}

int find_manifolds(const Settings& settings, const std::string& file) {
  const Report report = supervised(settings, file, [&] {
    const System s = read_system(settings.document(file), parameter_values(settings));
    const Budget budget = settings.solver_options().budget;
    const Integrals integrals = proved_integrals(s, budget);
    const auto found = kov::find_manifolds(s.field, integrals.values, budget);
    std::ostringstream out;
    out << "# " << found.proved.size()
        << (found.proved.size() == 1 ? " invariant set, proved;" : " invariant sets, each proved;")
        << " looked for: x_i = c_i, x_i = x_j or -x_j, lines; others may exist\n";
    for (const std::string& limit : found.left_out)
      out << "# left out: " << limit << "\n";
    if (found.proved.empty())
      out << "# next: "
          << (settings.given ? "the same command with classify" : "kovacic classify " + file)
          << " tries other ways (Darboux points, orders at infinity)\n";
    print(found.proved, integrals, s, settings.verbose > 0, out);
    const Json all = list_of(found.proved, [](const auto& m) { return as_json(m); });
    Json json{{"format", "kovacic-manifolds/1"}, {"file", file}, {"manifolds", all}};
    if (!found.left_out.empty()) json["left_out"] = found.left_out;
    return Report{found.left_out.empty() ? exit_decided : exit_undecided, out.str(), json, {}};
  });
  return written_report(settings, report);
}

} // namespace kov::cli
