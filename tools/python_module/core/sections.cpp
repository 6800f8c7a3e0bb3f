// Sections of any system: the scenes of a system file.  Doubles, for the eye.

#include "bind.hpp"
#include "flow_enums.hpp"
#include "source.hpp"
#include "stop.hpp"

#include "flow/scene/system_section.hpp"

#include <pybind11/stl.h>

namespace kov::python {
namespace {

using flow::DrawnOrbit;
using flow::DrawnPoint;
using flow::SystemScene;
using flow::SystemSection;

template <class T, class Get> py::bytes bytes_of(const SystemSection& s, const Get& get) {
  std::vector<T> all;
  all.reserve(s.points.size());
  for (const DrawnPoint& p : s.points)
    all.push_back(static_cast<T>(get(p)));
  return {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T)};
}

/// A function of Python that is told how far a computation is, from whichever thread.  What it raises ends the
/// computation and is raised again.
class Progress {
public:
  explicit Progress(py::object function) : function_(std::move(function)) {}

  void operator()(std::size_t done, std::size_t all, Stop& stop) {
    if (function_.is_none()) return;
    const py::gil_scoped_acquire lock;
    if (raised_) return;
    try {
      function_(done, all);
    } catch (py::error_already_set& e) {
      raised_.emplace(std::move(e));
      stop.request();
    }
  }
  void raise_again() {
    if (raised_) throw std::move(*raised_);
  }

private:
  py::object function_;
  std::optional<py::error_already_set> raised_;
};

void bind_orbits(py::module_& m) {
  py::class_<DrawnOrbit>(m, "DrawnOrbit", "An orbit of a section of any system.")
      .def_readonly("start", &DrawnOrbit::start, "where it starts, in the picture")
      .def_readonly("crossings", &DrawnOrbit::crossings)
      .def_readonly("tangencies", &DrawnOrbit::tangencies)
      .def_readonly("steps", &DrawnOrbit::steps)
      .def_readonly("time", &DrawnOrbit::time)
      .def_readonly("drift", &DrawnOrbit::drift, "the largest of its integrals, relative")
      .def_readonly("ended", &DrawnOrbit::ended)
      .def_property_readonly("megno", [](const DrawnOrbit& o) { return o.indicators.megno; })
      .def_property_readonly("lyapunov", [](const DrawnOrbit& o) { return o.indicators.lyapunov; })
      .def_property_readonly("fli", [](const DrawnOrbit& o) { return o.indicators.fli; })
      .def(py::pickle(
          [](const DrawnOrbit& o) { // what is shown above
            return py::make_tuple(o.start, o.crossings, o.tangencies, o.steps, o.time, o.drift,
                                  o.ended, o.indicators.megno, o.indicators.lyapunov,
                                  o.indicators.fli);
          },
          [](const py::tuple& t) {
            DrawnOrbit o;
            o.start = t[0].cast<std::array<double, 2>>();
            o.crossings = t[1].cast<long>();
            o.tangencies = t[2].cast<int>();
            o.steps = t[3].cast<long>();
            o.time = t[4].cast<double>();
            o.drift = t[5].cast<double>();
            o.ended = t[6].cast<flow::Ended>();
            o.indicators.megno = t[7].cast<double>();
            o.indicators.lyapunov = t[8].cast<double>();
            o.indicators.fli = t[9].cast<double>();
            return o;
          }));
}

void bind_points(py::module_& m) {
  read_only<SystemSection>(m, "SystemSectionData", "The points of a section of any system.")
      .def_property_readonly("orbit",
                             [](const SystemSection& s) {
                               return bytes_of<std::int64_t>(s,
                                                             [](const auto& p) { return p.orbit; });
                             })
      .def_property_readonly("t",
                             [](const SystemSection& s) {
                               return bytes_of<double>(s, [](const auto& p) { return p.t; });
                             })
      .def_property_readonly("x",
                             [](const SystemSection& s) {
                               return bytes_of<double>(s, [](const auto& p) { return p.at[0]; });
                             })
      .def_property_readonly("y",
                             [](const SystemSection& s) {
                               return bytes_of<double>(s, [](const auto& p) { return p.at[1]; });
                             })
      .def_readonly("orbits", &SystemSection::orbits)
      .def_readonly("integrals", &SystemSection::integrals)
      .def_readonly("drifts", &SystemSection::drifts)
      .def_readonly("drift", &SystemSection::drift)
      .def_readonly("arithmetic", &SystemSection::arithmetic)
      .def_readonly("skipped", &SystemSection::skipped)
      .def_readonly("stopped", &SystemSection::stopped)
      .def_property_readonly("cut_short", &SystemSection::cut_short);
}

py::object simulated(const Limits& limits, const SystemScene& scene, int threads,
                     const py::object& function) {
  if (threads < 1 || threads > 256)
    throw InvalidArgument("threads: 1 to 256 are expected, and not " + std::to_string(threads));
  Progress progress(function);
  py::object result = computed(limits, [&](const Budget& budget, const Interrupt& interrupt) {
    Stop stop(interrupt, budget);
    flow::SystemSectionOptions options;
    options.threads = threads;
    options.stop = stop.flag();
    options.progress = [&](std::size_t done, std::size_t all) { progress(done, all, stop); };
    return flow::simulate(scene, options);
  });
  progress.raise_again();
  return result;
}

} // namespace

void bind_sections(py::module_& m) {
  bind_orbits(m);
  bind_points(m);
  read_only<SystemScene>(m, "SystemScene", "Which section, which level, which orbits of a system.")
      .def_readonly("name", &SystemScene::name)
      .def_readonly("title", &SystemScene::title)
      .def_property_readonly(
          "plot",
          [](const SystemScene& s) {
            return std::array{s.plot[0].text, s.plot[1].text};
          },
          "what is drawn")
      .def_property_readonly("section", [](const SystemScene& s) { return s.section.text; })
      .def_property_readonly("is_scan", [](const SystemScene& s) { return s.scan.has_value(); })
      .def_property_readonly("indicator",
                             [](const SystemScene& s) { return flow::to_string(s.indicator); })
      .def_property_readonly("allowed_drift",
                             [](const SystemScene& s) { return s.drift.as<double>(); });
  m.def("has_system_scenes",
        [](const Source& source) { return flow::has_system_scenes(source.document()); });
  m.def("system_scenes",
        [](const Source& source) { return flow::read_system_scenes(source.document()); });
  m.def("system_section", &simulated);
}

} // namespace kov::python
