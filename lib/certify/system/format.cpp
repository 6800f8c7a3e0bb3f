// SystemCertificate <-> JSON, keys in the order of docs/theory/system_certificates.md 2.

#include "certify/system/check.hpp"
#include "exact/error.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

/// An object whose keys are names before this one; as pairs.
struct ByName {
  const Ring& ring;
  std::size_t end;
  const char* why;

  [[nodiscard]] std::size_t number(const Node& n, const std::string& name) const {
    const auto i = ring->find(name);
    if (!i || *i >= end) n.fail(why);
    return *i;
  }
  template <class T, class S> void read(const Node& n, T& all, S& s) const {
    const auto* o = n.json().object();
    if (!o) n.fail("an object is expected");
    for (const auto& [name, json] : *o) {
      const Node value(json, n.path() + "." + name, n.field());
      auto& one = all.emplace_back();
      one.first = number(value, name);
      ByType{}.read(value, one.second, s);
    }
  }
  template <class T, class S> [[nodiscard]] Json write(const T& all, S& s) const {
    Json::Object o;
    for (const auto& [i, value] : all)
      o.emplace_back(ring->name(i), ByType{}.write(value, s));
    return {std::move(o)};
  }
};

namespace {

constexpr int way_json_depth = 4 * max_node_depth + 8;

Integer positive_integer(const Node& n) {
  if (!is_natural(n.text())) n.fail("a natural number is expected");
  return n.integer();
}

/// [coordinate, coordinate, value]
struct Bracket {
  ByName coordinates;

  template <class S> void read(const Node& n, PhaseBracket& x, S& s) const {
    const auto parts = n.items();
    if (parts.size() != 3) n.fail("two coordinates and their bracket are expected");
    x = {coordinates.number(parts[0], parts[0].text()),
         coordinates.number(parts[1], parts[1].text()), read_phase_function(*s.ring, parts[2])};
    if (x.first == x.second) n.fail("two different coordinates are expected");
  }
  template <class S> [[nodiscard]] Json write(const PhaseBracket& x, S&) const {
    const Ring& ring = coordinates.ring;
    return {Json::Array{{ring->name(x.first)}, {ring->name(x.second)}, to_json(x.value)}};
  }
};

using EquationOfWay = decltype(SystemCertificate::equation);

} // namespace

// ---- values

PhaseFunction read_phase_function(const Ring& ring, const Node& n) {
  if (n.json().text()) return {read_poly(ring, n), Integer(1)};
  const auto parts = n.items();
  if (parts.size() != 2) n.fail("a polynomial, or one and a number, is expected");
  return {read_poly(ring, parts[0]), positive_integer(parts[1])};
}

CurveFunction read_curve_function(const PhaseCurve& c, const Node& n) {
  if (n.json().text()) return {read_poly(c.ring, n), Integer(1), {}};
  const auto parts = n.items();
  if (parts.size() < 2 || parts.size() > 2 + c.denominators.size())
    n.fail("a polynomial, a number and an exponent for each denominator are expected");
  CurveFunction f{read_poly(c.ring, parts[0]), positive_integer(parts[1]), {}};
  const Between exponent{0, max_power, "an exponent from 0 to 1000 is expected"};
  NoSetting none;
  for (std::size_t i = 2; i < parts.size(); ++i)
    exponent.read(parts[i], f.over.emplace_back(), none);
  return f;
}

Json to_json(const PhaseFunction& f) {
  if (f.n == Integer(1)) return {to_string(f.p)};
  return {Json::Array{{to_string(f.p)}, {to_string(f.n)}}};
}

Json to_json(const CurveFunction& f) {
  std::size_t last = f.over.size();
  while (last > 0 && f.over[last - 1] == 0)
    --last;
  if (last == 0 && f.n == Integer(1)) return {to_string(f.p)};
  Json::Array parts{{to_string(f.p)}, {to_string(f.n)}};
  for (std::size_t k = 0; k < last; ++k)
    parts.push_back({std::to_string(f.over[k])});
  return {std::move(parts)};
}

void read_entry(const Node& n, EquationOfWay& x, const CurveSetting& /*s*/) {
  const std::string format = Keys(n).at("format").text();
  if (format == "kovacic-strata/1")
    x = read_strata_certificate(n);
  else if (format == "kovacic-loops/1")
    x = read_loops_certificate(n);
  else
    x = read_certificate(n);
}
Json write_entry(const EquationOfWay& x, const CurveSetting& /*s*/) {
  return std::visit([](const auto& c) { return to_json(c); }, x);
}

// ---- the system

