#include "sections/data_page.hpp"

#include "output/texts.hpp"

#include <nlohmann/json.hpp>

namespace kov::cli {

std::string data_page(const std::string& name, const std::string& data) {
  std::string page(text_file(name));
  const auto put = [&](const std::string& mark, std::string_view text) {
    page.replace(page.find(mark), mark.size(), text);
  };
  put("@palette.js@", text_file("palette.js"));
  put("@paper.css@", text_file("paper.css"));
  put("@DATA@", data);
  return page;
}

std::string script_text(const nlohmann::json& j) {
  std::string out;
  for (const char c : j.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

} // namespace kov::cli
