// strata_certificates.md 7.6, 7.7: G0 is not abelian at any point of the stratum.

#include "certify/strata/places.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <array>

namespace kov::certify {

namespace {

constexpr std::size_t max_values = 20000;

// Values of Delta at an open place at which G0 might be abelian.
class ExcludedValues {
public:
  ExcludedValues(const Stratum& s, const ProvedPlace& open) : s_(s), open_(open) {}

  void add(const Rational& v) {
    s_.arithmetic().charge(work_of_a_rational);
    values_.insert(v);
    need_within(values_.size() <= max_values, "a limit: too many values of an exponent difference");
  }
  /// All a/N, a >= 1, up to b.
  void add_multiples(long N, const Rational& b) {
    for (Integer a(1); Rational(a, Integer(N)) <= b; a += Integer(1))
      add(Rational(a, Integer(N)));
  }
  /// chi(v^2) is not 0 on the stratum.
  void need_excluded() const {
    const Coefficients& chi = open_.chi;
    for (const Rational& v : values_) {
      const Rational square = v * v;
      const MPoly f =
          s_.arithmetic().plus(scaled(chi[1], square.num()), scaled(chi[0], square.den()));
      if (!s_.is_unit(f))
        throw Refused{"the exponent difference " + to_string(v) + " is not excluded"};
    }
  }

private:
  const Stratum& s_;
  const ProvedPlace& open_;
  std::set<Rational> values_;
};

// 7.7: exactly one place is open.
class OneOpen {
public:
  OneOpen(const Places& places, const ProvedPlace& open)
      : a_(places.stratum().arithmetic()), places_(places), open_(open), b_(open.largest()),
        values_(places.stratum(), open) {}

  void operator()() {
    const bool torus = places_.infinite_order();
    const bool log = places_.has_log();
    if (torus && log) return; // not abelian anyway
    need(b_.has_value(), "the exponent difference has no bound");
    if (!log) add_products();
    if (!torus && !log) add_primitive();
    if (!torus) add_lines();
    values_.need_excluded();
  }

private:
  // (i) G in N(T): the exponents of (y1 y2)^2.
  void add_products() {
    std::optional<Sums> sums{Sums{open_.q ? Rational(-2 * open_.n) : Rational(2)}};
    for (const ProvedPlace& x : places_.all)
      if (!x.open()) sums = add_choices(a_, std::move(sums), products(x), x.n);
    need_within(sums.has_value(), "a limit: too many sums of exponents");
    for (Integer k(1); Rational(k, Integer(2)) <= *b_; k += Integer(1))
      if (possible(*sums, k)) values_.add(Rational(k, Integer(2)));
  }

  // Is (f + jk)/2 a natural number for some sum f and some -d <= j <= d?
  [[nodiscard]] bool possible(const Sums& sums, const Integer& k) const {
    a_.charge(work_of_a_rational * static_cast<double>(sums.size()) *
              static_cast<double>(2 * open_.n + 1));
    for (const Rational& f : sums)
      for (long j = -open_.n; j <= open_.n; ++j)
        if (is_natural_number((f + Rational(Integer(j) * k)) / Rational(2))) return true;
    return false;
  }

  static Sums products(const ProvedPlace& x) {
    if (x.ordinary()) return {0, 2, 4};
    if (x.simple()) return {x.q ? -4 : 0};
    if (x.irregular()) return {x.q ? -x.order : 4 - x.order};
    const Rational s(x.sign());
    if (!x.delta) return {s * Rational(2)};
    const Rational twice = Rational(2) * *x.delta;
    if (x.has_log()) return {s * (Rational(2) - s * twice)};
    Sums c{s * Rational(2)};
    if (is_integer(twice)) {
      c.insert(s * (Rational(2) + twice));
      c.insert(s * (Rational(2) - twice));
    }
    return c;
  }

  // (ii) G finite and primitive: local orders up to 5 and an invariant of degree 12.
  void add_primitive() {
    for (const ProvedPlace& x : places_.all)
      if (x.delta && x.delta->den() > Integer(5)) return;
    for (long N = 1; N <= 5; ++N)
      for (Integer a(1); Rational(a, Integer(N)) <= *b_; a += Integer(1)) {
        const Rational v(a, Integer(N));
        a_.charge(work_of_a_rational * static_cast<double>(places_.all.size()));
        const auto D = places_.degree_bound(12, v);
        if (D && sign(*D) >= 0) values_.add(v);
      }
  }

