// A theorem about strata of complex parameters as one certificate: theorem_certificates.md 11 to 16.

#include "certify/equation/facts.hpp"
#include "certify/theorem/integrable.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "system/in_ring.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/bundle_symmetries.hpp"
#include "theorem/darboux_step.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"
#include "theorem/strata.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace kov {
namespace {

using Exponents = std::vector<unsigned long>;

Json json_truth(bool x) { return json_text(x ? "yes" : "no"); }
Json json_texts(const std::vector<std::string>& all) {
  std::vector<Json> list;
  for (const std::string& one : all)
    list.push_back(json_text(one));
  return json_list(std::move(list));
}

Json json_class(const IntegralClass& c) {
  if (c.near == IntegralClass::Near::level)
    throw DomainError("there is no rule for first integrals that are " + sentence(c));
  std::vector<std::string> symbols;
  for (const auto& [coordinate, symbol] : c.through)
    add_once(symbols, symbol);
  return Json{Json::Object{{"kind", json_text(std::string(word_of(c.kind)))},
                           {"near", json_text(std::string(word_of(c.near)))},
                           {"on_leaf", json_truth(c.on_leaf)},
                           {"liouville", json_truth(c.liouville)},
                           {"functions", json_texts(c.functions)},
                           {"without", json_texts(c.without)},
                           {"through", json_texts(symbols)},
                           {"frame", json_text(c.frame)}}};
}

std::string one_line_of(std::string s) {
  for (char& c : s)
    if (c < ' ' || c > '~') c = '?';
  constexpr std::size_t longest = 3000;
  return s.substr(0, longest);
}

/// The place of a step, in the names of the family.
struct Place12 {
  Json at;
  certify::ParameterFunctions values;
  Substitution put;
  std::vector<Condition> equations, region, given;
  Substitution
      levels{}; ///< values of parameters that only the system of a certificate has, in its ring
};

class StrataBundle {
public:
  StrataBundle(TheoremResult& t, std::string directory,
               const std::map<std::string, std::string>& refused, const StudyAgain& again,
               const Budget& budget)
      : t_(t), directory_(std::move(directory)), refused_(refused), again_(again), budget_(budget),
        family_(system_of(t.theorem, directory_)), name_(t.theorem.system),
        proof_(family_.proof(budget)), json_(family_.json(name_)),
        symmetries_(family_, beside(directory_, t.theorem.system), name_, budget) {
    if (refused_.contains(all_symmetries)) symmetries_.clear();
  }

  [[nodiscard]] bool has_symmetries() const { return !symmetries_.steps().empty(); }

  BundleOfStrata operator()() {
    const NodeResult& root = t_.nodes.front();
    if (root.node.kind != NodeKind::cover || !root.node.place.at.empty() ||
        !root.node.place.conditions.empty())
      throw DomainError("the first step is not a cover of all parameters");
    certify::Arithmetic a;
    checked_ = certify::read_family(certify::Node(json_, name_, rationals()), a);
    for (NodeResult& n : t_.nodes)
      if (is_among(n.node.id, root.node.needs)) put_part(n);
    put_groups();
    if (std::ranges::all_of(parts_, [](const auto& id) { return id == "open"; }))
      throw DomainError(
          "it would say nothing: what is proved has conditions that no polynomial says");
    put_cover(root);
    return {certify::to_string(Json{Json::Object{{"format", json_text("kovacic-theorem/1")},
                                                 {"title", json_text(t_.theorem.title)},
                                                 {"systems", json_list({json_})},
                                                 {"steps", json_list(std::move(steps_))}}}),
            std::move(on_trust_), std::move(carried_), std::move(by_points_)};
  }

private:
  void put_step(const std::string& id, const char* rule, Json::Object members) {
    Json::Object step{{"id", json_text(id)}, {"rule", json_text(rule)}};
    for (auto& m : members)
      step.push_back(std::move(m));
    steps_.push_back(Json{std::move(step)});
  }

  // ---- a part of the cover

  void put_part(NodeResult& n) {
    if (n.node.kind == NodeKind::open_part) return put_region(n, open_);
    if (n.says == Conclusion::none) return;
    if (!n.on_trust && !refused_.contains(n.node.id)) {
      const auto why = not_put(n);
      if (!why) return;
      if (n.node.found.studies.empty()) return put_trusted(n, *why);
      again_(n);
      return put_part(n);
    }
    const auto no = refused_.find(n.node.id);
    const std::string why = no == refused_.end() ? "" : no->second;
    if (n.says == Conclusion::not_integrable && no == refused_.end()) return put_darboux(n);
    put_trusted(n, why);
  }

  // Why there is no step for it, if there is none.
  std::optional<std::string> not_put(const NodeResult& n) {
    try {
      n.says == Conclusion::has_integral ? put_integrable(n) : put_case(n);
      return std::nullopt;
    } catch (const DomainError& why) {
      return why.what();
    } catch (const InvalidArgument& why) {
      return why.what();
    } catch (const certify::Refused& why) {
      return why.why;
    }
  }

  // ---- excluded by Darboux points: region by region, and what has no certificate is on trust

