// SystemCertificate -> JSON, keys in the order of docs/theory/system_certificates.md; what reader.cpp
// reads.

#include "certify/system/certificate.hpp"
#include "proof/text/json_node.hpp"

namespace kov::certify {

namespace {

Json text(std::string s) { return {std::move(s)}; }
Json text(const MPoly& p) { return text(to_string(p)); }

template <class T, class F> Json listed(const std::vector<T>& all, F entry) {
  Json::Array list;
  for (const T& x : all)
    list.push_back(entry(x));
  return {std::move(list)};
}

} // namespace

Json to_json(const PhaseFunction& f) {
  if (f.n == Integer(1)) return text(f.p);
  return {Json::Array{text(f.p), text(to_string(f.n))}};
}
namespace {

Json function(const PhaseFunction& f) { return to_json(f); }
Json functions(const std::vector<PhaseFunction>& all) { return listed(all, function); }
Json polys(const std::vector<MPoly>& all) {
  return listed(all, [](const MPoly& p) { return text(p); });
}

} // namespace

Json to_json(const CurveFunction& f) {
  std::size_t last = f.over.size();
  while (last > 0 && f.over[last - 1] == 0)
    --last;
  if (last == 0 && f.n == Integer(1)) return text(f.p);
  Json::Array parts{text(f.p), text(to_string(f.n))};
  for (std::size_t k = 0; k < last; ++k)
    parts.push_back(text(std::to_string(f.over[k])));
  return {std::move(parts)};
}
namespace {

Json element(const CurveFunction& f) { return to_json(f); }
Json elements(const CurveRow& row) { return listed(row, element); }

class SystemWriter {
public:
  explicit SystemWriter(const SystemCertificate& c) : c_(c), s_(c.way.system) {}

  Json operator()() const {
    Json::Object whole{{"format", text("kovacic-system/1")},
                       {"title", text(c_.way.title)},
                       {"parameters", names(s_.first_parameter(), s_.ring->size())},
                       {"system", system()}};
    if (!c_.way.claims.empty())
      whole.emplace_back("claims", listed(c_.way.claims, [](const auto& c) { return claim(c); }));
    whole.emplace_back("curve", curve());
    whole.emplace_back("normal", normal());
    whole.emplace_back("equation", equation());
    whole.emplace_back("claim", Json{Json::Object{{"not_integrable", Json{c_.not_integrable}}}});
    return {std::move(whole)};
  }
  [[nodiscard]] Json of_the_system() const { return system(); }

private:
  [[nodiscard]] Json name(std::size_t i) const { return text(s_.ring->name(i)); }
  [[nodiscard]] Json names(std::size_t begin, std::size_t end) const {
    Json::Array list;
    for (std::size_t i = begin; i < end; ++i)
      list.push_back(name(i));
    return {std::move(list)};
  }

  [[nodiscard]] Json system() const {
    Json::Object x{{"coordinates", names(0, s_.dimension)}};
    if (!s_.functions.empty()) x.emplace_back("functions", symbols());
    if (!s_.inverses.empty()) x.emplace_back("inverses", inverses());
    if (!s_.relations.empty()) x.emplace_back("relations", polys(s_.relations));
    if (!s_.hamiltonian) {
      x.emplace_back("field", functions(s_.field));
      return {std::move(x)};
    }
    x.emplace_back("hamiltonian", function(*s_.hamiltonian));
    x.emplace_back("brackets", listed(s_.brackets, [&](const PhaseBracket& b) {
                     return Json{Json::Array{name(b.first), name(b.second), function(b.value)}};
                   }));
    return {std::move(x)};
  }
  [[nodiscard]] Json symbols() const {
    Json::Array list;
    for (std::size_t i = 0; i < s_.functions.size(); ++i) {
      Json::Object gradient;
      for (const auto& [j, g] : s_.functions[i].gradient)
        gradient.emplace_back(s_.ring->name(j), function(g));
      list.push_back(Json{Json::Object{{"name", name(s_.dimension + i)},
                                       {"meaning", text(s_.functions[i].meaning)},
                                       {"gradient", Json{std::move(gradient)}}}});
    }
    return {std::move(list)};
  }
  [[nodiscard]] Json inverses() const {
    Json::Array list;
    for (std::size_t i = 0; i < s_.inverses.size(); ++i)
      list.push_back(
          Json{Json::Object{{"name", name(s_.first_inverse() + i)}, {"of", text(s_.inverses[i])}}});
    return {std::move(list)};
  }
  static Json claim(const ClaimedFunction& c) {
    Json::Object x{{"kind", text(c.casimir ? "casimir" : "integral")},
                   {"name", text(c.name)},
                   {"value", function(c.value)}};
    if (!c.cofactors.empty()) x.emplace_back("cofactors", listed(c.cofactors, functions));
    return {std::move(x)};
  }

