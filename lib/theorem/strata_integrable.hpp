#pragma once
// Parts that are integrable by what was found.

#include "exact/lists.hpp"
#include "system/in_ring.hpp"
#include "theorem/strata_minor.hpp"

namespace kov {

class IntegrableParts {
public:
  explicit IntegrableParts(StrataParts& s) : s_(s), minor_(s) {}

  /// Throws DomainError: it has too few integrals, or they cannot be written.
  void operator()(const NodeResult& n) {
    const PartPlace x = s_.place_of(n);
    certify::ClaimedIntegrals c;
    c.family = &s_.family.family();
    std::vector<Json> claims, fields;
    for (const auto& [name, value] : n.node.found.integrals) {
      const certify::PhaseFunction f =
          is_hamiltonian(value, x) ? *s_.family.phase().hamiltonian : function(value);
      c.claims.emplace_back(name, f);
      claims.push_back(
          Json{Json::Object{{"name", json_text(name)}, {"value", certify::to_json(f)}}});
    }
    for (const auto& row : n.node.found.fields) {
      std::vector<Json> entries;
      c.fields.emplace_back();
      for (const MFraction& component : row) {
        const certify::PhaseFunction f = function(component, false);
        c.fields.back().push_back(f);
        entries.push_back(certify::to_json(f));
      }
      fields.push_back(json_list(std::move(entries)));
    }
    const std::size_t d = s_.family.phase().dimension, m = c.claims.size();
    const bool bracket = s_.family.phase().hamiltonian.has_value();
    if (bracket && (m > d || 2 * m < d)) throw DomainError("too few first integrals");
    const bool needs_rank = bracket || m < d;
    Json independent = m == 0 ? Json{} : minor_(c, false, m, x);
    Json rank =
        needs_rank ? minor_(c, true, bracket ? 2 * (d - m) : 1 + c.fields.size(), x) : Json{};
    trust_minor(n, m > 0 && independent.is_null(),
                "the gradients of the integrals are independent");
    trust_minor(n, needs_rank && rank.is_null(),
                bracket ? "the rank of the bracket" : "the fields are independent");
    s_.put_step(n.node.id, "integrable",
                {{"system", json_text(s_.family.name())},
                 {"at", x.values},
                 {"region", json_conditions(x.region)},
                 {"claims", json_list(std::move(claims))},
                 {"fields", json_list(std::move(fields))},
                 {"independent", std::move(independent)},
                 {"rank", std::move(rank)}});
    s_.add_region(n.node.id, x.conditions(), false);
  }

private:
  void trust_minor(const NodeResult& n, bool on_trust, const char* what) {
    if (on_trust)
      s_.on_trust.emplace_back(
          n.node.id,
          Trusted{Trusted::Step::gap, what + std::string(" (no rule of the certificate)")});
  }
  // Its denominator may be a smaller one there.
  [[nodiscard]] bool is_hamiltonian(const MFraction& given, const PartPlace& x) const {
    const System& s = s_.family.system();
    if (!s.field.hamiltonian || is_zero(given)) return false;
    const MFraction rest = in_names_of(s, given) - *s.field.hamiltonian;
    return is_zero(rest) || is_zero(substitute(rest, s_.family.in_system(x.put)));
  }
  // A multiple by what does not depend on the variables is an integral as well.
  certify::PhaseFunction function(const MFraction& given, bool any_multiple = true) {
    const System& s = s_.family.system();
    const MFraction f = is_zero(given) ? given : in_names_of(s, given);
    if (is_zero(f)) return {MPoly(s_.family.ring()), Integer(1)};
    const auto used = used_variables(f.den());
    const auto& p = s.field.parameters;
    const bool is_parametric =
        std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, p); });
    return s_.family.written(any_multiple && is_parametric ? MFraction(f.num()) : f);
  }

  StrataParts& s_;
  ShownMinor minor_;
};

} // namespace kov
