#include "exact/error.hpp"

#include <string_view>

namespace kov::detail {

void ensure_failed(const char* condition, const char* file, int line) {
  std::string_view path(file); // no path of a build machine in a message: keep the last two parts
  auto cut = path.rfind('/');
  if (cut != std::string_view::npos && cut > 0) cut = path.rfind('/', cut - 1);
  if (cut != std::string_view::npos) path.remove_prefix(cut + 1);
  throw InternalError("internal check failed: " + std::string(condition) + " (" +
                      std::string(path) + ":" + std::to_string(line) + ")");
}

} // namespace kov::detail
