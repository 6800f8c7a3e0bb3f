// The rule for the certificate of one system: theorem_certificates.md 5.

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/jets/check.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/error.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// The coefficients of a polynomial in one more name, z.
Coefficients in_z(const Ring& ring, const std::string& z, const Node& at, const MPoly& f) {
  const auto i = f.ring()->find(z);
  if (!i) at.fail("the variable is missing");
  Coefficients all;
  for (const MPoly& c : coefficients(f, *i))
    all.push_back(in_ring(c, ring));
  return all;
}

AskedCondition not_all_zero(std::vector<MPoly> all, const Ring& ring) {
  if (all.empty()) all.emplace_back(ring);
  return {false, Sign::nonzero, MPoly(ring), std::move(all)};
}

MPoly only(const Coefficients& c, const Ring& ring) { return c.empty() ? MPoly(ring) : c.front(); }

template <class Certificate>
std::shared_ptr<const Certificate> read_by(Certificate (*read)(std::string_view),
                                           const Node& inner) {
  try {
    return std::make_shared<const Certificate>(read(to_string(inner.json())));
  } catch (const InvalidArgument& e) {
    inner.fail(e.what());
  }
}

template <class Accepted> Accepted accepted(std::variant<Accepted, Rejected> verdict) {
  if (const auto* no = std::get_if<Rejected>(&verdict))
    throw Refused{no->step + ": " + no->why, no->limit};
  return std::get<Accepted>(std::move(verdict));
}

// Higher variational equations: canonical coordinates, nothing is left out.
Said of_jets(const Node& inner) {
  const auto read = read_by(read_jets_certificate, inner);
  const JetsCertificate& c = *read;
  need(accepted(check_jets(c)).trusted == 0, "not without trust");
  need(c.field.tower.empty(), "an algebraic constant among the parameters");
  Said f{FactKind::not_integrable, nullptr, {{}}};
  f.classes = {IntegralClass{}};
  f.way = {"VE_" + std::to_string(c.order) + " along a line of " + quoted(c.title)};
  f.used = {"Morales-Ramis-Simo"};
  f.only_stratum = true;
  auto s = std::make_shared<PhaseSystem>();
  s->ring = c.phase;
  const std::size_t n = 2 + c.others;
  s->dimension = 2 * n;
  s->hamiltonian = c.hamiltonian;
  for (std::size_t i = 0; i < n; ++i)
    s->brackets.push_back({i, i + n, {MPoly(c.phase, Integer(1)), Integer(1)}});
  f.system = s;
  f.target = Target{f.system.get(), {}};
  const Ring& ring = f.system->ring;
  const std::string e = c.field.ring->name(c.e());
  for (const MPoly& d : c.field.denominators)
    f.target->asked.push_back({false, Sign::nonzero, only(in_z(ring, e, inner, d), ring)});
  f.target->asked.push_back(not_all_zero(in_z(ring, e, inner, c.obstruction.value.p), ring));
  return f;
}

/// The conditions that a certificate of the whole way asks of a point.
class Asked {
public:
  Asked(const SystemCertificate& c, const Node& at) : c_(c), at_(at), ring_(c.way.system.ring) {}

