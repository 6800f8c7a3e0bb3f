#include "sections/section_report.hpp"

#include "sections/section_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace kov::cli {
namespace {

using flow::DrawnOrbit;
using flow::Ended;
using flow::Indicator;
using flow::SystemScene;
using flow::SystemSection;

std::string list(const std::array<flow::Quantity, 3>& v) {
  return "(" + v[0].text() + ", " + v[1].text() + ", " + v[2].text() + ")";
}

std::string moments(const flow::Scene& s) {
  bool full = false;
  for (std::size_t i = 0; i < 3; ++i)
    full = full || !s.inertia[i][(i + 1) % 3].is_zero();
  if (!full) return list({s.inertia[0][0], s.inertia[1][1], s.inertia[2][2]});
  return "(" + list(s.inertia[0]) + ", " + list(s.inertia[1]) + ", " + list(s.inertia[2]) + ")";
}

std::string body_text(const flow::Scene& s) {
  const bool still =
      std::ranges::all_of(s.gyrostat, [](const flow::Quantity& b) { return b.is_zero(); });
  return fmt::format("{} tip, I = {}, lever {}, mass {}, gravity {}{}",
                     s.sliding ? "sliding" : "fixed", moments(s), list(s.lever), s.mass.text(),
                     s.gravity.text(), still ? "" : ", B = " + list(s.gyrostat));
}

std::string angle_text(const flow::Scene& s) {
  const flow::SectionRule& rule = s.section;
  const bool half = rule.side > 0;
  const bool up = half ? rule.falling : rule.rising, down = half ? rule.rising : rule.falling;
  return fmt::format("g = {}, {}{}", half ? "pi/2" : "3pi/2",
                     up && down ? "both directions"
                     : up       ? "dg/dt > 0"
                                : "dg/dt < 0",
                     rule.axis == 2 ? "" : fmt::format(", axis {}", rule.axis + 1));
}

// A level that is not an integral is one for the start.
std::string levels_of(const SystemScene& s) {
  if (s.body)
    return fmt::format("H = {}, F1 = {}, F2 = {}", s.body->scene.energy.text(),
                       s.body->scene.length.text(), s.body->scene.casimir.text());
  std::string text;
  const std::vector<flow::SceneFormula> integrals = s.integrals();
  for (const auto& level : s.levels) {
    const bool stays = std::ranges::any_of(
        integrals, [&](const auto& f) { return f.value == level.function.value; });
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : ", ", level.function.text,
                        level.value.text(), stays ? "" : " at the start");
  }
  return text;
}

bool is_scanned(const SystemScene& s, std::size_t parameter) {
  return s.scan && std::ranges::any_of(s.scan->axes, [&](const auto& a) {
           return a.kind == flow::ScanAxis::Kind::parameter && a.place == parameter;
         });
}

std::string parameters_of(const SystemScene& s) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
  };
  for (const auto& [name, value] : s.system.values)
    add(name, name != s.varied ? to_string(value)
                               : fmt::format("{} ... {} ({} values)", to_string(value),
                                             to_string(s.family.back().system.values.at(name)),
                                             s.family.size()));
  for (const auto& [variable, value] : s.values)
    if (!is_scanned(s, variable)) add(s.system.ring()->name(variable), value.text());
  return text;
}

std::string drifts_of(const SystemSection& r) {
  std::string text;
  for (std::size_t i = 0; i < r.integrals.size(); ++i)
    text += fmt::format("{}{}: {:.1e}", text.empty() ? "relative drift of " : ", of ",
                        r.integrals[i], r.drifts[i]);
  return text.empty() ? "no integrals to check" : text;
}

// 1e-6, not 1e-06
std::string power_text(double x) {
  std::string text = fmt::format("{:.0e}", x);
  if (const std::size_t zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text;
}

} // namespace

