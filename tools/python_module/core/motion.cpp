// System: the equations of motion of a file, and invariant sets.

#include "bind.hpp"
#include "source.hpp"

#include "manifold/find.hpp"
#include "system/claims.hpp"
#include "system/system.hpp"

#include <pybind11/stl.h>

#include <map>

namespace kov::python {
namespace {

/// The equations of motion, as they were read.
struct Motion {
  std::string kind;
  std::vector<std::string> coordinates, parameters;
  std::vector<MFraction> components;
  std::optional<MFraction> hamiltonian;
  std::map<std::string, std::string> functions; ///< symbols and what they mean
  std::vector<std::string> relations;
};

std::string kind_of(const System& s) {
  switch (s.kind) {
  case SystemKind::hamiltonian:
    return "hamiltonian";
  case SystemKind::lagrangian:
    return "lagrangian";
  case SystemKind::poisson:
    return "poisson";
  case SystemKind::vector_field:
    return "vector-field";
  default:
    return "euler-poisson";
  }
}

Motion motion_of(const System& s) {
  Motion m;
  m.kind = kind_of(s);
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    m.coordinates.push_back(s.field.name(j));
  for (const std::size_t i : s.field.parameters)
    m.parameters.push_back(s.ring()->name(i));
  m.components = s.field.components;
  m.hamiltonian = s.field.hamiltonian;
  for (const FunctionSymbol& f : s.field.functions)
    m.functions[s.ring()->name(f.variable)] = f.meaning;
  for (const MPoly& f : s.field.relations)
    m.relations.push_back(to_string(f) + " = 0");
  return m;
}

std::vector<MFraction> proved_integrals(const System& s, const Budget& budget) {
  std::vector<MFraction> integrals;
  if (s.field.hamiltonian) integrals.push_back(*s.field.hamiltonian);
  for (const auto& claim : s.claims)
    if ((claim.kind == SystemClaim::Kind::integral || claim.kind == SystemClaim::Kind::casimir) &&
        claim.on.empty() && decide_claim(s, claim, budget).proved)
      integrals.push_back(claim.value);
  return integrals;
}

std::vector<std::string> equations_of(const FoundManifold& m) {
  std::vector<std::string> all;
  for (const Equation& e : m.equations)
    all.push_back(text_in_file(e));
  return all;
}

} // namespace

void bind_motion(py::module_& m) {
  read_only<Motion>(m, "Motion", "The equations of motion of a system.", {})
      .def_readonly("kind", &Motion::kind)
      .def_readonly("coordinates", &Motion::coordinates)
      .def_readonly("parameters", &Motion::parameters)
      .def_readonly("components", &Motion::components)
      .def_readonly("hamiltonian", &Motion::hamiltonian)
      .def_readonly("functions", &Motion::functions)
      .def_readonly("relations", &Motion::relations);
  read_only<FoundManifold>(m, "FoundManifold", "An invariant set, proved.", {"equations"})
      .def_property_readonly("equations", &equations_of)
      .def_readonly("kind", &FoundManifold::kind)
      .def_readonly("dimension", &FoundManifold::dimension)
      .def_property_readonly("leaf_dimension", &FoundManifold::leaf_dimension,
                             "1: levels of integrals cut out phase curves")
      .def_readonly("equilibria", &FoundManifold::equilibria, "the field vanishes on it")
      .def("__repr__", [](const FoundManifold& f) {
        std::string text;
        for (const Equation& e : f.equations)
          text += (text.empty() ? "" : ", ") + e.text;
        return "<FoundManifold " + text + ">";
      });
  m.def("motion", [](const Source& source, const ParameterValues& values) {
    return motion_of(read_system(source.document(), values));
  });
  m.def("find_manifolds",
        [](const Limits& limits, const Source& source, const ParameterValues& values) {
          return computed(limits, [&](const Budget& budget, const Interrupt&) {
            const System s = read_system(source.document(), values);
            return kov::find_manifolds(s.field, proved_integrals(s, budget), budget).proved;
          });
        });
}

} // namespace kov::python
