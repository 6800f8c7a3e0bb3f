#include "certify/theorem/computed.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/phase_space.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr long most_degree = 12;
constexpr unsigned long most_power = 12;
constexpr std::array<const char*, 7> extra_names{"_alpha", "_beta", "_delta", "_s",
                                                 "_F",     "_Y",    "_i"};

/// theta times the coordinates on an orbit near one of the two points, as polynomials in theta and zeta, of which
/// what is below theta^degree counts; all times the same number.
class Orbits {
public:
  Orbits(const Ring& ring, const std::array<std::size_t, 3>& moments, unsigned long degree,
         Arithmetic& a)
      : ring_(ring), a_(a), degree_(degree), inner_(inner_ring(ring)),
        first_(ring->size() - extra_names.size()), theta_(ring->size()), zeta_(theta_ + 1) {
    const MPoly A = variable(moments[0]), B = variable(moments[1]), C = variable(moments[2]);
    b_ = times(A, C);
    squares_ = {{0, times(C, A - B)},
                {1, times(A, B - C)},
                {2, times(B, A - C)},
                {6, number(-1)},
                {3, number(1) - times(name(4), name(4))}};
    expand(times(b_, times(A - B, B - C)));
    unit_ = scaled(times(times(name(0), name(1)), name(2)), Integer(2) * below_);
  }

  /// The sums of Z4, real and imaginary part of each.
  std::vector<MPoly> sums(const MPoly& perturbation) const {
    std::map<std::pair<int, int>, std::map<unsigned long, MPoly>> rho;
    for (const int sigma : {1, -1})
      for (const int sign : {1, -1})
        rho[{sigma, sign}] = residues(in_ring(perturbation, inner_), coordinates(sigma, sign));
    std::vector<MPoly> all;
    for (unsigned long k = 1; k <= degree_; ++k)
      for (const int sigma : {1, -1}) {
        const MPoly lower = times(number(1), rho[{sigma, -1}][k]);
        const MPoly upper = times(number(1), rho[{sigma, 1}][k]);
        Coefficients parts =
            coefficients(reduced(a_.plus(upper, times(lower, a_.power(name(5), k)))), first_ + 6);
        parts.resize(2, number(0));
        for (const MPoly& part : parts)
          all.push_back(in_ring(primitive(part), ring_));
      }
    return all;
  }
  [[nodiscard]] MPoly extra(std::size_t i) const { return in_ring(name(i), ring_); }
  /// alpha^2 - _alpha^2, ...; s^2 comes last
  [[nodiscard]] MPoly relation(std::size_t i) const {
    return in_ring(squares_.at(i) - times(name(i), name(i)), ring_);
  }

private:
  static Ring inner_ring(const Ring& ring) {
    auto names = ring->names();
    names.insert(names.end(), {"theta'", "zeta'"}); // no names of a file
    return make_ring(names);
  }
  [[nodiscard]] MPoly variable(std::size_t i) const { return MPoly::variable(inner_, i); }
  [[nodiscard]] MPoly name(std::size_t i) const { return variable(first_ + i); }
  [[nodiscard]] MPoly number(long c) const { return {inner_, Integer(c)}; }
  [[nodiscard]] MPoly times(const MPoly& f, const MPoly& g) const { return a_.times(f, g); }

  // x/sinh x and x/tanh x, x^2 = q theta^2, by division by sinh x/x.
  void expand(const MPoly& q) {
    const long terms = static_cast<long>(degree_ / 2) + 1;
    Poly sinh, cosh;
    Rational term(1); // 1/k!
    for (long k = 0; k < terms; ++k) {
      cosh.set_coeff(k, NfElem(term));
      term = term / Rational(2 * k + 1);
      sinh.set_coeff(k, NfElem(term));
      term = term / Rational(2 * k + 2);
    }
    const Poly f = inverse_series(sinh, terms), g = truncate(cosh * f, terms);
    below_ = lcm(Integer(f.raw()->den), Integer(g.raw()->den));
    const MPoly square = times(q, times(variable(theta_), variable(theta_)));
    const auto put_in = [&](const Poly& series) {
      MPoly sum = number(0);
      for (long k = degree(series); k >= 0; --k)
        sum = a_.plus(times(sum, square),
                      MPoly(inner_, (series.coeff(k).coeff(0) * Rational(below_)).num()));
      return sum;
    };
    f_ = put_in(f);
    g_ = put_in(g);
  }

