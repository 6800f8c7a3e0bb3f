#include "output/output_format.hpp"

#include <filesystem>

namespace kov::cli {

std::string output_format(const Settings& settings) {
  for (const char* ending : {"html", "tex", "json"})
    if (settings.format == "text" && settings.output.ends_with(std::string(".") + ending))
      return ending;
  return settings.format;
}

} // namespace kov::cli
