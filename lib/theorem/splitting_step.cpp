// The step "splitting": from a case file to the families that the criterion leaves.

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "splitting/families.hpp"
#include "splitting/hypotheses.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include <algorithm>

namespace kov {
namespace {

std::string numbers(const std::array<Rational, 3>& abc) {
  return "A = " + to_string(abc[0]) + ", B = " + to_string(abc[1]) + ", C = " + to_string(abc[2]);
}

void show_data(NodeResult& n, const SplittingData& d, const VanishingConditions& c) {
  n.formulas.push_back(
      {"order of the perturbation", "epsilon^" + std::to_string(d.perturbation.order)});
  Grid sums{"Residues in t at the two poles of the strip, each up to the positive factor X^(-k/2): "
            "vanishing conditions, after factors of one sign are dropped",
            {"condition"},
            {}};
  for (const MPoly& f : c.equations)
    sums.rows.push_back({to_string(f) + " = 0"});
  n.tables.push_back(std::move(sums));
  Grid poles{"Poles of h_k in the strip", {"mode k", "orbit", "order at z = i and z = -i"}, {}};
  for (const StripResidues& r : d.residues)
    poles.rows.push_back(
        {std::to_string(r.k), r.sign > 0 ? "+" : "-", std::to_string(r.pole_order)});
  n.tables.push_back(std::move(poles));
  PolePicture picture{
      "The strip 0 <= Im t <= 2 pi/lambda with the poles of h_k (in units of pi/lambda); z = -i is "
      "reached with argument 3 pi/2",
      "Re t",
      "Im t",
      {{Rational(0), Rational(Integer(1), Integer(2)), "z = i", true},
       {Rational(0), Rational(Integer(3), Integer(2)), "z = -i", true}},
      true};
  n.pictures.push_back(std::move(picture));
}

void show_families(NodeResult& n, const SplittingClassification& k) {
  Grid grid{"Bodies 0 < C < B < A and directions for which all sums vanish (complete list)",
            {"family", "with A <= B + C?", "a member"},
            {}};
  for (const SplittingFamily& f : k.families)
    grid.rows.push_back({describe(f),
                         f.triangle == Truth::yes  ? "yes"
                         : f.triangle == Truth::no ? "no"
                                                   : "not decided",
                         f.witness ? numbers(*f.witness) : ""});
  n.tables.push_back(std::move(grid));
  Grid empty{"Branches that are empty, each by an identity", {"branch", "because"}, {}};
  for (const EmptyBranch& e : k.empty)
    empty.rows.push_back({e.branch, sentence(e.because)});
  n.tables.push_back(std::move(empty));
}

// The moments go by the names that the criterion gives them.
bool has_moments(const EulerPerturbation& p) {
  for (int k = 0; k < 3; ++k)
    if (to_string(p.inverse_inertia[k]) != std::string("1/") + "ABC"[k]) return false;
  return true;
}

// The needs of the criterion about the body: it is not a member of a family, and so on.
void put_domain(NodeResult& n, const System& s, bool triangle) {
  std::string direction = joined(
      n.node.small, [&](const std::string& name) { return name + "^2"; }, " + ");
  n.domain = {"A - B > 0", "B - C > 0", "C > 0", direction + " > 0"};
  if (triangle) n.domain.emplace_back("B + C - A >= 0");
  if (!has_moments(perturbation_of_euler(s, n.node.small))) n.domain.clear();
}

// A family is left: its equations do not all hold.
bool put_family(NodeResult& n, const SplittingFamily& f) {
  if (f.direction) return false;
  std::string sum = joined(
      f.zero, [&](const std::string& name) { return name + "^2"; }, " + ");
  for (const MPoly& g : f.moments)
    sum += (sum.empty() ? "(" : " + (") + to_string(g) + ")^2";
  n.domain.push_back(sum + " > 0");
  return true;
}

// The bodies and the directions that the criterion was asked about.
std::string range(const System& s, const TheoremNode& node, bool triangle) {
  std::string direction, zero;
  for (const std::string& name : node.small) {
    if (s.values.contains(name)) continue;
    direction += (direction.empty() ? "" : ", ") + name;
    zero += zero.empty() ? "0" : ", 0";
  }
  if (zero != "0") {
    direction = "(" + direction + ")";
    zero = "(" + zero + ")";
  }
  return "every body with three different moments" +
         std::string(triangle ? " A > B > C, A <= B + C," : "") + " and every " + direction +
         " other than " + zero;
}

// The families that the criterion leaves, compared with those that the file lists.
struct Families {
  std::string left, admitted; ///< in words: left open, and listed
  bool triangle = false;      ///< a family was left out because of the triangle inequality
  std::vector<const SplittingFamily*> remaining; ///< of the classification
};

Families sorted(const NodeResult& n, const SplittingClassification& k) {
  Families all;
  for (const SplittingFamily& f : k.families) {
    const std::string name = describe(f);
    if (n.node.triangle && f.triangle == Truth::no) {
      all.triangle = true;
      continue;
    }
    if (!is_among(name, n.node.families)) {
      all.left += (all.left.empty() ? "" : "; ") + name;
      continue;
    }
    all.remaining.push_back(&f);
    all.admitted += (all.admitted.empty() ? ", except for the family " : "; ") + name;
  }
  for (const std::string& f : n.node.families)
    if (std::ranges::none_of(k.families,
                             [&](const SplittingFamily& x) { return describe(x) == f; }))
      all.left +=
          (all.left.empty() ? "" : "; ") + f + " (listed, but the criterion leaves no such family)";
  return all;
}

// H(M, epsilon Gamma; S) = H(M, Gamma; epsilon S): an integral at S gives one at all multiples of S.
bool scales(const System& s, const EulerPerturbation& p, const std::vector<std::string>& small) {
  auto names = s.ring()->names();
  names.emplace_back("epsilon");
  const Ring ring = make_ring(names);
  Substitution gamma, parameters;
  const auto scale = [&](Substitution& all, std::size_t i) {
    all[i] = MFraction::variable(ring, "epsilon") * MFraction::variable(ring, i);
  };
  for (std::size_t k = 3; k < 6; ++k)
    scale(gamma, p.coordinates[k]);
  for (const std::string& name : small)
    scale(parameters, ring->index(name));
  const MFraction h = transfer(*s.field.hamiltonian, ring);
  return substitute(h, gamma) == substitute(h, parameters);
}

} // namespace

void prove_splitting(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  const System s = read_system(beside(directory, n.node.file), n.node.where);
  show_setting(n, s);
  for (const std::string& name : n.node.small)
    require_known(name, free_parameters(s), "free parameter of " + n.node.file);
  const EulerPerturbation p = perturbation_of_euler(s, n.node.small);
  const SplittingData d = splitting_data(p, options.decide.budget);
  n.checks = d.checks;
  n.theorems.push_back(used(ziglin_1980()));
  for (const CheckedIdentity& c : check_ziglin_hypotheses(d))
    n.checks.push_back(c);
  const VanishingConditions conditions = vanishing_conditions(d);
  for (const MPoly& f : conditions.nonzero)
    throw DomainError("all sums of residues vanish where " + to_string(f) + " = 0");
  const SplittingClassification k = classify_families(conditions, options.decide.budget);
  show_data(n, d, conditions);
  show_families(n, k);
  if (!all_hold(n.checks)) {
    n.status = NodeStatus::refuted;
    n.summary = "an identity fails";
    return;
  }
  const Families found = sorted(n, k);
  const std::string& left = found.left;
  n.status = left.empty() ? NodeStatus::proved : NodeStatus::open;
  put_domain(n, s, found.triangle);
  bool describable = true;
  for (const SplittingFamily* f : found.remaining)
    describable = !n.domain.empty() && put_family(n, *f) && describable;
  const bool for_all = scales(s, p, n.node.small);
  if (for_all)
    n.checks.push_back({"H with epsilon (" + joined(n.node.small) +
                            ") is H with epsilon Gamma: what holds for small ones holds for all",
                        true});
  if (left.empty() && describable && for_all && !n.domain.empty()) {
    n.says = Conclusion::not_integrable;
    n.excluded = {ziglin_1980().integrals};
  }
  const std::string found_here =
      left.empty()
          ? "a sum of residues is not zero for " + range(s, n.node, found.triangle) +
                found.admitted + "; by Ziglin's theorem there is no further integral that is " +
                sentence(ziglin_1980().integrals) +
                (for_all ? "" : ", when these parameters are small")
          : "the criterion says nothing for: " + left;
  n.summary = (s.values.empty() ? "" : "with " + values_of(s) + ": ") + found_here;
  n.statement = assumptions_of(s) + "For the " + titled(s) + ": " + found_here;
}

} // namespace kov
