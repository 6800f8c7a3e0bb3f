// Rational functions, algebraic numbers, groups and the three-valued truth.

#include "values.hpp"
#include "bind.hpp"
#include "decide/decide.hpp"
#include "exact/tried.hpp"
#include "report/formula.hpp"
#include "report/solution.hpp"
#include "symbol/expression.hpp"
#include "symbol/rational_form.hpp"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <complex>

namespace kov::python {

py::object to_python(const Integer& n) {
  if (fits_long(n)) return py::int_(to_long(n));
  char* digits = fmpz_get_str(nullptr, 16, n.raw()); // decimal digits have a limit in Python
  auto value = py::reinterpret_steal<py::object>(PyLong_FromString(digits, nullptr, 16));
  flint_free(digits);
  if (!value) throw py::error_already_set();
  return value;
}

namespace {
py::handle fraction_class; // fractions.Fraction; never freed
}

py::object to_python(const Rational& q) {
  return fraction_class(to_python(q.num()), to_python(q.den()));
}

py::object to_python(const NfElem& a) {
  if (is_rational(a)) return to_python(to_rational(a));
  return py::cast(a);
}

namespace {

std::complex<double> midpoint(const ComplexBall& z) {
  return {arf_get_d(arb_midref(acb_realref(z.raw())), ARF_RND_NEAR),
          arf_get_d(arb_midref(acb_imagref(z.raw())), ARF_RND_NEAR)};
}

} // namespace

py::object generator_of(const Field& k) {
  if (k->is_rational() || k->letter() == "I" || k->letter().find('(') != std::string::npos)
    return py::none();
  return py::make_tuple(k->letter(), k->minpoly_coefficients(), midpoint(k->generator(64)),
                        k->scale());
}

Integer to_integer(const py::int_& n) {
  int overflow = 0;
  const long small = PyLong_AsLongAndOverflow(n.ptr(), &overflow);
  if (overflow == 0) return {small};
  const auto text = py::reinterpret_steal<py::str>(PyNumber_ToBase(n.ptr(), 16));
  if (!text) throw py::error_already_set();
  auto digits = text.cast<std::string>(); // -0x1f
  digits.erase(digits.find("0x"), 2);
  Integer value;
  KOV_ENSURE(fmpz_set_str(value.raw(), digits.c_str(), 16) == 0);
  return value;
}

std::string latex(const std::string& formula) {
  const std::optional<Expression> whole =
      tried<InputError>([&] { return std::optional(parse_expression(formula, "formula", true)); });
  return whole ? "$" + report::solution(*whole, report::Markup::tex) + "$"
               : report::formula(formula, report::Markup::tex);
}

namespace {

Function parsed(const std::string& text, const std::string& variable) {
  const Expression e = parse_expression(text, "formula");
  Constants constants;
  constants.gather({&e, 1});
  return {
      rational_function(e, Reading{.variable = variable, .constants = &constants, .budget = {}}),
      variable};
}

// Of one variable; a constant goes with every variable.
Function combined(const Function& a, const Function& b, RationalFunction value) {
  const auto constant = [](const Function& x) {
    return degree(x.f.num()) <= 0 && degree(x.f.den()) <= 0;
  };
  if (a.variable != b.variable && !constant(a) && !constant(b))
    throw InvalidArgument("functions of " + a.variable + " and of " + b.variable +
                          " cannot be combined");
  return {std::move(value), constant(a) ? b.variable : a.variable};
}

std::string text(const Function& x) { return to_string(x.f, x.variable); }

// Within the degree that other limits have by default.
Function power(const Function& a, long e) {
  const double longest = static_cast<double>(std::max(degree(a.f.num()), degree(a.f.den())) + 1);
  const auto bits = [](const Poly& f) { // of the largest number in it
    const auto top = std::abs(_fmpz_vec_max_bits(f.raw()->coeffs, f.raw()->length));
    return static_cast<double>(top) + static_cast<double>(fmpz_bits(f.raw()->den));
  };
  const double numbers = bits(a.f.num()) + bits(a.f.den());
  const double times = std::abs(static_cast<double>(e));
  if (times * longest > static_cast<double>(Budget{}.max_degree) || times * numbers > 1e8)
    throw OutOfBudget("this power is too large: degree " + std::to_string(degree(a.f.num())) +
                      ", exponent " + std::to_string(e));
  return {pow(a.f, e), a.variable};
}

py::list coefficients(const Poly& f) {
  py::list all;
  for (long i = 0; i <= degree(f); ++i)
    all.append(to_python(f.coeff(i)));
  return all;
}

void bind_functions(py::module_& m) {
  py::class_<Function> type(m, "RationalFunction",
                            "An element of K(z), K the rational numbers or a number field.");
  type.def(py::init(&parsed), py::arg("text"), py::arg("variable") = "z")
      .def(py::init([](const Rational& c) {
        return Function{c, "z"};
      }))
      .def_readonly("variable", &Function::variable)
      .def_property_readonly(
          "num", [](const Function& x) { return coefficients(x.f.num()); },
          "coefficients of the numerator, ascending")
      .def_property_readonly(
          "den", [](const Function& x) { return coefficients(x.f.den()); },
          "coefficients of the monic denominator, ascending")
      .def_property_readonly(
          "generator", [](const Function& x) { return generator_of(x.f.field()); },
          "what the letter of the number field means: (letter, minpoly, value, scale), or None")
      .def(
          "diff",
          [](const Function& x) {
            return Function{derivative(x.f), x.variable};
          },
          R"(The derivative.

    >>> kovacic.RationalFunction("z^2 + 1/z").diff()
    RationalFunction('(2*z^3 - 1)/z^2')
)")
      .def("__call__",
           [](const Function& x, const Rational& c) {
             const NfElem at(c), den = evaluate(x.f.den(), at);
             if (is_zero(den)) throw DomainError("a pole of " + text(x) + " at " + to_string(c));
             return to_python(evaluate(x.f.num(), at) / den);
           })
      .def("__str__", &text)
      .def("__repr__", [](const Function& x) { return "RationalFunction('" + text(x) + "')"; })
      .def("__hash__", [](const Function& x) { return py::hash(py::str(text(x))); })
      .def("__neg__",
           [](const Function& a) {
             return Function{-a.f, a.variable};
           })
      .def("__pow__", &power, py::is_operator())
      .def("_repr_latex_", [](const Function& x) { return latex(text(x)); });
  const auto binary = [&](const char* name, const char* reversed, auto operation) {
    type.def(
        name,
        [operation](const Function& a, const Function& b) {
          return combined(a, b, operation(a.f, b.f));
        },
        py::is_operator());
    type.def(
        reversed,
        [operation](const Function& a, const Function& b) {
          return combined(b, a, operation(b.f, a.f));
        },
        py::is_operator());
  };
  binary("__add__", "__radd__", [](const auto& a, const auto& b) { return a + b; });
  binary("__sub__", "__rsub__", [](const auto& a, const auto& b) { return a - b; });
  binary("__mul__", "__rmul__", [](const auto& a, const auto& b) { return a * b; });
  binary("__truediv__", "__rtruediv__", [](const auto& a, const auto& b) { return a / b; });
  type.def(
      "__eq__",
      [](const Function& a, const Function& b) {
        const bool constant = degree(a.f.num()) <= 0 && degree(a.f.den()) <= 0;
        return a.f == b.f && (constant || a.variable == b.variable);
      },
      py::is_operator());
  py::implicitly_convertible<py::int_, Function>();
  py::implicitly_convertible<Rational, Function>();

  py::class_<NfElem>(m, "AlgebraicNumber", "An irrational element of a number field Q(a).")
      .def("__str__", [](const NfElem& a) { return to_string(a); })
      .def("__repr__", [](const NfElem& a) { return "AlgebraicNumber('" + to_string(a) + "')"; })
      .def_property_readonly(
          "letter", [](const NfElem& a) { return a.field()->letter(); },
          "the name of the generator in texts")
      .def_property_readonly(
          "minpoly", [](const NfElem& a) { return a.field()->minpoly_coefficients(); },
          "minimal polynomial of the field's generator, ascending")
      .def(
          "__eq__", [](const NfElem& a, const NfElem& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const NfElem& a) { return py::hash(py::str(to_string(a))); })
      .def("__complex__", [](const NfElem& a) { return midpoint(embed(a, 64)); })
      .def_property_readonly(
          "generator", [](const NfElem& a) { return generator_of(a.field()); },
          "(letter, minpoly, value, scale), or None where the text says it")
      .def("_repr_latex_", [](const NfElem& a) { return latex(to_string(a)); });

  py::class_<MFraction>(m, "MFraction", "A rational function of parameters, over Q.")
      .def_property_readonly("names",
                             [](const MFraction& f) {
                               std::vector<std::string> names;
                               for (const std::size_t i : used_variables(f))
                                 names.push_back(f.ring()->name(i));
                               return names;
                             })
      .def("__str__", [](const MFraction& f) { return to_string(f); })
      .def("__repr__", [](const MFraction& f) { return "MFraction('" + to_string(f) + "')"; })
      .def(
          "factored", [](const MFraction& f) { return to_factored_string(f); },
          R"(A product, as text.

    >>> kovacic.solve("(a^2 - 1)*z", parameters="a").r.factored()
    'z*(a - 1)*(a + 1)'
)")
      .def(
          "__eq__",
          [](const MFraction& a, const MFraction& b) { return to_string(a) == to_string(b); },
          py::is_operator())
      .def("__hash__", [](const MFraction& f) { return py::hash(py::str(to_string(f))); })
      .def("_repr_latex_", [](const MFraction& f) { return latex(to_factored_string(f)); });
}

void bind_groups(py::module_& m) {
  enumeration<Truth>(m, "Truth",
                     {{"no", Truth::no}, {"yes", Truth::yes}, {"unknown", Truth::unknown}});

  enumeration<Unable::Why>(m, "Why",
                           {{"parameter", Unable::Why::parameter},
                            {"budget", Unable::Why::budget},
                            {"not_implemented", Unable::Why::not_implemented},
                            {"inexact", Unable::Why::inexact},
                            {"methods_disagree", Unable::Why::methods_disagree}});
  auto unable = read_only<Unable>(m, "Unable", "Why something is unknown.", {"why", "detail"});
  unable.def_readonly("why", &Unable::why)
      .def_readonly("detail", &Unable::detail)
      .def("__repr__", [](const Unable& u) { return "Unable('" + u.detail + "')"; })
      .def("__str__", [](const Unable& u) { return u.detail; });

  enumeration<GroupType>(m, "GroupType",
                         {{"SL2", GroupType::SL2},
                          {"Borel", GroupType::Borel},
                          {"T", GroupType::T},
                          {"Gm", GroupType::Gm},
                          {"cyclic", GroupType::cyclic},
                          {"Dinf", GroupType::Dinf},
                          {"D", GroupType::D},
                          {"A4", GroupType::A4},
                          {"S4", GroupType::S4},
                          {"A5", GroupType::A5}});
  enumeration<Connected>(m, "Connected",
                         {{"trivial", Connected::trivial},
                          {"additive", Connected::additive},
                          {"torus", Connected::torus},
                          {"borel", Connected::borel},
                          {"sl2", Connected::sl2}});
  auto group = read_only<GaloisGroup>(m, "GaloisGroup", "A subgroup of SL(2, C) up to conjugation.",
                                      {"type", "n"});
  group.def_readonly("type", &GaloisGroup::type)
      .def_readonly("n", &GaloisGroup::n, "T, cyclic and D only; None there: not determined")
      .def_property_readonly("identity_component",
                             [](const GaloisGroup& g) { return identity_component(g); })
      .def_property_readonly("kovacic_case", [](const GaloisGroup& g) { return kovacic_case(g); })
      .def(
          "__eq__", [](const GaloisGroup& a, const GaloisGroup& b) { return a == b; },
          py::is_operator())
      .def("__hash__", [](const GaloisGroup& g) { return py::hash(py::str(describe(g))); })
      .def(py::pickle(
          [](const GaloisGroup& g) { return py::make_tuple(g.type, g.n); },
          [](const py::tuple& t) {
            return GaloisGroup{t[0].cast<GroupType>(), t[1].cast<std::optional<Integer>>()};
          }))
      .def("__str__", [](const GaloisGroup& g) { return describe(g); })
      .def("__repr__", [](const GaloisGroup& g) {
        return "GaloisGroup('" + to_string(g.type) + (g.n ? "_" + to_string(*g.n) : "") + "')";
      });
}

} // namespace

void bind_values(py::module_& m) {
  fraction_class = py::module_::import("fractions").attr("Fraction").cast<py::object>().release();
  bind_functions(m);
  bind_groups(m);
  m.def("latex", &latex, py::arg("formula"), "A formula of the program's syntax as LaTeX.");
  m.def("prose", [](const std::string& text) { return report::prose(text, report::Markup::tex); });
  m.def(
      "decimal", [](const Integer& n) { return to_string(n); },
      "The digits of an integer of any size.");
}

} // namespace kov::python
