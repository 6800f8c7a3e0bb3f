// Theorem files: prove().  Certificates: verify().  Lame's equation.

#include "bind.hpp"
#include "question.hpp"

#include "answer/solve.hpp"
#include "certify/equation/statement.hpp"
#include "certify/system/check.hpp"
#include "equations/lame_question.hpp"
#include "report/render_theorem.hpp"
#include "theorem/prove.hpp"

#include <pybind11/stl.h>

namespace pybind11::detail {
KOV_PYTHON_ENUM(kov::NodeStatus, "NodeStatus");
} // namespace pybind11::detail

namespace kov::python {
namespace {

TheoremResult proved(const std::string& path, const Options& options) {
  ProveOptions how;
  how.decide = options;
  how.decide.ask_the_judge = true;
  return prove(read_theorem(read_document(path)), how);
}

void bind_prove(py::module_& m) {
  enumeration<NodeStatus>(m, "NodeStatus",
                          {{"proved", NodeStatus::proved},
                           {"partial", NodeStatus::partial},
                           {"trusted", NodeStatus::trusted},
                           {"reasoned", NodeStatus::reasoned},
                           {"unbound", NodeStatus::unbound},
                           {"open", NodeStatus::open},
                           {"refuted", NodeStatus::refuted}});
  read_only<NodeResult>(m, "NodeResult", "A step of a theorem, and what was found.", {"status"})
      .def_property_readonly("id", [](const NodeResult& n) { return n.node.id; })
      .def_property_readonly("title", [](const NodeResult& n) { return n.node.title; })
      .def_property_readonly("kind", [](const NodeResult& n) { return to_string(n.node.kind); })
      .def_property_readonly("needs", [](const NodeResult& n) { return n.node.needs; })
      .def_readonly("status", &NodeResult::status)
      .def_readonly("statement", &NodeResult::statement, "what was computed, in words")
      .def_readonly("summary", &NodeResult::summary)
      .def_readonly("rests_on_open", &NodeResult::rests_on_open)
      .def_readonly("steps_on_trust", &NodeResult::steps_on_trust,
                    "how many steps on trust it rests on, itself and all that it needs")
      .def_readonly("integrals", &NodeResult::integrals)
      .def_property_readonly(
          "excluded",
          [](const NodeResult& n) {
            std::vector<std::string> classes;
            for (const IntegralClass& c : n.excluded)
              classes.push_back(sentence(c));
            return classes;
          },
          "classes of first integrals")
      .def_readonly("theorems", &NodeResult::theorems)
      .def_property_readonly("trusted", [](const NodeResult& n) { return sentences(n.trusted); })
      .def_readonly("certificates", &NodeResult::certificates)
      .def_readonly("seconds", &NodeResult::seconds)
      .def("__repr__", [](const NodeResult& n) {
        return "<NodeResult " + n.node.id + ": " + status_of(n) + ">";
      });
  const auto whole_text = [](const TheoremResult& t) { return report::theorem_text(t); };
  read_only<TheoremResult>(m, "TheoremResult", "A theorem as a tree of lemmas, and what was found.",
                           {"complete"})
      .def_property_readonly("title", [](const TheoremResult& t) { return t.theorem.title; })
      .def_readonly("nodes", &TheoremResult::nodes)
      .def_property_readonly("statement", &TheoremResult::statement,
                             "what is proved; empty while it is not")
      .def_property_readonly("verdict", &TheoremResult::verdict)
      .def_property_readonly("conclusion", &TheoremResult::conclusion)
      .def_property_readonly("complete", &TheoremResult::complete,
                             "a bool: every step is proved here or a theorem of the literature")
      .def_property_readonly("theorems", &TheoremResult::uses)
      .def_property_readonly("trusted_steps", &TheoremResult::trusted_steps)
      .def_property_readonly("unchecked_hypotheses", &TheoremResult::unchecked_hypotheses)
      .def_readonly("seconds", &TheoremResult::seconds)
      .def("text", whole_text, R"(As `kovacic prove` prints it.

    >>> theorem.text().splitlines()[2][:6]
    'PROVED'
)")
      .def("json", &report::theorem_json, R"(The report kovacic-proof/1.

    >>> import json
    >>> json.loads(theorem.json())["format"]
    'kovacic-proof/1'
)")
      .def("tex", &report::theorem_tex, R"(An article in LaTeX.

    >>> theorem.tex().splitlines()[0]
    '\\documentclass[11pt]{article}'
)")
      .def("html", &report::theorem_html, R"(One page, without scripts.

    >>> theorem.html()[:15]
    '<!DOCTYPE html>'
)")
      .def("__str__", whole_text)
      .def("__repr__",
           [](const TheoremResult& t) { return "<TheoremResult: " + t.conclusion() + ">"; });
  m.def("prove", [](const Wishes& wishes, const std::string& path) {
    return computed(wishes.limits, [&](const Budget& budget, const Interrupt&) {
      return proved(path, wishes.options(budget));
    });
  });
}

// ---- certificates

struct Accepted {
  std::size_t trusted_steps = 0;
  std::vector<std::string> statement;
};

std::variant<Accepted, certify::Rejected> judged(const std::string& text) {
  if (certify::format_of(text) == "kovacic-strata/1") {
    const auto c = certify::read_strata_certificate(text);
    const auto verdict = certify::check_strata(c);
    if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return *no;
    const auto& yes = std::get<certify::StrataAccepted>(verdict);
    return Accepted{yes.trusted, certify::statement(c, yes)};
  }
  if (certify::format_of(text) == "kovacic-system/1") {
    const auto c = certify::read_system_certificate(text);
    const auto verdict = certify::check_way(c);
    if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return *no;
    const auto& yes = std::get<certify::SystemAccepted>(verdict);
    return Accepted{yes.trusted, certify::statement(c, yes)};
  }
  const auto c = certify::read_certificate(text);
  const auto verdict = certify::check(c);
  if (const auto* no = std::get_if<certify::Rejected>(&verdict)) return *no;
  return Accepted{std::get<certify::Accepted>(verdict).trusted_steps, certify::statement(c)};
}

void bind_verify(py::module_& m) {
  read_only<Accepted>(m, "Accepted", "The checker accepts: `statement` follows.",
                      {"statement", "trusted_steps"})
      .def_readonly("trusted_steps", &Accepted::trusted_steps, "steps taken on faith")
      .def_readonly("statement", &Accepted::statement)
      .def("__str__",
           [](const Accepted& a) {
             std::string text = "accepted, " + std::to_string(a.trusted_steps) + " trusted steps";
             for (const std::string& line : a.statement)
               text += "\n  " + line;
             return text;
           })
      .def("__repr__", [](const Accepted& a) {
        return "<Accepted, " + std::to_string(a.trusted_steps) + " trusted steps>";
      });
  read_only<certify::Rejected>(m, "Rejected", "The checker refuses, and says where.",
                               {"step", "why"})
      .def_readonly("step", &certify::Rejected::step)
      .def_readonly("why", &certify::Rejected::why)
      .def_readonly("limit", &certify::Rejected::limit,
                    "only a size: nothing in it was found to be false")
      .def("__repr__", [](const certify::Rejected& r) {
        return "<Rejected at '" + r.step + "': " + r.why + ">";
      });
  m.def("verify", [](const std::string& text) {
    return computed(Limits{}, [&](const Budget&, const Interrupt&) { return judged(text); });
  });
}

// ---- Lame's equation

using LameNumbers = answer::DecidedTwice;
using LameFamilies = std::vector<LameFamily>;

std::variant<LameNumbers, LameConditions, LameFamilies> lame(const cli::LameQuestion& q,
                                                             const Options& wished) {
  if (!q.degree.alpha) return lame_families();
  const NfElem& alpha = *q.degree.alpha;
  if (const auto* p = std::get_if<LameParameters<NfElem>>(&q.parameters)) {
    Options options = wished;
    options.variable = "x";
    return answer::decided_twice(lame_answer(alpha, *p, options.budget), lame_equation(alpha, *p),
                                 options);
  }
  LameConditions c = lame_conditions(
      lame_index(alpha), std::get<LameParameters<MFraction>>(q.parameters), wished.budget);
  if (is_zero(c.discriminant))
    throw InvalidArgument("g2^3 = 27 g3^2 here: the curve is degenerate, and the conditions say "
                          "nothing; give numbers, or see the command kovacic lame");
  return c;
}

// For all values of the free names at once.
Truth abelian(const LameConditions& c) {
  if (!is_constant(c.discriminant) || is_zero(c.discriminant)) return Truth::unknown;
  return c.always() ? Truth::yes : c.never() ? Truth::no : Truth::unknown;
}

std::vector<MFraction> fractions(const std::vector<MPoly>& all) { return {all.begin(), all.end()}; }

void bind_lame(py::module_& m) {
  read_only<LameNumbers>(m, "LameAnswer", "Lame's equation with numbers: two independent answers.",
                         {"abelian", "group"})
      .def("__repr__", [](const LameNumbers& n) { return "<LameAnswer: " + n.closed.reason + ">"; })
      .def_readonly("decision", &LameNumbers::decision, "of the engines, on y'' = r(x) y")
      .def_property_readonly("abelian", &LameNumbers::abelian)
      .def_property_readonly("group", &LameNumbers::group)
      .def_property_readonly(
          "closed", [](const LameNumbers& n) { return n.closed.reason; },
          "what the closed formula says");
  read_only<LameConditions>(
      m, "LameConditions",
      "Where g2^3 != 27 g3^2: the identity component is abelian exactly where all of "
      "`polynomials` vanish.  Nothing is said where `discriminant` or a denominator of B, g2, g3 "
      "vanishes.",
      {"polynomials", "discriminant"})
      .def("__repr__",
           [](const LameConditions& c) {
             std::string text = c.always() ? "always" : c.never() ? "never" : "where";
             if (!c.always() && !c.never())
               for (const MPoly& f : c.abelian)
                 text += (text == "where" ? " " : ", ") + brief(MFraction(f)) + " = 0";
             return "<LameConditions: abelian " + text + ", if " +
                    brief(MFraction(c.discriminant)) + " != 0>";
           })
      .def_property_readonly("n", [](const LameConditions& c) { return c.index.n; })
      .def_property_readonly("discriminant",
                             [](const LameConditions& c) { return MFraction(c.discriminant); })
      .def_property_readonly(
          "polynomials", [](const LameConditions& c) { return fractions(c.abelian); },
          "empty: always; [1]: never")
      .def_property_readonly("always", &LameConditions::always)
      .def_property_readonly("never", &LameConditions::never)
      .def_property_readonly("abelian", &abelian, "for all values at once, or unknown")
      .def_property_readonly(
          "reducible",
          [](const LameConditions& c) -> std::optional<MFraction> {
            if (!c.reducible) return std::nullopt;
            return MFraction(*c.reducible);
          },
          "n an integer: the group is T_4 exactly where this vanishes")
      .def_property_readonly("octahedral",
                             [](const LameConditions& c) { return fractions(c.octahedral); });
  read_only<LameFamily>(m, "LameFamily",
                        "(2n+1)^2 = (numerator j/denominator)^2, j = 1, 2, ..., is a value that "
                        "leaves a chance; no value outside these families does.")
      .def_readonly("numerator", &LameFamily::numerator)
      .def_readonly("denominator", &LameFamily::denominator)
      .def_readonly("which", &LameFamily::which)
      .def("__repr__", [](const LameFamily& f) {
        return "<LameFamily (" + std::to_string(f.numerator) + "*j/" +
               std::to_string(f.denominator) + ")^2, " + f.which + ">";
      });
  using Text = std::optional<std::string>;
  m.def("lame", [](const Wishes& wishes, const Text& n, const Text& alpha, const Text& b,
                   const Text& g2, const Text& g3) {
    const auto formula = [](const char* name, const Text& text) -> std::optional<Expression> {
      if (!text) return std::nullopt;
      return parse_expression(*text, name);
    };
    const cli::LameQuestion question = cli::read_lame({formula("n", n),
                                                       formula("alpha", alpha),
                                                       formula("B", b),
                                                       formula("g2", g2),
                                                       formula("g3", g3),
                                                       {}});
    return computed(wishes.limits, [&](const Budget& budget, const Interrupt&) {
      return lame(question, wishes.options(budget));
    });
  });
}

} // namespace

void bind_theorem(py::module_& m) {
  bind_prove(m);
  bind_verify(m);
  bind_lame(m);
}

} // namespace kov::python
