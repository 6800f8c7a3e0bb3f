// JetsCertificate <-> JSON, keys in the order of docs/theory/jet_certificates.md 2.

#include "certify/jets/check.hpp"
#include "exact/error.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

constexpr Words<4> group_words{"first-family", "homogeneous", "equilibria", "group"};

constexpr Each<> jet_terms{{}, static_cast<std::size_t>(max_jet_terms)};
constexpr Each<> jet_cofactor{{}, max_jet_cofactor};
constexpr Between jet_column{0, max_order + 1};

} // namespace

template <class IO> void describe(IO& io, In<IO, LocalSeries>& x) {
  io("low", x.low, Between{-max_jet_terms, max_jet_terms})("terms", x.c, jet_terms);
}
inline void read_entry(const Node& n, LocalSeries& x, CurveSetting& s) {
  if (n.is_null()) return;
  whole.read(n, x, s);
  x.end = x.low + static_cast<long>(x.c.size());
}
inline Json write_entry(const LocalSeries& x, CurveSetting& s) {
  return x.is_exact_zero() ? Json{} : whole.write(x, s);
}

template <class IO> void describe(IO& io, In<IO, JetLine>& x) {
  io("start", x.start)("across", x.across)("along", x.along)("masses", x.masses);
  io("inertias", x.inertias);
}
template <class IO> void describe(IO& io, In<IO, JetMinor>& x) {
  io("columns", x.columns, Each{jet_column})("cofactor", x.cofactor)("value", x.value);
  io("power", x.power, Between{1, max_jet_power});
}
template <class IO> void describe(IO& io, In<IO, ByEquilibria>& x) {
  io("first", x.first, jet_cofactor)("second", x.second, jet_cofactor);
}
template <class IO> void describe(IO& io, In<IO, ByGroup>& x) {
  io("e", x.e)("first", x.first, jet_cofactor)("second", x.second, jet_cofactor);
  io("certificate", x.certificate);
}

template <class IO> void describe(IO& io, In<IO, JetsCertificate>& x) {
  std::vector<std::string> parameters, variables, coordinates, momenta, constants;
  if constexpr (!IO::reads) {
    const auto &all = x.field.ring->names(), &phase = x.system.ring->names();
    const auto e = all.begin() + static_cast<long>(x.e());
    const auto n = static_cast<long>(x.system.dimension / 2);
    parameters.assign(e + 1, all.end() - 2);
    variables = {*e, all[x.c1()], all[x.c2()]};
    coordinates.assign(phase.begin(), phase.begin() + n);
    momenta.assign(phase.begin() + n, phase.begin() + 2 * n);
  }
  io.format("kovacic-jets/1")("title", x.title);
  io("parameters", parameters, Each<>{{}, max_jet_parameters, "parameters"});
  io("variables", variables, Each<>{{}, 3});
  if constexpr (IO::reads) {
    io.check(variables.size() == 3, "variables", "three names are expected");
    constants = io.names_in("constants");
    io.check(constants.size() <= max_tower, "constants", "the tower is too high");
    std::vector<std::string> names(constants.rbegin(), constants.rend());
    names.push_back(variables[0]);
    names.insert(names.end(), parameters.begin(), parameters.end());
    names.insert(names.end(), variables.begin() + 1, variables.end());
    x.field.ring = io.ring_of("variables", names);
  }
  io.object("system", [&](auto& o) {
    constexpr Each<> some{{}, max_coordinates / 2};
    o("coordinates", coordinates, some)("momenta", momenta, some);
    if constexpr (IO::reads) {
      o.check(coordinates.size() >= 2 && momenta.size() == coordinates.size(), "coordinates",
              "two coordinates or more, and as many momenta, are expected");
      auto names = coordinates;
      for (const auto* more : {&momenta, &parameters, &constants})
        names.insert(names.end(), more->begin(), more->end());
      x.system.ring = o.ring_of("coordinates", names);
      x.system.dimension = 2 * coordinates.size();
      for (std::size_t i = 0; i < coordinates.size(); ++i)
        x.system.brackets.push_back(
            {i, i + coordinates.size(), {MPoly(x.system.ring, Integer(1)), Integer(1)}});
    }
    o.setting.ring = &x.system.ring;
    o.always("hamiltonian", x.system.hamiltonian, Stated{});
  });
  io.setting.ring = &x.field.ring;
  io.setting.curve = &x.field;
  io("denominators", x.field.denominators, Each<>{{}, max_denominators, "denominators"});
  const Between one_degree{2, max_curve_degree};
  std::size_t i = 0;
  unsigned long whole_degree = 1;
  io("constants", x.field.tower, Each{Described{[&](auto& o, auto& step) {
       o.known("name", [&] { return x.field.ring->name(x.field.variable(i++)); });
       o("degree", step.degree, one_degree)("value", step.value);
       whole_degree *= step.degree;
       o.check(whole_degree <= max_curve_degree, "degree", "the degree of the tower is above 64");
       if constexpr (IO::reads) step.derivative.p = MPoly(x.field.ring);
     }}});
  io("line", x.line).object("place", [&](auto& o) {
    o("turns", x.turns, Between{1, max_turns})("time_scale", x.time_scale);
    o("solution", x.solution)("normal", x.normal);
  });
  io.object("jets", [&](auto& o) {
    o("order", x.order, Between{2, max_order})("across", x.across)("along", x.along);
    for (const auto* all : {&x.across, &x.along})
      o.check(all->size() + 2 == static_cast<std::size_t>(x.order),
              all == &x.across ? "across" : "along", "one for each lower order");
    o("form", x.form);
  });
  io("obstruction", x.obstruction)("group", x.group, one_of("by", group_words));
}

JetsCertificate read_jets_certificate(std::string_view text) {
  return read_whole<JetsCertificate, CurveSetting>(text);
}
std::string write_jets_certificate(const JetsCertificate& c) {
  return to_string(whole_json<CurveSetting>(c));
}

} // namespace kov::certify
