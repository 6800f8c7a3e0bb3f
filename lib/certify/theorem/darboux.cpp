#include "certify/theorem/computed.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/system/phase_space.hpp"
#include "certify/theorem/rules.hpp"

#include <algorithm>
#include <set>

namespace kov::certify {
namespace {

constexpr long max_potential_degree = 20, max_chart = 1000, max_power = 12;
constexpr std::size_t max_eigenvalues = 8;
constexpr long max_choices = 20000, max_table = 4000;

// ---- the Hamiltonian

// {x, u} = {y, v} = 1, and nothing else.
void need_canonical(const PhaseSystem& s, const DarbouxChart& c, Arithmetic& a) {
  need(s.hamiltonian.has_value() && s.dimension == 4 && s.functions.empty() && s.inverses.empty() &&
           s.relations.empty(),
       "a polynomial Hamiltonian of two degrees of freedom is expected");
  const std::set<std::size_t> all{c.coordinates[0], c.coordinates[1], c.momenta[0], c.momenta[1]};
  need(all == std::set<std::size_t>{0, 1, 2, 3}, "two coordinates and their momenta are expected");
  const PhaseSpace space(s, a);
  const auto is_pair = [&](std::size_t i, std::size_t j) {
    return (i == c.coordinates[0] && j == c.momenta[0]) ||
           (i == c.coordinates[1] && j == c.momenta[1]);
  };
  for (const std::size_t i : all)
    for (const std::size_t j : all) {
      const PhaseFunction f = space.bracket(i, j);
      const MPoly value(s.ring, Integer(is_pair(i, j) ? 1 : is_pair(j, i) ? -1 : 0));
      need(f.p == value && (is_zero(value) || f.n == Integer(1)), "not a canonical bracket");
    }
}

/// H = (m11 u^2 + 2 m12 u v + m22 v^2)/2 + lower + V, up to a number.
struct NaturalParts {
  std::array<MPoly, 3> mass;
  MPoly potential; ///< the terms of degree k
};

NaturalParts natural_parts(const MPoly& h, const DarbouxChart& c) {
  const Ring& ring = h.ring();
  NaturalParts n{{MPoly(ring), MPoly(ring), MPoly(ring)}, MPoly(ring)};
  const auto of_another_weight = [&](long weight) {
    return c.part == PotentialPart::highest ? weight < c.degree
                                            : c.part == PotentialPart::lowest && weight > c.degree;
  };
  for (long t = 0; t < h.length(); ++t) {
    const Integer value = h.coefficient(t);
    auto e = h.exponents(t);
    const long in_q = static_cast<long>(e[c.coordinates[0]] + e[c.coordinates[1]]);
    const unsigned long u = std::exchange(e[c.momenta[0]], 0),
                        v = std::exchange(e[c.momenta[1]], 0);
    need(u + v <= 2, "more than a quadratic form in the momenta");
    if (u + v == 2) {
      need(in_q == 0, "masses that are not constant");
      n.mass[v] += MPoly::term(ring, u == v ? value : value * Integer(2), e);
    } else if (u + v == 1) {
      need(of_another_weight(2 * in_q), "a term that is linear in the momenta");
    } else if (in_q == c.degree) {
      n.potential += MPoly::term(ring, value, e);
    } else if (in_q != 0) { // else no equation of motion contains it
      need(of_another_weight(in_q), "a term of another degree");
    }
  }
  return n;
}

// adj(B) M adj(B)^T for q = B (w, 1), B = (a -b; b a)
std::array<MPoly, 3> mass_in_chart(const std::array<MPoly, 3>& m, const DarbouxChart& c,
                                   Arithmetic& a) {
  const auto sum = [&](long x, long y, long z) {
    return a.plus(a.plus(a.scaled(m[0], Integer(x)), a.scaled(m[1], Integer(y))),
                  a.scaled(m[2], Integer(z)));
  };
  const long p = c.a, q = c.b;
  return {sum(p * p, 2 * p * q, q * q), sum(-p * q, p * p - q * q, p * q),
          sum(q * q, -2 * p * q, p * p)};
}

MPoly in_chart(const MPoly& v, const DarbouxChart& c, const Functions& in) {
  auto images = in.variables();
  const MPoly w = MPoly::variable(in.ring(), c.coordinates[0]);
  const auto line = [&](long slope, long at_zero) {
    return PhaseFunction{scaled(w, Integer(slope)) + MPoly(in.ring(), Integer(at_zero)),
                         Integer(1)};
  };
  images[c.coordinates[0]] = line(c.a, -c.b);
  images[c.coordinates[1]] = line(c.b, c.a);
  return in.evaluate(v, images).p;
}

} // namespace

DarbouxForms darboux_forms(const StepPlace& x, const DarbouxChart& c, Arithmetic& a) {
  const PhaseSystem& s = x.family->system;
  need_canonical(s, c, a);
  need(c.degree >= 3 && c.degree <= max_potential_degree, "the degree of the potential");
  need(std::abs(c.a) <= max_chart && std::abs(c.b) <= max_chart, "a chart");
  const Here here(x, {}, a);
  const NaturalParts n = natural_parts(here.put(*s.hamiltonian).p, c);
  const auto [m11, m12, m22] = mass_in_chart(n.mass, c, a);
  const std::size_t w = c.coordinates[0];
  const MPoly along = MPoly::variable(s.ring, w);
  DarbouxForms f{in_chart(n.potential, c, here.in()), MPoly(s.ring), MPoly(s.ring), MPoly(s.ring)};
  const MPoly linear = a.minus(a.times(m22, along), m12);
  f.circle = a.plus(a.times(a.minus(linear, m12), along), m11);
  f.determinant = a.minus(a.times(m11, m22), a.times(m12, m12));
  f.directions = a.minus(a.times(f.circle, derivative(f.potential, w)),
                         a.scaled(a.times(linear, f.potential), Integer(c.degree)));
  return f;
}

MPoly resultant_in(const MPoly& f, const MPoly& g, std::size_t w, Arithmetic& a) {
  if (is_zero(f) || is_zero(g)) return MPoly(f.ring());
  const Coefficients x = coefficients(f, w), y = coefficients(g, w);
  if (x.size() == 1) return a.power(f, y.size() - 1);
  if (y.size() == 1) return a.power(g, x.size() - 1);
  return Elimination(a).resultant(x, y);
}

Coefficients eigenvalues_at(const DarbouxForms& f, const DarbouxChart& c, const MPoly& proper,
                            Arithmetic& a) {
  const std::size_t w = c.coordinates[0], l = c.coordinates[1];
  const MPoly here = a.times(f.circle, derivative(f.directions, w));
  const MPoly slope = a.scaled(a.times(f.determinant, f.potential), Integer(c.degree));
  const MPoly line = a.minus(here, a.times(MPoly::variable(here.ring(), l), slope));
  return coefficients(resultant_in(proper, line, w, a), l);
}

// ---- the table: Lambda = (k/2) (nu^2 - (1/2 + 1/k)^2), nu in one of some classes modulo 1

namespace {

class EigenvalueSets {
public:
  explicit EigenvalueSets(long k) : k_(k), top_(Rational(1, 2) + Rational(1, k)) {
    std::vector<Rational> classes{Rational(1, 2), top_};
    if (k == 3) classes.insert(classes.end(), {{1, 3}, {1, 4}, {1, 5}, {2, 5}});
    if (k == 4) classes.emplace_back(1, 3);
    if (k == 5) classes.insert(classes.end(), {{1, 3}, {2, 5}});
    for (const Rational& c : classes)
      classes_.insert({c, Rational(1) - c});
    negative_ = values(Rational(0));
  }

