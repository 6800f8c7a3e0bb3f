// JSON -> JetsCertificate, in the order of jet_certificates.md 2; unknown, missing and doubled keys
// are errors.

#include "certify/jets/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

class JetsReader {
public:
  explicit JetsReader(const Node& n) : n_(n), top_(n) {}

  JetsCertificate operator()() {
    const Node format = top_.at("format");
    if (format.text() != "kovacic-jets/1") format.fail("not kovacic-jets/1");
    c_.title = top_.at("title").text();
    read_names();
    read_line(top_.at("line"));
    read_place(top_.at("place"));
    read_jets(top_.at("jets"));
    read_obstruction(top_.at("obstruction"));
    read_group(top_.at("group"));
    top_.done();
    return std::move(c_);
  }

private:
  void read_names() {
    const auto parameters = read_texts(top_.at("parameters"), max_jet_parameters);
    const Node variables = top_.at("variables");
    const auto three = read_texts(variables, 3);
    if (three.size() != 3) variables.fail("three names are expected");
    const auto constants = top_.at("constants").items();
    if (constants.size() > max_tower) n_.fail("the tower is too high");
    std::vector<std::string> names, constant_names;
    for (const Node& x : constants)
      constant_names.push_back(Keys(x).at("name").text());
    names.assign(constant_names.rbegin(), constant_names.rend());
    names.push_back(three[0]);
    names.insert(names.end(), parameters.begin(), parameters.end());
    names.insert(names.end(), three.begin() + 1, three.end());
    c_.field.ring = ring_of(n_, names);
    for (const Node& x : top_.at("denominators").items())
      c_.field.denominators.push_back(read_poly(c_.field.ring, x));
    if (c_.field.denominators.size() > max_denominators) n_.fail("more than 200 denominators");
    read_constants(constants);
    read_system(top_.at("system"), parameters, constant_names);
  }
  void read_constants(const std::vector<Node>& constants) {
    unsigned long degree = 1;
    for (const Node& x : constants) {
      Keys k(x);
      static_cast<void>(k.at("name"));
      const long d = count(k.at("degree"), 2, static_cast<long>(max_curve_degree));
      degree *= static_cast<unsigned long>(d);
      if (degree > max_curve_degree) n_.fail("the degree of the tower is above 64");
      c_.field.tower.push_back(
          {static_cast<unsigned long>(d), element(k.at("value")), element_of("0")});
      k.done();
    }
  }
  void read_system(const Node& n, const std::vector<std::string>& parameters,
                   const std::vector<std::string>& constants) {
    Keys k(n);
    auto names = read_texts(k.at("coordinates"), max_coordinates / 2);
    const auto momenta = read_texts(k.at("momenta"), max_coordinates / 2);
    if (names.size() < 2 || momenta.size() != names.size())
      n.fail("two coordinates or more, and as many momenta, are expected");
    c_.others = names.size() - 2;
    for (const auto* more : {&momenta, &parameters, &constants})
      names.insert(names.end(), more->begin(), more->end());
    c_.phase = ring_of(n, names);
    c_.hamiltonian = read_phase_function(c_.phase, k.at("hamiltonian"));
    k.done();
  }

  void read_line(const Node& n) {
    Keys k(n);
    c_.line = {pair(k.at("start")), pair(k.at("across")), pair(k.at("along")), pair(k.at("masses")),
               pair(k.at("inertias"))};
    k.done();
  }
  void read_place(const Node& n) {
    Keys k(n);
    c_.turns = count(k.at("turns"), 1, max_turns);
    c_.time_scale = element(k.at("time_scale"));
    c_.solution = series(k.at("solution"));
    const auto both = k.at("normal").items();
    if (both.size() != 2) n.fail("two solutions of the normal equation are expected");
    c_.normal = {series(both[0]), series(both[1])};
    k.done();
  }
  void read_jets(const Node& n) {
    Keys k(n);
    c_.order = count(k.at("order"), 2, max_order);
    c_.across = many(k.at("across"));
    c_.along = many(k.at("along"));
    c_.form = element(k.at("form"));
    k.done();
  }
  void read_obstruction(const Node& n) {
    Keys k(n);
    for (const Node& x : k.at("columns").items())
      c_.obstruction.columns.push_back(count(x, 0, max_order + 1));
    c_.obstruction.cofactor = element(k.at("cofactor"));
    c_.obstruction.value = element(k.at("value"));
    c_.obstruction.power = count(k.at("power"), 1, max_jet_power);
    k.done();
  }
  void read_group(const Node& n) {
    Keys k(n);
    const Node by = k.at("by");
    if (by.text() == "first-family")
      c_.group = ByFirstFamily{};
    else if (by.text() == "homogeneous")
      c_.group = ByHomogeneity{};
    else if (by.text() == "equilibria")
      c_.group = ByEquilibria{cofactor(k.at("first")), cofactor(k.at("second"))};
    else if (by.text() == "group")
      c_.group = ByGroup{k.at("e").rational(), cofactor(k.at("first")), cofactor(k.at("second")),
                         read_certificate(k.at("certificate"))};
    else
      by.fail("unknown");
    k.done();
  }

  [[nodiscard]] static long count(const Node& n, long least, long most) {
    const long x = n.count();
    if (x < least || x > most) n.fail("out of range");
    return x;
  }
  [[nodiscard]] CurveFunction element(const Node& n) const {
    return read_curve_function(c_.field, n);
  }
  [[nodiscard]] CurveFunction element_of(const char* text) const {
    return {read_polynomial(c_.field.ring, text), Integer(1), {}};
  }
  [[nodiscard]] CurveRow row(const Node& n) const {
    CurveRow all;
    for (const Node& x : n.items())
      all.push_back(element(x));
    if (all.size() > static_cast<std::size_t>(max_jet_terms)) n.fail("too many entries");
    return all;
  }
  [[nodiscard]] CurveRow cofactor(const Node& n) const {
    CurveRow all = row(n);
    if (all.size() > max_jet_cofactor) n.fail("too many entries");
    return all;
  }
  [[nodiscard]] std::array<CurveFunction, 2> pair(const Node& n) const {
    CurveRow both = row(n);
    if (both.size() != 2) n.fail("two entries are expected");
    return {std::move(both[0]), std::move(both[1])};
  }
  [[nodiscard]] JetSeries series(const Node& n) const {
    if (n.is_null()) return std::nullopt;
    Keys k(n);
    SeriesData x{count(k.at("low"), -max_jet_terms, max_jet_terms), row(k.at("terms"))};
    k.done();
    return x;
  }
  [[nodiscard]] std::vector<JetSeries> many(const Node& n) const {
    std::vector<JetSeries> all;
    for (const Node& x : n.items())
      all.push_back(series(x));
    if (all.size() + 2 != static_cast<std::size_t>(c_.order)) n.fail("one for each lower order");
    return all;
  }

  const Node& n_;
  Keys top_;
  JetsCertificate c_;
};

} // namespace

JetsCertificate read_jets_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text);
  const Node node(json, "certificate", rationals());
  return JetsReader(node)();
}

} // namespace kov::certify
