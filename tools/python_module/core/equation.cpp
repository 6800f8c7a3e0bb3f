// One equation: solve().  Decisions and the evidence behind them.

#include "bind.hpp"
#include "question.hpp"

#include "answer/notation.hpp"
#include "decide/afterwards.hpp"
#include "decide/words.hpp"
#include "equation/assumptions.hpp"
#include "equation/equation_file.hpp"
#include "galois/algebraic_solution.hpp"
#include "strata.hpp"
#include "symbol/author_words.hpp"
#include "symbol/notations.hpp"
#include "symbol/reading_note.hpp"
#include "symbol/written.hpp"

#include <pybind11/stl.h>

#include <algorithm>

namespace kov::python {
namespace {

/// A decision about an equation that somebody wrote.
struct Solved : Decision {
  GivenEquation given;
  answer::Given question;
  AskedEquation asked;
};

/// With the name of the variable.
struct Solution {
  LiouvillianSolution s;
  std::string variable;
};

struct Engines {
  std::shared_ptr<const Classification> proof;
  std::string variable;
};

py::object because(const Decision& d) {
  if (const auto* by = std::get_if<ByEngines>(&d.because))
    return py::cast(Engines{by->proof, d.variable});
  if (const auto* by = std::get_if<ByFormula>(&d.because)) return py::cast(*by);
  if (const auto* by = std::get_if<ByKovacic>(&d.because)) return py::cast(*by);
  return py::none();
}

std::vector<Solution> solutions_of(const Decision& d) {
  std::vector<Solution> all;
  for (const LiouvillianSolution& s : d.solutions)
    all.push_back({s, d.variable});
  return all;
}

// The equation as it was given.
std::string equation_of(const Solved& s) {
  return s.asked.given.empty() ? written(s.question.ode) : s.asked.given;
}

RationalFunction gauge_of(const Solved& s) { return s.given.p * RationalFunction(Rational(-1, 2)); }

// exp(-1/2 int p), by which the solutions of y'' = r y are to be multiplied.
std::string factor_text(const Solved& s) {
  return answer::factor_of(s.given, Budget::of_seconds(10)).text;
}

// Solutions of the given equation, in its letters: with its right side the general one, with initial values the one.
std::vector<std::string> solution_texts(const Solved& s) {
  const RationalFunction gauge = gauge_of(s);
  const answer::Solutions found =
      answer::solutions_of(s.question, s.given, s, gauge, {}, Budget::of_seconds(60));
  if (!s.asked.whole) return answer::for_programs(found);
  const auto whole = answer::whole_of(s.asked, found.y);
  const auto& one = whole.with_values ? whole.with_values : whole.general;
  if (!one) return {};
  return {answer::for_programs(parse_expression(*one, "a solution"))};
}

// Both solutions times exp(int gauge); nothing where they are not known as formulas.
auto basis_of(const Decision& d, const RationalFunction& gauge) {
  return answer::basis_of(d, gauge, Budget::of_seconds(60));
}

/// y^power = factor*X, and the coefficients of the polynomial of X, ascending.
using PolynomialOfY = std::tuple<long, Function, std::vector<Function>>;

// Of y exp(int gauge).
std::optional<PolynomialOfY> polynomial_of_y(const Decision& d, const RationalFunction& gauge) {
  if (d.proof() == nullptr) return std::nullopt;
  const Budget budget = Budget::of_seconds(60);
  auto y = algebraic_solution(*d.proof(), d.r, budget);
  if (y && !is_zero(gauge)) y = times_exponential(*std::move(y), gauge, budget);
  if (!y) return std::nullopt;
  std::vector<Function> coefficients;
  for (const Poly& c : y->polynomial)
    coefficients.push_back({RationalFunction(c), d.variable});
  return PolynomialOfY{y->power, Function{y->factor, d.variable}, coefficients};
}

std::string headline(const Decision& d) {
  std::string text = d.group ? "G = " + describe(*d.group) : "G not determined";
  if (d.component) text += ", identity component " + to_string(*d.component);
  return text + (d.abelian == Truth::yes  ? ", abelian"
                 : d.abelian == Truth::no ? ", not abelian"
                                          : ", abelian or not: undecided");
}

std::string told(const Decision& d) {
  std::string text = "y'' = r y, r = " + to_string(d.r, d.variable) + "\n" + headline(d) +
                     "\nbecause " + reason(d);
  if (d.undecided) text += "\nundecided: " + d.undecided->detail;
  return text;
}

template <class T> py::object or_none(const std::optional<T>& value, const std::string& variable) {
  if (!value) return py::none();
  return py::cast(Function{*value, variable});
}

py::list functions(const std::vector<RationalFunction>& all, const std::string& variable) {
  py::list list;
  for (const RationalFunction& f : all)
    list.append(Function{f, variable});
  return list;
}

std::string solution_text(const Solution& s) {
  if (!s.s.exponential) {
    std::string sum;
    for (std::size_t i = 0; i < s.s.minimal_polynomial.size(); ++i)
      if (!is_zero(s.s.minimal_polynomial[i]))
        sum +=
            (sum.empty() ? "" : " + ") +
            ("(" + to_string(s.s.minimal_polynomial[i], s.variable) + ")*w^" + std::to_string(i));
    return "exp(int w), " + sum + " = 0";
  }
  return text(s.s, s.variable, Budget::of_seconds(60));
}

void bind_solutions(py::module_& m) {
  auto type = read_only<Solution>(
      m, "LiouvillianSolution",
      "A solution of y'' = r y: an exponential, or the minimal polynomial of y'/y.", {"y"});
  type.def_property_readonly(
          "y",
          [](const Solution& s) -> py::object {
            if (!s.s.exponential) return py::none();
            return py::str(solution_text(s));
          },
          "P*(z-c)^e*exp(R) as text; None for the others")
      .def_property_readonly(
          "omega",
          [](const Solution& s) -> py::object {
            if (!s.s.exponential) return py::none();
            return py::cast(Function{s.s.exponential->omega(), s.variable});
          },
          "y'/y; None for the others")
      .def_property_readonly(
          "minimal_polynomial",
          [](const Solution& s) { return functions(s.s.minimal_polynomial, s.variable); },
          "of y'/y over K(z), ascending; empty for an exponential")
      .def_property_readonly(
          "note", [](const Solution& s) { return note(s.s); }, "what is said of the constants")
      .def_property_readonly(
          "generator",
          [](const Solution& s) -> py::object {
            if (!s.s.exponential) return py::none();
            return generator_of(s.s.exponential->theta.field());
          },
          "what the letter of the number field means, or None")
      .def("__str__", &solution_text)
      .def("__repr__",
           [](const Solution& s) { return "LiouvillianSolution('" + solution_text(s) + "')"; })
      .def("_repr_latex_", [](const Solution& s) {
        return s.s.exponential ? latex(solution_text(s)) : solution_text(s);
      });
}

void bind_evidence_enums(py::module_& m) {
  enumeration<Argument>(m, "Argument",
                        {{"none", Argument::none},
                         {"zero", Argument::zero},
                         {"p_curvature", Argument::p_curvature},
                         {"torus_two_lines", Argument::torus_two_lines},
                         {"torus_dihedral", Argument::torus_dihedral},
                         {"torus_no_invariant", Argument::torus_no_invariant},
                         {"torus_one_line", Argument::torus_one_line},
                         {"torus_no_line", Argument::torus_no_line},
                         {"logarithm_one_line", Argument::logarithm_one_line},
                         {"logarithm_no_line", Argument::logarithm_no_line},
                         {"integral_exponents", Argument::integral_exponents},
                         {"two_quartics", Argument::two_quartics},
                         {"two_radicals", Argument::two_radicals},
                         {"fourth_power", Argument::fourth_power},
                         {"dihedral", Argument::dihedral},
                         {"one_radical", Argument::one_radical},
                         {"line_alone", Argument::line_alone},
                         {"no_invariant", Argument::no_invariant},
                         {"primitive", Argument::primitive}});
  enumeration<Trichotomy>(m, "Trichotomy",
                          {{"irregular_or_irrational", Trichotomy::irregular_or_irrational},
                           {"logarithmic", Trichotomy::logarithmic},
                           {"rational_without_log", Trichotomy::rational_without_log},
                           {"undetermined", Trichotomy::undetermined}});
  enumeration<Method>(m, "Method",
                      {{"automatic", Method::automatic},
                       {"kovacic", Method::kovacic},
                       {"engines", Method::engines},
                       {"all", Method::all}});
}

py::object pair_of(const Engines& e) {
  if (!e.proof->pair) return py::none();
  return py::make_tuple(Function{e.proof->pair->v, e.variable},
                        to_python(e.proof->pair->w_squared));
}

py::list invariants_of(const Engines& e) {
  py::list all;
  for (const InvariantSearch& search : e.proof->invariants)
    for (const Invariant& v : search.basis)
      all.append(py::make_tuple(v.m, Function{value(v, *e.proof->local), e.variable}));
  return all;
}

py::object absence_of(const Engines& e) {
  if (!e.proof->no_exponential) return py::none();
  const NoExponential& none = *e.proof->no_exponential;
  if (none.obstruction) return py::str(to_string(*none.obstruction, *e.proof->local, e.variable));
  return py::str("the expansion at one place modulo " + std::to_string(none.prime.p) +
                 " satisfies no recurrence of length " + std::to_string(none.length));
}

void bind_evidence(py::module_& m) {
  bind_evidence_enums(m);
  auto engines = read_only<Engines>(
      m, "ByEngines", "The polynomial-time engines: which argument, and the evidence that it uses.",
      {"argument"});
  engines.def_property_readonly("argument", [](const Engines& e) { return e.proof->argument; })
      .def_property_readonly("kind", [](const Engines& e) { return e.proof->kind; })
      .def_property_readonly(
          "place",
          [](const Engines& e) -> py::object {
            if (!e.proof->local) return py::none();
            return py::str(place_name(place_at(*e.proof->local, e.proof->decisive), e.variable));
          },
          "the place that decides the kind, but for rational_without_log")
      .def_property_readonly(
          "exponential",
          [](const Engines& e) -> py::object {
            if (!e.proof->exponential) return py::none();
            return py::cast(Function{e.proof->exponential->omega(), e.variable});
          },
          "y'/y of the only exponential solution over K, verified")
      .def_property_readonly("pair", &pair_of,
                             "(v, w^2) of two exponential solutions: v = y1*y2, "
                             "y'/y = (v' +- w)/(2*v)")
      .def_property_readonly("invariants", &invariants_of,
                             "(m, v): rational solutions v of the m-th symmetric power, verified")
      .def_property_readonly(
          "no_invariants",
          [](const Engines& e) {
            py::list all;
            for (const NoInvariant& none : e.proof->no_invariants)
              all.append(none.m);
            return all;
          },
          "degrees m of symmetric powers without rational solution, proved")
      .def_property_readonly("no_exponential", &absence_of,
                             "how the absence of exponential solutions is proved, or None")
      .def_property_readonly(
          "p_curvature",
          [](const Engines& e) -> py::object {
            if (!e.proof->p_curvature) return py::none();
            return py::int_(e.proof->p_curvature->prime.p);
          },
          "the prime that proves SL(2, C) by itself, or None")
      .def_property_readonly("undecided", [](const Engines& e) { return e.proof->undecided; })
      .def_property_readonly("reason", [](const Engines& e) { return reason(*e.proof); })
      .def("__repr__", [](const Engines& e) { return "ByEngines(" + reason(*e.proof) + ")"; });

  read_only<ByKovacic>(m, "ByKovacic", R"(Kovacic's algorithm excludes its cases 1, 2 and 3.

    >>> isinstance(kovacic.solve("z").because, kovacic.ByKovacic)
    False
)")
      .def("__repr__", [](const ByKovacic&) { return "ByKovacic()"; });

  auto formula = read_only<ByFormula>(
      m, "ByFormula", "The classical criterion of a classical equation.", {"family", "parameters"});
  formula
      .def_property_readonly("family",
                             [](const ByFormula& by) { return to_string(by.known.family); })
      .def_property_readonly("equation", [](const ByFormula& by) { return by.known.equation; })
      .def_property_readonly("parameters",
                             [](const ByFormula& by) {
                               py::dict all;
                               for (const auto& [name, value] : by.known.parameters)
                                 all[py::str(name)] = value;
                               return all;
                             })
      .def_property_readonly("reason", [](const ByFormula& by) { return by.known.answer->reason; })
      .def_property_readonly(
          "engines", [](const ByFormula& by) { return by.engines; }, "what had stopped the engines")
      .def("__repr__", [](const ByFormula& by) {
        return std::string("ByFormula('") + to_string(by.known.family) + "')";
      });
}

void bind_decision(py::module_& m) {
  auto type = read_only<Decision>(
      m, "Decision", "y'' = r y decided: group, identity component, solutions, and why.",
      {"group", "because"});
  type.def_property_readonly("r",
                             [](const Decision& d) {
                               return Function{d.r, d.variable};
                             })
      .def_readonly("variable", &Decision::variable)
      .def_readonly("group", &Decision::group, "None: not determined")
      .def_readonly("component", &Decision::component,
                    "the identity component; may be known where the group is not")
      .def_readonly("abelian", &Decision::abelian, "is the identity component abelian?  A Truth")
      .def_readonly("kovacic_case", &Decision::kovacic_case, "1 to 4, or None")
      .def_property_readonly("because", &because,
                             "ByEngines, ByKovacic, ByFormula, or None: undecided")
      .def_property_readonly("reason", [](const Decision& d) { return reason(d); })
      .def_readonly("undecided", &Decision::undecided,
                    "why something that was asked stayed open, or None")
      .def_property_readonly(
          "withdrawn",
          [](const Decision& d) -> std::optional<std::string> {
            if (!d.withdrawn) return std::nullopt;
            return to_string(*d.withdrawn);
          },
          "why an answer was taken back; then nothing else is stated")
      .def_readonly("second_opinion", &Decision::second_opinion,
                    "the case that Kovacic's algorithm finds as well, or None")
      .def_property_readonly("liouvillian", &solutions_of, "of y'' = r y")
      .def_property_readonly(
          "basis", [](const Decision& d) { return basis_of(d, {}); },
          "two formulas, checked in exact arithmetic, where the group is reducible or dihedral; or "
          "None")
      .def_property_readonly(
          "polynomial_of_y", [](const Decision& d) { return polynomial_of_y(d, {}); },
          "(k, factor, coefficients) for A4, S4, A5, else None: y^k = factor*X, and the polynomial "
          "of X, ascending")
      .def_property_readonly(
          "no_solutions",
          [](const Decision& d) -> std::optional<std::string> {
            if (!d.no_solutions) return std::nullopt;
            return to_string(*d.no_solutions);
          },
          "why the solutions are not there, or None")
      .def_readonly("only_case", &Decision::only_case)
      .def_property_readonly("trace",
                             [](const Decision& d) {
                               py::list all;
                               for (const kovacic::Step& t : d.trace)
                                 all.append(py::make_tuple(name(t), t.text));
                               return all;
                             })
      .def_property_readonly(
          "certificate",
          [](const Decision& d) -> std::optional<std::string> {
            if (d.certificate.empty()) return std::nullopt;
            return d.certificate;
          },
          "JSON for verify(), if it was asked for")
      .def_readonly("no_certificate", &Decision::no_certificate)
      .def_readonly("refused", &Decision::refused)
      .def_readonly("seconds", &Decision::seconds)
      .def_property_readonly("headline", &headline)
      .def("__str__", &told)
      .def("__repr__", [](const Decision& d) { return "<Decision: " + headline(d) + ">"; })
      .def("_repr_latex_", [](const Decision& d) {
        return latex("y'' = (" + to_string(d.r, d.variable) + ")*y") + ": " + headline(d);
      });

  py::class_<Solved, Decision> solved(
      m, "Solved", "The decision about an equation as it was given: y'' + p y' + q y = 0.");
  solved
      .def_property_readonly(
          "unknown", [](const Solved& s) { return s.given.unknown; },
          "What the unknown function is called in the given equation.\n\n"
          ">>> kovacic.solve(\"u'' = t*u\").unknown\n'u'")
      .def_property_readonly(
          "equation", &equation_of,
          "The equation as it was given.\n\n>>> kovacic.solve(\"u'' = t*u\").equation\n\"u'' = "
          "t*u\"")
      .def_property_readonly(
          "solutions", &solution_texts,
          "Of the given equation, in its letters; special functions have the names of mpmath.  "
          "With a right side, "
          "or of a Riccati equation: the general one; with initial values: the one that has "
          "them.\n\n"
          ">>> kovacic.solve(\"u'' = t*u\").solutions\n['airyai(t)', 'airybi(t)']")
      .def_property_readonly("p",
                             [](const Solved& s) {
                               return Function{s.given.p, s.variable};
                             })
      .def_property_readonly("q",
                             [](const Solved& s) {
                               return Function{s.given.q, s.variable};
                             })
      .def_property_readonly(
          "factor", [](const Solved& s) { return factor_text(s); },
          "exp(-1/2 int p): the solutions of the given equation are this times `solutions`.\n\n"
          ">>> kovacic.solve(\"u'' + u' = t*u\").factor\n'exp(-t/2)'")
      .def_property_readonly(
          "basis", [](const Solved& s) { return basis_of(s, gauge_of(s)); },
          "both solutions of the given equation as formulas, or None")
      .def_property_readonly(
          "polynomial_of_y", [](const Solved& s) { return polynomial_of_y(s, gauge_of(s)); },
          "the same for the given equation; None also where no such power is algebraic over K(z)")
      .def_property_readonly(
          "constants",
          [](const Solved& s) {
            py::dict all;
            if (!s.given.constant.empty())
              all[py::str(s.given.constant)] = s.given.constant_meaning;
            return all;
          },
          "what the generator of the number field means: {name: 'root(p, approx)'}")
      .def("__str__", [](const Solved& s) {
        std::string text = equation_of(s), failed; // the verdict is told all the same
        const std::string& y = s.asked.whole ? s.asked.whole->unknown : s.given.unknown;
        try {
          failed = failure_of("printing the solutions", [&] {
            const std::vector<std::string> all = solution_texts(s);
            for (const std::string& one : all)
              text += "\n" + y + " = " + one;
            if (!all.empty()) return;
            for (const Solution& one : solutions_of(s))
              text += "\n" + solution_text(one);
            if (!s.solutions.empty() && !is_zero(s.given.p))
              text += "\nsolutions of the given equation: these times " + factor_text(s);
          });
        } catch (const OutOfBudget& limit) {
          failed = limit.what();
        }
        text += "\n" + told(s);
        if (is_identifier(s.given.constant) && s.given.constant != "I")
          text += "\nwhere " + s.given.constant + " = " + s.given.constant_meaning;
        for (const std::string& note : sentences(s.asked.notes))
          text += "\nnote: " + note;
        return failed.empty() ? text : text + "\nsolutions not printed: " + failed;
      });
}

/// Numbers, or a family.
std::variant<Solved, FamilyAnswer> decided(const Wishes& wishes, const AskedEquation& asked,
                                           const Budget& budget) {
  const EquationText& text = asked.text;
  check_names(text);
  check_assumptions(text);
  const Options options = wishes.options(budget);
  try {
    GivenEquation given = read_equation(text, budget);
    Decision d = answer::decided(answer::in_its_variable(given), options);
    return Solved{std::move(d), std::move(given), answer::given_equation(text), asked};
  } catch (const FreeParameters&) {
    strata::StrataLimits limits;
    limits.decide = options;
    return FamilyAnswer(answer::decide_family(text, limits));
  }
}

} // namespace

Options Wishes::options(const Budget& budget) const {
  Options o;
  o.budget = budget;
  o.method = method;
  o.only_case = only_case;
  o.want_solutions = solutions;
  o.want_trace = trace;
  o.want_certificate = certificate;
  return o;
}

AskedEquation QuestionTexts::read() const {
  EquationText given;
  given.variable = variable;
  given.unknown = unknown;
  given.parameters = parameters;
  for (const auto& [name, value] : set)
    given.set.emplace_back(name, parse_expression(value, "set[" + name + "]"));
  given.assume = assumed_texts(assume, "assume");
  return asked_equation(equation, std::move(given), Door::keys);
}

py::object answer(const Wishes& wishes, const AskedEquation& asked) {
  return computed(wishes.limits,
                  [&](const Budget& b, const Interrupt&) { return decided(wishes, asked, b); });
}

void bind_equation(py::module_& m) {
  bind_solutions(m);
  bind_evidence(m);
  bind_decision(m);
  py::class_<Limits>(m, "Limits")
      .def(py::init([](std::optional<double> timeout, std::optional<double> work,
                       std::optional<long> degree, std::optional<long> families) {
             Limits limits{timeout, work, degree, families};
             (void)limits.budget();
             return limits;
           }),
           py::kw_only(), py::arg("timeout") = py::none(), py::arg("max_work") = py::none(),
           py::arg("max_degree") = py::none(), py::arg("max_families") = py::none());
  py::class_<Wishes>(m, "Wishes")
      .def(py::init([](const Limits& limits, Method method, std::optional<int> only_case,
                       bool solutions, bool trace, bool certificate) {
             if (only_case && (*only_case < 1 || *only_case > 3))
               throw InvalidArgument("only_case is 1, 2 or 3, and not " +
                                     std::to_string(*only_case));
             return Wishes{limits, method, only_case, solutions, trace, certificate};
           }),
           py::kw_only(), py::arg("limits"), py::arg("method") = Method::automatic,
           py::arg("only_case") = py::none(), py::arg("solutions") = true, py::arg("trace") = false,
           py::arg("certificate") = false);
  using Text = std::optional<std::string>;
  py::class_<QuestionTexts>(m, "QuestionTexts")
      .def(py::init([](Text r, Text ode, Text p, Text q, Text minpoly, std::string variable,
                       std::string unknown, std::vector<std::string> parameters,
                       std::vector<std::string> assume,
                       std::vector<std::pair<std::string, std::string>> set) {
             return QuestionTexts{
                 {std::move(r), std::move(ode), std::move(p), std::move(q), std::move(minpoly)},
                 std::move(variable),
                 std::move(unknown),
                 std::move(parameters),
                 std::move(assume),
                 std::move(set)};
           }),
           py::arg("r"), py::arg("ode"), py::arg("p"), py::arg("q"), py::arg("minpoly"),
           py::arg("variable"), py::arg("unknown"), py::arg("parameters"), py::arg("assume"),
           py::arg("set"));
  m.def("solve", [](const Wishes& wishes, const QuestionTexts& texts) {
    return answer(wishes, texts.read());
  });
}

} // namespace kov::python