std::string section_text(const SystemScene& s) {
  if (s.body) return angle_text(s.body->scene);
  const std::string& g = s.section.text;
  if (s.rising && s.falling) return g + " = 0";
  const bool is_name = std::ranges::all_of(
      g, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
  return fmt::format("{} = 0, {}' {} 0", g, is_name ? g : "(" + g + ")", s.rising ? ">" : "<");
}

std::string outside_of_level(const SystemScene& s, const SystemSection& r) {
  const std::string level = levels_of(s);
  return fmt::format("{} of {} starting points lie outside the level {}", r.skipped,
                     r.skipped + r.orbits.size(), level.empty() ? "of the scene" : level);
}

std::string accuracy_text(const SystemSection& r) {
  const flow::PointAccuracy a = accuracy_of(r);
  if (!a.known) return {};
  const std::size_t orbits = r.orbits.size();
  std::string text;
  if (a.whole == orbits)
    text = "the points are right to " + power_text(a.bound);
  else if (a.returns == 0)
    text = fmt::format("the points are not right to {}, not even the first of each orbit",
                       power_text(a.bound));
  else
    text = fmt::format("the points are right to {} for the first {} return{}", power_text(a.bound),
                       a.returns, a.returns == 1 ? "" : "s");
  if (a.whole > 0 && a.whole < orbits)
    text += fmt::format(" ({} of {} orbits: for all)", a.whole, orbits);
  if (a.doubtful > 0)
    text +=
        fmt::format("; {} of {} points have errors above {} (drawn lighter): they are statistical",
                    a.doubtful, r.points.size(), power_text(flow::visible_error));
  return text;
}

std::string mechanics_text(const SystemScene& s) {
  std::string mechanics;
  for (const std::string& part :
       {s.body ? body_text(s.body->scene) : parameters_of(s), levels_of(s)})
    if (!part.empty()) mechanics += part + "; ";
  mechanics += section_text(s);
  if (s.where && !s.body) mechanics += fmt::format(", where {} > 0", s.where->text);
  return mechanics;
}

std::vector<std::string> caption(const SystemScene& s, const SystemSection& r) {
  std::vector<std::string> lines{
      mechanics_text(s),
      fmt::format("{} orbit{}, {} point{}; Taylor order {}, {}, tolerance {}; {}", r.orbits.size(),
                  r.orbits.size() == 1 ? "" : "s", r.points.size(), r.points.size() == 1 ? "" : "s",
                  r.order, r.arithmetic, s.tolerance.text(), drifts_of(r))};
  if (const std::string text = accuracy_text(r); !text.empty()) lines.push_back(text);
  return lines;
}

std::string shortfall(const SystemSection& r) {
  std::string text;
  const auto add = [&](std::size_t n, const std::string& what) {
    if (n > 0)
      text +=
          fmt::format("{}{} of {} orbits {}", text.empty() ? "" : "; ", n, r.orbits.size(), what);
  };
  add(r.count(Ended::stopped), "were stopped before their end");
  add(r.cut_short(), fmt::format("ended at the limit of {} before their last crossing",
                                 r.has_time ? "points" : "steps"));
  return text;
}

std::string partial(const SystemSection& r) {
  const std::string missing = shortfall(r);
  return missing.empty() ? "" : "PARTIAL: " + missing;
}

namespace {

// "3 of 10 orbits"
std::string orbits_text(std::size_t n, const SystemSection& r) {
  return fmt::format("{} of {} orbit{}", n, r.orbits.size(), r.orbits.size() == 1 ? "" : "s");
}

// "orbit 1 from t = 36.7 on, orbit 4 from t = 12 on, ..."
std::string since_text(const SystemSection& r, double DrawnOrbit::*from) {
  std::string text;
  int named = 0;
  for (std::size_t i = 0; i < r.orbits.size(); ++i) {
    if (!(r.orbits[i].*from > 0)) continue;
    if (++named > 3) return text + ", ...";
    text +=
        fmt::format("{}orbit {} from t = {:.4g} on", named > 1 ? ", " : "", i, r.orbits[i].*from);
  }
  return text;
}

// Both kinds: from the start, and from later on.
void add_since(std::vector<std::string>& lines, const SystemSection& r, double DrawnOrbit::*from,
               const std::string& always, const std::string& later) {
  const auto count = [&](const auto& holds) {
    return static_cast<std::size_t>(
        std::ranges::count_if(r.orbits, [&](const DrawnOrbit& o) { return holds(o.*from); }));
  };
  if (const std::size_t n = count([](double t) { return t == 0; }); n > 0)
    lines.push_back(always + ": " + orbits_text(n, r));
  if (const std::size_t n = count([](double t) { return t > 0; }); n > 0)
    lines.push_back(fmt::format("{}: {} ({})", later, orbits_text(n, r), since_text(r, from)));
}

bool is_early(const DrawnOrbit& o) {
  return o.ended == Ended::singular || o.ended == Ended::broken || o.ended == Ended::escaped ||
         o.ended == Ended::lost;
}

// "at t = 1.1107", "from t = 3.1 on"
std::string times_of(const SystemSection& r, Ended how) {
  double first = INFINITY, last = 0;
  for (const DrawnOrbit& o : r.orbits)
    if (o.ended == how) {
      first = std::min(first, o.time);
      last = std::max(last, o.time);
    }
  return first == last ? fmt::format("at t = {:.8g}", first)
                       : fmt::format("between t = {:.6g} and t = {:.6g}", first, last);
}

// What the section is near zero.
void add_doubts(std::vector<std::string>& lines, const SystemSection& r) {
  long touched = 0, hidden = 0;
  std::size_t hiding = 0;
  for (const DrawnOrbit& o : r.orbits) {
    touched += o.tangencies;
    hidden += o.hidden;
    hiding += o.hidden > 0 ? 1 : 0;
  }
  if (touched > 0)
    lines.push_back(
        fmt::format("the section is touched {} time{} without a crossing, but for rounding",
                    touched, touched == 1 ? "" : "s"));
  if (r.again > 0)
    lines.push_back(fmt::format("{} ran again with {} digits: with fewer, rounding hides crossings",
                                orbits_text(r.again, r), r.digits_again));
  if (hiding > 0)
    lines.push_back(fmt::format("rounding hides the section in {} steps of {}: crossings may be "
                                "missing (more 'digits' show them)",
                                hidden, orbits_text(hiding, r)));
}

} // namespace

std::vector<std::string> remarks(const SystemScene& s, const SystemSection& r) {
  std::vector<std::string> lines;
  if (const std::size_t n = r.count(Ended::singular); n > 0)
    lines.push_back(fmt::format("{} end{} in a singularity {}: a collision, an encounter too close "
                                "for the digits, or infinity in finite time",
                                orbits_text(n, r), n == 1 ? "s" : "",
                                times_of(r, Ended::singular)));
  if (const std::size_t n = r.count(Ended::escaped); n > 0)
    lines.push_back(fmt::format("{} escape{}: 10^24 times as far as the others {}",
                                orbits_text(n, r), n == 1 ? "s" : "", times_of(r, Ended::escaped)));
  if (const std::size_t n = r.count(Ended::lost); n > 0)
    lines.push_back(fmt::format(
        "{} {} lost {} integrals {} (an encounter too close for the "
        "digits): what follows is not a motion of the system, and is not drawn (more 'digits')",
        orbits_text(n, r), n == 1 ? "has" : "have", n == 1 ? "its" : "their",
        times_of(r, Ended::lost)));
  if (const std::size_t n = r.count(Ended::broken); n > 0)
    lines.push_back(fmt::format("{} of {} orbits end where the field has no value (0/0), or beyond "
                                "the largest number",
                                n, r.orbits.size()));
  add_since(lines, r, &DrawnOrbit::rest_from, "at an equilibrium from the start",
            "come to rest at an equilibrium, but for the rounding of the start");
  add_since(lines, r, &DrawnOrbit::inside_from,
            "in the section " + s.section.text +
                " from the start, but for rounding, which is not a crossing",
            "within rounding of the section in the end, where crossings are not seen");
  add_doubts(lines, r);
  return lines;
}

std::string chaos_of(const SystemSection& r) {
  std::vector<std::size_t> moving, resting;
  for (std::size_t i = 0; i < r.orbits.size(); ++i)
    if (!is_early(r.orbits[i])) (r.orbits[i].rest_from < 0 ? moving : resting).push_back(i);
  const auto& all = moving.empty() ? resting : moving;
  if (all.empty()) return "no exponents: every orbit ends early";
  const auto of = [&](std::size_t i) { return r.orbits[i].indicators; };
  const std::size_t most = *std::ranges::max_element(
      all, [&](auto a, auto b) { return of(a).lyapunov < of(b).lyapunov; });
  std::string text = fmt::format(
      "largest Lyapunov exponent {:.4g} +- {:.1g} (orbit {}, {}numerically)", of(most).lyapunov,
      of(most).lyapunov_error, most, moving.empty() ? "that of its equilibrium, " : "");
  if (!moving.empty())
    text +=
        fmt::format("; <MEGNO> above 3: {} of {} orbits",
                    std::ranges::count_if(moving, [&](std::size_t i) { return of(i).megno > 3; }),
                    moving.size());
  if (const std::size_t left = r.orbits.size() - moving.size(); left > 0 && !moving.empty())
    text += fmt::format(" ({} that rest{} or end early are left out)", left, left == 1 ? "s" : "");
  return text;
}

std::string spectrum_text(const SystemSection& r) {
  const DrawnOrbit* most = nullptr;
  std::size_t known = 0;
  for (const DrawnOrbit& o : r.orbits) {
    if (o.spectrum.exponents.empty()) continue;
    ++known;
    if (most == nullptr || o.spectrum.exponents[0].rate > most->spectrum.exponents[0].rate)
      most = &o;
  }
  if (most == nullptr) return "no spectrum: every orbit ends early";
  std::string text = fmt::format("Lyapunov exponents of orbit {}: ", most - r.orbits.data());
  double sum = 0;
  for (const auto& e : most->spectrum.exponents) {
    text += fmt::format("{}{:.5g} +- {:.1g}", text.ends_with(": ") ? "" : ", ", e.rate, e.error);
    sum += e.rate;
  }
  if (most->spectrum.exponents.size() > 1)
    text += fmt::format("; sum {:.5g}; log10 SALI {:.2f}", sum, most->spectrum.log_sali);
  if (known < r.orbits.size())
    text += fmt::format(" ({} that end early {} left out)", r.orbits.size() - known,
                        r.orbits.size() - known == 1 ? "is" : "are");
  return text;
}

std::string winding_text(const SystemSection& r) {
  double least = INFINITY, most = -INFINITY, worst = 0;
  std::size_t known = 0, sharp = 0;
  for (const DrawnOrbit& o : r.orbits) {
    if (o.winding.error < 0) continue;
    ++known;
    sharp += o.winding.error < 1e-6 ? 1 : 0;
    worst = std::max(worst, o.winding.error);
    least = std::min(least, o.winding.turns);
    most = std::max(most, o.winding.turns);
  }
  if (known == 0) return "no winding numbers: too few points, or they do not go round a centre";
  if (known == 1)
    return fmt::format("winding number {:.12g} +- {:.1g} turns a return", least, worst);
  return fmt::format("winding numbers {:.6g} to {:.6g} turns a return ({}; {} of them to 10^-6)",
                     least, most, orbits_text(known, r), sharp);
}

std::string never_crossed(const SystemScene& s, const SystemSection& r) {
  std::string text =
      r.orbits.size() == 1
          ? "the section is never crossed"
          : fmt::format("the section is never crossed by any of {} orbits", r.orbits.size());
  for (const std::string& line : remarks(s, r))
    text += "; " + line;
  return text;
}

std::string colour_of(const SystemScene& s) { return s.sign_of ? "sign" : to_string(s.indicator); }

double indicator_of(const SystemScene& s, const DrawnOrbit& o) {
  if (s.sign_of) return o.sign;
  switch (s.indicator) {
  case Indicator::megno:
    return o.indicators.megno;
  case Indicator::lyapunov:
    return o.indicators.lyapunov;
  case Indicator::fli:
    return o.indicators.fli;
  case Indicator::sali:
    return o.spectrum.log_sali;
  default:
    return 0;
  }
}

namespace {

void add_motion(nlohmann::ordered_json& j, const SystemScene& s, const DrawnOrbit& o) {
  using Json = nlohmann::ordered_json;
  if (s.exponents > 0) {
    Json all = Json::array(), errors = Json::array();
    for (const auto& e : o.spectrum.exponents) {
      all.push_back(e.rate);
      errors.push_back(e.error);
    }
    j.update(
        {{"exponents", all}, {"exponent_errors", errors}, {"log10_gali", o.spectrum.log_gali}});
    j["log10_sali"] = o.spectrum.log_gali.empty() ? Json() : Json(o.spectrum.log_sali);
  }
  if (!s.winding) return;
  const bool known = !(o.winding.error < 0);
  j["winding"] = known ? Json(o.winding.turns) : Json();
  j["winding_error"] = known ? Json(o.winding.error) : Json();
}

nlohmann::ordered_json accuracy_json(const SystemSection& r) {
  const flow::PointAccuracy a = accuracy_of(r);
  if (!a.known) return {};
  return {{"right_to", a.bound},
          {"first_returns", a.returns},
          {"whole_orbits", a.whole},
          {"points_above_1e-3", a.doubtful}};
}

} // namespace

nlohmann::ordered_json json_of(const SystemScene& s, const SystemSection& r) {
  const auto since = [](double t) {
    return t < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(t);
  };
  nlohmann::ordered_json j{
      {"points", r.points.size()},    {"drift", r.drift},
      {"accuracy", accuracy_json(r)}, {"partial", !shortfall(r).empty()},
      {"remarks", remarks(s, r)},     {"orbits", nlohmann::ordered_json::array()}};
  for (const DrawnOrbit& o : r.orbits) {
    j["orbits"].push_back({{"start", o.start},
                           {"crossings", o.crossings},
                           {"tangencies", o.tangencies},
                           {"time", o.time},
                           {"drift", o.drift},
                           {"rest_from", since(o.rest_from)},
                           {"inside_from", since(o.inside_from)},
                           {"ended_by", word(o.ended)}});
    add_motion(j["orbits"].back(), s, o);
    if (!s.has_tangent()) continue;
    j["orbits"].back().update({{"lyapunov", o.indicators.lyapunov},
                               {"lyapunov_error", o.indicators.lyapunov_error},
                               {"fli", o.indicators.fli},
                               {"megno", o.indicators.megno}});
  }
  return j;
}

} // namespace kov::cli
