// The steps about vector fields: claims, scaling, lowest order.

#include "theorem/prove.hpp"

#include "exact/error.hpp"
#include "integrability/parameters.hpp"
#include "symbol/suggest.hpp"
#include "system/claims.hpp"
#include "system/weights.hpp"

#include <algorithm>

namespace kov {
namespace {

std::string on_level(const SystemClaim& c) {
  std::string text;
  for (const Equation& e : c.on)
    text += (text.empty() ? " on " : ", ") + e.text;
  return text;
}

std::string words(const SystemClaim& c) {
  using Kind = SystemClaim::Kind;
  const std::string formula = c.name.empty() || c.name == c.text ? c.text : c.name + " = " + c.text;
  switch (c.kind) {
  case Kind::integral:
    return formula + " is a first integral" + on_level(c);
  case Kind::casimir:
    return formula + " is a Casimir function" + on_level(c);
  case Kind::darboux:
    return formula + " is a Darboux polynomial: " + c.name + " = 0 is invariant" + on_level(c);
  default: // brackets and identities carry their own = sign
    return (c.name.empty() || c.name == c.text ? "" : c.name + ": ") + c.text + on_level(c);
  }
}

// A claim that is expected to fail: it fails for some parameters, as far as this goes.
std::string refutation(const System& s, bool proved) {
  if (proved) return ": claimed to fail, but it holds";
  return s.field.parameters.empty() ? ": claimed to fail, and it does"
                                    : ": claimed not to hold for all parameters, and it does not";
}

// f(x) with each x in `names` replaced by epsilon x.
MFraction scaled(const MFraction& f, const Ring& ring, const std::vector<std::string>& names) {
  const MFraction epsilon = MFraction::variable(ring, "epsilon");
  Substitution values;
  for (const std::string& n : names)
    values[ring->index(n)] = epsilon * MFraction::variable(ring, n);
  return substitute(transfer(f, ring), values);
}

bool same_function(const MFraction& f, const MFraction& g) {
  for (const std::size_t v : used_variables(f))
    if (!g.ring()->find(f.ring()->name(v))) return false;
  return transfer(f, g.ring()) == g;
}

void conclude(NodeResult& n, const std::string& proved) {
  n.status = all_hold(n.checks) ? NodeStatus::proved : NodeStatus::refuted;
  n.summary = proved;
  if (n.status == NodeStatus::refuted)
    for (const CheckedIdentity& c : n.checks)
      if (!c.holds) n.summary = "false: " + c.statement;
}

} // namespace

void require_known(const std::string& name, const std::vector<std::string>& known,
                   const std::string& what) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  const auto near = nearest(name, known);
  throw InputError("", 0, 0, 1, "'" + name + "' is no " + what,
                   near            ? "did you mean " + *near + "?"
                   : known.empty() ? "there is none"
                                   : "known: " + enumerate(known));
}

std::vector<std::string> free_parameters(const System& s) {
  std::vector<std::string> names;
  for (const std::size_t i : s.field.parameters)
    if (!s.values.contains(s.ring()->name(i))) names.push_back(s.ring()->name(i));
  return names;
}

std::string beside(const std::string& directory, const std::string& file) {
  return file.starts_with('/') ? file : directory + file;
}

void show_setting(NodeResult& n, const System& s) {
  std::string fixed;
  for (const auto& [name, value] : s.values)
    fixed += (fixed.empty() ? "" : ", ") + name + " = " + to_string(value);
  if (!fixed.empty()) n.formulas.push_back({"with", fixed});
  for (const Assumption& a : s.assumptions)
    n.formulas.push_back({"assumed", a.text});
}

void prove_claims(NodeResult& n, const std::string& directory) {
  const System s = read_system(beside(directory, n.node.file), n.node.where);
  show_setting(n, s);
  for (const SystemClaim& c : s.claims) {
    const ClaimResult result = check_claim(s, c);
    std::string where;
    for (const MPoly& g : not_excluded(s, result.generic))
      where += (where.empty() ? " where " : ", ") + to_string(g) + " != 0";
    if (!where.empty())
      n.node.hypotheses.push_back(
          {"the parameters are such that '" + words(c) + "' is proved:" + where.substr(6), "",
           false});
    n.checks.push_back(
        {words(c) + (c.holds ? where : refutation(s, result.proved)), result.proved == c.holds});
  }
  if (n.checks.empty()) throw DomainError(n.node.file + " claims nothing");
  conclude(n, "every claim of " + n.node.file + " is decided by an exact identity");
}

void prove_scaling(NodeResult& n, const std::string& directory) {
  const System s = read_system(beside(directory, n.node.file), n.node.where);
  show_setting(n, s);
  std::vector<std::string> coordinates;
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    coordinates.push_back(s.field.name(j));
  for (const std::string& name : n.node.small)
    require_known(name, free_parameters(s), "free parameter of " + n.node.file);
  for (const std::string& name : n.node.scaled)
    require_known(name, coordinates, "coordinate of " + n.node.file);
  std::vector<std::string> names = s.ring()->names();
  names.emplace_back("epsilon");
  const Ring ring = make_ring(names);
  const MFraction epsilon = MFraction::variable(ring, "epsilon");
  for (std::size_t j = 0; j < s.field.dimension(); ++j) {
    const std::string& x = s.field.name(j);
    const bool is_scaled =
        std::find(n.node.scaled.begin(), n.node.scaled.end(), x) != n.node.scaled.end();
    const MFraction left = scaled(s.field.components[j], ring, n.node.scaled);
    MFraction right = scaled(s.field.components[j], ring, n.node.small);
    if (is_scaled) right = epsilon * right;
    n.checks.push_back(
        {x + "' at " + (is_scaled ? "scaled variables is epsilon times " : "scaled variables is ") +
             x + "' at scaled parameters",
         left == right});
  }
  conclude(n, "the field with parameters epsilon (" + enumerate(n.node.small) +
                  ") is the field with the original ones in the variables epsilon (" +
                  enumerate(n.node.scaled) + ")");
}

void prove_lowest_order(NodeResult& n, const std::string& directory) {
  const System s = read_system(beside(directory, n.node.file), n.node.where);
  show_setting(n, s);
  const System other = read_system(beside(directory, n.node.other), n.node.where);
  if (s.weights.empty()) throw DomainError(n.node.file + " has no [expansion] with weights");
  const LowestSystem low = lowest_system(s, s.expansion_terms);
  n.checks.push_back({"both systems have " + std::to_string(s.field.dimension()) + " coordinates",
                      s.field.dimension() == other.field.dimension()});
  n.checks.push_back({"the bracket is weight-homogeneous", low.structure.has_value()});
  n.checks.push_back({"the lowest-order field is the Hamiltonian field of the lowest term of H",
                      low.is_hamiltonian});
  for (std::size_t j = 0; j < s.field.dimension(); ++j) {
    const std::string& x = s.field.name(j);
    bool same = false;
    for (std::size_t k = 0; k < other.field.dimension(); ++k)
      if (other.field.name(k) == x)
        same = same_function(low.components[j], other.field.components[k]);
    n.checks.push_back({"lowest order of " + x + "' = " + x + "' of " + n.node.other, same});
  }
  for (const WeightTerm& t : low.hamiltonian)
    n.formulas.push_back({"H_" + std::to_string(t.degree), to_string(t.value)});
  conclude(n, "the lowest-order system is that of " + n.node.other);
}

} // namespace kov
