// -H and -L: a system file from one formula.

#include "system/one_line.hpp"
#include "commands.hpp"
#include "symbol/given_text.hpp"
#include "symbol/pasted.hpp"

#include <cstdio>

namespace kov::cli {

namespace {

// "p^2/2 + q^4/4" of "H = p^2/2 + q^4/4"
std::string without_name(const std::string& text, const std::string& name) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return text;
  std::string left = text.substr(0, equals);
  std::erase_if(left, [](char c) { return c == ' ' || c == '\t'; });
  const bool is_named = left == name || (left.starts_with(name + "(") && left.ends_with(")"));
  return is_named ? text.substr(equals + 1) : text;
}

} // namespace

std::string take_one_line(Settings& settings, const OneLineArguments& arguments) {
  const bool hamiltonian = !arguments.hamiltonian.empty();
  const std::string name = hamiltonian ? "-H" : "-L";
  if (hamiltonian && !arguments.lagrangian.empty())
    throw InputError("-L", 0, 0, 1, "H and L are both given", "leave one of them out");
  std::vector<std::string> declared = arguments.parameters;
  for (const auto* list : {&arguments.coordinates, &arguments.rates})
    declared.insert(declared.end(), list->begin(), list->end());
  const std::string& given = hamiltonian ? arguments.hamiltonian : arguments.lagrangian;
  const Pasted pasted = pasted_formula(without_name(given, name.substr(1)), name, {declared, ""});
  const std::string formula = pasted.text();
  const Mechanics kind = hamiltonian ? Mechanics::hamiltonian : Mechanics::lagrangian;
  const Letters letters = letters_of(
      formula, kind, {arguments.coordinates, arguments.rates, arguments.parameters}, name);
  settings.given = system_text(formula, kind, letters);
  for (const std::string& note : sentences(pasted.notes))
    std::fprintf(stderr, "kovacic: %s\n", printable(note).c_str());
  if (!pasted.as_written)
    std::fprintf(stderr, "kovacic: %s read as %s\n", name.c_str(), printable(formula).c_str());
  if (!settings.quiet)
    std::fprintf(stderr, "kovacic: %s read with %s\n", name.c_str(),
                 in_words(letters, kind).c_str());
  constexpr std::size_t longest = 60;
  std::string heading = name.substr(1) + " = " + formula;
  if (heading.size() > longest) heading = heading.substr(0, longest - 3) + "...";
  give_text(heading, *settings.given);
  return heading;
}

} // namespace kov::cli
