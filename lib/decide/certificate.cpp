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

using certify::Theorem;
using Ids = std::vector<std::string>;

class Writer {
public:
  Writer(const Classification& c, const RationalFunction& r, const Budget& budget)
      : c_(c), r_(r), budget_(budget) {
    out_.field = common_field(r.num().field(), r.den().field());
    out_.num = coerce(r.num(), out_.field);
    out_.den = coerce(r.den(), out_.field);
    judge_ = {out_.field, {out_.num, out_.den}};
  }

  certify::Certificate run() {
    if (c_.group)
      group();
    else
      KOV_ENSURE(c_.abelian != Truth::unknown), abelian();
    claim();
    drop_unused_steps();
    return std::move(out_);
  }

private:
  void drop_unused_steps() {
    std::set<std::string> used{out_.steps.back().id};
    for (auto s = out_.steps.rbegin(); s != out_.steps.rend(); ++s)
      if (used.count(s->id) == 1) used.insert(s->premises.begin(), s->premises.end());
    const auto idle = [&](const certify::Step& s) { return used.count(s.id) == 0; };
    out_.steps.erase(std::remove_if(out_.steps.begin(), out_.steps.end(), idle), out_.steps.end());
  }
  void claim() {
    if (c_.group) {
      out_.claim.group = to_string(c_.group->type);
      out_.claim.n = c_.group->n;
      out_.claim.component = to_string(identity_component(*c_.group));
    }
    out_.claim.abelian = certainly(c_.abelian);
  }

  std::string add(std::string id, Ids premises, certify::Rule rule) {
    out_.steps.push_back({id, std::move(premises), std::move(rule)});
    return id;
  }
  void conclude(Theorem theorem, Ids premises) {
    add("conclusion", std::move(premises), certify::Conclude{theorem});
  }

  // --- steps; each is written once ---------------------------------------------------------------

  std::string local(witness::Detail detail = witness::Detail::exponents) {
    if (local_) return "local";
    certify::Local data;
    if (c_.local)
      data = witness::local(judge_, *c_.local, detail, budget_);
    else
      data.prime = PrimeIdeals::large(out_.field).next(); // r = 0
    prime_ = data.prime;
    local_ = certify::claimed_local(judge_, data);
    return add("local", {}, std::move(data));
  }

  std::string exponential() {
    const ExponentialSolution& y = *c_.exponential;
    return add("exponential", {}, certify::Exponential{y.p, y.theta.num(), y.theta.den()});
  }

  // G is irreducible.
  std::string irreducible() {
    local(witness::Detail::growth);
    return add("irreducible", {"local"},
               witness::no_exponential(judge_, *c_.local, *local_, budget_));
  }

  std::string absent(long m) {
    local();
    return add("no-invariant-" + std::to_string(m), {"local"},
               witness::no_invariant(judge_, m, *local_, budget_));
  }

  // v = p prod q^e over the places, exponents in units of 1/denominator
  std::string invariant(long m, const Poly& p, const std::vector<long>& e, long denominator,
                        const std::string& id = "invariant") {
    local();
    certify::Invariant v;
    v.prime = prime_;
    v.m = m;
    v.p = p;
    for (std::size_t i = 0; i < e.size(); ++i) {
      const Singularity& place = c_.local->finite[i];
      if (e[i] != 0 || place.order <= 2)
        v.factors.push_back({place.place, Rational(e[i], denominator)});
    }
    quadratic_ = v;
    return add(id, {}, std::move(v));
  }
  std::string invariant(const Invariant& v, const std::string& id = "invariant") {
    return invariant(v.m, v.p, v.e, 1, id);
  }
  [[nodiscard]] const InvariantSearch* search(long m) const {
    const auto found =
        std::ranges::find_if(c_.invariants, [m](const InvariantSearch& s) { return s.m == m; });
    return found == c_.invariants.end() ? nullptr : &*found;
  }
  // v = y1 y2, or its square root in a quadratic extension, from F = v^2
  std::string root_of_quartic() {
    const QuarticRoot root = quartic_root(search(4)->basis.front(), *c_.local);
    return invariant(2, root.q, root.e, 2);
  }

  // --- conclusions -------------------------------------------------------------------------------

  void abelian() {
    if (c_.abelian == Truth::yes)
      conclude(Theorem::invariant_abelian, {root_of_quartic()});
    else
      conclude(Theorem::torus_nonabelian, {local(), absent(4)});
  }

  void group() {
    switch (c_.group->type) {
    case GroupType::SL2:
      return sl2();
    case GroupType::Borel:
      return conclude(Theorem::borel, {local(), exponential(), absent(4)});
    case GroupType::T:
      return additive();
    case GroupType::Gm:
    case GroupType::cyclic:
      return diagonal();
    case GroupType::Dinf:
      return infinite_dihedral();
    case GroupType::D:
      return finite_dihedral();
    case GroupType::A4:
      return primitive(Theorem::tetrahedral, 6, {4});
    case GroupType::S4:
      return primitive(Theorem::octahedral, 8, {4, 6});
    case GroupType::A5:
      return primitive(Theorem::icosahedral, 12, {8});
    }
  }

  void sl2() {
    if (c_.p_curvature) return sl2_by_p_curvature();
    const std::string no_line = irreducible();
    if (local_->has_log()) return conclude(Theorem::sl2_irreducible_log, {"local", no_line});
    if (local_->infinite_order())
      return conclude(Theorem::sl2_irreducible_infinite, {"local", no_line, absent(4)});
    conclude(Theorem::sl2_irreducible_12, {no_line, absent(12)});
  }

