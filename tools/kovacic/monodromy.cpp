// kovacic monodromy: matrices with proven radii, and what they prove.

#include "monodromy/monodromy.hpp"
#include "commands.hpp"
#include "equation/read_equation.hpp"
#include "mechanics.hpp"
#include "monodromy/decimal.hpp"
#include "monodromy/words.hpp"
#include "render.hpp"
#include "symbol/rational_form.hpp"

#include <chrono>
#include <sstream>

namespace kov::cli {
namespace {

namespace mo = kov::monodromy;

constexpr long most_digits = 100000;

std::optional<Expression> formula(const std::string& option, const std::optional<std::string>& text,
                                  bool equation = false) {
  if (!text) return std::nullopt;
  return parse_expression(*text, option, equation);
}

GivenEquation given(const Settings& settings, const MonodromyArguments& a) {
  EquationText text;
  text.r = formula("-r", a.r);
  text.ode = formula("-e", a.ode, true);
  text.p = formula("--p", a.p);
  text.q = formula("--q", a.q);
  text.minpoly = formula("--minpoly", a.minpoly);
  text.variable = a.variable;
  text.set = settings.settings();
  return read_equation(text, settings.solver_options().budget);
}

// A base point: a Gaussian number whose denominators are powers of two.
mo::Point read_base(const std::string& text) {
  const Expression e = parse_expression(text, "--base");
  Constants constants;
  constants.gather(std::span(&e, 1));
  const RationalFunction f =
      rational_function(e, Reading{.variable = "", .constants = &constants, .budget = {}});
  const ComplexBall z = embed(f.num().coeff(0), mo::plan_bits);
  if (acb_is_exact(z.raw()) == 0)
    throw e.error("a base point is x + y*I, with denominators that are powers of two",
                  "write e.g. --base '3/4 - 2*I'");
  return mo::point(z);
}

Json json_of(const mo::BallMatrix& m, long digits) {
  Json rows = Json::array();
  for (long i = 0; i < m.size(); ++i) {
    Json row = Json::array();
    for (long j = 0; j < m.size(); ++j) {
      const auto [re, im] = mo::decimals(m.entry(i, j), digits);
      row.push_back({re, im});
    }
    rows.push_back(row);
  }
  return rows;
}

Json json_of(const mo::Monodromy& m, long digits, const std::string& variable) {
  Json loops = Json::array();
  for (const mo::LoopMatrix& l : m.loops)
    loops.push_back({{"place", mo::to_string(l.place, variable)},
                     {"matrix", json_of(l.matrix, digits)},
                     {"radius", mo::decimal_radius(l.matrix, digits)}});
  Json j{{"format", "kovacic-monodromy/1"},
         {"base", mo::exact_decimals(m.base)},
         {"basis", "Y(base) = 1, rows (y, y'); continued along a loop Y becomes Y M"},
         {"loops", loops},
         {"digits", digits}};
  if (m.large_circle)
    j["large_circle"] = {{"matrix", json_of(*m.large_circle, digits)},
                         {"radius", mo::decimal_radius(*m.large_circle, digits)}};
  j["self_tests"] = m.self_tests;
  return j;
}

std::string ball_text(const ComplexBall& z) {
  char* re = arb_get_str(acb_realref(z.raw()), 10, 0);
  char* im = arb_get_str(acb_imagref(z.raw()), 10, 0);
  const std::string text = std::string(re) + " + " + im + "*I";
  flint_free(re);
  flint_free(im);
  return text;
}

Json json_of(const mo::Sl2Proof& p) {
  return {{"proves", "SL2"},
          {"A", p.a},
          {"B", p.b},
          {"trace_A", ball_text(p.trace_a)},
          {"trace_commutator", ball_text(p.trace_commutator)},
          {"trace_ABAB^-1", ball_text(p.trace_normalizer)}};
}

std::string entry_text(const Json& entry, long shown) {
  const auto cut = [&](std::string s) {
    const auto dot = s.find('.');
    if (dot != std::string::npos && s.size() > dot + 1 + static_cast<std::size_t>(shown))
      s.resize(dot + 1 + static_cast<std::size_t>(shown));
    return s;
  };
  const std::string im = cut(entry[1]);
  const bool negative = im.front() == '-';
  return cut(entry[0]) + (negative ? " - " + im.substr(1) : " + " + im) + "*I";
}

std::string text_of(const Json& j) {
  std::ostringstream out;
  const long shown = std::min(20L, j.at("digits").get<long>());
  out << "base " << entry_text(j.at("base"), 20) << "; " << j.at("basis").get<std::string>()
      << '\n';
  for (const Json& l : j.at("loops")) {
    out << "  around " << l.at("place").get<std::string>() << ", counterclockwise   (radius "
        << l.at("radius").get<std::string>() << ")\n";
    for (const Json& row : l.at("matrix")) {
      out << "   ";
      for (const Json& entry : row)
        out << "  " << entry_text(entry, shown);
      out << '\n';
    }
  }
  if (j.at("loops").empty()) out << "  no finite singularity: every loop gives the identity\n";
  for (const Json& t : j.at("self_tests"))
    out << "  tested    " << t.get<std::string>() << '\n';
  if (j.contains("certificate") && !j.at("certificate").is_null())
    out << "  proved    the group of the normal form y'' = r y is SL(2, C): words A, B in the "
           "loops "
           "with\n            tr A = "
        << j.at("certificate").at("trace_A").get<std::string>() << "\n            tr [A, B] = "
        << j.at("certificate").at("trace_commutator").get<std::string>()
        << "\n            tr A B A B^-1 = "
        << j.at("certificate").at("trace_ABAB^-1").get<std::string>() << '\n';
  return out.str();
}

Report matrices(const Settings& settings, const MonodromyArguments& a) {
  const auto start = std::chrono::steady_clock::now();
  const GivenEquation e = given(settings, a);
  mo::Request request;
  request.digits = a.digits;
  request.budget = settings.solver_options().budget;
  if (a.base) request.base = read_base(*a.base);
  const mo::Monodromy m = mo::monodromy(e.p, e.q, request);
  Json j = json_of(m, a.digits, e.variable);
  const auto proof = mo::prove_sl2(m, request.budget);
  j["certificate"] = proof ? json_of(*proof) : Json(nullptr);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  j["seconds"] = seconds.count();
  return {exit_decided, text_of(j), j};
}

} // namespace

int monodromy(const Settings& settings, const MonodromyArguments& a) {
  if (!a.r && !a.ode && !a.p && !a.q) {
    complain(settings, "no equation is given", "write e.g. kovacic monodromy -r '-3/16/z^2 + 1/z'");
    return exit_input;
  }
  if (a.digits < 1 || a.digits > most_digits) {
    complain(settings, "--digits: 1 to " + std::to_string(most_digits) + " are expected");
    return exit_input;
  }
  const Report report = supervised(settings, "monodromy", [&] { return matrices(settings, a); });
  write_output(settings, settings.format == "json" && !report.json.is_null()
                             ? report.json.dump(2) + "\n"
                             : report.text);
  return report.exit;
}

} // namespace kov::cli
