// classify(): for which parameters is a system integrable?

#include "bind.hpp"
#include "exact/joined.hpp"
#include "source.hpp"

#include "classify/classify.hpp"

#include <pybind11/stl.h>

namespace kov::python {
namespace {
/// A verdict by the words of a classification, where the undecided is open.
enum class ClassificationStatus : int {
  integrable = static_cast<int>(Verdict::integrable),
  non_integrable = static_cast<int>(Verdict::non_integrable),
  open = static_cast<int>(Verdict::undecided),
  depends = static_cast<int>(Verdict::depends)
};
} // namespace
} // namespace kov::python

namespace pybind11::detail {
KOV_PYTHON_ENUM(kov::StratumStatus, "StratumStatus");
KOV_PYTHON_ENUM(kov::python::ClassificationStatus, "ClassificationStatus");
} // namespace pybind11::detail

namespace kov::python {
namespace {

/// A reason that knows what it proves.
struct ReasonOf {
  ExclusionReason reason;
  std::string statement, integrals_class;
};

/// A stratum that knows what its classification assumes.
struct StratumOf {
  ClassifiedStratum stratum;
  std::vector<std::string> conditions;
  std::vector<ReasonOf> by;
};

StratumOf stratum_of(const SystemClassification& c, const ClassifiedStratum& s) {
  StratumOf of{s, conditions(c, s.where), {}};
  for (const ExclusionReason& by : s.by)
    of.by.push_back({by, statement(by), sentence(by.integrals)});
  return of;
}

std::vector<StratumOf> classified(const SystemClassification& c) {
  std::vector<StratumOf> all;
  for (const ClassifiedStratum& s : c.strata)
    all.push_back(stratum_of(c, s));
  return all;
}

std::string parameters_text(const std::vector<std::string>& all) {
  std::string text = joined(all);
  return text.empty() ? "all parameters" : text;
}

std::string stratum_text(const StratumOf& s) {
  std::string text = to_string(s.stratum.status) + "  " + parameters_text(s.conditions);
  for (const FoundIntegral& f : s.stratum.integrals)
    text += "\n  integral " + (f.hamiltonian ? std::string("H") : to_string(f));
  for (const std::string& y : s.stratum.fields)
    text += "\n  commuting field " + y;
  for (const auto& [by, statement, integrals] : s.by) {
    text += "\n  " + statement + "\n  along " + by.solution + ": " + by.reason;
    if (!by.unchecked.empty()) text += "\n  not checked: " + by.unchecked;
  }
  for (const std::string& tried : s.stratum.open_after)
    text += "\n  tried " + tried;
  return text;
}

std::string classification_text(const SystemClassification& c) {
  std::string text = statement(c);
  if (!c.assumptions.empty()) text += "\nassumed: " + parameters_text(c.assumptions);
  if (!c.variables.empty()) text += "\nwhere: " + parameters_text(c.variables);
  for (const StratumOf& s : classified(c))
    text += "\n" + stratum_text(s);
  for (const std::string& step : sentences(c.trusted))
    text += "\ntrusted: " + step;
  return text;
}

/// A property that shows a member of the reason.
template <class T> auto of_reason(T ExclusionReason::*member) {
  return [member](const ReasonOf& by) { return by.reason.*member; };
}

void bind_stratum(py::module_& m) {
  read_only<ReasonOf>(m, "ExclusionReason", "Why a system is not integrable somewhere.",
                      {"solution", "reason"})
      .def_property_readonly("solution", of_reason(&ExclusionReason::solution),
                             "the invariant manifold")
      .def_property_readonly("level", [](const ReasonOf& by) { return sentence(by.reason.level); })
      .def_property_readonly("order", of_reason(&ExclusionReason::order),
                             "of the variational equations")
      .def_property_readonly("reason", of_reason(&ExclusionReason::reason))
      .def_property_readonly("theorems",
                             [](const ReasonOf& by) { return theorem_names(by.reason.theorems); })
      .def_property_readonly("trusted",
                             [](const ReasonOf& by) { return sentences(by.reason.trusted); })
      .def_property_readonly("not_checked", of_reason(&ExclusionReason::unchecked),
                             "a hypothesis that is not proved, as a sentence; or empty")
      .def_readonly("statement", &ReasonOf::statement, "what it proves")
      .def_readonly("integrals_class", &ReasonOf::integrals_class,
                    "the first integrals that it excludes")
      .def("__repr__",
           [](const ReasonOf& by) { return "<ExclusionReason along " + by.reason.solution + ">"; });
  read_only<StratumOf>(m, "ClassifiedStratum", "Parameters with one answer.",
                       {"status", "conditions"})
      .def_readonly("conditions", &StratumOf::conditions, "empty: all parameters")
      .def_property_readonly("status", [](const StratumOf& s) { return s.stratum.status; })
      .def_property_readonly("integrals", [](const StratumOf& s) { return s.stratum.integrals; })
      .def_property_readonly(
          "fields", [](const StratumOf& s) { return s.stratum.fields; },
          "commuting fields, where they are needed beside the integrals: texts")
      .def_readonly("by", &StratumOf::by)
      .def_property_readonly("open_after", [](const StratumOf& s) { return s.stratum.open_after; })
      .def("__str__", [](const StratumOf& s) { return stratum_text(s); })
      .def("__repr__", [](const StratumOf& s) {
        return "<ClassifiedStratum " + to_string(s.stratum.status) + ": " +
               parameters_text(s.conditions) + ">";
      });
}

} // namespace

void bind_classification(py::module_& m) {
  enumeration<StratumStatus>(m, "StratumStatus",
                             {{"integrable", StratumStatus::integrable},
                              {"excluded", StratumStatus::excluded},
                              {"open", StratumStatus::open}});
  enumeration<ClassificationStatus>(m, "ClassificationStatus",
                                    {{"integrable", ClassificationStatus::integrable},
                                     {"non_integrable", ClassificationStatus::non_integrable},
                                     {"open", ClassificationStatus::open},
                                     {"depends", ClassificationStatus::depends}});
  bind_stratum(m);
  read_only<SystemClassification>(m, "Classification",
                                  "For which parameters a system is integrable: a theorem.",
                                  {"status", "strata"})
      .def_property_readonly("status",
                             [](const SystemClassification& c) {
                               return static_cast<ClassificationStatus>(c.status());
                             })
      .def_property_readonly(
          "statement", [](const SystemClassification& c) { return statement(c); }, "one sentence")
      .def_property_readonly("strata", &classified, "disjoint; they cover all parameters")
      .def_property_readonly(
          "integrals_class",
          [](const SystemClassification& c) -> std::optional<std::string> {
            if (c.excluded.empty()) return std::nullopt;
            return integrals_class(c);
          },
          "the first integrals that are excluded, or None")
      .def_property_readonly(
          "almost_all",
          [](const SystemClassification& c) -> std::optional<ReasonOf> {
            if (!c.almost_all) return std::nullopt;
            const ExclusionReason& by = c.almost_all->by;
            return ReasonOf{by, statement(by), sentence(by.integrals)};
          },
          "why it is not integrable for almost all parameters where a set of them stays open, or "
          "None")
      .def_readonly("assumptions", &SystemClassification::assumptions)
      .def_property_readonly(
          "theorems", [](const SystemClassification& c) { return theorem_names(c.theorems); })
      .def_property_readonly("trusted_steps",
                             [](const SystemClassification& c) { return sentences(c.trusted); })
      .def_property_readonly("notes",
                             [](const SystemClassification& c) { return sentences(c.notes); })
      .def_property_readonly(
          "stages",
          [](const SystemClassification& c) {
            std::vector<std::pair<std::string, double>> all;
            for (const Spent& s : c.spent)
              all.emplace_back(s.task, s.seconds);
            return all;
          },
          "(what, seconds)")
      .def_readonly("complete", &SystemClassification::complete,
                    "all of the work that was allowed is done; False: the clock ended it")
      .def_readonly("seconds", &SystemClassification::seconds)
      .def("__str__", [](const SystemClassification& c) { return classification_text(c); })
      .def("__repr__", [](const SystemClassification& c) {
        return "<Classification: " + status_word(c.status()) + ">";
      });
  m.def("classify", [](const Limits& limits, const Source& source, const ParameterValues& values,
                       std::optional<long> degree, bool search) {
    if (degree && *degree < 1) throw InvalidArgument("the degree of first integrals is at least 1");
    return computed(limits, [&](const Budget& budget, const Interrupt&) {
      ClassifyOptions options;
      options.check.decide.budget = budget;
      options.check.decide.budget.give_by_default();
      options.check.decide.ask_the_judge = true;
      if (degree) options.degree = options.degree_at_points = *degree;
      options.search_solutions = search;
      return classify_system(read_system(source.document(), values), options);
    });
  });
}

} // namespace kov::python
