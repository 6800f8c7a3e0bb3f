// kovacic new KIND: an annotated file to start from, on standard output.

#include "commands.hpp"
#include "output/texts.hpp"
#include "symbol/suggest.hpp"

namespace kov::cli {
int make_new(const Settings& settings, const std::string& kind) {
  if (settings.given) {
    write_output(settings, *settings.given);
    return exit_decided;
  }
  if (const std::string_view text = text_file("new/" + kind + ".toml"); !text.empty()) {
    write_output(settings, std::string(text));
    return exit_decided;
  }
  std::vector<std::string> kinds;
  for (const std::string_view name : text_files())
    if (name.starts_with("new/")) kinds.emplace_back(name.substr(4, name.size() - 9)); // KIND.toml
  const auto near = nearest(kind, kinds);
  complain(settings, "there is no starting file of the kind '" + kind + "'",
           near ? "did you mean " + *near + "?" : "kinds: " + enumerate(kinds));
  return exit_input;
}

} // namespace kov::cli
