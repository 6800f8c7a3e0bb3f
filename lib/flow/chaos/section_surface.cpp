#include "flow/chaos/section_surface.hpp"

#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

template <class R> R exactly(const Rational& q);
template <> double exactly<double>(const Rational& q) { return number_as<double>(q); }
template <> Enclosure exactly<Enclosure>(const Rational& q) {
  Enclosure e;
  arb_set_fmpq(e.raw(), q.raw(), Enclosure::bits());
  return e;
}
template <> DoubleBall exactly<DoubleBall>(const Rational& q) {
  return double_ball(exactly<Enclosure>(q));
}
template <class R> R value_of(const Quantity& q) { return q.as<R>(); }
template <> DoubleBall value_of<DoubleBall>(const Quantity& q) {
  return double_ball(q.as<Enclosure>());
}

[[noreturn]] void refuse(const SystemScene& s, const std::string& why,
                         const std::string& hint = {}) {
  throw InputError(s.file, 0, 0, 1, why, hint);
}

void check(const SystemScene& s) {
  if (!s.family.empty()) refuse(s, "a diagram over a parameter is not one section map");
  if (s.rising && s.falling)
    refuse(s, "a section map needs one direction of crossing, not both",
           "direction = \"upward\" or \"downward\"");
  const std::size_t n = s.system.field.dimension();
  if (n < 3 || s.levels.size() + 3 != n)
    refuse(s, "the section map is not a map of a surface: " + std::to_string(n) +
                  " coordinates need levels of " + std::to_string(n < 3 ? 0 : n - 3) +
                  " first integrals, the scene has " + std::to_string(s.levels.size()));
  for (const auto& level : s.levels)
    if (!is_zero_modulo(lie_derivative(s.system.field, level.function.value),
                        relation_ideal(s.system.field)))
      refuse(s,
             "the level of " + level.function.text + " is not a level of a proved first integral");
}

// The longitude, in [0, 2 pi) but for rounding, and the height of a vector; turned, so that no cut is near.
template <class T> std::array<T, 2> on_sphere(const std::vector<T>& n) {
  using std::cos;
  using std::sin;
  double about = std::atan2(static_cast<double>(n[0].v), static_cast<double>(n[1].v));
  if (about < -1e-9) about += 2 * pi_of(0.0);
  const decltype(n[0].v) angle(about), c(cos(angle)), s(sin(angle));
  return {T(angle) + atan2(n[0] * T(c) - n[1] * T(s), n[1] * T(c) + n[0] * T(s)),
          n[2] / sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])};
}

// One level is that of H and the others are those of Casimirs.
bool keeps_an_area(const SystemScene& s) {
  const VectorField& v = s.system.field;
  if (!v.hamiltonian || !v.poisson || v.dimension() < 4) return false;
  std::size_t energies = 0;
  for (const auto& level : s.levels) {
    const MFraction& f = level.function.value;
    if (f == *v.hamiltonian) {
      ++energies;
      continue;
    }
    for (const std::size_t x : v.coordinates)
      if (!is_zero(poisson_bracket(v, f, MFraction::variable(v.ring, x)))) return false;
  }
  return energies == 1;
}

} // namespace

std::vector<SectionSurface::Equation> SectionSurface::equations_of(const SystemScene& s) {
  std::vector<Equation> all{{s.section.value, Quantity("0")}};
  for (const auto& level : s.levels)
    all.emplace_back(level.function.value, level.value);
  return all;
}

SectionSurface::SectionSurface(const SystemScene& s) : SectionSurface(s, equations_of(s), false) {
  check(s);
}

SectionSurface SectionSurface::section_alone(const SystemScene& s) {
  return {s, {{s.section.value, Quantity("0")}}, true};
}

