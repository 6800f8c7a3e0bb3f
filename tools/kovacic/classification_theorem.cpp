#include "classification_theorem.hpp"

#include "certificate_file.hpp"
#include "classification_report.hpp"
#include "output_format.hpp"
#include "render.hpp"
#include "theorem/goals.hpp"
#include "theorem/prove.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace kov::cli {
namespace {

std::string accepted_text(const std::string& file, const TheoremResult& result) {
  std::string text = file + ", accepted, with " + std::to_string(result.bundle_trusted) +
                     (result.bundle_trusted == 1 ? " trusted step" : " trusted steps");
  if (result.bundle_open > 0) text += "; nothing is proved of what is open";
  return text;
}

std::string why_not_proved(const TheoremResult& result) {
  for (const NodeResult& n : result.nodes)
    if (n.node.kind == NodeKind::cover && n.status != NodeStatus::proved) return n.summary;
  for (const NodeResult& n : result.nodes)
    if (n.status != NodeStatus::proved && n.status != NodeStatus::trusted &&
        n.node.kind != NodeKind::open_part)
      return n.node.title + ": " + n.summary;
  return "the theorem is not proved";
}

class TheoremWriter {
public:
  TheoremWriter(const Settings& settings, const ClassifyArguments& arguments, const System& s,
                const SystemClassification& c, Report& report)
      : settings_(settings), arguments_(arguments), s_(s), c_(c), report_(report) {}

  void write_file_of_theorem() {
    namespace fs = std::filesystem;
    const fs::path to = fs::absolute(arguments_.as_theorem).parent_path();
    const std::string system = fs::absolute(arguments_.file).lexically_relative(to).string();
    try {
      write_file(arguments_.as_theorem, theorem_file(s_, c_, system));
      tell("theorem", arguments_.as_theorem + ", for kovacic prove");
    } catch (const DomainError& why) {
      tell("theorem", std::string("none: ") + why.what());
    }
  }
  // What is proved again, and the bundle is accepted: a page shows it.  Without it the page is as it was.
  void write_page(const std::string& format) {
    try {
      const TheoremResult& result = proved();
      if (!result.bundle.empty()) report_.text = classification_page(s_, c_, format, &result);
    } catch (const InternalError& why) {
      withdraw(why.what());
    } catch (const InputError&) {
      throw;
    } catch (const Error&) { // there is no theorem file, or a limit
    }
  }
  void write_certificate() {
    Json told;
    try {
      const TheoremResult& result = proved();
      if (result.bundle.empty())
        throw DomainError(result.no_bundle.empty() ? why_not_proved(result) : result.no_bundle);
      write_file(settings_.certificate, laid_out(result.bundle) + "\n");
      told = {{"file", settings_.certificate},
              {"trusted_steps", result.bundle_trusted},
              {"open_regions", result.bundle_open}};
      tell("certificate", accepted_text(settings_.certificate, result));
    } catch (const InternalError& why) {
      return withdraw(why.what());
    } catch (const InputError&) {
      throw;
    } catch (const Error& why) {
      told = {{"file", nullptr}, {"none", why.what()}};
      tell("certificate", std::string("no certificate: ") + why.what());
    }
    report_.json["certificate"] = std::move(told);
  }

private:
  // What our own checker refuses is not told.
  void withdraw(const std::string& why) {
    const std::string because = "the certificate is refused, so nothing is claimed: " + why;
    report_.exit = exit_undecided;
    report_.text = heading(s_.file, s_.title) +
                   fmt::format("\n  OPEN\n  {:<12}{}\n", "because", wrapped(because, 14));
    report_.json["status"] = to_string(ClassificationStatus::open);
    report_.json["statement"] = because;
    report_.json["strata"] = report_.json["theorems"] = Json::array();
    report_.json["integrals_class"] = report_.json["almost_all"] = nullptr;
    report_.json["certificate"] = {{"file", nullptr}, {"none", because}};
  }
  const TheoremResult& proved() {
    if (proved_) return *proved_;
    const auto slash = arguments_.file.rfind('/');
    const std::string folder =
        slash == std::string::npos ? "" : arguments_.file.substr(0, slash + 1);
    const std::string text = theorem_file(s_, c_, arguments_.file.substr(folder.size()));
    ProveOptions options;
    options.found = true;
    options.decide = settings_.solver_options();
    options.decide.budget.give_by_default();
    proved_ =
        kov::prove(read_theorem(parse_document(text, folder + "what classify found")), options);
    return *proved_;
  }
  void tell(const std::string& what, const std::string& text) {
    if (output_format(settings_) == "text")
      report_.text += fmt::format("  {:<12}{}\n", what, wrapped(text, 14));
  }

  const Settings& settings_;
  const ClassifyArguments& arguments_;
  const System& s_;
  const SystemClassification& c_;
  Report& report_;
  std::optional<TheoremResult> proved_;
};

} // namespace

void write_theorem(const Settings& settings, const ClassifyArguments& arguments, const System& s,
                   const SystemClassification& c, Report& report) {
  TheoremWriter writer(settings, arguments, s, c, report);
  if (!arguments.as_theorem.empty()) writer.write_file_of_theorem();
  const std::string format = output_format(settings);
  if (format == "tex" || format == "html") writer.write_page(format);
  if (!settings.certificate.empty()) writer.write_certificate();
}

} // namespace kov::cli