  // The second triple is also times zeta.
  [[nodiscard]] std::array<MPoly, 6> coordinates(int sigma, int sign) const {
    const MPoly alpha = name(0), beta = name(1), delta = name(2), s = name(3), F = name(4),
                i = name(6), zeta = variable(zeta_), odd = number(sigma);
    const MPoly theta = scaled(variable(theta_), below_), v = times(number(-sign) * i, f_);
    const std::array momentum{times(beta + beta, v), times(number(-2) * odd * delta, g_),
                              times((alpha + alpha) * odd, v)};
    const auto rotating = [&](const MPoly& unit) {
      return std::array{
          times(odd * unit * alpha * alpha * beta, theta) + times(odd * unit * unit * beta, g_),
          times(-delta, v), -times(alpha, g_) - times(unit * alpha * beta * beta, theta)};
    };
    const auto up = rotating(i), down = rotating(-i);
    std::array<MPoly, 6> all;
    for (std::size_t j = 0; j < 3; ++j) {
      all[j] = momentum[j];
      all[3 + j] = times(F * zeta, momentum[j]) + times(s * zeta * zeta, up[j]) + times(s, down[j]);
    }
    return all;
  }

  // The squares of the extra names are put in.
  [[nodiscard]] MPoly reduced(MPoly f) const {
    for (const std::size_t i : {0, 1, 2, 6, 3}) {
      if (degree(f, first_ + i) < 2) continue;
      const auto [even, odd] = halves(f, first_ + i, {squares_.at(i), {1}}, a_);
      f = a_.plus(even, times(odd, name(i)));
    }
    return f;
  }

  using SixExponents = std::array<unsigned long, 6>;
  const MPoly& monomial(const SixExponents& e, const std::array<MPoly, 6>& x,
                        std::map<SixExponents, MPoly>& known) const {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    const auto j =
        static_cast<std::size_t>(std::ranges::find_if(e, [](auto n) { return n > 0; }) - e.begin());
    MPoly low = number(j == e.size() ? 1 : 0);
    if (j < e.size()) {
      SixExponents less = e;
      --less[j];
      const Coefficients all = coefficients(times(x[j], monomial(less, x, known)), theta_);
      for (std::size_t k = std::min<std::size_t>(all.size(), degree_); k-- > 0;)
        low = a_.plus(times(low, variable(theta_)), all[k]);
    }
    return known.emplace(e, reduced(low)).first->second;
  }

  // The coefficient of zeta^k/theta in the perturbation times exp(i k b theta), k > 0.
  [[nodiscard]] std::map<unsigned long, MPoly> residues(const MPoly& perturbation,
                                                        const std::array<MPoly, 6>& x) const {
    std::map<SixExponents, MPoly> known;
    std::map<unsigned long, MPoly> found;
    for (long t = 0; t < perturbation.length(); ++t) {
      auto rest = perturbation.exponents(t);
      SixExponents e{};
      unsigned long d = 0;
      for (std::size_t j = 0; j < 6; ++j)
        d += e[j] = std::exchange(rest[j], 0);
      if (d == 0) continue;
      const MPoly c = times(MPoly::term(inner_, perturbation.coefficient(t), rest),
                            a_.power(unit_, degree_ - d));
      const unsigned long turns = e[3] + e[4] + e[5];
      const Coefficients by_zeta = coefficients(monomial(e, x, known), zeta_);
      for (unsigned long k = 1; turns + k < by_zeta.size(); ++k) {
        MPoly& sum = found.try_emplace(k, inner_).first->second;
        sum = a_.plus(sum, reduced(times(c, with_exponential(by_zeta[turns + k], k, d))));
      }
    }
    return found;
  }
  // The coefficient of theta^(d - 1) in f exp(i k b theta), times degree!
  [[nodiscard]] MPoly with_exponential(const MPoly& f, unsigned long k, unsigned long d) const {
    const Coefficients by_theta = coefficients(f, theta_);
    const MPoly step = scaled(times(name(6), b_), Integer(static_cast<long>(k)));
    MPoly sum = number(0), power = number(1);
    Integer weight; // degree!/j!
    fmpz_fac_ui(weight.raw(), degree_);
    for (unsigned long j = 0; j < d; ++j) {
      if (d - 1 - j < by_theta.size())
        sum = a_.plus(sum, scaled(times(power, by_theta[d - 1 - j]), weight));
      power = reduced(times(power, step));
      weight = exact_div(weight, Integer(static_cast<long>(j + 1)));
    }
    return sum;
  }

