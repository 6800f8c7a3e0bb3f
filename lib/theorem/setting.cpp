#include "theorem/setting.hpp"

#include "exact/joined.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"
#include "symbol/author_words.hpp"
#include "symbol/given_text.hpp"
#include "theorem/prove.hpp"

#include <nettle/sha2.h>

#include <algorithm>
#include <array>

namespace kov {
namespace {

std::string listed(const System& s, const std::vector<std::size_t>& names) {
  return joined(names, [&](const std::size_t i) { return s.ring()->name(i); });
}

// {x, y} = f for every pair whose bracket is not 0, once.
void show_bracket(InputFile& file, const System& s) {
  std::string text;
  const auto& bracket = *s.field.poisson;
  for (std::size_t i = 0; i < bracket.size(); ++i)
    for (std::size_t j = i + 1; j < bracket.size(); ++j)
      if (!is_zero(bracket[i][j]))
        text += (text.empty() ? "{" : ", {") + s.field.name(i) + ", " + s.field.name(j) +
                "} = " + to_string(bracket[i][j]);
  file.setting.push_back({"bracket", text});
}

// The entries of a table of formulas, as they are written.
void show_written(InputFile& file, const Entry& table, const std::string& dash = {}) {
  for (const auto& [name, entry] : table.members())
    if (entry.kind() == Entry::Kind::string) file.setting.push_back({name + dash, entry.string()});
}

void show_equations(InputFile& file, const Entry& system, const System& s) {
  if (const Entry* define = system.find("define")) show_written(file, *define);
  if (const Entry* field = system.find("field")) show_written(file, *field, "'");
  for (const FunctionSymbol& f : s.field.functions)
    if (!f.meaning.empty())
      file.setting.push_back({"function " + s.ring()->name(f.variable), f.meaning});
  if (const Entry* relations = system.find("relations"))
    for (const std::string& f : relations->strings())
      file.setting.push_back({"relation", f});
  if (const Entry* l = system.find("lagrangian")) {
    file.setting.push_back({"Lagrangian", l->string()});
    file.setting.push_back(
        {"momenta", "the derivatives of the Lagrangian by " + listed(s, s.velocities)});
  }
  if (const Entry* h = system.find("hamiltonian"))
    file.setting.push_back({"Hamiltonian", h->string()});
  else if (s.field.hamiltonian && !system.find("lagrangian"))
    file.setting.push_back({"H, the energy", to_factored_string(*s.field.hamiltonian)});
}

InputFile system_file(const std::string& name, const Entry& document) {
  const System s = read_system(document);
  InputFile file{name, sha256(document.file_text()), titled(s), {}, {}};
  file.setting.push_back({"variables", listed(s, s.field.coordinates)});
  if (!s.field.parameters.empty())
    file.setting.push_back({"parameters", listed(s, s.field.parameters)});
  file.assumed = assumptions_of(s);
  if (s.field.poisson) show_bracket(file, s);
  show_equations(file, document.at("system"), s);
  return file;
}

// A name that the file defines says nothing to a reader of the sentence.
bool uses_defined_name(const System& s, const std::string& text) {
  std::string name;
  for (const char c : text + ' ') {
    if (is_identifier(name + c)) {
      name += c;
      continue;
    }
    if (s.named.contains(name)) return true;
    name.clear();
  }
  return false;
}

// "m positive" as "m > 0"; a condition as it is written.
std::string condition(const System& s, const Assumption& a) {
  const bool is_written = a.text.find_first_of("<>=") != std::string::npos;
  return is_written && !uses_defined_name(s, a.text)
             ? a.text
             : to_string(a.value) + certify::relation(std::get<Sign>(a.says));
}

// "g, L": all of one kind together.
std::string all_of(const System& s, Sort sort) {
  std::string names;
  for (const Assumption& a : s.assumptions)
    if (a.is(sort) && !is_constant(a.value))
      names += (names.empty() ? "" : ", ") + to_string(a.value);
  return names;
}

} // namespace

std::string toml_text(const std::string& s) {
  std::string out = "\"";
  for (const char c : s) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string toml_list(const std::vector<std::string>& all) {
  return "[" + joined(all, toml_text) + "]";
}

bool is_of_stratum(const TheoremNode& n) { return n.tables.has_value() || !n.step.empty(); }

bool is_of_strata(const Theorem& t) {
  return std::ranges::any_of(t.nodes, [](const TheoremNode& n) {
    return is_of_stratum(n) || n.kind == NodeKind::open_part;
  });
}

namespace {

Entry with_names(Entry document, const ParameterValues& algebraic, std::vector<std::string> names,
                 std::vector<std::string> conditions) {
  for (const auto& [name, value] : algebraic) {
    names.push_back(name);
    conditions.push_back(value + " = 0");
  }
  if (!names.empty())
    document = document.merged(
        parse_document("system = {parameters = " + toml_list(names) + "}", document.file()));
  if (!conditions.empty())
    document = document.merged(
        parse_document("assume = {conditions = " + toml_list(conditions) + "}", document.file()));
  return document;
}

} // namespace

Entry document_of(const TheoremNode& n, const std::string& directory) {
  Entry document = read_document(beside(directory, n.file));
  if (!is_of_stratum(n)) return with_names(std::move(document), n.algebraic, {}, {});
  std::vector<std::string> keys{"format", "title", "cite", "system", "set", "assume"};
  if (n.kind == NodeKind::case_file || n.kind == NodeKind::trusted) {
    keys.insert(keys.end(), {"integral", "casimir", "darboux"});
    if (!n.tables && n.found.along.empty()) keys.insert(keys.end(), {"manifold", "reduce"});
  }
  document = with_names(document.only(keys), n.algebraic, n.values, n.place.conditions);
  return n.tables ? document.merged(*n.tables) : document;
}

System system_of(const Theorem& t, const std::string& directory, const ParameterValues& at) {
  return read_system(with_names(read_document(beside(directory, t.system)), t.algebraic, {}, {}),
                     at);
}

std::string sha256(const std::string& bytes) {
  sha256_ctx state;
  sha256_init(&state);
  sha256_update(&state, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state, digest.size(), digest.data());
  constexpr const char* digits = "0123456789abcdef";
  std::string out;
  for (const std::uint8_t byte : digest)
    out += {digits[byte >> 4U], digits[byte & 15U]};
  return out;
}

std::string assumptions_of(const System& s) {
  std::string text;
  const auto add = [&](const std::string& one) { text += (text.empty() ? "Let " : ", ") + one; };
  for (const auto& [name, value] : s.values)
    add(name + " = " + to_string(value));
  for (const Assumption& a : s.assumptions)
    if (!is_constant(a.value) && std::holds_alternative<Sign>(a.says)) // of fixed ones: they hold
      add(condition(s, a));
  System plain = s;
  plain.domain = {};
  for (const ParameterDomain::NotAllZero& list : s.domain.lists())
    if (not_excluded(plain, list).size() == list.size()) add(in_words(list));
  for (const auto& [sort, word] :
       {std::pair{Sort::integer, " integral"}, std::pair{Sort::rational, " rational"},
        std::pair{Sort::real, " real"}})
    if (const auto names = all_of(s, sort); !names.empty())
      text += (text.empty() ? "Let " + names + " be" : ", and " + names) + word;
  return text.empty() ? text : text + ". ";
}

std::string titled(const System& s) {
  return s.title.empty() ? "system of " + s.file.substr(folder_of(s.file).size())
                         : "system \"" + one_line(s.title) + "\"";
}

std::vector<InputFile> input_files(const Theorem& t) {
  const std::string directory = folder_of(t.file);
  std::vector<InputFile> all;
  const auto add = [&](const std::string& name) {
    const auto same = [&](const InputFile& f) { return f.name == name; };
    if (name.empty() || name == "-" || std::ranges::any_of(all, same)) return;
    // not a pipe, which cannot be read twice: the step has its error
    tried<InputError>(
        [&] { all.push_back(system_file(name, read_document(beside(directory, name)))); });
  };
  add(t.system);
  for (const TheoremNode& n : t.nodes)
    for (const std::string* name : {&n.file, &n.other})
      add(*name);
  if (const std::string name = t.file.substr(directory.size()); !t.sha256.empty())
    if (std::ranges::none_of(all, [&](const InputFile& f) { return f.name == name; }))
      all.push_back({name, t.sha256, {}, {}, {}});
  return all;
}

} // namespace kov
