#include "closed/symbolic_family.hpp"

#include "closed/coefficients.hpp"
#include "closed/kimura.hpp"
#include "closed/lame.hpp"
#include "closed/lame_family.hpp"
#include "exact/error.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "parameters/statement.hpp"

#include <algorithm>

namespace kov {
namespace {

using Polynomial = Coefficients<MFraction>;

struct Place {
  std::optional<MFraction> at; ///< unset: infinity
  long order = 0;              ///< at infinity: of the equation in 1/z
};

// A factor of the denominator that is not linear: the families below do not look at it.
class NotRational {};

std::vector<Place> places_of(const MFraction& r, std::size_t z) {
  std::vector<Place> places;
  if (!is_constant(r.den()))
    for (const MFactor& factor : factor(r.den()).second) {
      const long d = degree(factor.base, z);
      if (d == 0) continue;
      if (d > 1) throw NotRational{};
      const auto c = coefficients(factor.base, z);
      places.push_back({-MFraction(c[0], c[1]), factor.exponent});
    }
  const long o = degree(r.den(), z) - degree(r.num(), z);
  if (o < 4) places.push_back({std::nullopt, 4 - o});
  return places;
}

bool is_regular(const Place& p) { return p.order <= 2; }

class Recognizer {
public:
  // Coefficients of num(r) may vanish: exponent differences become 1, which the answers allow for.
  Recognizer(const MFraction& r, std::size_t z) : r_(r), z_(z) {
    note(r.den());
    note(coefficients(r.den(), z).back());
  }

  std::optional<SymbolicFamily> run(const Budget& budget) {
    const std::vector<Place> places = places_of(r_, z_);
    const auto regular = std::ranges::count_if(places, is_regular);
    const auto irregular = static_cast<long>(places.size()) - regular;
    note_distances(places);
    if (irregular == 0 && regular == 2) return euler(places);
    if (irregular == 0 && regular == 3) return riemann(places);
    if (irregular == 1 && regular == 0) return polynomial(moved(places, {}));
    if (irregular == 1 && regular == 1) return one_regular(places);
    (void)budget;
    return std::nullopt;
  }

  SymbolicFamily lame(const LameFamilyForm& form) const;
  /// Is x of the standard equation the variable itself?
  [[nodiscard]] bool in_place() const { return in_place_; }

private:
  void note(const MPoly& f) {
    if (is_constant(f)) return;
    for (const MFactor& factor : factor(f).second)
      if (!uses(factor.base, z_) && !is_among(factor.base, generic_))
        generic_.push_back(factor.base);
  }
  void note_distances(const std::vector<Place>& places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i].at) continue;
      note(places[i].at->den());
      for (std::size_t j = 0; j < i; ++j)
        if (places[j].at) note((*places[i].at - *places[j].at).num());
    }
  }

  // 1 + 4a, a the coefficient of t^-2 at the place.
  [[nodiscard]] MFraction delta_squared(const Place& p) const {
    const MFraction one(r_.ring(), Rational(1));
    if (p.order < 2) return one;
    const Polynomial num = in_z(r_.num(), z_);
    const Polynomial den = in_z(r_.den(), z_);
    const MFraction a =
        p.at ? shifted(num, *p.at).front() / shifted(den, *p.at)[2] : num.back() / den.back();
    return one + Rational(4) * a;
  }

  // r with its irregular place at infinity and `zero` at 0, as numerator over x^power.
  struct Moved {
    Polynomial num;
    long power = 0;
  };
  [[nodiscard]] Moved moved(const std::vector<Place>& places, const std::optional<Place>& zero);

  SymbolicFamily started(Classical family, const std::string& equation) const {
    return {family, equation, {}, {}, generic_};
  }
  SymbolicFamily euler(const std::vector<Place>& places);
  SymbolicFamily riemann(const std::vector<Place>& places) const;
  std::optional<SymbolicFamily> polynomial(const Moved& r);
  std::optional<SymbolicFamily> one_regular(const std::vector<Place>& places);

  const MFraction& r_;
  std::size_t z_;
  std::vector<MPoly> generic_;
  bool in_place_ = true;
};