template <class IO> void describe(IO& io, In<IO, PhaseSystem>& x) {
  std::vector<std::string> coordinates;
  if constexpr (!IO::reads) {
    const auto names = x.ring->names().begin();
    coordinates.assign(names, names + static_cast<long>(x.dimension));
  }
  io("coordinates", coordinates, Each<>{{}, max_coordinates, "coordinates"});
  if constexpr (IO::reads) {
    auto names = coordinates;
    x.dimension = names.size();
    for (const char* list : {"functions", "inverses"})
      for (std::string& name : io.names_in(list))
        names.push_back(std::move(name));
    names.insert(names.end(), io.setting.parameters->begin(), io.setting.parameters->end());
    io.check(names.size() <= max_phase_names, "coordinates", "more than 64 names");
    x.ring = io.ring_of("coordinates", names);
  }
  io.setting.ring = &x.ring;
  const ByName by_coordinate{x.ring, x.dimension, "a coordinate is expected"};
  std::size_t i = x.dimension;
  io.unless_empty("functions", x.functions, Each{Described{[&](auto& o, auto& f) {
                    o.known("name", [&] { return x.ring->name(i++); })("meaning", f.meaning);
                    o("gradient", f.gradient, by_coordinate);
                  }}});
  io.unless_empty("inverses", x.inverses, Each{Described{[&](auto& o, auto& h) {
                    o.known("name", [&] { return x.ring->name(i++); })("of", h);
                  }}});
  io.unless_empty("relations", x.relations);
  bool has_field = !x.hamiltonian;
  if constexpr (IO::reads) has_field = io.has("field");
  if (has_field) {
    io("field", x.field);
    io.check(x.field.size() == x.dimension, "field", "one entry for each coordinate is expected");
    return;
  }
  io.always("hamiltonian", x.hamiltonian, Stated{})("brackets", x.brackets,
                                                    Each{Bracket{by_coordinate}});
  for (const PhaseBracket& b : x.brackets)
    io.check(std::ranges::count_if(x.brackets,
                                   [&](const PhaseBracket& c) {
                                     return std::minmax(b.first, b.second) ==
                                            std::minmax(c.first, c.second);
                                   }) == 1,
             "brackets", "a pair occurs twice");
}

template <class IO> void describe(IO& io, In<IO, ClaimedFunction>& x) {
  io("kind", x.casimir, Either{"casimir", "integral"})("name", x.name)("value", x.value);
  io.unless_empty("cofactors", x.cofactors);
}

// ---- the curve

template <class IO> void describe(IO& io, In<IO, PhaseCurve>& x) {
  const Ring& phase = *io.setting.ring;
  std::string variable;
  if constexpr (!IO::reads) variable = x.ring->name(x.z());
  io("manifold", x.manifold)("equations", x.equations)("levels", x.levels);
  io("variable", variable)("change", x.change);
  if constexpr (IO::reads) {
    const auto steps = io.names_in("tower");
    io.check(steps.size() <= max_tower, "tower", "the tower is too high");
    std::vector<std::string> names(steps.rbegin(), steps.rend());
    names.push_back(variable);
    names.insert(names.end(), io.setting.parameters->begin(), io.setting.parameters->end());
    x.ring = io.ring_of("tower", names);
  }
  io.setting.ring = &x.ring;
  io.setting.curve = &x;
  io("denominators", x.denominators, Each<>{{}, max_denominators, "denominators"});
  const Between degree{2, max_curve_degree, "a degree from 2 to 64"};
  std::size_t i = 0;
  unsigned long whole_degree = 1;
  io("tower", x.tower, Each{Described{[&](auto& o, auto& step) {
       o.known("name", [&] { return x.ring->name(x.variable(i++)); })("degree", step.degree,
                                                                      degree);
       whole_degree *= step.degree;
       o.check(whole_degree <= max_curve_degree, "degree", "the degree of the tower is above 64");
       o("value", step.value)("derivative", step.derivative);
     }}});
  const std::size_t first_parameter = phase->size() - io.setting.parameters->size();
  io("values", x.values, ByName{phase, first_parameter, "the value of no name"})("time", x.time);
}

template <class IO> void describe(IO& io, In<IO, Annihilator>& x) {
  io("row", x.row)("matrix", x.matrix);
}
template <class IO> void describe(IO& io, In<IO, NormalIdentity>& x) {
  io("annihilators", x.annihilators, Each<>{{}, max_annihilators, "annihilators"});
  if constexpr (IO::reads) {
    x.is_system = io.has("rows");
    if (!x.is_system) x.rows.resize(1), x.rests.resize(1);
  }
  if (x.is_system)
    io("rows", x.rows)("rest", x.rests).if_true("whole", x.whole);
  else
    io("row", x.rows.front())("p", x.p)("q", x.q)("rest", x.rests.front());
  io("vectors", x.vectors);
  io.check(x.vectors.size() == (x.is_system ? x.rows.size() : 2) && x.rests.size() == x.rows.size(),
           "vectors", "as many vectors as rows are expected");
}

template <class IO> void describe(IO& io, In<IO, SystemCertificate>& x) {
  const PhaseSystem& s = x.way.system;
  std::vector<std::string> parameters;
  if constexpr (!IO::reads) parameters = s.parameters();
  io.format("kovacic-system/1")("title", x.way.title);
  io("parameters", parameters, Each<>{{}, max_parameters, "parameters"});
  io.setting.parameters = &parameters;
  io("system", x.way.system).unless_empty("claims", x.way.claims)("curve", x.way.curve);
  io("normal", x.way.normal).object("equation", [&](auto& o) {
    o("certificate", x.equation)("root", x.root);
  });
  io.object("claim", [&](auto& o) { o("not_integrable", x.not_integrable); });
}

PhaseSystem read_phase_system(const Node& n, const std::vector<std::string>& parameters) {
  PhaseSystem x;
  CurveSetting s{.parameters = &parameters};
  whole.read(n, x, s);
  return x;
}
Json to_json(const PhaseSystem& x) {
  CurveSetting s;
  return whole.write(x, s);
}

SystemCertificate read_system_certificate(std::string_view text) {
  return read_whole<SystemCertificate, CurveSetting>(text, way_json_depth);
}
std::string write_system_certificate(const SystemCertificate& c) {
  return to_string(whole_json<CurveSetting>(c));
}

} // namespace kov::certify
