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

class Classifier {
public:
  Classifier(const RationalFunction& r, const Budget& budget) : r_(r), budget_(budget) {}

  Classification run() {
    if (is_zero(r_)) {
      settle({GroupType::cyclic, Integer(1)}, Argument::zero);
      answer_.pair.reset();
      return answer_;
    }
    try {
      answer_.local = singularities(r_, budget_);
      const Branch branch = trichotomy(*answer_.local);
      answer_.kind = branch.kind;
      answer_.decisive = branch.decisive;
      switch (answer_.kind) {
      case Trichotomy::irregular_or_irrational:
        irregular_or_irrational();
        break;
      case Trichotomy::logarithmic:
        logarithmic();
        break;
      default:
        rational_exponents();
        break;
      }
    } catch (const OutOfBudget& limit) {
      answer_.undecided = Unable{Unable::Why::budget, limit.what()};
    }
    return answer_;
  }

private:
  [[nodiscard]] const Singularities& local() const { return *answer_.local; }

  void settle(const GaloisGroup& g, Argument argument) {
    answer_.group = g;
    answer_.component = identity_component(g);
    answer_.abelian = truth(is_abelian(*answer_.component));
    answer_.argument = argument;
  }

  // The invariants of degree m, recorded either way.
  InvariantSearch search(long m) {
    InvariantSearch found = invariants(local(), m, budget_);
    if (found.none)
      answer_.no_invariants.push_back(*found.none);
    else
      answer_.invariants.push_back(found);
    return found;
  }

  void found_pair(const RationalFunction& v, const NfElem& w_squared) {
    KOV_ENSURE(!is_zero(w_squared));
    answer_.pair = ExponentialPair{v, w_squared};
  }

  // The shortest proof there is, where the local data alone do not settle the question.
  bool one_prime_says_sl2() {
    answer_.p_curvature = sl2_by_p_curvature(local(), 3, budget_);
    if (!answer_.p_curvature) return false;
    settle({GroupType::SL2, {}}, Argument::p_curvature);
    return true;
  }

  // One line by families, those of small degree first.  With two lines it may be either of them.
  [[nodiscard]] std::optional<ExponentialSolution> line_by_families(const Budget& budget) const {
    const auto found = kovacic::rational_lines(local(), budget, nullptr);
    const auto* line = found ? std::get_if<kovacic::Exponential>(&*found) : nullptr;
    if (line == nullptr) return std::nullopt;
    const ExponentialSolution y{line->omega, Poly(1)};
    KOV_ENSURE(solves(y, local().r));
    return y;
  }

  // The same where no more than `largest_degree` is asked of any polynomial.
  [[nodiscard]] std::optional<ExponentialSolution> line_of_degree(long largest_degree) const {
    Budget little = budget_;
    little.max_degree = std::min(little.max_degree, largest_degree);
    little.max_families = std::min(little.max_families, 1000L);
    return tried<OutOfBudget>([&] { return line_by_families(little); });
  }

  // The exponents may allow a polynomial of a degree that no engine can afford, although each
  // family of Kovacic's that has a natural number d needs a small one.  Requires at most one line.
  [[nodiscard]] ExponentialSearch exponentials() {
    try {
      return exponential_solutions(local(), budget_);
    } catch (const OutOfBudget&) {
      const auto line = line_by_families(budget_);
      if (!line) throw;
      return {{*line}, std::nullopt, false};
    }
  }

  // Does the search for the invariants of degree 4 ask for a polynomial of a degree above `limit`?
  [[nodiscard]] bool quartic_is_above(long limit) const {
    try {
      const InvariantShape shape = invariant_shape(local(), 4);
      return !shape.obstruction && shape.degree > limit;
    } catch (const OutOfBudget&) {
      return true;
    }
  }

  // For large exponents: one line of small degree, then the second one or its absence
  // (docs/theory/riccati_one_place.md, 7).  No logarithm is excluded; not all solutions are
  // square roots of rational functions.
  bool one_small_line_says_it() {
    const bool beyond = quartic_is_above(budget_.max_degree);
    if (!beyond && !quartic_is_above(large_degree)) return false;
    const auto y = line_of_degree(beyond ? budget_.max_degree : small_degree);
    if (!y) return false;
    return tried<OutOfBudget>([&] {
      const auto v = product_with_second_line(*y, local(), budget_);
      v ? two_lines(*v) : line_alone(*y);
    });
  }