  /// Regions without a certificate, and why.
  struct Left {
    std::vector<ParameterRegion> regions;
    std::vector<std::string> whys;
  };
  void put_darboux(const NodeResult& n) {
    NodeResult left = n;
    left.regions.clear();
    std::vector<std::string> whys;
    std::set<std::string> known;
    for (const ParameterRegion& r : regions_of(n)) {
      if (!known.insert(to_string(r.conditions)).second) continue;
      Budget little = budget_;
      constexpr double most_work = 6e8;
      if (!little.work_end || meter() + most_work < *little.work_end) little.give(most_work);
      const CaseProof proof(ComplexProof(checked_.system.ring, complex_there(), little));
      constexpr int most_cases = 8;
      const Left rest = put_darboux(n, r, proof, most_cases);
      left.regions.insert(left.regions.end(), rest.regions.begin(), rest.regions.end());
      for (const std::string& why : rest.whys)
        add_once(whys, why);
    }
    if (left.regions.empty()) return carried_.push_back(n.node.id);
    put_trusted(left, n.node.darboux.empty() ? "" : joined(whys, "; "));
    looked_at_.insert(n.node.id);
  }
  // A polynomial of which no proof is found that it is not 0 is so in one case, and 0 in the other, where
  // another chart may do.
  Left put_darboux(const NodeResult& n, const ParameterRegion& r, const CaseProof& proof,
                   int cases) {
    const Place12 x = solved(r);
    const auto no = put_darboux(n, x, proof);
    if (!no) return {};
    const auto f = cases > 0 ? unknown_factor(no->unknown, in_judge(x.given)) : std::nullopt;
    if (!f) return {{r}, {sentence(*no)}};
    Left left;
    for (const Sign sign : {Sign::nonzero, Sign::zero}) {
      ParameterRegion part = r;
      part.conditions.push_back({*f, sign});
      Left rest = put_darboux(n, part, proof, cases - 1);
      left.regions.insert(left.regions.end(), rest.regions.begin(), rest.regions.end());
      left.whys.insert(left.whys.end(), rest.whys.begin(), rest.whys.end());
    }
    return left;
  }
  // An irreducible factor of which the region says nothing, of the lowest degree.
  static std::optional<MPoly> unknown_factor(const std::vector<MPoly>& all,
                                             const std::vector<Condition>& given) {
    std::optional<MPoly> best;
    for (const MPoly& f : all)
      for (const MFactor& g : factor(f).second)
        if (std::ranges::none_of(
                given, [&](const Condition& c) { return c.p == g.base || c.p == -g.base; }) &&
            (!best || total_degree(g.base) < total_degree(*best)))
          best = g.base;
    return best;
  }
  // Why there is no certificate, if there is none.
  std::optional<NoDarbouxStep> put_darboux(const NodeResult& n, const Place12& x,
                                           const CaseProof& proof) {
    using certify::PotentialPart;
    std::vector<PotentialPart> parts{n.node.part == "highest"  ? PotentialPart::highest
                                     : n.node.part == "lowest" ? PotentialPart::lowest
                                                               : PotentialPart::all};
    // A leading part excludes rational integrals only: it is used if no more is said than that.
    if (n.node.darboux.empty() && excludes_rational_only()) parts.push_back(PotentialPart::highest);
    const bool relation = n.node.darboux != "multiple";
    std::optional<NoDarbouxStep> why;
    for (const PotentialPart part : parts)
      for (const bool first : {true, false}) {
        auto no = put_darboux(n, x, proof, {first == relation, part});
        if (!no) return std::nullopt;
        const bool other_may_do = no->depends == NoDarbouxStep::Depends::on_statement;
        if (first && (!why || why->why < no->why)) why = std::move(no);
        if (!other_may_do) break;
      }
    return why;
  }
  [[nodiscard]] bool excludes_rational_only() const {
    return std::ranges::any_of(
        t_.nodes, [](const NodeResult& n) { return !n.node.part.empty() && n.node.part != "all"; });
  }
  std::optional<NoDarbouxStep> put_darboux(const NodeResult& n, const Place12& x,
                                           const CaseProof& proof, const DarbouxSaid& said) {
    certify::FamilyStratum stratum{&checked_, {}, in_judge(x.region)};
    for (const auto& [i, value] : x.values)
      stratum.at[i] = in_judge(value);
    try {
      auto found = darboux_members(stratum, in_judge(x.given), said, proof);
      if (const auto* no = std::get_if<NoDarbouxStep>(&found)) return *no;
      Json::Object members{
          {"system", json_text(name_)}, {"at", x.at}, {"region", json_conditions(x.region)}};
      for (auto& m : std::get<Json::Object>(found))
        members.push_back(std::move(m));
      const std::string id = n.node.id + "-" + std::to_string(++darboux_steps_[n.node.id]);
      put_step(id, "darboux", std::move(members));
      add_region(id, x);
      note_theorems(by_points_[n.node.id], said);
      return std::nullopt;
    } catch (const OutOfBudget&) {
      budget_.check(); // of the whole
      return NoDarbouxStep{NoDarbouxStep::Why::limit};
    }
  }
  static void note_theorems(std::vector<const LiteratureTheorem*>& all, const DarbouxSaid& by) {
    add_once(all, by.relation ? &morales_ramis() : &morales_ramis_simo());
    if (by.part == certify::PotentialPart::highest) add_once(all, &ziglin_highest());
    if (by.part == certify::PotentialPart::lowest) add_once(all, &ziglin_lowest());
  }
  [[nodiscard]] std::vector<Condition> in_judge(const std::vector<Condition>& all) const {
    std::vector<Condition> there;
    for (const Condition& c : all)
      there.push_back({in_judge(certify::PhaseFunction{c.p, Integer(1)}).p, c.sign});
    return there;
  }
  [[nodiscard]] std::vector<bool> complex_there() const {
    return checked_.complex.empty() ? std::vector<bool>(checked_.system.ring->size(), false)
                                    : checked_.complex;
  }

