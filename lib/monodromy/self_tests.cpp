#include "monodromy/self_tests.hpp"

#include "linode/singularities.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

// Throws: an enclosure that misses what is known is wrong.
void ensure(bool passed, const std::string& what, const std::string& place) {
  if (!passed)
    throw InternalError("a monodromy matrix fails its self-test: " + what +
                        (place.empty() ? "" : ", at z = " + place));
}

bool overlap(const ComplexBall& a, const ComplexBall& b) {
  return acb_overlaps(a.raw(), b.raw()) != 0;
}

BallMatrix ordered_product(const Monodromy& m) {
  BallMatrix product = BallMatrix::identity(m.loops.front().matrix.size());
  for (const LoopMatrix& l : m.loops)
    product = multiply(l.matrix, product, m.bits);
  return product;
}

// exp(2 pi i residue of f at the root `at` of q); nothing at a pole of order two or more.
std::optional<ComplexBall> exponential_of_residue(const RationalFunction& f, const SingularPoint& p,
                                                  long bits) {
  const Poly q = coerce(p.factor, f.field());
  ComplexBall value;
  acb_one(value.raw());
  const auto [order, rest] = remove_factor(f.den(), q);
  if (order == 0) return value;
  if (order > 1) return std::nullopt;
  const ComplexBall num = evaluate(f.num(), p.at, bits);
  const ComplexBall den = evaluate(derivative(f.den()), p.at, bits);
  acb_div(value.raw(), num.raw(), den.raw(), bits);
  acb_mul_2exp_si(value.raw(), value.raw(), 1);
  acb_exp_pi_i(value.raw(), value.raw(), bits);
  return value;
}

bool test_determinants(const DifferentialSystem& s, const Monodromy& m) {
  const RationalFunction f = coerce(trace(s), s.field);
  bool any = false;
  for (const LoopMatrix& l : m.loops)
    if (const auto expected = exponential_of_residue(f, l.place, m.bits)) {
      ensure(overlap(*expected, determinant(l.matrix, m.bits)), "the determinant",
             to_string(l.place));
      any = true;
    }
  return any;
}

// 2 cos(pi Delta) for Delta^2 at the place.
ComplexBall twice_cosine(const Singularity& s, const ComplexBall& at, long bits) {
  ComplexBall delta = evaluate(s.delta_squared, at, bits);
  acb_sqrt(delta.raw(), delta.raw(), bits);
  acb_cos_pi(delta.raw(), delta.raw(), bits);
  acb_mul_2exp_si(delta.raw(), delta.raw(), 1);
  return delta;
}

// The place of the normal form that the point lies on; null where r is regular.
const Singularity* place_of(const Singularities& all, const SingularPoint& p) {
  const auto it = std::ranges::find_if(all.finite, [&](const Singularity& s) {
    return s.place == coerce(p.factor, s.place.field());
  });
  return it == all.finite.end() ? nullptr : &*it;
}

bool regular(const Singularity* s) {
  return s == nullptr || s->kind == PlaceKind::simple || s->kind == PlaceKind::regular;
}

} // namespace

std::vector<std::string> tested_identities(const DifferentialSystem& s, const Monodromy& m) {
  std::vector<std::string> passed;
  if (m.loops.empty()) return passed;
  if (m.large_circle) {
    ensure(overlap(ordered_product(m), *m.large_circle), "the ordered product", "");
    passed.emplace_back("the ordered product meets the large circle");
  }
  if (test_determinants(s, m)) passed.emplace_back("the determinants contain exp(2 pi i res tr A)");
  return passed;
}

std::vector<std::string> tested_traces(const NormalForm& equation, const Monodromy& m,
                                       const Budget& budget) {
  if (is_zero(equation.r)) return {};
  const Singularities all = singularities(equation.r, budget);
  bool any = false;
  for (const LoopMatrix& l : m.loops) {
    const Singularity* s = place_of(all, l.place);
    if (!regular(s)) continue;
    const ComplexBall at = l.place.at;
    const Singularity none;
    ComplexBall expected = twice_cosine(s == nullptr ? none : *s, at, m.bits);
    ComplexBall found = trace(l.matrix, m.bits);
    if (is_zero(equation.p)) {
      acb_neg(expected.raw(), expected.raw());
    } else {
      const ComplexBall det = determinant(l.matrix, m.bits);
      acb_sqr(expected.raw(), expected.raw(), m.bits);
      acb_mul(expected.raw(), expected.raw(), det.raw(), m.bits);
      acb_sqr(found.raw(), found.raw(), m.bits);
    }
    ensure(overlap(expected, found), "the trace", to_string(l.place));
    any = true;
  }
  return any ? std::vector<std::string>{"the traces contain -2 cos(pi Delta)"}
             : std::vector<std::string>{};
}

} // namespace kov::monodromy
