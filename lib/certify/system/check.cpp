#include "certify/system/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/on_curve.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// Properties of the "not abelian" leaves of the inner certificate: section 7.
struct Leaves {
  bool any = false;    ///< some leaf says "not abelian"
  bool regular = true; ///< all of these have regular singular places only
  bool has_sl2 = true; ///< all of these have the group SL(2)

  void add(bool is_regular, bool is_sl2) {
    any = true;
    regular = regular && is_regular;
    has_sl2 = has_sl2 && is_sl2;
  }
};

bool is_regular(const Poly& num, const Poly& den) {
  const Poly first = derivative(den);
  return kov::degree(gcd(gcd(den, first), derivative(first))) <= 0 &&
         (is_zero(num) || kov::degree(den) - kov::degree(num) >= 2);
}

void look_at(const Certificate& c, Leaves& leaves) {
  leaves.add(is_regular(c.num, c.den), c.claim.group == "SL2");
}

class TreeLeaves {
public:
  explicit TreeLeaves(const StrataCertificate& c) { node(*c.tree, c.r); }
  Leaves leaves;

private:
  void node(const StrataNode& n, const Fraction& r) {
    std::visit([&](const auto& x) { take(x, r); }, n.kind);
  }
  void where_zero(const WhereZero& z, const Fraction& r) {
    std::visit([&](const auto& x) { take(x, r); }, z);
  }
  void take(const SplitNode& n, const Fraction& r) {
    node(*n.nonzero, r);
    where_zero(n.zero, r);
  }
  void take(const AssumedNode& n, const Fraction& r) { where_zero(n.zero, r); }
  void take(const LemmasNode& n, const Fraction& r) { node(*n.then, r); }
  void take(const SolvedStratum& n, const Fraction& r) { node(*n.then, n.r ? *n.r : r); }
  void take(const RootStratum& n, const Fraction&) {
    if (!n.abelian) look_at(n.certificate, leaves);
  }
  void take(const LeafNode& n, const Fraction& r) {
    if (n.abelian.value_or(true)) return;
    if (std::holds_alternative<ByClassical>(n.by)) return leaves.add(false, false);
    if (const auto* x = std::get_if<ByNumber>(&n.by)) return look_at(x->certificate, leaves);
    const auto& places = std::get<ByPlaces>(n.by).places;
    const bool finite =
        std::ranges::all_of(places, [](const StratumPlace& p) { return p.order <= 2; });
    leaves.add(finite && (is_zero(r.num) || degree(r.den, 0) - degree(r.num, 0) >= 2), false);
  }
  void take(const TrustedStratum& n, const Fraction&) {
    if (n.abelian == "no") leaves.add(false, false);
  }
  void take(const EmptyStratum&, const Fraction&) {}
  void take(const OutsideStratum&, const Fraction&) {}
  void take(const OpenStratum&, const Fraction&) {}
};

Refused refused(const Rejected& no) {
  return {"equation: " + (no.step.empty() ? "" : no.step + ": ") + no.why, no.limit};
}

// The inner certificate: trusted steps, leaves, and whether all of it says "not abelian".
struct Inner {
  std::size_t trusted = 0;
  Leaves leaves;
  bool not_abelian = false;
};

Inner judged(const Certificate& c) {
  const auto verdict = check(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) throw refused(*no);
  Inner inner{std::get<Accepted>(verdict).trusted_steps, {}, c.claim.abelian == false};
  if (inner.not_abelian) look_at(c, inner.leaves);
  return inner;
}

Inner judged(const StrataCertificate& c) {
  const auto verdict = check_strata(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) throw refused(*no);
  return {std::get<StrataAccepted>(verdict).trusted, TreeLeaves(c).leaves, c.abelian == false};
}

// A parameter, or an algebraic constant: a function with an empty gradient.
bool is_constant_of(const PhaseSystem& s, const std::string& name) {
  const auto k = s.ring->find(name);
  if (!k || *k < s.dimension) return false;
  return *k >= s.first_parameter() ||
         (*k < s.first_inverse() && s.functions[*k - s.dimension].gradient.empty());
}

