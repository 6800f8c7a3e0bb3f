#include "certify/system/check.hpp"

#include "certify/equation/statement.hpp"
#include "certify/system/normal_rules.hpp"
#include "certify/system/regular_leaf.hpp"
#include "proof/text/checked.hpp"

namespace kov::certify {

namespace {

// The inner certificate: trusted steps, leaves that say "not abelian", and whether all of it does.
struct Inner {
  std::size_t trusted = 0;
  std::vector<Denial> denials;
  bool not_abelian = false;
  std::vector<CriterionLeaf> criteria{};
  std::vector<std::string> lines{};
};

const char* const inside = "equation: ";

Inner judged(const Certificate& c) {
  Inner inner{found_within(check(c), inside).trusted_steps, {}, c.claim.abelian == false};
  inner.lines = statement(c);
  if (inner.not_abelian) inner.denials.push_back(denial_of(c, inner.trusted));
  return inner;
}

Inner judged(const StrataCertificate& c) {
  const StrataAccepted yes = found_within(check_strata(c), inside);
  return {yes.trusted, yes.denials, c.abelian == false, yes.criteria, statement(c, yes)};
}

// Loops on the curve itself: nothing is asked of its ends.
Inner judged(const LoopsCertificate& c) {
  const std::size_t trusted = found_within(check_loops(c), inside).trusted_steps;
  return {trusted, {{.regular = true, .trusted = trusted}}, true, {}, statement(c)};
}

void need_inner(const AlongCurve& x, const NormalRules& normal, const SystemCertificate& c) {
  const PhaseSystem& s = c.way.system;
  if (const auto* e = std::get_if<Certificate>(&c.equation))
    return normal.need_equation(e->num, e->den, c.root);
  if (const auto* loops = std::get_if<LoopsCertificate>(&c.equation)) {
    need(!c.way.normal.whole || !s.hamiltonian || x.moving().empty(),
         "N5: on the whole manifold no name is left out, because the bracket may contain it");
    return normal.need_system(*loops, c.root);
  }
  const auto& strata = std::get<StrataCertificate>(c.equation);
  need(!c.root, "a root of a field that there is not");
  need(strata.ring->name(0) == c.way.curve.ring->name(c.way.curve.z()),
       "N4: the equation has another variable");
  for (std::size_t i = 1; i < strata.ring->size(); ++i) {
    const auto k = s.ring->find(strata.ring->name(i));
    need(k && is_constant_of(s, *k), "N4: the equation has a parameter that the system has not");
  }
  normal.need_equation(strata.r, strata.generic);
  normal.need_assumptions(strata);
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
  Excluded(const Way& w, const AlongCurve& x) : s_(w.system), leaves_(w, x), moving_(x.moving()) {
    sample_.on_leaf = has_leaves(s_) && !w.normal.whole;
    sample_.liouville = s_.hamiltonian.has_value();
    for (std::size_t i = 0; i < s_.functions.size(); ++i)
      if (x.values()[s_.dimension + i] && !s_.functions[i].gradient.empty())
        sample_.functions.push_back(s_.ring->name(s_.dimension + i));
  }

  IntegralClass operator()(const std::vector<Denial>& denials) {
    const bool regular = std::ranges::all_of(denials, &Denial::regular);
    IntegralClass integrals = sample_;
    if (!regular) integrals.near = IntegralClass::Near::closed_curve;
    if (denials.empty() || !regular || !std::ranges::all_of(denials, &Denial::has_sl2))
      integrals.without = moving_;
    if (integrals.on_leaf && regular && integrals.functions.empty() && integrals.without.empty()) {
      if (!has_regular_leaves_) has_regular_leaves_ = leaves_();
      integrals.on_leaf = !*has_regular_leaves_;
    }
    return integrals;
  }

private:
  const PhaseSystem& s_;
  RegularLeaves leaves_;
  std::vector<std::string> moving_;
  IntegralClass sample_; ///< as far as no leaf is asked
  std::optional<bool> has_regular_leaves_;
};

// The rules of the way, then those for its end.
template <class End> auto along(const Way& w, End end) {
  std::string rule = "C1";
  return verdict_at(rule, [&] {
    Arithmetic arithmetic;
    AlongCurve x(w, arithmetic, rule);
    x.need_claims(w.claims);
    x.need_curve();
    return end(x, NormalRules(w, x, rule));
  });
}
template <class Found>
std::optional<Rejected> objection(const std::variant<Found, Rejected>& verdict) {
  const auto* no = std::get_if<Rejected>(&verdict);
  return no ? std::optional(*no) : std::nullopt;
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

bool holds_on_curve(const Way& w, const MPoly& f, Arithmetic& a) {
  std::string rule;
  return AlongCurve(w, a, rule).holds(f);
}

std::optional<Rejected> objection(const Way& w, const Fraction& r) {
  return objection(along(w, [&](const AlongCurve&, const NormalRules& normal) {
    normal.need_equation(r, {});
    return true;
  }));
}

std::optional<Rejected> objection(const SystemCertificate& c) {
  return objection(along(c.way, [&](const AlongCurve& x, const NormalRules& normal) {
    need_inner(x, normal, c);
    return true;
  }));
}

std::variant<SystemAccepted, Rejected> check_way(const SystemCertificate& c) {
  const CheckedSteps::File file;
  return along(c.way, [&](const AlongCurve& x, const NormalRules& normal) {
    need_inner(x, normal, c);
    const Inner inner = std::visit([](const auto& e) { return judged(e); }, c.equation);
    need(!c.not_integrable || inner.not_abelian, "the claim does not follow");
    Excluded excluded(c.way, x);
    SystemAccepted accepted{inner.trusted,
                            c.not_integrable,
                            !inner.denials.empty(),
                            excluded(inner.denials),
                            x.seen_by_functions(true),
                            x.seen_by_functions(false),
                            {},
                            {},
                            inner.lines};
    for (const Denial& d : inner.denials)
      accepted.leaves.push_back({d.path, d.trusted, excluded({d})});
    for (const auto& [d, difference] : inner.criteria)
      accepted.criteria.push_back({d.path, 0, excluded({d}), difference});
    if (CheckedSteps::wanted()) tell(c, accepted);
    return accepted;
  });
}

} // namespace kov::certify
