// JetsCertificate -> JSON, keys in the order of docs/theory/jet_certificates.md; what reader.cpp
// reads.

#include "certify/jets/certificate.hpp"

namespace kov::certify {

namespace {

Json text(std::string s) { return {std::move(s)}; }
Json text(long n) { return text(std::to_string(n)); }

template <class All, class F> Json listed(const All& all, F entry) {
  Json::Array list;
  for (const auto& x : all)
    list.push_back(entry(x));
  return {std::move(list)};
}
Json elements(const CurveRow& all) {
  return listed(all, [](const CurveFunction& f) { return to_json(f); });
}
Json pair(const std::array<CurveFunction, 2>& two) { return elements({two[0], two[1]}); }

Json series(const JetSeries& x) {
  if (!x) return {nullptr};
  return {Json::Object{{"low", text(x->low)}, {"terms", elements(x->terms)}}};
}

Json group(const ByFirstFamily&) { return {Json::Object{{"by", text("first-family")}}}; }
Json group(const ByHomogeneity&) { return {Json::Object{{"by", text("homogeneous")}}}; }
Json group(const ByEquilibria& x) {
  return {Json::Object{
      {"by", text("equilibria")}, {"first", elements(x.first)}, {"second", elements(x.second)}}};
}
Json group(const ByGroup& x) {
  return {Json::Object{{"by", text("group")},
                       {"e", text(to_string(x.e))},
                       {"first", elements(x.first)},
                       {"second", elements(x.second)},
                       {"certificate", to_json(x.certificate)}}};
}

class JetsWriter {
public:
  explicit JetsWriter(const JetsCertificate& c) : c_(c) {}

  [[nodiscard]] Json operator()() const {
    return {
        Json::Object{{"format", text("kovacic-jets/1")},
                     {"title", text(c_.title)},
                     {"parameters", names(*c_.field.ring, c_.e() + 1, c_.c1())},
                     {"variables", variables()},
                     {"system", system()},
                     {"denominators", listed(c_.field.denominators,
                                             [](const MPoly& d) { return text(to_string(d)); })},
                     {"constants", constants()},
                     {"line", line()},
                     {"place", place()},
                     {"jets", jets()},
                     {"obstruction", obstruction()},
                     {"group", std::visit([](const auto& x) { return group(x); }, c_.group)}}};
  }

private:
  static Json names(const Variables& ring, std::size_t begin, std::size_t end) {
    Json::Array list;
    for (std::size_t i = begin; i < end; ++i)
      list.push_back(text(ring.name(i)));
    return {std::move(list)};
  }
  [[nodiscard]] Json variables() const {
    const Variables& ring = *c_.field.ring;
    return {
        Json::Array{text(ring.name(c_.e())), text(ring.name(c_.c1())), text(ring.name(c_.c2()))}};
  }
  [[nodiscard]] Json system() const {
    return {Json::Object{{"coordinates", names(*c_.phase, 0, 2 + c_.others)},
                         {"momenta", names(*c_.phase, 2 + c_.others, 4 + 2 * c_.others)},
                         {"hamiltonian", to_json(c_.hamiltonian)}}};
  }
  [[nodiscard]] Json constants() const {
    Json::Array list;
    for (std::size_t i = 0; i < c_.field.tower.size(); ++i)
      list.push_back(Json{Json::Object{{"name", text(c_.field.ring->name(c_.field.variable(i)))},
                                       {"degree", text(std::to_string(c_.field.tower[i].degree))},
                                       {"value", to_json(c_.field.tower[i].value)}}});
    return {std::move(list)};
  }
  [[nodiscard]] Json line() const {
    const JetLine& l = c_.line;
    return {Json::Object{{"start", pair(l.start)},
                         {"across", pair(l.across)},
                         {"along", pair(l.along)},
                         {"masses", pair(l.masses)},
                         {"inertias", pair(l.inertias)}}};
  }
  [[nodiscard]] Json place() const {
    return {Json::Object{{"turns", text(c_.turns)},
                         {"time_scale", to_json(c_.time_scale)},
                         {"solution", series(c_.solution)},
                         {"normal", listed(c_.normal, series)}}};
  }
  [[nodiscard]] Json jets() const {
    return {Json::Object{{"order", text(c_.order)},
                         {"across", listed(c_.across, series)},
                         {"along", listed(c_.along, series)},
                         {"form", to_json(c_.form)}}};
  }
  [[nodiscard]] Json obstruction() const {
    return {
        Json::Object{{"columns", listed(c_.obstruction.columns, [](long n) { return text(n); })},
                     {"cofactor", to_json(c_.obstruction.cofactor)},
                     {"value", to_json(c_.obstruction.value)},
                     {"power", text(c_.obstruction.power)}}};
  }

  const JetsCertificate& c_;
};

} // namespace

std::string write_jets_certificate(const JetsCertificate& c) { return to_string(JetsWriter(c)()); }

} // namespace kov::certify
