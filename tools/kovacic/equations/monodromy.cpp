// kovacic monodromy: matrices with proven radii, and what they prove.

#include "monodromy/monodromy.hpp"
#include "commands.hpp"
#include "equation/read_equation.hpp"
#include "exact/factor.hpp"
#include "exact/joined.hpp"
#include "integrability/loops_certificate.hpp"
#include "integrability/variational_monodromy.hpp"
#include "monodromy/decimal.hpp"
#include "monodromy/elliptic_time.hpp"
#include "monodromy/stokes.hpp"
#include "monodromy/words.hpp"
#include "output/render.hpp"
#include "proofs/certificate_file.hpp"
#include "report/loops_picture.hpp"
#include "study/study.hpp"
#include "symbol/rational_form.hpp"
#include "systems/mechanics.hpp"

#include <chrono>
#include <set>
#include <sstream>

namespace kov::cli {
namespace {

namespace mo = kov::monodromy;

constexpr long most_digits = 100000;

// How it was read goes into the answer.
GivenEquation given(const Settings& settings, const MonodromyArguments& a, Json& reading) {
  EquationText text;
  text.variable = a.variable;
  text.unknown = a.unknown;
  text.set = settings.settings();
  const AskedEquation pasted =
      asked_equation({a.r, a.ode, a.p, a.q, a.minpoly}, std::move(text), Door::options);
  reading = reading_json(pasted);
  return read_equation(pasted.text, settings.solver_options().budget);
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

Json as_json(const mo::BallMatrix& m, long digits) {
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

// Of all places, with so many digits that no two look alike.
std::vector<std::string> place_names(const mo::Monodromy& m, const std::string& variable) {
  for (long digits = 10;; digits *= 2) {
    auto names = mapped<std::string>(
        m.loops, [&](const mo::LoopMatrix& l) { return mo::to_string(l.place, variable, digits); });
    if (digits > most_digits || std::set(names.begin(), names.end()).size() == names.size())
      return names;
  }
}

Json as_json(const mo::Monodromy& m, long digits, const std::string& variable,
             const std::string& rows) {
  Json loops = Json::array();
  const auto names = place_names(m, variable);
  auto name = names.begin();
  for (const mo::LoopMatrix& l : m.loops)
    loops.push_back({{"place", *name++},
                     {"matrix", as_json(l.matrix, digits)},
                     {"radius", mo::decimal_radius(l.matrix, digits)}});
  Json j{{"format", "kovacic-monodromy/1"},
         {"base", mo::exact_decimals(m.base)},
         {"basis", "Y(base) = 1, rows " + rows + "; continued along a loop Y becomes Y M"},
         {"loops", loops},
         {"digits", digits}};
  if (m.large_circle)
    j["large_circle"] = {{"matrix", as_json(*m.large_circle, digits)},
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

std::string angle_text(const Ball& x) {
  Ball turns;
  arb_const_pi(turns.raw(), mo::plan_bits);
  arb_div(turns.raw(), x.raw(), turns.raw(), mo::plan_bits);
  char* text = arb_get_str(turns.raw(), 10, ARB_STR_NO_RADIUS);
  const std::string direction = std::string(text) + "*pi";
  flint_free(text);
  return arb_is_zero(x.raw()) != 0 ? "0" : direction;
}

Json number(const ComplexBall& z, long digits) {
  const auto [re, im] = mo::decimals(z.raw(), digits);
  return {re, im};
}

Json as_json(const mo::Stokes& s, long digits) {
  Json all = Json::array();
  for (const mo::StokesMatrix& x : s.matrices)
    all.push_back({{"direction", angle_text(x.direction)},
                   {"multiplier", number(x.multiplier, digits)},
                   {"matrix", as_json(x.matrix, digits)},
                   {"radius", mo::decimal_radius(x.matrix, digits)}});
  return {{"place", "infinity"}, {"family", s.family}, {"matrices", all}};
}

Json as_json(const mo::HyperbolicPair& p) {
  return {{"proves", "SL2"},
          {"A", p.a},
          {"B", p.b},
          {"trace_A", ball_text(p.trace_a)},
          {"trace_commutator", ball_text(p.trace_commutator)},
          {"trace_ABAB^-1", ball_text(p.trace_normalizer)}};
}

Json as_json(const mo::NoSmallGroup& p) {
  return {{"proves", "SL2"},
          {"A", p.a},
          {"B", p.b},
          {"C", p.c},
          {"trace_commutator_of_squares", ball_text(p.trace_squares)},
          {"trace_C_squared", ball_text(p.trace_c_square)}};
}

Json as_json(const mo::Sl2Proof& p) {
  return std::visit([](const auto& x) { return as_json(x); }, p);
}

Json as_json(const mo::UnipotentElement& u) {
  return {{"loops", u.loops ? Json(*u.loops) : Json("large circle")},
          {"power", u.power},
          {"conjugated_by", u.conjugator}};
}

constexpr const char* not_abelian = "the identity component is not abelian";

Json as_json(const mo::NonAbelianProof& p, bool by_blocks) {
  return {{"proves", not_abelian},
          {"unipotent_by", by_blocks ? "blocks" : "exponents"},
          {"A", as_json(p.a)},
          {"B", as_json(p.b)},
          {"row", p.row},
          {"column", p.column},
          {"commutator_entry", ball_text(p.entry)}};
}

// "(dq1, dq2)"
std::string rows_of(const std::vector<std::string>& names) {
  return "(" + joined(names, [](const std::string& name) { return "d" + name; }) + ")";
}

Json as_json(const std::optional<NonAbelianVariation>& p, const std::vector<std::string>& names) {
  if (!p) return nullptr;
  if (p->unipotent) return as_json(*p->unipotent, p->by_blocks);
  Json j = as_json(*p->block_proof);
  j["proves"] = not_abelian;
  j["block"] = rows_of({names.at(p->block.at(0)), names.at(p->block.at(1))});
  return j;
}

std::string numbers_text(const Json& word) {
  return joined(word, [&](const Json& i) { return std::to_string(i.get<long>() + 1); });
}

std::string element_text(const Json& u) {
  const Json& loops = u.at("loops");
  std::string text = loops.is_string()   ? "the large circle"
                     : loops.size() == 1 ? "loop " + numbers_text(loops)
                                         : "loops " + numbers_text(loops);
  if (u.at("power") != 1) text += ", " + std::to_string(u.at("power").get<long>()) + " times";
  if (!u.at("conjugated_by").empty()) text += ", behind " + numbers_text(u.at("conjugated_by"));
  return text;
}

std::string inequalities_text(const Json& proof) {
  const std::string stokes = proof.contains("stokes") ? " and Stokes matrices" : "";
  if (proof.contains("C"))
    return "words A, B, C in the loops" + stokes + " with tr A^2 B^2 A^-2 B^-2 = " +
           proof.at("trace_commutator_of_squares").get<std::string>() +
           ", tr(C)^2/det C = " + proof.at("trace_C_squared").get<std::string>();
  return "words A, B in the loops" + stokes +
         " with tr A = " + proof.at("trace_A").get<std::string>() +
         ", tr A B A^-1 B^-1 = " + proof.at("trace_commutator").get<std::string>() +
         ", tr A B A B^-1 = " + proof.at("trace_ABAB^-1").get<std::string>();
}

// What a certificate says, in one sentence.
std::string proof_text(const Json& proof) {
  if (proof.at("proves") == "SL2")
    return "the group of the normal form y'' = r y is SL(2, C): " + inequalities_text(proof);
  const std::string claim = "the identity component of the group is not abelian: ";
  if (proof.contains("block"))
    return claim + "on " + proof.at("block").get<std::string>() + ", " + inequalities_text(proof);
  return claim + "A (" + element_text(proof.at("A")) + ") and B (" + element_text(proof.at("B")) +
         ") are unipotent by " +
         (proof.at("unipotent_by") == "exponents" ? "their exponents"
                                                  : "the groups of the diagonal blocks") +
         " and do not commute: an entry of A B - B A is " +
         proof.at("commutator_entry").get<std::string>();
}

// The numbers cut after so many decimals; `mark` stands where something was cut.
std::string entry_text(const Json& entry, long shown, const char* mark = "") {
  const auto cut = [&](std::string s) {
    const auto dot = s.find('.');
    if (dot == std::string::npos || s.size() <= dot + 1 + static_cast<std::size_t>(shown)) return s;
    return s.substr(0, dot + 1 + static_cast<std::size_t>(shown)) + mark;
  };
  const std::string im = cut(entry[1]);
  const bool negative = im.front() == '-';
  return cut(entry[0]) + (negative ? " - " + im.substr(1) : " + " + im) + "*I";
}

void write_matrix(std::ostream& out, const Json& matrix, long shown) {
  for (const Json& row : matrix) {
    out << "   ";
    for (const Json& entry : row)
      out << "  " << entry_text(entry, shown);
    out << '\n';
  }
}

std::string stokes_text(const Json& stokes, long shown) {
  std::ostringstream out;
  for (const Json& s : stokes.at("matrices")) {
    out << "  Stokes matrix at infinity, arg = " << s.at("direction").get<std::string>()
        << ", multiplier " << entry_text(s.at("multiplier"), shown) << "   (radius "
        << s.at("radius").get<std::string>() << ")\n";
    write_matrix(out, s.at("matrix"), shown);
  }
  return out.str();
}

std::string text_of(const Json& j) {
  std::ostringstream out;
  const long shown = std::min(20L, j.at("digits").get<long>());
  out << "base " << entry_text(j.at("base"), 20, "...") << "; " << j.at("basis").get<std::string>()
      << '\n';
  if (j.contains("constant")) out << "where " << j.at("constant").get<std::string>() << '\n';
  for (const Json& l : j.at("loops")) {
    out << "  around " << l.at("place").get<std::string>() << ", counterclockwise   (radius "
        << l.at("radius").get<std::string>() << "; cut after " << shown << " decimals)\n";
    write_matrix(out, l.at("matrix"), shown);
  }
  if (j.at("loops").empty()) out << "  no finite singularity: every loop gives the identity\n";
  if (j.contains("stokes")) out << stokes_text(j.at("stokes"), shown);
  for (const Json& t : j.at("self_tests"))
    put(out, "tested", t);
  if (j.contains("irregular") && !j.at("irregular").empty())
    put(out, "note",
        "irregular at " + listed(j.at("irregular")) +
            ": there the Galois group is more than monodromy " +
            (j.contains("stokes")
                 ? "(with the exponential torus the matrices are dense in it)"
                 : "(exponential torus and Stokes matrices, which are not computed)"));
  if (const Json& proof = j.at("certificate"); !proof.is_null())
    put(out, "proved", proof_text(proof));
  if (j.contains("certificate_file")) put(out, "written", j.at("certificate_file"));
  if (j.contains("no_certificate"))
    put(out, "note", "no certificate: " + j.at("no_certificate").get<std::string>());
  return out.str();
}

mo::Request request_of(const Settings& settings, const MonodromyArguments& a) {
  mo::Request request;
  request.digits = a.digits;
  request.budget = settings.solver_options().budget;
  if (a.base) request.base = read_base(*a.base);
  return request;
}

// Where f has a pole of order > most, or no zero of order >= least at infinity.
void add_places(const RationalFunction& f, int most, long least, const std::string& variable,
                std::set<std::string>& places) {
  if (is_zero(f)) return;
  for (const Factor& x : squarefree_factors(f.den()))
    if (x.exponent > most && degree(x.base) > 0)
      places.insert(to_string(x.base, variable) + " = 0");
  if (order_at_infinity(f) < least) places.insert("infinity");
}

// Places where monodromy is not all: "infinity", or the polynomial that vanishes there.  The
// equation that is given is the normal form times exp(-int p/2).
std::set<std::string> irregular_places(const GivenEquation& e) {
  std::set<std::string> places;
  add_places(e.normal_form.r, 2, 2, e.variable, places);
  add_places(e.p, 1, 1, e.variable, places);
  return places;
}

/// What was computed, and its picture.
struct Matrices {
  Json json;
  std::string svg;
};

// To the file of --certificate, or why there is none.
void write_proof(const Settings& settings, const LoopsProof& proof, Json& j) {
  if (proof.certificate.empty()) {
    j["no_certificate"] = proof.none;
    return;
  }
  write_file(settings.certificate, laid_out(proof.certificate));
  j["certificate_file"] = settings.certificate;
}

Matrices of_equation(const Settings& settings, const MonodromyArguments& a) {
  Json reading;
  const GivenEquation e = given(settings, a, reading);
  const mo::Request request = request_of(settings, a);
  const mo::Monodromy m = mo::monodromy(e.p, e.q, request);
  Json j = as_json(m, a.digits, e.variable, "(y, y')");
  j.update(reading);
  mo::Monodromy known = m; // elements of the group
  if (const auto s = mo::stokes_at_infinity(e.p, e.q, m.base, request)) {
    j["stokes"] = as_json(*s, a.digits);
    for (const mo::StokesMatrix& x : s->matrices)
      known.loops.push_back({{}, x.matrix});
    for (const std::string& passed : s->self_tests)
      j["self_tests"].push_back(passed);
  }
  const auto proof = mo::prove_sl2(known, request.budget);
  j["certificate"] = proof ? as_json(*proof) : Json(nullptr);
  const std::string title = is_zero(e.p)
                                ? "y'' = r y, r = " + to_string(e.normal_form.r, e.variable)
                                : "y'' + p y' + q y = 0, p = " + to_string(e.p, e.variable) +
                                      ", q = " + to_string(e.q, e.variable);
  if (!settings.certificate.empty()) {
    LoopsProof written = sl2_certificate(title, mo::companion(e.p, e.q), m, request.budget);
    if (written.certificate.empty() && proof && !mo::prove_sl2(m, request.budget))
      written.none = "Stokes matrices have no rule in a certificate";
    write_proof(settings, written, j);
  }
  if (proof && j.contains("stokes")) j["certificate"]["stokes"] = true;
  j["irregular"] = irregular_places(e);
  if (!e.constant.empty() && e.constant != "I")
    j["constant"] = e.constant + " = " + e.constant_meaning;
  return {j, report::loops_svg(m, title, place_names(m, e.variable))};
}

// F(z) of an elliptic time, over the field of the equation or Q.
Poly read_time(const std::string& text, const GivenEquation& e) {
  const Expression f = parse_expression(text, "--elliptic-time");
  Constants constants;
  constants.gather(std::span(&f, 1));
  const RationalFunction value =
      rational_function(f, Reading{.variable = e.variable, .constants = &constants, .budget = {}});
  if (degree(value.den()) > 0)
    throw f.error("a polynomial of degree 3 or 4 is expected",
                  "write e.g. --elliptic-time '4*z^3 - 4*z'");
  return scale(value.num(), NfElem(1) / value.den().coeff(0));
}

std::string elliptic_text(const Json& j) {
  std::ostringstream out;
  const long shown = std::min(20L, j.at("digits").get<long>());
  out << "base z = " << entry_text(j.at("base"), 20, "...")
      << ", dz/dt = " << entry_text(j.at("speed"), shown) << "; "
      << j.at("basis").get<std::string>() << '\n';
  if (j.contains("curve"))
    out << "  on the curve " << j.at("curve").get<std::string>() << ", "
        << j.at("change").get<std::string>() << '\n';
  for (const Json& p : j.at("periods")) {
    out << "  period " << entry_text(p.at("period"), shown) << " (loops "
        << numbers_text(p.at("loops")) << ")   (radius " << p.at("radius").get<std::string>()
        << ")\n";
    write_matrix(out, p.at("matrix"), shown);
  }
  for (const Json& p : j.at("poles")) {
    out << "  around the pole at z = " << p.at("place").get<std::string>()
        << (p.at("other_sheet").get<bool>() ? ", other sheet" : "")
        << ", counterclockwise   (radius " << p.at("radius").get<std::string>() << ")\n";
    write_matrix(out, p.at("matrix"), shown);
  }
  for (const Json& t : j.at("self_tests"))
    put(out, "tested", t);
  if (!j.value("certificate", Json()).is_null())
    put(out, "proved", proof_text(j.at("certificate")) + " (periods count before poles)");
  return out.str();
}

Json as_json(const mo::EllipticMonodromy& m, long digits, const std::string& variable,
             const std::string& rows) {
  Json periods = Json::array(), poles = Json::array();
  for (const mo::PeriodMatrix& p : m.periods)
    periods.push_back({{"period", number(p.period, digits)},
                       {"loops", p.loops},
                       {"matrix", as_json(p.matrix, digits)},
                       {"radius", mo::decimal_radius(p.matrix, digits)}});
  for (const mo::PoleMatrix& p : m.poles)
    poles.push_back({{"place", p.place ? mo::to_string(*p.place, variable) : "infinity"},
                     {"other_sheet", p.other_sheet},
                     {"matrix", as_json(p.matrix, digits)},
                     {"radius", mo::decimal_radius(p.matrix, digits)}});
  return {{"format", "kovacic-monodromy/1"},
          {"base", mo::exact_decimals(m.base)},
          {"speed", number(m.speed, digits)},
          {"basis", "Y(base) = 1, rows " + rows + "; continued along a loop Y becomes Y M"},
          {"periods", periods},
          {"poles", poles},
          {"digits", digits},
          {"self_tests", m.self_tests}};
}

Matrices of_elliptic_time(const Settings& settings, const MonodromyArguments& a) {
  if (!a.r || a.time->empty())
    throw InvalidArgument("--elliptic-time needs an equation y'' = R(z) y, or a system: "
                          "-r R --elliptic-time F, or --system FILE --elliptic-time");
  Json reading;
  const GivenEquation e = given(settings, a, reading);
  const mo::EllipticMonodromy m =
      mo::elliptic_monodromy(e.normal_form.r, read_time(*a.time, e), request_of(settings, a));
  Json j = as_json(m, a.digits, e.variable, "(y, dy/dt)");
  j.update(reading);
  return {j, {}};
}

LinearSystem linear_system(const System& s, const MonodromyArguments& a, const Settings& settings,
                           const InvariantManifold& m) {
  if (a.stage == "ve") return variational_equations(s.field, m);
  CheckOptions options;
  options.decide = settings.solver_options();
  options.only_manifold = m.name;
  options.stop_at_r = true;
  return study::FileStudy(s).manifold(0, {.check = options}).first.reduced.system;
}

// The one manifold that is meant.
InvariantManifold manifold_of(const System& s, const Settings& settings) {
  const ManifoldSpec* chosen = nullptr;
  for (const ManifoldSpec& spec : s.manifolds)
    if (settings.manifold.empty() || spec.name == settings.manifold) {
      if (chosen != nullptr)
        throw InvalidArgument("several manifolds in this file: choose one with --manifold NAME");
      chosen = &spec;
    }
  if (chosen == nullptr)
    throw InvalidArgument(s.manifolds.empty() ? "there is no manifold in this file"
                                              : "there is no manifold '" + settings.manifold + "'");
  auto proved = prove_invariant(s.field, *chosen);
  if (const auto* failure = std::get_if<ManifoldFailure>(&proved))
    throw InvalidArgument(failure->message);
  return std::get<InvariantManifold>(std::move(proved));
}

Matrices of_system(const Settings& settings, const MonodromyArguments& a) {
  const System s = read_system(a.system, parameter_values(settings));
  const InvariantManifold manifold = manifold_of(s, settings);
  const mo::Request request = request_of(settings, a);
  const NumericalVariation v =
      numerical_variation(s, manifold, linear_system(s, a, settings, manifold), {}, request.budget);
  const mo::Monodromy m = mo::monodromy(v.system, request);
  Json j = as_json(m, a.digits, s.ring()->name(s.z), rows_of(v.names));
  j["unknowns"] = v.names;
  j["change"] = v.change;
  const auto proof = prove_non_abelian(v.system, m, request.budget);
  j["certificate"] = as_json(proof, v.names);
  const std::string title = s.title.empty() ? s.file : s.title;
  if (!settings.certificate.empty())
    write_proof(settings,
                proof ? not_abelian_certificate(*proof, title, v.system, m, request.budget)
                      : LoopsProof{{}, "the matrices do not prove it"},
                j);
  return {j, report::loops_svg(m, title, place_names(m, s.ring()->name(s.z)))};
}

Json as_json(const std::optional<EllipticBlockProof>& p, const std::vector<std::string>& names) {
  if (!p) return nullptr;
  Json j = as_json(p->words);
  j["proves"] = not_abelian;
  j["block"] = rows_of({names.at(p->block.at(0)), names.at(p->block.at(1))});
  return j;
}

Matrices of_system_on_a_curve(const Settings& settings, const MonodromyArguments& a) {
  if (!a.time->empty())
    throw InvalidArgument("the curve of a system follows from its file: write --elliptic-time "
                          "without F(z)");
  if (!settings.certificate.empty())
    throw InvalidArgument("certificates of matrices are about loops in the z-plane: leave "
                          "--elliptic-time away");
  const System s = read_system(a.system, parameter_values(settings));
  const InvariantManifold manifold = manifold_of(s, settings);
  const mo::Request request = request_of(settings, a);
  const EllipticVariation v =
      elliptic_variation(s, manifold, linear_system(s, a, settings, manifold), request.budget);
  const mo::EllipticMonodromy m = mo::elliptic_monodromy(v.system, request);
  const std::string& z = s.ring()->name(s.z);
  Json j = as_json(m, a.digits, z, rows_of(v.names));
  j["unknowns"] = v.names;
  j["change"] = v.change;
  j["curve"] = "(d" + z + "/dt)^2 = " + to_string(v.system.f, z);
  j["certificate"] = as_json(prove_non_abelian(v.system, m, request.budget), v.names);
  return {j, {}};
}

Report matrices(const Settings& settings, const MonodromyArguments& a) {
  const auto start = std::chrono::steady_clock::now();
  const bool is_equation = a.system.empty();
  const Matrices found =
      a.time ? is_equation ? of_elliptic_time(settings, a) : of_system_on_a_curve(settings, a)
      : is_equation ? of_equation(settings, a)
                    : of_system(settings, a);
  Json j = found.json;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  j["seconds"] = seconds.count();
  const bool is_picture = settings.format == "text" && settings.output.ends_with(".svg");
  const std::string text = reading_text(j) + (a.time ? elliptic_text(j) : text_of(j));
  return {exit_decided, is_picture ? found.svg : text, j};
}

} // namespace

int monodromy(const Settings& settings, const MonodromyArguments& a) {
  const bool one_liner = a.r || a.ode || a.p || a.q;
  if (one_liner != a.system.empty()) {
    complain(
        settings, one_liner ? "an equation and a system are given" : "no equation is given",
        "write e.g. kovacic monodromy -r '-3/16/z^2 + 1/z'   or   kovacic monodromy --system FILE");
    return exit_input;
  }
  if (a.digits < 1 || a.digits > most_digits) {
    complain(settings, "--digits: 1 to " + std::to_string(most_digits) + " are expected");
    return exit_input;
  }
  const std::string about = one_liner ? "monodromy" : a.system;
  const Report report = supervised(settings, about, [&] { return matrices(settings, a); });
  return written_report(settings, report);
}

} // namespace kov::cli
