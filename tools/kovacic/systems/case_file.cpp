#include "systems/case_file.hpp"

#include "commands.hpp"
#include "equations/answer.hpp"
#include "equations/present.hpp"
#include "exact/joined.hpp"
#include "proofs/certificate_file.hpp"
#include "systems/mechanics.hpp"

#include <algorithm>
#include <map>

namespace kov::cli {
namespace {

std::string outcome_of(const Json& result) {
  if (result.at("case").is_null()) return "undecided";
  static const std::map<int, std::string> names{
      {1, "exponential"}, {2, "imprimitive"}, {3, "algebraic"}, {4, "no-liouvillian"}};
  return names.at(result.at("case").get<int>());
}

std::string plain(const Json& value) {
  if (value.is_null()) return "undecided";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// A group as people write it: "SL2", "SL(2)", "Borel", "Ga", "Gm", "T_4", "C_3", "mu_3", "cyclic_3", "trivial", "Dinf",
// "D_3", "A4", "S4", "A5".
struct GroupName {
  std::string type;
  std::string n; ///< empty: any, or none
};

std::optional<GroupName> parse_group(const std::string& text) {
  static const std::map<std::string, GroupName> fixed{
      {"SL2", {"SL2", ""}},      {"SL(2)", {"SL2", ""}},   {"SL(2, C)", {"SL2", ""}},
      {"SL(2,C)", {"SL2", ""}},  {"Borel", {"Borel", ""}}, {"B", {"Borel", ""}},
      {"Ga", {"T", "1"}},        {"Gm", {"Gm", ""}},       {"trivial", {"cyclic", "1"}},
      {"Dinf", {"Dinf", ""}},    {"A4", {"A4", ""}},       {"S4", {"S4", ""}},
      {"A5", {"A5", ""}},        {"T", {"T", ""}},         {"D", {"D", ""}},
      {"cyclic", {"cyclic", ""}}};
  if (const auto it = fixed.find(text); it != fixed.end()) return it->second;
  const auto cut = text.find('_');
  if (cut == std::string::npos) return std::nullopt;
  static const std::map<std::string, std::string> families{
      {"T", "T"}, {"C", "cyclic"}, {"mu", "cyclic"}, {"cyclic", "cyclic"}, {"D", "D"}};
  const auto family = families.find(text.substr(0, cut));
  const std::string n = text.substr(cut + 1);
  if (family == families.end() || n.empty() ||
      n.find_first_not_of("0123456789") != std::string::npos || n.front() == '0')
    return std::nullopt;
  return GroupName{family->second, n};
}

// Does the object under "group" of a result have this name?
bool matches(const GroupName& name, const Json& group) {
  if (group.is_null() || group.at("type") != name.type) return false;
  return name.n.empty() || plain(group.at("n")) == name.n;
}

GroupName group_of(const EquationExpectation& x) {
  const auto name = parse_group(*x.group);
  if (!name)
    throw x.entry.at("group").error("'" + *x.group + "' is not the name of a group",
                                    "SL2, Borel, T_n, Ga, Gm, C_n, trivial, Dinf, D_n, A4, S4, A5");
  return *name;
}

Expected compare(const EquationExpectation& x, const Json& result) {
  Expected e;
  std::vector<std::string> wanted;
  std::vector<std::string> found;
  const auto item = [&](const std::string& what, const std::string& want, const std::string& is,
                        bool met) {
    wanted.push_back(what + " " + want);
    if (!met) found.push_back(what + " " + is);
  };
  if (x.group)
    item("group", *x.group,
         result.at("group").is_null() ? "undecided" : group_text(result.at("group")),
         matches(group_of(x), result.at("group")));
  if (x.kovacic_case)
    item("case", std::to_string(*x.kovacic_case), plain(result.at("case")),
         result.at("case") == *x.kovacic_case);
  if (x.outcome) item("outcome", *x.outcome, outcome_of(result), *x.outcome == outcome_of(result));
  if (x.identity_component)
    item("identity component", *x.identity_component, plain(result.at("identity_component")),
         result.at("identity_component") == *x.identity_component);
  if (x.abelian)
    item("abelian", *x.abelian, plain(result.at("abelian")), result.at("abelian") == *x.abelian);
  std::string where;
  for (const auto& [name, value] : x.where)
    where += (where.empty() ? "" : ", ") + name + " = " + std::string(value.text());
  e.name = (where.empty() ? "" : where + ": ") + joined(wanted) +
           (x.source.empty() ? "" : "  (" + x.source + ")");
  e.met = found.empty();
  e.found = joined(found);
  return e;
}

// The values that belong to one solve: --set, then the block's own.
std::vector<std::pair<std::string, Expression>>
values_for(const Settings& settings, const std::vector<std::pair<std::string, Expression>>& where) {
  auto all = settings.settings();
  for (const auto& [name, value] : where) {
    std::erase_if(all, [&](const auto& old) { return old.first == name; });
    all.emplace_back(name, value);
  }
  return all;
}

Answer solve_with(const Settings& settings, const EquationFile& file,
                  const std::vector<std::pair<std::string, Expression>>& where) {
  Solver solver(fixed_question([&] {
                  Question q{file.asked};
                  q.text.set = values_for(settings, where);
                  q.id = file.path;
                  return q;
                }),
                settings);
  return solver.answer("");
}

std::string name_of_entry(const EquationFile& file,
                          const std::vector<std::pair<std::string, Expression>>& where) {
  std::string title = file.path;
  for (const auto& [name, value] : where)
    title +=
        (&name == &where.front().first ? "  [" : ", ") + name + " = " + std::string(value.text());
  if (!where.empty()) title += "]";
  return title;
}

// Adds one answer; throws its input error.
void take(const Settings& settings, CaseReport& report, const Answer& answer,
          const std::string& title) {
  if (answer.error) throw *answer.error;
  report.exit = worse(report.exit, exit_code(settings, answer));
  if (answer.exit >= exit_internal) report_failure(settings, answer);
  if (answer.result.is_null()) return;
  if (!report.text.empty() && settings.format == "text") report.text += "\n";
  Answer shown = answer;
  const std::string name = title.substr(title.rfind('/', title.find("  [")) + 1);
  if (!settings.certificate.empty() && !shown.certificate.empty())
    shown.result["certificate_file"] = file_certificate(settings, name, shown.certificate);
  if (!settings.certificate.empty() && !shown.loops_certificate.empty())
    shown.result["loops_certificate_file"] =
        file_certificate(settings, name + ".loops", shown.loops_certificate);
  report.text += presented(settings, shown, title);
  report.json.push_back(shown.result);
}

} // namespace

CaseReport check_equation(const Settings& settings, const Entry& document) {
  const EquationFile file = read_equation_file(document);
  if (!settings.manifold.empty())
    throw InputError(file.path, 0, 0, 1, "an equation file has no manifolds",
                     "leave out --manifold");
  CaseReport report;
  report.exit = settings.nothing_yet();
  report.json = Json::array();
  std::map<std::string, Answer> answers; // by the values of the block
  const auto answer_for = [&](const std::vector<std::pair<std::string, Expression>>& where) {
    const std::string key = name_of_entry(file, where);
    if (!answers.contains(key)) {
      answers.emplace(key, solve_with(settings, file, where));
      take(settings, report, answers.at(key), key);
    }
    return answers.at(key);
  };
  if (file.expect.empty()) (void)answer_for({});
  for (const EquationExpectation& x : file.expect) {
    if (x.group) (void)group_of(x); // complain about names before the work
    const Answer answer = answer_for(x.where);
    if (answer.exit >= exit_internal) return report;
    report.expected.push_back(compare(x, answer.result));
  }
  return report;
}

std::string command_for(const std::string& path) {
  const Entry document = read_document(path);
  if (has_format(document, "theorem")) return "prove";
  if (has_format(document, "scene")) return "section";
  return is_equation_file(document) ? "solve" : "classify";
}

CaseReport check_case(const Settings& settings, const std::string& path) {
  const Entry document = settings.document(path);
  if (has_format(document, "theorem"))
    throw document.error("this file holds a theorem", "kovacic prove " + path);
  if (has_format(document, "scene"))
    throw InputError(path, 0, 0, 1, "this file describes a scene to simulate",
                     "write: kovacic section " + path + "   or   kovacic test " + path);
  if (is_equation_file(document)) return check_equation(settings, document);
  if (settings.format != "text" && settings.format != "json")
    throw InputError(path, 0, 0, 1, "a page shows one system",
                     "write: kovacic report " + path + " --format " + settings.format);
  return check_system_file(settings, path);
}

} // namespace kov::cli
