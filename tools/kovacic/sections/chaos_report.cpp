#include "sections/chaos_report.hpp"

#include "exact/lists.hpp"
#include "literature/literature.hpp"
#include "sections/section_files.hpp"
#include "symbol/input_error.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace kov::cli {
namespace {

using flow::DrawnBox;
using flow::FixedPointsInRectangle;
using flow::Homoclinic;
using flow::HomoclinicProof;
using flow::PeriodicOrbit;
using flow::PeriodicOrbits;
using flow::SystemScene;
using Json = nlohmann::ordered_json;

std::string named(const std::string& text) {
  std::string column;
  for (const char c : text)
    if (c != ' ' && c != '"') column += c;
  return column;
}

// Decimals that an error bound justifies.
int decimals(double error) {
  return error > 0 ? std::clamp(static_cast<int>(-std::log10(error)), 1, 15) : 15;
}
std::string number(double x, double error) {
  return fmt::format("{:.{}f}", std::abs(x) <= 2 * error ? 0.0 : x, decimals(error));
}

std::string place(const SystemScene& s, const std::array<double, 2>& at, double error) {
  return fmt::format("({}, {}) = ({}, {})", s.plot[0].text, s.plot[1].text, number(at[0], error),
                     number(at[1], error));
}

// What is drawn is a function of the coordinates, whose error is proved: this shows no more digits than it has.
double shown_error(const PeriodicOrbit& o) {
  return o.proved ? std::max(10 * o.error, 1e-13) : 1e-10;
}

std::string levels_of(const SystemScene& s) {
  std::string text;
  for (const auto& level : s.levels)
    text +=
        fmt::format("{}{} = {}", text.empty() ? "" : ", ", level.function.text, level.value.text());
  return text;
}

// Two digits, never above x > 0.
std::string rounded_down(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return fmt::format("{:.2g}", std::floor(0.999 * x / unit) * unit);
}

// The roots of t^2 - T t + D.  An error d of T moves a root l by less than 2 d |l|/spread where the other one is far away, and the
// nearest root by sqrt(d |l|) at most, however near they are: the product of the distances of l from both new roots is d |l|.
std::string multipliers(const PeriodicOrbit& o) {
  const auto [real, imaginary] = o.multiplier();
  const double large = std::hypot(real, imaginary), other = std::abs(o.determinant) / large;
  double error = 1e-8, error_of_other = 1e-8;
  if (o.proved) {
    const double spread =
        imaginary != 0 ? 2 * std::abs(imaginary) : std::abs(real - o.determinant / real);
    const double of_trace = o.trace_error + 1e-15 * (1 + large);
    const double by_slope = 2 * std::max(1.0, large / std::max(spread, 1e-300)) * of_trace;
    error = std::max(std::min(by_slope, 2 * std::sqrt(of_trace * large)), 1e-14);
    error_of_other = std::max(error * other / large, 1e-15); // of D/l
  }
  if (imaginary != 0)
    return fmt::format("{} +- {} i", number(real, error), number(imaginary, error));
  return fmt::format("{}, {}", number(real, error), number(o.determinant / real, error_of_other));
}

Json json_of(const PeriodicOrbit& o) {
  Json j{{"proved", o.proved}, {"kind", kind_of(o)}, {"time", o.time}, {"trace", o.trace}};
  if (o.proved)
    j.update(Json{{"error", o.error}, {"trace_error", o.trace_error}});
  else
    j["why"] = to_string(o.why);
  for (const auto& p : o.points)
    j["points"].push_back({{"drawn", p.drawn}, {"coordinates", p.x}});
  return j;
}

Json json_of(const HomoclinicProof& p) {
  Json j{{"periodic_orbit", json_of(p.fixed)},
         {"reach", p.reach},
         {"slopes", {p.slope_unstable, p.slope_stable}},
         {"stretches", {p.stretch_unstable, p.stretch_stable}},
         {"returns", p.orbit.size() - 1},
         {"point", p.orbit[p.middle].drawn},
         {"error", p.error},
         {"sine_at_least", p.sine}};
  for (const auto& z : p.orbit)
    j["orbit"].push_back(z.drawn);
  return j;
}

std::string power_of_map(int n) {
  return n == 1 ? "the section map" : fmt::format("power {} of the section map", n);
}

// "(x, y, u, v) = (0, 0.1, 0.5, 0)"
std::string state_text(const SystemScene& s, const std::vector<double>& x) {
  std::string names, values;
  for (std::size_t j = 0; j < x.size(); ++j) {
    names += (j > 0 ? ", " : "") + s.system.field.name(j);
    values += fmt::format("{}{:.8g}", j > 0 ? ", " : "", x[j] + 0.0);
  }
  return fmt::format("({}) = ({})", names, values);
}

// The smallest rectangle that holds them.
std::string undecided_text(const std::vector<DrawnBox>& boxes) {
  DrawnBox all = boxes.front();
  for (const DrawnBox& b : boxes)
    for (std::size_t d = 0; d < 2; ++d)
      all[d] = {std::min(all[d][0], b[d][0]), std::max(all[d][1], b[d][1])};
  return fmt::format("      these boxes lie in [{:.8g}, {:.8g}] x [{:.8g}, {:.8g}]\n", all[0][0],
                     all[0][1], all[1][0], all[1][1]);
}

int index_sum(const flow::FixedPointsOverSheet& sheet) {
  int sum = 0;
  for (const auto& p : sheet.points)
    sum += p.index;
  return sum;
}

Json json_of(const FixedPointsInRectangle& all) {
  Json j{{"period", all.period}, {"complete", complete(all)}, {"sheets", Json::array()}};
  for (const auto& sheet : all.sheets) {
    Json one{{"through", sheet.through},       {"complete", sheet.complete()},
             {"all_sheets", sheet.all_sheets}, {"boxes", sheet.boxes},
             {"points", Json::array()},        {"undecided", sheet.undecided}};
    for (const auto& p : sheet.points)
      one["points"].push_back({{"x", p.x}, {"error", p.error}, {"index", p.index}});
    if (sheet.complete()) one["index_sum"] = index_sum(sheet);
    j["sheets"].push_back(one);
  }
  return j;
}

// The hints of the grid at points that the list may lack.
std::string index_text(const flow::CellCount& found) {
  const auto cells = [](int n) { return fmt::format("{} cell{}", n, n == 1 ? "" : "s"); };
  if (found.identity) return "  the section map is the identity on most of the section\n";
  std::string text = fmt::format("  sum of indices {} over {} of the grid\n", found.index_sum,
                                 cells(found.with_index));
  if (const int n = found.without)
    text +=
        fmt::format("  {} without an index: the map jumps there, leaves the sheet of the level, "
                    "or has fixed points on the border\n",
                    cells(n));
  if (const int n = found.unexplained)
    text += fmt::format(
        "  {} whose index the points found in it do not make up: some were missed\n", cells(n));
  if (found.curves) text += "  curves of fixed points\n";
  return text;
}

} // namespace