// At c: z = c + 1/x, r becomes x^-4 r(c + 1/x).  The regular place then is 1/(c' - c), or 0.
Recognizer::Moved Recognizer::moved(const std::vector<Place>& places,
                                    const std::optional<Place>& zero) {
  MFraction r = r_;
  const MFraction x = MFraction::variable(r_.ring(), z_);
  const auto irregular =
      std::ranges::find_if(places, [](const Place& p) { return !is_regular(p); });
  MFraction shift(r_.ring());
  if (irregular->at) {
    r = substitute(r, {{z_, *irregular->at + pow(x, -1)}}) * pow(x, -4);
    if (zero && zero->at) shift = pow(*zero->at - *irregular->at, -1);
  } else if (zero) {
    shift = *zero->at;
  }
  in_place_ = !irregular->at && is_zero(shift);
  r = substitute(r, {{z_, x + shift}});
  const Polynomial den = in_z(r.den(), z_);
  Moved m{in_z(r.num(), z_), static_cast<long>(den.size()) - 1};
  for (MFraction& c : m.num)
    c = c / den.back();
  return m;
}

// a/sqrt(b)
std::string quotient_text(const MFraction& a, const MFraction& b) {
  if (is_zero(a)) return "0";
  if (const auto root = square_root(b)) return to_string(a / *root);
  const std::string text = to_string(a);
  const bool plain = text.find_first_of("+-*/ ") == std::string::npos;
  return (plain ? text : "(" + text + ")") + "/sqrt(" + to_string(b) + ")";
}

SymbolicFamily Recognizer::euler(const std::vector<Place>& places) {
  in_place_ = places.front().at && is_zero(*places.front().at) && !places.back().at;
  SymbolicFamily out = started(Classical::euler, "y'' = (l^2-1)/(4*x^2) y");
  out.parameters = {{"l", root_text(delta_squared(places.front()))}};
  out.cases = {{"l = 0 (T_2)", GroupType::T, Truth::yes},
               {"l is a rational number", GroupType::cyclic, Truth::yes},
               {"else", GroupType::Gm, Truth::yes}};
  return out;
}

SymbolicFamily Recognizer::riemann(const std::vector<Place>& places) const {
  SymbolicFamily out =
      started(Classical::riemann,
              "y'' = ((l^2-1)/(4*x^2) + (m^2-1)/(4*(x-1)^2) + (1-l^2-m^2+n^2)/(4*x*(x-1))) y");
  std::vector<MFraction> squares;
  for (const Place& p : places)
    squares.push_back(delta_squared(p));
  const auto rational = [](const MFraction& f) {
    return is_constant(f) ? exact_sqrt(to_rational(f)) : std::nullopt;
  };
  // The exponents that depend on parameters, or are irrational, last.
  std::stable_partition(squares.begin(), squares.end(),
                        [&](const MFraction& f) { return rational(f).has_value(); });
  static const char* const names[] = {"l", "m", "n"};
  for (std::size_t i = 0; i < 3; ++i)
    out.parameters.emplace_back(names[i], root_text(squares[i]));
  const auto l = rational(squares[0]);
  const auto m = rational(squares[1]);
  if (l && m) {
    const ThirdExponents third = abelian_third_exponents(*l, *m);
    if (third.all)
      out.cases = {{"", std::nullopt, Truth::yes}};
    else
      out.cases = {{"n is " + to_string(third.nu()), std::nullopt, Truth::yes},
                   {"else", GroupType::SL2, Truth::no}};
    return out;
  }
  out.cases = {
      {"l, m, n are rational, and some l +- m +- n is an odd integer", std::nullopt, Truth::yes},
      {"some l +- m +- n is an odd integer, one of l, m, n is a natural number N, and the "
       "sum or the difference of the others is one of N-1, N-3, ..., 1-N",
       GroupType::Gm, Truth::yes},
      {"some l +- m +- n is an odd integer", GroupType::Borel, Truth::no},
      {"two of l, m, n are in 1/2 + Z", std::nullopt, Truth::yes},
      {"l, m, n are in a row of the table of Schwarz and Kimura", std::nullopt, Truth::yes},
      {"else", GroupType::SL2, Truth::no}};
  return out;
}

