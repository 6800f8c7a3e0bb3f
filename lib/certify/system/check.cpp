#include "certify/system/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/loops/check.hpp"
#include "certify/system/on_curve.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

Refused refused(const Rejected& no) {
  return {"equation: " + (no.step.empty() ? "" : no.step + ": ") + no.why, no.limit};
}

// The inner certificate: trusted steps, leaves that say "not abelian", and whether all of it does.
struct Inner {
  std::size_t trusted = 0;
  std::vector<Denial> denials;
  bool not_abelian = false;
  std::vector<CriterionLeaf> criteria{};
  std::vector<std::string> lines{};
};

Inner judged(const Certificate& c) {
  const auto verdict = check(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) throw refused(*no);
  Inner inner{std::get<Accepted>(verdict).trusted_steps, {}, c.claim.abelian == false};
  inner.lines = statement(c);
  if (inner.not_abelian) inner.denials.push_back(denial_of(c, inner.trusted));
  return inner;
}

Inner judged(const StrataCertificate& c) {
  const auto verdict = check_strata(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) throw refused(*no);
  const auto& yes = std::get<StrataAccepted>(verdict);
  return {yes.trusted, yes.denials, c.abelian == false, yes.criteria, statement(c, yes)};
}

// Loops on the curve itself: nothing is asked of its ends.
Inner judged(const LoopsCertificate& c) {
  const auto verdict = check_loops(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) throw refused(*no);
  Denial d{.regular = true};
  d.trusted = std::get<Accepted>(verdict).trusted_steps;
  return {d.trusted, {d}, true, {}, statement(c)};
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
  if (const auto* x = std::get_if<LoopsCertificate>(&c.equation)) {
    need(!c.way.normal.whole || !c.way.system.hamiltonian || way.moving().empty(),
         "N5: on the whole manifold no name is left out, because the bracket may contain it");
    return way.need_system(*x, c.root);
  }
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

// The class that some leaves exclude, all of which say "not abelian".
class Excluded {
public:
  Excluded(const Way& w, OnCurve& way) : w_(w), way_(way), moving_(way.moving()) {}

  IntegralClass operator()(const std::vector<Denial>& denials) {
    const auto all = [&](bool Denial::*what) {
      return std::ranges::all_of(denials, [&](const Denial& d) { return d.*what; });
    };
    const bool regular = all(&Denial::regular);
    IntegralClass integrals;
    if (!regular) integrals.near = IntegralClass::Near::closed_curve;
    integrals.on_leaf = has_leaves(w_.system) && !w_.normal.whole;
    integrals.liouville = w_.system.hamiltonian.has_value();
    for (std::size_t i = w_.system.dimension; i < w_.system.first_inverse(); ++i)
      if (!w_.system.functions[i - w_.system.dimension].gradient.empty() &&
          std::ranges::any_of(w_.curve.values, [i](const auto& v) { return v.first == i; }))
        integrals.functions.push_back(w_.system.ring->name(i));
    if (denials.empty() || !regular || !all(&Denial::has_sl2)) integrals.without = moving_;
    if (integrals.on_leaf && regular && integrals.functions.empty() && integrals.without.empty())
      integrals.on_leaf = !has_regular_leaves();
    return integrals;
  }

private:
  bool has_regular_leaves() {
    if (!has_regular_leaves_) has_regular_leaves_ = way_.has_regular_leaves();
    return *has_regular_leaves_;
  }

  const Way& w_;
  const OnCurve& way_;
  std::vector<std::string> moving_;
  std::optional<bool> has_regular_leaves_;
};

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

std::string equation_of(const Certificate& c) {
  return equation_text(over_field(c.num), over_field(c.den));
}
std::string equation_of(const StrataCertificate& c) {
  return equation_text(to_string(c.r.num), to_string(c.r.den));
}

std::string equation_of(const LoopsCertificate& c) {
  return "Y' = A(z) Y, A a matrix of size " + std::to_string(c.rows.size());
}

// The rules, in an order in which they can be read.
void tell(const SystemCertificate& c, const SystemAccepted& found) {
  const char* format = "kovacic-system/1";
  const std::string equation = std::visit([](const auto& x) { return equation_of(x); }, c.equation);
  const std::string excluded =
      found.somewhere ? "first integrals that are " + sentence(found.integrals) : "none";
  CheckedSteps::add_labels(format, {"S1", "S2", "S3", "S4", "C1", "C2"});
  CheckedSteps::add({format, "label", "C4", "", {}, phase_curve(c)});
  CheckedSteps::add_labels(format, {"C5", "C6", "C7", "N1", "N2", "N3"});
  const bool of_matrices = std::holds_alternative<LoopsCertificate>(c.equation);
  CheckedSteps::add({format, "label", of_matrices ? "N5" : "N4", "", {}, equation});
  CheckedSteps::add({format, "label", "class", "", {}, excluded});
}

} // namespace

bool holds_on_curve(const Way& w, const MPoly& f, Arithmetic& a) { return OnCurve(w, a).holds(f); }

std::optional<Rejected> objection(const Way& w, const Fraction& r) {
  return run(w, [&](OnCurve& way) { way.need_equation(r, {}); });
}

std::optional<Rejected> objection(const SystemCertificate& c) {
  return run(c.way, [&](OnCurve& way) { need_inner(way, c); });
}

std::variant<SystemAccepted, Rejected> check_way(const SystemCertificate& c) {
  const CheckedSteps::File file;
  SystemAccepted accepted;
  const auto no = run(c.way, [&](OnCurve& way) {
    need_inner(way, c);
    const Inner inner = std::visit([](const auto& x) { return judged(x); }, c.equation);
    need(!c.not_integrable || inner.not_abelian, "the claim does not follow");
    Excluded excluded(c.way, way);
    accepted = {inner.trusted,
                c.not_integrable,
                !inner.denials.empty(),
                excluded(inner.denials),
                way.seen_by_functions(true),
                way.seen_by_functions(false),
                {},
                {},
                inner.lines};
    for (const Denial& d : inner.denials)
      accepted.leaves.push_back({d.path, d.trusted, excluded({d})});
    for (const auto& [d, difference] : inner.criteria)
      accepted.criteria.push_back({d.path, 0, excluded({d}), difference});
  });
  if (no) return *no;
  if (CheckedSteps::wanted()) tell(c, accepted);
  return accepted;
}

} // namespace kov::certify