std::string kind_of(const PeriodicOrbit& o) {
  if (!o.stability) return "undecided";
  std::string kind = to_string(*o.stability);
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

void write_periodic_orbits(const std::string& path, const SystemScene& s,
                           const PeriodicOrbits& found) {
  write_whole(path, [&](std::ofstream& out) {
    if (found.stopped) fmt::print(out, "# PARTIAL: the search or the proofs were stopped\n");
    fmt::print(out,
               "# points of period {} of the section map; error: proved, of every coordinate (inf: "
               "not proved)\n",
               found.period);
    fmt::print(out, "orbit {} {} error kind trace trace_error multiplier_re multiplier_im time\n",
               named(s.plot[0].text), named(s.plot[1].text));
    for (std::size_t i = 0; i < found.orbits.size(); ++i) {
      const PeriodicOrbit& o = found.orbits[i];
      for (const auto& p : o.points)
        fmt::print(out, "{} {:.17g} {:.17g} {:.1e} {} {:.15g} {:.1e} {:.12g} {:.12g} {:.12g}\n", i,
                   p.drawn[0], p.drawn[1], o.proved ? o.error : INFINITY, kind_of(o), o.trace,
                   o.proved ? o.trace_error : INFINITY, o.multiplier()[0], o.multiplier()[1],
                   o.time);
    }
  });
}

std::string proof_text(const SystemScene& s, const PeriodicOrbits& found) {
  std::string text = found.cells && !found.stopped ? index_text(*found.cells) : "";
  text += found.period == 1
              ? "  fixed points of the section map:"
              : fmt::format("  orbits of period {} of the section map:", found.period);
  bool any = false;
  for (const char* kind : {"elliptic", "hyperbolic", "inverse-hyperbolic", "undecided"}) {
    const auto n =
        std::ranges::count_if(found.orbits, [&](const auto& o) { return kind_of(o) == kind; });
    if (n > 0) text += fmt::format("{} {} {}", any ? "," : "", n, kind);
    any = any || n > 0;
  }
  text += any ? fmt::format("; that there are no others is not proved{}\n", s.body ? "" : " (--in)")
              : " none found, which proves nothing\n";
  if (found.stopped) text += "  PARTIAL: the search or the proofs were stopped\n";
  for (const PeriodicOrbit& o : found.orbits) {
    text += fmt::format("    {}", place(s, o.points[0].drawn, shown_error(o)));
    text += o.proved
                ? fmt::format(
                      "  time {:.10g}  {:18}  multipliers {}  proved: +-{:.0e}, trace +-{:.0e}\n",
                      o.time, kind_of(o), multipliers(o), o.error, o.trace_error)
                : fmt::format("  not proved: {}\n", to_string(o.why));
  }
  return text;
}

void write_homoclinic(const std::string& path, const SystemScene& s, const Homoclinic& found) {
  write_whole(path, [&](std::ofstream& out) {
    fmt::print(out,
               "# arcs of the manifolds: in double, not proved; homoclinic: the proved orbit\n");
    fmt::print(out, "what {} {}\n", named(s.plot[0].text), named(s.plot[1].text));
    const auto line = [&](const char* what, const std::array<double, 2>& at) {
      fmt::print(out, "{} {:.10g} {:.10g}\n", what, at[0], at[1]);
    };
    for (const auto* arcs : {&found.unstable, &found.stable})
      for (const auto& arc : *arcs)
        for (const auto& at : arc)
          line(arcs == &found.unstable ? "unstable" : "stable", at);
    if (!found.proof) return;
    for (const auto& z : found.proof->orbit)
      line("homoclinic", z.drawn);
    for (const auto& p : found.proof->fixed.points)
      line("hyperbolic", p.drawn);
  });
}

std::string reason(const Homoclinic& found) {
  return to_string(found.why) + (found.by_checker.empty() ? "" : ": " + found.by_checker);
}

std::string proof_text(const SystemScene& s, const Homoclinic& found) {
  if (!found.proof)
    return fmt::format("  no homoclinic point is proved: {}{}\n", reason(found),
                       found.stopped ? " (stopped)" : "");
  const HomoclinicProof& p = *found.proof;
  const PeriodicOrbit& fixed = p.fixed;
  const std::size_t n = fixed.points.size();
  const std::string map = power_of_map(static_cast<int>(n));
  return fmt::format(
      "  proved: on the level {} {} has a transverse homoclinic point to the {} fixed point at\n"
      "    {}, multipliers {}\n"
      "    its orbit passes near {}: {} returns of it are enclosed (radius {:.0e}), and\n"
      "    where the manifolds cross there |sin| of their angle is {}\n"
      "  hence ({}): a power of the map has a horseshoe, and every real-analytic\n"
      "    first integral on a connected open part of the level around the closure of this orbit "
      "is constant\n",
      levels_of(s), map, kind_of(fixed), place(s, fixed.points[0].drawn, shown_error(fixed)),
      multipliers(fixed), place(s, p.orbit[p.middle].drawn, 1e-6), p.orbit.size() - 1, p.error,
      p.sine > 0 ? "above " + rounded_down(p.sine) : "not 0", smale_moser().name);
}

bool complete(const FixedPointsInRectangle& all) {
  return !all.sheets.empty() &&
         std::ranges::all_of(all.sheets, [](const auto& sheet) { return sheet.complete(); });
}

std::string proof_text(const SystemScene& s, const FixedPointsInRectangle& all,
                       const std::vector<std::string>& r) {
  std::string text =
      fmt::format("  fixed points of {} in {} <= {} <= {}, {} <= {} <= {}:\n",
                  power_of_map(all.period), r[0], s.plot[0].text, r[1], r[2], s.plot[1].text, r[3]);
  for (const auto& sheet : all.sheets) {
    text += fmt::format(
        "    {}: {}\n",
        sheet.all_sheets        ? "on all sheets"
        : sheet.through.empty() ? "no sheet was found"
                                : "on the sheet through " + state_text(s, sheet.through),
        sheet.complete() ? fmt::format("proved: exactly {}, sum of indices {} ({} boxes)",
                                       sheet.points.size(), index_sum(sheet), sheet.boxes)
                         : fmt::format("undecided: {} proved, there may be more in {} of {} boxes",
                                       sheet.points.size(), sheet.undecided.size(), sheet.boxes));
    for (const auto& p : sheet.points)
      text +=
          fmt::format("      {}  index {:+d}  +-{:.0e}\n", state_text(s, p.x), p.index, p.error);
    if (!sheet.complete()) text += undecided_text(sheet.undecided);
  }
  if (all.stopped) text += "  PARTIAL: the proof was stopped\n";
  return text;
}

std::string json_of(const SystemScene& s, const PeriodicOrbits* orbits,
                    const Homoclinic* homoclinic, const FixedPointsInRectangle* all,
                    const Json& simulation) {
  Json j{{"file", s.file},
         {"scene", s.name},
         {"section", s.section.text},
         {"level", levels_of(s)},
         {"simulation", simulation}};
  if (orbits != nullptr) {
    j["period"] = orbits->period;
    j["complete"] = false; // that there are no others anywhere is never proved
    j["orbits"] = Json::array();
    for (const PeriodicOrbit& o : orbits->orbits)
      j["orbits"].push_back(json_of(o));
  }
  if (all != nullptr) j["all_fixed_points"] = json_of(*all);
  if (homoclinic != nullptr) {
    Json& h = j["homoclinic"];
    h = Json{{"proved", homoclinic->proof.has_value()}};
    if (homoclinic->proof) {
      h.update(json_of(*homoclinic->proof));
      h["theorem"] = {{"id", smale_moser().id}, {"statement", smale_moser().statement}};
      for (const auto& hypothesis : smale_moser().hypotheses)
        h["theorem"]["hypotheses"].push_back({{"text", hypothesis.text}, {"how", hypothesis.how}});
    } else {
      h["why"] = reason(*homoclinic);
    }
  }
  return j.dump(2);
}

std::string certificate_of(const SystemScene& s, const Homoclinic& found) {
  const VectorField& v = s.system.field;
  const HomoclinicProof& p = *found.proof;
  if (p.fixed.points.size() > 1)
    throw InputError(s.file, 0, 0, 1, "certificates of homoclinic points are for --period 1");
  const auto polynomial = [&](const MFraction& f) {
    return is_constant(MFraction(f.den())) && v.functions.empty() && v.constants.empty() &&
           v.parameters.empty();
  };
  if (s.system.kind != SystemKind::hamiltonian || v.dimension() != 4 ||
      !polynomial(*v.hamiltonian) || !polynomial(s.section.value) ||
      (s.where && !polynomial(s.where->value)) || !(s.levels[0].function.value == *v.hamiltonian))
    throw InputError(
        s.file, 0, 0, 1,
        "certificates of homoclinic points are for polynomial Hamiltonians with two degrees "
        "of freedom, on a level of H");
  const auto exact = [](double x) { return fmt::format("{:.17g}", x); };
  const auto all = [&](const auto& numbers) { return Json(mapped<std::string>(numbers, exact)); };
  const auto text = [](const MFraction& f) { return Json{to_string(f.num()), to_string(f.den())}; };
  Json j{{"format", "kovacic-homoclinic/1"},
         {"variables", {v.name(0), v.name(1), v.name(2), v.name(3)}},
         {"hamiltonian", text(*v.hamiltonian)},
         {"level", s.levels[0].value.text()},
         {"section", text(s.section.value)},
         {"direction", s.rising ? "upward" : "downward"},
         {"where", s.where ? text(s.where->value) : Json()},
         {"period", std::to_string(p.fixed.points.size())},
         {"point", all(p.fixed.points[0].x)},
         {"chart", {std::to_string(p.chart.free[0]), std::to_string(p.chart.free[1])}},
         {"axes", Json::array({all(p.axes[0]), all(p.axes[1])})},
         {"reach", exact(p.reach)},
         {"xi", exact(p.xi)},
         {"eta", exact(p.eta)}};
  for (std::size_t k = 1; k + 1 < p.orbit.size(); ++k)
    j["orbit"].push_back(all(p.orbit[k].x));
  return j.dump(1) + "\n";
}

} // namespace kov::cli
