// The command line of kovacic: flags, sub-commands, exit codes.  No mathematics.

#include "command_table.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "output/page_width.hpp"
#include "output/progress.hpp"
#include "process/interrupt.hpp"
#include "process/reproducer.hpp"
#include "symbol/given_text.hpp"
#include "symbol/suggest.hpp"
#include "systems/case_file.hpp"

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <set>
#include <unistd.h>

namespace kov::cli {
namespace {

constexpr const char* examples =
    R"(Is a mechanical system integrable?  If not, a proof.  And y'' = r(z) y, solved or proved unsolvable.

  kovacic classify -H 'p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3'   for which b is it integrable?
  kovacic solve "x y'' + y' + x y = 0"                         any linear equation of second order
)";

constexpr const char* footer =
    R"(Exit codes: 0 decided, 1 a "no" from check, test, prove or verify, 2 usage or input error,
3 undecided, 4 internal error, 130 interrupted (143 by SIGTERM).  More: kovacic COMMAND --help, kovacic explain)";

bool is_a_file(const std::string& name) {
  std::error_code none;
  return std::filesystem::is_regular_file(name, none);
}

// "-hbar^2/2 psi'' = E psi" is no cluster of flags: a blank before it keeps it from CLI11.
void shield_equations(std::vector<std::string>& arguments) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
  constexpr std::string_view takes_formula = "er", no_beginning = "^*/' =";
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    std::string& a = arguments[i];
    const bool minus = a.size() > 1 && a[0] == '-' && a[1] != '-';
    if (!minus || a.find_first_not_of(plain) == std::string::npos || a[1] == 'o') continue;
    const bool value = takes_formula.find(a[1]) != std::string_view::npos && a.size() > 2 &&
                       no_beginning.find(a[2]) == std::string_view::npos; // -r'z^2'
    static const std::vector<std::string> options{"-e", "--ode", "-r", "--p", "--q", "--base"};
    const bool wanted = is_among(arguments[i - 1], options);
    if (!value && !wanted) a.insert(0, 1, ' ');
  }
}

void declare(CLI::App& app, Asked& asked) {
  app.name("kovacic");
  app.description(examples);
  app.footer(footer);
  app.set_version_flag("--version", std::string("version"),
                       "the version of kovacic and of its libraries");
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  for (const Command& command : command_table()) {
    CLI::App* one = app.add_subcommand(command.name, command.summary);
    Flags flags(*one, asked);
    command.declare(*one, flags, asked);
  }
}

// -o NAME.html is a page, also without --format html.
void settle_format(Settings& settings, const std::string& command,
                   const std::vector<std::string>& formats) {
  if (formats.empty() || command == "section" || settings.format != "text") return;
  for (const std::string ending : {"html", "tex", "json"}) {
    if (!settings.output.ends_with("." + ending)) continue;
    if (!is_among(ending, formats))
      throw InputError("-o", 0, 0, 1, command + " writes no " + ending,
                       "it writes " + enumerate(formats));
    settings.format = ending;
  }
}

int run(const CLI::App& app, Asked& asked) {
  const std::string name = app.get_name();
  Settings& settings = asked.settings;
  settle_format(settings, name, asked.formats[name]);
  settings.timeout = asked.timeout.value_or(asked.time_limits[name]);
  settings.one_page = asked.pages.contains(name);
  set_page_width(settings.output.empty() || settings.output == "-");
  set_colours(settings.style().color);
  if (!settings.quiet) show_that_it_works(name, settings.timeout);
  return std::ranges::find(command_table(), name, &Command::name)->run(app, asked);
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({}))
    names.push_back(sub->get_name());
  return names;
}

// What the arguments are about: the sub-command that was named, or the program.
const CLI::App& meant(const CLI::App& app, const std::vector<std::string>& arguments) {
  for (const CLI::App* sub : app.get_subcommands({}))
    if (!arguments.empty() && sub->get_name() == arguments.front()) return *sub;
  return app;
}

std::string option_hint(const CLI::App& app, const std::string& flag) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      known.push_back("--" + name);
    for (const std::string& name : option->get_snames())
      known.push_back("-" + name);
  }
  if (const auto near = nearest(flag, known)) return "did you mean " + *near + "?";
  return "see: kovacic " + (app.get_parent() != nullptr ? app.get_name() + " " : "") + "--help";
}

