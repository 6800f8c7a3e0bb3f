#include "monodromy/local_system.hpp"

#include "monodromy/imprecise.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

Coefficients embedded(const Poly& f, long bits) {
  Coefficients c;
  for (long i = 0; i <= degree(f); ++i)
    c.push_back(embed(f.coeff(i), bits));
  return c;
}

// f(scale t) factor
void stretch(Coefficients& f, const Ball& scale, Ball factor, long precision) {
  for (ComplexBall& a : f) {
    acb_mul_arb(a.raw(), a.raw(), factor.raw(), precision);
    arb_mul(factor.raw(), factor.raw(), scale.raw(), precision);
  }
}

void round(Coefficients& f, long bits) {
  for (ComplexBall& a : f)
    acb_set_round(a.raw(), a.raw(), bits);
}

} // namespace

Coefficients shifted(Coefficients f, const ComplexBall& c, long bits) {
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    for (std::size_t j = f.size() - 1; j-- > i;)
      acb_addmul(f[j].raw(), f[j + 1].raw(), c.raw(), bits);
  return f;
}

EmbeddedSystem::EmbeddedSystem(const DifferentialSystem& s, long bits)
    : precision_(s.field->is_rational() ? ARF_PREC_EXACT : bits) {
  for (const Row& row : s.rows) {
    LocalRow e{embedded(row.den, precision_), {}};
    for (const Poly& f : row.num)
      e.num.push_back(embedded(f, precision_));
    rows_.push_back(std::move(e));
  }
}

LocalSystem EmbeddedSystem::at(const ComplexBall& c, const Ball& scale, long bits) const {
  LocalSystem s;
  const auto local = [&](const Coefficients& f, const Ball& factor) {
    Coefficients g = shifted(f, c, precision_);
    stretch(g, scale, factor, precision_);
    round(g, bits);
    s.degree = std::max(s.degree, static_cast<long>(g.size()) - 1);
    return g;
  };
  Ball one;
  arb_one(one.raw());
  for (const LocalRow& e : rows_) {
    LocalRow row{local(e.den, one), {}};
    if (acb_contains_zero(row.den.front().raw()) != 0)
      throw Imprecise("a centre of expansion cannot be told from a singularity");
    for (const Coefficients& f : e.num)
      row.num.push_back(local(f, scale));
    s.rows.push_back(std::move(row));
  }
  return s;
}

} // namespace kov::monodromy