  std::vector<std::vector<Rational>> operator()(long n, const Rational& sum) {
    take_negative(0, n, sum);
    return {found_.begin(), found_.end()};
  }

private:
  // All Lambda != 0 up to this.
  std::vector<Rational> values(const Rational& most) {
    std::set<Rational> all;
    for (Rational nu : classes_)
      for (;; nu = nu + Rational(1)) {
        const Rational value = Rational(k_, 2) * (nu * nu - top_ * top_);
        if (value > most) break;
        need_within(++looked_ < max_table * 50, "too many eigenvalues");
        if (!is_zero(value)) all.insert(value);
      }
    return {all.begin(), all.end()};
  }

  // The numbers that are chosen are ascending.
  void take_negative(std::size_t first, long left, const Rational& rest) {
    take_positive(left, rest, Rational(0));
    if (left == 0) return;
    for (std::size_t i = first; i < negative_.size(); ++i) {
      chosen_.push_back(negative_[i]);
      take_negative(i, left - 1, rest - Rational(1) / negative_[i]);
      chosen_.pop_back();
    }
  }
  // `left` numbers >= least > 0 with this sum of inverses: the smallest is at most left/rest.
  void take_positive(long left, const Rational& rest, const Rational& least) {
    need_within(++steps_ <= max_choices * 10, "too many eigenvalues");
    if (left == 0 && is_zero(rest)) found_.insert(chosen_);
    if (left == 0 || !(rest > Rational(0))) return;
    std::vector<Rational> next;
    if (left > 1)
      next = values(Rational(left) / rest);
    else if (const Rational last = Rational(1) / rest; is_value(last))
      next = {last};
    for (const Rational& value : next) {
      if (value < least) continue;
      chosen_.push_back(value);
      take_positive(left - 1, rest - Rational(1) / value, value);
      chosen_.pop_back();
    }
  }
  // Is 2 value/k + top^2 the square of a rational number in a class?
  [[nodiscard]] bool is_value(const Rational& value) const {
    const auto nu = exact_sqrt(Rational(2, k_) * value + top_ * top_);
    return nu && classes_.contains(*nu - Rational(floor(*nu)));
  }

