// Numbers with proven radii: monodromy().  Pictures: section(), the only place with doubles.

#include "bind.hpp"
#include "flow_enums.hpp"
#include "question.hpp"
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

/// One column of the points as the bytes of doubles.
template <class T, class Get> py::bytes column(const flow::Section& s, const Get& get) {
  std::vector<T> all;
  all.reserve(s.points.size());
  for (const flow::SectionPoint& p : s.points)
    all.push_back(static_cast<T>(get(p)));
  return {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T)};
}

void bind_body_sections(py::module_& m) {
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
                                {"inverse_hyperbolic", flow::Stability::inverse_hyperbolic},
                                {"parabolic", flow::Stability::parabolic}});
  py::class_<flow::OrbitReport>(m, "OrbitReport")
      .def_readonly("l", &flow::OrbitReport::l)
      .def_readonly("y", &flow::OrbitReport::y)
      .def_readonly("G", &flow::OrbitReport::g_size)
      .def_readonly("sign", &flow::OrbitReport::sign)
      .def_readonly("crossings", &flow::OrbitReport::crossings)
      .def_readonly("tangencies", &flow::OrbitReport::tangencies)
      .def_readonly("steps", &flow::OrbitReport::steps)
      .def_readonly("time", &flow::OrbitReport::time)
      .def_readonly("drift", &flow::OrbitReport::drift, "of H, F1, F2, relative")
      .def_readonly("ended", &flow::OrbitReport::ended)
      .def(py::pickle(
          [](const flow::OrbitReport& o) {
            return py::make_tuple(o.l, o.y, o.g_size, o.sign, o.crossings, o.tangencies, o.steps,
                                  o.time, o.drift, o.ended);
          },
          [](const py::tuple& t) {
            return flow::OrbitReport{.l = t[0].cast<double>(),
                                     .y = t[1].cast<double>(),
                                     .g_size = t[2].cast<double>(),
                                     .sign = t[3].cast<int>(),
                                     .crossings = t[4].cast<long>(),
                                     .steps = t[6].cast<long>(),
                                     .tangencies = t[5].cast<int>(),
                                     .time = t[7].cast<double>(),
                                     .drift = t[8].cast<std::array<double, 3>>(),
                                     .ended = t[9].cast<flow::Ended>()};
          }));
  read_only<flow::Section>(m, "SectionData", "The points of a Poincare section.")
      .def_property_readonly("orbit",
                             [](const flow::Section& s) {
                               return column<std::int64_t>(s,
                                                           [](const auto& p) { return p.orbit; });
                             })
      .def_property_readonly("t",
                             [](const flow::Section& s) {
                               return column<double>(s, [](const auto& p) { return p.t; });
                             })
      .def_property_readonly("l",
                             [](const flow::Section& s) {
                               return column<double>(s, [](const auto& p) { return p.l; });
                             })
      .def_property_readonly("y",
                             [](const flow::Section& s) {
                               return column<double>(s, [](const auto& p) { return p.y; });
                             })
      .def_property_readonly("G",
                             [](const flow::Section& s) {
                               return column<double>(s, [](const auto& p) { return p.g_size; });
                             })
      .def_property_readonly("digits",
                             [](const flow::Section& s) {
                               py::list all;
                               for (const auto& p : s.points)
                                 if (!p.digits.empty()) all.append(p.digits);
                               return all;
                             })
      .def_readonly("orbits", &flow::Section::orbits)
      .def_readonly("drift", &flow::Section::drift)
      .def_readonly("arithmetic", &flow::Section::arithmetic)
      .def_readonly("skipped", &flow::Section::skipped)
      .def_readonly("stopped", &flow::Section::stopped)
      .def_property_readonly("cut_short", &flow::Section::cut_short);
  read_only<flow::FixedPoint>(m, "FixedPoint", "A periodic orbit that meets the section once.",
                              {"stability", "l", "y"})
      .def_readonly("l", &flow::FixedPoint::l)
      .def_readonly("y", &flow::FixedPoint::y, "L/G")
      .def_readonly("G", &flow::FixedPoint::g_size)
      .def_readonly("period", &flow::FixedPoint::period)
      .def_readonly("trace", &flow::FixedPoint::trace)
      .def_readonly("multiplier", &flow::FixedPoint::multiplier)
      .def_readonly("stability", &flow::FixedPoint::stability)
      .def_readonly("proved", &flow::FixedPoint::proved)
      .def_readonly("error", &flow::FixedPoint::error, "proved distance from the exact point")
      .def_readonly("trace_error", &flow::FixedPoint::trace_error)
      .def_property_readonly(
          "why", [](const flow::FixedPoint& f) { return f.proved ? "" : flow::to_string(f.why); },
          "where the proof failed");
  read_only<flow::FixedPoints>(m, "FixedPoints",
                               "Those that were found; that there are no others is not proved.",
                               {"points"})
      .def_readonly("points", &flow::FixedPoints::points)
      .def_readonly("index_sum", &flow::FixedPoints::index_sum)
      .def_readonly("cells", &flow::FixedPoints::cells)
      .def_readonly("cells_without_index", &flow::FixedPoints::cells_without_index)
      .def_readonly("unexplained_cells", &flow::FixedPoints::unexplained_cells)
      .def_readonly("stopped", &flow::FixedPoints::stopped)
      .def_readonly("degenerate", &flow::FixedPoints::degenerate);
  read_only<flow::Scene>(m, "Scene", "Which body, on which level, seen in which section.")
      .def_readonly("title", &flow::Scene::title)
      .def_readonly("file", &flow::Scene::file)
      .def_property_readonly("allowed_drift",
                             [](const flow::Scene& s) { return s.drift.as<double>(); });
  m.def("scene", [](const std::string& text, const std::string& name) {
    return text.empty() ? flow::read_scene(name) : flow::parse_scene(text, name);
  });
  m.def("section", [](const Limits& limits, const flow::Scene& scene, int threads, int lanes) {
    if (threads < 1 || threads > 256)
      throw InvalidArgument("threads: 1 to 256 are expected, and not " + std::to_string(threads));
    if (lanes != 0 && lanes != 1 && lanes != 4 && lanes != 8)
      throw InvalidArgument("lanes: 0, 1, 4 or 8 are expected, and not " + std::to_string(lanes));
    return computed(limits, [&](const Budget& budget, const Interrupt& interrupt) {
      const Stop stop(interrupt, budget);
      flow::SimulateOptions options;
      options.threads = threads;
      options.lanes = lanes;
      options.stop = stop.flag();
      return flow::simulate(scene, options);
    });
  });
  m.def("fixed_points", [](const Limits& limits, const flow::Scene& scene) {
    return computed(limits, [&](const Budget& budget, const Interrupt& interrupt) {
      const Stop stop(interrupt, budget);
      flow::FixedPointOptions options;
      options.stop = stop.flag();
      return flow::fixed_points(scene, options);
    });
  });
}

} // namespace

void bind_numerics(py::module_& m) {
  bind_monodromy(m);
  bind_body_sections(m);
}

} // namespace kov::python
