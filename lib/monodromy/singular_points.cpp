#include "monodromy/singular_points.hpp"

#include "exact/factor.hpp"

namespace kov::monodromy {
namespace {

constexpr long most_root_bits = 1L << 16;

// Over Q, f squarefree.
std::vector<ComplexBall> rational_roots(const Poly& f, long bits) {
  fmpz_poly_t g;
  fmpz_poly_init(g);
  fmpq_poly_get_numerator(g, f.raw());
  const slong n = fmpz_poly_degree(g);
  acb_ptr z = _acb_vec_init(n);
  arb_fmpz_poly_complex_roots(z, g, 0, bits);
  std::vector<ComplexBall> roots(static_cast<std::size_t>(n));
  for (slong i = 0; i < n; ++i)
    acb_set(roots[static_cast<std::size_t>(i)].raw(), z + i);
  _acb_vec_clear(z, n);
  fmpz_poly_clear(g);
  return roots;
}

// Roots of different factors are different numbers; their enclosures must be, too.
void ensure_disjoint(const std::vector<SingularPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (acb_overlaps(points[i].at.raw(), points[j].at.raw()) != 0)
        throw OutOfBudget("two singularities are too near to each other");
}

Poly squarefree_part(const Poly& f) { return exact_div(f, gcd(f, derivative(f))); }

} // namespace

// Over K the roots are among those of the norm; exactly deg f of these are roots of f, so as soon
// as only deg f values can be 0, those are.
std::vector<ComplexBall> embedded_roots(const Poly& f, long bits) {
  if (degree(f) < 1) return {};
  if (f.field()->is_rational()) return rational_roots(f, bits);
  const Poly all = squarefree_part(norm(f));
  for (long precision = bits + 64; precision <= most_root_bits; precision *= 2) {
    std::vector<ComplexBall> kept;
    for (const ComplexBall& z : rational_roots(all, precision))
      if (acb_contains_zero(evaluate(f, z, precision).raw()) != 0) kept.push_back(z);
    if (static_cast<long>(kept.size()) == degree(f)) return kept;
  }
  throw OutOfBudget("the singularities could not be told apart with " +
                    std::to_string(most_root_bits) + " bits");
}

std::vector<SingularPoint> singular_points(const DifferentialSystem& s, long bits,
                                           const Budget& budget) {
  const Poly common = common_denominator(s);
  std::vector<SingularPoint> points;
  if (degree(common) < 1) return points;
  for (const Factor& f : irreducible_factors(common, budget)) {
    budget.check();
    for (const ComplexBall& z : embedded_roots(f.base, bits))
      points.push_back({f.base, z});
  }
  ensure_disjoint(points);
  return points;
}

std::string to_string(const SingularPoint& p, const std::string& variable, long digits) {
  if (degree(p.factor) == 1) return kov::to_string(-p.factor.coeff(0));
  const auto text = [digits](const arb_struct* x) {
    char* decimal = arb_get_str(x, digits, ARB_STR_NO_RADIUS);
    std::string s = decimal;
    flint_free(decimal);
    return s;
  };
  std::string approx = text(acb_realref(p.at.raw()));
  if (arb_contains_zero(acb_imagref(p.at.raw())) == 0) {
    const std::string im = text(acb_imagref(p.at.raw()));
    approx += im.front() == '-' ? " - " + im.substr(1) + "*I" : " + " + im + "*I";
  }
  return "root(" + kov::to_string(p.factor, variable) + ", " + approx + ")";
}

} // namespace kov::monodromy
