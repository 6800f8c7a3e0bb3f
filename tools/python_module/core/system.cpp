// Systems: check() and integrals().

#include "bind.hpp"
#include "exact/joined.hpp"
#include "question.hpp"
#include "source.hpp"
#include "strata.hpp"

#include "equation/equation_file.hpp"
#include "integrability/matrices.hpp"
#include "integrals/find.hpp"
#include "study/headline_words.hpp"
#include "study/together.hpp"
#include "system/one_line.hpp"

#include <pybind11/stl.h>

#include <algorithm>

namespace pybind11::detail {
KOV_PYTHON_ENUM(kov::Verdict, "VerdictKind");
KOV_PYTHON_ENUM(kov::Settled, "Settled");
} // namespace pybind11::detail

namespace kov::python {
namespace {

using study::CurveStudy;
using study::SystemStudy;

py::object answer_of(const BlockReport& b) {
  if (b.decision) return py::cast(*b.decision);
  if (b.strata) return py::cast(FamilyAnswer(*b.strata));
  return py::none();
}

py::list levels_of(const BlockReport& b) {
  py::list all;
  for (const EnergyResult& e : b.energies) {
    py::object found = py::none();
    if (e.decision) found = py::cast(*e.decision);
    if (e.strata) found = py::cast(FamilyAnswer(*e.strata));
    all.append(py::make_tuple(sentence(e.at), why(e), found, note(e.missing)));
  }
  return all;
}

std::vector<std::string> texts(const std::vector<MPoly>& polynomials) {
  std::vector<std::string> all;
  for (const MPoly& f : polynomials)
    all.push_back(to_string(f));
  return all;
}

std::optional<std::string> unless_empty(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return text;
}

std::vector<std::string> notes(const ManifoldReport& m) {
  std::vector<std::string> all;
  if (m.manifold) all = m.manifold->rewritten;
  for (const Elimination& e : m.reduced.eliminations)
    all.push_back("the variation of " + e.unknown + " is taken away by the linear integral d" +
                  e.integral + " = 0");
  return all;
}

std::string said(const py::object& answer) { return "\n  " + py::str(answer).cast<std::string>(); }

std::string told(const BlockReport& b) {
  std::string text;
  if (b.ode) text += "\n  " + b.ode->change + ", y the variation of " + b.ode->unknown;
  if (b.decision || b.strata) text += said(answer_of(b));
  for (const MPoly& f : b.special)
    text += "\n  singular places meet where " + to_string(f) + " = 0";
  for (const EnergyResult& e : b.energies) {
    text += "\n  at " + sentence(e.at) + " (" + why(e) + ")";
    if (e.decision) text += said(py::cast(*e.decision));
    if (e.strata) text += said(py::cast(FamilyAnswer(*e.strata)));
    if (!e.missing.empty()) text += "\n  note: " + note(e.missing);
  }
  if (!b.missing.empty()) text += "\n  note: " + note(b.missing);
  return text;
}

std::string told(const CurveStudy& study) {
  const ManifoldReport& m = study.first;
  std::string text = "[" + m.name + "] " + one_line(in_words(study));
  if (m.failure) return text;
  if (const std::string open = not_checked(m);
      !open.empty() && (m.verdict != Verdict::undecided || m.by))
    text += "\n  NOT CHECKED: " + open;
  for (const std::string& note : notes(m))
    text += "\n  note: " + note;
  for (const BlockReport& b : m.blocks)
    text += told(b);
  if (m.blocks.empty() || m.matrices || m.verdict == Verdict::undecided)
    for (const std::string& r : reasons(m))
      text += "\n  because " + r;
  if (study.higher && study.higher->excluded)
    text += "\n  because " + study.higher->excluded->by.reason;
  if (m.verdict != Verdict::undecided)
    for (const std::string& step : sentences(trusted_steps(m)))
      text += "\n  trusted: " + step;
  return text;
}

// Of one manifold too.
SystemClassification all_together(const SystemStudy& study) {
  if (study.together) return *study.together;
  std::vector<Exclusion> all;
  for (const CurveStudy& m : study.manifolds)
    all.insert(all.end(), m.exclusions.begin(), m.exclusions.end());
  return together(study.system, all);
}

py::dict values_of(const System& s) {
  py::dict all;
  for (const auto& [name, value] : s.values)
    all[py::str(name)] = is_constant(value) ? to_python(to_rational(value)) : py::cast(value);
  return all;
}

std::vector<std::string> assumptions_of(const System& s) {
  std::vector<std::string> all;
  for (const Assumption& a : s.assumptions)
    all.push_back(a.text);
  return all;
}

py::dict certificates_of(const SystemStudy& report) {
  py::dict all;
  for (const CurveStudy& m : report.manifolds)
    for (const NamedCertificate& c : certificates(report.system, m))
      if (!c.json.empty()) all[py::str(c.name)] = c.json;
  return all;
}

py::object checked(const Wishes& wishes, const Source& source, const ParameterValues& values,
                   const std::string& manifold, int order, const std::vector<std::string>& assume) {
  const Entry document = source.document();
  if (is_equation_file(document)) {
    AskedEquation asked = read_equation_file(document).asked;
    for (const auto& [name, value] : values)
      asked.text.set.emplace_back(name, parse_expression(value, "set[" + name + "]"));
    add_assumptions(asked.text, assumed_texts(assume, "assume"));
    return answer(wishes, asked);
  }
  if (!assume.empty())
    throw InvalidArgument("the assumptions on a system stand in its file, under [assume]");
  if (order < 1 || order > jets::largest_order)
    throw InvalidArgument("order: 1 to " + std::to_string(jets::largest_order) +
                          " is expected, and not " + std::to_string(order));
  return computed(wishes.limits, [&](const Budget& budget, const Interrupt&) {
    study::StudyOptions options;
    options.check.decide = wishes.options(budget);
    options.check.decide.ask_the_judge = true;
    options.check.only_manifold = manifold;
    options.order = order;
    return study::study(document, values, options);
  });
}

void bind_theorem_used(py::module_& m) {
  enumeration<Settled>(
      m, "Settled",
      {{"checked", Settled::checked}, {"stated", Settled::stated}, {"open", Settled::open}});
  read_only<TheoremHypothesis>(m, "TheoremHypothesis", "A hypothesis, and how a use settles it.")
      .def_readonly("text", &TheoremHypothesis::text)
      .def_readonly("settled", &TheoremHypothesis::settled)
      .def_readonly("how", &TheoremHypothesis::how)
      .def("__repr__", [](const TheoremHypothesis& h) { return "<" + h.text + ">"; });
  read_only<TheoremUsed>(m, "TheoremUsed", "One use of a theorem of the literature.", {"id"})
      .def_property_readonly("id", &TheoremUsed::id)
      .def_property_readonly("name", [](const TheoremUsed& t) { return t.theorem->name; })
      .def_property_readonly("statement", [](const TheoremUsed& t) { return t.theorem->statement; })
      .def_property_readonly("cite", [](const TheoremUsed& t) { return t.theorem->cite; })
      .def_readonly("hypotheses", &TheoremUsed::hypotheses)
      .def_property_readonly(
          "integrals", [](const TheoremUsed& t) { return sentence(t.integrals); },
          "the first integrals that it excludes are ...")
      .def("__repr__", [](const TheoremUsed& t) { return "<TheoremUsed " + t.id() + ">"; });
}

void bind_reports(py::module_& m) {
  enumeration<Verdict>(m, "VerdictKind",
                       {{"non_integrable", Verdict::non_integrable},
                        {"no_obstruction", Verdict::no_obstruction},
                        {"depends", Verdict::depends},
                        {"undecided", Verdict::undecided},
                        {"integrable", Verdict::integrable},
                        {"failed", Verdict::failed}});

  auto block = read_only<BlockReport>(m, "BlockReport", "A diagonal block of the normal system.",
                                      {"answer"});
  block.def_readonly("unknowns", &BlockReport::unknowns)
      .def_property_readonly(
          "unknown", [](const BlockReport& b) { return unless_empty(b.ode ? b.ode->unknown : ""); },
          "whose variation y is")
      .def_property_readonly(
          "change", [](const BlockReport& b) { return unless_empty(b.ode ? b.ode->change : ""); })
      .def_property_readonly("r",
                             [](const BlockReport& b) -> std::optional<MFraction> {
                               if (!b.ode) return std::nullopt;
                               return b.ode->r;
                             })
      .def_property_readonly("answer", &answer_of, "Decision, StrataAnswer, or None")
      .def_readonly("abelian", &BlockReport::abelian)
      .def_property_readonly(
          "merging", [](const BlockReport& b) { return texts(b.special); },
          "singular places of r meet where one of these is 0")
      .def_property_readonly("levels", &levels_of, "(condition, why, answer, note)")
      .def_property_readonly("note", [](const BlockReport& b) { return note(b.missing); });

  auto manifold =
      read_only<CurveStudy>(m, "ManifoldReport", "What follows from one manifold.", {"verdict"});
  manifold.def_property_readonly("name", &CurveStudy::name)
      .def_property_readonly("verdict", [](const CurveStudy& c) { return c.headline.verdict; })
      .def_property_readonly(
          "failure",
          [](const CurveStudy& c) {
            return unless_empty(c.first.failure ? c.first.failure->message : "");
          },
          "why it is not an invariant manifold, or None")
      .def_property_readonly(
          "by", [](const CurveStudy& c) { return c.first.by; }, "the theorem used, or None")
      .def_property_readonly(
          "integrals",
          [](const CurveStudy& c) {
            return c.headline.excluded.empty() ? "meromorphic" : sentence(c.headline.excluded);
          },
          "the class of first integrals that is excluded")
      .def_property_readonly("statement", [](const CurveStudy& c) { return statement(c.first); })
      .def_property_readonly(
          "not_checked", [](const CurveStudy& c) { return unless_empty(not_checked(c.first)); },
          "a hypothesis of the verdict that is not proved, or None")
      .def_property_readonly("reasons", [](const CurveStudy& c) { return reasons(c.first); })
      .def_property_readonly("blocks", [](const CurveStudy& c) { return c.first.blocks; })
      .def_property_readonly(
          "matrices",
          [](const CurveStudy& c) {
            return unless_empty(c.first.matrices ? reason(*c.first.matrices) : "");
          },
          "what monodromy matrices prove of the whole variational equation, "
          "where the blocks decide nothing")
      .def_property_readonly(
          "notes", [](const CurveStudy& c) { return notes(c.first); },
          "how the manifold and its equations were read")
      .def_property_readonly("trusted_steps",
                             [](const CurveStudy& c) { return sentences(trusted_steps(c.first)); })
      .def_property_readonly("not_studied",
                             [](const CurveStudy& c) {
                               return c.first.left_out ? std::optional(sentence(*c.first.left_out))
                                                       : std::nullopt;
                             })
      .def_property_readonly("headline", [](const CurveStudy& c) { return one_line(in_words(c)); })
      .def("__str__", [](const CurveStudy& c) { return told(c); })
      .def("__repr__", [](const CurveStudy& c) {
        return "<ManifoldReport " + c.name() + ": " + to_string(c.headline.verdict) + ">";
      });

  read_only<ClaimReport>(m, "ClaimReport", "A claim of the file, proved or refuted.")
      .def_property_readonly("name", [](const ClaimReport& c) { return c.claim.name; })
      .def_property_readonly("text", [](const ClaimReport& c) { return c.claim.text; })
      .def_property_readonly(
          "proved",
          [](const ClaimReport& c) {
            return c.result.open.empty() ? truth(c.result.proved) : Truth::unknown;
          },
          "a Truth")
      .def_property_readonly("detail", [](const ClaimReport& c) { return c.result.detail; })
      .def_property_readonly(
          "generic", [](const ClaimReport& c) { return texts(c.result.generic); },
          "proved where none of these vanishes")
      .def("__repr__",
           [](const ClaimReport& c) { return "<" + c.claim.name + ": " + c.result.detail + ">"; });

  auto report = read_only<SystemStudy>(m, "CheckReport", "A system file and what follows from it.",
                                       {"verdict"});
  report.def_property_readonly("verdict", [](const SystemStudy& r) { return r.headline.verdict; })
      .def_property_readonly(
          "complete", [](const SystemStudy& r) { return r.headline.complete; },
          "no limit and no error of the program ended a part of it")
      .def_property_readonly(
          "integrals",
          [](const SystemStudy& r) {
            return r.headline.excluded.empty() ? std::optional<std::string>()
                                               : sentence(r.headline.excluded);
          },
          "the class of first integrals that is excluded, or None")
      .def_property_readonly("title", [](const SystemStudy& r) { return r.system.title; })
      .def_property_readonly("file", [](const SystemStudy& r) { return r.system.file; })
      .def_property_readonly(
          "values", [](const SystemStudy& r) { return values_of(r.system); }, "of parameters")
      .def_property_readonly("assumptions",
                             [](const SystemStudy& r) { return assumptions_of(r.system); })
      .def_readonly("claims", &SystemStudy::claims)
      .def_readonly("manifolds", &SystemStudy::manifolds)
      .def_property_readonly("together", &all_together,
                             "what the manifolds exclude together: a Classification")
      .def_property_readonly("certificates", &certificates_of,
                             "by name, if they were asked for: JSON for verify()")
      .def_readonly("seconds", &SystemStudy::seconds)
      .def("__str__",
           [](const SystemStudy& r) {
             std::string text = r.system.title;
             for (const CurveStudy& each : r.manifolds)
               text += "\n" + told(each);
             if (r.manifolds.empty()) text += "\nno [[manifold]]: nothing was asked";
             return text;
           })
      .def("__repr__", [](const SystemStudy& r) {
        return "<CheckReport: " + to_string(r.headline.verdict) + ">";
      });
}

std::vector<MFraction> values_of(const IntegralsOfSet& s) {
  std::vector<MFraction> all;
  for (const FoundIntegral& f : s.integrals)
    all.push_back(f.value);
  return all;
}

void bind_integrals(py::module_& m) {
  read_only<FoundIntegral>(m, "FoundIntegral", "A first integral, checked by its Lie derivative.",
                           {"value"})
      .def_readonly("value", &FoundIntegral::value, "without the logarithms")
      .def_property_readonly(
          "logarithms",
          [](const FoundIntegral& f) {
            std::vector<std::pair<MFraction, MFraction>> all;
            for (const LogarithmicTerm& t : f.logarithms)
              all.emplace_back(t.times, MFraction(t.of));
            return all;
          },
          "pairs (c, f): the sum of c*log(f) is to be added to the value")
      .def_readonly("degree", &FoundIntegral::degree)
      .def_readonly("casimir", &FoundIntegral::casimir)
      .def_readonly("hamiltonian", &FoundIntegral::hamiltonian)
      .def("__repr__",
           [](const FoundIntegral& f) { return "<FoundIntegral " + to_string(f) + ">"; });
  read_only<IntegralsOfSet>(m, "IntegralsOfSet", "What is known at these parameter values.",
                            {"integrals"})
      .def_readonly("searched", &IntegralsOfSet::searched)
      .def_property_readonly("equations",
                             [](const IntegralsOfSet& s) { return texts(s.equations); })
      .def_property_readonly("inequations",
                             [](const IntegralsOfSet& s) { return texts(s.inequations); })
      .def_readonly("integrals", &IntegralsOfSet::integrals)
      .def_property_readonly("values", [](const IntegralsOfSet& s) { return values_of(s); })
      .def_readonly("commuting", &IntegralsOfSet::commuting)
      .def_readonly("liouville", &IntegralsOfSet::liouville)
      .def_readonly("only_declared_relations", &IntegralsOfSet::only_declared_relations)
      .def_readonly("complete", &IntegralsOfSet::complete)
      .def_readonly("complete_for_smooth", &IntegralsOfSet::complete_for_smooth)
      .def_property_readonly(
          "open", [](const IntegralsOfSet& s) { return unless_empty(s.open); },
          "why the search ended early, or None")
      .def("__repr__", [](const IntegralsOfSet& s) {
        std::string text =
            joined(s.equations, [&](const MPoly& f) { return to_string(f) + " = 0"; });
        for (const MPoly& f : s.inequations)
          text += (text.empty() ? "" : ", ") + to_string(f) + " != 0";
        return "<IntegralsOfSet " + (text.empty() ? "everywhere" : text) + ": " +
               std::to_string(s.integrals.size()) + ">";
      });
  read_only<IntegralSearch>(m, "IntegralSearch", "First integrals, at all parameter values.",
                            {"sets"})
      .def_readonly("searched", &IntegralSearch::searched)
      .def_readonly("sets", &IntegralSearch::sets, "disjoint")
      .def_readonly("elsewhere", &IntegralSearch::elsewhere,
                    "at all other values: nothing but the Hamiltonian and Casimirs was found")
      .def_property_readonly(
          "not_covered", [](const IntegralSearch& s) { return texts(s.not_covered); },
          "nothing is said where one of these vanishes")
      .def_property_readonly(
          "assumed", [](const IntegralSearch& s) { return texts(s.assumed); },
          "assumed by the file: none of these vanishes")
      .def_property_readonly(
          "assumed_equations", [](const IntegralSearch& s) { return texts(s.assumed_equations); },
          "assumed by the file: all of these vanish")
      .def_property_readonly("finished", &IntegralSearch::finished);
}

} // namespace

void bind_system(py::module_& m) {
  m.def("one_line", [](const std::string& given, const std::string& name) {
    const bool hamiltonian = name == "H";
    const OneLine line = read_one_line(
        given, hamiltonian ? Mechanics::hamiltonian : Mechanics::lagrangian, {}, name);
    const Entry system = parse_document(line.text, name).at("system");
    return py::make_tuple(system.at(hamiltonian ? "hamiltonian" : "lagrangian").string(),
                          line.letters.coordinates, line.letters.rates);
  });
  bind_theorem_used(m);
  bind_reports(m);
  bind_integrals(m);
  py::class_<Source>(m, "Source")
      .def(py::init([](std::string text, std::string name) {
             return Source{std::move(text), std::move(name)};
           }),
           py::arg("text"), py::arg("name"));
  m.def("check", &checked, py::arg("wishes"), py::arg("source"), py::arg("set"),
        py::arg("manifold"), py::arg("order"), py::arg("assume"));
  m.def("integrals", [](const Limits& limits, const Source& source, const ParameterValues& values,
                        long degree, std::optional<long> coefficients) {
    if (degree < 0 || (coefficients && *coefficients < 0))
      throw InvalidArgument("a degree must not be negative");
    return computed(limits, [&](const Budget& budget, const Interrupt&) {
      IntegralOptions options;
      options.degree = degree;
      options.coefficients = coefficients;
      options.budget = budget;
      options.budget.give_by_default();
      return find_integrals(read_system(source.document(), values), options);
    });
  });
}

} // namespace kov::python
