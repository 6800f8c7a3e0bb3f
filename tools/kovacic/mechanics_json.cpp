#include "mechanics_json.hpp"

#include <algorithm>

namespace kov::cli {
namespace {

Json text_or_null(const std::optional<MFraction>& f) {
  return f ? Json(to_string(*f)) : Json(nullptr);
}

Json texts(const std::vector<MPoly>& polys) {
  Json all = Json::array();
  for (const auto& f : polys)
    all.push_back(to_string(f));
  return all;
}

std::string yes_no(Truth t) {
  return t == Truth::yes ? "yes" : t == Truth::no ? "no" : "undecided";
}

Json json_of(const GaloisGroup& g) {
  Json n = nullptr;
  if (g.n)
    n = fits_long(*g.n) && abs(Rational(*g.n)) < Rational(1L << 53) ? Json(to_long(*g.n))
                                                                    : Json(to_string(*g.n));
  return Json{{"type", to_string(g.type)}, {"n", n}};
}

} // namespace

std::string join(const std::vector<std::string>& words, const std::string& between) {
  std::string s;
  for (const auto& w : words)
    s += (s.empty() ? "" : between) + w;
  return s;
}

std::string claim_kind(Claim::Kind k) {
  switch (k) {
  case Claim::Kind::integral:
    return "integral";
  case Claim::Kind::casimir:
    return "casimir";
  case Claim::Kind::darboux:
    return "darboux";
  case Claim::Kind::poisson:
    return "poisson";
  default:
    return "equal";
  }
}

Json json_of(const LinearSystem& s) {
  Json rows = Json::array();
  for (const auto& row : s.a) {
    Json entries = Json::array();
    for (const auto& e : row)
      entries.push_back(to_string(e));
    rows.push_back(std::move(entries));
  }
  return Json{{"unknowns", s.names}, {"matrix", rows}};
}

Json json_of(const ScalarEquation& e) {
  return Json{{"unknown", e.unknown}, {"a1", to_string(e.a1)}, {"a0", to_string(e.a0)}};
}

Json json_of(const System& s, const AlgebraicOde& ode) {
  Json parameters = Json::array();
  for (const std::size_t i : used_variables(ode.r))
    if (i != ode.z) parameters.push_back(s.ring()->name(i));
  return Json{{"unknown", ode.unknown},
              {"change", ode.change},
              {"variable", s.ring()->name(ode.z)},
              {"parameters", parameters},
              {"z_dot_squared", text_or_null(ode.z_dot_squared)},
              {"z_ddot", text_or_null(ode.z_ddot)},
              {"p", text_or_null(ode.p)},
              {"q", text_or_null(ode.q)},
              {"r", to_string(ode.r)},
              {"generic", texts(ode.generic)},
              {"checks", ode.checks}};
}

Json json_of(const Decision& d) {
  Json j;
  j["group"] = d.group ? json_of(*d.group) : Json(nullptr);
  j["identity_component"] = d.component ? Json(to_string(*d.component)) : Json(nullptr);
  j["abelian"] = yes_no(d.abelian);
  j["case"] = d.kovacic_case ? Json(*d.kovacic_case) : Json(nullptr);
  j["reason"] = d.reason;
  return j;
}

Json json_of(const System& s, const BlockReport& b) {
  Json j{{"unknowns", b.unknowns}};
  if (b.ode) j["equation"] = json_of(s, *b.ode);
  if (b.decision) j["decision"] = json_of(*b.decision);
  if (!b.special.empty()) j["merging"] = texts(b.special);
  if (!b.energies.empty()) {
    Json all = Json::array();
    for (const auto& e : b.energies) {
      Json one{{"at", e.condition}, {"why", e.why}};
      if (e.r) one["r"] = to_string(*e.r, s.ring()->name(b.ode->z));
      if (e.decision) one["decision"] = json_of(*e.decision);
      if (!e.note.empty()) one["note"] = e.note;
      all.push_back(std::move(one));
    }
    j["energies"] = std::move(all);
  }
  j["abelian"] = yes_no(b.abelian);
  if (!b.note.empty()) j["note"] = b.note;
  return j;
}

Json json_of(const System& s, const ManifoldReport& m) {
  Json j{{"name", m.name}, {"verdict", to_string(m.verdict)}};
  if (m.failure) {
    j["failure"] = Json{{"message", m.failure->message},
                        {"component", m.failure->component},
                        {"value", to_string(m.failure->value)}};
    return j;
  }
  j["theorem"] = m.theorem;
  j["function_class"] = m.function_class;
  if (m.manifold) {
    Json equations = Json::array();
    for (const auto& e : m.manifold->equations)
      equations.push_back(e.text);
    Json levels = Json::array();
    for (const auto& e : m.manifold->levels)
      levels.push_back(e.text);
    j["equations"] = equations;
    j["level"] = levels;
    j["proof"] = m.manifold->proof;
  }
  Json eliminations = Json::array();
  for (const auto& e : m.reduced.eliminations)
    eliminations.push_back(Json{{"integral", e.integral}, {"unknown", e.unknown}});
  j["eliminated"] = eliminations;
  Json blocks = Json::array();
  for (const auto& b : m.blocks)
    blocks.push_back(json_of(s, b));
  j["blocks"] = blocks;
  j["reasons"] = m.reasons;
  return j;
}

Json json_of(const ClaimReport& c) {
  return Json{
      {"kind", claim_kind(c.claim.kind)},  {"name", c.claim.name},     {"claim", c.claim.text},
      {"proved", c.result.proved},         {"claimed", c.claim.holds}, {"detail", c.result.detail},
      {"generic", texts(c.result.generic)}};
}

Json json_of_field(const System& s) {
  Json field;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    field[s.field.name(j)] = to_string(s.field.components[j]);
  Json parameters = Json::array();
  for (const std::size_t i : s.field.parameters)
    parameters.push_back(s.ring()->name(i));
  Json relations = Json::array();
  for (const auto& f : s.field.relations)
    relations.push_back(to_string(f));
  Json j{{"parameters", parameters}, {"relations", relations}, {"field", field}};
  if (s.field.hamiltonian) j["hamiltonian"] = to_string(*s.field.hamiltonian);
  return j;
}

} // namespace kov::cli