  // (iii) G reducible: the exponents of an exponential solution.
  void add_lines() {
    const Rational half(1, 2);
    std::optional<Sums> sums{Sums{open_.q ? -half * Rational(open_.n) : half}};
    for (const ProvedPlace& x : places_.all) {
      if (x.open()) continue;
      const auto choices = Places::line_choices(x);
      need(choices.has_value(), "internal: an exponent difference is not rational");
      sums = add_choices(a_, std::move(sums), *choices, x.n);
      need_within(sums.has_value(), "a limit: too many sums of exponents");
    }
    for (const Rational& f : *sums)
      for (long j = open_.n; j >= 0; j -= 2)
        add_line(f, j);
  }

  // All |2(k - f)/j| <= b, k natural; -j gives the same.
  void add_line(const Rational& f, long j) {
    a_.charge(work_of_a_rational);
    if (j == 0) {
      need(!is_natural_number(f), "an exponential solution may exist for all exponent differences");
      return;
    }
    const Rational reach = *b_ * Rational(j) / Rational(2);
    Integer k = ceil(f - reach);
    if (sign(k) < 0) k = Integer(0);
    for (; Rational(k) <= f + reach; k += Integer(1))
      values_.add(abs(Rational(2) * (Rational(k) - f) / Rational(j)));
  }

  Arithmetic& a_;
  const Places& places_;
  const ProvedPlace& open_;
  std::optional<Rational> b_;
  ExcludedValues values_;
};

std::vector<const ProvedPlace*> open_places(const Places& places) {
  std::vector<const ProvedPlace*> open;
  for (const ProvedPlace& x : places.all)
    if (x.open()) open.push_back(&x);
  return open;
}

void need_torus(const Places& places) { need(places.infinite_order(), "no place shows a torus"); }
void need_log(const Places& places) { need(places.has_log(), "no place has a logarithm"); }
void need_no_invariant_4(const Places& places) {
  need(places.no_invariant(4), "an invariant of degree 4 is not excluded");
}
void need_no_line_by_degree(const Places& places) {
  need(places.no_line_by_degree(), "an exponential solution is not excluded");
}

void torus_log(const Places& places) {
  need_torus(places);
  need_log(places);
}

void torus(const Places& places) {
  need_torus(places);
  need(!places.any(&ProvedPlace::open), "an exponent difference is open");
  need_no_invariant_4(places);
}

void irreducible_log(const Places& places) {
  need_log(places);
  need_no_line_by_degree(places);
}

void one_open(const Places& places) {
  const auto open = open_places(places);
  need(open.size() == 1, "not exactly one exponent difference is open");
  need_no_invariant_4(places);
  OneOpen(places, *open[0])();
}

void several_open(const Places& places) {
  const auto open = open_places(places);
  need(!open.empty(), "no exponent difference is open");
  const bool torus = places.infinite_order();
  if (!torus) need_no_line_by_degree(places);
  need_no_invariant_4(places);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto b = open[i]->largest();
    need(b.has_value(), "an exponent difference has no bound");
    ExcludedValues values(places.stratum(), *open[i]);
    values.add_multiples(2, *b);
    if (i == 0 && !torus && !places.has_log())
      for (long N = 3; N <= 5; ++N)
        values.add_multiples(N, *b);
    values.need_excluded();
  }
}

// The least n that makes y^n rational for an exponential solution, and even.
long character_order(const Places& places) {
  const Integer n = lcm(Integer(2), places.character_order());
  need_within(n <= Integer(max_sym), "a limit: the degree of an invariant");
  return to_long(n);
}

void rational(const Places& places) {
  for (const ProvedPlace& x : places.all)
    need(x.tame(), "not all exponent differences are rational");
  need(places.has_log() || places.no_invariant(12), "an invariant of degree 12 is not excluded");
  need(places.no_line() || places.no_invariant(character_order(places)),
       "an exponential solution is not excluded");
}

struct PlacesTheorem {
  std::string_view id;
  void (*check)(const Places&);
};
constexpr std::array<PlacesTheorem, 7> places_theorems{{{"torus-log", torus_log},
                                                        {"torus", torus},
                                                        {"irreducible-log", irreducible_log},
                                                        {"rational", rational},
                                                        {"one-open", one_open},
                                                        {"open", several_open},
                                                        {"separated", check_separated}}};

} // namespace

bool is_places_theorem(std::string_view id) {
  return std::ranges::find(places_theorems, id, &PlacesTheorem::id) != places_theorems.end();
}

void check_places(const Stratum& s, const ByPlaces& leaf) {
  const Places places(s, leaf);
  const auto* theorem = std::ranges::find(places_theorems, leaf.theorem, &PlacesTheorem::id);
  need(theorem != places_theorems.end(), "an unknown theorem");
  need(!leaf.growth || leaf.theorem == "separated", "the theorem has no growth");
  theorem->check(places);
}

} // namespace kov::certify