  long k_, looked_ = 0, steps_ = 0;
  Rational top_;
  std::set<Rational> classes_; ///< from 0 to 1, with 1 - nu for each nu
  std::vector<Rational> negative_, chosen_;
  std::set<std::vector<Rational>> found_;
};

} // namespace

std::vector<std::vector<Rational>> eigenvalue_sets(long k, long n, const Rational& sum) {
  return EigenvalueSets(k)(n, sum);
}

std::vector<MPoly> equations_for(const Coefficients& chi, const std::vector<Rational>& values,
                                 Arithmetic& a) {
  std::vector<MPoly> all;
  std::size_t order = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    order = i > 0 && values[i] == values[i - 1] ? order + 1 : 0;
    MPoly sum(chi.front().ring()); // the derivative of this order, times a power of the denominator
    Integer below(1);
    for (std::size_t j = chi.size(); j-- > order;) {
      Integer falling(1);
      for (std::size_t m = 0; m < order; ++m)
        falling = falling * Integer(static_cast<long>(j - m));
      sum = a.plus(a.scaled(sum, values[i].num()), a.scaled(chi[j], falling * below));
      below = a.times(below, values[i].den());
    }
    all.push_back(std::move(sum));
  }
  return all;
}

// ---- the step

namespace {

class DarbouxStep {
public:
  DarbouxStep(const StepPlace& x, Keys& data, Arithmetic& a, std::size_t& nodes)
      : x_(x), ring_(x.family->system.ring), data_(data), a_(a), here_(x, {}, a),
        proof_(here_.given(), nodes) {
    read_chart();
    forms_ = darboux_forms(x_, chart_, a_);
    zeros_ = data_.at("zeros").items();
    shown_ = data_.at("shown").items();
  }

  Said operator()() {
    const Node says = data_.at("says");
    const bool relation = says.text() == "relation";
    if (!relation && says.text() != "multiple") says.fail("relation or multiple is expected");
    need_proper();
    show(resultant_in(proper_, derivative(proper_, w()), w(), a_),
         relation ? Sign::nonzero : Sign::zero);
    const Rational sum = isotropic(relation);
    const auto choices = data_.at("choices").items();
    if (relation)
      need_choices(choices, sum);
    else if (!choices.empty())
      data_.at("choices").fail("nothing is chosen");
    if (next_zero_ != zeros_.size() || next_ != shown_.size())
      data_.at("shown").fail("more is shown than is needed");
    return fact(relation);
  }

private:
  [[nodiscard]] std::size_t w() const { return chart_.coordinates[0]; }

