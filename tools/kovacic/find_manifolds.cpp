// kovacic find-manifolds FILE: invariant sets, as [[manifold]] blocks to paste.

#include "manifold/find.hpp"

#include "commands.hpp"
#include "mechanics.hpp"

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

void print(const FoundManifold& m, std::ostringstream& out) {
  out << "\n# " << m.kind << "; dimension " << m.dimension << ", " << m.integrals
      << " independent integral(s) on it";
  if (m.equilibria)
    out << "; equilibria only";
  else if (m.leaf_dimension() == 1)
    out << ": levels cut out phase curves";
  out << "\n[[manifold]]\nequations = [";
  for (std::size_t i = 0; i < m.equations.size(); ++i)
    out << (i ? ", " : "") << '"' << m.equations[i].text << '"';
  out << "]\n";
}

Json json_of(const FoundManifold& m) {
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
    const System s = read_system(file, parameter_values(settings));
    const Budget budget = settings.solver_options().budget;
    const auto found = kov::find_manifolds(s.field, proved_integrals(s, budget), budget);
    std::ostringstream out;
    out << "# invariant sets, each proved; " << found.proved.size() << " found\n"
        << "# looked for: x_i = c_i, x_i = x_j or -x_j, lines; there may be others\n";
    for (const std::string& limit : found.left_out)
      out << "# left out: " << limit << "\n";
    Json all = Json::array();
    for (const auto& m : found.proved) {
      print(m, out);
      all.push_back(json_of(m));
    }
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
