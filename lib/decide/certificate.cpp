#include "decide/certificate.hpp"

#include "certify/equation/check.hpp"
#include "decide/witness.hpp"
#include "exact/error.hpp"
#include "exact/tried.hpp"
#include "galois/dihedral.hpp"

#include <algorithm>
#include <set>

namespace kov {

namespace {

using Ids = std::vector<std::string>;

// v = p prod q^e; y1 y2 has no other poles.
Invariant factored(const RationalFunction& v, const Singularities& local) {
  Invariant found{2, v.num(), {}};
  for (const Singularity& place : local.finite) {
    const auto [zeros, rest] = remove_factor(found.p, place.place);
    found.e.push_back(zeros - remove_factor(v.den(), place.place).first);
    found.p = rest;
  }
  found.p = scale(found.p, inverse(lead(found.p)));
  return found;
}

/// The steps of a certificate, each written once.
class EquationSteps {
public:
  EquationSteps(const Classification& known, const RationalFunction& r, const Budget& given)
      : c(known), budget(given) {
    out.field = common_field(r.num().field(), r.den().field());
    out.num = coerce(r.num(), out.field);
    out.den = coerce(r.den(), out.field);
    judge = {out.field, {out.num, out.den}};
  }

  certify::Certificate finished() {
    claim();
    drop_unused_steps();
    return std::move(out);
  }
  [[nodiscard]] bool shows_sl2(const certify::PCurvature& data) const {
    return tried<certify::Refused>(
        [&] { static_cast<void>(certify::check_p_curvature(judge, data, &*fact)); });
  }

  std::string add(std::string id, Ids premises, certify::Rule rule) {
    out.steps.push_back({id, std::move(premises), std::move(rule)});
    return id;
  }
  void conclude(std::string theorem, Ids premises) {
    add("conclusion", std::move(premises), certify::Conclude{std::move(theorem)});
  }

  std::string local(witness::Detail detail = witness::Detail::exponents) {
    if (fact) return "local";
    certify::Local data;
    if (c.local)
      data = witness::local(judge, *c.local, detail, budget);
    else
      data.prime = PrimeIdeals::large(out.field).next(); // r = 0
    prime = data.prime;
    fact = certify::claimed_local(judge, data);
    return add("local", {}, std::move(data));
  }

  std::string exponential() {
    const ExponentialSolution& y = *c.exponential;
    return add("exponential", {}, certify::Exponential{y.p, y.theta.num(), y.theta.den()});
  }

  // G is irreducible.
  std::string irreducible() {
    local(witness::Detail::growth);
    return add("irreducible", {"local"}, witness::no_exponential(judge, *c.local, *fact, budget));
  }

  std::string absent(long m) {
    local();
    return add("no-invariant-" + std::to_string(m), {"local"},
               witness::no_invariant(judge, m, *fact, budget));
  }

  // v = p prod q^e over the places, exponents in units of 1/denominator
  std::string invariant(long m, const Poly& p, const std::vector<long>& e, long denominator,
                        const std::string& id = "invariant") {
    local();
    certify::Invariant v;
    v.prime = prime;
    v.m = m;
    v.p = p;
    for (std::size_t i = 0; i < e.size(); ++i) {
      const Singularity& place = c.local->finite[i];
      if (e[i] != 0 || place.order <= 2)
        v.factors.push_back({place.place, Rational(e[i], denominator)});
    }
    quadratic = v;
    return add(id, {}, std::move(v));
  }
  std::string invariant(const Invariant& v, const std::string& id = "invariant") {
    return invariant(v.m, v.p, v.e, 1, id);
  }
  [[nodiscard]] const InvariantSearch* search(long m) const {
    const auto found =
        std::ranges::find_if(c.invariants, [m](const InvariantSearch& s) { return s.m == m; });
    return found == c.invariants.end() ? nullptr : &*found;
  }
  // v = y1 y2, or its square root in a quadratic extension, from F = v^2
  std::string root_of_quartic() {
    const QuarticRoot root = quartic_root(search(4)->basis.front(), *c.local);
    return invariant(2, root.q, root.e, 2);
  }