std::optional<SymbolicFamily> Recognizer::polynomial(const Moved& r) {
  if (r.power != 0) return std::nullopt;
  const std::size_t degree = r.num.size() - 1;
  note(r.num.back().num());
  if (degree == 0) {
    SymbolicFamily out = started(Classical::constant, "y'' = c y");
    out.parameters = {{"c", to_string(r.num[0])}};
    out.cases = {{"", GroupType::Gm, Truth::yes}};
    return out;
  }
  in_place_ = in_place_ && is_zero(r.num[degree - 1]); // no shift
  if (degree == 1) {
    SymbolicFamily out = started(Classical::airy, "y'' = a x y");
    out.parameters = {{"a", to_string(r.num[1])}};
    out.cases = {{"", GroupType::SL2, Truth::no}};
    return out;
  }
  if (degree == 2) {
    const MFraction& u = r.num[2];
    const MFraction w = r.num[0] - r.num[1] * r.num[1] / (Rational(4) * u);
    SymbolicFamily out = started(Classical::weber, "y'' = (u x^2 + w) y, a = w/sqrt(u)");
    out.parameters = {{"a", quotient_text(w, u)}};
    out.cases = {{"a is an odd integer", GroupType::Borel, Truth::no},
                 {"else", GroupType::SL2, Truth::no}};
    return out;
  }
  SymbolicFamily out = started(Classical::polynomial, "y'' = r(x) y");
  out.cases = {{"", degree % 2 == 1 ? std::optional(GroupType::SL2) : std::nullopt, Truth::no}};
  return out;
}

// A + b/x + c/x^2.
std::optional<SymbolicFamily> Recognizer::one_regular(const std::vector<Place>& places) {
  const auto zero = std::ranges::find_if(places, is_regular);
  const Moved r = moved(places, *zero);
  if (r.power > 2 || r.num.size() > 3) return std::nullopt;
  Polynomial n = r.num; // times x^(2 - power)
  n.insert(n.begin(), static_cast<std::size_t>(2 - r.power), MFraction(r_.ring()));
  if (n.size() > 3) return std::nullopt;
  n.resize(3, MFraction(r_.ring()));
  const MFraction m2 = n[0] + MFraction(r_.ring(), Rational(1, 4));
  const FamilyCase other{"else", GroupType::SL2, Truth::no};
  if (is_zero(n[2])) {
    note(n[1].num());
    SymbolicFamily out =
        started(Classical::bessel,
                "y'' = (b/x + (m^2-1)/(4*x^2)) y, Bessel's equation of order m in sqrt(x)");
    out.parameters = {{"m", root_text(Rational(4) * m2)}};
    out.cases = {{"m is in 1/2 + Z", GroupType::Dinf, Truth::yes}, other};
    return out;
  }
  note(n[2].num());
  if (is_zero(n[1])) {
    SymbolicFamily out = started(Classical::bessel, "y'' = (a + (m^2-1/4)/x^2) y");
    out.parameters = {{"m", root_text(m2)}, {"a", to_string(n[2])}};
    out.cases = {{"m is in 1/2 + Z", GroupType::Gm, Truth::yes}, other};
    return out;
  }
  SymbolicFamily out =
      started(Classical::whittaker, "y'' = (a + b/x + (m^2-1/4)/x^2) y, k = -b/(2*sqrt(a))");
  out.parameters = {{"k", quotient_text(-n[1], Rational(4) * n[2])}, {"m", root_text(m2)}};
  out.cases = {{"k + m - 1/2 and k - m - 1/2 are integers, one of them >= 0 and one < 0",
                GroupType::Gm, Truth::yes},
               {"some k +- m is half of an odd integer", GroupType::Borel, Truth::no},
               other};
  return out;
}