  Ring ring_;
  Arithmetic& a_;
  unsigned long degree_;
  Ring inner_; ///< with theta and zeta
  std::size_t first_, theta_, zeta_;
  MPoly b_, unit_, f_, g_;
  std::map<std::size_t, MPoly> squares_; ///< of extra names
  Integer below_;
};

const std::vector<std::size_t> all_coordinates{0, 1, 2, 3, 4, 5}, second_triple{3, 4, 5};

WeightRange degrees_in(const MPoly& f, const std::vector<std::size_t>& x) {
  return weights_of(f, ones(f.ring()->size(), x));
}

// {M_i, M_j} = -eps_ijk M_k, {M_i, G_j} = -eps_ijk G_k, and nothing else.
bool has_euler_bracket(const PhaseSystem& s, Arithmetic& a) {
  if (s.dimension != 6) return false;
  const PhaseSpace space(s, a);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const PhaseFunction f = space.bracket(i, j);
      const bool zero = i % 3 == j % 3 || (i > 2 && j > 2), up = (i + 1) % 3 == j % 3;
      const std::size_t k = zero ? 0 : 3 - i % 3 - j % 3 + (i / 3 == j / 3 ? 0 : 3);
      const MPoly third = MPoly::variable(s.ring, k);
      if (zero ? !is_zero(f.p) : f.n != Integer(1) || !(f.p == (up ? -third : third))) return false;
    }
  return true;
}

// (Z1)
void need_scaling(const Family& y, const std::vector<std::size_t>& small) {
  Weights balance = ones(y.system.ring->size(), second_triple);
  for (const std::size_t i : small)
    balance[i] = -1;
  need(weights_of(y.system.hamiltonian->p, balance).is(0), "the system does not scale");
  for (const MPoly& h : y.system.inverses)
    need(weights_of(h, balance).is(0), "the system does not scale");
}

// (Z2), the denominators: c A^i B^j C^k where the small parameters are 0.
void need_units(const Family& y, const SplittingData& d, const std::vector<std::size_t>& small) {
  Weights others(y.system.ring->size(), 1);
  for (const std::size_t i : d.moments)
    others[i] = 0;
  std::vector<bool> is_small(others.size(), false);
  for (const std::size_t i : small)
    is_small[i] = true;
  for (const MPoly& h : y.system.inverses) {
    auto parts = parts_by(h, is_small);
    const MPoly& free = parts[Exponents(others.size(), 0)];
    need(free.length() == 1 && weights_of(free, others).is(0), "a denominator may vanish");
  }
}

// (Z2)
void need_order(const Family& y, const SplittingData& d, const std::vector<std::size_t>& small,
                Arithmetic& a) {
  const long order = static_cast<long>(d.order);
  need(degrees_in(d.first, small).is(order) &&
           degrees_in(d.first, all_coordinates).highest <= most_degree,
       "not of this order");
  const PhaseSystem& s = y.system;
  const auto v = [&](std::size_t i) { return MPoly::variable(s.ring, i); };
  const MPoly A = v(d.moments[0]), B = v(d.moments[1]), C = v(d.moments[2]);
  const MPoly whole = a.power(A * B * C, d.power - 1);
  const MPoly euler =
      a.times(whole, B * C * v(0) * v(0) + A * C * v(1) * v(1) + A * B * v(2) * v(2));
  const PhaseSpace space(s, a);
  const PhaseFunction twice =
      space.in().times({scaled(a.times(whole, A * B * C), Integer(2)), Integer(1)}, *s.hamiltonian);
  const MPoly rest = space.in().minus(twice, {a.plus(euler, d.first), Integer(1)}).p;
  need(degrees_in(space.cleared(rest), small).lowest > order, "another perturbation");
}

