#include "galois/classify.hpp"

#include "exact/error.hpp"
#include "exact/tried.hpp"
#include "kovacic/lines.hpp"
#include "riccati/second_line.hpp"

#include <algorithm>

namespace kov {

namespace {

// The local group is infinite (docs/theory/trichotomy.md, 2).
bool has_infinite_order(const Singularity& p) {
  return p.kind == PlaceKind::irregular || p.kind == PlaceKind::ramified ||
         (p.kind == PlaceKind::regular && !p.delta);
}

} // namespace

Branch trichotomy(const Singularities& s) {
  std::vector<PlaceIndex> places;
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    places.emplace_back(i);
  places.emplace_back();
  const auto first = [&](const auto& has) -> const PlaceIndex* {
    const auto found =
        std::ranges::find_if(places, [&](const PlaceIndex& i) { return has(place_at(s, i)); });
    return found == places.end() ? nullptr : &*found;
  };
  if (const auto* i = first([](const Singularity& p) { return has_infinite_order(p); }))
    return {Trichotomy::irregular_or_irrational, *i};
  if (const auto* i = first([](const Singularity& p) { return p.log == Truth::yes; }))
    return {Trichotomy::logarithmic, *i};
  if (const auto* i = first([](const Singularity& p) { return p.log == Truth::unknown; }))
    return {Trichotomy::undetermined, *i};
  return {Trichotomy::rational_without_log, {}};
}

namespace {

bool is_square(const QuarticRoot& root) {
  return std::ranges::all_of(root.e, [](long e) { return e % 2 == 0; });
}

// v = y1 y2 = Q prod q^(e/2), for even e
RationalFunction product_of_lines(const QuarticRoot& root, const Singularities& s) {
  Poly top = root.q;
  Poly bottom = coerce(Poly(1), s.r.field());
  for (std::size_t i = 0; i < s.finite.size(); ++i) {
    Poly& side = root.e[i] > 0 ? top : bottom;
    side *= pow(s.finite[i].place, static_cast<unsigned long>(std::abs(root.e[i]) / 2));
  }
  return RationalFunction::from_coprime(top, bottom);
}

// y with y^4 = F = Q^2 prod q^e
ExponentialSolution fourth_root(const QuarticRoot& root, const Singularities& s) {
  ExponentialSolution y;
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    if (root.e[i] != 0)
      y.theta += RationalFunction(
          scale(derivative(s.finite[i].place), NfElem(Rational(root.e[i], 4))), s.finite[i].place);
  const auto p = exact_sqrt(root.q);
  KOV_ENSURE(p);
  y.p = *p;
  KOV_ENSURE(solves(y, s.r));
  return y;
}

// If the quartic invariant needs degree > large_degree, first look for a line with degree <=
// small_degree.
constexpr long large_degree = 1000;
constexpr long small_degree = 100;

// One line by families, those of small degree first.  With two lines it may be either of them.
std::optional<ExponentialSolution> line_by_families(const Singularities& local,
                                                    const Budget& budget) {
  const auto found = kovacic::rational_lines(local, budget, nullptr);
  const auto* line = found ? std::get_if<kovacic::Exponential>(&*found) : nullptr;
  if (line == nullptr) return std::nullopt;
  const ExponentialSolution y{line->omega, Poly(1)};
  KOV_ENSURE(solves(y, local.r));
  return y;
}

// The same where no more than `largest_degree` is asked of any polynomial.
std::optional<ExponentialSolution> line_of_degree(const Singularities& local, const Budget& budget,
                                                  long largest_degree) {
  Budget little = budget;
  little.max_degree = std::min(little.max_degree, largest_degree);
  little.max_families = std::min(little.max_families, 1000L);
  return tried<OutOfBudget>([&] { return line_by_families(local, little); });
}

// The exponents may allow a polynomial of a degree that no engine can afford, although each
// family of Kovacic's that has a natural number d needs a small one.  Requires at most one line.
ExponentialSearch exponentials(const Singularities& local, const Budget& budget) {
  try {
    return exponential_solutions(local, budget);
  } catch (const OutOfBudget&) {
    const auto line = line_by_families(local, budget);
    if (!line) throw;
    return {{*line}, std::nullopt, false};
  }
}

// Does the search for the invariants of degree 4 ask for a polynomial of a degree above `limit`?
bool quartic_is_above(const Singularities& local, long limit) {
  try {
    const InvariantShape shape = invariant_shape(local, 4);
    return !shape.obstruction && shape.degree > limit;
  } catch (const OutOfBudget&) {
    return true;
  }
}

// An immense bound of the degree is not a budget matter as long as one prime may settle everything.
bool exponents_allow_a_line(const Singularities& local) {
  try {
    return !exponential_shape(local).obstruction;
  } catch (const OutOfBudget&) {
    return true;
  }
}

bool all_differences_integral(const Singularities& local) {
  const auto integral = [](const Singularity& p) { return p.delta && is_integer(*p.delta); };
  return integral(local.infinity) && std::ranges::all_of(local.finite, integral);
}

/// A classification on its way.
struct Draft {
  const RationalFunction& r;
  const Budget& budget;
  Classification answer = {};

