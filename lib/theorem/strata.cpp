#include "theorem/strata.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "integrability/preserved_relations.hpp"
#include "theorem/bundle_place.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include <algorithm>

namespace kov {
namespace {

System without_levels(System s) {
  const auto levels = level_parameters(s);
  std::erase_if(s.field.parameters, [&](std::size_t i) { return is_among(i, levels); });
  std::erase_if(s.field.parameters,
                [&](std::size_t i) { return s.values.contains(s.ring()->name(i)); });
  return s;
}

bool has_bracket(const VectorField& v) { return v.poisson && v.hamiltonian; }

certify::PhaseSystem phase_system(const VectorField& v, PhaseWriter& writer) {
  certify::PhaseSystem x;
  x.ring = writer.ring();
  x.dimension = v.dimension();
  for (const FunctionSymbol& f : v.functions) {
    certify::PhaseSymbol& symbol = x.functions.emplace_back();
    symbol.meaning = f.meaning;
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (!is_zero(f.gradient[j])) symbol.gradient.emplace_back(j, writer.write(f.gradient[j]));
  }
  for (std::size_t i = 0; i < v.constants.size(); ++i)
    x.functions.push_back({"an algebraic constant", {}});
  for (const MPoly& d : writer.divisors())
    x.inverses.push_back(writer.moved(d));
  for (const MPoly& r : v.relations)
    x.relations.push_back(writer.moved(r));
  if (!has_bracket(v)) {
    for (const MFraction& f : v.components)
      x.field.push_back(writer.write(f));
    return x;
  }
  x.hamiltonian = writer.write(*v.hamiltonian);
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t j = i + 1; j < v.dimension(); ++j)
      if (const MFraction& p = (*v.poisson)[i][j]; !is_zero(p))
        x.brackets.push_back({i, j, writer.write(p)});
  return x;
}

void divide_all(const VectorField& v, PhaseWriter& writer) {
  const auto divide = [&](const MFraction& f) {
    if (!is_zero(f)) writer.divide(f);
  };
  if (has_bracket(v)) {
    divide(*v.hamiltonian);
    for (const auto& row : *v.poisson)
      for (const MFraction& f : row)
        divide(f);
  } else {
    for (const MFraction& f : v.components)
      divide(f);
  }
  for (const FunctionSymbol& f : v.functions)
    for (const MFraction& g : f.gradient)
      divide(g);
}

} // namespace

StrataFamily::StrataFamily(System s) : s_(without_levels(std::move(s))), writer_(s_) {
  s_.field = with_preserved_relations(s_.field);
  divide_all(s_.field, writer_);
  writer_.make_ring();
  phase_ = phase_system(s_.field, writer_);
  complex_.assign(ring()->size(), false);
  for (const std::size_t i : s_.field.parameters)
    complex_[ring()->index(s_.ring()->name(i))] = !s_.real.contains(s_.ring()->name(i));
  assume();
}

std::vector<std::string> StrataFamily::parameters() const {
  const auto& names = ring()->names();
  return {names.begin() + static_cast<long>(phase_.first_parameter()), names.end()};
}

Condition StrataFamily::moved(const Condition& c) const {
  return {is_zero(c.p) ? MPoly(ring()) : transfer(MFraction(c.p), ring()).num(), c.sign};
}

// Assumes what the file says of these parameters, and that the system has values there.
void StrataFamily::assume() {
  const auto add = [&](const MPoly& p, Sign sign) {
    const auto used = used_variables(p);
    for (const std::size_t i : used)
      if (!is_among(i, s_.field.parameters)) return; // of a level
    const auto is_known = [&](const Condition& c) { return is_among(c, assumptions_); };
    const Condition c = moved({p, sign});
    const bool is_positive = sign == Sign::nonzero && is_known({c.p, Sign::positive});
    if (!is_constant(c.p) && !is_known(c) && !is_positive) assumptions_.push_back(c);
  };
  using Relation = Assumption::Relation;
  for (const Assumption& a : s_.assumptions) {
    if (!is_constant(a.value.den())) add(a.value.den(), Sign::nonzero);
    const MPoly p = is_constant(a.value.den()) ? a.value.num() : a.value.num() * a.value.den();
    if (a.relation == Relation::zero) add(a.value.num(), Sign::zero);
    if (a.relation == Relation::nonzero) add(a.value.num(), Sign::nonzero);
    if (a.relation == Relation::positive) add(p, Sign::positive);
    if (a.relation == Relation::nonnegative) add(p, Sign::nonnegative);
  }
  for (const MPoly& p : s_.domain.nonzero())
    add(p, Sign::nonzero);
}