  // Equations that are linear in a parameter, with a number before it, are solved.
  [[nodiscard]] Place12 solved(const ParameterRegion& r) const {
    Substitution put;
    std::vector<Condition> region;
    for (const Condition& c : r.conditions)
      region.push_back(family_.moved(c));
    for (std::size_t k = 0; k < region.size();) {
      const MFraction there = substitute(MFraction(region[k].p), put);
      const auto i = is_zero(there) || region[k].sign != Sign::zero ? std::nullopt
                                                                    : linear_parameter(there.num());
      if (!i) {
        ++k;
        continue;
      }
      put_in(put, *i, there.num());
      region.erase(region.begin() + static_cast<long>(k));
      k = 0;
    }
    return placed(put, std::move(region));
  }
  // f = 0 is solved for parameter i.
  static void put_in(Substitution& put, std::size_t i, const MPoly& f) {
    const auto line = coefficients(f, i);
    const MFraction value = -MFraction(line[0]) / MFraction(line[1]);
    for (auto& [j, known] : put)
      known = is_zero(known) ? known : substitute(known, Substitution{{i, value}});
    put[i] = value;
  }
  static std::optional<std::size_t> linear_parameter(const MPoly& f) {
    for (const std::size_t i : used_variables(f))
      if (degree(f, i) == 1 && is_constant(coefficients(f, i)[1])) return i;
    return std::nullopt;
  }
  [[nodiscard]] Place12 placed(const Substitution& put, std::vector<Condition> region) const {
    Place12 x;
    x.put = put;
    x.region = std::move(region);
    std::vector<Json> rows;
    for (const auto& [i, f] : put) {
      if (!is_zero(f) && !is_constant(f.den()))
        throw DomainError(family_.ring()->name(i) + " is put to a quotient of parameters");
      x.values[i] = is_zero(f) ? certify::PhaseFunction{MPoly(family_.ring()), Integer(1)}
                               : certify::PhaseFunction{f.num(), f.den().coefficient(0)};
      rows.push_back(
          json_list({json_text(family_.ring()->name(i)), certify::to_json(x.values[i])}));
      x.equations.push_back(
          {certify::scaled(MPoly::variable(family_.ring(), i), x.values[i].n) - x.values[i].p,
           Sign::zero});
    }
    x.at = json_list(std::move(rows));
    put_given(x);
    return x;
  }

  [[nodiscard]] Place12 place_of(const NodeResult& n) const {
    const Place& p = n.node.place;
    if (!p.as.empty() || !p.roots.empty() || !p.of.empty() || !p.time.empty())
      throw DomainError("a change of variables beside strata");
    Substitution put;
    const System base = system_of(t_.theorem, directory_, p.at);
    for (const std::string& name : family_.parameters()) {
      const auto value = base.values.find(name);
      if (std::ranges::none_of(p.at, [&](const auto& v) { return v.first == name; })) continue;
      if (value == base.values.end()) throw DomainError(name + " has no value");
      put[family_.ring()->index(name)] = is_zero(value->second)
                                             ? MFraction(MPoly(family_.ring()))
                                             : transfer(value->second, family_.ring());
    }
    std::vector<Condition> region;
    for (const Condition& c : conditions_of(family_.system(), p))
      region.push_back(family_.moved(c));
    return placed(put, std::move(region));
  }
  void put_given(Place12& x) const {
    for (const std::vector<Condition>* all : {&family_.assumptions(), &std::as_const(x.region)})
      for (const Condition& c : *all) {
        const MFraction f = substitute(MFraction(c.p), x.put);
        x.given.push_back(
            {is_zero(f) ? MPoly(family_.ring()) : certify::primitive(f.num()), c.sign});
      }
  }
  void add_region(const std::string& id, const Place12& x, bool excludes = true) {
    RegionOfPart r{parts_.size(), std::nullopt, x.equations};
    r.conditions.insert(r.conditions.end(), x.region.begin(), x.region.end());
    if (excludes) excluded_.push_back(r);
    regions_.push_back(std::move(r));
    parts_.push_back(id);
  }

  // ---- excluded, by certificates of its own: by one as a whole, or leaf by leaf

  /// Some points of a node, and what excludes them.
  struct CasePart {
    std::size_t certificate = 0;
    std::optional<std::size_t> leaf;
    Place12 x;
    std::vector<Json> shown;
  };

