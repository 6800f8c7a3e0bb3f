// How steps are put together: the place of a step, and the cover of parameters by regions.
// docs/theory/composition.md

#include "certify/theorem/fact.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "parameters/reals.hpp"
#include "symbol/suggest.hpp"
#include "system/claims.hpp"
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

// Linear maps of the parameters, as the values of all names of the ring.
using ParameterMap = std::vector<MFraction>;

ParameterMap identity(const Ring& ring) {
  ParameterMap map;
  for (std::size_t i = 0; i < ring->size(); ++i)
    map.push_back(MFraction::variable(ring, i));
  return map;
}

Substitution as_substitution(const ParameterMap& map) {
  Substitution put;
  for (std::size_t i = 0; i < map.size(); ++i)
    put[i] = map[i];
  return put;
}

ParameterMap after(const ParameterMap& f, const ParameterMap& g) {
  ParameterMap all;
  for (const MFraction& x : f)
    all.push_back(substitute(x, as_substitution(g)));
  return all;
}

// The group that the symmetries of the theorem generate, on the parameters; each is checked.
std::vector<ParameterMap> symmetries(NodeResult& n, const Theorem& t, const System& whole,
                                     const std::string& path) {
  const Ring& ring = whole.ring();
  std::vector<ParameterMap> generators, all{identity(ring)};
  for (const Symmetry& s : t.symmetries) {
    Place place;
    place.as = s.as;
    const std::string name = s.title.empty() ? "a symmetry" : s.title;
    for (const auto& [variable, value] : s.as)
      if (whole.values.contains(variable))
        throw DomainError(name + " changes " + variable + ", which the file of the system fixes");
    const Located found = locate(path, path, whole, place);
    n.checks.push_back({name + " maps the system to itself", found.objection.empty()});
    if (!found.objection.empty())
      throw DomainError(name + " is not a symmetry of the system: " + found.objection);
    n.symmetries.push_back(*found.map);
    ParameterMap map = identity(ring);
    for (const auto& [variable, value] : s.as)
      map[ring->index(variable)] = formula(whole, value);
    generators.push_back(std::move(map));
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const ParameterMap& g : generators) {
      ParameterMap next = after(all[i], g);
      add_once(all, std::move(next));
      if (all.size() > most_symmetries) throw DomainError("the symmetries generate too many maps");
    }
  return all;
}

// The points that the map sends to the region.
std::vector<Condition> image(const Assumptions& region, const ParameterMap& map) {
  Assumptions there;
  for (const Condition& c : region.conditions)
    there.require(substitute(transfer(MFraction(c.p), map.front().ring()), as_substitution(map)),
                  c.sign);
  return there.conditions;
}

// A splitting holds for small parameters; a scaling carries it to all.
bool reaches_all(const NodeResult& n, const TheoremResult& result) {
  if (n.node.kind != NodeKind::splitting) return true;
  return std::ranges::any_of(n.node.needs, [&](const std::string& id) {
    const NodeResult& s = *node_with(result, id);
    return s.node.kind == NodeKind::scaling && s.status == NodeStatus::proved &&
           s.node.file == n.node.file && s.node.where == n.node.where &&
           s.node.small == n.node.small;
  });
}