SymbolicFamily Recognizer::lame(const LameFamilyForm& form) const {
  SymbolicFamily out = started(Classical::lame, "y_tt = (n(n+1) wp(t; g2, g3) + B) y, x = wp(t)");
  out.generic = form.generic;
  const MFraction one(r_.ring(), Rational(1));
  const MFraction square = Rational(4) * form.alpha + one;
  const auto& p = form.parameters;
  out.parameters = {{"2*n+1", root_text(square)},
                    {"B", to_string(p.b)},
                    {"g2", to_string(p.g2)},
                    {"g3", to_string(p.g3)}};
  const MFraction disc = p.g2 * p.g2 * p.g2 - Rational(27) * (p.g3 * p.g3);
  if (!is_constant(disc)) out.generic.push_back(disc.num());
  out.cases = {{"n is an integer", std::nullopt, Truth::yes},
               {"n is half of an odd integer and Brioschi's determinant Q_m(B, g2, g3) = 0, "
                "m = |n + 1/2|",
                GroupType::D, Truth::yes},
               {"n + 1/2 is a third, a quarter or a fifth of an integer and the group is finite "
                "(kovacic lame shows the conditions)",
                std::nullopt, Truth::yes},
               {"else", GroupType::SL2, Truth::no}};
  return out;
}

// The letters of the family apart from the names that the equation uses.  A letter whose value is
// the name itself means the same on both sides.
SymbolicFamily with_names(SymbolicFamily f, FreshLetters letters) {
  for (const auto& [name, value] : f.parameters)
    if (name == value) letters.keep(name);
  f.equation = letters.in(f.equation);
  for (auto& [name, value] : f.parameters)
    name = letters.in(name);
  for (FamilyCase& c : f.cases)
    c.when = letters.in(c.when);
  return f;
}

} // namespace

std::string root_text(const MFraction& a) {
  const auto root = square_root(a);
  return root ? to_string(*root) : "sqrt(" + to_string(a) + ")";
}

Truth SymbolicFamily::abelian() const {
  Truth all = cases.empty() ? Truth::unknown : cases.front().abelian;
  for (const FamilyCase& c : cases)
    if (c.abelian != all) all = Truth::unknown;
  return all;
}

std::string SymbolicFamily::summary() const {
  if (abelian() == Truth::yes) return "the identity component is always abelian";
  if (abelian() == Truth::no) return "the identity component is never abelian";
  std::string s;
  for (const FamilyCase& c : cases) {
    if (c.when.empty() || (&c != &cases.back() && c.abelian == cases.back().abelian)) continue;
    const std::string is = c.abelian == Truth::yes ? "abelian" : "not abelian";
    s += (s.empty() ? "the identity component is " : ", ") + is +
         (c.when == "else" ? " otherwise" : " where " + c.when);
  }
  return s;
}

std::optional<SymbolicFamily> symbolic_family(const MFraction& r, std::size_t z,
                                              const Budget& budget) {
  if (is_zero(r)) return std::nullopt;
  constexpr long largest = 18;
  if (degree(r.num(), z) > largest || degree(r.den(), z) > largest) return std::nullopt;
  budget.check();
  Recognizer recognizer(r, z);
  FreshLetters letters(r.ring());
  if (const auto form = recognize_lame(r, z, budget)) {
    if (form->change.empty()) letters.keep("x");
    SymbolicFamily lame = with_names(recognizer.lame(*form), letters);
    if (!form->change.empty()) lame.equation += ", " + form->change;
    return lame;
  }
  try {
    auto found = recognizer.run(budget);
    if (recognizer.in_place() && r.ring()->name(z) == "x") letters.keep("x");
    if (found) found = with_names(*std::move(found), letters);
    return found;
  } catch (const NotRational&) {
    return std::nullopt;
  }
}

} // namespace kov