std::array<std::size_t, 3> three(const Family& y, const Node& n) {
  const auto items = n.items(3, "three parameters are expected");
  std::array<std::size_t, 3> all{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = y.system.ring->find(items[i].text());
    if (!at || !y.is_parameter(*at)) items[i].fail("a parameter is expected");
    all[i] = *at;
  }
  return all;
}

unsigned long natural(const Node& n, unsigned long most) {
  const long x = n.count();
  need(x >= 1 && static_cast<unsigned long>(x) <= most, "an order or a power is out of range");
  return static_cast<unsigned long>(x);
}

SplittingData read_splitting(const Family& y, Keys& k) {
  std::vector<bool> names = y.parameters();
  std::fill_n(names.begin(), y.system.dimension, true);
  SplittingData d{three(y, k.at("moments")),
                  three(y, k.at("small")),
                  natural(k.at("order"), 1000),
                  natural(k.at("power"), most_power),
                  read_poly(y.system.ring, k.at("first"), names),
                  y.region(k.at("region"))};
  std::set<std::size_t> six(d.moments.begin(), d.moments.end());
  six.insert(d.small.begin(), d.small.end());
  if (six.size() != 6) k.at("small").fail("a parameter occurs twice");
  return d;
}

} // namespace

Ring splitting_ring(const Family& y) {
  auto names = y.system.ring->names();
  for (const char* name : extra_names)
    need(!is_among(name, names), "a name is taken");
  names.insert(names.end(), extra_names.begin(), extra_names.end());
  need(names.size() <= 64, "too many names");
  return make_ring(names);
}

Conditions splitting_conditions(const Family& y, const SplittingData& d, const Ring& ring,
                                Arithmetic& a) {
  const long degree = std::max(0L, degrees_in(d.first, all_coordinates).highest);
  need(degree <= most_degree, "the degree of the perturbation");
  const Orbits orbits(ring, d.moments, static_cast<unsigned long>(degree), a);
  Conditions all;
  for (const Conditions* known : {&y.assumptions, &d.region})
    for (const Condition& c : *known)
      all.push_back({in_ring(c.p, ring), c.sign});
  for (std::size_t i = 0; i < 6; ++i)
    all.push_back({orbits.extra(i), Sign::positive});
  all.push_back({MPoly(ring, Integer(1)) - orbits.extra(5), Sign::positive});
  for (std::size_t i = 0; i < 4; ++i)
    all.push_back({orbits.relation(i), Sign::zero});
  for (MPoly& f : orbits.sums(d.first))
    all.push_back({std::move(f), Sign::zero});
  return all;
}

Said rule::splitting(Keys& step, Derivation& d) {
  const Family& y = d.plain_family(step);
  Arithmetic& a = d.arithmetic();
  need(has_euler_bracket(y.system, a), "not the bracket of e(3)");
  const SplittingData data = read_splitting(y, step);
  const std::vector<std::size_t> small(data.small.begin(), data.small.end());
  need_scaling(y, small);
  need_units(y, data, small);
  need_order(y, data, small, a);
  const auto v = [&](std::size_t i) { return MPoly::variable(y.system.ring, data.moments[i]); };
  for (const MPoly& f : {v(0) - v(1), v(1) - v(2), v(2)})
    need(is_among(Condition{f, Sign::positive}, data.region),
         "the moments are not known to be ordered");
  const Ring ring = splitting_ring(y);
  std::vector<bool> real(ring->size(), false);
  for (std::size_t i = y.system.first_parameter(); i + 1 < ring->size(); ++i)
    real[i] = true;
  ConditionSet all(ring, a, real, real);
  for (Condition& c : splitting_conditions(y, data, ring, a))
    all.assume(std::move(c));
  SetProof(all, d.nodes()).absent(step.at("proof"));
  Said f{FactKind::not_integrable, &y, {data.region}};
  f.classes = {real_analytic()};
  f.used = {"Ziglin 1980"};
  return f;
}

} // namespace kov::certify
