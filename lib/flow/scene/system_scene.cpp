#include "flow/scene/system_scene.hpp"

#include "exact/error.hpp"
#include "flow/field/written.hpp"
#include "flow/scene/body_system.hpp"
#include "flow/scene/window.hpp"
#include "symbol/document.hpp"
#include "symbol/suggest.hpp"
#include "system/claims.hpp"
#include "system/read_system.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace kov::flow {
namespace {

Quantity quantity(const Entry& e) { return Quantity(e.expression()); }

std::array<Quantity, 2> pair_of(const Entry& e) {
  if (e.array().size() != 2) throw e.error("'" + e.name() + "' needs pairs of numbers");
  return {quantity(e.array()[0]), quantity(e.array()[1])};
}

long count(const Entry& e, long least, long most) {
  if (e.integer() < least || e.integer() > most)
    throw e.error("'" + e.name() + "' is " + std::to_string(least) + " to " + std::to_string(most));
  return e.integer();
}

bool is_irrational(const Expression& e) {
  if (e.kind() == Expression::Kind::call) return true;
  if (e.kind() == Expression::Kind::name) return e.name() == "pi" || e.name() == "Pi";
  return std::ranges::any_of(e.operands(), is_irrational);
}

// ---- scans ----

constexpr std::array<std::string_view, 5> scan_values{"megno", "lyapunov", "fli", "crossings",
                                                      "time"};
constexpr long most_cells = 100'000'000;

ScanAxis axis(const std::string& name, const Entry& range) {
  if (!range.is_array() || range.array().size() != 3)
    throw range.error("an axis is [from, to, how many cells]");
  ScanAxis a;
  a.name = name;
  a.from = quantity(range.array()[0]);
  a.to = quantity(range.array()[1]);
  if ((a.to - a.from).sign() <= 0)
    throw range.error("an axis goes from the smaller number to the larger");
  a.count = static_cast<std::size_t>(count(range.array()[2], 2, 1'000'000));
  return a;
}

void read_axes(const Entry& scene, SystemScene& s) {
  const Entry* scan = scene.find("scan");
  if (scan == nullptr) return;
  scan->check_keys({"of", "over"});
  s.scan.emplace();
  const std::string of = scan->at("of").string();
  const auto known = std::ranges::find(scan_values, of);
  if (known == scan_values.end())
    throw scan->at("of").error(
        "'of' is \"megno\", \"lyapunov\", \"fli\", \"crossings\" or \"time\"");
  s.scan->of = static_cast<ScanValue>(known - scan_values.begin());
  for (const auto& [name, range] : scan->at("over").members())
    s.scan->axes.push_back(axis(name, range));
  if (s.scan->axes.empty() || s.scan->axes.size() > 2)
    throw scan->at("over").error("a scan has one axis or two",
                                 "over = { y = [-1, 1, 200], v = [-1, 1, 200] }");
  double cells = 1;
  for (const ScanAxis& a : s.scan->axes)
    cells *= static_cast<double>(a.count);
  if (cells > most_cells)
    throw scan->at("over").error("a scan has up to " + std::to_string(most_cells) + " cells");
}

const ScanAxis* axis_named(const SystemScene& s, const std::string& name) {
  if (!s.scan) return nullptr;
  for (const ScanAxis& a : s.scan->axes)
    if (a.name == name) return &a;
  return nullptr;
}

void place_axis(ScanAxis& a, const Entry& scene, const SystemScene& s) {
  const VectorField& v = s.system.field;
  const auto named = [&](std::size_t i) { return v.ring->name(i) == a.name; };
  const auto value =
      std::ranges::find_if(s.values, [&](const auto& one) { return named(one.first); });
  const auto drawn = std::ranges::find_if(s.plot, [&](const auto& f) { return f.text == a.name; });
  const auto coordinate = std::ranges::find_if(v.coordinates, named);
  const Entry& at = *scene.at("scan").at("over").find(a.name);
  const Entry* set = scene.find("set");
  const bool states = scene.find("states") != nullptr;
  if (set != nullptr && set->find(a.name) != nullptr)
    throw at.key_error("'" + a.name + "' is set, and scanned");
  if (value != s.values.end()) {
    a.kind = ScanAxis::Kind::parameter;
    a.place = value->first;
  } else if (states && coordinate != v.coordinates.end()) {
    a.kind = ScanAxis::Kind::coordinate;
    a.place = static_cast<std::size_t>(coordinate - v.coordinates.begin());
  } else if (!states && drawn != s.plot.end() && !s.return_map) {
    a.kind = ScanAxis::Kind::drawn;
    a.place = static_cast<std::size_t>(drawn - s.plot.begin());
  } else {
    throw at.key_error(
        "'" + a.name + "' cannot be scanned here",
        "an axis is what 'plot' draws, a parameter without a value, or, with states = "
        "[[...]], a coordinate");
  }
}

// Finds what the names of the axes stand for.
void place_axes(const Entry& scene, SystemScene& s) {
  if (!s.scan) return;
  for (ScanAxis& a : s.scan->axes)
    place_axis(a, scene, s);
}

void check_scan(const Entry& scene, SystemScene& s) {
  const Entry& scan = scene.at("scan");
  for (const char* other :
       {"grid", "random", "vary", "errors", "indicator", "exponents", "winding"})
    if (const Entry* e = scene.find(other))
      throw e->key_error("a scan has no '" + std::string(other) + "'",
                         "'scan' says what is varied and what is computed");
  if (s.digits > 0) throw scene.at("digits").error("a scan is computed in double precision");
  const auto drawn = std::ranges::count_if(
      s.scan->axes, [](const ScanAxis& a) { return a.kind == ScanAxis::Kind::drawn; });
  if (s.states.size() + s.seeds.size() > 1)
    throw scan.error("a scan has one start that it varies: one seed, or one state");
  if (s.states.empty() && drawn < 2 && s.seeds.empty())
    throw scan.error("a scan needs a start for what it does not vary",
                     "seeds = [[0, \"1/10\"]] in the order of 'plot', or states = [[...]]");
  s.indicator = s.scan->of == ScanValue::megno      ? Indicator::megno
                : s.scan->of == ScanValue::lyapunov ? Indicator::lyapunov
                : s.scan->of == ScanValue::fli      ? Indicator::fli
                                                    : Indicator::none;
  s.errors = false;
}

// ---- what needs no formula ----

void read_texts(const Entry& scene, SystemScene& s) {
  const auto text = [&](const char* key, std::string& to) {
    if (const Entry* e = scene.find(key)) to = e->string();
  };
  s.title = s.system.title;
  text("name", s.name);
  text("title", s.title);
  text("source", s.source);
  const auto bad = [](char c) {
    return std::string_view("/\\\"'`$").find(c) != std::string_view::npos ||
           static_cast<unsigned char>(c) < ' ';
  };
  if (std::ranges::any_of(s.name, bad))
    throw scene.at("name").error(
        "the name of a scene becomes the name of files: no slashes, quotes or '$'");
  if (const Entry* name = scene.find("name");
      name != nullptr &&
      (s.name.empty() || s.name.size() > 100 || s.name[0] == '.' || s.name[0] == '-'))
    throw name->error("the name of a scene becomes the name of files: up to 100 bytes, not "
                      "beginning with '.' or '-'");
}

// whole_states: what is drawn does not say where an orbit starts.
void read_orbits(const Entry& scene, bool whole_states, SystemScene& s) {
  if (const Entry* seeds = scene.find("seeds"))
    for (const Entry& seed : seeds->array())
      s.seeds.push_back(pair_of(seed));
  if (const Entry* states = scene.find("states"))
    for (const Entry& state : states->array()) {
      if (state.array().size() != s.system.field.dimension())
        throw state.error("a state has one number for each of " +
                          std::to_string(s.system.field.dimension()) + " coordinates");
      s.states.emplace_back();
      for (const Entry& x : state.array())
        s.states.back().push_back(quantity(x));
    }
  read_limits(scene, s.columns, s.rows, s.crossings, s.time);
  if (const Entry* random = scene.find("random")) s.random = count(*random, 1, 1'000'000);
  if ((s.columns > 0 || s.random > 0) && !s.range) s.range = window_over_level(s);
  if (s.seeds.empty() && s.states.empty() && s.columns == 0 && s.random == 0 && !s.scan)
    throw scene.error("no orbits: give seeds, a grid, random or states");
  if (const Entry* n = scene.find("skip")) s.skip = count(*n, 0, 1'000'000'000);
  if (whole_states && (!s.seeds.empty() || s.columns > 0 || s.random > 0))
    throw scene.at("plot").error("a return map needs complete initial states",
                                 "states = [[x1, x2, ...]]");
}

void read_exponents(const Entry& scene, SystemScene& s) {
  const auto n = static_cast<long>(s.system.field.dimension());
  if (s.indicator == Indicator::sali) s.exponents = std::min(2L, n);
  const Entry* e = scene.find("exponents");
  if (e == nullptr) return;
  const bool word = e->kind() == Entry::Kind::string;
  if (word && e->string() != "all")
    throw e->error("'exponents' is a number or \"all\"", "exponents = \"all\"");
  s.exponents = std::max(s.exponents, word ? n : count(*e, 1, n));
}

void read_accuracy(const Entry& scene, SystemScene& s) {
  read_tolerance(scene, s.tolerance, s.drift, s.digits);
  if (const Entry* indicator = scene.find("indicator")) {
    for (const Indicator i :
         {Indicator::megno, Indicator::lyapunov, Indicator::fli, Indicator::sali})
      if (indicator->string() == to_string(i)) s.indicator = i;
    if (s.indicator == Indicator::none)
      throw indicator->error("the indicator is \"megno\", \"lyapunov\", \"fli\" or \"sali\"");
  }
  read_exponents(scene, s);
  if (const Entry* winding = scene.find("winding")) s.winding = winding->boolean();
  const Entry* errors = scene.find("errors");
  s.errors = errors == nullptr ? s.indicator != Indicator::none : errors->boolean();
}

// The system of a scene and all that is written in its names.
class SceneReader {
public:
  SceneReader(const Entry& system_document, const Entry& scene, ParameterValues varied = {})
      : e_(scene), varied_(std::move(varied)) {
    s_.file = scene.file();
    read_axes(e_, s_);
    read_values(system_document);
    read_texts(e_, s_);
    read_section();
    read_levels();
    read_plot();
    place_axes(e_, s_);
    s_.written = std::make_shared<const Graph>(written_->graph());
    read_orbits(e_, s_.return_map || !varied_.empty(), s_);
    read_accuracy(e_, s_);
    if (s_.scan) check_scan(e_, s_);
    for (const Entry* x : e_.find("expect") ? e_.at("expect").list() : std::vector<const Entry*>{})
      s_.expect.push_back(read_expectation(*x));
  }
  SystemScene scene() && { return std::move(s_); }

private:
  [[nodiscard]] SceneFormula function(const Entry& e) const {
    const Expression formula = e.expression(true);
    const bool equation = formula.kind() == Expression::Kind::equation;
    const MFraction value =
        equation ? evaluate_equation(formula, *scope_) : evaluate(formula, *scope_);
    written_->add(formula, value);
    return {value, e.string()};
  }

  // Rational values go into the algebra, the others into the integration.
  void read_values(const Entry& document) {
    ParameterValues rational = varied_;
    std::vector<const std::pair<std::string, Entry>*> others;
    if (const Entry* set = e_.find("set"))
      for (const auto& one : set->members()) {
        if (is_irrational(one.second.expression())) {
          if (quantity(one.second).is_zero()) // sqrt(2) - sqrt(2) is not a number for the machine
            rational.emplace_back(one.first, "0");
          else
            others.push_back(&one);
        } else
          rational.emplace_back(one.first, std::string(one.second.expression().text()));
      }
    try {
      scope_ = std::make_unique<SystemScope>(document, rational, &e_);
      s_.system = read_system(document, *scope_);
    } catch (const InputError& e) { // a value is known there as one of the command line
      const Entry* set = e_.find(varied_.empty() ? "set" : "vary");
      if (e.file() != "--set" || set == nullptr) throw;
      throw set->error(e.message(), e.hint());
    }
    s_.meanings = scope_->meanings;
    written_ = std::make_unique<Written>(document, *scope_, s_.system);
    const VectorField& v = s_.system.field;
    std::vector<std::size_t> open = v.parameters;
    open.insert(open.end(), v.constants.begin(), v.constants.end());
    for (const auto* one : others) {
      const auto place =
          std::ranges::find_if(open, [&](std::size_t i) { return v.ring->name(i) == one->first; });
      if (place == open.end())
        throw one->second.error("'" + one->first +
                                "' is not a parameter of this system without a value");
      s_.values.emplace(*place, quantity(one->second));
      open.erase(place);
    }
    for (const std::size_t i : open)
      if (const ScanAxis* axis = axis_named(s_, v.ring->name(i)))
        s_.values.emplace(i, (axis->from + axis->to) * Quantity("1/2"));
      else if (is_used(i))
        throw e_.error("'" + v.ring->name(i) + "' has no value",
                       "set = {" + v.ring->name(i) + " = \"...\"}");
  }

  // h, the name of a level for another part of the program, needs no value.
  [[nodiscard]] bool is_used(std::size_t i) const {
    const VectorField& v = s_.system.field;
    const auto in = [i](const auto& f) { return uses(f, i); };
    return std::ranges::any_of(v.components, in) || std::ranges::any_of(v.relations, in) ||
           (v.hamiltonian && uses(*v.hamiltonian, i)) ||
           std::ranges::any_of(v.functions,
                               [&](const auto& f) { return std::ranges::any_of(f.gradient, in); });
  }

  void read_section() {
    const Entry& section = e_.at("section");
    s_.section = function(section);
    if (is_constant(s_.section.value))
      throw section.error("the section does not depend on the coordinates");
    if (const Entry* where = e_.find("where")) s_.where = function(*where);
    read_direction(e_, s_.rising, s_.falling);
  }

  void read_levels() {
    if (const Entry* levels = e_.find("levels"))
      for (const auto& [name, value] : levels->members())
        s_.levels.push_back({{formula_named(name, value), name}, quantity(value)});
    if (const Entry* start = e_.find("start"))
      for (const Entry* one : start->list())
        s_.start.push_back(function(*one));
  }

  [[nodiscard]] MFraction formula_named(const std::string& text, const Entry& at) const {
    try {
      return evaluate(parse_expression(text, "levels"), *scope_);
    } catch (const InputError& e) {
      throw at.key_error("'" + text + "' is not a function of this system: " + e.what());
    }
  }

  void read_plot() {
    const Entry& plot = e_.at("plot");
    const std::size_t n = plot.list().size();
    if (n != 1 && n != 2)
      throw plot.error("two functions are drawn, or one against its next value",
                       "plot = [\"q2\", \"p2\"]");
    for (std::size_t i = 0; i < n; ++i)
      s_.plot[i] = function(*plot.list()[i]);
    s_.return_map = n == 1 && varied_.empty();
    if (n == 2 && !varied_.empty())
      throw plot.error("a diagram over a parameter draws one function");
    if (n == 1) s_.plot[1] = {s_.plot[0].value, "next " + s_.plot[0].text};
    if (const Entry* angles = e_.find("angles"))
      for (const Entry* angle : angles->list()) {
        const auto place =
            std::ranges::find_if(s_.plot, [&](const auto& f) { return f.text == angle->string(); });
        if (place == s_.plot.end())
          throw angle->error("this angle is not drawn", "it must be written as in 'plot'");
        s_.angle[static_cast<std::size_t>(place - s_.plot.begin())] = true;
      }
    if (const Entry* range = e_.find("range")) {
      if (range->array().size() != 2) throw range->error("a range is [[a, b], [c, d]]");
      s_.range = {pair_of(range->array()[0]), pair_of(range->array()[1])};
      for (const auto& [low, high] : *s_.range)
        if ((high - low).sign() <= 0)
          throw range->error("a range goes from the smaller number to the larger");
    }
  }

  const Entry& e_;
  ParameterValues varied_;
  SystemScene s_;
  std::unique_ptr<SystemScope> scope_; ///< what the names of the system mean
  std::unique_ptr<Written> written_;
};

// The value texts of vary = {r = [a, b, n]}.
std::vector<std::string> values_of(const Entry& range) {
  if (range.array().size() != 3)
    throw range.error("a parameter varies in [from, to, how many values]");
  const long n = count(range.array()[2], 2, 2000);
  const auto end = [&](std::size_t i) {
    const Entry& e = range.array()[i];
    if (is_irrational(e.expression())) throw e.error("a parameter varies between fractions");
    return "(" + std::string(e.expression().text()) + ")";
  };
  std::vector<std::string> all;
  for (long i = 0; i < n; ++i)
    all.push_back(end(0) + " + (" + end(1) + " - " + end(0) + ")*" + std::to_string(i) + "/" +
                  std::to_string(n - 1));
  return all;
}

SystemScene read_scene(const Entry& document, const Entry& scene) {
  const Entry* vary = scene.find("vary");
  if (vary == nullptr) return SceneReader(document, scene).scene();
  if (vary->members().size() != 1) throw vary->error("one parameter varies");
  const auto& [name, range] = vary->members().front();
  if (const Entry* set = scene.find("set"); set != nullptr && set->find(name) != nullptr)
    throw range.error("'" + name + "' is set, and varies");
  std::vector<SystemScene> family;
  for (const std::string& value : values_of(range)) {
    family.push_back(SceneReader(document, scene, {{name, value}}).scene());
    family.back().value = Quantity(value.c_str());
  }
  SystemScene whole = family.front();
  whole.varied = name;
  whole.plot = {SceneFormula{whole.plot[0].value, name}, whole.plot[0]};
  whole.angle = {false, whole.angle[0]};
  whole.family = std::move(family);
  return whole;
}

} // namespace

std::string to_string(Indicator i) {
  constexpr std::array all{"", "megno", "lyapunov", "fli", "sali"};
  return all.at(static_cast<std::size_t>(i));
}

std::vector<SceneFormula> SystemScene::integrals() const {
  std::vector<SceneFormula> all;
  const VectorField& v = system.field;
  const auto add = [&](const MFraction& f, const std::string& text) {
    const auto same = [&](const SceneFormula& other) { return other.value == f; };
    if (!is_constant(f) && std::ranges::none_of(all, same)) all.push_back({f, text});
  };
  if (v.hamiltonian) add(*v.hamiltonian, "H");
  for (const SystemClaim& c : system.claims)
    if ((c.kind == SystemClaim::Kind::integral || c.kind == SystemClaim::Kind::casimir) &&
        c.holds && c.on.empty() && decide_claim(system, c).proved)
      add(c.value, c.name);
  for (const Level& level :
       levels) { // a level of a function that is not an integral is for the start only
    SystemClaim c;
    c.value = level.function.value;
    if (decide_claim(system, c).proved) add(c.value, level.function.text);
  }
  for (const MPoly& r : v.relations)
    add(MFraction(r), kov::to_string(r));
  return all;
}

bool has_system_scenes(const Entry& document) {
  return document.find("scene") != nullptr || has_format(document, "scene");
}

std::vector<SystemScene> read_system_scenes(const Entry& document) {
  const auto check = [](const Entry& e) {
    e.check_keys({"name",      "title",     "source",    "set",    "section", "direction", "where",
                  "levels",    "start",     "plot",      "angles", "range",   "seeds",     "states",
                  "grid",      "random",    "crossings", "skip",   "time",    "drift",     "digits",
                  "tolerance", "expect",    "indicator", "format", "system",  "vary",      "errors",
                  "scan",      "exponents", "winding"});
  };
  std::vector<SystemScene> scenes;
  if (document.find("body") != nullptr) return {system_of(read_scene(document))};
  if (const Entry* all = document.find("scene")) {
    for (const Entry* one : all->list()) {
      check(*one);
      for (const char* other : {"format", "system"})
        if (const Entry* e = one->find(other))
          throw e->key_error("only a scene in a file of its own has this key");
      scenes.push_back(read_scene(document, *one));
    }
  } else {
    check(document);
    const std::filesystem::path beside(document.file());
    const Entry system =
        read_document((beside.parent_path() / document.at("system").string()).string());
    if (!is_system_document(system)) throw document.at("system").error("this file holds no system");
    scenes.push_back(read_scene(system, document));
  }
  if (scenes.empty()) throw document.at("scene").error("there is no scene in this list");
  std::set<std::string> names;
  for (const SystemScene& s : scenes)
    if (s.name.empty() && scenes.size() > 1)
      throw document.at("scene").error("several scenes of a file need names", "name = \"...\"");
    else if (!names.insert(s.name).second)
      throw document.at("scene").error("two scenes have the name '" + s.name +
                                       "', which becomes the name of files");
  return scenes;
}

} // namespace kov::flow
