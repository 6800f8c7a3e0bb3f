// kovacic lame: when is the identity component of Lame's equation abelian?

#include "decide/words.hpp"
#include "equations/lame_question.hpp"
#include "equations/recognized.hpp"
#include "exact/joined.hpp"
#include "output/render.hpp"
#include "symbol/suggest.hpp"
#include "systems/mechanics.hpp"

#include <set>
#include <sstream>

namespace kov::cli {
namespace {

constexpr const char* equation_of_lame = "Lame's equation y_tt = (n(n+1) wp(t; g2, g3) + B) y, ";

// A thousand coefficients do not belong on a terminal.
std::string all_zero(const std::vector<MPoly>& polynomials) {
  std::string s = joined(
      polynomials, [&](const MPoly& f) { return to_string(f) + " = 0"; }, " and ");
  if (s.size() <= 1200) return s;
  const std::string count = polynomials.size() == 1
                                ? "a polynomial is 0"
                                : std::to_string(polynomials.size()) + " polynomials are 0";
  return count + " (too long for a terminal, whole with --format json)";
}

Json opened(const LameQuestion& q) {
  Json j = {{"format", "kovacic-lame/1"}, {"degree", q.degree.text}, {"n", nullptr}};
  if (q.degree.alpha)
    if (const auto index = lame_index(*q.degree.alpha); index.n) j["n"] = to_string(*index.n);
  std::visit(
      [&](const auto& p) {
        j["B"] = to_string(p.b);
        j["g2"] = to_string(p.g2);
        j["g3"] = to_string(p.g3);
      },
      q.parameters);
  j["free"] = q.free;
  return j;
}

std::string title(const LameQuestion& q, const Json& j) {
  std::string text = equation_of_lame + q.degree.text;
  std::vector<std::string> open;
  for (const char* name : {"B", "g2", "g3"}) {
    const std::string value = j.at(name).get<std::string>();
    if (value == name)
      open.emplace_back(name);
    else
      text += std::string(", ") + name + " = " + value;
  }
  if (!open.empty()) text += "; " + enumerate(open) + " free";
  return wrapped(text, 0) + "\n";
}

// --- numbers: the classical criterion, and the engines on the equation
// -----------------------------------

Report numbers(const Settings& settings, const LameQuestion& q) {
  const auto& p = std::get<LameParameters<NfElem>>(q.parameters);
  Options options = settings.solver_options();
  options.variable = "x";
  options.want_solutions = false;
  const answer::DecidedTwice both = answer::decided_twice(
      lame_answer(*q.degree.alpha, p, options.budget), lame_equation(*q.degree.alpha, p), options);
  const Decision& d = both.decision;
  const auto group = both.group();
  const Truth abelian = both.abelian();
  Json j = opened(q);
  j["r"] = to_string(d.r, "x");
  j["abelian"] = word_of(abelian);
  j["group"] = group ? group_json(*group) : Json(nullptr);
  j["closed_answer"] = closed_json(both.closed);
  j["reason"] = reason(d);
  std::ostringstream out;
  out << title(q, j);
  if (!q.constants.empty()) put(out, "where", q.constants);
  out << "  G = " << (group ? describe(*group) : "?") << ", identity component "
      << (abelian == Truth::yes  ? "abelian"
          : abelian == Truth::no ? "not abelian"
                                 : "undecided")
      << '\n';
  put(out, "closed", both.closed.reason);
  put(out, "engines", reason(d));
  put(out, "algebraic", "y'' = r y in x = wp(t), r = " + to_string(d.r, "x"));
  const bool decided = group && abelian != Truth::unknown;
  return {settings.exit_of(abelian, decided), out.str(), j};
}

// --- free names: a condition
// -----------------------------------------------------------------------

// Our letters beside the free names.
FreshLetters letters_beside(const LameQuestion& q) {
  return FreshLetters(std::set<std::string>(q.free.begin(), q.free.end()));
}

std::string degenerate_text(const ThirdExponents& third, const FreshLetters& letter) {
  return third.all ? "always" : "exactly when " + letter("l") + " is " + to_string(third.nu());
}

std::string cusp_text(const LameIndex& index) {
  return std::string("where g2 = g3 = 0, y_tt = (n(n+1)/t^2 + B) y: abelian ") +
         (index.kind == LameCase::hermite ? "always" : "exactly when B = 0");
}

// On the curve g2^3 = 27 g3^2: Riemann's equation.
Report degenerate(const Settings& settings, const LameQuestion& q,
                  const LameParameters<MFraction>& p) {
  Json j = opened(q);
  std::ostringstream out;
  out << title(q, j);
  const LameIndex index = lame_index(*q.degree.alpha);
  put(out, "curve", "g2^3 = 27 g3^2: the curve is degenerate");
  if (is_zero(p.g3)) {
    const bool integer = index.kind == LameCase::hermite;
    put(out, "abelian",
        integer ? "always: Bessel's equation y_tt = (n(n+1)/t^2 + B) y, n an integer"
                : "exactly when " + to_string(p.b.num()) + " = 0: y_tt = (n(n+1)/t^2 + B) y");
    j["condition"] = {
        {"abelian", integer ? "always" : "all-zero"},
        {"polynomials", integer ? Json::array() : Json::array({to_string(p.b.num())})}};
    return {settings.exit_of(integer ? Truth::yes : Truth::unknown, true), out.str(), j};
  }
  const MFraction alpha(p.g3.ring(),
                        is_rational(*q.degree.alpha) ? to_rational(*q.degree.alpha) : Rational(0));
  if (!is_rational(*q.degree.alpha)) {
    put(out, "open", "an irrational n beside free names on a degenerate curve");
    j["condition"] = nullptr;
    return {settings.exit_of(Truth::unknown, false), out.str(), j};
  }
  const MFraction l2 = degenerate_exponent_squared(alpha, p);
  const ThirdExponents third = degenerate_exponents(index);
  const FreshLetters letter = letters_beside(q);
  const bool number = is_zero(l2) || is_constant(l2);
  const std::string where = ", where " + letter("l") + "^2 = " + to_string(l2);
  const Json classes = list_of(third.classes, [](const ExponentClass& c) {
    return Json{{"l", to_string(c.nu)}, {"reason", sentence(c.by)}};
  });
  j["condition"] = {{"abelian", "exponent"}, {"l_squared", to_string(l2)}, {"l", classes}};
  Truth abelian = third.all ? Truth::yes : Truth::unknown; // for all values at once
  if (number && !third.all) {
    const bool yes = contains_root(third, is_zero(l2) ? Rational(0) : to_rational(l2));
    j["condition"]["abelian"] = yes ? "always" : "never";
    abelian = yes ? Truth::yes : Truth::no;
    put(out, "abelian",
        (yes ? "always: " : "never: ") + letter("l") + (yes ? " is " : " is not ") +
            to_string(third.nu()) + where);
  } else {
    put(out, "abelian", degenerate_text(third, letter) + where);
  }
  const MFraction cusp = is_zero(p.g2) ? p.g3 : p.g2; // g2 = 0 and g3 = 0 say the same here
  if (!is_constant(cusp)) {
    if (index.kind != LameCase::hermite || abelian != Truth::yes) abelian = Truth::unknown;
    j["condition"]["assuming"] = Json::array({to_string(cusp.num()) + " != 0"});
    j["condition"]["cusp"] = cusp_text(index);
    put(out, "assuming", "g2 != 0: " + to_string(cusp.num()) + " != 0");
    put(out, "else", cusp_text(index));
  }
  return {settings.exit_of(abelian, true), out.str(), j};
}

// Which group where the identity component is abelian.
std::string group_text(const LameConditions& c) {
  const std::string elsewhere = c.always() ? "" : " there; SL(2, C) elsewhere";
  switch (c.index.kind) {
  case LameCase::hermite:
    return "T_4 where " +
           (c.reducible ? all_zero({*c.reducible})
                        : "Lame's polynomial w^2, of degree " +
                              to_string(Rational(2) * *c.index.n + Rational(1)) +
                              " in B, is 0 (not written out)") +
           ", elsewhere irreducible and dihedral, finite or infinite";
  case LameCase::brioschi:
    return "D_2, the quaternion group" + elsewhere;
  default:
    break;
  }
  if (c.abelian == c.octahedral) return "binary octahedral" + elsewhere;
  const bool impossible = std::ranges::any_of(
      c.octahedral, [](const MPoly& f) { return is_constant(f) && !is_zero(f); });
  if (impossible) return "binary icosahedral" + elsewhere;
  return "binary octahedral where " + all_zero(c.octahedral) + ", binary icosahedral elsewhere" +
         (c.always() ? "" : " on it; SL(2, C) elsewhere");
}

void put_condition(std::ostringstream& out, const LameConditions& c) {
  if (c.never()) return put(out, "abelian", "never: G = SL(2, C)");
  put(out, "abelian", c.always() ? "always" : "exactly when " + all_zero(c.abelian));
  put(out, "group", group_text(c));
}

Report condition(const Settings& settings, const LameQuestion& q) {
  const auto& p = std::get<LameParameters<MFraction>>(q.parameters);
  const LameIndex index = lame_index(*q.degree.alpha);
  const LameConditions c = lame_conditions(index, p, settings.solver_options().budget);
  if (is_zero(c.discriminant)) return degenerate(settings, q, p);
  Json j = opened(q);
  j["condition"] = {{"abelian", c.always()  ? "always"
                                : c.never() ? "never"
                                            : "all-zero"},
                    {"polynomials", c.never() ? Json::array() : texts(c.abelian)},
                    {"octahedral", texts(c.octahedral)},
                    {"reducible", c.reducible ? Json(to_string(*c.reducible)) : Json(nullptr)},
                    {"assuming", Json::array()}};
  std::ostringstream out;
  out << title(q, j);
  put_condition(out, c);
  if (!is_constant(c.discriminant)) {
    j["condition"]["assuming"].push_back(to_string(c.discriminant) + " != 0");
    put(out, "assuming", to_string(c.discriminant) + " != 0 (the curve is not degenerate)");
    const FreshLetters letter = letters_beside(q);
    const std::string when = letter("l") + "^2 = n(n+1)/3 - 2*B*g2/(9*g3): abelian " +
                             degenerate_text(degenerate_exponents(index), letter) + "; " +
                             cusp_text(index);
    j["degenerate"] = when;
    put(out, "else",
        "Riemann's equation with exponent differences " + letter("l") + ", 1/2, n + 1/2, where " +
            when);
  }
  const bool everywhere = is_constant(c.discriminant);
  const Truth abelian = everywhere && c.always()  ? Truth::yes
                        : everywhere && c.never() ? Truth::no
                                                  : Truth::unknown;
  return {settings.exit_of(abelian, true), out.str(), j};
}

// B, g2, g3 in the ring of n(n+1); unset where they are not rational there.
std::optional<LameParameters<MFraction>> parameters_beside(const LameQuestion& q) {
  const Ring& ring = q.degree.symbolic.ring();
  if (const auto* free = std::get_if<LameParameters<MFraction>>(&q.parameters))
    return free->b.ring() == ring ? std::optional(*free) : std::nullopt;
  const auto& p = std::get<LameParameters<NfElem>>(q.parameters);
  if (!is_rational(p.b) || !is_rational(p.g2) || !is_rational(p.g3)) return std::nullopt;
  const auto in = [&](const NfElem& c) { return MFraction(ring, to_rational(c)); };
  return LameParameters<MFraction>{in(p.b), in(p.g2), in(p.g3)};
}

template <class T> T curve_discriminant(const LameParameters<T>& p) {
  return p.g2 * p.g2 * p.g2 - Rational(27) * (p.g3 * p.g3);
}

bool curve_may_degenerate(const LameParameters<NfElem>&) { return false; } // it is not 0
bool curve_may_degenerate(const LameParameters<MFraction>& p) {
  return !is_constant(curve_discriminant(p).num());
}

constexpr const char* cusp_for_all_n =
    "y_tt = (n(n+1)/t^2 + B) y: abelian where B = 0, and elsewhere exactly when n is an integer";
constexpr const char* half_integer_is_abelian =
    "abelian where l is in 1/2 + Z (two of them are); for other l it depends on n, which needs a "
    "value";

// The same on the curve g2^3 = 27 g3^2: Riemann's equation, differences l, 1/2, n + 1/2, or Bessel's.
Report degenerate_families(const Settings& settings, const LameQuestion& q) {
  Json j = opened(q);
  std::ostringstream out;
  out << title(q, j);
  const FreshLetters letter = letters_beside(q);
  const auto p = parameters_beside(q);
  const bool cusp = std::visit([](const auto& x) { return is_zero(x.g3); }, q.parameters);
  put(out, "curve", "g2^3 = 27 g3^2: the curve is degenerate");
  const auto answered = [&](bool always, const std::string& why) {
    put(out, always ? "abelian" : "open", (always ? "always: " : "") + why);
    j["condition"] = {{"abelian", always ? "always" : "undecided"}, {"reason", why}};
    return Report{settings.exit_of(always ? Truth::yes : Truth::unknown, always), out.str(), j};
  };
  if (cusp) {
    const bool no_b = std::visit([](const auto& x) { return is_zero(x.b); }, q.parameters);
    return answered(no_b, no_b ? "Euler's equation y_tt = n(n+1)/t^2 y, with powers of t"
                               : cusp_for_all_n);
  }
  const std::string differences = "Riemann's equation with exponent differences " + letter("l") +
                                  ", 1/2, n + 1/2, " + letter("l") + "^2 = ";
  if (!p)
    return answered(false, differences +
                               "n(n+1)/3 - 2*B*g2/(9*g3): " + letter.in(half_integer_is_abelian));
  const MFraction l2 = degenerate_exponent_squared(q.degree.symbolic, *p);
  const bool number = is_zero(l2) || is_constant(l2);
  const auto l = number && !is_zero(l2) ? exact_sqrt(to_rational(l2)) : std::nullopt;
  const bool half = l && l->den() == Integer(2);
  const MFraction other = is_zero(p->g2) ? p->g3 : p->g2;
  if (half && is_constant(other))
    return answered(true, differences + to_string(l2) + ", two of them in 1/2 + Z");
  const std::string elsewhere =
      is_constant(other) ? "" : "; where " + to_string(other.num()) + " = 0: " + cusp_for_all_n;
  return answered(false, differences + to_string(l2) + ": " + letter.in(half_integer_is_abelian) +
                             elsewhere);
}

// n(n+1) with free names: the values that leave a chance.
Report families(const Settings& settings, const LameQuestion& q) {
  const bool degenerate_curve =
      std::visit([](const auto& p) { return is_zero(curve_discriminant(p)); }, q.parameters);
  if (degenerate_curve) return degenerate_families(settings, q);
  Json j = opened(q);
  std::ostringstream out;
  out << title(q, j);
  const MFraction square =
      Rational(4) * q.degree.symbolic + MFraction(q.degree.symbolic.ring(), Rational(1));
  const std::string d = to_factored_string(square);
  const bool may_degenerate =
      std::visit([](const auto& p) { return curve_may_degenerate(p); }, q.parameters);
  put(out, "abelian",
      std::string(may_degenerate ? "where g2^3 != 27 g3^2, " : "") + "only if (2n+1)^2 = " + d +
          " is the square of a rational number: one of");
  Json list = Json::array();
  for (const LameFamily& f : lame_families()) {
    const std::string value =
        f.denominator == 1 && f.numerator == 1
            ? "j^2"
            : "(" + (f.numerator == 1 ? "j" : std::to_string(f.numerator) + "*j") + "/" +
                  std::to_string(f.denominator) + ")^2";
    put(out, "", value + ", " + f.which);
    list.push_back({{"value", value}, {"condition", f.which}});
  }
  std::vector<std::string> names;
  for (const std::size_t i : used_variables(square))
    names.push_back(square.ring()->name(i));
  put(out, "open",
      "which of these happen depends on " + enumerate(names) +
          "; everything else: G = SL(2, C), for every B, g2, g3 with g2^3 != 27 g3^2");
  j["condition"] = {
      {"abelian", "only-if"}, {"square", d}, {"families", list}, {"assuming", Json::array()}};
  if (const auto* p = std::get_if<LameParameters<MFraction>>(&q.parameters))
    if (const MFraction curve = curve_discriminant(*p); !is_constant(curve.num())) {
      const FreshLetters letter = letters_beside(q);
      const std::string when =
          "where " + to_string(curve.num()) +
          " = 0, Riemann's equation with exponent differences " + letter("l") + ", 1/2, n + 1/2, " +
          letter("l") + "^2 = n(n+1)/3 - 2*B*g2/(9*g3): " + letter.in(half_integer_is_abelian) +
          "; where g2 = g3 = 0, " + cusp_for_all_n;
      j["condition"]["assuming"].push_back(to_string(curve.num()) + " != 0");
      j["degenerate"] = when;
      put(out, "assuming", to_string(curve.num()) + " != 0 (the curve is not degenerate)");
      put(out, "else", when);
    }
  return {settings.exit_of(Truth::unknown, false), out.str(), j};
}

} // namespace

int lame(const Settings& settings, const LameArguments& a) {
  std::optional<Entry> document;
  if (!a.file.empty()) {
    if (a.n || a.alpha || a.b || a.g2 || a.g3) {
      complain(settings, "both a file and values are given", "see: kovacic lame --help");
      return exit_input;
    }
    document = read_document(a.file);
  } else if (!a.n && !a.alpha && !a.b && !a.g2 && !a.g3) {
    complain(settings, "nothing is given",
             "write e.g. kovacic lame -n 3/2 --B 3 --g2 12 --g3 1   or   kovacic lame -n 3/2");
    return exit_input;
  }
  const Report report = supervised(settings, a.file.empty() ? "lame" : a.file, [&] {
    const LameQuestion q =
        read_lame(document ? lame_texts(settings, *document) : lame_texts(settings, a));
    if (!q.degree.alpha) return families(settings, q);
    return std::holds_alternative<LameParameters<NfElem>>(q.parameters) ? numbers(settings, q)
                                                                        : condition(settings, q);
  });
  return written_report(settings, report);
}

} // namespace kov::cli
