// kovacic potential --degree K: which eigenvalues V''(c) may have for an integrable homogeneous
// potential of degree K.

#include "closed/potential.hpp"
#include "closed/number_answers.hpp"
#include "commands.hpp"
#include "decide/words.hpp"
#include "equations/recognized.hpp"
#include "output/render.hpp"
#include "systems/mechanics.hpp"

#include <sstream>

namespace kov::cli {
namespace {

// "3/2*p^2 + 1/2*p"
std::string polynomial_text(const EigenvalueFamily& f) {
  std::vector<NfElem> ascending;
  for (const Rational& c : f.polynomial())
    ascending.insert(ascending.begin(), NfElem(c));
  return to_string(Poly::from_coefficients(ascending), "p");
}

// "-1/24 + (6*p + 1)^2/24"
std::string square_text(const EigenvalueFamily& f) {
  const std::string square = "(" +
                             to_string(Poly::from_coefficients({NfElem(f.u), NfElem(f.v)}), "p") +
                             ")^2/" + to_string(abs(f.w));
  const std::string sign_text = sign(f.w) < 0 ? "-" : "";
  if (is_zero(f.c)) return sign_text + square;
  return to_string(f.c) + (sign(f.w) < 0 ? " - " : " + ") + square;
}

Json as_json(const EigenvalueTable& t) {
  const Json families = list_of(t.families, [](const EigenvalueFamily& f) {
    return Json{{"lambda", polynomial_text(f)},
                {"square", square_text(f)},
                {"p", "any integer"},
                {"reason", sentence(f.by)}};
  });
  return {
      {"format", "kovacic-potential/1"}, {"degree", t.k}, {"all", t.all}, {"families", families}};
}

std::string text_of(const EigenvalueTable& t) {
  std::ostringstream out;
  out << "homogeneous potential V of degree " << t.k
      << ", V'(c) = c, lambda an eigenvalue of V''(c)\n";
  if (t.all) {
    out << "  the identity component is abelian for every lambda: no obstruction of this kind\n";
    return out.str();
  }
  out << "  the identity component is abelian exactly for (p any integer)\n";
  for (const EigenvalueFamily& f : t.families) {
    std::string line = "lambda = " + polynomial_text(f);
    line.resize(std::max<std::size_t>(line.size() + 2, 40), ' ');
    line += "= " + square_text(f);
    line.resize(std::max<std::size_t>(line.size() + 2, 70), ' ');
    out << "    " << line << sentence(f.by) << '\n';
  }
  out << "  any other lambda: V is not integrable with meromorphic first integrals "
         "(Morales-Ramis)\n";
  return out.str();
}

NfElem eigenvalue(const PotentialArguments& a, Constants& constants) {
  const Expression e = parse_expression(*a.eigenvalue, "--eigenvalue");
  constants.gather(std::span(&e, 1));
  const Reading reading{.variable = "", .constants = &constants, .budget = {}};
  return rational_function(e, reading).num().coeff(0);
}

// One eigenvalue: the classical criterion, and the engines on the equation itself.
Report one(const Settings& settings, const PotentialArguments& a, Report report) {
  Constants constants;
  const NfElem lambda = eigenvalue(a, constants);
  Options options = settings.solver_options();
  options.want_solutions = false;
  const answer::DecidedTwice both =
      answer::decided_twice(riemann_answer(potential_exponents(a.degree, lambda)),
                            potential_equation(a.degree, lambda), options);
  const ClosedAnswer& closed = both.closed;
  const bool abelian = closed.abelian == Truth::yes;
  std::ostringstream out;
  out << "homogeneous potential of degree " << a.degree
      << ", eigenvalue lambda = " << to_string(lambda) << "\n  "
      << (abelian ? "NO OBSTRUCTION at this eigenvalue"
                  : "NON-INTEGRABLE (Morales-Ramis; meromorphic first integrals)")
      << "\n  G = " << describe(*closed.group)
      << (abelian ? ", identity component abelian" : ", identity component not abelian")
      << "\n  because   " << wrapped(closed.reason, 12) << '\n';
  report.exit = settings.exit_of(closed.abelian, true);
  report.text = out.str();
  report.json["eigenvalue"] = to_string(lambda);
  report.json["r"] = to_string(both.decision.r);
  report.json["abelian"] = abelian ? "yes" : "no";
  report.json["group"] = group_json(*closed.group);
  report.json["reason"] = closed.reason;
  report.json["engines"] = reason(both.decision);
  return report;
}

} // namespace

int potential(const Settings& settings, const PotentialArguments& a) {
  const Report report = supervised(settings, "--degree", [&] {
    const EigenvalueTable table = eigenvalue_table(a.degree);
    const Truth abelian = table.all ? Truth::yes : Truth::unknown;
    Report r{settings.exit_of(abelian, true), text_of(table), as_json(table)};
    return a.eigenvalue ? one(settings, a, std::move(r)) : r;
  });
  return written_report(settings, report);
}

} // namespace kov::cli