  // Often no exponent is needed: even if lines were exchanged at every place, B_p has other ones.
  void sl2_by_p_curvature() {
    const certify::PCurvature known{c_.p_curvature->prime, "sl2"};
    local(witness::Detail::places);
    PrimeIdeals primes(out_.field, 6);
    for (certify::PCurvature data = known; data.prime.p < 32; data.prime = primes.next()) {
      if (!shows_sl2(data)) continue;
      return conclude(Theorem::sl2_p_curvature, {add("p-curvature", {"local"}, data)});
    }
    out_.steps.clear();
    local_.reset();
    local();
    conclude(Theorem::sl2_p_curvature, {add("p-curvature", {"local"}, known)});
  }
  [[nodiscard]] bool shows_sl2(const certify::PCurvature& data) const {
    return tried<certify::Refused>(
        [&] { static_cast<void>(certify::check_p_curvature(judge_, data, &*local_)); });
  }

  void additive() {
    Ids premises{local(), exponential()};
    if (!local_->has_log()) premises.push_back(absent(2));
    conclude(Theorem::additive, std::move(premises));
  }

  void diagonal() {
    local();
    conclude(Theorem::diagonal, {"local", product_of_lines()});
  }

  // v = p prod q^e; y1 y2 has no other poles.
  [[nodiscard]] Invariant factored(const RationalFunction& v) const {
    Invariant found{2, v.num(), {}};
    for (const Singularity& place : c_.local->finite) {
      const auto [zeros, rest] = remove_factor(found.p, place.place);
      found.e.push_back(zeros - remove_factor(v.den(), place.place).first);
      found.p = rest;
    }
    found.p = scale(found.p, inverse(lead(found.p)));
    return found;
  }
  // A rational v = y1 y2 with w != 0.
  std::string product_of_lines() {
    if (!c_.local) return add("invariant", {}, certify::Invariant{prime_, 2, Poly::z(), {}});
    const InvariantSearch* quartic = search(4);
    if (quartic && quartic->basis.size() == 1) return root_of_quartic();
    if (c_.pair) return invariant(factored(c_.pair->v));
    const InvariantSearch* known = search(2);
    const InvariantSearch square = known ? *known : invariants(*c_.local, 2, budget_);
    // forms of rank 1 are squares of one line; of three forms or their sums one has rank 2
    for (std::size_t i = 0; i < square.basis.size(); ++i)
      for (std::size_t j = i; j < square.basis.size(); ++j) {
        Invariant v = square.basis[i];
        if (j != i) v.p += square.basis[j].p;
        const std::string id = invariant(v);
        if (certify::is_quadratic(certify::check_invariant(judge_, quadratic_))) return id;
        out_.steps.pop_back();
      }
    throw InternalError("no product of two solutions is rational");
  }

  void infinite_dihedral() {
    const std::string v = root_of_quartic();
    if (local_->infinite_order()) return conclude(Theorem::dihedral_infinite, {"local", v});
    const auto fact = certify::check_invariant(judge_, quadratic_);
    if (fact.holomorphic_quotient()) return conclude(Theorem::dihedral_holomorphic, {v});
    const InfiniteTorsion torsion = infinite_torsion();
    Ids premises{"local", v, add("reduction", {v}, certify::GoodReduction{torsion.good})};
    for (const PrimeIdeal& prime : torsion.nonzero)
      premises.push_back(
          add("p-curvature-" + std::to_string(prime.p), {}, certify::PCurvature{prime, "nonzero"}));
    conclude(Theorem::dihedral_torsion, std::move(premises));
  }
  [[nodiscard]] InfiniteTorsion infinite_torsion() const {
    if (c_.dihedral->curvatures) return *c_.dihedral->curvatures;
    auto found = infinite_by_curvatures(*c_.curve, *c_.local, budget_);
    if (!found) throw OutOfBudget("the p-curvatures of small primes do not suffice");
    return *std::move(found);
  }

  void finite_dihedral() {
    const InvariantSearch& quartic = *search(4);
    if (quartic.basis.size() == 2) {
      const std::string no_line = irreducible();
      return conclude(Theorem::quaternion, {no_line, invariant(quartic.basis[0]),
                                            invariant(quartic.basis[1], "second")});
    }
    const std::string v = root_of_quartic();
    if (c_.curve->genus == 0) return conclude(Theorem::dihedral_genus_0, {"local", v});
    const auto fact = certify::check_invariant(judge_, quadratic_);
    auto h = witness::torsion_function(judge_, *c_.curve, *c_.dihedral, fact, *local_, budget_);
    conclude(Theorem::dihedral_finite, {v, add("torsion", {v, "local"}, std::move(h))});
  }

  void primitive(Theorem theorem, long m, const std::vector<long>& none) {
    Ids premises{irreducible()};
    for (const long k : none)
      premises.push_back(absent(k));
    premises.push_back(invariant(search(m)->basis.front()));
    conclude(theorem, std::move(premises));
  }

  const Classification& c_;
  const RationalFunction& r_;
  const Budget& budget_;
  certify::Certificate out_;
  certify::Judge judge_;
  std::optional<certify::LocalFact> local_;
  PrimeIdeal prime_;
  certify::Invariant quadratic_;
};

} // namespace

certify::Certificate certificate(const Classification& c, const RationalFunction& r,
                                 const Budget& budget) {
  try {
    return Writer(c, r, budget).run();
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
