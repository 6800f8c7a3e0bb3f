// JSON -> SystemCertificate, in the order of system_certificates.md 2; unknown, missing and doubled
// keys are errors.

#include "certify/system/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/json_node.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr int max_json_depth = 4 * max_node_depth + 8;

} // namespace

Ring ring_of(const Node& n, const std::vector<std::string>& names) {
  for (const std::string& s : names)
    if (!is_name(s) || std::ranges::count(names, s) != 1)
      n.fail("different names of letters, digits and _ are expected");
  return make_ring(names);
}

std::vector<std::string> read_texts(const Node& n, std::size_t most) {
  std::vector<std::string> all;
  for (const Node& x : n.items())
    all.push_back(x.text());
  if (all.size() > most) n.fail("more than " + std::to_string(most) + " entries");
  return all;
}

namespace {

Integer natural(const Node& n) {
  if (!is_natural(n.text())) n.fail("a natural number is expected");
  return n.integer();
}

PhaseFunction phase_function(const Ring& ring, const Node& n) {
  if (n.json().text()) return {read_poly(ring, n), Integer(1)};
  const auto parts = n.items();
  if (parts.size() != 2) n.fail("a polynomial, or one and a number, is expected");
  return {read_poly(ring, parts[0]), natural(parts[1])};
}

std::vector<PhaseFunction> phase_functions(const Ring& ring, const Node& n) {
  std::vector<PhaseFunction> all;
  for (const Node& x : n.items())
    all.push_back(phase_function(ring, x));
  return all;
}

// The members of an object whose keys are names.
std::vector<std::pair<std::string, Node>> members(const Node& n) {
  const auto* o = n.json().object();
  if (!o) n.fail("an object is expected");
  std::vector<std::pair<std::string, Node>> all;
  for (const auto& [key, value] : *o)
    all.emplace_back(key, Node(value, n.path() + "." + key, n.field()));
  return all;
}

// The members of system_certificates.md 2 that belong to `system`.
class PhaseReader {
public:
  PhaseReader(const Node& n, const std::vector<std::string>& parameters) { read(n, parameters); }
  PhaseSystem take() { return std::move(s_); }

private:
  void read(const Node& n, const std::vector<std::string>& parameters) {
    Keys k(n);
    auto names = read_texts(k.at("coordinates"), max_coordinates);
    s_.dimension = names.size();
    const auto functions = k.find("functions");
    const auto inverses = k.find("inverses");
    for (const auto* list : {&functions, &inverses})
      if (*list)
        for (const Node& x : (*list)->items())
          names.push_back(Keys(x).at("name").text());
    names.insert(names.end(), parameters.begin(), parameters.end());
    if (names.size() > max_phase_names) n.fail("more than 64 names");
    s_.ring = ring_of(n, names);
    if (functions)
      for (const Node& x : functions->items())
        s_.functions.push_back(symbol(x));
    if (inverses)
      for (const Node& x : inverses->items())
        s_.inverses.push_back(inverse(x));
    if (const auto relations = k.find("relations"))
      for (const Node& x : relations->items())
        s_.relations.push_back(read_poly(s_.ring, x));
    read_field(k);
    k.done();
  }

  PhaseSymbol symbol(const Node& n) {
    Keys k(n);
    static_cast<void>(k.at("name"));
    PhaseSymbol f{k.at("meaning").text(), {}};
    for (const auto& [name, value] : members(k.at("gradient")))
      f.gradient.emplace_back(coordinate(value, name), function(value));
    k.done();
    return f;
  }
  MPoly inverse(const Node& n) {
    Keys k(n);
    static_cast<void>(k.at("name"));
    MPoly h = read_poly(s_.ring, k.at("of"));
    k.done();
    return h;
  }
  void read_field(Keys& k) {
    if (const auto field = k.find("field")) {
      s_.field = phase_functions(s_.ring, *field);
      if (s_.field.size() != s_.dimension) field->fail("one entry for each coordinate is expected");
      return;
    }
    s_.hamiltonian = function(k.at("hamiltonian"));
    for (const Node& n : k.at("brackets").items()) {
      const auto parts = n.items();
      if (parts.size() != 3) n.fail("two coordinates and their bracket are expected");
      PhaseBracket b{coordinate(parts[0], parts[0].text()), coordinate(parts[1], parts[1].text()),
                     function(parts[2])};
      for (const PhaseBracket& x : s_.brackets)
        if (std::minmax(x.first, x.second) == std::minmax(b.first, b.second))
          n.fail("the pair occurs twice");
      if (b.first == b.second) n.fail("two different coordinates are expected");
      s_.brackets.push_back(std::move(b));
    }
  }

