#include "canonical/elementary.hpp"
#include "exact/tried.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_origins = 200; // places that are tried
constexpr long most_rests = 40;           // with multiplicities

/// Values of the coordinates at which something special may be.
class Places {
public:
  Places(const Form& form, const Budget& budget) : form_(form), budget_(budget) {
    Substitution at_rest;
    for (std::size_t i = 0; i < form.degrees(); ++i)
      at_rest[form.p(i)] = MFraction(form.field.ring);
    potential_ = substitute(*form.field.hamiltonian, at_rest);
    values_.assign(form.degrees(), {MFraction(form.field.ring)});
  }

  std::vector<std::vector<MFraction>> all() {
    add_linear_factors();
    add_centres();
    add_rests();
    std::vector<std::vector<MFraction>> places{{}};
    for (const auto& values : values_) {
      std::vector<std::vector<MFraction>> longer;
      for (const auto& place : places)
        for (const MFraction& value : values)
          if (longer.size() < most_origins) {
            longer.push_back(place);
            longer.back().push_back(value);
          }
      places = std::move(longer);
    }
    return places;
  }

private:
  // Takes values without denominators only, which hold for all parameters.
  void add(std::size_t i, const MFraction& value) {
    if (!form_.is_constant_of_motion(value) || !is_constant(MFraction(value.den()))) return;
    auto& all = values_[i];
    add_once(all, value);
  }
  void add_root(std::size_t i, const MPoly& f) {
    const auto c = coefficients(f, form_.q(i));
    if (c.size() == 2) add(i, -MFraction(c[0], c[1]));
  }

  // Poles, and where roots vanish.
  void add_linear_factors() {
    std::vector<MPoly> all{form_.field.hamiltonian->den()};
    all.insert(all.end(), form_.field.relations.begin(), form_.field.relations.end());
    for (const MPoly& f : all)
      for (const MFactor& factor : factor(f).second)
        for (std::size_t i = 0; i < form_.degrees(); ++i)
          add_root(i, factor.base);
  }

  // c x^n + b x^(n-1) + ... with constant b/c: x = -b/(n c).  Also of the denominator.
  void add_centres() {
    for (const MFraction& f : {potential_, *form_.field.hamiltonian})
      for (const MPoly& part : {f.num(), f.den()})
        for (std::size_t i = 0; i < form_.degrees(); ++i) {
          const auto c = coefficients(part, form_.q(i));
          if (c.size() < 3) continue;
          const long n = static_cast<long>(c.size()) - 1;
          add(i, Rational(Integer(-1), Integer(n)) * MFraction(c[c.size() - 2], c.back()));
        }
  }

  // Adds the places where the potential, a rational function, is critical.
  void add_rests() {
    std::vector<std::size_t> main;
    std::vector<MPoly> slopes;
    for (std::size_t i = 0; i < form_.degrees(); ++i)
      if (uses(potential_, form_.q(i))) {
        main.push_back(form_.q(i));
        slopes.push_back(derivative(potential_, form_.q(i)).num());
      }
    for (const FunctionSymbol& f : form_.field.functions)
      if (uses(potential_, f.variable)) return;
    if (main.empty()) return;
    Ideal rests(form_.field.ring, main, slopes, {potential_.den()}, budget_);
    if (rests.dimension() != 0) return;
    const FiniteAlgebra algebra(std::move(rests), most_rests);
    for (std::size_t i = 0; i < form_.degrees(); ++i)
      if (uses(potential_, form_.q(i))) add_roots_of_minimal_polynomial(algebra, i);
  }
  void add_roots_of_minimal_polynomial(const FiniteAlgebra& algebra, std::size_t i) {
    const MFraction x = form_.variable(form_.q(i));
    const auto element = algebra.evaluate(x);
    if (!element) return;
    MFraction value(form_.field.ring), power(form_.field.ring, Rational(1));
    for (const MFraction& c : algebra.minimal_polynomial(*element)) {
      value += c * power;
      power *= x;
    }
    for (const MFactor& f : factor(value.num()).second)
      add_root(i, f.base);
  }

  const Form& form_;
  const Budget& budget_;
  MFraction potential_;
  std::vector<std::vector<MFraction>> values_;
};

Form shifted(const Form& form, const std::vector<MFraction>& place) {
  Substitution old, now;
  for (std::size_t i = 0; i < form.degrees(); ++i) {
    if (is_zero(place[i])) continue;
    old[form.q(i)] = form.variable(form.q(i)) + place[i];
    now[form.q(i)] = form.variable(form.q(i)) - place[i];
  }
  return old.empty() ? form : changed(form, old, now);
}

} // namespace

Form with_good_origin(const Form& form, const Budget& budget) {
  Form best = form;
  tried<OutOfBudget, InvalidArgument>([&] { // a limit, or too many rests: what was found is right
    for (const auto& place : Places(form, budget).all()) {
      budget.check();
      Form next = with_completed_square(shifted(form, place), budget);
      if (next.length() < best.length()) best = std::move(next);
    }
  });
  return best;
}

} // namespace kov