  [[nodiscard]] const Singularities& local() const { return *answer.local; }

  void settle(const GaloisGroup& g, Argument argument) {
    answer.group = g;
    answer.component = identity_component(g);
    answer.abelian = truth(is_abelian(*answer.component));
    answer.argument = argument;
  }

  // The invariants of degree m, recorded either way.
  InvariantSearch search(long m) {
    InvariantSearch found = invariants(local(), m, budget);
    if (found.none)
      answer.no_invariants.push_back(*found.none);
    else
      answer.invariants.push_back(found);
    return found;
  }

  void found_pair(const RationalFunction& v, const NfElem& w_squared) {
    KOV_ENSURE(!is_zero(w_squared));
    answer.pair = ExponentialPair{v, w_squared};
  }

  // The shortest proof there is, where the local data alone do not settle the question.
  bool one_prime_says_sl2() {
    answer.p_curvature = sl2_by_p_curvature(local(), 3, budget);
    if (!answer.p_curvature) return false;
    settle({GroupType::SL2, {}}, Argument::p_curvature);
    return true;
  }

  void two_lines(const RationalFunction& v) {
    if (answer.kind != Trichotomy::irregular_or_irrational) return diagonal(v, NfElem(1));
    found_pair(v, NfElem(1));
    settle({GroupType::Gm, {}}, Argument::torus_two_lines);
  }

  void line_alone(const ExponentialSolution& y) {
    if (answer.kind != Trichotomy::irregular_or_irrational)
      return one_radical_line(y, Argument::line_alone);
    answer.exponential = y;
    settle({GroupType::Borel, {}}, Argument::line_alone);
  }

  // One exponential solution y with y^m rational for some m, and no second one.
  void one_radical_line(const ExponentialSolution& y, Argument argument) {
    answer.exponential = y;
    const auto m = radical_order(logarithmic_parts(y.theta, budget)); // P does not matter
    KOV_ENSURE(m); // regular singular with rational exponents
    settle({GroupType::T, *m}, argument);
  }

