// spectrum(): for which E has y'' = r(z; E) y a Liouvillian solution?

#include "bind.hpp"
#include "question.hpp"

#include "equation/parametric_equation.hpp"
#include "parameters/statement.hpp"
#include "spectrum/spectrum.hpp"

#include <pybind11/stl.h>

namespace pybind11::detail {
KOV_PYTHON_ENUM(kov::spectrum::Piece::Status, "SpectrumStatus");
} // namespace pybind11::detail

namespace kov::python {
namespace {

using spectrum::AlgebraicSpectrum;
using spectrum::DegreeFamily;
using spectrum::Level;
using spectrum::Piece;
using spectrum::Series;

/// What the parts need to be read: the ring and the variable of the equation.
struct AskedSpectrum {
  strata::Question question;
  std::string energy;
};
template <class T> struct PartOf {
  std::shared_ptr<const AskedSpectrum> asked;
  T part;
};
using LevelOf = PartOf<Level>;
using SeriesOf = PartOf<Series>;
using FamilyOf = PartOf<DegreeFamily>;
using PieceOf = PartOf<Piece>;
using SpectrumOf = PartOf<AlgebraicSpectrum>;

/// A property: the parts of a part.
template <class Whole, class T> auto parts(std::vector<T> Whole::*member) {
  return [member](const PartOf<Whole>& whole) {
    std::vector<PartOf<T>> all;
    for (const T& one : whole.part.*member)
      all.push_back({whole.asked, one});
    return all;
  };
}

template <class Whole> auto texts(std::vector<Statement> Whole::*member) {
  return [member](const PartOf<Whole>& whole) {
    std::vector<std::string> all;
    for (const Statement& one : whole.part.*member)
      all.push_back(to_string(one));
    return all;
  };
}

std::string level_text(const LevelOf& l) {
  std::string text;
  const auto add = [&](const std::string& one) { text += (text.empty() ? "" : ", ") + one; };
  if (l.part.fixed)
    add(l.asked->question.r.ring()->name(l.part.fixed->first) + " = " +
        to_string(l.part.fixed->second));
  for (const MPoly& f : l.part.equations)
    add(to_string(f) + " = 0");
  if (text.empty()) text = "every " + l.asked->energy;
  return "N = " + std::to_string(l.part.n) + ": " + text;
}

std::string series_text(const SeriesOf& s) {
  const std::string some = ", for some integer " + s.part.equation.ring()->name(s.part.n);
  const std::string equation = to_string(s.part.equation) + " = 0";
  return (s.part.every_energy ? "every " + s.asked->energy + " where " + equation
          : s.part.value      ? s.asked->energy + " = " + to_string(*s.part.value)
                              : equation) +
         some;
}

void bind_levels(py::module_& m) {
  read_only<LevelOf>(m, "SpectrumLevel", "Values with a solution of one degree.", {"n", "y"})
      .def_property_readonly("n", [](const LevelOf& l) { return l.part.n; })
      .def_property_readonly(
          "fixed",
          [](const LevelOf& l) -> std::optional<std::pair<std::string, MFraction>> {
            if (!l.part.fixed) return std::nullopt;
            return std::pair{l.asked->question.r.ring()->name(l.part.fixed->first),
                             l.part.fixed->second};
          },
          "(name, value), or None")
      .def_property_readonly(
          "equations",
          [](const LevelOf& l) {
            return std::vector<MFraction>(l.part.equations.begin(), l.part.equations.end());
          },
          "each = 0")
      .def_property_readonly(
          "y",
          [](const LevelOf& l) -> std::optional<std::string> {
            if (!l.part.y) return std::nullopt;
            return spectrum::to_string(*l.part.y, l.asked->question.z);
          },
          "an eigenfunction, checked by substitution; or None")
      .def("__str__", &level_text)
      .def("__repr__", [](const LevelOf& l) { return "<SpectrumLevel " + level_text(l) + ">"; });
  read_only<SeriesOf>(m, "SpectrumSeries", "Values for each integer N.", {"value"})
      .def_property_readonly(
          "equation", [](const SeriesOf& s) { return MFraction(s.part.equation); }, "= 0")
      .def_property_readonly(
          "value", [](const SeriesOf& s) { return s.part.value; },
          "the solution of the equation, or None")
      .def_property_readonly(
          "integer", [](const SeriesOf& s) { return s.part.equation.ring()->name(s.part.n); },
          "the name of N")
      .def_property_readonly(
          "every_energy", [](const SeriesOf& s) { return s.part.every_energy; },
          "the equation is one of the other parameters")
      .def_property_readonly("levels", parts(&Series::first), "those of the first N")
      .def("__str__", &series_text)
      .def("__repr__", [](const SeriesOf& s) { return "<SpectrumSeries " + series_text(s) + ">"; });
  read_only<FamilyOf>(m, "SpectrumFamily", "Exponential solutions, degree by degree.", {"degree"})
      .def_property_readonly("degree", [](const FamilyOf& f) { return f.part.degree; })
      .def_property_readonly("levels", parts(&DegreeFamily::first))
      .def_property_readonly(
          "open", [](const FamilyOf& f) { return f.part.open; }, "what was not found, or empty")
      .def("__repr__",
           [](const FamilyOf& f) { return "<SpectrumFamily " + to_string(f.part.degree) + ">"; });
}

void bind_pieces(py::module_& m) {
  read_only<PieceOf>(m, "SpectrumPiece", "What is known where the conditions hold.", {"status"})
      .def_property_readonly("status", [](const PieceOf& p) { return p.part.status; })
      .def_property_readonly(
          "conditions", [](const PieceOf& p) { return to_string(p.part.conditions); },
          "empty: all values")
      .def_property_readonly("where", texts(&Piece::where), "exactly where one of these holds")
      .def_property_readonly("series", parts(&Piece::series),
                             "those of `where` that were solved for the energy")
      .def_property_readonly("unsolved", texts(&Piece::unsolved), "the others")
      .def_property_readonly("families", parts(&Piece::families))
      .def_property_readonly("groups", [](const PieceOf& p) { return p.part.groups; })
      .def_property_readonly(
          "why", [](const PieceOf& p) { return open_reason(p.part); }, "of an open one")
      .def("__repr__",
           [](const PieceOf& p) { return "<SpectrumPiece " + to_string(p.part.conditions) + ">"; });
  read_only<SpectrumOf>(m, "Spectrum", "The values of a parameter with a Liouvillian solution.",
                        {"pieces"})
      .def_property_readonly("pieces", parts(&AlgebraicSpectrum::pieces), "disjoint")
      .def_property_readonly("energy", [](const SpectrumOf& s) { return s.asked->energy; })
      .def_property_readonly("decided", [](const SpectrumOf& s) { return s.part.decided(); })
      .def_property_readonly("assumptions",
                             [](const SpectrumOf& s) {
                               return in_words(s.asked->question.assumptions,
                                               s.asked->question.r.ring());
                             })
      .def_property_readonly("trusted_steps",
                             [](const SpectrumOf& s) { return sentences(s.part.trusted); })
      .def_property_readonly("not_studied",
                             [](const SpectrumOf& s) { return s.part.strata.unvisited; })
      .def("__repr__", [](const SpectrumOf& s) {
        return "<Spectrum of " + s.asked->energy + ": " +
               (s.part.decided() ? "decided" : "undecided") + ", " +
               std::to_string(s.part.pieces.size()) + " pieces>";
      });
}

SpectrumOf found(QuestionTexts texts, const std::string& energy, long levels,
                 const Budget& budget) {
  texts.parameters = {energy};
  EquationText text = texts.read().text;
  text.parameters.clear();
  take_all_parameters(text, energy);
  const ParametricEquation equation = read_parametric_equation(text);
  const auto asked = energy_of(equation, energy);
  spectrum::SpectrumOptions options;
  options.levels = levels;
  options.strata.decide.budget = budget;
  options.strata.decide.variable = equation.variable;
  options.strata.decide.ask_the_judge = true;
  AlgebraicSpectrum all = spectrum::algebraic_spectrum(equation.question, asked, options);
  if (!all.strata.refusal.empty())
    throw InternalError("our own checker refuses the strata: " + all.strata.refusal);
  return {std::make_shared<const AskedSpectrum>(AskedSpectrum{equation.question, energy}),
          std::move(all)};
}

} // namespace

void bind_spectrum(py::module_& m) {
  enumeration<Piece::Status>(m, "SpectrumStatus",
                             {{"no_equation", Piece::Status::no_equation},
                              {"none", Piece::Status::none},
                              {"all", Piece::Status::all},
                              {"conditions", Piece::Status::conditions},
                              {"degrees", Piece::Status::degrees},
                              {"open", Piece::Status::open}});
  bind_levels(m);
  bind_pieces(m);
  m.def("spectrum", [](const Limits& limits, const QuestionTexts& texts, const std::string& energy,
                       long levels) {
    if (levels < 0) throw InvalidArgument("levels: a number of 0 or more is expected");
    return computed(limits, [&](const Budget& budget, const Interrupt&) {
      return found(texts, energy, levels, budget);
    });
  });
}

} // namespace kov::python
