#include "strata/classical_certificate.hpp"

#include "certify/strata/classical.hpp"
#include "exact/error.hpp"
#include "parameters/integers.hpp"
#include "strata/leaf_certificate.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using certify::ByClassical;
using certify::Fraction;

Fraction fraction_of(const MFraction& f, const Ring& ring) {
  if (!f.ring()) return {MPoly(ring), MPoly(ring, Integer(1))};
  return {f.num(), f.den()};
}

class ClassicalWriter {
public:
  ClassicalWriter(const ClassicalAnswer& answer, const ParametrisedSet& region, KnownFacts& facts,
                  std::vector<Lemma>& lemmas)
      : answer_(answer), form_(*answer.equation), region_(region), facts_(facts), lemmas_(lemmas),
        ring_(form_.r.ring()) {}

  certify::LeafNode operator()(Truth abelian) {
    leaf_.change = fraction_of(answer_.x, ring_);
    leaf_.equation = fraction_of(form_.r, ring_);
    need_change();
    if (form_.factors.empty())
      confluent();
    else
      places();
    for (const MFraction& square : form_.numbers)
      add_number(square);
    if (abelian == Truth::unknown) return {std::nullopt, std::move(leaf_)};
    certify::Arithmetic arithmetic;
    const certify::ParameterFacts facts{
        [this](const Fraction& f) { return shown(f); },
        [this](const MPoly& p) {
          return std::ranges::all_of(used_variables(p),
                                     [&](std::size_t i) { return region_.is_rational(i); });
        },
        [this](const MPoly& p) { return facts_.ensure_positive(p, lemmas_); }, form_.z};
    if (certify::criterion_holds(leaf_, facts, arithmetic) != abelian)
      throw NoProof(Gap::rule,
                    "what is assumed of integers does not settle the criterion by itself");
    return {abelian == Truth::yes, std::move(leaf_)};
  }

private:
  void need(const MPoly& p) {
    if (!facts_.ensure_nonzero(p, lemmas_))
      throw NoProof(Gap::places, "a change of variable: " + brief(MFraction(p), 120) +
                                     " != 0 has no exact proof");
  }
  // The derivative of the change of variable is not 0.
  void need_change() {
    const auto& [p, q] = leaf_.change;
    const MPoly wronskian = derivative(p, form_.z) * q - p * derivative(q, form_.z);
    const auto c = coefficients(wronskian, form_.z);
    if (std::ranges::none_of(c, [&](const MPoly& f) { return facts_.ensure_nonzero(f, lemmas_); }))
      throw NoProof(Gap::places, "the change of variable may be constant");
  }
  // num/(e z^2)
  void confluent() {
    const MPoly x = MPoly::variable(ring_, form_.z);
    auto& [num, den] = leaf_.equation;
    while (degree(den, form_.z) < 2) {
      num = num * x;
      den = den * x;
    }
    need(coefficients(num, form_.z).back());
    need(coefficients(den, form_.z).back());
    leaf_.family = degree(num, form_.z) == 2 ? "whittaker" : "bessel";
  }
  // num/(e P^2)
  void places() {
    leaf_.family = answer_.form.family == Classical::lame ? "lame" : "riemann";
    leaf_.factors = form_.factors;
    MPoly product(ring_, Integer(1));
    for (const MPoly& q : form_.factors)
      product = product * q;
    auto& [num, den] = leaf_.equation;
    for (const MPoly& q : form_.factors)
      while (!divides(q * q, den)) {
        num = num * q;
        den = den * q;
      }
    need(exact_div(den, product * product));
    need(coefficients(product, form_.z).back());
    need(resultant(product, derivative(product, form_.z), form_.z));
  }
  void add_number(const MFraction& square) {
    leaf_.numbers.push_back({fraction_of(square, ring_)});
    need(leaf_.numbers.back().square.den);
    const auto root = square_root(square);
    if (!root || is_constant(square)) return;
    leaf_.numbers.back().root = fraction_of(*root, ring_);
    need(leaf_.numbers.back().root->den);
  }

  // Assumed memberships that make the value an integer, or none.
  Truth shown(const Fraction& f) {
    const MFraction value(f.num, f.den);
    const auto proof = integer_proof(facts_.memberships(), value);
    if (!proof || !facts_.ensure_nonzero(value.den(), lemmas_)) return Truth::unknown;
    add(as_shown(*proof, {value.num(), value.den()}));
    return truth(proof->integral);
  }
  // One membership w stands alone: the one that says "none", or one of the integers; n w is
  // (n + 1) w - w.
  [[nodiscard]] static certify::ShownMembership as_shown(const IntegerProof& proof,
                                                         Fraction value) {
    std::vector<Integer> left = proof.sum;
    const auto alone = std::ranges::find_if(
        left, [&](const Integer& n) { return proof.integral ? !is_zero(n) : n == Integer(-1); });
    const auto some = alone != left.end()
                          ? alone
                          : std::ranges::find_if(left, [](auto& n) { return !is_zero(n); });
    certify::ShownMembership x{std::move(value), proof.integral, proof.times, 0, {}};
    if (proof.none) {
      x.membership = *proof.none;
    } else {
      x.membership = static_cast<std::size_t>(some - left.begin());
      if (proof.integral) x.times = *some;
      *some = proof.integral ? Integer(0) : *some + Integer(1);
    }
    for (std::size_t i = 0; i < left.size(); ++i)
      if (!is_zero(left[i])) x.with.push_back({left[i], i});
    return x;
  }
  void add(certify::ShownMembership x) {
    const bool old = std::ranges::any_of(leaf_.shown, [&](const auto& y) {
      return y.value.num == x.value.num && y.value.den == x.value.den;
    });
    if (!old) leaf_.shown.push_back(std::move(x));
  }

  const ClassicalAnswer& answer_;
  const ClassicalEquation& form_;
  const ParametrisedSet& region_;
  KnownFacts& facts_;
  std::vector<Lemma>& lemmas_;
  Ring ring_;
  ByClassical leaf_;
};

} // namespace

certify::LeafNode classical_leaf(const ClassicalAnswer& answer, Truth abelian,
                                 const ParametrisedSet& region, KnownFacts& facts,
                                 std::vector<Lemma>& lemmas) {
  if (!answer.equation)
    throw NoProof(Gap::rule, "the format has no rule for this classical criterion");
  return ClassicalWriter(answer, region, facts, lemmas)(abelian);
}

} // namespace kov::strata