  // Their product has half the degree of its square, and solves an equation of order 3, not 5.
  bool two_long_lines_say_it() {
    if (!quartic_is_above(large_degree)) return false;
    const InvariantSearch product = invariants(local(), 2, budget_);
    if (product.none) return false;
    KOV_ENSURE(product.basis.size() == 1); // as the group contains a torus
    const RationalFunction v = value(product.basis.front(), local());
    found_pair(v, wronskian_squared(v, r_));
    settle({GroupType::Gm, {}}, Argument::torus_two_lines);
    return true;
  }

  void two_lines(const RationalFunction& v) {
    if (answer_.kind != Trichotomy::irregular_or_irrational) return diagonal(v, NfElem(1));
    found_pair(v, NfElem(1));
    settle({GroupType::Gm, {}}, Argument::torus_two_lines);
  }

  void line_alone(const ExponentialSolution& y) {
    if (answer_.kind != Trichotomy::irregular_or_irrational)
      return one_radical_line(y, Argument::line_alone);
    answer_.exponential = y;
    settle({GroupType::Borel, {}}, Argument::line_alone);
  }

  // An immense bound of the degree is not a budget matter as long as one prime may settle everything.
  [[nodiscard]] bool exponents_allow_a_line() const {
    try {
      return !exponential_shape(local()).obstruction;
    } catch (const OutOfBudget&) {
      return true;
    }
  }

  void irregular_or_irrational() {
    if (quartic_is_above(-1) && one_prime_says_sl2()) return;
    if (one_small_line_says_it() || two_long_lines_say_it()) return;
    const InvariantSearch quartic = search(4);
    if (!quartic.none) {
      answer_.abelian = Truth::yes;
      answer_.component = Connected::torus;
      KOV_ENSURE(quartic.basis.size() == 1);
      const QuarticRoot root = quartic_root(quartic.basis.front(), local());
      if (is_square(root)) {
        found_pair(product_of_lines(root, local()), root.w_squared / root.k);
        settle({GroupType::Gm, {}}, Argument::torus_two_lines);
      } else {
        answer_.curve = dihedral_curve(root, local());
        settle({GroupType::Dinf, {}}, Argument::torus_dihedral);
      }
      return;
    }
    answer_.abelian = Truth::no;
    answer_.argument = Argument::torus_no_invariant;
    if (exponents_allow_a_line() && one_prime_says_sl2()) return;
    const ExponentialSearch exponential = exponentials();
    KOV_ENSURE(!exponential.projectively_trivial);
    if (!exponential.solutions.empty()) {
      answer_.exponential = exponential.solutions.front();
      settle({GroupType::Borel, {}}, Argument::torus_one_line);
    } else {
      answer_.no_exponential = exponential.none;
      settle({GroupType::SL2, {}}, Argument::torus_no_line);
    }
  }

  // One exponential solution y with y^m rational for some m, and no second one.
  void one_radical_line(const ExponentialSolution& y, Argument argument) {
    answer_.exponential = y;
    const auto m = radical_order(logarithmic_parts(y.theta, budget_)); // P does not matter
    KOV_ENSURE(m); // regular singular with rational exponents
    settle({GroupType::T, *m}, argument);
  }

  void logarithmic() {
    if (exponents_allow_a_line() && one_prime_says_sl2()) return;

    const ExponentialSearch exponential = exponentials();
    if (!exponential.solutions.empty()) {
      one_radical_line(exponential.solutions.front(), Argument::logarithm_one_line);
      return;
    }
    answer_.no_exponential = exponential.none;
    settle({GroupType::SL2, {}}, Argument::logarithm_no_line);
  }

  [[nodiscard]] bool all_differences_integral() const {
    const auto integral = [](const Singularity& p) { return p.delta && is_integer(*p.delta); };
    return integral(local().infinity) && std::ranges::all_of(local().finite, integral);
  }