  [[nodiscard]] Json curve() const {
    const PhaseCurve& c = c_.way.curve;
    Json::Array tower;
    for (std::size_t i = 0; i < c.tower.size(); ++i)
      tower.push_back(Json{Json::Object{{"name", text(c.ring->name(c.variable(i)))},
                                        {"degree", text(std::to_string(c.tower[i].degree))},
                                        {"value", element(c.tower[i].value)},
                                        {"derivative", element(c.tower[i].derivative)}}});
    Json::Object values;
    for (const auto& [i, value] : c.values)
      values.emplace_back(s_.ring->name(i), element(value));
    return {Json::Object{{"manifold", text(c.manifold)},
                         {"equations", functions(c.equations)},
                         {"levels", functions(c.levels)},
                         {"variable", text(c.ring->name(c.z()))},
                         {"change", function(c.change)},
                         {"denominators", polys(c.denominators)},
                         {"tower", Json{std::move(tower)}},
                         {"values", Json{std::move(values)}},
                         {"time", element(c.time)}}};
  }
  [[nodiscard]] Json normal() const {
    const NormalIdentity& n = c_.way.normal;
    const auto annihilator = [](const Annihilator& l) {
      return Json{Json::Object{{"row", elements(l.row)}, {"matrix", elements(l.matrix)}}};
    };
    Json::Object x{{"annihilators", listed(n.annihilators, annihilator)}};
    if (n.is_system) {
      x.emplace_back("rows", listed(n.rows, elements));
      x.emplace_back("rest", listed(n.rests, elements));
      if (n.whole) x.emplace_back("whole", Json{true});
    } else {
      x.emplace_back("row", elements(n.rows.front()));
      x.emplace_back("p", element(n.p));
      x.emplace_back("q", element(n.q));
      x.emplace_back("rest", elements(n.rests.front()));
    }
    x.emplace_back("vectors", listed(n.vectors, elements));
    return {std::move(x)};
  }
  [[nodiscard]] Json equation() const {
    Json inner = std::visit([](const auto& x) { return to_json(x); }, c_.equation);
    Json::Object x{{"certificate", std::move(inner)}};
    if (c_.root) x.emplace_back("root", element(*c_.root));
    return {std::move(x)};
  }
  static Json to_json(const Certificate& c) { return certify::to_json(c); }
  static Json to_json(const StrataCertificate& c) {
    return parse_json(write_strata_certificate(c), 1000);
  }
  static Json to_json(const LoopsCertificate& c) { return parse_json(write_loops_certificate(c)); }

  const SystemCertificate& c_;
  const PhaseSystem& s_;
};

} // namespace

Json to_json(const PhaseSystem& s) {
  SystemCertificate c;
  c.way.system = s;
  return SystemWriter(c).of_the_system();
}

std::string write_system_certificate(const SystemCertificate& c) {
  return to_string(SystemWriter(c)());
}

} // namespace kov::certify