  [[nodiscard]] std::vector<AskedCondition> everywhere() const {
    std::vector<AskedCondition> all;
    if (const auto* x = std::get_if<StrataCertificate>(&c_.equation)) ask_strata(all, *x);
    const PhaseCurve& curve = c_.way.curve;
    for (const MPoly& d : curve.denominators)
      all.push_back(group(d, curve.ring->name(curve.z())));
    return all;
  }
  [[nodiscard]] LeafSaid of(const LeafOfWay& leaf) const {
    LeafSaid said{{}, leaf.trusted, leaf.integrals};
    for (const Condition& c : leaf.path)
      said.asked.push_back({false, c.sign, moved(c.p)});
    said.difference = leaf.difference;
    if (auto& d = said.difference) d->square = {moved(d->square.num), moved(d->square.den)};
    return said;
  }

private:
  void ask_strata(std::vector<AskedCondition>& all, const StrataCertificate& x) const {
    need(x.memberships.empty() && std::ranges::none_of(x.rational, [](bool b) { return b; }),
         "memberships are not looked at here");
    for (std::size_t i = 1; i < x.ring->size(); ++i) {
      const auto j = ring_->find(x.ring->name(i));
      need(j && *j >= c_.way.system.first_parameter(),
           "an algebraic constant among the parameters");
    }
    for (std::size_t i = 1; i < x.ring->size(); ++i)
      if (x.real[i]) all.push_back({true, Sign::nonzero, moved(MPoly::variable(x.ring, i))});
    for (const Condition& f : x.assumptions)
      all.push_back({false, f.sign, moved(f.p)});
    for (const auto& members : x.generic) {
      std::vector<MPoly> there;
      for (const MPoly& f : members)
        there.push_back(moved(f));
      all.push_back(not_all_zero(std::move(there), ring_));
    }
    all.push_back(group(x.r.den, x.ring->name(0)));
  }
  [[nodiscard]] AskedCondition group(const MPoly& f, const std::string& z) const {
    return not_all_zero(in_z(ring_, z, at_, f), ring_);
  }
  // A polynomial of the equation, without its variable.
  [[nodiscard]] MPoly moved(const MPoly& f) const {
    return only(in_z(ring_, f.ring()->name(0), at_, f), ring_);
  }

  const SystemCertificate& c_;
  const Node& at_;
  const Ring& ring_;
};

} // namespace

Target target_of(const Said& certificate, const LeafSaid& leaf) {
  Target y = certificate.target.value();
  y.asked.insert(y.asked.end(), leaf.asked.begin(), leaf.asked.end());
  return y;
}

Said said_by_certificate(const Node& inner) {
  if (Keys(inner).at("format").text() == "kovacic-jets/1") return of_jets(inner);
  const auto read = read_by(read_system_certificate, inner);
  const SystemCertificate& c = *read;
  const SystemAccepted yes = accepted(check_way(c));
  const bool everywhere = yes.not_integrable && yes.trusted == 0;
  need(everywhere || !yes.leaves.empty() || !yes.criteria.empty(), "no leaf says \"not abelian\"");
  Said f{everywhere ? FactKind::not_integrable : FactKind::leaves, nullptr, {{}}};
  const auto has_names = [](const IntegralClass& x) {
    return !x.functions.empty() || !x.without.empty();
  };
  f.only_stratum = !c.way.system.hamiltonian || has_names(yes.integrals) ||
                   std::ranges::any_of(yes.criteria, has_names, &LeafOfWay::integrals);
  f.classes = {yes.integrals};
  f.way = {phase_curve(c) + " of " + quoted(c.way.title)};
  f.there = functions_there(c, yes);
  f.used = {c.way.system.hamiltonian && !c.way.normal.whole ? "Morales-Ramis" : "Ayoul-Zung"};
  f.system = std::shared_ptr<const PhaseSystem>(read, &c.way.system);
  const Asked asked(c, inner);
  f.target = Target{f.system.get(), asked.everywhere(), &c.way, f.there.chosen};
  for (const LeafOfWay& leaf : yes.leaves)
    f.leaves.push_back(asked.of(leaf));
  for (const LeafOfWay& leaf : yes.criteria)
    f.criteria.push_back(asked.of(leaf));
  return f;
}

Said rule::certificate(Keys& step, Derivation&) {
  return said_by_certificate(step.at("certificate"));
}

// One leaf of a certificate that says "not abelian", where it says so.
Said rule::leaf(Keys& step, Derivation& d) {
  const TheoremFact& of = d.fact(step.at("of"));
  const LeafSaid& x = of.leaves.at(read_index(step.at("leaf"), of.leaves.size(), "no such leaf"));
  need(x.trusted == 0, "a leaf on trust");
  Said f{FactKind::not_integrable, nullptr, {{}}};
  f.classes = {x.integrals};
  f.way = of.way;
  f.there = of.there;
  f.system = of.system;
  f.target = target_of(of, x);
  return f;
}

} // namespace kov::certify
