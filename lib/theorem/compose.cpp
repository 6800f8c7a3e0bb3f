// How steps are put together: the place of a step, and the cover of parameters by regions.
// docs/theory/composition.md

#include "certify/theorem/fact.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"
#include "symbol/suggest.hpp"
#include "system/claims.hpp"
#include "theorem/bundle_family.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include <algorithm>

namespace kov {

const NodeResult* node_with(const TheoremResult& result, const std::string& id) {
  for (const NodeResult& n : result.nodes)
    if (n.node.id == id) return &n;
  return nullptr;
}

namespace {

constexpr std::size_t most_symmetries = 48;

bool has_system(const NodeResult& n) {
  using enum NodeKind;
  return n.node.kind != argument && n.node.kind != cover &&
         (n.node.kind != theorem || (n.node.theorem != nullptr && !n.node.theorem->system.empty()));
}

System system_of(const NodeResult& n, const std::string& directory) {
  System s = n.node.kind == NodeKind::theorem
                 ? read_system(parse_document(n.node.theorem->system, n.node.theorem->id))
                 : read_system(beside(directory, n.node.file), n.node.where);
  for (const std::string& text : n.domain)
    s.assumptions.push_back(condition(s, text));
  if (!n.domain.empty()) // a criterion about a real system
    for (const std::size_t i : s.field.parameters)
      s.real.insert(s.ring()->name(i));
  return s;
}

// The file of the system that the step speaks about.
std::string base_of(const NodeResult& n, const TheoremResult& result,
                    const std::string& directory) {
  if (n.node.place.of.empty()) return beside(directory, result.theorem.system);
  for (const TheoremNode& other : result.theorem.nodes)
    if (other.id == n.node.place.of && other.kind == NodeKind::lowest_order) {
      if (!other.where.empty() || !other.place.at.empty() || !other.place.conditions.empty())
        throw DomainError("'" + other.id + "' is not for all parameters");
      return beside(directory, other.other);
    }
  throw DomainError("'" + n.node.place.of + "' is not a step of kind lowest-order");
}

void unbind(NodeResult& n, const std::string& why) {
  n.summary = "NOT CHECKED to be about the theorem's system: " + why +
              (n.summary.empty() ? "" : ". Computed: " + n.summary);
  if (n.status == NodeStatus::proved || n.status == NodeStatus::trusted)
    n.status = NodeStatus::unbound;
  n.says = Conclusion::none;
}

std::string text_of(const Assumptions& r) {
  return r.conditions.empty() ? "all parameters" : to_string(r.conditions);
}

/// A product of symmetries, and the values of the parameters that it leads to.
struct Product {
  std::vector<std::size_t> word;
  Substitution put;
};

// The group that the symmetries of the theorem generate, on the parameters; each is checked.
std::vector<Product> products(NodeResult& n, const Theorem& t, const BundleFamily& whole,
                              const std::string& path) {
  const Ring& ring = whole.ring();
  std::vector<Substitution> letters;
  std::vector<Product> all(1);
  for (const std::string& p : whole.parameters())
    all.front().put[ring->index(p)] = MFraction::variable(ring, p);
  for (const Symmetry& s : t.symmetries) {
    Place place;
    place.as = s.as;
    const std::string name = s.title.empty() ? "a symmetry" : s.title;
    for (const auto& [variable, value] : s.as)
      if (whole.system().values.contains(variable))
        throw DomainError(name + " changes " + variable + ", which the file of the system fixes");
    const Located found = locate(path, path, whole.system(), place);
    n.checks.push_back({name + " maps the system to itself", found.objection.empty()});
    if (!found.objection.empty())
      throw DomainError(name + " is not a symmetry of the system: " + found.objection);
    n.symmetries.push_back(*found.map);
    letters.emplace_back();
    for (const auto& [i, same] : all.front().put) {
      const MFraction value = transfer(found.map->values.at(ring->name(i)), ring);
      if (!is_constant(value.den())) throw DomainError(name + " divides by parameters");
      letters.back()[i] = value;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < letters.size(); ++k) {
      Product next = all[i];
      next.word.push_back(k);
      for (auto& [x, value] : next.put)
        value = substitute(value, letters[k]);
      if (std::ranges::none_of(all, [&](const Product& p) { return p.put == next.put; }))
        all.push_back(std::move(next));
      if (all.size() > most_symmetries) throw DomainError("the symmetries generate too many maps");
    }
  return all;
}

// Why a need adds nothing to a cover, or nothing.
std::string adds_nothing(const NodeResult& part) {
  if (part.node.kind == NodeKind::open_part) return "";
  if (part.status != NodeStatus::proved && part.status != NodeStatus::trusted)
    return "it is " + to_string(part.status);
  if (part.says == Conclusion::none) return "it says nothing about integrability";
  return "";
}

} // namespace

namespace {

// The step reads the theorem's own file, with the same values: nothing has to be compared.  (The
// file of a lowest-order system may assume more than the theorem's.)
bool is_the_same_file(const NodeResult& n, const std::string& whole, const std::string& directory) {
  const Place& p = n.node.place;
  return p.of.empty() && n.domain.empty() && n.node.kind != NodeKind::theorem &&
         beside(directory, n.node.file) == whole && n.node.where == p.at && p.as.empty() &&
         p.roots.empty() && p.time.empty();
}

void settle(NodeResult& n, const TheoremResult& result, const std::string& directory) {
  const std::string whole = beside(directory, result.theorem.system);
  const std::string base = base_of(n, result, directory);
  if (n.node.kind == NodeKind::splitting && !n.node.place.roots.empty())
    return unbind(n, "the criterion is about the real system, and a root may be complex");
  if (is_the_same_file(n, whole, directory)) {
    n.region = region_of(system_of(result.theorem, directory), n.node.place);
    return;
  }
  Located found = locate(whole, base, system_of(n, directory), n.node.place);
  for (CheckedIdentity& c : found.checks)
    n.checks.push_back(std::move(c));
  n.trusted.insert(n.trusted.end(), found.trusted.begin(), found.trusted.end());
  n.region = std::move(found.region);
  n.map = std::move(found.map);
  if (!found.objection.empty()) unbind(n, found.objection);
}

} // namespace

// Are the lowest-order parts of integrals that are of this class and meromorphic near the origin of
// this class?
bool has_lowest_parts(const IntegralClass& c) {
  return has_rational_functions(c) || (c.kind == IntegralClass::Kind::real_analytic &&
                                       c.near == IntegralClass::Near::phase_space);
}

// An integral that is analytic at the origin has a polynomial as lowest-order part, a meromorphic
// one a rational function; both belong to the class that is excluded, besides that at the origin.
void transport_from_lowest_order(NodeResult& n) {
  n.theorems.push_back(used(ziglin_1982()));
  std::erase_if(n.excluded, has_rational_functions);
  n.excluded.push_back(ziglin_1982().integrals);
}

namespace {

// Settles the regions of a step on trust, or of an open part: lists of conditions.
void settle_regions(NodeResult& n, const TheoremResult& result, const std::string& directory) {
  if (result.theorem.system.empty())
    return unbind(n, "the theorem file names no system (system = \"...\")");
  const System whole = system_of(result.theorem, directory);
  for (const auto& conditions : n.node.regions) {
    Place place;
    place.conditions = conditions;
    n.regions.push_back(region_of(whole, place));
  }
  if (n.regions.empty()) n.regions.push_back(region_of(whole, {}));
}

} // namespace

void settle_place(NodeResult& n, const TheoremResult& result, const std::string& directory) {
  if (n.node.kind == NodeKind::trusted || n.node.kind == NodeKind::open_part)
    return settle_regions(n, result, directory);
  if (!has_system(n) || (n.status != NodeStatus::proved && n.status != NodeStatus::trusted)) return;
  if (result.theorem.system.empty())
    return unbind(n, "the theorem file names no system (system = \"...\")");
  try {
    settle(n, result, directory);
    if (n.status == NodeStatus::unbound) return;
    if (!n.node.place.of.empty() && n.says == Conclusion::has_integral) n.says = Conclusion::none;
    if (!n.node.place.of.empty() && n.says == Conclusion::not_integrable) {
      if (std::ranges::any_of(n.excluded, &IntegralClass::on_leaf))
        return unbind(n, "it is about integrals that are independent on one symplectic leaf, and "
                         "their lowest-order parts need not be so there");
      if (!std::ranges::all_of(n.excluded, has_lowest_parts))
        return unbind(n,
                      "no proof is known that lowest-order parts of integrals of the class that it "
                      "excludes are of that class");
      transport_from_lowest_order(n);
    }
    if (!n.statement.empty() && !n.region.conditions.empty())
      n.statement += ". In the parameters of the theorem: " + text_of(n.region);
  } catch (const DomainError& why) {
    unbind(n, why.what());
  }
}

namespace {

// The statements of the needs of a cover, put together.
struct Pieces {
  std::vector<std::string> parts; ///< that say something
  std::vector<RegionOfPart> regions;
  std::vector<std::string> exceptions, idle, curves;
  std::vector<std::string> integrable, open; ///< strata
};

// A region that the statement says nothing about, and why; the step writes its integrals with the
// names of its own file.
std::string exception(const NodeResult& part) {
  std::string text = text_of(part.region);
  if (part.integrals.empty()) return text;
  text += ", where " + part.integrals;
  return part.node.place.as.empty() ? text : text + " in the coordinates of " + part.node.file;
}

// ", along the phase curve of N"
std::string on_a_curve(const NodeResult& part) {
  return part.curve.empty() ? "" : ", along the phase curve of " + part.curve;
}

// The points that products of symmetries send to the region of the part.
void add_images(Pieces& all, const std::vector<Condition>& region,
                const std::vector<Product>& products) {
  for (const Product& p : products) {
    all.regions.push_back({all.parts.size(), std::nullopt, region, p.word});
    for (Condition& c : all.regions.back().conditions)
      c.p = substitute(c.p, p.put).num();
  }
}

void add(Pieces& all, NodeResult& n, const NodeResult& part) {
  all.parts.push_back(part.node.id);
  const bool excluded = part.says == Conclusion::not_integrable;
  if (!n.tables.empty())
    n.tables.back().rows.push_back(
        {part.node.title, text_of(part.region),
         excluded                 ? "not integrable" + on_a_curve(part)
         : part.integrals.empty() ? "no integral besides those that every system of its kind has"
                                  : part.integrals});
  n.excluded.insert(n.excluded.end(), part.excluded.begin(), part.excluded.end());
  if (excluded && !part.curve.empty()) add_once(all.curves, part.curve);
  if (!excluded)
    all.exceptions.push_back(exception(part));
  else if (!part.integrals.empty()) // of a cover
    all.exceptions.push_back(part.integrals);
  for (const Assumptions& r : regions_of(part))
    if (!excluded)
      add_once(part.node.kind == NodeKind::open_part ? all.open : all.integrable,
               "(" + text_of(r) + ")");
}

Pieces pieces(NodeResult& n, const TheoremResult& result, const BundleFamily& whole,
              const std::string& directory) {
  Pieces all;
  const auto maps = products(n, result.theorem, whole, beside(directory, result.theorem.system));
  if (!is_of_strata(result.theorem))
    n.tables.push_back(
        {"Regions of the parameters, up to " +
             (maps.size() == 1 ? "1 symmetry" : std::to_string(maps.size()) + " symmetries"),
         {"step", "region", "there"},
         {}});
  for (const std::string& id : n.node.needs) {
    const NodeResult& part = *node_with(result, id);
    const auto why = adds_nothing(part);
    if (!why.empty()) {
      all.idle.push_back(part.node.title + " (" + why + ")");
      continue;
    }
    const Place& place = part.node.place;
    const auto as_judged = tried<DomainError>([&] { // else a parameter is a quotient there
      const System base = system_of(result.theorem, directory, place.at);
      return std::optional(whole.placed(place, base).conditions());
    });
    for (const Assumptions& r : regions_of(part))
      add_images(all, part.regions.empty() && as_judged ? *as_judged : whole.moved(r.conditions),
                 maps);
    add(all, n, part);
  }
  if (!all.idle.empty()) n.formulas.push_back({"steps that add no region", joined(all.idle, "; ")});
  return all;
}

// The affine map y = S x + s, s != 0.
bool moves_origin(const PlaceMap& map, const VectorField& v) {
  Substitution origin;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    origin[map.ring->index(v.name(j))] = MFraction(map.ring);
  return std::ranges::any_of(v.coordinates, [&](std::size_t i) {
    return !is_zero(substitute(map.values.at(v.ring->name(i)), origin));
  });
}

// A class of integrals near the origin is one near its image.
void need_origin(const NodeResult& n, const VectorField& v) {
  const auto& near = ziglin_1982().integrals;
  if (!is_among(near, n.excluded)) return;
  for (const PlaceMap& map : n.symmetries)
    if (moves_origin(map, v))
      throw DomainError(
          "a symmetry moves the origin, and a step excludes first integrals that are " +
          sentence(near));
}

// "The system", or "The system, where e != 7,"
std::string named(const NodeResult& n, const System& whole) {
  return assumptions_of(whole) + "The system" +
         (n.region.conditions.empty() ? "" : ", where " + text_of(n.region) + ",");
}

void state(NodeResult& n, const System& whole, bool has_symmetries) {
  n.statement = named(n, whole);
  n.excluded = at_once(n.excluded);
  n.statement += " is not integrable with " + first_integrals(n.excluded);
  if (!n.curve.empty()) n.statement += " (those of the steps)";
  if (!n.integrals.empty())
    n.statement += ", except possibly when " + n.integrals +
                   (has_symmetries ? " (or in an image of these cases under the symmetries)" : "");
}

// The same of strata: each set that the sentence leaves out is named.
void state_of_strata(NodeResult& n, const System& whole, const Pieces& found) {
  n.excluded = at_once(n.excluded);
  const std::string integrable = joined(found.integrable, ", or "),
                    open = joined(found.open, ", or ");
  n.statement = named(n, whole) + " is ";
  if (n.excluded.empty())
    n.statement +=
        "integrable" + (open.empty() ? "" : " where " + integrable + "; nothing is said elsewhere");
  else
    n.statement +=
        "not integrable with " + first_integrals(n.excluded) +
        (integrable.empty() ? "" : ", except in these cases, where it is: " + integrable) +
        (open.empty() ? ""
                      : std::string(integrable.empty() ? ", except" : ", and except") +
                            " in these cases, of which nothing is said: " + open);
}

// The system of a theorem about real parameters.
System real_system(const System& whole, const Assumptions& region) {
  auto real = assumptions_on(whole, whole.ring()).real;
  add_each_once(real, region.real);
  for (const std::size_t i : whole.field.parameters)
    if (!is_among(i, real))
      throw DomainError("the parameter " + whole.ring()->name(i) +
                        " is not assumed to be real: a cover is decided for real parameters");
  return with_real_parameters(whole);
}

} // namespace

std::vector<Assumptions> regions_of(const NodeResult& n) {
  return n.regions.empty() ? std::vector<Assumptions>{n.region} : n.regions;
}

void prove_cover(NodeResult& n, const TheoremResult& result, const std::string& directory,
                 const std::stop_token& stop) {
  if (result.theorem.system.empty()) throw DomainError("the theorem file names no system");
  const bool of_strata = is_of_strata(result.theorem);
  const System whole = system_of(result.theorem, directory);
  n.region = region_of(whole, n.node.place);
  const BundleFamily family(of_strata ? whole : real_system(whole, n.region),
                            result.theorem.system);
  const Pieces found = pieces(n, result, family, directory);
  need_origin(n, whole.field);
  Budget budget;
  budget.stop = stop;
  budget.give(2e9);
  const auto proof = family.proof(budget);
  const auto known = family.known_where(family.moved(n.region.conditions));
  if (tree_of_regions(proof, known, {}, budget))
    throw DomainError("no parameters satisfy what the system assumes");
  std::vector<Condition> gap;
  auto tree = tree_of_regions(proof, known, found.regions, budget, &gap);
  const bool says_nothing = n.excluded.empty() && (!of_strata || found.integrable.empty());
  n.status = tree && !says_nothing ? NodeStatus::proved : NodeStatus::open;
  n.summary = !tree ? "it was not shown that the steps cover the parameters: what of " +
                          (gap.empty() ? "all of them" : to_string(gap)) + "?"
              : says_nothing && of_strata ? "no step says anything of the parameters"
              : says_nothing ? "no step says that the system is not integrable somewhere"
                             : "the regions of " + std::to_string(found.parts.size()) +
                                   " steps cover the parameters";
  if (n.status == NodeStatus::open) return;
  n.says = n.excluded.empty() ? Conclusion::has_integral : Conclusion::not_integrable;
  n.cover = TreeOfSteps{found.parts, *std::move(tree)};
  n.checks.push_back({"the regions of the steps cover the parameters", true});
  if (!found.open.empty()) n.summary += ", and nothing is said of " + joined(found.open, ", or ");
  if (of_strata) return state_of_strata(n, whole, found);
  n.integrals = joined(found.exceptions, "; or when ");
  n.curve = joined(found.curves, "; ");
  state(n, whole, !n.symmetries.empty());
}

void prove_theorem(NodeResult& n) {
  n.status = NodeStatus::trusted;
  if (!n.node.theorem) return;
  const LiteratureTheorem& t = *n.node.theorem;
  n.theorems.push_back(used(t));
  n.statement = t.statement.substr(0, t.statement.find_last_not_of('.') + 1);
  if (t.system.empty()) return;
  n.says = Conclusion::not_integrable;
  n.excluded = {t.integrals};
}

} // namespace kov
