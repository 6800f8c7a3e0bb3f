#include "jets/certificate.hpp"

#include "certify/jets/check.hpp"
#include "exact/error.hpp"
#include "exact/factors.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace kov::jets {
namespace {

/// Thrown when the format has no words for a finding.
class NoWords : public Error {
  using Error::Error;
};

// The names of the constants, and those of the phase space.
std::pair<Ring, Ring> rings(const System& whole, const Subspace& inside,
                            const InvariantPlane& plane) {
  const VectorField& v = inside.system.field;
  const MFraction& h = *whole.field.hamiltonian;
  const Ring& from = inside.system.ring();
  std::vector<std::string> field, phase;
  const std::size_t n = whole.field.dimension() / 2;
  for (const std::size_t half : {0, 1}) { // positions, momenta
    for (const std::size_t i : {2 * half, 2 * half + 1})
      phase.push_back(from->name(v.coordinates[i]));
    for (const std::size_t l : inside.others)
      phase.push_back(from->name(whole.field.coordinates[l + half * n]));
  }
  for (const std::size_t i : v.constants)
    field.push_back(from->name(i));
  const std::vector<std::string> constants = field;
  field.push_back(plane.ring->name(plane.e));
  const auto used = used_variables(h);
  for (const std::size_t i : v.parameters) {
    const bool in_relation = plane.relation && uses(*plane.relation, i);
    if (!in_relation && !is_among(i, used)) continue;
    field.push_back(from->name(i));
    phase.push_back(from->name(i));
  }
  phase.insert(phase.end(), constants.begin(), constants.end());
  field.push_back(plane.ring->name(plane.c1));
  field.push_back(plane.ring->name(plane.c2));
  return {make_ring(std::move(field)), make_ring(std::move(phase))};
}

MFraction minor(const std::vector<MFraction>& r, long n, const std::array<long, 3>& columns,
                const InvariantPlane& plane) {
  std::vector<std::vector<MFraction>> m;
  for (const long j : columns) {
    const auto i = static_cast<std::size_t>(j);
    m.push_back(
        {Rational(n - j + 1) * r[i], Rational(n - 2 * j) * r[i + 1], Rational(j + 1) * r[i + 2]});
  }
  return plane.reduced(determinant(m, plane.ring));
}

class JetsWriter {
public:
  JetsWriter(const System& whole, const Subspace& inside, const HigherObstruction& o)
      : whole_(whole), inside_(inside), s_(inside.system), o_(o), plane_(o.plane) {}

  certify::JetsCertificate operator()() {
    c_.title = title_of(s_);
    c_.system.dimension = 4 + 2 * inside_.others.size();
    std::tie(c_.field.ring, c_.system.ring) = rings(whole_, inside_, plane_);
    system();
    line();
    const Place& p = o_.place;
    c_.turns = p.ramification;
    c_.time_scale = element(p.time_scale);
    c_.solution = series(p.y);
    c_.normal = {series(p.u1), series(p.u2)};
    for (const Series& x : o_.logarithm.across)
      c_.across.push_back(series(x));
    for (const Series& x : o_.logarithm.along)
      c_.along.push_back(series(x));
    c_.order = o_.logarithm.order;
    c_.form = element(o_.local_form);
    obstruction();
    group();
    for (const MPoly& d : factors_.all())
      c_.field.denominators.push_back(moved(d));
    return std::move(c_);
  }

private:
  // One constant at most, a root.
  void system() {
    const MFraction h = *whole_.field.hamiltonian;
    if (!is_constant(h.den())) throw NoWords("H has a denominator");
    c_.system.hamiltonian = {transfer(MFraction(h.num()), c_.system.ring).num(),
                             h.den().coefficient(0)};
    if (!plane_.relation) return;
    const std::size_t constant = plane_.constants->main().front();
    const auto c = kov::coefficients(*plane_.relation, constant);
    if (c.size() < 3 ||
        !std::all_of(c.begin() + 1, c.end() - 1, [](const MPoly& x) { return is_zero(x); }))
      throw NoWords("the algebraic constant is not a root");
    const MFraction value = -(MFraction(c.front()) / MFraction(c.back()));
    c_.field.tower.push_back({static_cast<unsigned long>(c.size() - 1), element(value), {}});
  }

  void line() {
    const LineOfConfigurations& l = plane_.line;
    std::array<MFraction, 2> masses;
    MFraction across, along;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t p = s_.field.coordinates[i + 2];
      const MFraction inertia = derivative(derivative(*s_.field.hamiltonian, p), p);
      masses[i] = plane_.reduced(unit() / transfer(inertia, plane_.ring));
      across += masses[i] * l.across[i] * l.across[i];
      along += masses[i] * l.along[i] * l.along[i];
    }
    c_.line = {pair(l.start), pair(l.across), pair(l.along), pair(masses),
               pair({unit() / plane_.reduced(across), unit() / plane_.reduced(along)})};
  }