void need_inner(OnCurve& way, const SystemCertificate& c) {
  if (const auto* x = std::get_if<Certificate>(&c.equation))
    return way.need_equation(x->num, x->den, c.root);
  const auto& strata = std::get<StrataCertificate>(c.equation);
  need(!c.root, "a root of a field that there is not");
  need(strata.ring->name(0) == c.way.curve.ring->name(c.way.curve.z()),
       "N4: the equation has another variable");
  for (std::size_t i = 1; i < strata.ring->size(); ++i)
    need(is_constant_of(c.way.system, strata.ring->name(i)),
         "N4: the equation has a parameter that the system has not");
  way.need_equation(strata.r, strata.generic);
  way.need_assumptions(strata);
}

// Unless the bracket is seen to be regular: constant, in pairs.
bool has_leaves(const PhaseSystem& s) {
  std::vector<int> pairs(s.dimension, 0);
  bool constant = true;
  for (const PhaseBracket& b : s.brackets) {
    ++pairs[b.first];
    ++pairs[b.second];
    constant = constant && is_constant(b.value.p) && !is_zero(b.value.p);
  }
  return s.hamiltonian && !(constant && std::ranges::all_of(pairs, [](int n) { return n == 1; }));
}

IntegralClass excluded(const Way& w, const Leaves& leaves, const OnCurve& way,
                       std::vector<std::string> moving) {
  IntegralClass integrals;
  if (leaves.any && !leaves.regular) integrals.near = IntegralClass::Near::closed_curve;
  integrals.on_leaf = has_leaves(w.system);
  integrals.liouville = w.system.hamiltonian.has_value();
  for (std::size_t i = w.system.dimension; i < w.system.first_inverse(); ++i)
    if (!w.system.functions[i - w.system.dimension].gradient.empty() &&
        std::ranges::any_of(w.curve.values, [i](const auto& v) { return v.first == i; }))
      integrals.functions.push_back(w.system.ring->name(i));
  if (!leaves.any || !leaves.regular || !leaves.has_sl2) integrals.without = std::move(moving);
  if (integrals.on_leaf && integrals.near == IntegralClass::Near::curve &&
      integrals.functions.empty() && integrals.without.empty())
    integrals.on_leaf = !way.has_regular_leaves();
  return integrals;
}

// Runs the rules and turns a refusal into a Rejected with the name of the rule.
template <class Rules> std::optional<Rejected> run(const Way& w, Rules rules) {
  std::string rule = "C1";
  try {
    Arithmetic arithmetic;
    OnCurve way(w, arithmetic);
    try {
      way.need_claims();
      way.need_curve();
      way.need_normal();
      rules(way);
    } catch (...) {
      rule = way.rule();
      throw;
    }
  } catch (const Refused& no) {
    return Rejected{no, rule};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}, rule};
  }
  return std::nullopt;
}

} // namespace

bool holds_on_curve(const Way& w, const MPoly& f, Arithmetic& a) { return OnCurve(w, a).holds(f); }

std::optional<Rejected> objection(const Way& w, const Fraction& r) {
  return run(w, [&](OnCurve& way) { way.need_equation(r, {}); });
}

std::variant<SystemAccepted, Rejected> check_way(const SystemCertificate& c) {
  SystemAccepted accepted;
  const auto no = run(c.way, [&](OnCurve& way) {
    need_inner(way, c);
    const Inner inner = std::visit([](const auto& x) { return judged(x); }, c.equation);
    need(!c.not_integrable || inner.not_abelian, "the claim does not follow");
    accepted = {inner.trusted,
                c.not_integrable,
                inner.leaves.any,
                excluded(c.way, inner.leaves, way, way.moving()),
                way.seen_by_functions(true),
                way.seen_by_functions(false)};
  });
  if (no) return *no;
  return accepted;
}

} // namespace kov::certify