SectionSurface::SectionSurface(const SystemScene& s, const std::vector<Equation>& equations,
                               bool bends)
    : dimension_(s.system.field.dimension()), rising_(s.rising), bends_(bends) {
  const VectorField& v = s.system.field;
  std::vector<MFraction> used = s.drawn();
  drawn_ = used.size();
  if (s.where) used.push_back(s.where->value);
  for (const auto& [function, value] : equations)
    used.push_back(function);
  Motion motion = motion_of(s.system, used, s.written.get());
  if (motion.variables.size() > motion.coordinates)
    refuse(s, "proofs about the section map are for systems without function symbols",
           "polynomial or rational coordinates");
  for (std::size_t j = 0; j < dimension_; ++j)
    names_.push_back(v.name(j));
  std::vector<std::size_t> inputs = motion.variables;
  for (const auto& [variable, value] : s.values) {
    inputs.push_back(variable);
    values_.push_back(value);
  }
  inputs_ = inputs.size();
  Registers in_field(inputs), in_point(inputs);
  field_ = compile(motion.graph, motion.derivatives, in_field);
  field_registers_ = in_field.count();

  std::vector<NodeId> outputs;
  const auto want = [&](const MFraction& f) { outputs.push_back(motion.graph.of(f)); };
  for (const auto& [function, value] : equations) {
    targets_.push_back(value);
    want(function);
  }
  for (const auto& [function, value] : equations)
    for (std::size_t j = 0; j < dimension_; ++j)
      want(partial(v, function, j));
  for (const NodeId d : motion.derivatives)
    outputs.push_back(d);
  for (const MFraction& f : s.drawn())
    want(f);
  want(s.where ? s.where->value : MFraction(v.ring, Rational(1)));
  if (bends_) want(lie_derivative(v, lie_derivative(v, s.section.value)));
  if (!bends_ && keeps_an_area(s))
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = i + 1; j < dimension_; ++j) {
        bracket_.push_back((*v.poisson)[i][j]);
        want(bracket_.back());
      }
  at_point_ = compile(motion.graph, outputs, in_point);
  point_registers_ = in_point.count();
}

template <class R>
SurfaceCode<R>::SurfaceCode(const SectionSurface& s, int order)
    : s_(s), stride_(static_cast<std::size_t>(order) + 1), field_once_(s.field_.once),
      field_each_(s.field_.each), field_terms_(s.field_.terms) {
  const auto stride = static_cast<std::uint32_t>(stride_);
  for (auto* code : {&field_once_, &field_each_})
    for (Instruction& i : *code)
      for (std::size_t k = 0; k < group; ++k) {
        i.out[k] *= stride;
        if (!i.is_register(k)) continue;
        i.a[k] *= stride;
        i.b[k] *= stride;
      }
  for (SumTerm& t : field_terms_)
    t.reg *= stride;
  for (const Rational& q : s.field_.numbers)
    field_numbers_.push_back(T(exactly<R>(q)));
  for (const Rational& q : s.at_point_.numbers)
    point_numbers_.push_back(T(exactly<R>(q)));
  for (const Quantity& q : s.targets_)
    targets_.push_back(T(value_of<R>(q)));
  series_.resize(s.field_registers_ * stride_);
  point_.resize(s.point_registers_);
  for (std::size_t i = 0; i < s.values_.size(); ++i) {
    const T value(value_of<R>(s.values_[i]));
    series_[(s.dimension_ + i) * stride_] = value;
    point_[s.dimension_ + i] = value;
  }
  run(field_once_, field_numbers_, field_terms_, series_, 0);
  run(s.at_point_.once, point_numbers_, s.at_point_.terms, point_, 0);
}

template <class R>
void SurfaceCode<R>::run(const std::vector<Instruction>& code, const std::vector<T>& numbers,
                         const std::vector<SumTerm>& terms, std::vector<T>& registers,
                         int k) const {
  for (const Instruction& i : code)
    machine::execute(i, terms.data(), numbers.data(), registers.data(), k);
}

template <class R> SurfaceValues<R> SurfaceCode<R>::at(const PhasePoint<R>& x) {
  std::ranges::copy(x, point_.begin());
  run(s_.at_point_.each, point_numbers_, s_.at_point_.terms, point_, 0);
  const std::size_t n = s_.dimension_, m = s_.equations();
  auto next = s_.at_point_.outputs.begin();
  const auto take = [&] { return point_[*next++]; };
  SurfaceValues<R> v;
  for (std::size_t i = 0; i < m; ++i)
    v.equations.push_back(take() - targets_[i]);
  for (std::size_t i = 0; i < m; ++i) {
    v.slope.emplace_back();
    for (std::size_t j = 0; j < n; ++j)
      v.slope.back().push_back(take());
  }
  for (std::size_t j = 0; j < n; ++j)
    v.field.push_back(take());
  std::vector<T> drawn;
  while (drawn.size() < s_.drawn_)
    drawn.push_back(take());
  if constexpr (!std::is_same_v<R, DoubleBall>)
    v.drawn = drawn.size() == 2 ? std::array{drawn[0], drawn[1]} : on_sphere(drawn);
  v.side = take();
  if (s_.bends_) v.bend = take();
  while (next != s_.at_point_.outputs.end())
    v.bracket.push_back(take());
  return v;
}