  // Some minor of the columns of 2.5, or some coefficient of R, that is not 0.
  void obstruction() {
    const long n = c_.order + 1;
    const auto by_c1 = coefficients(o_.local_form, plane_.c1);
    std::vector<MFraction> r(static_cast<std::size_t>(n) + 3); // r[i + 1] of c1^i
    for (std::size_t i = 0; i < by_c1.size(); ++i) {
      const auto by_c2 = coefficients(by_c1[i], plane_.c2);
      if (!by_c2.empty()) r[i + 1] = by_c2.back();
    }
    if (o_.because == InfiniteGroup::homogeneous) {
      for (long i = 0; i <= n; ++i)
        offer({i}, r[static_cast<std::size_t>(i) + 1]);
    } else {
      for (long i = 0; i <= n; ++i)
        for (long j = i + 1; j <= n; ++j)
          for (long k = j + 1; k <= n; ++k)
            offer({i, j, k}, minor(r, n, {i, j, k}, plane_));
    }
  }
  // The one with the shortest value is kept.
  void offer(const std::vector<long>& columns, const MFraction& found) {
    if (is_zero(found)) return;
    MFraction cofactor = unit(), value = found;
    if (plane_.constants && uses(found, plane_.constants->main().front())) {
      const MFraction inverse = plane_.reduced(unit() / found);
      cofactor = MFraction(inverse.num());
      value = MFraction(inverse.den());
    }
    long power = 1;
    MFraction radical(plane_.ring, Rational(1));
    for (const MFactor& f : factor(value.num()).second) {
      power = std::max(power, static_cast<long>(f.exponent));
      radical *= MFraction(f.base);
    }
    const MPoly& best = c_.obstruction.value.p;
    if (c_.obstruction.columns.empty() || radical.num().length() < best.length())
      c_.obstruction = {columns, element(cofactor * pow(radical, power) / value), element(radical),
                        power};
  }

  void group() {
    switch (o_.because) {
    case InfiniteGroup::first_family:
      c_.group = certify::ByFirstFamily{};
      break;
    case InfiniteGroup::homogeneous:
      c_.group = certify::ByHomogeneity{};
      break;
    case InfiniteGroup::equilibria: {
      const MFraction slope = derivative(plane_.potential, plane_.y);
      const auto [first, second] = one(slope);
      c_.group = certify::ByEquilibria{first, second};
      break;
    }
    case InfiniteGroup::decided: {
      if (o_.group->certificate.empty())
        throw NoWords("the group of the normal equation has no certificate: " +
                      o_.group->no_certificate);
      const MFraction slope = derivative(o_.place.energy, plane_.e);
      const MFraction start = substitute(o_.place.energy, {{plane_.e, MFraction(plane_.ring)}});
      const auto [first, second] = one(*o_.energy - plane_.potential);
      CurveRow minus;
      for (const auto& x : second)
        minus.push_back({-x.p, x.n, x.over});
      c_.group = certify::ByGroup{to_rational((*o_.energy - start) / slope), first, minus,
                                  certify::read_certificate(o_.group->certificate)};
    }
    }
  }
  using CurveRow = certify::CurveRow;

  // first f + second f' = 1, for a polynomial f in y with simple roots.
  std::pair<CurveRow, CurveRow> one(const MFraction& f) {
    if (plane_.constants) throw NoWords("an algebraic constant, and roots that are to be simple");
    const MFraction slope = derivative(f, plane_.y);
    const MFraction second = inverse_modulo(slope, f, plane_.y);
    return {row((unit() - second * slope) / f), row(second)};
  }

  // ---- elements

  [[nodiscard]] MFraction unit() const { return {plane_.ring, Rational(1)}; }

  [[nodiscard]] MPoly moved(const MPoly& f) const {
    return is_zero(f) ? MPoly(c_.field.ring) : transfer(MFraction(f), c_.field.ring).num();
  }
  certify::CurveFunction element(const MFraction& given) {
    const MFraction f = plane_.reduced(given);
    if (is_zero(f)) return {MPoly(c_.field.ring), Integer(1), {}};
    Factors::Product den = factors_.of(f.den());
    MPoly p = moved(f.num());
    if (den.content < Integer(0)) {
      p = -p;
      den.content = -den.content;
    }
    return {p, den.content, den.exponents};
  }
  std::array<certify::CurveFunction, 2> pair(const std::array<MFraction, 2>& two) {
    return {element(two[0]), element(two[1])};
  }
  CurveRow row(const MFraction& in_y) {
    CurveRow all;
    for (const MFraction& f : coefficients(in_y, plane_.y))
      all.push_back(element(f));
    return all;
  }
  certify::LocalSeries series(const Series& x) {
    if (x.is_exact_zero()) return {};
    certify::LocalSeries all{x.low(), {}, x.end()};
    for (long m = x.low(); m < x.end(); ++m)
      all.c.push_back(element(x[m]));
    return all;
  }

  const System& whole_;
  const Subspace& inside_;
  const System& s_; ///< inside
  const HigherObstruction& o_;
  const InvariantPlane& plane_;
  certify::JetsCertificate c_;
  Factors factors_;
};

} // namespace

Certified certificate(const System& whole, const Subspace& inside, const HigherObstruction& o) {
  Certified result;
  try {
    const std::string text = certify::write_jets_certificate(JetsWriter(whole, inside, o)());
    const auto verdict = certify::check_jets(certify::read_jets_certificate(text));
    const auto* no = std::get_if<certify::Rejected>(&verdict);
    if (!no) return {text, "", false};
    result.none = "our own checker did not accept it: " + no->step + ": " + no->why;
    result.refused = !no->limit;
  } catch (const Error& why) { // of the names, or of a size
    result.none = why.what();
  }
  return result;
}

} // namespace kov::jets
