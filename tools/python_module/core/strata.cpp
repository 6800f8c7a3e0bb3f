// Families of equations: the tree of strata, each with its verdict and its evidence.

#include "strata.hpp"
#include "answer/notation.hpp"
#include "bind.hpp"
#include "decide/afterwards.hpp"
#include "decide/words.hpp"
#include "exact/joined.hpp"
#include "strata/certificate.hpp"
#include "strata/domain.hpp"
#include "strata/words.hpp"
#include "symbol/written.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <set>

namespace kov::python {

FamilyAnswer::FamilyAnswer(answer::Family family, std::size_t place)
    : all(std::move(family)), at(place) {}

FamilyAnswer::FamilyAnswer(answer::Family family) : all(std::move(family)) {
  while (at < all.parts.size() && !part().answer)
    ++at;
  if (at < all.parts.size()) return;
  const EquationPart& first = all.parts.front().part;
  throw InvalidArgument("where " + answer::in_words(first) + ": " + first.none + first.open);
}

FamilyAnswer::FamilyAnswer(strata::StrataAnswer answer)
    : all{{answer::FamilyPart{{}, {}, std::move(answer)}}, true} {}

namespace {

using strata::Leaf;
using strata::StrataAnswer;
using strata::Stratum;

// The strata; nothing is said where there is no equation.
std::vector<Stratum> asked(const StrataAnswer& a) { return strata::on_domain(a).told_apart(); }

std::vector<std::string> assumed(const StrataAnswer& a) {
  return a.question ? in_words(a.question->assumptions, a.question->r.ring())
                    : std::vector<std::string>{};
}

std::string place_text(const Leaf& leaf, strata::PlaceIndex i) {
  if (!leaf.scheme) return "place " + std::to_string(i);
  const auto& place = strata::place_at(*leaf.scheme, i);
  return place.at_infinity ? "infinity" : to_string(place.q) + " = 0";
}

// Values of kovacic._evidence, by the name of the C++ type.
class EvidenceOf {
public:
  explicit EvidenceOf(const Leaf& leaf)
      : leaf_(leaf), classes_(py::module_::import("kovacic._evidence")) {}

