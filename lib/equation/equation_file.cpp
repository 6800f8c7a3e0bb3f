#include "equation/equation_file.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "symbol/notations.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>

namespace kov {
namespace {

std::optional<Expression> formula(const Entry& table, std::string_view key, bool equation = false) {
  const Entry* e = table.find(key);
  if (e == nullptr) return std::nullopt;
  if (!equation) return e->expression();
  auto place = std::make_shared<Origin>(*e->origin());
  place->what = key;
  return parse_ode(e->string(), place);
}

std::optional<std::string> word(const Entry& table, std::string_view key,
                                const std::vector<std::string>& allowed) {
  const Entry* e = table.find(key);
  if (e == nullptr) return std::nullopt;
  if (!is_among(e->string(), allowed)) {
    std::string list = joined(allowed);
    throw e->error("'" + e->string() + "' is not a value of " + std::string(key), "one of " + list);
  }
  return e->string();
}

void read_ode(const Entry& ode, EquationText& text) {
  ode.check_keys({"variable", "unknown", "r", "p", "q", "ode", "minpoly", "parameters"});
  text.r = formula(ode, "r");
  text.p = formula(ode, "p");
  text.q = formula(ode, "q");
  text.ode = formula(ode, "ode", true);
  text.minpoly = formula(ode, "minpoly");
  if (!text.r && !text.p && !text.q && !text.ode)
    throw ode.key_error("[ode] has no equation", "give r, or p and q, or ode");
  if (const Entry* v = ode.find("variable")) {
    text.variable = v->string();
    text.infer_variable = false;
  }
  if (const Entry* unknown = ode.find("unknown")) text.unknown = unknown->string();
  if (const Entry* parameters = ode.find("parameters")) text.parameters = parameters->strings();
}

[[noreturn]] void refuse_name(const Entry& at, const std::vector<std::string>& known) {
  const auto near = nearest(at.name(), known);
  throw at.key_error("'" + at.name() + "' does not occur in the equation",
                     near            ? "did you mean " + *near + "?"
                     : known.empty() ? "it has no names"
                                     : "its names: " + enumerate(known));
}

// The names that something is assumed of are parameters.
void read_assumptions(const Entry& assume, EquationFile& file) {
  const auto known = settable_names(file.text);
  for (const auto& [name, claim] : assume.members()) {
    if (name == "conditions") {
      for (const Entry* one : claim.list())
        file.text.assume.push_back({one->string(), one->origin(), ""});
      continue;
    }
    if (!std::ranges::binary_search(known, name)) refuse_name(claim, known);
    file.assume.emplace_back(name, claim.string());
    file.text.parameters.push_back(name);
    file.text.assume.push_back({claim.string(), claim.origin(), name});
  }
}

EquationExpectation read_expectation(const Entry& e, const EquationText& text) {
  e.check_keys(
      {"where", "outcome", "group", "identity_component", "abelian", "case", "source", "note"});
  EquationExpectation x;
  x.entry = e;
  if (const Entry* where = e.find("where"))
    for (const auto& [name, value] : where->members()) {
      const auto known = settable_names(text);
      if (!std::ranges::binary_search(known, name)) refuse_name(value, known);
      x.where.emplace_back(name, value.expression());
    }
  x.outcome = word(e, "outcome",
                   {"exponential", "imprimitive", "algebraic", "no-liouvillian", "undecided"});
  x.identity_component = word(e, "identity_component", {"trivial", "Ga", "Gm", "Borel", "SL2"});
  x.abelian = word(e, "abelian", {"yes", "no", "undecided"});
  if (const Entry* group = e.find("group")) x.group = group->string();
  if (const Entry* source = e.find("source")) x.source = source->string();
  if (const Entry* number = e.find("case")) {
    x.kovacic_case = number->integer();
    if (*x.kovacic_case < 1 || *x.kovacic_case > 4)
      throw number->error("Kovacic's cases are 1, 2, 3 and 4");
  }
  if (!x.outcome && !x.group && !x.identity_component && !x.abelian && !x.kovacic_case)
    throw e.error("this block expects nothing",
                  "give outcome, group, identity_component, abelian or case");
  return x;
}

} // namespace

bool is_equation_file(const Entry& document) { return document.find("system") == nullptr; }

EquationFile read_equation_file(const Entry& document) {
  document.check_keys({"format", "title", "cite", "ode", "assume", "expect"});
  EquationFile file;
  file.path = document.file();
  const Entry& format = document.at("format");
  if (format.string() != "equation/1")
    throw format.error("unknown format '" + format.string() + "'", "write format = \"equation/1\"");
  if (const Entry* title = document.find("title")) file.title = title->string();
  if (const Entry* cite = document.find("cite")) file.cite = cite->strings();
  if (document.find("ode") == nullptr)
    throw InputError(file.path, 0, 0, 1, "the file has neither an [ode] nor a [system] table",
                     "see: kovacic new ode");
  read_ode(document.at("ode"), file.text);
  if (const Entry* assume = document.find("assume")) read_assumptions(*assume, file);
  if (const Entry* expect = document.find("expect"))
    for (const Entry& e : expect->array())
      file.expect.push_back(read_expectation(e, file.text));
  return file;
}

} // namespace kov
