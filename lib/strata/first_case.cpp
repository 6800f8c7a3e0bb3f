#include "strata/first_case.hpp"
#include "exact/joined.hpp"

#include <algorithm>
#include <map>

namespace kov::strata {
namespace {

constexpr std::size_t most_places = 12;

// The possible contributions of a place: alpha at a finite place; at infinity 1 - alpha, so that the degree
// is that minus the sum of the others.
using Exponents = std::vector<Rational>;

std::optional<Exponents> choices(const ParametricPlace& p) {
  const Rational half(1, 2);
  switch (p.kind) {
  case PlaceKind::ordinary:
    return Exponents{Rational(0), Rational(1)};
  case PlaceKind::simple:
    return Exponents{Rational(p.at_infinity ? 0 : 1)};
  case PlaceKind::regular:
    if (p.exponent != ExponentKind::rational) return std::nullopt;
    if (is_zero(p.delta)) return Exponents{half};
    return Exponents{half * (Rational(1) + p.delta), half * (Rational(1) - p.delta)};
  default:
    return std::nullopt;
  }
}

std::string listed_choices(const Exponents& all) {
  return joined(all, [&](const auto& x) { return to_string(x); });
}

Rational exponent(const ParametricPlace& p, const Rational& choice) {
  return p.at_infinity ? Rational(1) - choice : choice;
}

class FirstCase {
public:
  FirstCase(const Scheme& s, const ParametrisedSet& region, const Budget& budget)
      : s_(s), region_(region), budget_(budget) {
    for (const auto& p : s.finite)
      places_.push_back(&p);
    places_.push_back(&s.infinity);
  }

  kovacic::Trace run() {
    const bool finite =
        std::ranges::all_of(places_, [this](const ParametricPlace* p) { return exponents(*p); });
    if (!finite)
      say(2, "the families are not a finite list of numbers");
    else if (places_.size() > most_places)
      say(2, "more than " + std::to_string(most_places) +
                 " places: the families are not listed_choices");
    else
      families();
    return std::move(steps_);
  }

private:
  void say(int number, const std::string& text) { steps_.push_back({1, number, text}); }

  bool exponents(const ParametricPlace& p) {
    const std::string at = place_name(p, s_.z) + ": ";
    const auto all = choices(p);
    Exponents shown = all.value_or(Exponents{});
    for (auto& x : shown)
      x = exponent(p, x);
    if (p.kind == PlaceKind::regular) {
      const std::string log = p.log == Truth::yes ? ", a logarithm" : "";
      say(1, at + square_text(p) + (all ? ", exponents " + listed_choices(shown) : "") + log);
    } else {
      say(1, at + (all ? "exponents " + listed_choices(shown)
                       : "irregular, order " + std::to_string(p.order)));
    }
    if (all) choices_.push_back(*all);
    return all.has_value();
  }

  // Every combination, by odometer.
  void families() {
    std::vector<std::size_t> pick(places_.size(), 0);
    std::size_t listed_families = 0;
    say(2, "d = 1 - (exponent at infinity) - (sum of the others) has to be a natural number");
    for (bool more = true; more;) {
      budget_.check();
      Rational d = choices_.back()[pick.back()];
      for (std::size_t i = 0; i + 1 < places_.size(); ++i)
        d -= Rational(places_[i]->degree(s_.z)) * choices_[i][pick[i]];
      if (is_integer(d) && sign(d) >= 0) {
        ++listed_families;
        family(pick, d);
      }
      more = false;
      for (std::size_t i = 0; i < pick.size() && !more; ++i) {
        pick[i] = (pick[i] + 1) % choices_[i].size();
        more = pick[i] != 0;
      }
    }
    if (listed_families == 0) say(2, "no choice of exponents gives one");
  }

  void family(const std::vector<std::size_t>& pick, const Rational& d) {
    std::string text = "d = " + to_string(d) + ":";
    for (std::size_t i = 0; i < places_.size(); ++i)
      text += (i == 0 ? " " : ", ") + to_string(exponent(*places_[i], choices_[i][pick[i]])) +
              " at " + place_name(*places_[i], s_.z);
    say(2, text);
    say(3, is_zero(d) ? degree_zero(pick)
                      : "d = " + to_string(d) + ": a polynomial of this degree is sought");
  }

  // P = 1: r = omega' + omega^2 with omega = sum alpha q'/q, coefficient by coefficient.
  [[nodiscard]] std::string degree_zero(const std::vector<std::size_t>& pick) const {
    MFraction omega(s_.r.ring());
    for (std::size_t i = 0; i + 1 < places_.size(); ++i)
      omega += choices_[i][pick[i]] *
               (MFraction(derivative(places_[i]->q, s_.z)) / MFraction(places_[i]->q));
    const MFraction left = derivative(omega, s_.z) + omega * omega - s_.r;
    if (is_zero(left)) return "d = 0: r = omega' + omega^2 holds, omega = " + brief(omega, 120);
    std::optional<MPoly> simplest;
    for (const auto& c : coefficients(left.num(), s_.z)) {
      if (is_zero(c)) continue;
      if (region_.provably_nonzero(c))
        return "d = 0: r = omega' + omega^2 needs " + to_factored_string(MFraction(c)) +
               " = 0, which does not happen here";
      if (!simplest || c.length() < simplest->length()) simplest = c;
    }
    return "d = 0: r = omega' + omega^2 needs " + to_factored_string(MFraction(*simplest)) +
           " = 0, among others";
  }

  const Scheme& s_;
  const ParametrisedSet& region_;
  const Budget& budget_;
  std::vector<const ParametricPlace*> places_; // infinity last
  std::vector<Exponents> choices_;
  kovacic::Trace steps_;
};

} // namespace

kovacic::Trace first_case(const Scheme& s, const ParametrisedSet& region, const Budget& budget) {
  return FirstCase(s, region, budget).run();
}

} // namespace kov::strata