  py::object operator()(const strata::IrregularPlace& e) const {
    return make("IrregularPlace", at(e.place));
  }
  py::object operator()(const strata::IrrationalDifference& e) const {
    return make("IrrationalDifference", at(e.place));
  }
  py::object operator()(const strata::Logarithm& e) const { return make("Logarithm", at(e.place)); }
  py::object operator()(const strata::DifferenceBound& e) const {
    return make("DifferenceBound", at(e.place), e.square);
  }
  py::object operator()(const strata::ExcludedDifferences& e) const {
    return make("ExcludedDifferences", at(e.place), e.values);
  }
  py::object operator()(const strata::NoProducts& e) const {
    return make("NoProducts", at(e.place));
  }
  py::object operator()(const strata::AssumedNotInteger& e) const {
    return make("AssumedNotInteger", at(e.place), e.twice);
  }
  py::object operator()(const strata::SeparatedNowhere& e) const {
    py::list pair;
    for (const strata::PlaceIndex i : e.pair)
      pair.append(at(i));
    return make("SeparatedNowhere", pair, at(e.third));
  }
  py::object operator()(const strata::NoExponential& e) const {
    return make("NoExponential", e.bound.d, e.bound.odd_order);
  }
  py::object operator()(const strata::NoFamilies&) const { return make("NoFamilies"); }
  py::object operator()(const strata::NoInvariant& e) const { return make("NoInvariant", e.m); }
  py::object operator()(const strata::ExponentialFound& e) const {
    return make("ExponentialFound", e.w);
  }
  py::object operator()(const strata::InvariantFound&) const { return make("InvariantFound"); }
  py::object operator()(const strata::ClassicalForm& e) const {
    py::dict squares;
    for (const auto& [name, square] : e.squares)
      squares[py::str(name)] = square;
    py::dict values;
    for (const auto& [name, value] : e.values)
      values[py::str(name)] = value;
    return make("ClassicalForm", to_string(e.family), squares, values, e.centre, e.power);
  }
  py::object operator()(const strata::ConditionFails&) const { return make("ConditionFails"); }
  py::object operator()(const strata::Number& e) const { return make("Number", e.decision); }
  py::object operator()(const strata::OtherBlocks& e) const { return make("OtherBlocks", e.shown); }
  py::object operator()(const strata::OfEquation& e) const {
    return make("OfEquation", e.unknown, e.r);
  }

private:
  [[nodiscard]] std::string at(strata::PlaceIndex i) const { return place_text(leaf_, i); }
  template <class... Values> py::object make(const char* name, const Values&... values) const {
    return classes_.attr(name)(values...);
  }
  const Leaf& leaf_;
  py::module_ classes_;
};

py::list because(const Leaf& leaf) {
  py::list all;
  const EvidenceOf evidence(leaf);
  for (const strata::Evidence& e : leaf.because)
    all.append(std::visit(evidence, e));
  return all;
}

std::string where(const Stratum& s) {
  std::string text = joined(strata::condition_texts(s));
  return text.empty() ? "always" : text;
}

const char* word(Truth t) {
  return t == Truth::yes ? "abelian" : t == Truth::no ? "not abelian" : "abelian or not: undecided";
}

std::string told(const Stratum& s) {
  if (s.leaf.no_equation())
    return where(s) + ": no equation y'' = r y: " + strata::open_condition(s.leaf);
  const std::string group = strata::group_text(s.leaf);
  return where(s) + ": " + (group.empty() ? "" : group + ", ") + word(s.leaf.abelian) + "; " +
         strata::reason(s.leaf);
}

std::string told(const FamilyAnswer& a) {
  std::string text;
  for (const std::string& c : assumed(a.answer()))
    text += (text.empty() ? "assumed " : ", ") + c;
  if (!text.empty()) text += "\n";
  if (a.answer().contradictory) text += "no parameters satisfy the assumptions\n";
  for (const std::string& c : in_words(strata::domain(a.answer())))
    text += "there is no equation unless " + c + "\n";
  for (const Stratum& s : asked(a.answer()))
    text += told(s) + "\n";
  for (const std::string& u : a.answer().unvisited)
    text += u + ": not looked at\n";
  for (const answer::FamilyPart& p : a.all.parts)
    if (&p != &a.part()) text += "where " + answer::in_words(p.part) + ": another equation\n";
  if (a.all.known)
    text += "recognised: " + a.all.known->equation + "; " + a.all.known->summary() + "\n";
  for (const std::string& t : sentences(a.answer().trusted))
    text += "trusted: " + t + "\n";
  if (!a.answer().refusal.empty())
    text += "refused by our own checker: " + a.answer().refusal + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

std::optional<Stratum> stratum_at_values(const StrataAnswer& a,
                                         const std::map<std::string, Rational>& values) {
  std::map<std::size_t, Rational> point;
  for (const auto& [name, value] : values)
    point.emplace(a.question->r.ring()->index(name), value);
  const Stratum* found = strata::stratum_at(a, point);
  if (found == nullptr) return std::nullopt;
  return *found;
}

void bind_family(py::module_& m) {
  using Family = strata::GenericForm;
  py::class_<Family>(m, "SymbolicFamily",
                     "The classical family, with its classical criterion as conditions; valid "
                     "where none of `generic` vanishes.")
      .def_property_readonly("family",
                             [](const Family& f) { return to_string(f.answer.form.family); })
      .def_readonly("equation", &Family::equation)
      .def_property_readonly("parameters",
                             [](const Family& f) {
                               py::dict all;
                               for (const auto& [name, value] : f.numbers)
                                 all[py::str(name)] = value;
                               return all;
                             })
      .def_property_readonly(
          "cases",
          [](const Family& f) {
            py::list all;
            for (const strata::Part& p : f.answer.parts)
              all.append(py::make_tuple(strata::in_words(p),
                                        p.group ? std::optional(p.group->type) : std::nullopt,
                                        p.abelian));
            return all;
          },
          "(when, group type or None, abelian)")
      .def_property_readonly("generic",
                             [](const Family& f) {
                               std::vector<MFraction> all(f.generic.begin(), f.generic.end());
                               return all;
                             })
      .def_property_readonly("summary", &Family::summary);
}

void bind_stratum(py::module_& m) {
  auto type =
      read_only<Stratum>(m, "Stratum", "Parameter values with one verdict.", {"abelian", "group"});
  type.def_property_readonly("conditions", &strata::condition_texts,
                             "in the parameters; empty: always")
      .def_property_readonly("where", &where)
      .def_property_readonly("abelian", [](const Stratum& s) { return s.leaf.abelian; })
      .def_property_readonly(
          "group", [](const Stratum& s) { return s.leaf.group; },
          "where it is the same on the whole stratum, else None")
      .def_property_readonly(
          "group_text", [](const Stratum& s) { return group_text(s.leaf); },
          "what is known of the group, in words")
      .def_property_readonly("reason", [](const Stratum& s) { return strata::reason(s.leaf); })
      .def_property_readonly("because", [](const Stratum& s) { return because(s.leaf); })
      .def_property_readonly(
          "undecided",
          [](const Stratum& s) -> std::optional<std::string> {
            if (!s.leaf.open) return std::nullopt;
            return strata::open_condition(s.leaf);
          },
          "what is left open, or None")
      .def_property_readonly(
          "no_equation", [](const Stratum& s) { return s.leaf.no_equation(); },
          "r means nothing here")
      .def_property_readonly("trace",
                             [](const Stratum& s) {
                               py::list all;
                               for (const kovacic::Step& t : s.leaf.trace)
                                 all.append(py::make_tuple(name(t), t.text));
                               return all;
                             })
      .def("__str__", [](const Stratum& s) { return told(s); })
      .def("__repr__", [](const Stratum& s) {
        return "<Stratum " + where(s) + ": " + word(s.leaf.abelian) + ">";
      });
}

// (where, answer or None) of the other parts.
py::list elsewhere(const FamilyAnswer& a) {
  py::list others;
  for (std::size_t i = 0; i < a.all.parts.size(); ++i) {
    const answer::FamilyPart& p = a.all.parts[i];
    if (i == a.at) continue;
    const py::object found =
        p.answer ? py::cast(FamilyAnswer(answer::Family{{p}, true}, 0)) : py::object(py::none());
    others.append(py::make_tuple(answer::in_words(p.part), found));
  }
  return others;
}

} // namespace

void bind_strata(py::module_& m) {
  bind_family(m);
  bind_stratum(m);
  auto type = read_only<FamilyAnswer>(
      m, "StrataAnswer", "The answer for all admitted values of the parameters.", {"strata"});
  type.def_property_readonly(
          "abelian", [](const FamilyAnswer& a) { return a.all.abelian(); },
          "the same on all strata: yes or no; else unknown: see `strata`")
      .def_property_readonly(
          "group", [](const FamilyAnswer& a) { return a.all.group(); },
          "where it is the same on all strata, else None")
      .def_property_readonly(
          "strata", [](const FamilyAnswer& a) { return asked(a.answer()); },
          "disjoint; with `unvisited` they cover the values with an equation: `domain`")
      .def_property_readonly(
          "domain", [](const FamilyAnswer& a) { return in_words(strata::domain(a.answer())); },
          "where there is an equation, beside the assumptions; empty: everywhere")
      .def_property_readonly("assumed", [](const FamilyAnswer& a) { return assumed(a.answer()); })
      .def_property_readonly(
          "unvisited", [](const FamilyAnswer& a) { return a.answer().unvisited; },
          "conditions of strata that a limit left open")
      .def_property_readonly(
          "trusted", [](const FamilyAnswer& a) { return sentences(a.answer().trusted); },
          "steps that rest on Z3 alone")
      .def_property_readonly(
          "pruned", [](const FamilyAnswer& a) { return a.answer().pruned; }, "empty strata")
      .def_property_readonly("contradictory",
                             [](const FamilyAnswer& a) { return a.answer().contradictory; })
      .def_property_readonly("refused", [](const FamilyAnswer& a) { return a.answer().refusal; })
      .def_property_readonly(
          "decided",
          [](const FamilyAnswer& a) {
            const auto all = a.all.strata();
            return a.all.is_complete() && !all.empty() &&
                   std::ranges::all_of(
                       all, [](const Stratum& s) { return s.leaf.abelian != Truth::unknown; });
          },
          "no stratum is open")
      .def_property_readonly("r", [](const FamilyAnswer& a) { return a.answer().question->r; })
      .def_property_readonly(
          "equation",
          [](const FamilyAnswer& a) -> std::optional<std::string> {
            if (!a.part().given) return std::nullopt;
            return written(a.part().given->ode);
          },
          "The equation as it was given.\n\n"
          ">>> kovacic.solve(\"y'' + n*y = 0\", parameters=\"n\").equation\n\"y'' + n*y = 0\"")
      .def_property_readonly(
          "solutions",
          [](const FamilyAnswer& a) {
            if (!a.part().given) return std::vector<std::string>{};
            return answer::for_programs(answer::solutions_of(*a.part().given,
                                                             *a.part().part.equation, a.answer(),
                                                             {}, Budget::of_seconds(60))
                                            .general);
          },
          "Of the given equation for general values of the parameters; special functions have the "
          "names of mpmath.\n\n"
          ">>> kovacic.solve(\"y'' + n*y = 0\", parameters=\"n\").solutions\n['cos(x*sqrt(n))', "
          "'sin(x*sqrt(n))']")
      .def_property_readonly("elsewhere", &elsewhere,
                             "(where, StrataAnswer or None) where the equation is another one: the "
                             "variable that was chosen is none there")
      .def_property_readonly("variable",
                             [](const FamilyAnswer& a) {
                               const auto& q = a.answer().question;
                               return q ? q->r.ring()->name(q->z) : std::string("z");
                             })
      .def_property_readonly(
          "family", [](const FamilyAnswer& a) { return a.all.known; },
          "the classical family that it is recognised as, or None")
      .def_property_readonly("seconds", [](const FamilyAnswer& a) { return a.answer().seconds; })
      .def_property_readonly(
          "certificate",
          [](const FamilyAnswer& a) -> std::optional<std::string> {
            const auto& c = a.answer().certificate;
            if (!c || !c->refusal.empty() || !c->says_anything) return std::nullopt;
            return c->json;
          },
          "JSON for verify(), or None")
      .def(
          "at",
          [](const FamilyAnswer& a, const std::map<std::string, Rational>& values) {
            return stratum_at_values(a.answer(), values);
          },
          R"(The stratum that contains these values of all parameters, or None where its conditions cannot be checked.

    >>> kovacic.solve("a*z", parameters="a").at({"a": 0}).conditions
    ['a = 0']
)")
      .def("__str__", [](const FamilyAnswer& a) { return told(a); })
      .def("__repr__", [](const FamilyAnswer& a) {
        return "<StrataAnswer: " + std::to_string(asked(a.answer()).size()) + " strata>";
      });
}

} // namespace kov::python