  void put_case(const NodeResult& n) {
    const Place12 whole = place_of(n);
    std::vector<CasePart> parts;
    std::string why = "the step has no certificate";
    for (std::size_t k = 0; k < n.certificates.size(); ++k)
      try {
        add_parts(k, said_by(n.certificates[k]), whole, parts, why);
      } catch (const Error& no) {
        why = no.what();
      }
    const auto all = std::ranges::find_if(parts, [&](const CasePart& p) {
      return p.x.equations.size() + p.x.region.size() ==
             whole.equations.size() + whole.region.size();
    });
    parts = all != parts.end() ? std::vector{*all} : covering(whole, parts);
    if (parts.empty()) throw DomainError(why);
    put_parts(n, parts);
  }
  void put_parts(const NodeResult& n, const std::vector<CasePart>& parts) {
    const auto once = [&](const std::string& id, const char* rule, Json::Object members) {
      if (put_.insert(id).second) put_step(id, rule, std::move(members));
    };
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto& [certificate, leaf, x, shown] = parts[k];
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
                           {"system", json_text(name_)},
                           {"at", x.at},
                           {"region", json_conditions(x.region)},
                           {"shown", json_list(shown)}};
      std::vector<Json> levels;
      for (const auto& [name, value] : level_values(x))
        levels.push_back(json_list({json_text(name), certify::to_json(value)}));
      if (!levels.empty()) members.emplace_back("levels", json_list(std::move(levels)));
      once(id, "place", std::move(members));
      add_region(id, x);
    }
  }
  // The parts that are needed to cover a node; none: they do not.
  [[nodiscard]] std::vector<CasePart> covering(const Place12& whole,
                                               const std::vector<CasePart>& parts) const {
    std::vector<CasePart> needed;
    std::vector<RegionOfPart> regions;
    const auto conditions = [](const Place12& x) {
      auto all = x.equations;
      all.insert(all.end(), x.region.begin(), x.region.end());
      return all;
    };
    const auto is_covered = [&](const Place12& x) {
      auto there = family_.assumptions();
      const auto here = conditions(x);
      there.insert(there.end(), here.begin(), here.end());
      return tree_of_regions(proof_, there, regions, budget_).has_value();
    };
    for (const CasePart& p : parts) {
      if (is_covered(p.x)) continue;
      regions.push_back({needed.size(), std::nullopt, conditions(p.x)});
      needed.push_back(p);
      if (is_covered(whole)) return needed;
    }
    return {};
  }

  void add_parts(std::size_t certificate, const certify::Said& said, const Place12& whole,
                 std::vector<CasePart>& parts, std::string& why) const {
    const auto add = [&](std::optional<std::size_t> leaf, const certify::Target& y,
                         const Place12& x) {
      try {
        Place12 at_levels = x;
        at_levels.levels = levels_of(y);
        for (const Place12& there : where_asked(y, at_levels))
          parts.push_back({certificate, leaf, there, shown_of(y, there)});
      } catch (const certify::Refused& no) {
        why = no.why;
      } catch (const Error& no) {
        why = no.what();
      }
    };
    const Place12 x = where_it_is(*said.system, whole);
    if (said.kind == certify::FactKind::not_integrable) return add(std::nullopt, *said.target, x);
    for (std::size_t k = 0; k < said.leaves.size(); ++k)
      if (said.leaves[k].trusted == 0) add(k, certify::target_of(said, said.leaves[k]), x);
  }

  // Parameters that the system of the certificate has not are put in: values for which both are the same.
  [[nodiscard]] Place12 where_it_is(const certify::PhaseSystem& y, const Place12& x) const {
    std::set<std::size_t> missing;
    for (const std::string& name : family_.parameters())
      if (const std::size_t i = family_.ring()->index(name);
          !y.ring->find(name) && !x.put.contains(i))
        missing.insert(i);
    if (missing.empty()) return x;
    Substitution put = x.put;
    auto equations = differences(family_.phase(), y);
    for (std::size_t k = 0; k < equations.size();) {
      const MFraction f = substitute(MFraction(equations[k]), put);
      const auto solution = is_zero(f) ? std::nullopt : root_of(f.num(), missing, x);
      if (!solution) {
        ++k;
        continue;
      }
      put_in(put, solution->first, solution->second);
      k = 0;
    }
    return placed(put, x.region);
  }
  // One of the parameters and a factor of f that is linear in it; the others vanish nowhere.
  [[nodiscard]] std::optional<std::pair<std::size_t, MPoly>>
  root_of(const MPoly& f, const std::set<std::size_t>& missing, const Place12& x) const {
    std::optional<std::pair<std::size_t, MPoly>> found;
    for (const MFactor& g : factor(f).second) {
      if (proof_.shown(x.given, {g.base, Sign::nonzero})) continue;
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
        MPoly& sum = parts.try_emplace(e, MPoly(family_.ring())).first->second;
        sum = sum + MPoly::term(family_.ring(), d.num().coefficient(t), here);
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
    return is_zero(g) ? MFraction(MPoly(family_.ring())) : transfer(g, family_.ring());
  }

  // Equations on the way to a leaf are solved for levels.
  [[nodiscard]] Substitution levels_of(const certify::Target& y) const {
    Substitution levels;
    for (const certify::AskedCondition& c : y.asked) {
      if (c.real || !c.group.empty() || c.sign != Sign::zero) continue;
      const MFraction f = substitute(MFraction(c.f), levels);
      if (is_zero(f)) continue;
      for (const std::size_t i : used_variables(f.num())) {
        if (!is_level(f.num().ring()->name(i)) || degree(f.num(), i) != 1 ||
            !is_constant(coefficients(f.num(), i)[1]))
          continue;
        put_in(levels, i, f.num());
        break;
      }
    }
    return levels;
  }
  // The parts of a polynomial by the monomials in the levels, in the order of the judge.
  [[nodiscard]] std::vector<std::pair<Exponents, MPoly>> by_levels(const MPoly& given,
                                                                   const Place12& x) const {
    const MFraction there = substitute(MFraction(given), x.levels);
    const MPoly f = is_zero(there) ? MPoly(given.ring()) : there.num();
    const auto level_part = [&](const Exponents& e) {
      Exponents levels(e.size(), 0);
      for (std::size_t j = 0; j < e.size(); ++j)
        if (is_level(f.ring()->name(j))) levels[j] = e[j];
      return levels;
    };
    std::map<Exponents, MPoly> all;
    for (long t = 0; t < f.length(); ++t) {
      const Exponents e = f.exponents(t);
      Exponents here(family_.ring()->size(), 0);
      for (std::size_t j = 0; j < e.size(); ++j)
        if (e[j] > 0 && !is_level(f.ring()->name(j)))
          here[family_.ring()->index(f.ring()->name(j))] = e[j];
      MPoly& sum = all.try_emplace(level_part(e), MPoly(family_.ring())).first->second;
      sum = sum + MPoly::term(family_.ring(), f.coefficient(t), here);
    }
    if (all.empty()) all.emplace(Exponents(f.ring()->size(), 0), MPoly(family_.ring()));
    return {all.begin(), all.end()};
  }
  [[nodiscard]] bool is_level(const std::string& name) const {
    return !family_.ring()->find(name).has_value();
  }

  // A condition that the judge settles by itself.
  [[nodiscard]] bool needs_no_node(const certify::AskedCondition& c, const Place12& x) const {
    if (c.real) return true;
    if (!c.group.empty() || (c.sign != Sign::positive && c.sign != Sign::nonnegative)) return false;
    const auto used = used_variables(c.f);
    return used.size() == 1 && is_level(c.f.ring()->name(used.front())) &&
           !x.levels.contains(used.front());
  }
  // Conditions on the parameters, one of which is enough: for some values of the levels it holds then.
  [[nodiscard]] std::vector<Condition> parts_of(const certify::AskedCondition& c,
                                                const Place12& x) const {
    std::vector<Condition> all;
    for (const MPoly& f : c.group.empty() ? std::vector{c.f} : c.group)
      for (const auto& [levels, part] : by_levels(f, x))
        all.push_back({part, c.sign});
    return all;
  }
  [[nodiscard]] std::optional<Json> shown(const certify::AskedCondition& c,
                                          const Place12& x) const {
    auto parts = parts_of(c, x);
    if (c.sign != Sign::nonzero) return proof_.shown(x.given, parts.front());
    auto zeros = x.given;
    for (const Condition& part : parts)
      zeros.push_back({part.p, Sign::zero});
    return proof_.contradiction(zeros);
  }
  // Places where all that is asked holds: x with more conditions, as few as are seen to be needed.
  [[nodiscard]] std::vector<Place12> where_asked(const certify::Target& y, const Place12& x) const {
    constexpr std::size_t most = 4;
    std::vector<Place12> all{x};
    for (const certify::AskedCondition& c : y.asked) {
      if (needs_no_node(c, x)) continue;
      std::vector<Place12> next;
      for (const Place12& there : all) {
        if (shown(c, there)) {
          next.push_back(there);
          continue;
        }
        for (const Condition& part : parts_of(c, there)) {
          if (is_zero(part.p) || is_constant(part.p) || next.size() == most) continue;
          auto region = there.region;
          region.push_back({certify::primitive(part.p), part.sign});
          Place12 smaller = placed(there.put, std::move(region));
          smaller.levels = there.levels;
          if (shown(c, smaller)) next.push_back(std::move(smaller));
        }
      }
      all = std::move(next);
    }
    std::erase_if(all, [&](const Place12& p) { return proof_.contradiction(p.given).has_value(); });
    return all;
  }
  [[nodiscard]] certify::LevelValues level_values(const Place12& x) const {
    certify::LevelValues values;
    for (const auto& [i, f] : x.levels) {
      const Ring& ring = checked_.system.ring;
      const std::string& name = f.ring()->name(i);
      values[name] = is_zero(f)
                         ? certify::PhaseFunction{MPoly(ring), Integer(1)}
                         : certify::PhaseFunction{transfer(f, ring).num(), f.den().coefficient(0)};
    }
    return values;
  }
  // As the judge wants it, which looks at it here already.
  [[nodiscard]] std::vector<Json> shown_of(const certify::Target& y, const Place12& x) const {
    std::vector<Json> all;
    for (const certify::AskedCondition& c : y.asked)
      if (!needs_no_node(c, x)) all.push_back(shown(c, x).value());
    certify::FamilyStratum there{&checked_, {}, in_judge(x.region)};
    for (const auto& [i, value] : x.values)
      there.at[i] = in_judge(value);
    certify::Arithmetic a;
    std::size_t nodes = 100000;
    const certify::Map checked(there, y, level_values(x),
                               certify::Node(json_list(all), "shown", rationals()), a, nodes);
    return all;
  }

  // ---- integrable

  void put_integrable(const NodeResult& n) {
    const Place12 x = place_of(n);
    const certify::FamilyStratum stratum{&checked_, x.values, x.region};
    certify::ClaimedIntegrals c;
    c.family = &checked_;
    std::vector<Json> claims, fields;
    for (const auto& [name, value] : n.node.found.integrals) {
      const certify::PhaseFunction f = function(value);
      c.claims.emplace_back(name, in_judge(f));
      claims.push_back(
          Json{Json::Object{{"name", json_text(name)}, {"value", certify::to_json(f)}}});
    }
    for (const auto& row : n.node.found.fields) {
      std::vector<Json> entries;
      c.fields.emplace_back();
      for (const MFraction& component : row) {
        const certify::PhaseFunction f = function(component, false);
        c.fields.back().push_back(in_judge(f));
        entries.push_back(certify::to_json(f));
      }
      fields.push_back(json_list(std::move(entries)));
    }
    const std::size_t d = checked_.system.dimension, m = c.claims.size();
    const bool bracket = checked_.system.hamiltonian.has_value();
    if (bracket && (m > d || 2 * m < d)) throw DomainError("too few first integrals");
    const bool needs_rank = bracket || m < d;
    Json independent = m == 0 ? Json{} : minor(stratum, c, false, m, x);
    Json rank = needs_rank ? minor(stratum, c, true, bracket ? 2 * (d - m) : 1 + c.fields.size(), x)
                           : Json{};
    trust_minor(n, m > 0 && independent.is_null(),
                "the gradients of the integrals are independent");
    trust_minor(n, needs_rank && rank.is_null(),
                bracket ? "the rank of the bracket" : "the fields are independent");
    put_step(n.node.id, "integrable",
             {{"system", json_text(name_)},
              {"at", x.at},
              {"region", json_conditions(x.region)},
              {"claims", json_list(std::move(claims))},
              {"fields", json_list(std::move(fields))},
              {"independent", std::move(independent)},
              {"rank", std::move(rank)}});
    add_region(n.node.id, x, false);
  }
  void trust_minor(const NodeResult& n, bool on_trust, const char* what) {
    if (on_trust)
      on_trust_.emplace_back(
          n.node.id, Trusted{Trusted::Step::gap, std::string("no minor shows it: ") + what});
  }
  // The function in the names of the family as the judge has read it.
  [[nodiscard]] certify::PhaseFunction in_judge(const certify::PhaseFunction& f) const {
    const Ring& ring = checked_.system.ring;
    return {is_zero(f.p) ? MPoly(ring) : transfer(MFraction(f.p), ring).num(), f.n};
  }
  // A multiple by what does not depend on the variables is an integral as well.
  certify::PhaseFunction function(const MFraction& given, bool any_multiple = true) {
    const System& s = family_.system();
    const MFraction f = is_zero(given) ? given : in_names_of(s, given);
    if (is_zero(f)) return {MPoly(family_.ring()), Integer(1)};
    const auto used = used_variables(f.den());
    const auto& p = s.field.parameters;
    const bool is_parametric =
        std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, p); });
    return family_.written(any_multiple && is_parametric ? MFraction(f.num()) : f);
  }

  // A minor with a coefficient that is not 0 on the stratum; null: it is on trust.
  Json minor(const certify::FamilyStratum& stratum, const certify::ClaimedIntegrals& c, bool rank,
             std::size_t size, const Place12& x) {
    const std::size_t d = checked_.system.dimension;
    constexpr std::size_t most_tries = 200;
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < size; ++i)
      columns.push_back(i);
    for (std::size_t tries = 0; tries < most_tries && size <= d; ++tries) {
      if (auto found = coefficient(minor_polynomial(stratum, c, rank, columns), x)) {
        std::vector<Json> names;
        for (const std::size_t i : columns)
          names.push_back(json_text(checked_.system.ring->name(i)));
        found->emplace(found->begin(), "columns", json_list(std::move(names)));
        return Json{*std::move(found)};
      }
      if (!next(columns, d)) break;
    }
    return {};
  }
  // 0 where the format has no rule for its functions.
  [[nodiscard]] MPoly minor_polynomial(const certify::FamilyStratum& stratum,
                                       const certify::ClaimedIntegrals& c, bool rank,
                                       const std::vector<std::size_t>& columns) const {
    try {
      certify::Arithmetic a;
      return certify::minor_of(stratum, c, rank, columns, a);
    } catch (const certify::Refused&) {
      return MPoly(family_.ring());
    }
  }
  static bool next(std::vector<std::size_t>& columns, std::size_t d) {
    const std::size_t n = columns.size();
    for (std::size_t k = n; k-- > 0;) {
      if (columns[k] + (n - k) >= d) continue;
      ++columns[k];
      for (std::size_t i = k + 1; i < n; ++i)
        columns[i] = columns[i - 1] + 1;
      return true;
    }
    return false;
  }
  [[nodiscard]] std::optional<Json::Object> coefficient(const MPoly& f, const Place12& x) const {
    const std::size_t d = checked_.system.dimension;
    std::map<Exponents, MPoly> all;
    const std::set<Exponents> with_functions = beside_functions(f);
    for (long t = 0; t < f.length(); ++t) {
      Exponents e = f.exponents(t);
      if (with_functions.contains(without_arguments(e))) continue;
      const Exponents monomial(e.begin(), e.begin() + static_cast<long>(d));
      std::fill(e.begin(), e.begin() + static_cast<long>(d), 0);
      MPoly& sum = all.try_emplace(monomial, MPoly(f.ring())).first->second;
      sum = sum + MPoly::term(f.ring(), f.coefficient(t), e);
    }
    std::vector<std::pair<Exponents, MPoly>> sorted(all.begin(), all.end());
    std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) {
      return total_degree(a.second) < total_degree(b.second);
    });
    constexpr std::size_t most_tries = 30;
    for (std::size_t k = 0; k < sorted.size() && k < most_tries; ++k) {
      const auto& [monomial, c] = sorted[k];
      const MPoly value = certify::primitive(family_.moved({c, Sign::nonzero}).p);
      if (is_zero(value)) continue;
      auto node = proof_.shown(x.given, {value, Sign::nonzero});
      if (!node) continue;
      std::vector<Json> exponents;
      for (const unsigned long e : monomial)
        exponents.push_back(json_text(std::to_string(e)));
      return Json::Object{{"monomial", json_list(std::move(exponents))},
                          {"value", json_text(to_string(value))},
                          {"by", *std::move(node)}};
    }
    return std::nullopt;
  }
  // The powers of those coordinates on which no function depends.
  [[nodiscard]] Exponents without_arguments(Exponents e) const {
    e.resize(checked_.system.dimension);
    for (const certify::PhaseSymbol& f : checked_.system.functions)
      for (const auto& [j, slope] : f.gradient)
        e[j] = 0;
    return e;
  }
  [[nodiscard]] std::set<Exponents> beside_functions(const MPoly& f) const {
    std::set<Exponents> all;
    const auto first = static_cast<long>(checked_.system.dimension);
    const auto last = static_cast<long>(checked_.system.first_parameter());
    for (long t = 0; t < f.length(); ++t) {
      const Exponents e = f.exponents(t);
      if (std::any_of(e.begin() + first, e.begin() + last, [](auto n) { return n > 0; }))
        all.insert(without_arguments(e));
    }
    return all;
  }
  static long total_degree(const MPoly& f) {
    long most = 0;
    for (long t = 0; t < f.length(); ++t) {
      long sum = 0;
      for (const unsigned long e : f.exponents(t))
        sum += static_cast<long>(e);
      most = std::max(most, sum);
    }
    return most;
  }

  // ---- on trust, or open

  struct Group {
    std::string id, step;
    bool integrable = false, on_trust = false; ///< as the node itself
    IntegralClass integrals;
    std::vector<std::vector<Condition>> regions;
  };
  void put_trusted(const NodeResult& n, const std::string& why) {
    const bool integrable = n.says == Conclusion::has_integral;
    std::string step = n.node.step.empty() ? n.summary : n.node.step;
    if (n.excluded.size() > 1) throw DomainError("a step on trust with several classes");
    const IntegralClass integrals = n.excluded.empty() ? IntegralClass{} : n.excluded.front();
    if (!why.empty() && (!n.on_trust || !n.node.darboux.empty()))
      step += " [no certificate: " + why + "]";
    step = one_line_of(step);
    for (Group& g : trusted_)
      if (g.step == step && g.integrable == integrable && g.on_trust == n.on_trust &&
          g.integrals == integrals)
        return put_region(n, g);
    trusted_.push_back({n.node.id, step, integrable, n.on_trust, integrals, {}});
    put_region(n, trusted_.back());
  }
  void put_region(const NodeResult& n, Group& g) const {
    for (const ParameterRegion& r : regions_of(n)) {
      g.regions.emplace_back();
      for (const Condition& c : r.conditions)
        g.regions.back().push_back(family_.moved(c));
    }
  }
  // A part of a region that Darboux points leave may lie in other strata.
  void drop_what_is_covered() {
    for (Group& g : trusted_) {
      if (!looked_at_.contains(g.id)) continue;
      for (std::size_t k = 0; k < g.regions.size();)
        if (is_covered(g, k))
          g.regions.erase(g.regions.begin() + static_cast<long>(k));
        else
          ++k;
    }
    std::erase_if(trusted_, [](const Group& g) { return g.regions.empty(); });
  }
  [[nodiscard]] bool is_covered(const Group& without, std::size_t k) const {
    auto others = regions_;
    const auto add = [&](const Group& g) {
      for (std::size_t i = 0; i < g.regions.size(); ++i)
        if (&g != &without || i != k) others.push_back({0, i, g.regions[i]});
    };
    for (const Group& g : trusted_)
      add(g);
    add(open_);
    auto there = family_.assumptions();
    there.insert(there.end(), without.regions[k].begin(), without.regions[k].end());
    return is_covered(there, others);
  }
  [[nodiscard]] bool is_covered(const std::vector<Condition>& there,
                                const std::vector<RegionOfPart>& regions) const {
    Budget little = budget_;
    constexpr double most_work = 1e8;
    if (!little.work_end || meter() + most_work < *little.work_end) little.give(most_work);
    try {
      return tree_of_regions(family_.proof(little), there, regions, little).has_value();
    } catch (const OutOfBudget&) {
      budget_.check();
      return false;
    }
  }
  void put_groups() {
    drop_what_is_covered();
    for (const Group& g : trusted_)
      for (const auto& region : g.regions)
        symmetries_.look_for_rotations(region);
    for (const RegionOfPart& r : excluded_)
      add_images(r);
    for (const Group& g : trusted_)
      put_group(g);
    if (open_.regions.empty()) return;
    put_step("open", "open", {{"system", json_text(name_)}, {"regions", put_regions(open_)}});
    parts_.emplace_back("open");
  }
  // The points that a symmetry sends into a region of a part that says "not integrable".
  void add_images(const RegionOfPart& r) {
    for (auto& w : symmetries_.before(r.conditions))
      images_.push_back({r.part, r.region, std::move(w.conditions), std::move(w.letters)});
  }
  // Is a region mapped into earlier ones by symmetries?  It is proved as these are.
  bool put_images(const std::vector<Condition>& region) {
    std::vector<RegionOfPart> some;
    for (const RegionOfPart& x : images_) {
      if (!satisfies_equations(region, x.conditions)) continue;
      some.push_back(x);
      if (implies(region, x.conditions) && put({x})) return true;
    }
    return some.size() > 1 && put(covering(region, std::move(some)));
  }
  bool put(const std::vector<RegionOfPart>& images) {
    std::vector<RegionOfPart> known;
    for (const RegionOfPart& x : images) {
      const auto word = symmetries_.use(x.word);
      if (!word) return false;
      known.push_back({x.part, x.region, x.conditions, *word});
    }
    regions_.insert(regions_.end(), known.begin(), known.end());
    return !known.empty();
  }
  // Images that are needed to cover a region together; none: they do not.
  [[nodiscard]] std::vector<RegionOfPart> covering(const std::vector<Condition>& region,
                                                   std::vector<RegionOfPart> images) const {
    auto there = family_.assumptions();
    there.insert(there.end(), region.begin(), region.end());
    if (!is_covered(there, images)) return {};
    for (std::size_t k = 0; k < images.size();) {
      auto fewer = images;
      fewer.erase(fewer.begin() + static_cast<long>(k));
      is_covered(there, fewer) ? void(images = std::move(fewer)) : void(++k);
    }
    return images;
  }
  [[nodiscard]] bool satisfies_equations(const std::vector<Condition>& region,
                                         const std::vector<Condition>& wanted) const {
    std::vector<MPoly> equations;
    for (const Condition& c : region)
      if (c.sign == Sign::zero) equations.push_back(c.p);
    certify::Arithmetic a;
    return std::ranges::all_of(wanted, [&](const Condition& c) {
      return c.sign != Sign::zero || is_zero(certify::modulo_equations(c.p, equations, a));
    });
  }
  // The equations are satisfied.
  [[nodiscard]] bool implies(const std::vector<Condition>& region,
                             const std::vector<Condition>& wanted) const {
    const auto is_stated = [&](const Condition& c, const std::vector<Condition>& all) {
      return std::ranges::any_of(all, [&](const Condition& d) {
        return c.sign == d.sign && (c.p == d.p || (c.sign != Sign::positive &&
                                                   c.sign != Sign::nonnegative && c.p == -d.p));
      });
    };
    auto given = family_.assumptions();
    given.insert(given.end(), region.begin(), region.end());
    return std::ranges::all_of(wanted, [&](const Condition& c) {
      return c.sign == Sign::zero || is_stated(c, given) || proof_.shown(given, c).has_value();
    });
  }
  void put_group(Group g) {
    if (!g.integrable)
      for (std::size_t k = 0; k < g.regions.size();) {
        if (put_images(g.regions[k])) {
          g.regions.erase(g.regions.begin() + static_cast<long>(k));
          continue;
        }
        add_images({parts_.size(), k, g.regions[k]});
        ++k;
      }
    if (g.regions.empty()) return;
    Json::Object members{{"system", json_text(name_)},
                         {"says", json_text(g.integrable ? "integrable" : "not integrable")},
                         {"step", json_text(g.step)},
                         {"regions", put_regions(g)}};
    if (!g.integrable) members.emplace_back("class", json_class(g.integrals));
    on_trust_.emplace_back(g.id, Trusted{Trusted::Step::by_author, g.step});
    put_step(g.id, "trusted", std::move(members));
    parts_.push_back(g.id);
  }
  Json put_regions(const Group& g) {
    std::vector<Json> rows;
    for (std::size_t k = 0; k < g.regions.size(); ++k) {
      rows.push_back(json_conditions(g.regions[k]));
      regions_.push_back({parts_.size(), k, g.regions[k]});
    }
    return json_list(std::move(rows));
  }

  void put_cover(const NodeResult& root) {
    std::vector<Json> parts;
    for (const std::string& id : parts_)
      parts.push_back(json_text(id));
    auto tree = tree_of_regions(proof_, family_.assumptions(), regions_, budget_);
    if (!tree) throw DomainError("the cover of the parameters was not found");
    std::vector<Json> symmetries;
    for (const Json::Object& step : symmetries_.steps()) {
      symmetries.push_back(json_text("symmetry-" + std::to_string(symmetries.size() + 1)));
      put_step("symmetry-" + std::to_string(symmetries.size()), "symmetry", step);
    }
    put_step(root.node.id, "cover",
             {{"system", json_text(name_)},
              {"symmetries", json_list(std::move(symmetries))},
              {"parts", json_list(std::move(parts))},
              {"tree", *std::move(tree)}});
  }

  TheoremResult& t_;
  std::string directory_;
  const std::map<std::string, std::string>& refused_;
  const StudyAgain& again_;
  const Budget& budget_;
  StrataFamily family_;
  std::string name_;
  ComplexProof proof_;
  Json json_;
  BundleSymmetries symmetries_;
  std::vector<RegionOfPart> excluded_; ///< of parts that say "not integrable"
  std::vector<RegionOfPart> images_;   ///< of them; the words in the numbers of all symmetries
  certify::Family checked_;
  std::vector<Json> steps_;
  std::vector<std::string> parts_;
  std::map<std::string, std::string> certificates_; ///< by their texts, the ids of their steps
  std::set<std::string> put_;                       ///< of these steps and their leaves
  std::vector<RegionOfPart> regions_;
  std::vector<Group> trusted_;
  std::map<std::string, std::size_t> darboux_steps_; ///< of a node
  std::set<std::string> looked_at_; ///< nodes of which some Darboux points are not enough
  StepsOnTrust on_trust_;
  std::vector<std::string> carried_;
  TheoremsOfSteps by_points_;
  Group open_;
};

} // namespace

BundleOfStrata bundle_of_strata(TheoremResult& t, const std::string& directory,
                                const std::map<std::string, std::string>& refused,
                                const StudyAgain& again, const Budget& budget) {
  StrataBundle bundle(t, directory, refused, again, budget);
  try {
    return bundle();
  } catch (const DomainError&) {
    if (!bundle.has_symmetries()) throw;
  }
  auto none = refused;
  none.emplace(all_symmetries, "the cover");
  return StrataBundle(t, directory, none, again, budget)();
}

} // namespace kov
