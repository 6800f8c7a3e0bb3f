// kovacic integrals FILE: first integrals that are polynomial in the momenta, at all parameter
// values.

#include "exact/joined.hpp"
#include "exact/share.hpp"
#include "integrability/parameters.hpp"
#include "integrals/find.hpp"
#include "parameters/conditions.hpp"

#include "commands.hpp"
#include "output/render.hpp"
#include "systems/mechanics.hpp"
#include "systems/study_report.hpp"

#include <sstream>

namespace kov::cli {
namespace {

// What is left for the answer when the search has to end by itself.
constexpr double part_of_the_time = 0.95;
constexpr double quick = 3e8; // units of work: nobody asked for the higher degree

std::string condition_text(const IntegralsOfSet& set) {
  std::vector<std::string> all;
  for (const MPoly& f : set.equations)
    all.push_back(to_string(Condition{f, Sign::zero}));
  for (const MPoly& f : set.inequations)
    all.push_back(to_string(Condition{f, Sign::nonzero}));
  return all.empty() ? "all parameter values" : joined(all, ", ", " and ");
}

std::string names(const IntegralsOfSet& set, const std::vector<std::string>& labels) {
  return joined(set.commuting, [&](const std::size_t i) { return labels[i]; });
}

// H, C1, C2, ..., F1, F2, ...; the system's own names are not taken.
std::vector<std::string> labels(const IntegralsOfSet& set) {
  std::vector<std::string> all;
  long casimirs = 0;
  long found = 0;
  for (const FoundIntegral& f : set.integrals) {
    std::string name = f.hamiltonian ? "H"
                       : f.casimir   ? "C" + std::to_string(++casimirs)
                                     : "F" + std::to_string(++found);
    while (f.value.ring()->find(name))
      name += '_';
    all.push_back(std::move(name));
  }
  return all;
}

std::string completeness(const IntegralsOfSet& set) {
  if (!set.open.empty()) return "";
  if (set.complete_for_smooth)
    return "proved: every other integral of this degree, its coefficients smooth functions of the "
           "coordinates, depends on these";
  if (set.complete) return "proved: every other integral of the class depends on these";
  return "others are not excluded, as function symbols may satisfy more relations than declared";
}

std::string integrable_text(const IntegralsOfSet& set, const std::vector<std::string>& label) {
  std::string all = joined(label);
  const std::string claim = set.liouville
                                ? names(set, label) + " independent and in involution"
                                : all + (label.size() == 1 ? ", one" : " independent, one") +
                                      " for each variable but one";
  return set.only_declared_relations
             ? "integrable if the function symbols satisfy no relations but those declared: " +
                   claim
             : "INTEGRABLE: " + claim;
}

void print(const std::string& where, const IntegralsOfSet& set, const VectorField& v,
           std::ostringstream& out) {
  const auto label = labels(set);
  const auto below = [&](const std::string& text) { out << "    " << wrapped(text, 6) << '\n'; };
  put(out, "where", where);
  out << "    searched: " << wrapped(set.searched, 14) << '\n';
  for (std::size_t i = 0; i < set.integrals.size(); ++i) {
    const FoundIntegral& f = set.integrals[i];
    const std::string title = label[i] + (f.casimir ? " (Casimir) = " : " = ");
    const std::string value = f.hamiltonian ? "the Hamiltonian" : to_string(f);
    below(title + value);
  }
  if (set.found() == 0 && set.open.empty()) below("no other integral found");
  if (set.integrable(v)) below(integrable_text(set, label));
  if (const std::string text = completeness(set); !text.empty()) below(text);
  if (!set.open.empty())
    below("open: " + set.open + "; parts of this set that are listed by themselves are decided");
}

Json as_json(const IntegralsOfSet& set, const VectorField& v) {
  const auto label = labels(set);
  Json all = Json::array();
  for (std::size_t i = 0; i < set.integrals.size(); ++i) {
    const FoundIntegral& f = set.integrals[i];
    all.push_back(
        {{"name", label[i]}, {"value", to_string(f)}, {"degree", f.degree}, {"kind", kind_of(f)}});
  }
  return {{"searched", set.searched},
          {"equations", texts(set.equations)},
          {"inequations", texts(set.inequations)},
          {"integrals", all},
          {"in_involution", list_of(set.commuting, [&](std::size_t i) { return label[i]; })},
          {"integrable", !set.integrable(v)            ? "not shown"
                         : set.only_declared_relations ? "if only the declared relations hold"
                                                       : "yes"},
          {"complete", set.complete_for_smooth ? "smooth coefficients"
                       : set.complete          ? "class"
                                               : "no"},
          {"open", text_or_null(set.open)}};
}

std::string text_of(const std::string& file, const IntegralSearch& search, const VectorField& v) {
  std::ostringstream out;
  out << file << "\n";
  const auto list = [&](const char* title, const std::vector<MPoly>& all, const char* relation) {
    for (const MPoly& f : all)
      out << title << to_string(f) << relation;
  };
  list("  assumed   ", search.assumed_equations, " = 0\n");
  list("  assumed   ", search.assumed, " != 0\n");
  list("  left out  unless ", search.not_covered, " != 0\n");
  const char* all_values =
      search.assumed.empty() && search.assumed_equations.empty() && search.not_covered.empty()
          ? "all parameter values"
          : "all these parameter values";
  for (const IntegralsOfSet& set : search.sets)
    print(condition_text(set), set, v, out);
  if (search.elsewhere)
    print(!search.sets.empty() ? "everywhere else" : all_values, *search.elsewhere, v, out);
  return out.str();
}

Json as_json(const std::string& file, const IntegralSearch& search, const VectorField& v) {
  return {{"format", "kovacic-integrals/1"},
          {"file", file},
          {"parameters", "complex"},
          {"assumed_zero", texts(search.assumed_equations)},
          {"assumed_nonzero", texts(search.assumed)},
          {"not_covered_unless_nonzero", texts(search.not_covered)},
          {"sets", list_of(search.sets, [&](const auto& set) { return as_json(set, v); })},
          {"elsewhere", search.elsewhere ? as_json(*search.elsewhere, v) : Json(nullptr)},
          {"finished", search.finished()}};
}

} // namespace

int integrals(const Settings& settings, const IntegralsArguments& arguments) {
  const Report report = supervised(settings, arguments.file, [&] {
    const System s = read_system(settings.document(arguments.file), parameter_values(settings));
    IntegralOptions options;
    if (arguments.degree) options.degree = *arguments.degree;
    options.coefficients = arguments.coefficients;
    options.budget = settings.search_budget(part_of_the_time);
    options.budget.give_by_default();
    require_consistent(s);
    IntegralSearch search = find_integrals(s, options);
    std::string next;
    if (!arguments.degree && search.finished()) {
      options.degree = 4; // as in classify
      options.budget = at_most(options.budget, quick);
      if (IntegralSearch larger = find_integrals(s, options); larger.finished())
        search = std::move(larger);
      else
        next = "  next      --degree 4 searches longer\n";
    }
    return Report{search.finished() ? exit_decided : exit_undecided,
                  with_written_roots(s, text_of(arguments.file, search, s.field)) + next,
                  as_json(arguments.file, search, s.field)};
  });
  return written_report(settings, report);
}

} // namespace kov::cli
