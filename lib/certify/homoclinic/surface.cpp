#include "certify/homoclinic/surface.hpp"

namespace kov::certify {
namespace {

constexpr int sharpenings = 8;
constexpr long widest_sheet = -6, narrowest_sheet = -57, next_sheet = 3; // binary logarithms

Interval determinant(const TwoRows& a) { return a[0][0] * a[1][1] - a[0][1] * a[1][0]; }

TwoNumbers applied(const TwoRows& a, const TwoNumbers& v) {
  return {a[0][0] * v[0] + a[0][1] * v[1], a[1][0] * v[0] + a[1][1] * v[1]};
}

std::vector<std::size_t> others(const Chart& c) {
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != c[0] && i != c[1]) rest.push_back(i);
  return rest;
}

Point joined(const Chart& chart, const std::vector<std::size_t>& rest, const TwoNumbers& free,
             const TwoNumbers& solved) {
  Point x;
  for (std::size_t k = 0; k < 2; ++k) {
    x[chart[k]] = free[k];
    x[rest[k]] = solved[k];
  }
  return x;
}

std::vector<PhaseFunction> gradients(const PhaseFunction& f, const PhaseFunction& g) {
  std::vector<PhaseFunction> all;
  for (const PhaseFunction* h : {&f, &g})
    for (std::size_t i = 0; i < 4; ++i)
      all.push_back(partial(*h, i));
  return all;
}

} // namespace

TwoRows product(const TwoRows& a, const TwoRows& b) {
  TwoRows c;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  return c;
}

TwoRows inverse(const TwoRows& a) {
  const Interval d = determinant(a);
  return {{{a[1][1] / d, -a[0][1] / d}, {-a[1][0] / d, a[0][0] / d}}};
}

TwoRows Carried::by_chart(const Chart& c) const {
  return {{{jet[1][c[0]], jet[2][c[0]]}, {jet[1][c[1]], jet[2][c[1]]}}};
}

LevelSurface::LevelSurface(const HomoclinicCertificate& c)
    : values_({c.section, c.hamiltonian}), slopes_(gradients(c.section, c.hamiltonian)),
      level_(c.level), period_(c.period), flow_(c.hamiltonian, c.section, c.where, c.rising) {}

LevelSurface::Local LevelSurface::local(const Chart& chart, const std::vector<std::size_t>& rest,
                                        const Point& x) const {
  const auto value = values_.at(x), by = slopes_.at(x);
  Local l{{value[0], value[1] - level_}, {}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      l.by_chart[i][k] = by[4 * i + chart[k]];
      l.by_rest[i][k] = by[4 * i + rest[k]];
    }
  return l;
}

Chart LevelSurface::chart_at(const Point& x) const {
  Chart best{};
  double most = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Chart c{i, j};
      const double d = std::abs(determinant(local(c, others(c), x).by_rest).about());
      if (d > most) {
        most = d;
        best = c;
      }
    }
  return best;
}

// Interval Newton over the box and the sheet: y - (by rest)^-1 (value at y) inside the sheet.
bool LevelSurface::find_sheet(SurfacePatch& p, const TwoNumbers& y, Point& found) const {
  const Local over = local(p.chart, p.rest, joined(p.chart, p.rest, p.box, p.sheet));
  const Local here = local(p.chart, p.rest, joined(p.chart, p.rest, p.box, y));
  const TwoNumbers step = applied(inverse(over.by_rest), here.value);
  const TwoNumbers solved{y[0] - step[0], y[1] - step[1]};
  found = joined(p.chart, p.rest, p.box, solved);
  return p.holds(found);
}

SurfacePatch LevelSurface::patch(const Chart& chart, const TwoNumbers& box,
                                 const Point& near) const {
  SurfacePatch p{chart, box, others(chart), {}, Jet(3)};
  TwoNumbers y{near[p.rest[0]].middle(), near[p.rest[1]].middle()};
  const TwoNumbers middle{box[0].middle(), box[1].middle()};
  for (int i = 0; i < sharpenings; ++i) {
    const Local l = local(chart, p.rest, joined(chart, p.rest, middle, y));
    const TwoNumbers step = applied(inverse(l.by_rest), l.value);
    for (std::size_t k = 0; k < 2; ++k)
      y[k] = (y[k] - step[k]).middle();
  }
  bool held = false;
  for (long room = widest_sheet; !held && room >= narrowest_sheet; room -= next_sheet) {
    p.sheet = {y[0].wider(power_of_two(room)), y[1].wider(power_of_two(room))};
    held = find_sheet(p, y, p.at[0]);
  }
  need(held, "a piece of the surface is not enclosed");
  const Local l = local(chart, p.rest, p.at[0]);
  const TwoRows slopes = product(inverse(l.by_rest), l.by_chart);
  for (std::size_t part = 0; part < 2; ++part) { // of the implicit functions
    p.at[1 + part][chart[part]] = Interval(1);
    for (std::size_t k = 0; k < 2; ++k)
      p.at[1 + part][p.rest[k]] = -slopes[k][part];
  }
  return p;
}

Carried LevelSurface::carried(const SurfacePatch& from, int way) {
  const TwoNumbers middle{from.box[0].middle(), from.box[1].middle()};
  const TwoNumbers off{from.box[0] - middle[0], from.box[1] - middle[1]};
  const SurfacePatch point = patch(from.chart, middle, from.at[0]);
  need(from.holds(point.at[0]), "the middle of a patch is not known to lie on its sheet");
  Jet x = from.at, thin{point.at[0]};
  for (long k = 0; k < period_; ++k)
    flow_.to_crossing(x, thin, off, way);
  return {x[0], thin[0], x};
}

} // namespace kov::certify