  // Euler's equation, with exponents too large for a series: v = y1 y2 vanishes once at each finite
  // place.  Two lines exclude logarithms.
  bool product_of_places_says_it() {
    RationalFunction v(coerce(Poly(1), r_.field()));
    for (const Singularity& place : local().finite)
      v *= RationalFunction(place.place);
    const RationalFunction dv = derivative(v);
    const RationalFunction w =
        dv * dv - RationalFunction(2) * v * derivative(dv) + RationalFunction(4) * r_ * v * v;
    if (degree(w.num()) != 0 || degree(w.den()) != 0) return false;
    diagonal(v, w.num().coeff(0));
    return true;
  }

  void rational_exponents() {
    if (all_differences_integral()) {
      if (answer_.kind == Trichotomy::undetermined) {
        if (product_of_places_says_it()) return;
        throw OutOfBudget("whether there is a logarithm at " +
                          place_name(place_at(local(), answer_.decisive)) + " is not known");
      }
      const auto odd = [](const Singularity& p) { return fmpz_is_odd(p.delta->num().raw()) != 0; };
      const bool rational = std::ranges::all_of(local().finite, odd);
      settle({GroupType::cyclic, Integer(rational ? 1 : 2)}, Argument::integral_exponents);
      return;
    }
    if (one_prime_says_sl2() || one_small_line_says_it()) return;
    const InvariantSearch quartic = search(4);
    if (!quartic.none)
      with_quartic(quartic);
    else
      without_quartic();
  }

  void with_quartic(const InvariantSearch& quartic) {
    answer_.abelian = Truth::yes; // a nonzero invariant: neither SL2 nor Borel
    if (quartic.basis.size() == 2) {
      settle({GroupType::D, Integer(2)}, Argument::two_quartics);
      return;
    }
    if (quartic.basis.size() > 2) { // cyclic of order 4: Sym^2 has one solution
      const InvariantSearch square = search(2);
      KOV_ENSURE(square.basis.size() == 1);
      const RationalFunction v = value(square.basis.front(), local());
      diagonal(v, wronskian_squared(v, r_));
      return;
    }
    const QuarticRoot root = quartic_root(quartic.basis.front(), local());
    if (is_zero(root.w_squared)) { // F = y^4
      one_radical_line(fourth_root(root, local()), Argument::fourth_power);
      return;
    }
    if (is_square(root)) {
      diagonal(product_of_lines(root, local()), root.w_squared / root.k);
      return;
    }
    dihedral(root);
  }

  void diagonal(const RationalFunction& v, const NfElem& w_squared) {
    found_pair(v, w_squared);
    const auto m = radical_order(*answer_.pair, budget_);
    KOV_ENSURE(m);
    settle({GroupType::cyclic, *m}, Argument::two_radicals);
  }

  void dihedral(const QuarticRoot& root) {
    answer_.curve = dihedral_curve(root, local());
    answer_.dihedral = decide_dihedral(*answer_.curve, local(), budget_);
    answer_.argument = Argument::dihedral;
    if (answer_.dihedral->finite == Truth::yes)
      settle({GroupType::D, answer_.dihedral->n}, Argument::dihedral);
    else if (answer_.dihedral->finite == Truth::no)
      settle({GroupType::Dinf, {}}, Argument::dihedral);
    else
      answer_.undecided = Unable{Unable::Why::not_implemented, reason(answer_)};
  }

  void without_quartic() {
    const ExponentialSearch exponential = exponentials();
    if (!exponential.solutions.empty()) {
      one_radical_line(exponential.solutions.front(), Argument::one_radical);
      return;
    }
    answer_.no_exponential = exponential.none;
    if (const auto none = no_invariant(local(), 12, budget_)) {
      answer_.no_invariants.push_back(*none);
      settle({GroupType::SL2, {}}, Argument::no_invariant);
      return;
    }
    const struct {
      long m;
      GroupType group;
    } primitive[] = {{6, GroupType::A4}, {8, GroupType::S4}, {12, GroupType::A5}};
    for (const auto& [m, group] : primitive) {
      if (search(m).none) continue;
      settle({group, {}}, Argument::primitive);
      return;
    }
    // The kernel of degree 12 was an accident of its prime: search(12) has proved that there is
    // none.
    settle({GroupType::SL2, {}}, Argument::no_invariant);
  }

  const RationalFunction& r_;
  const Budget& budget_;
  Classification answer_;
};

} // namespace

Classification classify(const RationalFunction& r, const Budget& budget) {
  return Classifier(r, budget).run();
}

} // namespace kov