  [[nodiscard]] std::size_t coordinate(const Node& n, const std::string& name) const {
    const auto i = s_.ring->find(name);
    if (!i || *i >= s_.dimension) n.fail("a coordinate is expected");
    return *i;
  }
  [[nodiscard]] PhaseFunction function(const Node& n) const { return phase_function(s_.ring, n); }

  PhaseSystem s_;
};

class SystemReader {
public:
  explicit SystemReader(const Node& n) : top_(n) {}

  SystemCertificate operator()() {
    const Node format = top_.at("format");
    if (format.text() != "kovacic-system/1") format.fail("not kovacic-system/1");
    c_.way.title = top_.at("title").text();
    parameters_ = read_texts(top_.at("parameters"), max_parameters);
    c_.way.system = PhaseReader(top_.at("system"), parameters_).take();
    if (const auto claims = top_.find("claims"))
      for (const Node& n : claims->items())
        c_.way.claims.push_back(claim(n));
    read_curve(top_.at("curve"));
    read_normal(top_.at("normal"));
    read_equation(top_.at("equation"));
    Keys claim(top_.at("claim"));
    const Node said = claim.at("not_integrable");
    if (!said.json().truth()) said.fail("true or false is expected");
    c_.not_integrable = *said.json().truth();
    claim.done();
    top_.done();
    return std::move(c_);
  }

private:
  [[nodiscard]] PhaseFunction function(const Node& n) const {
    return phase_function(c_.way.system.ring, n);
  }

  [[nodiscard]] ClaimedFunction claim(const Node& n) const {
    Keys k(n);
    const Node kind = k.at("kind");
    if (kind.text() != "integral" && kind.text() != "casimir")
      kind.fail("integral or casimir is expected");
    ClaimedFunction c{kind.text() == "casimir", k.at("name").text(), function(k.at("value")), {}};
    if (const auto all = k.find("cofactors"))
      for (const Node& x : all->items())
        c.cofactors.push_back(phase_functions(c_.way.system.ring, x));
    k.done();
    return c;
  }

  // ---- the curve

  void read_curve(const Node& n) {
    Keys k(n);
    PhaseCurve& c = c_.way.curve;
    const Ring& phase = c_.way.system.ring;
    c.manifold = k.at("manifold").text();
    c.equations = phase_functions(phase, k.at("equations"));
    c.levels = phase_functions(phase, k.at("levels"));
    c.change = function(k.at("change"));
    const auto steps = k.at("tower").items();
    if (steps.size() > max_tower) n.fail("the tower is too high");
    std::vector<std::string> names;
    for (const Node& x : steps)
      names.insert(names.begin(), Keys(x).at("name").text());
    names.push_back(k.at("variable").text());
    names.insert(names.end(), parameters_.begin(), parameters_.end());
    c.ring = ring_of(n, names);
    for (const Node& x : k.at("denominators").items())
      c.denominators.push_back(read_poly(c.ring, x));
    if (c.denominators.size() > max_denominators) n.fail("more than 200 denominators");
    read_tower(steps, n);
    for (const auto& [name, value] : members(k.at("values"))) {
      const auto i = phase->find(name);
      if (!i || *i >= c_.way.system.first_parameter()) value.fail("the value of no name");
      c.values.emplace_back(*i, element(value));
    }
    c.time = element(k.at("time"));
    k.done();
  }
  void read_tower(const std::vector<Node>& steps, const Node& n) {
    unsigned long degree = 1;
    for (const Node& x : steps) {
      Keys k(x);
      static_cast<void>(k.at("name"));
      const long d = k.at("degree").count();
      if (d < 2 || static_cast<unsigned long>(d) > max_curve_degree)
        x.fail("a degree from 2 to 64");
      degree *= static_cast<unsigned long>(d);
      if (degree > max_curve_degree) n.fail("the degree of the tower is above 64");
      c_.way.curve.tower.push_back(
          {static_cast<unsigned long>(d), element(k.at("value")), element(k.at("derivative"))});
      k.done();
    }
  }

