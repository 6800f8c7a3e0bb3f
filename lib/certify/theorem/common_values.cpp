#include "certify/theorem/computed.hpp"

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr long most_common_values = 20000, most_function_degree = 20, most_function_bits = 1000,
               most_denominator_bits = 400;
constexpr std::size_t most_gap_digits = 40;

/// The denominators of the rows of Schwarz and Kimura.
constexpr std::array<std::array<long, 3>, 9> schwarz_denominators{{{2, 3, 3},
                                                                   {3, 3, 3},
                                                                   {2, 3, 4},
                                                                   {3, 4, 4},
                                                                   {2, 3, 5},
                                                                   {3, 3, 5},
                                                                   {3, 5, 5},
                                                                   {2, 5, 5},
                                                                   {5, 5, 5}}};

bool is_odd(const Rational& x) { return is_integer((x - Rational(1)) / Rational(2)); }
bool is_half_of_odd(const Rational& x) { return x.den() == Integer(2); }

// Riemann's equation with these differences.
bool may_be_abelian(const std::vector<Rational>& three) {
  for (const Rational& s : {Rational(1), Rational(-1)})
    for (const Rational& t : {Rational(1), Rational(-1)})
      if (is_odd(three[0] + s * three[1] + t * three[2])) return true;
  if (std::ranges::count_if(three, is_half_of_odd) >= 2) return true;
  auto below = mapped<Integer>(three, [&](const Rational& x) { return x.den(); });
  std::ranges::sort(below);
  return std::ranges::any_of(schwarz_denominators, [&](const auto& row) {
    return std::ranges::equal(row, below, [](long x, const Integer& y) { return Integer(x) == y; });
  });
}

Rational value_at(const Poly& f, const Rational& x) { return evaluate(f, NfElem(x)).coeff(0); }

// Has f(start + t) no negative coefficient, and f(start) > 0?
bool positive_from(const Poly& f, const Rational& start) {
  const Poly g = taylor_shift(f, NfElem(start));
  bool positive = sign(g.coeff(0).coeff(0)) > 0;
  for (long i = 1; i <= degree(g); ++i)
    positive = positive && sign(g.coeff(i).coeff(0)) >= 0;
  return positive;
}

// den^n f(num/den), f with integer coefficients
MPoly homogeneous_value(const Poly& f, long n, const Fraction& x, Arithmetic& a) {
  MPoly sum(x.num.ring());
  for (long i = 0; i <= degree(f); ++i)
    if (const Rational c = f.coeff(i).coeff(0); !is_zero(c))
      sum = a.plus(sum, scaled(a.times(a.power(x.num, static_cast<unsigned long>(i)),
                                       a.power(x.den, static_cast<unsigned long>(n - i))),
                               c.num()));
  return sum;
}

Poly read_function(const Node& n) {
  const MPoly f = read_poly(make_ring({"x"}), n);
  need_within(degree(f, 0) <= most_function_degree, "a limit: the function");
  Poly all;
  for (long t = 0; t < f.length(); ++t) {
    const Integer c = f.coefficient(t);
    need_within(static_cast<long>(fmpz_bits(c.raw())) <= most_function_bits,
                "a limit: the function");
    all.set_coeff(static_cast<long>(f.exponents(t)[0]), NfElem(Rational(c)));
  }
  return all;
}

} // namespace

ExponentDifference::ExponentDifference(OneDifference d) : d_(std::move(d)), N_(60) {
  need(std::ranges::count_if(d_.known, is_half_of_odd) < 2,
       "abelian for each value of the difference");
  need(d_.times != 2 || !is_odd(d_.known[0]), "reducible for each value of the difference");
  for (const Rational& x : d_.known)
    N_ = lcm(N_, Integer(2) * x.den());
  need_within(static_cast<long>(fmpz_bits(N_.raw())) <= most_denominator_bits,
              "a limit: the denominators");
}

bool ExponentDifference::is_special(const Rational& x) const {
  auto three = d_.known;
  three.insert(three.end(), d_.times, x);
  return may_be_abelian(three);
}

MPoly off_function(const ExponentDifference& first, const ExponentDifference& second,
                   const ValuesOfDifferences& f, Arithmetic& a) {
  const long n = std::max(degree(f.A), degree(f.B));
  const auto at_first = [&](const Poly& g) { return homogeneous_value(g, n, first.square(), a); };
  const auto& [num, den] = second.square();
  return a.plus(a.times(num, at_first(f.B)), -a.times(den, at_first(f.A)));
}

bool shows_bound(const ExponentDifference& first, const ExponentDifference& second,
                 const ValuesOfDifferences& f) {
  const Rational root(Integer(f.bound), first.N()), start = root * root;
  const auto square = [](const Integer& x) { return Poly(Rational(x * x)); };
  const Poly s(Rational(sign(value_at(f.B, start)) > 0 ? 1 : -1)), A = s * f.A, B = s * f.B;
  if (!positive_from(B, start)) return false;
  if (!f.gap) return positive_from(-A, start);
  const Poly scaled = square(second.N()) * A;
  return positive_from(scaled - square(*f.gap) * B, start) &&
         positive_from(square(*f.gap + Integer(1)) * B - scaled, start);
}