bool known_elsewhere(const CLI::App& app, const std::string& flag) {
  const auto commands = app.get_subcommands({});
  return std::ranges::any_of(commands, [&](const CLI::App* command) {
    return command->get_option_no_throw(flag) != nullptr;
  });
}

int usage_error(const CLI::App& app, const Settings& settings, const CLI::ParseError& error,
                const std::vector<std::string>& arguments) {
  const CLI::App& sub = meant(app, arguments);
  const std::vector<std::string> commands = command_names(app);
  if (sub.get_parent() == nullptr && !arguments.empty() && arguments.front().front() != '-') {
    const auto near = nearest(arguments.front(), commands);
    complain(settings, "unknown command '" + arguments.front() + "'",
             near ? "did you mean " + *near + "?" : "commands: " + enumerate(commands));
    return exit_input;
  }
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    const std::vector<std::string> extra = sub.remaining();
    const std::string first = extra.empty() ? std::string("?") : extra.front();
    const bool flag = first.starts_with('-');
    if (flag && known_elsewhere(app, first.substr(0, first.find('=')))) {
      complain(settings, sub.get_name() + " has no use for " + first.substr(0, first.find('=')),
               "see: kovacic " + sub.get_name() + " --help");
      return exit_input;
    }
    complain(settings, (flag ? "unknown option '" : "unexpected argument '") + first + "'",
             flag ? option_hint(sub, first.substr(0, first.find('='))) : option_hint(sub, ""));
    return exit_input;
  }
  std::string message = error.what();
  std::ranges::replace(message, '\n', ' ');
  if (const auto at = message.find(": 1 required "); at != std::string::npos)
    message = message.substr(0, at) + " needs a value";
  if (arguments.empty()) message = "a command is expected: " + enumerate(commands);
  complain(settings, message,
           "see: kovacic " + (sub.get_parent() != nullptr ? sub.get_name() + " " : "") + "--help");
  return exit_input;
}

int main(int argc, char** argv) {
  remember_command(argc, argv);
  Asked asked;
  CLI::App app;
  declare(app, asked);
  try {
    std::vector<std::string> arguments(argv + std::min(1, argc), argv + argc);
    const auto names = command_names(app);
    if (!arguments.empty() && is_a_file(arguments.front()) && !is_among(arguments.front(), names))
      arguments.insert(arguments.begin(), command_for(arguments.front()));
    if (!arguments.empty() && (arguments.front() == "-H" || arguments.front() == "-L"))
      arguments.insert(arguments.begin(), "classify");
    if (!arguments.empty() && (arguments.front() == "solve" || arguments.front() == "monodromy" ||
                               arguments.front() == "spectrum"))
      shield_equations(arguments);
    std::ranges::reverse(arguments); // as CLI11 takes them
    app.parse(std::move(arguments));
    catch_interrupts();
    // files are read in a child process, which has no standard error
    tell_readings([told = std::set<std::string>(), to = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)](
                      const std::string& reading) mutable {
      if (told.insert(reading).second) ::dprintf(to, "kovacic: %s\n", printable(reading).c_str());
    });
    const int exit = run(*app.get_subcommands().front(), asked);
    return exit == exit_interrupted && ending_signal == SIGTERM ? exit_terminated : exit;
  } catch (const CLI::CallForVersion&) {
    return version();
  } catch (const CLI::Success& help) {
    return app.exit(help); // --help, on standard output
  } catch (const CLI::ParseError& error) {
    return usage_error(app, asked.settings, error,
                       std::vector<std::string>(argv + std::min(1, argc), argv + argc));
  } catch (const InputError& error) {
    return report(asked.settings, error);
  } catch (const std::exception& error) {
    complain(asked.settings, "internal error: " + std::string(error.what()),
             "this is an error of the program, not of the input");
    leave_reproducer(error.what());
    return exit_internal;
  }
}

} // namespace
} // namespace kov::cli

int main(int argc, char** argv) { return kov::cli::main(argc, argv); }