  const Classification& c;
  const Budget& budget;
  certify::Certificate out;
  certify::Judge judge;
  std::optional<certify::LocalFact> fact; ///< the local data, as they are claimed
  PrimeIdeal prime;
  certify::Invariant quadratic;

private:
  void drop_unused_steps() {
    std::set<std::string> used{out.steps.back().id};
    for (auto s = out.steps.rbegin(); s != out.steps.rend(); ++s)
      if (used.count(s->id) == 1) used.insert(s->premises.begin(), s->premises.end());
    const auto idle = [&](const certify::Step& s) { return used.count(s.id) == 0; };
    out.steps.erase(std::remove_if(out.steps.begin(), out.steps.end(), idle), out.steps.end());
  }
  void claim() {
    if (c.group) {
      out.claim.group = to_string(c.group->type);
      out.claim.n = c.group->n;
      out.claim.component = to_string(identity_component(*c.group));
    }
    out.claim.abelian = certainly(c.abelian);
  }
};

// A rational v = y1 y2 with w != 0.
std::string product_of_lines(EquationSteps& w) {
  if (!w.c.local) return w.add("invariant", {}, certify::Invariant{w.prime, 2, Poly::z(), {}});
  const InvariantSearch* quartic = w.search(4);
  if (quartic && quartic->basis.size() == 1) return w.root_of_quartic();
  if (w.c.pair) return w.invariant(factored(w.c.pair->v, *w.c.local));
  const InvariantSearch* known = w.search(2);
  const InvariantSearch square = known ? *known : invariants(*w.c.local, 2, w.budget);
  // forms of rank 1 are squares of one line; of three forms or their sums one has rank 2
  for (std::size_t i = 0; i < square.basis.size(); ++i)
    for (std::size_t j = i; j < square.basis.size(); ++j) {
      Invariant v = square.basis[i];
      if (j != i) v.p += square.basis[j].p;
      const std::string id = w.invariant(v);
      if (certify::is_quadratic(certify::check_invariant(w.judge, w.quadratic))) return id;
      w.out.steps.pop_back();
    }
  throw InternalError("no product of two solutions is rational");
}

void abelian(EquationSteps& w) {
  if (w.c.abelian == Truth::yes)
    w.conclude("invariant-abelian", {w.root_of_quartic()});
  else
    w.conclude("torus-nonabelian", {w.local(), w.absent(4)});
}

// Often no exponent is needed: even if lines were exchanged at every place, B_p has other ones.
void sl2_by_p_curvature(EquationSteps& w) {
  const certify::PCurvature known{w.c.p_curvature->prime, "sl2"};
  w.local(witness::Detail::places);
  PrimeIdeals primes(w.out.field, 6);
  for (certify::PCurvature data = known; data.prime.p < 32; data.prime = primes.next()) {
    if (!w.shows_sl2(data)) continue;
    return w.conclude("sl2-p-curvature", {w.add("p-curvature", {"local"}, data)});
  }
  w.out.steps.clear();
  w.fact.reset();
  w.local();
  w.conclude("sl2-p-curvature", {w.add("p-curvature", {"local"}, known)});
}

void sl2(EquationSteps& w) {
  if (w.c.p_curvature) return sl2_by_p_curvature(w);
  const std::string no_line = w.irreducible();
  if (w.fact->has_log()) return w.conclude("sl2-irreducible-log", {"local", no_line});
  if (w.fact->infinite_order())
    return w.conclude("sl2-irreducible-infinite", {"local", no_line, w.absent(4)});
  w.conclude("sl2-irreducible-12", {no_line, w.absent(12)});
}

void additive(EquationSteps& w) {
  Ids premises{w.local(), w.exponential()};
  if (!w.fact->has_log()) premises.push_back(w.absent(2));
  w.conclude("additive", std::move(premises));
}

void diagonal(EquationSteps& w) {
  w.local();
  w.conclude("diagonal", {"local", product_of_lines(w)});
}

InfiniteTorsion infinite_torsion(const EquationSteps& w) {
  if (w.c.dihedral->curvatures) return *w.c.dihedral->curvatures;
  auto found = infinite_by_curvatures(*w.c.curve, *w.c.local, w.budget);
  if (!found) throw OutOfBudget("the p-curvatures of small primes do not suffice");
  return *std::move(found);
}

void infinite_dihedral(EquationSteps& w) {
  const std::string v = w.root_of_quartic();
  if (w.fact->infinite_order()) return w.conclude("dihedral-infinite", {"local", v});
  const auto fact = certify::check_invariant(w.judge, w.quadratic);
  if (fact.holomorphic_quotient()) return w.conclude("dihedral-holomorphic", {v});
  const InfiniteTorsion torsion = infinite_torsion(w);
  Ids premises{"local", v, w.add("reduction", {v}, certify::GoodReduction{torsion.good})};
  for (const PrimeIdeal& prime : torsion.nonzero)
    premises.push_back(
        w.add("p-curvature-" + std::to_string(prime.p), {}, certify::PCurvature{prime, "nonzero"}));
  w.conclude("dihedral-torsion", std::move(premises));
}

void finite_dihedral(EquationSteps& w) {
  const InvariantSearch& quartic = *w.search(4);
  if (quartic.basis.size() == 2) {
    const std::string no_line = w.irreducible();
    return w.conclude("quaternion", {no_line, w.invariant(quartic.basis[0]),
                                     w.invariant(quartic.basis[1], "second")});
  }
  const std::string v = w.root_of_quartic();
  if (w.c.curve->genus == 0) return w.conclude("dihedral-genus-0", {"local", v});
  const auto fact = certify::check_invariant(w.judge, w.quadratic);
  auto h = witness::torsion_function(w.judge, *w.c.curve, *w.c.dihedral, fact, *w.fact, w.budget);
  w.conclude("dihedral-finite", {v, w.add("torsion", {v, "local"}, std::move(h))});
}

void primitive(const std::string& theorem, long m, const std::vector<long>& none,
               EquationSteps& w) {
  Ids premises{w.irreducible()};
  for (const long k : none)
    premises.push_back(w.absent(k));
  premises.push_back(w.invariant(w.search(m)->basis.front()));
  w.conclude(theorem, std::move(premises));
}

void group(EquationSteps& w) {
  switch (w.c.group->type) {
  case GroupType::SL2:
    return sl2(w);
  case GroupType::Borel:
    return w.conclude("borel", {w.local(), w.exponential(), w.absent(4)});
  case GroupType::T:
    return additive(w);
  case GroupType::Gm:
  case GroupType::cyclic:
    return diagonal(w);
  case GroupType::Dinf:
    return infinite_dihedral(w);
  case GroupType::D:
    return finite_dihedral(w);
  case GroupType::A4:
    return primitive("tetrahedral", 6, {4}, w);
  case GroupType::S4:
    return primitive("octahedral", 8, {4, 6}, w);
  case GroupType::A5:
    return primitive("icosahedral", 12, {8}, w);
  }
}

} // namespace

certify::Certificate certificate(const Classification& c, const RationalFunction& r,
                                 const Budget& budget) {
  try {
    EquationSteps steps(c, r, budget);
    if (c.group)
      group(steps);
    else
      KOV_ENSURE(c.abelian != Truth::unknown), abelian(steps);
    return steps.finished();
  } catch (const certify::Refused& refused) {
    const std::string what = "the judge refuses a step: " + refused.why;
    if (refused.limit) throw OutOfBudget(what);
    throw RefusedByChecker(what);
  }
}

Judged judged(const certify::Certificate& c) {
  Judged j{certify::write_certificate(c), "", false};
  try {
    const auto verdict = certify::check(certify::read_certificate(j.json));
    if (const auto* no = std::get_if<certify::Rejected>(&verdict)) {
      j.refusal = "step '" + no->step + "': " + no->why;
      j.limit = no->limit;
    }
  } catch (const Error& e) {
    j.refusal = e.what();
    j.limit = true;
  }
  return j;
}

} // namespace kov
