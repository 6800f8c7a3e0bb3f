#include "equation/equation_file.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "symbol/notations.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>

namespace kov {
namespace {

std::optional<Expression> formula(const Entry& table, std::string_view key) {
  const Entry* e = table.find(key);
  return e == nullptr ? std::nullopt : std::optional(e->expression());
}

// In our notation, whose errors have a place in the file; else as the command line reads it.
void read_equation_of(const Entry& e, AskedEquation& asked) {
  std::optional<InputError> strict;
  auto place = std::make_shared<Origin>(*e.origin());
  place->what = "ode";
  try {
    asked.text.ode = parse_ode(e.string(), place);
  } catch (const InputError& error) {
    strict = error;
  }
  EquationText names = asked.text;
  names.ode = std::nullopt;
  EquationTexts texts;
  texts.ode = e.string();
  auto u =
      tried<InputError>([&] { return std::optional(asked_equation(texts, names, Door::keys)); });
  if (u && (strict || is_another_equation(u->notes)))
    asked = *std::move(u);
  else if (strict)
    throw *strict;
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

// assume: the names in it are parameters
void read_ode(const Entry& ode, const Entry* assume, AskedEquation& asked) {
  ode.check_keys({"variable", "unknown", "r", "p", "q", "ode", "minpoly", "parameters"});
  EquationText& text = asked.text;
  text.r = formula(ode, "r");
  text.p = formula(ode, "p");
  text.q = formula(ode, "q");
  text.minpoly = formula(ode, "minpoly");
  const Entry* equation = ode.find("ode");
  if (!text.r && !text.p && !text.q && equation == nullptr)
    throw ode.key_error("[ode] has no equation", "give r, or p and q, or ode");
  if (const Entry* v = ode.find("variable")) {
    text.variable = v->string();
    text.infer_variable = false;
  }
  if (const Entry* unknown = ode.find("unknown")) text.unknown = unknown->string();
  if (const Entry* parameters = ode.find("parameters")) text.parameters = parameters->strings();
  if (equation == nullptr) return;
  const std::size_t declared = text.parameters.size();
  if (assume != nullptr)
    for (const auto& [name, claim] : assume->members())
      if (name != "conditions") text.parameters.push_back(name);
  read_equation_of(*equation, asked);
  if (!text.change) text.parameters.resize(declared); // read_assumptions says which of them occur
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
  const auto known = settable_names(file.asked.text);
  for (const auto& [name, claim] : assume.members()) {
    if (name == "conditions") {
      for (const Entry* one : claim.list())
        file.asked.text.assume.push_back({one->string(), one->origin(), ""});
      continue;
    }
    if (!std::ranges::binary_search(known, name)) refuse_name(claim, known);
    file.assume.emplace_back(name, claim.string());
    file.asked.text.parameters.push_back(name);
    file.asked.text.assume.push_back({claim.string(), claim.origin(), name});
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
  const Entry* assume = document.find("assume");
  read_ode(document.at("ode"), assume, file.asked);
  if (assume != nullptr) read_assumptions(*assume, file);
  if (const Entry* expect = document.find("expect"))
    for (const Entry& e : expect->array())
      file.expect.push_back(read_expectation(e, file.asked.text));
  return file;
}

} // namespace kov