template <class R> void SurfaceCode<R>::expand(const PhasePoint<R>& x, int order) {
  const std::size_t n = s_.dimension_;
  for (std::size_t j = 0; j < n; ++j)
    series_[j * stride_] = x[j];
  for (int k = 0; k < order; ++k) {
    run(field_each_, field_numbers_, field_terms_, series_, k);
    const R by = R(1) / R(k + 1);
    for (std::size_t j = 0; j < n; ++j) {
      const T& d = series_[s_.field_.outputs[j] * stride_ + static_cast<std::size_t>(k)];
      series_[j * stride_ + static_cast<std::size_t>(k) + 1] =
          T(d.v * by, d.d[0] * by, d.d[1] * by);
    }
  }
}

template <class R> PhasePoint<R> SurfaceCode<R>::polynomial(const R& t, int order) const {
  PhasePoint<R> x;
  for (std::size_t j = 0; j < s_.dimension_; ++j) {
    T sum = coefficient(j, order);
    for (int k = order - 1; k >= 0; --k) {
      const T& c = coefficient(j, k);
      sum = T(sum.v * t + c.v, sum.d[0] * t + c.d[0], sum.d[1] * t + c.d[1]);
    }
    x.push_back(sum);
  }
  return x;
}

template class SurfaceCode<double>;
template class SurfaceCode<Enclosure>;
template class SurfaceCode<DoubleBall>;

template <class R> std::vector<R> solved(std::vector<std::vector<R>> a, std::vector<R> b) {
  const std::size_t n = b.size();
  const auto size = [](const R& x) { return std::abs(static_cast<double>(x)); };
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < n; ++k)
      if (size(a[k][i]) > size(a[pivot][i])) pivot = k;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t k = i + 1; k < n; ++k) {
      const R factor = a[k][i] / a[i][i];
      for (std::size_t j = i + 1; j < n; ++j)
        a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j)
      b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}
template std::vector<double> solved(std::vector<std::vector<double>>, std::vector<double>);
template std::vector<Enclosure> solved(std::vector<std::vector<Enclosure>>, std::vector<Enclosure>);
template std::vector<DoubleBall> solved(std::vector<std::vector<DoubleBall>>,
                                        std::vector<DoubleBall>);

Chart chart_at(SurfaceCode<double>& code, const std::vector<double>& x) {
  const auto values = code.at(PhasePoint<double>(x.begin(), x.end()));
  std::vector<std::vector<double>> a;
  for (const auto& row : values.slope) {
    a.emplace_back();
    double most = 1e-300;
    for (const auto& d : row)
      most = std::max(most, std::abs(d.v));
    for (const auto& d : row)
      a.back().push_back(d.v / most);
  }
  const std::size_t m = a.size(), n = x.size();
  std::vector<bool> taken(n);
  for (std::size_t i = 0; i < m; ++i) {
    std::size_t row = i, column = n;
    double most = -1;
    for (std::size_t k = i; k < m; ++k)
      for (std::size_t j = 0; j < n; ++j)
        if (!taken[j] && std::abs(a[k][j]) > most) {
          most = std::abs(a[k][j]);
          row = k;
          column = j;
        }
    std::swap(a[i], a[row]);
    if (column == n) throw NotProved::section_value; // NaN
    taken[column] = true;
    for (std::size_t k = i + 1; k < m; ++k) {
      const double factor = a[k][column] / a[i][column];
      for (std::size_t j = 0; j < n; ++j)
        if (!taken[j]) a[k][j] -= factor * a[i][j];
    }
  }
  Chart chart;
  std::size_t free = 0;
  for (std::size_t j = 0; j < n; ++j)
    if (taken[j])
      chart.rest.push_back(j);
    else
      chart.free.at(free++) = j;
  return chart;
}

} // namespace kov::flow
