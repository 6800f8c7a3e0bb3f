// A theorem about strata of complex parameters as one certificate: theorem_certificates.md 11 to 16.

#include "certify/equation/facts.hpp"
#include "certify/theorem/stratum.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "system/formula.hpp"
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
};

class StrataBundle {
public:
  StrataBundle(const TheoremResult& t, std::string directory,
               const std::map<std::string, std::string>& refused, const Budget& budget)
      : t_(t), directory_(std::move(directory)), refused_(refused), budget_(budget),
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
    for (const std::string& id : root.node.needs)
      put_part(*node_with(t_, id));
    put_groups();
    if (std::ranges::all_of(parts_, [](const auto& id) { return id == "open"; }))
      throw DomainError(
          "it would say nothing: what is proved has conditions that no polynomial says");
    put_cover(root);
    return {certify::to_string(Json{Json::Object{{"format", json_text("kovacic-theorem/1")},
                                                 {"title", json_text(t_.theorem.title)},
                                                 {"systems", json_list({json_})},
                                                 {"steps", json_list(std::move(steps_))}}}),
            std::move(on_trust_), std::move(carried_)};
  }

private:
  void put_step(const std::string& id, const char* rule, Json::Object members) {
    Json::Object step{{"id", json_text(id)}, {"rule", json_text(rule)}};
    for (auto& m : members)
      step.push_back(std::move(m));
    steps_.push_back(Json{std::move(step)});
  }

  // ---- a part of the cover

  void put_part(const NodeResult& n) {
    if (n.node.kind == NodeKind::open_part) return put_region(n, open_);
    if (n.says == Conclusion::none) return;
    if (!n.on_trust && !refused_.contains(n.node.id)) try {
        return n.says == Conclusion::has_integral ? put_integrable(n) : put_case(n);
      } catch (const DomainError& why) {
        return put_trusted(n, why.what());
      } catch (const InvalidArgument& why) {
        return put_trusted(n, why.what());
      } catch (const certify::Refused& why) {
        return put_trusted(n, why.why);
      }
    const auto no = refused_.find(n.node.id);
    const std::string why = no == refused_.end() ? "" : no->second;
    if (n.says == Conclusion::not_integrable && no == refused_.end()) return put_darboux(n);
    put_trusted(n, why);
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
        if (first && (!why || why->why < no->why)) why = std::move(no);
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
      return std::nullopt;
    } catch (const OutOfBudget&) {
      budget_.check(); // of the whole
      return NoDarbouxStep{NoDarbouxStep::Why::limit};
    }
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
    Place12 x;
    for (const Condition& c : r.conditions)
      x.region.push_back(family_.moved(c));
    for (std::size_t k = 0; k < x.region.size();) {
      const MFraction there = substitute(MFraction(x.region[k].p), x.put);
      const auto i = is_zero(there) || x.region[k].sign != Sign::zero
                         ? std::nullopt
                         : linear_parameter(there.num());
      if (!i) {
        ++k;
        continue;
      }
      const auto line = coefficients(there.num(), *i);
      const MFraction value = -MFraction(line[0]) / MFraction(line[1]);
      for (auto& [j, known] : x.put)
        known = is_zero(known) ? known : substitute(known, Substitution{{*i, value}});
      x.put[*i] = value;
      x.region.erase(x.region.begin() + static_cast<long>(k));
      k = 0;
    }
    std::vector<Json> rows;
    for (const auto& [i, value] : x.put) {
      const bool none = is_zero(value);
      x.values[i] = {none ? MPoly(family_.ring()) : value.num(),
                     none ? Integer(1) : value.den().coefficient(0)};
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
  static std::optional<std::size_t> linear_parameter(const MPoly& f) {
    for (const std::size_t i : used_variables(f))
      if (degree(f, i) == 1 && is_constant(coefficients(f, i)[1])) return i;
    return std::nullopt;
  }

  [[nodiscard]] Place12 place_of(const NodeResult& n) const {
    const Place& p = n.node.place;
    if (!p.as.empty() || !p.roots.empty() || !p.of.empty() || !p.time.empty())
      throw DomainError("a change of variables beside strata");
    Place12 x;
    const System base = system_of(t_.theorem, directory_, p.at);
    std::vector<Json> rows;
    for (const std::string& name : family_.parameters()) {
      const auto value = base.values.find(name);
      if (std::ranges::none_of(p.at, [&](const auto& v) { return v.first == name; })) continue;
      if (value == base.values.end()) throw DomainError(name + " has no value");
      const MFraction f = is_zero(value->second) ? MFraction(MPoly(family_.ring()))
                                                 : transfer(value->second, family_.ring());
      if (!is_zero(f) && !is_constant(f.den()))
        throw DomainError(name + " is put to a quotient of parameters");
      const Integer d = is_zero(f) ? Integer(1) : f.den().coefficient(0);
      const std::size_t i = family_.ring()->index(name);
      x.values[i] = {is_zero(f) ? MPoly(family_.ring()) : f.num(), d};
      x.put[i] = f;
      rows.push_back(json_list({json_text(name), certify::to_json(x.values[i])}));
      x.equations.push_back(
          {certify::scaled(MPoly::variable(family_.ring(), i), d) - x.values[i].p, Sign::zero});
    }
    x.at = json_list(std::move(rows));
    for (const Condition& c : conditions_of(family_.system(), p))
      x.region.push_back(family_.moved(c));
    put_given(x);
    return x;
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
    if (excludes) add_images(r.part, std::nullopt, r.conditions);
    regions_.push_back(std::move(r));
    parts_.push_back(id);
  }

  // ---- excluded, by a certificate of its own

  void put_case(const NodeResult& n) {
    const Place12 x = place_of(n);
    std::string why = "the step has no certificate";
    for (const std::string& json : n.certificates) {
      try {
        const BundleTarget y = target_of(json);
        std::vector<Json> shown = shown_of(y, x);
        put_step(certificate_step(n.node.id), "certificate",
                 {{"certificate", certify::parse_json(json, 512)}});
        put_step(n.node.id, "stratum",
                 {{"of", json_text(certificate_step(n.node.id))},
                  {"system", json_text(name_)},
                  {"at", x.at},
                  {"region", json_conditions(x.region)},
                  {"shown", json_list(std::move(shown))}});
        return add_region(n.node.id, x);
      } catch (const Error& no) {
        why = no.what();
      }
    }
    throw DomainError(why);
  }

  // The parts of f by the monomials in the levels, in the order of the judge.
  [[nodiscard]] std::vector<std::pair<Exponents, MPoly>> by_levels(const MPoly& f) const {
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

  std::vector<Json> shown_of(const BundleTarget& y, const Place12& x) const {
    std::vector<Json> all;
    for (const BundleAsked& c : y.asked) {
      if (c.real) continue;
      const MPoly& f = c.choices.empty() ? MPoly(family_.ring()) : c.choices.front();
      const bool has_sign = c.sign == Sign::positive || c.sign == Sign::nonnegative;
      if (!c.group && has_sign) {
        const auto used = used_variables(f);
        if (used.size() == 1 && is_level(f.ring()->name(used.front()))) continue;
      }
      std::optional<Json> node;
      if (!c.group && c.sign != Sign::nonzero) {
        node = proof_.shown(x.given, {by_levels(f).front().second, c.sign});
      } else {
        auto zeros = x.given;
        for (const MPoly& g : c.choices)
          for (const auto& [levels, part] : by_levels(g))
            zeros.push_back({part, Sign::zero});
        if (c.choices.empty()) zeros.push_back({MPoly(family_.ring()), Sign::zero});
        node = proof_.contradiction(zeros);
      }
      if (!node)
        throw DomainError("it is not shown that " + brief(MFraction(f), 80) +
                          (c.group ? " and others do not vanish together" : " has its sign"));
      all.push_back(*std::move(node));
    }
    return all;
  }

  // ---- integrable

  void put_integrable(const NodeResult& n) {
    const Place12 x = place_of(n);
    const System s = read_system(document_of(n.node, directory_), n.node.where);
    const certify::FamilyStratum stratum{&checked_, x.values, x.region};
    certify::ClaimedIntegrals c;
    c.family = &checked_;
    std::vector<Json> claims, fields;
    for (const SystemClaim& claim : s.claims) {
      if (claim.kind != SystemClaim::Kind::integral || !claim.on.empty()) continue;
      const certify::PhaseFunction f = function(s, claim.value);
      c.claims.emplace_back(claim.name, in_judge(f));
      claims.push_back(
          Json{Json::Object{{"name", json_text(claim.name)}, {"value", certify::to_json(f)}}});
    }
    for (const auto& row : n.node.fields) {
      std::vector<Json> entries;
      c.fields.emplace_back();
      for (const std::string& text : row) {
        const certify::PhaseFunction f = function(s, formula(s, text), false);
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
  certify::PhaseFunction function(const System& s, const MFraction& f, bool any_multiple = true) {
    if (is_zero(f)) return {MPoly(family_.ring()), Integer(1)};
    const auto used = used_variables(f.den());
    const auto& p = s.field.parameters;
    const bool is_parametric =
        std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, p); });
    const MFraction g = any_multiple && is_parametric ? MFraction(f.num()) : f;
    return family_.written(transfer(g, family_.system().ring()));
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
    Budget little = budget_;
    constexpr double most_work = 1e8;
    if (!little.work_end || meter() + most_work < *little.work_end) little.give(most_work);
    try {
      return tree_of_regions(family_.proof(little), there, others, little).has_value();
    } catch (const OutOfBudget&) {
      budget_.check();
      return false;
    }
  }
  void put_groups() {
    drop_what_is_covered();
    for (const Group& g : trusted_)
      put_group(g);
    if (open_.regions.empty()) return;
    put_step("open", "open", {{"system", json_text(name_)}, {"regions", put_regions(open_)}});
    parts_.emplace_back("open");
  }
  /// A region of which a symmetry sends other points into it, of a part that says "not integrable".
  struct Image {
    std::size_t part = 0;
    std::optional<std::size_t> region;
    std::vector<Condition> conditions; ///< of the points
    std::size_t symmetry = 0;
  };
  void add_images(std::size_t part, std::optional<std::size_t> region,
                  const std::vector<Condition>& conditions) {
    for (std::size_t s = 0; s < symmetries_.size(); ++s)
      images_.push_back({part, region, symmetries_.before(s, conditions), s});
  }
  // A region that a symmetry maps into an earlier one is proved as that one is.
  [[nodiscard]] std::optional<RegionOfPart> image_of(const std::vector<Condition>& region) {
    for (const Image& x : images_) {
      if (!implies(region, x.conditions)) continue;
      if (const auto k = symmetries_.use(x.symmetry))
        return RegionOfPart{x.part, x.region, x.conditions, {*k}};
    }
    return std::nullopt;
  }
  [[nodiscard]] bool implies(const std::vector<Condition>& region,
                             const std::vector<Condition>& wanted) const {
    std::vector<MPoly> equations;
    for (const Condition& c : region)
      if (c.sign == Sign::zero) equations.push_back(c.p);
    certify::Arithmetic a;
    const auto is_stated = [&](const Condition& c, const std::vector<Condition>& all) {
      return std::ranges::any_of(all, [&](const Condition& d) {
        return c.sign == d.sign && (c.p == d.p || (c.sign != Sign::positive &&
                                                   c.sign != Sign::nonnegative && c.p == -d.p));
      });
    };
    for (const Condition& c : wanted)
      if (c.sign == Sign::zero && !is_zero(certify::modulo_equations(c.p, equations, a)))
        return false;
    auto given = family_.assumptions();
    given.insert(given.end(), region.begin(), region.end());
    return std::ranges::all_of(wanted, [&](const Condition& c) {
      return c.sign == Sign::zero || is_stated(c, given) || proof_.shown(given, c).has_value();
    });
  }
  void put_group(Group g) {
    if (!g.integrable)
      for (std::size_t k = 0; k < g.regions.size();) {
        if (auto image = image_of(g.regions[k])) {
          regions_.push_back(*std::move(image));
          g.regions.erase(g.regions.begin() + static_cast<long>(k));
          continue;
        }
        add_images(parts_.size(), k, g.regions[k]);
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

  const TheoremResult& t_;
  std::string directory_;
  const std::map<std::string, std::string>& refused_;
  const Budget& budget_;
  StrataFamily family_;
  std::string name_;
  ComplexProof proof_;
  Json json_;
  BundleSymmetries symmetries_;
  std::vector<Image> images_;
  certify::Family checked_;
  std::vector<Json> steps_;
  std::vector<std::string> parts_;
  std::vector<RegionOfPart> regions_;
  std::vector<Group> trusted_;
  std::map<std::string, std::size_t> darboux_steps_; ///< of a node
  std::set<std::string> looked_at_; ///< nodes of which some Darboux points are not enough
  StepsOnTrust on_trust_;
  std::vector<std::string> carried_;
  Group open_;
};

} // namespace

BundleOfStrata bundle_of_strata(const TheoremResult& t, const std::string& directory,
                                const std::map<std::string, std::string>& refused,
                                const Budget& budget) {
  StrataBundle bundle(t, directory, refused, budget);
  try {
    return bundle();
  } catch (const DomainError&) {
    if (!bundle.has_symmetries()) throw;
  }
  auto none = refused;
  none.emplace(all_symmetries, "the cover");
  return StrataBundle(t, directory, none, budget)();
}

} // namespace kov
