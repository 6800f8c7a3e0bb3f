#include "closed/lame_criteria.hpp"

#include "closed/criterion.hpp"
#include "closed/lame.hpp"
#include "closed/parts.hpp"
#include "closed/statement.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using Answer = std::variant<std::monostate, ClassicalAnswer, Needs>;

MFraction constant(const Ring& ring, const Rational& c) { return {ring, c}; }

class Lame {
public:
  Lame(const LameFamilyForm& form, const ParametrisedSet& region, const Budget& budget)
      : form_(form), p_(form.parameters), region_(region), budget_(budget), parts_(region) {}

  Answer run() {
    for (const MPoly& f : form_.generic)
      if (auto needs = must_not_vanish(f)) return *std::move(needs);
    const MFraction disc = p_.g2 * p_.g2 * p_.g2 - Rational(27) * (p_.g3 * p_.g3);
    if (is_zero(disc)) return {};
    if (auto needs = must_not_vanish(disc.num())) return *std::move(needs);
    const Ring& ring = form_.alpha.ring();
    const MFraction square = Rational(4) * form_.alpha + constant(ring, Rational(1));
    if (!is_number(form_.alpha))
      any_index(square);
    else if (auto needs = given_index(square))
      return *std::move(needs);
    ClassicalForm found{Classical::lame, {{"2*n + 1", square}}, MFraction(ring), 1};
    found.values = {{"B", p_.b}, {"g2", p_.g2}, {"g3", p_.g3}};
    return ClassicalAnswer{std::move(found), parts_.take(), form_.map, equation(square)};
  }

private:
  // f = 4x^3 - g2 x - g3:  r = f''/(4f) - 3 f'^2/(16 f^2) + (alpha x + B)/f
  [[nodiscard]] ClassicalEquation equation(const MFraction& square) const {
    const Ring& ring = form_.alpha.ring();
    const MFraction x = MFraction::variable(ring, form_.z);
    const MFraction f = Rational(4) * (x * x * x) - p_.g2 * x - p_.g3;
    const MFraction slope = derivative(f, form_.z);
    const MFraction r = (Rational(1, 4) * derivative(slope, form_.z) + form_.alpha * x + p_.b) / f -
                        Rational(3, 16) * (slope * slope) / (f * f);
    return {form_.z, r, {f.num()}, {constant(ring, Rational(1, 4)), square}};
  }
  [[nodiscard]] std::optional<Needs> must_not_vanish(const MPoly& f) const {
    auto doubt = region_.doubtful_factor(f);
    if (!doubt) return std::nullopt;
    return Needs{*std::move(doubt), {Event::Kind::poles_meet}};
  }

  void add_sl2() { parts_.add(GroupType::SL2); }
  // The equation in (z - c)^2 has the same identity component; the group of the given one is, up to
  // signs, of index 1 or 2 in that group.
  void add_quaternions() {
    if (form_.squared) return parts_.add(Truth::yes, GroupBound::finite);
    parts_.add(GroupType::D, Integer(2));
  }
  // n is an integer: T_4 where B is an eigenvalue of a polynomial of Lame, else dihedral.
  void add_hermite(const std::optional<MPoly>& reducible) {
    if (reducible && vanishes(*reducible))
      return form_.squared ? parts_.add(GroupType::T) : parts_.add(GroupType::T, Integer(4));
    const bool irreducible = reducible && is_plainly_nonzero(*reducible, region_);
    parts_.add(Truth::yes,
               irreducible ? GroupBound::torus_normaliser : GroupBound::torus_normaliser_or_T);
  }
  // All conditions for a finite group hold; A5 has no subgroup of index 2.
  void add_polyhedral(const LameConditions& c) {
    const auto holds = [&](const MPoly& f) { return vanishes(f); };
    const bool octahedral = std::ranges::all_of(c.octahedral, holds);
    const bool icosahedral = std::ranges::any_of(
        c.octahedral, [&](const MPoly& f) { return is_plainly_nonzero(f, region_); });
    if (icosahedral) return parts_.add(GroupType::A5);
    if (octahedral && !form_.squared) return parts_.add(GroupType::S4);
    parts_.add(Truth::yes, GroupBound::finite);
  }

  void any_index(const MFraction& square) {
    const Squares all{square, p_.b, p_.g2, p_.g3};
    const Rational zero(0);
    const auto sl2 = [&] { add_sl2(); };
    const auto half = [&] {
      parts_.split(
          LameIsFinite{all, true}, [&] { add_quaternions(); }, sl2);
    };
    const auto polyhedral = [&] {
      parts_.split(
          LameIsFinite{all, false}, [&] { parts_.add(Truth::yes, GroupBound::finite); }, sl2);
    };
    const SumIn fractions{{square},
                          {{zero, Rational(2, 3)}, {zero, Rational(1, 2)}, {zero, Rational(2, 5)}}};
    const auto no_integer = [&] {
      parts_.split(SumIn{{square}, {{zero, Rational(2)}}}, half,
                   [&] { parts_.split(fractions, polyhedral, sl2); });
    };
    parts_.split(
        SumIn{{square}, {odd_integers}},
        [&] { parts_.add(Truth::yes, GroupBound::torus_normaliser_or_T); }, no_integer);
  }

  // Abelian exactly where some polynomials all vanish.
  std::optional<Needs> given_index(const MFraction& square) {
    const Rational four_alpha = is_zero(square) ? Rational(-1) : to_rational(square) - Rational(1);
    const LameIndex index = lame_index(NfElem(four_alpha * Rational(1, 4)));
    const LameConditions c = lame_conditions(index, p_, budget_);
    if (index.kind == LameCase::hermite) {
      add_hermite(c.reducible);
      return std::nullopt;
    }
    std::optional<MPoly> doubt;
    for (const MPoly& f : c.abelian) {
      if (vanishes(f)) continue;
      auto factor = region_.doubtful_factor(f);
      if (!factor) {
        add_sl2();
        return std::nullopt;
      }
      if (!doubt) doubt = std::move(factor);
    }
    if (doubt) return Needs{*std::move(doubt), {.kind = Event::Kind::invariant_appears, .m = 12}};
    if (index.kind == LameCase::brioschi)
      add_quaternions();
    else
      add_polyhedral(c);
    return std::nullopt;
  }
  // A relation that is not solved says so.
  [[nodiscard]] bool vanishes(const MPoly& f) const {
    const auto& all = region_.relations();
    return is_zero(f) || std::ranges::any_of(all, [&](const ParametrisedSet::Relation& r) {
             return divides(r.p, f).has_value();
           });
  }

  const LameFamilyForm& form_;
  const LameParameters<MFraction>& p_;
  const ParametrisedSet& region_;
  const Budget& budget_;
  Parts parts_;
};

} // namespace

Answer lame_answer_on(const LameFamilyForm& form, const ParametrisedSet& region,
                      const Budget& budget) {
  return Lame(form, region, budget).run();
}

} // namespace kov::strata