  void diagonal(const RationalFunction& v, const NfElem& w_squared) {
    found_pair(v, w_squared);
    const auto m = radical_order(*answer.pair, budget);
    KOV_ENSURE(m);
    settle({GroupType::cyclic, *m}, Argument::two_radicals);
  }
};

// Without a second line; the absence of the first one is recorded.
std::optional<ExponentialSolution> line_or_none(Draft& c) {
  const ExponentialSearch found = exponentials(c.local(), c.budget);
  KOV_ENSURE(!found.projectively_trivial || c.answer.kind != Trichotomy::irregular_or_irrational);
  if (!found.solutions.empty()) return found.solutions.front();
  c.answer.no_exponential = found.none;
  return std::nullopt;
}

// For large exponents: one line of small degree, then the second one or its absence
// (docs/theory/riccati_one_place.md, 7).  No logarithm is excluded; not all solutions are
// square roots of rational functions.
bool one_small_line_says_it(Draft& c) {
  const bool beyond = quartic_is_above(c.local(), c.budget.max_degree);
  if (!beyond && !quartic_is_above(c.local(), large_degree)) return false;
  const auto y = line_of_degree(c.local(), c.budget, beyond ? c.budget.max_degree : small_degree);
  if (!y) return false;
  return tried<OutOfBudget>([&] {
    const auto v = product_with_second_line(*y, c.local(), c.budget);
    v ? c.two_lines(*v) : c.line_alone(*y);
  });
}

// Their product has half the degree of its square, and solves an equation of order 3, not 5.
bool two_long_lines_say_it(Draft& c) {
  if (!quartic_is_above(c.local(), large_degree)) return false;
  const InvariantSearch product = invariants(c.local(), 2, c.budget);
  if (product.none) return false;
  KOV_ENSURE(product.basis.size() == 1); // as the group contains a torus
  const RationalFunction v = value(product.basis.front(), c.local());
  c.found_pair(v, wronskian_squared(v, c.r));
  c.settle({GroupType::Gm, {}}, Argument::torus_two_lines);
  return true;
}

void irregular_or_irrational(Draft& c) {
  if (quartic_is_above(c.local(), -1) && c.one_prime_says_sl2()) return;
  if (one_small_line_says_it(c) || two_long_lines_say_it(c)) return;
  const InvariantSearch quartic = c.search(4);
  if (!quartic.none) {
    c.answer.abelian = Truth::yes;
    c.answer.component = Connected::torus;
    KOV_ENSURE(quartic.basis.size() == 1);
    const QuarticRoot root = quartic_root(quartic.basis.front(), c.local());
    if (is_square(root)) {
      c.found_pair(product_of_lines(root, c.local()), root.w_squared / root.k);
      c.settle({GroupType::Gm, {}}, Argument::torus_two_lines);
    } else {
      c.answer.curve = dihedral_curve(root, c.local());
      c.settle({GroupType::Dinf, {}}, Argument::torus_dihedral);
    }
    return;
  }
  c.answer.abelian = Truth::no;
  c.answer.argument = Argument::torus_no_invariant;
  if (exponents_allow_a_line(c.local()) && c.one_prime_says_sl2()) return;
  c.answer.exponential = line_or_none(c);
  if (c.answer.exponential)
    c.settle({GroupType::Borel, {}}, Argument::torus_one_line);
  else
    c.settle({GroupType::SL2, {}}, Argument::torus_no_line);
}

void logarithmic(Draft& c) {
  if (exponents_allow_a_line(c.local()) && c.one_prime_says_sl2()) return;
  if (const auto y = line_or_none(c)) return c.one_radical_line(*y, Argument::logarithm_one_line);
  c.settle({GroupType::SL2, {}}, Argument::logarithm_no_line);
}

// Euler's equation, with exponents too large for a series: v = y1 y2 vanishes once at each finite
// place.  Two lines exclude logarithms.
bool product_of_places_says_it(Draft& c) {
  RationalFunction v(coerce(Poly(1), c.r.field()));
  for (const Singularity& place : c.local().finite)
    v *= RationalFunction(place.place);
  const RationalFunction dv = derivative(v);
  const RationalFunction w =
      dv * dv - RationalFunction(2) * v * derivative(dv) + RationalFunction(4) * c.r * v * v;
  if (degree(w.num()) != 0 || degree(w.den()) != 0) return false;
  c.diagonal(v, w.num().coeff(0));
  return true;
}

void dihedral(const QuarticRoot& root, Draft& c) {
  c.answer.curve = dihedral_curve(root, c.local());
  c.answer.dihedral = decide_dihedral(*c.answer.curve, c.local(), c.budget);
  c.answer.argument = Argument::dihedral;
  if (c.answer.dihedral->finite == Truth::yes)
    c.settle({GroupType::D, c.answer.dihedral->n}, Argument::dihedral);
  else if (c.answer.dihedral->finite == Truth::no)
    c.settle({GroupType::Dinf, {}}, Argument::dihedral);
  else
    c.answer.undecided = Unable{Unable::Why::not_implemented, reason(c.answer)};
}

void with_quartic(const InvariantSearch& quartic, Draft& c) {
  c.answer.abelian = Truth::yes; // a nonzero invariant: neither SL2 nor Borel
  if (quartic.basis.size() == 2)
    return c.settle({GroupType::D, Integer(2)}, Argument::two_quartics);
  if (quartic.basis.size() > 2) { // cyclic of order 4: Sym^2 has one solution
    const InvariantSearch square = c.search(2);
    KOV_ENSURE(square.basis.size() == 1);
    const RationalFunction v = value(square.basis.front(), c.local());
    return c.diagonal(v, wronskian_squared(v, c.r));
  }
  const QuarticRoot root = quartic_root(quartic.basis.front(), c.local());
  if (is_zero(root.w_squared)) // F = y^4
    return c.one_radical_line(fourth_root(root, c.local()), Argument::fourth_power);
  if (is_square(root))
    return c.diagonal(product_of_lines(root, c.local()), root.w_squared / root.k);
  dihedral(root, c);
}

void without_quartic(Draft& c) {
  if (const auto y = line_or_none(c)) return c.one_radical_line(*y, Argument::one_radical);
  if (const auto none = no_invariant(c.local(), 12, c.budget)) {
    c.answer.no_invariants.push_back(*none);
    return c.settle({GroupType::SL2, {}}, Argument::no_invariant);
  }
  const struct {
    long m;
    GroupType group;
  } primitive[] = {{6, GroupType::A4}, {8, GroupType::S4}, {12, GroupType::A5}};
  for (const auto& [m, group] : primitive)
    if (!c.search(m).none) return c.settle({group, {}}, Argument::primitive);
  // The kernel of degree 12 was an accident of its prime: search(12) has proved that there is
  // none.
  c.settle({GroupType::SL2, {}}, Argument::no_invariant);
}

void rational_exponents(Draft& c) {
  if (all_differences_integral(c.local())) {
    if (c.answer.kind == Trichotomy::undetermined) {
      if (product_of_places_says_it(c)) return;
      throw OutOfBudget("whether there is a logarithm at " +
                        place_name(place_at(c.local(), c.answer.decisive)) + " is not known");
    }
    const auto odd = [](const Singularity& p) { return fmpz_is_odd(p.delta->num().raw()) != 0; };
    const bool rational = std::ranges::all_of(c.local().finite, odd);
    c.settle({GroupType::cyclic, Integer(rational ? 1 : 2)}, Argument::integral_exponents);
    return;
  }
  if (c.one_prime_says_sl2() || one_small_line_says_it(c)) return;
  const InvariantSearch quartic = c.search(4);
  if (!quartic.none)
    with_quartic(quartic, c);
  else
    without_quartic(c);
}

} // namespace

Classification classify(const RationalFunction& r, const Budget& budget) {
  Draft c{r, budget};
  if (is_zero(r)) {
    c.settle({GroupType::cyclic, Integer(1)}, Argument::zero);
    c.answer.pair.reset();
    return c.answer;
  }
  try {
    c.answer.local = singularities(r, budget);
    const Branch branch = trichotomy(*c.answer.local);
    c.answer.kind = branch.kind;
    c.answer.decisive = branch.decisive;
    switch (c.answer.kind) {
    case Trichotomy::irregular_or_irrational:
      irregular_or_irrational(c);
      break;
    case Trichotomy::logarithmic:
      logarithmic(c);
      break;
    default:
      rational_exponents(c);
      break;
    }
  } catch (const OutOfBudget& limit) {
    c.answer.undecided = Unable{Unable::Why::budget, limit.what()};
  }
  return c.answer;
}

} // namespace kov
