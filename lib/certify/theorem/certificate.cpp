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

// At the points some coefficient in one more name, z, is not 0.
AskedCondition not_zero_in(const std::string& z, const MPoly& f, const Ring& ring) {
  AskedCondition c{false, Sign::nonzero, MPoly(ring)};
  for (const MPoly& part : coefficients(f, f.ring()->index(z)))
    c.group.push_back(in_ring(part, ring));
  if (c.group.empty()) c.group.emplace_back(ring);
  return c;
}

template <class Certificate>
std::shared_ptr<const Certificate> read_by(Certificate (*read)(std::string_view),
                                           const Node& inner) {
  try {
    return std::make_shared<const Certificate>(read(to_string(inner.json())));
  } catch (const InvalidArgument& e) {
    inner.fail(e.what());
  }
}

// Higher variational equations: canonical coordinates, nothing is left out.
Said of_jets(const Node& inner) {
  const auto read = read_by(read_jets_certificate, inner);
  const JetsCertificate& c = *read;
  need(found_within(check_jets(c)).trusted == 0, "not without trust");
  need(c.field.tower.empty(), "an algebraic constant among the parameters");
  Said f{FactKind::not_integrable, nullptr, {{}}};
  f.classes = {IntegralClass{}};
  f.way = {"VE_" + std::to_string(c.order) + " along a line of " + quoted(c.title)};
  f.used = {"Morales-Ramis-Simo"};
  f.only_stratum = true;
  f.system = std::shared_ptr<const PhaseSystem>(read, &c.system);
  f.target = Target{f.system.get(), {}};
  const Ring& ring = f.system->ring;
  for (const MPoly& d : c.field.denominators)
    f.target->asked.push_back({false, Sign::nonzero, in_ring(d, ring)});
  f.target->asked.push_back(not_zero_in(c.field.ring->name(c.e()), c.obstruction.value.p, ring));
  return f;
}

// The conditions that a certificate of the whole way asks of a point.
std::vector<AskedCondition> asked_everywhere(const SystemCertificate& c) {
  const PhaseSystem& s = c.way.system;
  std::vector<AskedCondition> all;
  if (const auto* x = std::get_if<StrataCertificate>(&c.equation)) {
    need(x->memberships.empty() && std::ranges::none_of(x->rational, [](bool b) { return b; }),
         "memberships are not looked at here");
    for (std::size_t i = 1; i < x->ring->size(); ++i) {
      const auto j = s.ring->find(x->ring->name(i));
      need(j && *j >= s.first_parameter(), "an algebraic constant among the parameters");
      if (x->real[i]) all.push_back({true, Sign::nonzero, MPoly::variable(s.ring, *j)});
    }
    for (const Condition& f : x->assumptions)
      all.push_back({false, f.sign, in_ring(f.p, s.ring)});
    for (const auto& members : x->generic) {
      AskedCondition some{false, Sign::nonzero, MPoly(s.ring)};
      for (const MPoly& f : members)
        some.group.push_back(in_ring(f, s.ring));
      if (some.group.empty()) some.group.emplace_back(s.ring);
      all.push_back(std::move(some));
    }
    all.push_back(not_zero_in(x->ring->name(0), x->r.den, s.ring));
  }
  const PhaseCurve& curve = c.way.curve;
  for (const MPoly& d : curve.denominators)
    all.push_back(not_zero_in(curve.ring->name(curve.z()), d, s.ring));
  return all;
}

LeafSaid said_at(const LeafOfWay& leaf, const Ring& ring) {
  LeafSaid said{{}, leaf.trusted, leaf.integrals, leaf.difference};
  for (const Condition& c : leaf.path)
    said.asked.push_back({false, c.sign, in_ring(c.p, ring)});
  if (auto& d = said.difference)
    d->square = {in_ring(d->square.num, ring), in_ring(d->square.den, ring)};
  return said;
}

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
  const SystemAccepted yes = found_within(check_way(c));
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
  f.target = Target{f.system.get(), asked_everywhere(c), &c.way, f.there.chosen};
  for (const LeafOfWay& leaf : yes.leaves)
    f.leaves.push_back(said_at(leaf, f.system->ring));
  for (const LeafOfWay& leaf : yes.criteria)
    f.criteria.push_back(said_at(leaf, f.system->ring));
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
