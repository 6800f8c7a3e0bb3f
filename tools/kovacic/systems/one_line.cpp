// -H and -L: a system file from one formula.

#include "system/one_line.hpp"
#include "commands.hpp"
#include "symbol/given_text.hpp"
#include "symbol/written.hpp"

#include <cstdio>

namespace kov::cli {

std::string take_one_line(Settings& settings, const OneLineArguments& arguments) {
  const bool hamiltonian = !arguments.hamiltonian.empty();
  const std::string name = hamiltonian ? "-H" : "-L";
  if (hamiltonian && !arguments.lagrangian.empty())
    throw InputError("-L", 0, 0, 1, "H and L are both given", "leave one of them out");
  const std::string& given = hamiltonian ? arguments.hamiltonian : arguments.lagrangian;
  const Mechanics kind = hamiltonian ? Mechanics::hamiltonian : Mechanics::lagrangian;
  const OneLine line = read_one_line(
      given, kind, {arguments.coordinates, arguments.rates, arguments.parameters}, name);
  const std::string& formula = line.formula;
  settings.given = line.text;
  if (!settings.assume.empty()) *settings.given += "\n" + assume_table(settings.assume);
  settings.assume.clear();
  for (const std::string& note : sentences(line.notes))
    std::fprintf(stderr, "kovacic: %s\n", printable(note).c_str());
  if (!line.as_written)
    std::fprintf(stderr, "kovacic: %s read as %s\n", name.c_str(), printable(formula).c_str());
  if (!settings.quiet)
    std::fprintf(stderr, "kovacic: %s read with %s\n", name.c_str(),
                 in_words(line.letters, kind).c_str());
  constexpr std::size_t longest = 75; // whole terms of it
  std::string heading = name.substr(1) + " = " + formula;
  if (heading.size() > longest) {
    std::size_t end = longest - 3;
    while (end > 10 && !(heading[end - 1] == ' ' &&
                         std::string("+-").find(heading[end - 2]) != std::string::npos))
      --end;
    heading = heading.substr(0, end > 10 ? end : longest - 3) + "...";
  }
  give_text(heading, *settings.given);
  return heading;
}

std::string with_scene(const Settings& settings, const std::string& system) {
  SceneWishes wishes;
  if (settings.given) wishes.name = "section"; // else it is called as its file
  if (!settings.energy.empty()) wishes.energy = settings.energy;
  for (const auto& [name, value] : settings.settings())
    wishes.values.emplace_back(name, written(value));
  return kov::with_scene(system, wishes);
}

} // namespace kov::cli