  void read_chart() {
    const auto two = [&](const char* key) { return data_.at(key).items(2, "two are expected"); };
    const auto places = [&](const char* key) {
      std::array<std::size_t, 2> both{};
      for (std::size_t j = 0; j < 2; ++j)
        both[j] = read_coordinate(x_.family->system, two(key)[j]);
      return both;
    };
    chart_.coordinates = places("coordinates");
    chart_.momenta = places("momenta");
    const std::array words{"all", "highest", "lowest"};
    const auto part = std::ranges::find(words, data_.at("part").text());
    if (part == words.end()) data_.at("part").fail("another part of the potential");
    chart_.part = static_cast<PotentialPart>(part - words.begin());
    chart_.degree = data_.at("degree").count();
    chart_.a = two("chart")[0].count();
    chart_.b = two("chart")[1].count();
  }
  // A polynomial in w and the parameters that are left.
  [[nodiscard]] MPoly form(const Node& n) const {
    std::vector<bool> names = x_.family->parameters(x_.at);
    names[w()] = true;
    return read_poly(ring_, n, names);
  }

  // (value, sign), value up to a number.
  void show_row(const Node& row, const MPoly& computed, Sign sign) {
    Keys k(row);
    show_value(k, x_, computed, sign, proof_, "another value");
    k.done();
  }
  void show(const MPoly& f, Sign sign) {
    if (next_ >= shown_.size()) data_.at("shown").fail("not everything is shown");
    show_row(shown_[next_++], f, sign);
  }
  // f = 0 for all w at each point of the stratum.  What f has as a factor beside the forms is shown not to be 0
  // as well, and by that to be free of w.
  void need_identity(const MPoly& f) {
    for (const MPoly& c : coefficients(f, w())) {
      if (is_zero(c)) continue;
      if (next_zero_ >= zeros_.size()) data_.at("zeros").fail("an identity is not shown");
      show_row(zeros_[next_zero_++], c, Sign::zero);
    }
  }

  // The zeros of `proper` are directions of Darboux points; the other directions are none.
  void need_proper() {
    const MPoly unit = form(data_.at("unit")), rest = form(data_.at("rest"));
    proper_ = form(data_.at("proper"));
    need(degree(forms_.directions, w()) == chart_.degree, "a direction is at infinity");
    const long n = degree(proper_, w());
    need(n >= 1 && n <= static_cast<long>(max_eigenvalues), "the number of Darboux points");
    need_identity(a_.minus(a_.times(unit, forms_.directions), a_.times(proper_, rest)));
    for (const MPoly& f :
         {forms_.determinant, lead(forms_.circle, 2), lead(forms_.directions, chart_.degree), unit,
          lead(proper_, n), resultant_in(proper_, forms_.circle, w(), a_),
          resultant_in(proper_, forms_.potential, w(), a_)})
      show(f, Sign::nonzero);
    if (uses(rest, w())) need_improper(rest);
  }
  [[nodiscard]] MPoly lead(const MPoly& f, long d) const {
    const auto all = coefficients(f, w());
    return static_cast<long>(all.size()) > d ? all[static_cast<std::size_t>(d)] : MPoly(ring_);
  }
  // scale (P c)^N = rest cofactor: its zeros are isotropic, or zeros of the potential.
  void need_improper(const MPoly& rest) {
    Keys k(data_.at("improper"));
    const MPoly scale = form(k.at("scale")), cofactor = form(k.at("cofactor"));
    const long power = k.at("power").count();
    k.done();
    need(power >= 1 && power <= max_power, "an exponent is out of range");
    const MPoly both = power_of(a_.times(forms_.potential, forms_.circle), power);
    need_identity(a_.minus(a_.times(scale, both), a_.times(rest, cofactor)));
    show(scale, Sign::nonzero);
  }