certify::PhaseFunction StrataFamily::written(const MFraction& f) {
  if (is_zero(f)) return {MPoly(ring()), Integer(1)};
  const std::size_t known = writer_.divisors().size();
  PhaseWriter trial = writer_;
  trial.divide(f);
  if (trial.divisors().size() != known) throw DomainError("a denominator that the system has not");
  return writer_.write(f);
}

Json StrataFamily::json(const std::string& name) const {
  std::vector<Json> names, complex;
  for (const std::string& p : parameters()) {
    names.push_back(json_text(p));
    if (complex_[ring()->index(p)]) complex.push_back(json_text(p));
  }
  return Json{Json::Object{{"name", json_text(name)},
                           {"parameters", json_list(std::move(names))},
                           {"complex", json_list(std::move(complex))},
                           {"system", certify::to_json(phase_)},
                           {"assumptions", json_conditions(assumptions_)}}};
}

std::vector<ParameterRegion> regions_of(const NodeResult& n) {
  return n.regions.empty() ? std::vector<ParameterRegion>{n.region} : n.regions;
}

namespace {

void add_set(const std::string& text, std::vector<std::string>& all) { add_once(all, text); }

// Each set that the sentence leaves out is named.
std::string statement_of_strata(const std::vector<IntegralClass>& excluded,
                                const std::vector<std::string>& integrable,
                                const std::vector<std::string>& open) {
  if (excluded.empty())
    return " is integrable" +
           (open.empty() ? std::string()
                         : " where " + joined(integrable, ", or ") + "; nothing is said elsewhere");
  std::string text = " is not integrable with " + first_integrals(excluded);
  if (!integrable.empty())
    text += ", except in these cases, where it is: " + joined(integrable, ", or ");
  if (!open.empty())
    text += std::string(integrable.empty() ? ", except" : ", and except") +
            " in these cases, of which nothing is said: " + joined(open, ", or ");
  return text;
}

} // namespace

void prove_cover_of_strata(NodeResult& n, const TheoremResult& result, const std::string& directory,
                           const std::stop_token& stop) {
  const StrataFamily whole(system_of(result.theorem, directory));
  Budget budget;
  budget.stop = stop;
  budget.give(2e9);
  std::vector<RegionOfPart> regions;
  std::vector<std::string> integrable, open;
  n.excluded.clear();
  for (std::size_t k = 0; k < n.node.needs.size(); ++k) {
    const NodeResult& part = *node_with(result, n.node.needs[k]);
    if (part.node.kind != NodeKind::open_part &&
        (part.says == Conclusion::none ||
         (part.status != NodeStatus::proved && part.status != NodeStatus::trusted)))
      continue;
    n.excluded.insert(n.excluded.end(), part.excluded.begin(), part.excluded.end());
    for (const ParameterRegion& r : regions_of(part)) {
      RegionOfPart one{k, std::nullopt, {}};
      for (const Condition& c : r.conditions)
        one.conditions.push_back(whole.moved(c));
      regions.push_back(std::move(one));
      const std::string text = r.conditions.empty() ? "all parameters" : to_string(r.conditions);
      if (part.says == Conclusion::has_integral) add_set("(" + text + ")", integrable);
      if (part.node.kind == NodeKind::open_part) add_set("(" + text + ")", open);
    }
  }
  std::vector<Condition> gap;
  const auto tree =
      tree_of_regions(whole.proof(budget), whole.assumptions(), regions, budget, &gap);
  if (!tree) {
    n.status = NodeStatus::open;
    n.summary = "it was not shown that the steps cover the parameters: what of " +
                (gap.empty() ? std::string("all of them") : to_string(gap)) + "?";
    return;
  }
  if (integrable.empty() && n.excluded.empty()) {
    n.status = NodeStatus::open;
    n.summary = "no step says anything of the parameters";
    return;
  }
  n.status = NodeStatus::proved;
  n.excluded = at_once(n.excluded);
  n.checks.push_back({"the strata of the steps cover the parameters", true});
  n.summary =
      "the strata of " + std::to_string(n.node.needs.size()) + " steps cover the parameters";
  if (!open.empty()) n.summary += ", and nothing is said of " + joined(open, ", or ");
  n.says = n.excluded.empty() ? Conclusion::has_integral : Conclusion::not_integrable;
  n.statement = assumptions_of(whole.system()) + "The system of " + result.theorem.system +
                statement_of_strata(n.excluded, integrable, open);
}

} // namespace kov
