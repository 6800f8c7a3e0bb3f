#include "process/settings.hpp"

#include "commands.hpp"
#include "output/page_width.hpp"
#include "process/supervisor.hpp"

#include "equation/read_equation.hpp"
#include "symbol/author_words.hpp"
#include "symbol/expression.hpp"
#include "symbol/notations.hpp"
#include "system/one_line.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace kov::cli {

Options Settings::solver_options() const {
  Options o;
  if (timeout > 0) o.budget = Budget::of_seconds(timeout);
  o.budget.stop = stopped_by_hand();
  o.budget.max_degree = max_degree;
  o.budget.max_families = max_families;
  o.budget.max_work = max_work;
  if (method == "kovacic") o.method = Method::kovacic;
  if (method == "engines") o.method = Method::engines;
  if (method == "all") o.method = Method::all;
  if (only_case != 0) o.only_case = only_case;
  o.want_trace = trace;
  o.want_solutions = wants_solutions();
  o.want_certificate = !certificate.empty();
  return o;
}

Budget Settings::search_budget(double part_of_the_time) const {
  Settings less = *this;
  less.timeout *= part_of_the_time;
  Budget b = less.solver_options().budget;
  b.seconds = timeout;
  return b;
}

int Settings::exit_of(Truth abelian, bool decided) const {
  if (!exit_verdict) return decided ? exit_decided : exit_undecided;
  return abelian == Truth::yes  ? exit_abelian
         : abelian == Truth::no ? exit_not_abelian
                                : exit_decided;
}

int worse(int a, int b) {
  // With --exit-verdict "abelian" is said only if nothing else is.
  static constexpr int order[] = {exit_abelian, exit_decided, exit_undecided, exit_not_abelian,
                                  exit_no,      exit_input,   exit_internal,  exit_interrupted};
  const auto rank = [](int code) { return std::find(std::begin(order), std::end(order), code); };
  return rank(a) > rank(b) ? a : b;
}

bool Settings::colors(int descriptor) const {
  if (color == "always") return true;
  if (color == "never") return false;
  const char* refused = std::getenv("NO_COLOR");
  if (refused != nullptr && *refused != '\0') return false;
  const char* terminal = std::getenv("TERM");
  if (terminal != nullptr && std::string(terminal) == "dumb") return false;
  return ::isatty(descriptor) != 0;
}

Style Settings::style() const {
  return {.color = output.empty() && colors(STDOUT_FILENO),
          .trace = trace,
          .quiet = quiet,
          .whole = verbose > 0,
          .solutions = wants_solutions()};
}

std::vector<std::pair<std::string, Expression>> Settings::settings() const {
  std::vector<std::pair<std::string, Expression>> all;
  for (const std::string& s : set) {
    auto origin = std::make_shared<Origin>();
    origin->file = "--set";
    origin->text = s;
    const auto equal = s.find('=');
    const std::string name = s.substr(0, equal);
    if (equal == std::string::npos || !is_identifier(name))
      throw InputError(*origin, Span{0, static_cast<std::uint32_t>(name.size())},
                       "a name with a value is expected", "write e.g. --set a=1/2");
    for (const auto& [known, value] : all)
      if (known == name)
        throw InputError(*origin, Span{0, static_cast<std::uint32_t>(name.size())},
                         "'" + name + "' gets a value twice");
    origin->offset = equal + 1;
    const OriginPtr place = origin;
    all.emplace_back(name,
                     parse_expression(std::string_view(place->text).substr(equal + 1), place));
  }
  return all;
}

void write_file(const std::string& path, const std::string& text) {
  struct stat existing = {};
  if (::stat(path.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode)) { // a pipe, a terminal
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw InputError(path, 0, 0, 1, "the file cannot be written");
    return;
  }
  const std::string temporary = path + ".part";
  {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) {
      std::remove(temporary.c_str());
      throw InputError(path, 0, 0, 1, "the file cannot be written");
    }
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) {
    std::remove(temporary.c_str());
    throw InputError(path, 0, 0, 1, "the file cannot be written");
  }
}

bool is_directory(const std::string& path) {
  std::error_code failed; // too long a name, no permission: then it is none
  return std::filesystem::is_directory(path, failed);
}

void make_directory(const std::string& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (failed && !is_directory(path))
    throw InputError(path, 0, 0, 1, "the directory cannot be made");
}

void close_file(std::ofstream& out, const std::string& path) {
  out.close();
  if (!out) throw InputError(path, 0, 0, 1, "the file cannot be written");
}

std::optional<Expression> formula(const std::string& option, const std::optional<std::string>& text,
                                  bool equation) {
  if (!text) return std::nullopt;
  return equation ? parse_ode(*text, option) : parse_expression(*text, option);
}

void write_output(const Settings& settings, const std::string& text) {
  if (!settings.output.empty() && settings.output != "-") return write_file(settings.output, text);
  const bool is_text = settings.format == "text";
  const bool brief = settings.one_page && settings.verbose == 0 && is_text;
  const std::string shown = brief ? one_page(text) : text;
  const std::string page = is_text ? for_standard_output(shown) : shown;
  const bool whole = std::fwrite(page.data(), 1, page.size(), stdout) == page.size();
  if (!whole || std::fflush(stdout) != 0)
    throw InputError("standard output", 0, 0, 1, "not everything could be written");
}

int report(const Settings& settings, const InputError& error) {
  std::fputs(render(error, settings.colors(STDERR_FILENO)).c_str(), stderr);
  return exit_input;
}

Entry Settings::document(const std::string& file) const {
  const Entry document = given ? parse_document(*given, file) : read_document(file);
  if (assume.empty()) return document;
  return document.merged(parse_document(assume_table(assume), "--assume"));
}

void complain(const Settings& settings, const std::string& message, const std::string& hint) {
  const bool color = settings.colors(STDERR_FILENO);
  const char* red = color ? "\033[1;31m" : "";
  const char* cyan = color ? "\033[1;36m" : "";
  const char* off = color ? "\033[0m" : "";
  std::string text =
      std::string("kovacic: ") + red + "error:" + off + " " + printable(message) + "\n";
  if (!hint.empty())
    text += std::string("  ") + cyan + "note:" + off + " " + printable(hint) + "\n";
  if (const std::size_t width = columns_of(STDERR_FILENO, 0); width > 0)
    text = folded(text, std::max<std::size_t>(width, 40));
  std::fputs(text.c_str(), stderr);
}

} // namespace kov::cli
