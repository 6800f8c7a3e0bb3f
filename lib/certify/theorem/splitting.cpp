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

/// A power series in theta, up to theta^degree.
using Series = std::vector<PhaseFunction>;
/// Powers of zeta with series.
using Modes = std::map<long, Series>;

/// theta times the coordinates on an orbit near one of the two points.
class Orbits {
public:
  Orbits(const Functions& in, const std::array<MPoly, 3>& moments, std::size_t degree)
      : in_(in), degree_(degree) {
    const auto& [a, b, c] = moments;
    const std::size_t first = in_.ring()->size() - extra_names.size();
    for (std::size_t i = 0; i < extra_names.size(); ++i)
      extra_[i] = first + i;
    b_ = times(a, c);
    squares_ = {{extra_[0], times(c, a - b)},
                {extra_[1], times(a, b - c)},
                {extra_[2], times(b, a - c)},
                {extra_[6], MPoly(in_.ring(), Integer(-1))},
                {extra_[3], MPoly(in_.ring(), Integer(1)) - times(name(4), name(4))}};
    expand(times(times(a, c), times(a - b, b - c)));
  }

  /// The sums of Z4, real and imaginary part of each.
  std::vector<MPoly> sums(const MPoly& perturbation) {
    std::map<std::pair<int, int>, std::map<long, PhaseFunction>> rho;
    for (const int sigma : {1, -1})
      for (const int sign : {1, -1})
        rho[{sigma, sign}] = residues(perturbation, coordinates(sigma, sign));
    std::vector<MPoly> all;
    for (std::size_t k = 1; k <= degree_; ++k)
      for (const int sigma : {1, -1})
        put_sum(all, rho[{sigma, 1}], rho[{sigma, -1}], static_cast<long>(k));
    return all;
  }
  /// alpha^2 - _alpha^2, ...; s^2 comes last
  [[nodiscard]] MPoly relation(std::size_t i) const {
    return squares_.at(extra_[i]) - times(name(i), name(i));
  }
  [[nodiscard]] MPoly name(std::size_t i) const { return MPoly::variable(in_.ring(), extra_[i]); }

private:
  [[nodiscard]] MPoly times(const MPoly& a, const MPoly& b) const {
    return in_.arithmetic().times(a, b);
  }
  [[nodiscard]] PhaseFunction of(const MPoly& f) const { return {f, Integer(1)}; }
  [[nodiscard]] MPoly number(long c) const { return {in_.ring(), Integer(c)}; }

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
    const Poly inverse = inverse_series(sinh, terms);
    f_ = in_theta(inverse, q);
    g_ = in_theta(truncate(cosh * inverse, terms), q);
  }
  [[nodiscard]] Series in_theta(const Poly& f, const MPoly& q) const {
    Series s(degree_ + 1, in_.zero());
    for (long k = 0; k <= degree(f); ++k) {
      const Rational c = f.coeff(k).coeff(0);
      s[static_cast<std::size_t>(2 * k)] = {
          scaled(in_.arithmetic().power(q, static_cast<unsigned long>(k)), c.num()), c.den()};
    }
    return s;
  }

  [[nodiscard]] Series combination(const std::vector<std::pair<MPoly, const Series*>>& all) const {
    Series sum(degree_ + 1, in_.zero());
    for (const auto& [c, s] : all)
      for (std::size_t k = 0; k <= degree_; ++k)
        sum[k] = in_.plus(sum[k], in_.times(of(c), (*s)[k]));
    return sum;
  }

  [[nodiscard]] std::vector<Modes> coordinates(int sigma, int sign) const {
    const MPoly alpha = name(0), beta = name(1), delta = name(2), s = name(3), F = name(4),
                i = name(6);
    Series theta(degree_ + 1, in_.zero());
    if (degree_ > 0) theta[1] = in_.one();
    const Series v = combination({{scaled(i, Integer(-sign)), &f_}});
    const std::array<Series, 3> momentum{combination({{scaled(beta, Integer(2)), &v}}),
                                         combination({{scaled(delta, Integer(-2 * sigma)), &g_}}),
                                         combination({{scaled(alpha, Integer(2 * sigma)), &v}})};
    const auto rotating = [&](const MPoly& unit) {
      const MPoly along = scaled(times(unit, times(times(alpha, alpha), beta)), Integer(sigma));
      const MPoly across = scaled(times(times(unit, unit), beta), Integer(sigma));
      return std::array<Series, 3>{
          combination({{along, &theta}, {across, &g_}}), combination({{-delta, &v}}),
          combination({{-alpha, &g_}, {-times(unit, times(alpha, times(beta, beta))), &theta}})};
    };
    const auto up = rotating(i), down = rotating(-i);
    auto all = mapped<Modes>(momentum, [&](const Series& m) { return Modes{{0, m}}; });
    for (std::size_t j = 0; j < 3; ++j)
      all.push_back({{0, combination({{F, &momentum[j]}})},
                     {1, combination({{s, &up[j]}})},
                     {-1, combination({{s, &down[j]}})}});
    return all;
  }

  // Squares of the extra names are put in.
  [[nodiscard]] PhaseFunction reduced(PhaseFunction f) const {
    for (const std::size_t x : {extra_[0], extra_[1], extra_[2], extra_[6], extra_[3]}) {
      if (degree(f.p, x) < 2) continue;
      const auto [even, odd] = halves(f.p, x, of(squares_.at(x)), in_.arithmetic());
      f.p = in_.arithmetic().plus(even, times(odd, MPoly::variable(in_.ring(), x)));
    }
    return f;
  }

  [[nodiscard]] Modes product(const Modes& a, const Modes& b) const {
    Modes c;
    for (const auto& [k, u] : a)
      for (const auto& [m, v] : b) {
        Series& row = c.try_emplace(k + m, degree_ + 1, in_.zero()).first->second;
        for (std::size_t r = 0; r <= degree_; ++r)
          for (std::size_t j = 0; j <= r; ++j)
            row[r] = in_.plus(row[r], in_.times(u[j], v[r - j]));
      }
    for (auto& [k, row] : c)
      for (PhaseFunction& x : row)
        x = reduced(std::move(x));
    return c;
  }

  using Exponents = std::array<unsigned long, 6>;
  const Modes& monomial(const Exponents& e, const std::vector<Modes>& x,
                        std::map<Exponents, Modes>& known) const {
    if (const auto found = known.find(e); found != known.end()) return found->second;
    const auto j =
        static_cast<std::size_t>(std::ranges::find_if(e, [](auto n) { return n > 0; }) - e.begin());
    if (j == e.size()) {
      Series one(degree_ + 1, in_.zero());
      one[0] = in_.one();
      return known.emplace(e, Modes{{0, one}}).first->second;
    }
    Exponents less = e;
    --less[j];
    Modes m = product(x[j], monomial(less, x, known));
    return known.emplace(e, std::move(m)).first->second;
  }

  // The coefficient of zeta^k/theta in the perturbation times exp(i k b theta), k > 0.
  [[nodiscard]] std::map<long, PhaseFunction> residues(const MPoly& perturbation,
                                                       const std::vector<Modes>& x) const {
    std::map<Exponents, Modes> known;
    std::map<long, PhaseFunction> found;
    const MPoly unit = scaled(times(times(name(0), name(1)), name(2)), Integer(2));
    for (long t = 0; t < perturbation.length(); ++t) {
      auto rest = perturbation.exponents(t);
      Exponents e{};
      std::size_t d = 0;
      for (std::size_t j = 0; j < 6; ++j)
        d += e[j] = std::exchange(rest[j], 0);
      if (d == 0) continue;
      const MPoly c = times(MPoly::term(in_.ring(), perturbation.coefficient(t), rest),
                            in_.arithmetic().power(unit, degree_ - d));
      for (const auto& [k, row] : monomial(e, x, known))
        if (k > 0) put_residue(found, k, row, d, c);
    }
    return found;
  }
  void put_residue(std::map<long, PhaseFunction>& found, long k, const Series& row, std::size_t d,
                   const MPoly& c) const {
    PhaseFunction& sum = found.try_emplace(k, in_.zero()).first->second;
    PhaseFunction exponential = in_.one(); // (i k b theta)^j/j!
    const PhaseFunction step = of(scaled(times(name(6), b_), Integer(k)));
    for (std::size_t j = 0; j < d; ++j) {
      sum = in_.plus(sum, in_.times(in_.times(exponential, row[d - 1 - j]), of(c)));
      exponential = reduced(in_.times(exponential, step));
      exponential.n = exponential.n * Integer(static_cast<long>(j + 1));
    }
    sum = reduced(std::move(sum));
  }
  void put_sum(std::vector<MPoly>& all, const std::map<long, PhaseFunction>& upper,
               const std::map<long, PhaseFunction>& lower, long k) const {
    const auto at = [&](const std::map<long, PhaseFunction>& rho) {
      const auto found = rho.find(k);
      return found == rho.end() ? in_.zero() : found->second;
    };
    const MPoly y = in_.arithmetic().power(name(5), static_cast<unsigned long>(k));
    const PhaseFunction sum = reduced(in_.plus(at(upper), in_.times(at(lower), of(y))));
    Coefficients c = coefficients(sum.p, extra_[6]);
    c.resize(2, MPoly(in_.ring()));
    for (const MPoly& part : c)
      all.push_back(primitive(part));
  }

  Functions in_;
  std::size_t degree_;
  std::array<std::size_t, 7> extra_{};
  MPoly b_;
  std::map<std::size_t, MPoly> squares_;
  Series f_, g_;
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
  const auto v = [&](std::size_t i) { return MPoly::variable(ring, i); };
  Orbits orbits(Functions(ring, a), {v(d.moments[0]), v(d.moments[1]), v(d.moments[2])},
                static_cast<std::size_t>(degree));
  Conditions all;
  for (const Conditions* known : {&y.assumptions, &d.region})
    for (const Condition& c : *known)
      all.push_back({in_ring(c.p, ring), c.sign});
  for (std::size_t i = 0; i < 6; ++i)
    all.push_back({orbits.name(i), Sign::positive});
  all.push_back({MPoly(ring, Integer(1)) - orbits.name(5), Sign::positive});
  for (std::size_t i = 0; i < 4; ++i)
    all.push_back({orbits.relation(i), Sign::zero});
  for (MPoly& f : orbits.sums(in_ring(d.first, ring)))
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