  // The sum of 1/Lambda: -k/(2(k - 2 m)) for each isotropic direction, m the order of the potential there.
  Rational isotropic(bool relation) {
    Keys k(data_.at("isotropic"));
    const long first = k.at("order").count();
    const MPoly scale = form(k.at("scale")), rest = form(k.at("rest"));
    const auto lines = k.find("lines");
    k.done();
    if (!relation) {
      if (lines) lines->fail("nothing is asked of the isotropic directions");
      return Rational(0);
    }
    need_order(first);
    const auto [power, second] =
        lines ? along_lines(*lines, first) : std::pair(power_of(forms_.circle, first), first);
    need_identity(a_.minus(a_.times(scale, forms_.potential), a_.times(power, rest)));
    show(scale, Sign::nonzero);
    show(resultant_in(rest, forms_.circle, w(), a_), Sign::nonzero);
    return (half_sum(first) + half_sum(second)) / Rational(2);
  }
  [[nodiscard]] Rational half_sum(long m) const {
    return -Rational(chart_.degree, chart_.degree - 2 * m);
  }
  void need_order(long m) const {
    need(m >= 0 && m <= chart_.degree && 2 * m != chart_.degree, "an order is out of range");
  }
  [[nodiscard]] MPoly power_of(const MPoly& f, long m) const {
    return a_.power(f, static_cast<unsigned long>(m));
  }
  // over c is a product of two lines, so that each is one of the isotropic directions: their powers, and the
  // order along the second one.
  std::pair<MPoly, long> along_lines(const Node& lines, long first) {
    Keys k(lines);
    const auto factors = k.at("factors").items(2, "two lines are expected");
    const std::array both{form(factors[0]), form(factors[1])};
    const MPoly over = form(k.at("over"));
    const long second = k.at("order").count();
    k.done();
    need_order(second);
    need(degree(both[0], w()) == 1 && degree(both[1], w()) == 1, "a line is expected");
    need_identity(a_.minus(a_.times(over, forms_.circle), a_.times(both[0], both[1])));
    show(over, Sign::nonzero);
    return {a_.times(power_of(both[0], first), power_of(both[1], second)), second};
  }

  void need_choices(const std::vector<Node>& choices, const Rational& sum) {
    const Coefficients chi = eigenvalues_at(forms_, chart_, proper_, a_);
    const long n = degree(proper_, w());
    need(static_cast<long>(chi.size()) == n + 1, "the polynomial of the eigenvalues");
    const auto all = eigenvalue_sets(chart_.degree, n, sum);
    need(choices.size() == all.size(), "other sets of eigenvalues");
    for (std::size_t i = 0; i < all.size(); ++i)
      need_choice(choices[i], all[i], equations_for(chi, all[i], a_));
  }
  void need_choice(const Node& n, const std::vector<Rational>& values,
                   const std::vector<MPoly>& equations) {
    Keys k(n);
    const auto told = k.at("values").items(), zero = k.at("equations").items();
    need(told.size() == values.size() && zero.size() == values.size(), "other eigenvalues");
    std::vector<MPoly> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
      need(told[i].rational() == values[i], "other eigenvalues");
      const MPoly f = read_poly(ring_, zero[i], x_.family->parameters());
      need(is_multiple(f, equations[i]), "another equation");
      all.push_back(f);
    }
    proof_.show_some(all, k.at("by"));
    k.done();
  }

  [[nodiscard]] Said fact(bool relation) const {
    const bool whole = chart_.part == PotentialPart::all;
    Said f{FactKind::not_integrable, x_.family, {x_.conditions()}};
    f.classes = {whole ? IntegralClass{}
                       : IntegralClass{.kind = IntegralClass::Kind::rational,
                                       .near = IntegralClass::Near::phase_space}};
    f.used.insert(relation ? "Morales-Ramis, potentials" : "Morales-Ramis-Simo, potentials");
    if (!whole) f.used.insert("Ziglin, parts");
    const std::string degree = std::to_string(chart_.degree);
    const std::string which =
        whole ? "the potential, of degree " + degree
              : "the part of the potential of " + data_.at("part").text() + " degree, " + degree;
    f.way = {relation ? "the eigenvalues at the " + std::to_string(kov::degree(proper_, w())) +
                            " Darboux points of " + which + ", which are simple"
                      : "a multiple Darboux point of " + which};
    f.shows_way = true;
    return f;
  }

  const StepPlace& x_;
  Ring ring_;
  Keys& data_;
  Arithmetic& a_;
  Here here_;
  SetProof proof_;
  DarbouxChart chart_;
  DarbouxForms forms_;
  MPoly proper_;
  std::vector<Node> zeros_, shown_;
  std::size_t next_zero_ = 0, next_ = 0;
};

} // namespace

Said rule::darboux(Keys& step, Derivation& d) {
  const StepPlace here = d.place(step, d.family(step));
  return DarbouxStep(here, step, d.arithmetic(), d.nodes())();
}

} // namespace kov::certify
