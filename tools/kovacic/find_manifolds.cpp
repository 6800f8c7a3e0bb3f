// kovacic find-manifolds FILE: invariant linear subspaces, as [[manifold]] blocks to paste.

#include "manifold/find.hpp"
#include "mechanics.hpp"
#include "mechanics_json.hpp"

#include <ostream>

namespace kov::cli {

int run_find_manifolds(const MechanicsArguments& a, std::ostream& out) {
  const System s = read_system(a.file, a.set);
  std::vector<MFraction> integrals;
  if (s.field.hamiltonian) integrals.push_back(*s.field.hamiltonian);
  for (const auto& claim : s.claims)
    if ((claim.kind == Claim::Kind::integral || claim.kind == Claim::Kind::casimir) &&
        claim.on.empty() && check_claim(s, claim).proved)
      integrals.push_back(claim.value);
  const auto found = find_manifolds(s.field, integrals, a.decide.budget);
  if (a.format == "json") {
    Json all = Json::array();
    for (const auto& m : found) {
      std::vector<std::string> equations;
      for (const auto& e : m.equations)
        equations.push_back(e.text);
      all.push_back(Json{{"equations", equations},
                         {"kind", m.kind},
                         {"dimension", m.dimension},
                         {"integrals", m.integrals},
                         {"leaf_dimension", m.leaf_dimension()},
                         {"equilibria", m.equilibria}});
    }
    out << Json{{"format", "kovacic-manifolds/1"}, {"file", s.file}, {"manifolds", all}}.dump(2)
        << "\n";
    return 0;
  }
  out << "# invariant linear subspaces, proved; " << found.size() << " found\n";
  for (const auto& m : found) {
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
  return 0;
}

} // namespace kov::cli
