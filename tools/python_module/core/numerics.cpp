// Numbers with proven radii: monodromy().  Pictures: section(), the only place with doubles.

#include "bind.hpp"
#include "flow_enums.hpp"
#include "question.hpp"
#include "source.hpp"
#include "stop.hpp"

#include "monodromy/decimal.hpp"
#include "monodromy/monodromy.hpp"
#include "monodromy/words.hpp"
#include "symbol/document.hpp"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <complex>

namespace kov::python {
namespace {

namespace mo = kov::monodromy;

// ---- monodromy

struct MonodromyAnswer {
  mo::Monodromy m;
  std::optional<mo::Sl2Proof> sl2;
  std::string variable;
  long digits = 30;
};

double middle(const arb_struct* x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); }

py::list midpoints(const mo::BallMatrix& m) {
  py::list rows;
  for (long i = 0; i < m.size(); ++i) {
    py::list row;
    for (long j = 0; j < m.size(); ++j)
      row.append(std::complex<double>(middle(acb_realref(m.entry(i, j))),
                                      middle(acb_imagref(m.entry(i, j)))));
    rows.append(row);
  }
  return rows;
}

py::list decimals(const mo::BallMatrix& m, long digits) {
  py::list rows;
  for (long i = 0; i < m.size(); ++i) {
    py::list row;
    for (long j = 0; j < m.size(); ++j)
      row.append(mo::decimals(m.entry(i, j), digits));
    rows.append(row);
  }
  return rows;
}

py::list loops_of(const MonodromyAnswer& a) {
  py::list all;
  const py::object loop = py::module_::import("kovacic._evidence").attr("Loop");
  for (const mo::LoopMatrix& l : a.m.loops)
    all.append(loop(mo::to_string(l.place, a.variable), midpoints(l.matrix),
                    decimals(l.matrix, a.digits), mo::decimal_radius(l.matrix, a.digits)));
  return all;
}

MonodromyAnswer continued(const EquationText& text, long digits, const Budget& budget) {
  const GivenEquation e = read_equation(text, budget);
  MonodromyAnswer a{mo::monodromy(e.p, e.q, {.digits = digits, .base = {}, .budget = budget}),
                    std::nullopt, e.variable, digits};
  a.sl2 = mo::prove_sl2(a.m, budget);
  return a;
}

void bind_monodromy(py::module_& m) {
  read_only<MonodromyAnswer>(
      m, "Monodromy",
      "Monodromy matrices of (y, y') along a tree of loops, with proven radii: Y(base) = 1, and "
      "continued along a loop Y becomes Y M.",
      {"loops"})
      .def_property_readonly("base",
                             [](const MonodromyAnswer& a) { return mo::exact_decimals(a.m.base); })
      .def_property_readonly("loops", &loops_of)
      .def_property_readonly(
          "self_tests", [](const MonodromyAnswer& a) { return a.m.self_tests; },
          "what was tested, and held")
      .def_property_readonly(
          "proves",
          [](const MonodromyAnswer& a) -> std::optional<GroupType> {
            if (!a.sl2) return std::nullopt;
            return GroupType::SL2;
          },
          "SL2 if strict inequalities prove that the group of the normal form "
          "is SL(2, C); None proves nothing")
      .def_property_readonly(
          "words",
          [](const MonodromyAnswer& a) -> std::optional<std::vector<mo::Word>> {
            if (!a.sl2) return std::nullopt;
            if (const auto* p = std::get_if<mo::HyperbolicPair>(&*a.sl2))
              return std::vector{p->a, p->b};
            const auto& p = std::get<mo::NoSmallGroup>(*a.sl2);
            return std::vector{p.a, p.b, p.c};
          },
          "the words in the loops that prove it")
      .def("__repr__", [](const MonodromyAnswer& a) {
        return "<Monodromy: " + std::to_string(a.m.loops.size()) + " loops>";
      });
  m.def("monodromy", [](const Limits& limits, const QuestionTexts& texts, long digits) {
    if (digits < 1 || digits > 100000)
      throw InvalidArgument("digits: 1 to 100000 are expected, and not " + std::to_string(digits));
    const EquationText text = texts.read().text;
    return computed(limits, [&](const Budget& budget, const Interrupt&) {
      return continued(text, digits, budget);
    });
  });
}

// ---- sections

void bind_fixed_points(py::module_& m) {
  enumeration<flow::Ended>(m, "Ended",
                           {{"time", flow::Ended::time},
                            {"crossings", flow::Ended::crossings},
                            {"steps", flow::Ended::steps},
                            {"stopped", flow::Ended::stopped},
                            {"broken", flow::Ended::broken},
                            {"singular", flow::Ended::singular},
                            {"idle", flow::Ended::idle},
                            {"escaped", flow::Ended::escaped},
                            {"lost", flow::Ended::lost}});
  enumeration<flow::Stability>(m, "Stability",
                               {{"elliptic", flow::Stability::elliptic},
                                {"hyperbolic", flow::Stability::hyperbolic},
                                {"inverse_hyperbolic", flow::Stability::inverse_hyperbolic}});
  read_only<flow::PeriodicOrbit>(m, "FixedPoint", "A periodic orbit that meets the section once.",
                                 {"stability", "at"})
      .def_property_readonly(
          "at", [](const flow::PeriodicOrbit& o) { return o.points.at(0).drawn; },
          "what the scene draws of it")
      .def_property_readonly(
          "x", [](const flow::PeriodicOrbit& o) { return o.points.at(0).x; }, "all coordinates")
      .def_readonly("period", &flow::PeriodicOrbit::time)
      .def_readonly("trace", &flow::PeriodicOrbit::trace)
      .def_property_readonly("multiplier", &flow::PeriodicOrbit::multiplier)
      .def_readonly("stability", &flow::PeriodicOrbit::stability)
      .def_readonly("proved", &flow::PeriodicOrbit::proved)
      .def_readonly("error", &flow::PeriodicOrbit::error, "proved distance from the exact point")
      .def_readonly("trace_error", &flow::PeriodicOrbit::trace_error)
      .def_property_readonly(
          "why",
          [](const flow::PeriodicOrbit& o) { return o.proved ? "" : flow::to_string(o.why); },
          "where the proof failed");
  const auto cells = [](auto member) {
    return [member](const flow::PeriodicOrbits& all) {
      return all.cells.value_or(flow::CellCount{}).*member;
    };
  };
  read_only<flow::PeriodicOrbits>(m, "FixedPoints",
                                  "Those that were found; that there are no others is not proved.",
                                  {"points"})
      .def_readonly("points", &flow::PeriodicOrbits::orbits)
      .def_property_readonly("index_sum", cells(&flow::CellCount::index_sum))
      .def_property_readonly("cells", cells(&flow::CellCount::with_index))
      .def_property_readonly("cells_without_index", cells(&flow::CellCount::without))
      .def_property_readonly("unexplained_cells", cells(&flow::CellCount::unexplained))
      .def_readonly("stopped", &flow::PeriodicOrbits::stopped)
      .def_property_readonly("degenerate", cells(&flow::CellCount::identity));
  m.def("fixed_points", [](const Limits& limits, const Source& source) {
    const flow::SystemScene scene = flow::read_system_scenes(source.document()).at(0);
    return computed(limits, [&](const Budget& budget, const Interrupt& interrupt) {
      const Stop stop(interrupt, budget);
      flow::PeriodicOptions options;
      options.stop = stop.flag();
      return flow::periodic_orbits(scene, options);
    });
  });
}

} // namespace

void bind_numerics(py::module_& m) {
  bind_monodromy(m);
  bind_fixed_points(m);
}

} // namespace kov::python
