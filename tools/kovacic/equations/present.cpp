#include "equations/present.hpp"

#include "decide/afterwards.hpp"
#include "output/render_program.hpp"
#include "process/reproducer.hpp"
#include "proofs/certificate_file.hpp"
#include "report/render_theorem.hpp"

namespace kov::cli {

void report_failure(const Settings& settings, const Answer& answer) {
  if (answer.error) {
    report(settings, *answer.error);
  } else if (answer.exit == exit_internal) {
    complain(settings, "internal error: " + answer.internal,
             "this is an error of the program, not of the input");
    leave_reproducer(answer.internal);
  } else if (answer.exit == exit_interrupted) {
    complain(settings, "interrupted");
  }
}

namespace {

// A comment, in a format that has them.
std::string remark(const Settings& settings, std::string line) {
  if (settings.format == "maxima") {
    for (auto at = line.find("*/"); at != std::string::npos; at = line.find("*/", at))
      line.insert(at + 1, " ");
    return "/* " + line + " */\n";
  }
  const bool script = program_of(settings.format).has_value();
  return (script ? "# " : settings.format == "tex" ? "% " : "  ") + line + "\n";
}

std::string failures(const Settings& settings, const Answer& answer) {
  std::string text;
  for (const Json& what : answer.result.value("failed", Json::array()))
    text += remark(settings, what.get<std::string>());
  return text;
}

std::string page(const Settings& settings, const Answer& answer, const std::string& title) {
  if (settings.format == "json") return indented(answer.result);
  if (settings.format == "tex")
    return failures(settings, answer) + page_of_result(answer.result, title, report::Markup::tex);
  if (settings.format == "html") return page_of_result(answer.result, title, report::Markup::html);
  if (const auto program = program_of(settings.format))
    return failures(settings, answer) + program_text(answer.result, *program);
  std::string text = text_of_result(answer.result, title, settings.style());
  if (settings.verbose > 0 && answer.result.at("seconds").is_number()) {
    char line[64];
    std::snprintf(line, sizeof line, "  time      %.1f ms\n",
                  1000 * answer.result.at("seconds").get<double>());
    text += line;
  }
  return text;
}

// Where the whole cannot be laid out: comments in a script.
std::string verdict_only(const Settings& settings, const Json& result, const std::string& failed) {
  const auto value = [&](const char* key) {
    const Json& j = result.at(key);
    return j.is_null() ? std::string("not known") : j.is_string() ? j.get<std::string>() : dump(j);
  };
  std::string text;
  for (const std::string& line :
       {about_given(result), "y'' = (" + value("r") + ") y", "group: " + value("group"),
        "identity component: " + value("identity_component") + ", abelian: " + value("abelian"),
        failed})
    if (!line.empty()) text += remark(settings, line);
  return text;
}

} // namespace

std::string presented(const Settings& settings, const Answer& answer, const std::string& title) {
  if (answer.result.is_null()) return {};
  std::string text, failed;
  try {
    failed = failure_of("the layout", [&] { text = page(settings, answer, title); });
  } catch (const OutOfBudget& limit) {
    failed = limit.what();
  }
  return failed.empty() ? text : verdict_only(settings, answer.result, failed);
}

int present(const Settings& settings, Answer answer, const std::string& title) {
  try {
    if (!settings.certificate.empty() && !answer.certificate.empty()) {
      write_file(settings.certificate, laid_out(answer.certificate) + "\n");
      answer.result["certificate_file"] = settings.certificate;
    }
    if (!settings.certificate.empty() && !answer.loops_certificate.empty()) {
      const std::string path = loops_file(settings.certificate);
      write_file(path, laid_out(answer.loops_certificate) + "\n");
      answer.result["loops_certificate_file"] = path;
    }
    if (answer.result.contains("no_certificate"))
      complain(settings,
               "no certificate: " + answer.result.at("no_certificate").get<std::string>());
    std::string text = presented(settings, answer, title);
    if (!text.empty() && settings.format == "html")
      text = report::html_page(answer.result.value("equation", Json()).is_string()
                                   ? answer.result.at("equation").get<std::string>()
                                   : title,
                               text);
    if (!text.empty()) write_output(settings, text);
  } catch (const InputError& e) {
    return report(settings, e);
  }
  report_failure(settings, answer);
  const int code = exit_code(settings, answer);
  const bool unproved = code == exit_decided && answer.result.contains("no_certificate");
  return unproved ? exit_undecided : code;
}

} // namespace kov::cli
