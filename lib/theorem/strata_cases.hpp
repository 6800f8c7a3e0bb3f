#pragma once
// Parts that certificates of their own exclude: by one as a whole, or leaf by leaf.

#include "certify/equation/facts.hpp"
#include "moves/scalings.hpp"
#include "theorem/strata_levels.hpp"

namespace kov {

class CaseParts {
public:
  explicit CaseParts(StrataParts& s) : s_(s), asked_(s) {}

  /// Throws DomainError: there is no certificate that excludes it.
  void operator()(const NodeResult& n, const PartPlace& whole) {
    std::vector<CasePart> parts;
    std::string why = "none was written";
    for (std::size_t k = 0; k < n.certificates.size(); ++k)
      try {
        add_parts(k, said_by(n.certificates[k]), whole, parts, why);
      } catch (const Error& no) {
        why = no.what();
      }
    const auto all = std::ranges::find_if(parts, [&](const CasePart& p) {
      return p.where.conditions().size() == whole.conditions().size();
    });
    parts = all != parts.end() ? std::vector{*all} : covering(whole, parts);
    if (parts.empty()) throw DomainError(why);
    put_parts(n, parts);
  }

private:
  using Exponents = std::vector<unsigned long>;

  /// Some points of a node, and what excludes them.
  struct CasePart {
    std::size_t certificate = 0;
    std::optional<std::size_t> leaf;
    PartPlace x;
    std::vector<Json> shown;
    PartPlace where;         ///< x, or in all units
    Json::Object scale = {}; ///< members of the step to these
  };
  void put_parts(const NodeResult& n, const std::vector<CasePart>& parts) {
    const auto once = [&](const std::string& id, const char* rule, Json::Object members) {
      if (put_.insert(id).second) s_.put_step(id, rule, std::move(members));
    };
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto& [certificate, leaf, x, shown, where, scale] = parts[k];
      const std::string number = certificate == 0 ? "" : "-" + std::to_string(certificate + 1);
      const std::string& text = n.certificates[certificate];
      std::string of =
          certificates_.try_emplace(text, certificate_step(n.node.id) + number).first->second;
      once(of, "certificate", {{"certificate", certify::parse_json(text, 512)}});
      if (leaf) {
        const std::string one = of + "-leaf-" + std::to_string(*leaf);
        once(one, "leaf", {{"of", json_text(of)}, {"leaf", json_text(std::to_string(*leaf))}});
        of = one;
      }
      const std::string id = n.node.id + (k == 0 ? "" : "-" + std::to_string(k + 1));
      Json::Object members{{"of", json_text(of)},
                           {"system", json_text(s_.family.name())},
                           {"at", x.values},
                           {"region", json_conditions(x.region)},
                           {"shown", json_list(shown)}};
      if (!x.levels.empty()) members.emplace_back("levels", asked_.level_rows(x));
      once(scale.empty() ? id : id + "-at", "place", std::move(members));
      if (!scale.empty()) {
        Json::Object all{{"of", json_text(id + "-at")}, {"system", json_text(s_.family.name())}};
        all.insert(all.end(), scale.begin(), scale.end());
        once(id, "scale", std::move(all));
      }
      s_.add_region(id, where.conditions());
    }
  }
  // The parts that are needed to cover a node; none: they do not.
  [[nodiscard]] std::vector<CasePart> covering(const PartPlace& whole,
                                               const std::vector<CasePart>& parts) const {
    std::vector<CasePart> needed;
    std::vector<RegionOfPart> regions;
    const auto is_covered = [&](const PartPlace& x) {
      const auto there = s_.family.known_where(x.conditions());
      return tree_of_regions(s_.proof, there, regions, s_.budget).has_value();
    };
    for (const CasePart& p : parts) {
      if (is_covered(p.where)) continue;
      regions.push_back({needed.size(), std::nullopt, p.where.conditions()});
      needed.push_back(p);
      if (is_covered(whole)) return needed;
    }
    return {};
  }
  void add_parts(std::size_t certificate, const certify::Said& said, const PartPlace& whole,
                 std::vector<CasePart>& parts, std::string& why) const {
    const auto add = [&](std::optional<std::size_t> leaf, const certify::Target& y,
                         const PartPlace& x) {
      try {
        PartPlace at_levels = x;
        at_levels.levels = asked_.levels_of(y);
        for (const PartPlace& there : asked_.where_asked(y, at_levels))
          parts.push_back(
              in_all_units({certificate, leaf, there, asked_.shown_of(y, there), there}, whole));
      } catch (const certify::Refused& no) {
        why = no.why;
      } catch (const Error& no) {
        why = no.what();
      }
    };
    const PartPlace x = where_it_is(*said.system, whole);
    if (said.kind == certify::FactKind::not_integrable) return add(std::nullopt, *said.target, x);
    for (std::size_t k = 0; k < said.leaves.size(); ++k)
      if (said.leaves[k].trusted == 0) add(k, certify::target_of(said, said.leaves[k]), x);
  }
  // A part at a value of one parameter more than the whole: p != 0 in its place, if the system has units.
  [[nodiscard]] CasePart in_all_units(CasePart part, const PartPlace& whole) const {
    const BundleFamily& family = s_.family;
    const auto is_new = [&](const auto& value) {
      return !whole.put.contains(value.first) && is_constant(value.second) &&
             !is_zero(value.second);
    };
    const auto p = std::ranges::find_if(part.x.put, is_new);
    if (p == part.x.put.end() || part.x.put.size() != whole.put.size() + 1) return part;
    const std::string name = family.ring()->name(p->first);
    auto others = part.x.conditions();
    std::erase_if(others, [&](const Condition& c) {
      return c.sign == Sign::zero && used_variables(c.p) == std::vector{p->first};
    });
    const auto weights = units(family.system().ring()->index(name), others);
    if (weights.empty()) return part;
    std::vector<Json> rows;
    for (std::size_t i = 0; i < family.ring()->size(); ++i)
      if (i < family.phase().dimension || i >= family.phase().first_parameter())
        rows.push_back(
            json_text(to_string(weights[family.system().ring()->index(family.ring()->name(i))])));
    part.scale = {{"parameter", json_text(name)}, {"weights", json_list(std::move(rows))}};
    Substitution put = part.x.put;
    put.erase(p->first);
    auto region = part.x.region;
    add_once(region, Condition{MPoly::variable(family.ring(), p->first), Sign::nonzero});
    part.where = family.placed(put, std::move(region));
    return part;
  }
  // Weights that are integers, by variable of the ring of the system, for which it and the conditions are
  // homogeneous, and p moves; empty: there are none, or a condition has a sign that depends on the units.
  [[nodiscard]] std::vector<Integer> units(std::size_t p,
                                           const std::vector<Condition>& conditions) const {
    const certify::Family& family = s_.family.family();
    const Ring& ring = s_.family.system().ring();
    const auto known = s_.family.known_where(conditions);
    const auto has_arguments = [](const auto& f) { return !f.gradient.empty(); };
    const auto is_complex = [&](const std::string& name) {
      return family.complex[family.system.ring->index(name)];
    };
    if (std::ranges::any_of(known, certify::is_ordered, &Condition::sign) ||
        std::ranges::any_of(family.system.functions, has_arguments) ||
        !std::ranges::all_of(s_.family.parameters(), is_complex))
      return {};
    WeightEquations equations = weight_equations(s_.family.system());
    for (const Condition& c : known)
      equations.add_homogeneous(transfer(c.p, ring));
    for (const auto& row : equations.all()) {
      if (is_zero(row[p])) continue;
      Integer all(sign(to_rational(row[p])));
      for (const MFraction& w : row)
        if (!is_zero(w)) all = Integer(sign(all)) * lcm(all, to_rational(w).den());
      return mapped<Integer>(row, [&](const MFraction& w) {
        return is_zero(w) ? Integer(0) : (Rational(all) * to_rational(w)).num();
      });
    }
    return {};
  }
  // Parameters that the system of the certificate has not are put in: values for which both are the same.
  [[nodiscard]] PartPlace where_it_is(const certify::PhaseSystem& y, const PartPlace& x) const {
    std::set<std::size_t> missing;
    for (const std::string& name : s_.family.parameters())
      if (const std::size_t i = s_.family.ring()->index(name);
          !y.ring->find(name) && !x.put.contains(i))
        missing.insert(i);
    if (missing.empty()) return x;
    Substitution put = x.put;
    auto equations = differences(s_.family.phase(), y);
    for (std::size_t k = 0; k < equations.size();) {
      const MFraction f = substitute(MFraction(equations[k]), put);
      const auto solution = is_zero(f) ? std::nullopt : root_of(f.num(), missing, x);
      if (!solution) {
        ++k;
        continue;
      }
      StrataParts::put_in(put, solution->first, solution->second);
      k = 0;
    }
    return s_.family.placed(put, x.region);
  }
  // One of the parameters and a factor of f that is linear in it; the others vanish nowhere.
  [[nodiscard]] std::optional<std::pair<std::size_t, MPoly>>
  root_of(const MPoly& f, const std::set<std::size_t>& missing, const PartPlace& x) const {
    std::optional<std::pair<std::size_t, MPoly>> found;
    for (const MFactor& g : factor(f).second) {
      if (s_.proof.shown(x.given, {g.base, Sign::nonzero})) continue;
      if (found) return std::nullopt;
      for (const std::size_t i : used_variables(g.base))
        if (missing.contains(i) && degree(g.base, i) == 1 &&
            is_constant(coefficients(g.base, i)[1]))
          found = {i, g.base};
      if (!found) return std::nullopt;
    }
    return found;
  }
  // Polynomials in the parameters that vanish where both systems are the same; without denominators.
  [[nodiscard]] std::vector<MPoly> differences(const certify::PhaseSystem& x,
                                               const certify::PhaseSystem& y) const {
    if (x.hamiltonian.has_value() != y.hamiltonian.has_value() || x.field.size() != y.field.size())
      throw DomainError("another system");
    std::vector<MPoly> all;
    const auto add = [&](const certify::PhaseFunction& f, const certify::PhaseFunction& g) {
      const MFraction d = fraction(x, f) - fraction(y, g);
      if (is_zero(d)) return;
      std::map<Exponents, MPoly> parts;
      for (long t = 0; t < d.num().length(); ++t) {
        Exponents e = d.num().exponents(t), here(e.size(), 0);
        for (std::size_t j = x.first_parameter(); j < e.size(); ++j)
          here[j] = std::exchange(e[j], 0);
        MPoly& sum = parts.try_emplace(e, MPoly(s_.family.ring())).first->second;
        sum = sum + MPoly::term(s_.family.ring(), d.num().coefficient(t), here);
      }
      for (auto& [e, part] : parts)
        all.push_back(std::move(part));
    };
    if (x.hamiltonian) add(*x.hamiltonian, *y.hamiltonian);
    for (std::size_t j = 0; j < x.field.size(); ++j)
      add(x.field[j], y.field[j]);
    return all;
  }
  // In the names of the family.
  [[nodiscard]] MFraction fraction(const certify::PhaseSystem& s,
                                   const certify::PhaseFunction& f) const {
    Substitution inverses;
    for (std::size_t k = 0; k < s.inverses.size(); ++k)
      inverses[s.first_inverse() + k] =
          MFraction(MPoly(s.ring, Integer(1))) / MFraction(s.inverses[k]);
    const MFraction g = substitute(MFraction(f.p) / MFraction(MPoly(s.ring, f.n)), inverses);
    return transfer(g, s_.family.ring());
  }

  StrataParts& s_;
  AskedThere asked_;
  std::map<std::string, std::string> certificates_; ///< by their texts, the ids of their steps
  std::set<std::string> put_;                       ///< of these steps and their leaves
};

} // namespace kov