// Why a need adds nothing to a cover, or nothing.
std::string adds_nothing(const NodeResult& part, const TheoremResult& result) {
  if (part.status != NodeStatus::proved && part.status != NodeStatus::trusted)
    return "it is " + to_string(part.status);
  if (part.says == Conclusion::none) return "it says nothing about integrability";
  if (!reaches_all(part, result)) return "it is for small parameters, and no scaling is needed";
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

// Lowest-order parts of integrals that are independent on a leaf need not be so on that leaf.
bool excludes_on_one_leaf(const NodeResult& n) {
  return std::ranges::any_of(n.excluded, [](const IntegralClass& c) { return c.on_leaf; });
}

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
      if (excludes_on_one_leaf(n))
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
  std::vector<std::vector<Condition>> regions;
  std::vector<std::string> exceptions, idle, curves;
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

void add(Pieces& all, NodeResult& n, const NodeResult& part,
         const std::vector<ParameterMap>& maps) {
  for (const ParameterMap& map : maps)
    all.regions.push_back(image(part.region, map));
  const bool excluded = part.says == Conclusion::not_integrable;
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
}

Pieces pieces(NodeResult& n, const TheoremResult& result, const std::vector<ParameterMap>& maps) {
  Pieces all;
  n.tables.push_back(
      {"Regions of the parameters, up to " +
           (maps.size() == 1 ? "1 symmetry" : std::to_string(maps.size()) + " symmetries"),
       {"step", "region", "there"},
       {}});
  for (const std::string& id : n.node.needs) {
    const NodeResult& part = *node_with(result, id);
    if (const auto why = adds_nothing(part, result); !why.empty())
      all.idle.push_back(part.node.title + " (" + why + ")");
    else
      add(all, n, part, maps);
  }
  if (!all.idle.empty()) n.formulas.push_back({"steps that add no region", joined(all.idle, "; ")});
  return all;
}

// The real parameters that the node speaks about.
std::vector<Condition> range_of(const NodeResult& n, const System& whole, const Budget& budget) {
  Assumptions known = assumptions_on(whole, whole.ring());
  for (const std::size_t i : n.region.real)
    known.declare_real(MFraction::variable(whole.ring(), i));
  for (const Condition& c : n.region.conditions)
    known.require(transfer(MFraction(c.p), whole.ring()), c.sign);
  for (const std::size_t i : whole.field.parameters)
    if (!is_among(i, known.real))
      throw DomainError("the parameter " + whole.ring()->name(i) +
                        " is not assumed to be real: a cover is decided for real parameters");
  if (has_real_point(known.conditions, budget) == Truth::no)
    throw DomainError("no parameters satisfy what the system assumes");
  return known.conditions;
}

// The affine map y = S x + s, s != 0.
bool moves_origin(const PlaceMap& map, const VectorField& v) {
  std::vector<std::size_t> coordinates;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    coordinates.push_back(map.ring->index(v.name(j)));
  const auto is_constant_term = [&](const std::vector<unsigned long>& e) {
    return std::ranges::all_of(coordinates, [&](std::size_t i) { return e[i] == 0; });
  };
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const MPoly& f = map.values.at(v.name(j)).num();
    for (long t = 0; t < f.length(); ++t)
      if (is_constant_term(f.exponents(t))) return true;
  }
  return false;
}

// A class of integrals near the origin is one near its image.
void need_origin(const NodeResult& n, const System& whole) {
  const auto& near = ziglin_1982().integrals;
  if (!is_among(near, n.excluded)) return;
  for (const PlaceMap& map : n.symmetries)
    if (moves_origin(map, whole.field))
      throw DomainError(
          "a symmetry moves the origin, and a step excludes first integrals that are " +
          sentence(near));
}

void state(NodeResult& n, const System& whole, bool has_symmetries) {
  n.statement = assumptions_of(whole) + "The system";
  if (!n.region.conditions.empty()) n.statement += ", where " + text_of(n.region) + ",";
  n.excluded = at_once(n.excluded);
  n.statement += " is not integrable with " + first_integrals(n.excluded);
  if (!n.curve.empty()) n.statement += " (those of the steps)";
  if (!n.integrals.empty())
    n.statement += ", except possibly when " + n.integrals +
                   (has_symmetries ? " (or in an image of these cases under the symmetries)" : "");
}

} // namespace

void prove_cover(NodeResult& n, const TheoremResult& result, const std::string& directory,
                 const std::stop_token& stop) {
  if (result.theorem.system.empty()) throw DomainError("the theorem file names no system");
  if (is_of_strata(result.theorem)) return prove_cover_of_strata(n, result, directory, stop);
  const std::string path = beside(directory, result.theorem.system);
  const System whole = read_system(path);
  const auto maps = symmetries(n, result.theorem, whole, path);
  const Pieces found = pieces(n, result, maps);
  need_origin(n, whole);
  n.region = region_of(whole, n.node.place);
  Budget z3;
  z3.stop = stop;
  const Covered covered = is_covered(range_of(n, whole, z3), found.regions, z3);
  if (covered.holds != Truth::yes || n.excluded.empty()) {
    n.status = NodeStatus::open;
    n.summary = covered.holds == Truth::no
                    ? "the steps do not cover the parameters: nothing is proved at " + covered.gap
                : covered.holds == Truth::unknown
                    ? "whether the steps cover the parameters was not decided"
                    : "no step says that the system is not integrable somewhere";
    return;
  }
  n.status = NodeStatus::proved;
  n.says = Conclusion::not_integrable;
  n.trusted.push_back({Trusted::Step::covered_by_z3});
  n.checks.push_back({"the regions of the steps cover the parameters", true});
  n.integrals = joined(found.exceptions, "; or when ");
  n.curve = joined(found.curves, "; ");
  state(n, whole, maps.size() > 1);
  n.summary = "the regions of " + std::to_string(n.tables.back().rows.size()) +
              " steps cover the parameters";
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
