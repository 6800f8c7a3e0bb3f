// A family that the separatrix criterion leaves to a case: is that case about these bodies?
//
// With the equations of the family and the units put in, the field of the splitting step must be
// that of the case, and what the case assumes must follow from A > B > C > 0.  Units (m = 1, L1 =
// 1) are units if for each of them there is a group of scalings x -> s^w x of the variables, the
// time and the parameters that moves it, leaves the others, and maps the field, the manifolds of
// the case with their levels and its assumptions to themselves.

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "moves/scalings.hpp"
#include "parameters/parametrised_set.hpp"
#include "system/claims.hpp"
#include "theorem/prove.hpp"

#include <algorithm>

namespace kov {
namespace {

// x -> -x changes nothing in the field.
bool even_in(const System& s, const std::string& name) {
  const std::size_t i = *s.ring()->find(name);
  return std::ranges::all_of(s.field.components, [&](const MFraction& f) {
    return substitute(f, {{i, -MFraction::variable(s.ring(), i)}}) == f;
  });
}

bool assumed_positive(const System& s, const std::string& name) {
  return std::ranges::any_of(s.assumptions, [&](const Assumption& a) {
    return a.is(Sign::positive) && a.value == MFraction::variable(s.ring(), *s.ring()->find(name));
  });
}

// The first of the units that is none, or nothing.
std::string no_unit(const System& family, const System& single, const ParameterValues& units) {
  std::vector<std::string> names = family.ring()->names();
  add_each_once(names, single.ring()->names());
  const Ring ring = make_ring(names);
  WeightEquations equations(ring);
  for (std::size_t j = 0; j < family.field.dimension(); ++j)
    equations.add(transfer(family.field.components[j], ring),
                  {{ring->index(family.field.name(j)), 1}, {equations.time(), 1}});
  for (const ManifoldSpec& m : single.manifolds)
    for (const auto* list : {&m.equations, &m.levels})
      for (const Equation& e : *list)
        equations.add_homogeneous(transfer(e.difference, ring));
  for (const Assumption& a : single.assumptions)
    equations.add_homogeneous(transfer(a.value, ring));
  // some scaling moves this parameter and none of the others
  const auto is_moved = [&](const std::string& name) {
    WeightEquations fixed = equations;
    for (const auto& [other, value] : units)
      if (other != name) fixed.add_row({{ring->index(other), 1}});
    return std::ranges::any_of(
        fixed.all(), [&](const auto& weights) { return !is_zero(weights[ring->index(name)]); });
  };
  for (const auto& [name, value] : units)
    if (value != "1" || !is_moved(name) ||
        (!even_in(family, name) && !assumed_positive(family, name)))
      return name;
  return "";
}

// The first thing that the case assumes and that does not follow from A > B > C > 0, or nothing.
std::string too_much_assumed(const System& single, const ParameterValues& members) {
  const auto moment = [&](const std::string& name) {
    for (const auto& [fixed, value] : members)
      if (fixed == name) return formula(single, value);
    return formula(single, name);
  };
  const MFraction a = moment("A"), b = moment("B"), c = moment("C");
  Assumptions known;
  for (const MFraction& f : {a, b, c})
    for (const std::size_t i : used_variables(f))
      known.declare_real(MFraction::variable(single.ring(), i));
  for (const MFraction& f : {a - b, b - c, c, b, a}) // the last two follow, and help
    known.require(f, Sign::positive);
  const ParametrisedSet region(single.ring(), known);
  for (const Assumption& x : single.assumptions) {
    const int sign = region.exact_sign_of(x.value.num()) * region.exact_sign_of(x.value.den());
    if (!x.holds_near(Rational(sign))) return x.text;
  }
  return "";
}

// Empty if the case is about the family with these equations, else why not.
std::string objection(const NodeResult& splitting, const LeftFamily& f,
                      const ParameterValues& members, const TheoremNode& by,
                      const std::string& directory) {
  ParameterValues values = splitting.node.where;
  values.insert(values.end(), members.begin(), members.end());
  const std::string path = beside(directory, splitting.node.file);
  const System family = read_system(path, values);
  const System single = read_system(beside(directory, by.file), by.where);
  values.insert(values.end(), f.units.begin(), f.units.end());
  const ClaimResult same = check_same_field(read_system(path, values).field, single.field);
  if (!same.proved) return "its field is another one: " + same.detail;
  if (const auto name = no_unit(family, single, f.units); !name.empty())
    return name + " = 1 is not seen to be a choice of units";
  if (const auto text = too_much_assumed(single, members); !text.empty())
    return "it assumes that " + text;
  return "";
}

} // namespace

Hypothesis settle_family(NodeResult& splitting, const LeftFamily& f, const NodeResult* by,
                         const std::string& directory) {
  Hypothesis h{"the bodies of the family " + f.family + " are not integrable", f.by, false};
  const auto unchecked = [&](const std::string& why) {
    h.text += " (" + why + ")";
    return h;
  };
  if (!by) return unchecked("no node is named");
  if (by->node.kind != NodeKind::case_file || by->node.expect != "non-integrable")
    return unchecked("node '" + f.by + "' is not a case that is expected to be non-integrable");
  std::string why = "its equations could not be solved for a parameter";
  for (const ParameterValues& members : f.members) {
    try {
      why = objection(splitting, f, members, by->node, directory);
    } catch (const Error& e) {
      why = e.what();
    }
    if (!why.empty()) continue;
    std::string units;
    for (const auto& [name, value] : f.units)
      units += (units.empty() ? ", in units with " : ", ") + name + " = " + value;
    splitting.checks.push_back({"the field of " + by->node.file + " is that of " +
                                    splitting.node.file + " on the family" + units +
                                    ", and what it assumes follows from A > B > C > 0",
                                true});
    h.checked = by->status == NodeStatus::proved;
    return h;
  }
  return unchecked("node '" + f.by + "' does not speak about them: " + why);
}

} // namespace kov
