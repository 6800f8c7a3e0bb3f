#include "strata/formula_certificate.hpp"

#include "certify/strata/check.hpp"
#include "closed/criteria.hpp"
#include "closed/whittaker_pull_back.hpp"
#include "exact/error.hpp"
#include "places/scheme.hpp"
#include "strata/classical_certificate.hpp"
#include "strata/leaf_certificate.hpp"

namespace kov::strata {
namespace {

constexpr std::size_t z = 0; // the only variable of the ring

// u'' = (a + b/x + c/x^2) u in x = f(z)
ClassicalAnswer whittaker(const WhittakerPullBack& w, const Ring& ring) {
  const MFraction x = MFraction::variable(ring, z);
  const auto number = [&](const NfElem& c) { return MFraction(ring, to_rational(c)); };
  ClassicalEquation e{z, number(w.a) + number(w.b) / x + number(w.c) / (x * x), {}, {}};
  e.numbers = {number(w.b * w.b / (NfElem(4) * w.a)), number(w.c + NfElem(Rational(1, 4)))};
  ClassicalAnswer answer;
  answer.x = from_rational_function(w.f, ring, z);
  answer.form.family = is_zero(w.b) ? Classical::bessel : Classical::whittaker;
  answer.equation = std::move(e);
  return answer;
}

// The equation itself, after a Moebius map, or Whittaker's after any change of variable.
std::optional<ClassicalAnswer> classical(const Decision& d, const MFraction& r,
                                         const ParametrisedSet& everywhere, const Budget& budget) {
  try {
    const auto places = scheme(r, z, everywhere, budget);
    if (const auto* s = std::get_if<Scheme>(&places)) {
      auto answer = classical_answer(*s, everywhere, budget);
      if (auto* found = std::get_if<ClassicalAnswer>(&answer); found && found->equation)
        return std::move(*found);
    }
  } catch (const OutOfBudget&) { // exponents that are too large for a look at logarithms
    budget.check();
  }
  const auto behind = whittaker_pull_back(*d.places, budget);
  if (!behind || !behind->f.field()->is_rational()) return std::nullopt;
  return whittaker(*behind, r.ring());
}

Judged opinion(std::string json) {
  try {
    const auto answer = certify::check_strata(certify::read_strata_certificate(json));
    if (const auto* no = std::get_if<certify::Rejected>(&answer))
      return {std::move(json), no->why, no->limit};
  } catch (const InvalidArgument& e) {
    return {std::move(json), e.what(), true};
  }
  return {std::move(json), "", false};
}

} // namespace

std::optional<Judged> formula_certificate(const Decision& d, const Budget& budget) {
  if (!d.r.field()->is_rational() || d.abelian == Truth::unknown) return std::nullopt;
  const Ring ring = make_ring({d.variable});
  const MFraction r = from_rational_function(d.r, ring, z);
  const ParametrisedSet everywhere(ring, {});
  const auto answer = classical(d, r, everywhere, budget);
  if (!answer) return std::nullopt;
  KnownFacts facts(ring, {}, {});
  std::vector<Lemma> lemmas;
  certify::StrataCertificate whole;
  whole.ring = ring;
  whole.variable = z;
  whole.real = whole.rational = {false};
  whole.r = {r.num(), r.den()};
  whole.abelian = d.abelian == Truth::yes;
  try {
    auto leaf = classical_leaf(*answer, d.abelian, everywhere, facts, lemmas);
    KOV_ENSURE(lemmas.empty()); // there are no parameters
    whole.tree = std::make_unique<const certify::StrataNode>(certify::StrataNode{std::move(leaf)});
  } catch (const NoProof&) {
    return std::nullopt;
  }
  return opinion(certify::write_strata_certificate(whole));
}

} // namespace kov::strata