  [[nodiscard]] CurveFunction element(const Node& n) const {
    return read_curve_function(c_.way.curve, n);
  }
  [[nodiscard]] CurveRow elements(const Node& n) const {
    CurveRow all;
    for (const Node& x : n.items())
      all.push_back(element(x));
    return all;
  }

  [[nodiscard]] std::vector<CurveRow> rows_of(const Node& n) const {
    std::vector<CurveRow> all;
    for (const Node& x : n.items())
      all.push_back(elements(x));
    return all;
  }
  void read_normal(const Node& n) {
    Keys k(n);
    NormalIdentity& x = c_.way.normal;
    const Node annihilators = k.at("annihilators");
    for (const Node& l : annihilators.items()) {
      Keys a(l);
      x.annihilators.push_back({elements(a.at("row")), elements(a.at("matrix"))});
      a.done();
    }
    if (x.annihilators.size() > max_annihilators) annihilators.fail("more than 40 annihilators");
    if (const auto rows = k.find("rows")) {
      x.is_system = true;
      x.rows = rows_of(*rows);
      x.rests = rows_of(k.at("rest"));
      if (const auto whole = k.find("whole")) {
        const bool* truth = whole->json().truth();
        if (!truth || !*truth) whole->fail("true is expected");
        x.whole = true;
      }
    } else {
      x.rows = {elements(k.at("row"))};
      x.p = element(k.at("p"));
      x.q = element(k.at("q"));
      x.rests = {elements(k.at("rest"))};
    }
    const Node vectors = k.at("vectors");
    x.vectors = rows_of(vectors);
    if (x.vectors.size() != (x.is_system ? x.rows.size() : 2) || x.rests.size() != x.rows.size())
      vectors.fail("as many vectors as rows are expected");
    k.done();
  }

  void read_equation(const Node& n) {
    Keys k(n);
    const Node inner = k.at("certificate");
    if (format_of(inner) == "kovacic-strata/1")
      c_.equation = read_strata_certificate(to_string(inner.json()));
    else if (format_of(inner) == "kovacic-loops/1")
      c_.equation = read_loops_certificate(to_string(inner.json()));
    else
      c_.equation = read_certificate(inner);
    if (const auto root = k.find("root")) c_.root = element(*root);
    k.done();
  }
  static std::string format_of(const Node& n) {
    const auto all = members(n);
    const auto f = std::ranges::find_if(all, [](const auto& x) { return x.first == "format"; });
    return f != all.end() && f->second.json().text() ? f->second.text() : "";
  }

  Keys top_;
  std::vector<std::string> parameters_;
  SystemCertificate c_;
};

} // namespace

CurveFunction read_curve_function(const PhaseCurve& c, const Node& n) {
  if (n.json().text()) return {read_poly(c.ring, n), Integer(1), {}};
  const auto parts = n.items();
  if (parts.size() < 2 || parts.size() > 2 + c.denominators.size())
    n.fail("a polynomial, a number and an exponent for each denominator are expected");
  CurveFunction f{read_poly(c.ring, parts[0]), natural(parts[1]), {}};
  for (std::size_t i = 2; i < parts.size(); ++i) {
    const long e = parts[i].count();
    if (e < 0 || static_cast<unsigned long>(e) > max_power)
      parts[i].fail("an exponent from 0 to 1000 is expected");
    f.over.push_back(static_cast<unsigned long>(e));
  }
  return f;
}

PhaseSystem read_phase_system(const Node& n, const std::vector<std::string>& parameters) {
  return PhaseReader(n, parameters).take();
}

PhaseFunction read_phase_function(const Ring& ring, const Node& n) {
  return phase_function(ring, n);
}

SystemCertificate read_system_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text, max_json_depth);
  return SystemReader(Node(json, "certificate", rationals()))();
}

} // namespace kov::certify