Conditions no_common_values(const ExponentDifference& first, const ExponentDifference& second,
                            const ValuesOfDifferences& f) {
  Conditions all;
  const auto meets = [&](const Rational& x) {
    const Rational below = value_at(f.B, x);
    if (is_zero(below)) return true;
    const Rational square = value_at(f.A, x) / below;
    const auto root = sign(square) < 0 ? std::nullopt : exact_sqrt(square);
    return root && second.is_special(*root);
  };
  for (long j = 0; j < f.bound; ++j) {
    const Rational root(Integer(j), first.N());
    if (!first.is_special(root) || !meets(root * root)) continue;
    const Rational x = root * root;
    const auto& [num, den] = first.square();
    const MPoly p = scaled(num, x.den()) - scaled(den, x.num());
    if (is_zero(p) || !is_constant(p)) add_once(all, {primitive(p), Sign::nonzero});
  }
  return all;
}

namespace {

ValuesOfDifferences read_values(Keys& step) {
  Keys function(step.at("function"));
  ValuesOfDifferences f{read_function(function.at("num")), read_function(function.at("den")),
                        step.at("bound").count()};
  function.done();
  const Node gap = step.at("gap");
  if (gap.text() != "negative") {
    f.gap = gap.integer();
    need(sign(*f.gap) >= 0, "the gap is below 0");
    need_within(gap.text().size() <= most_gap_digits, "a limit: the gap");
  }
  need(!is_zero(f.B), "the function has no denominator");
  return f;
}

// The conditions at which one of them is not special.
Conditions need_no_common_values(const ExponentDifference& first, const ExponentDifference& second,
                                 Keys& step, const StepPlace& here, Derivation& d) {
  const ValuesOfDifferences f = read_values(step);
  const MPoly other = off_function(first, second, f, d.arithmetic());
  const auto by = step.find("by");
  if (by) {
    Here stratum(here, {}, d.arithmetic());
    SetProof(stratum.given(), d.nodes()).show({other, Sign::zero}, *by);
  }
  need(by || is_zero(other), "another function of the difference");
  need_within(f.bound >= 0 && f.bound <= most_common_values, "a limit: the number of values");
  need(shows_bound(first, second, f), "the bound is not shown");
  d.arithmetic().charge(10.0 * static_cast<double>(degree(f.A) + degree(f.B) + 2) *
                        static_cast<double>(f.bound));
  return no_common_values(first, second, f);
}

// The same in the parameters of X that are left, if they are those of Y.
OneDifference in_parameters(OneDifference d, const PhaseSystem& y, const StepPlace& here) {
  const Ring& ring = here.family->system.ring;
  for (MPoly* f : {&d.square.num, &d.square.den}) {
    for (const std::size_t i : used_variables(*f)) {
      const auto j = ring->find(y.ring->name(i));
      need(i >= y.first_parameter() && j && here.family->is_parameter(*j) && !here.at.contains(*j),
           "the difference depends on a level");
    }
    *f = in_ring(*f, ring);
  }
  return d;
}

} // namespace

Said rule::common_values(Keys& step, Derivation& d) {
  const StepPlace here = d.place(step, d.family(step));
  const auto two_of = [](const Node& n) { return n.items(2, "two leaves are expected"); };
  const auto of = two_of(step.at("of")), leaves = two_of(step.at("leaves")),
             shown = two_of(step.at("shown"));
  Said f{FactKind::not_integrable, here.family, {here.conditions()}};
  const auto all_levels = step.find("levels");
  const auto levels = all_levels ? two_of(*all_levels) : std::vector<Node>{};
  std::vector<ExponentDifference> two;
  for (const std::size_t i : {0, 1}) {
    const TheoremFact& curve = d.proved(of[i]);
    need_kind(curve.kind == FactKind::not_integrable || curve.kind == FactKind::leaves);
    const LeafSaid& leaf =
        curve.criteria[read_index(leaves[i], curve.criteria.size(), "no such leaf")];
    need(leaf.difference.has_value(), "not one exponent difference");
    const LevelValues at = read_levels(here, all_levels ? std::optional(levels[i]) : std::nullopt);
    const Map map(here, target_of(curve, leaf), at, shown[i], d.arithmetic(), d.nodes());
    add_once(f.classes, map.carried(leaf.integrals));
    f.way.insert(f.way.end(), curve.way.begin(), curve.way.end());
    if (!at.empty()) f.way.push_back(shown_levels(at));
    need(with_levels(curve.there, *curve.system, here.family->system).text.empty(),
         "functions have values there, which may be others along the other curve");
    two.emplace_back(in_parameters(*leaf.difference, *curve.system, here));
  }
  f.shows_way = true;
  for (const Condition& c : need_no_common_values(two[0], two[1], step, here, d))
    f.regions.front().push_back(c);
  return f;
}

} // namespace kov::certify
