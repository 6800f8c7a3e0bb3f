#include "systems/classification_theorem.hpp"

#include "exact/lists.hpp"
#include "output/render.hpp"
#include "proofs/certificate_file.hpp"
#include "symbol/given_text.hpp"
#include "systems/classification_report.hpp"
#include "theorem/goals.hpp"
#include "theorem/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace kov::cli {
namespace {

std::string accepted_text(const std::string& file, const TheoremResult& result) {
  const std::size_t trusted = result.trusted_steps().size();
  std::string text = file + ", accepted, with " + std::to_string(trusted) +
                     (trusted == 1 ? " trusted step" : " trusted steps");
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
                SystemClassification& c, Report& report, const ReportAgain& again)
      : settings_(settings), arguments_(arguments), s_(s), c_(c), report_(report), again_(again) {}

  void prove() {
    try {
      proved_ = kov::prove(found_theorem(), options_of_proof());
      if (proved_->complete_but_for_open_parts()) take_from_proof();
      report_ = again_(proved_->bundle.empty() ? nullptr : &*proved_);
    } catch (const InternalError& why) {
      withdraw(why.what());
    } catch (const InputError&) {
      throw;
    } catch (const Error& why) { // there is no theorem file, or a limit
      why_not_ = why.what();
    }
  }
  void write_file_of_theorem() {
    namespace fs = std::filesystem;
    const fs::path to = fs::absolute(arguments_.as_theorem).parent_path();
    try {
      if (!is_given(arguments_.file)) {
        write_file(arguments_.as_theorem,
                   text_about(fs::absolute(arguments_.file).lexically_relative(to)));
        return tell("theorem", arguments_.as_theorem + ", for kovacic prove");
      }
      const fs::path system = system_file_beside(arguments_.as_theorem);
      write_file(arguments_.as_theorem, text_about(system.filename()));
      write_file(system, settings_.document(arguments_.file).file_text());
      tell("theorem",
           arguments_.as_theorem + ", for kovacic prove; the system is in " + system.string());
    } catch (const DomainError& why) {
      tell("theorem", std::string("none: ") + why.what());
    }
  }
  void write_certificate() {
    if (is_withdrawn_) return;
    if (!proved_ || proved_->bundle.empty()) {
      const std::string why = !proved_                     ? why_not_
                              : proved_->no_bundle.empty() ? why_not_proved(*proved_)
                                                           : proved_->no_bundle;
      tell("certificate", "no certificate: " + why);
      report_.json["certificate"] = {{"file", nullptr}, {"none", why}};
      return;
    }
    write_file(settings_.certificate, laid_out(proved_->bundle) + "\n");
    tell("certificate", accepted_text(settings_.certificate, *proved_));
    report_.json["certificate"] = {{"file", settings_.certificate},
                                   {"trusted_steps", proved_->trusted_steps().size()},
                                   {"open_regions", proved_->bundle_open}};
  }

private:
  [[nodiscard]] std::string text_about(const std::string& system_file) const {
    return theorem_file(found_theorem(), system_file, options_of_proof());
  }
  // What our own checker refuses is not told.
  void withdraw(const std::string& why) {
    const std::string because = "the certificate is refused, so nothing is claimed: " + why;
    is_withdrawn_ = true;
    c_ = {};
    c_.notes.push_back({ClassificationNote::What::limit, because});
    report_ = again_(nullptr);
    report_.json["certificate"] = {{"file", nullptr}, {"none", because}};
  }
  // The class of its statement, and its steps on trust; beside it are almost all parameters, and exponent
  // differences that exclude at some of their values.
  void take_from_proof() {
    std::vector<IntegralClass> excluded = proved_->nodes.front().excluded;
    if (!proved_->bundle.empty()) std::erase(c_.assumptions, only_declared_relations);
    c_.trusted.clear();
    for (std::string& step : proved_->trusted_steps())
      c_.trusted.push_back({Trusted::Step::by_author, std::move(step)});
    if (c_.almost_all) add_each_once(c_.trusted, c_.almost_all->by.trusted);
    for (const ClassifiedStratum* x : beside_the_theorem(c_)) {
      excluded.push_back(x->by.front().integrals);
      add_each_once(c_.trusted, x->by.front().trusted);
    }
    excluded = at_once(excluded);
    if (sentence(excluded) != sentence(c_.excluded)) c_.excluded = excluded;
  }
  [[nodiscard]] Theorem found_theorem() const {
    const std::string folder = folder_of(arguments_.file);
    Theorem theorem = goals(s_, c_, arguments_.file.substr(folder.size()));
    theorem.file = folder + "what classify found";
    return theorem;
  }
  [[nodiscard]] ProveOptions options_of_proof() const {
    ProveOptions options;
    options.found = true;
    options.decide = settings_.solver_options();
    options.decide.budget.give_by_default();
    return options;
  }
  void tell(const std::string& what, const std::string& text) {
    if (settings_.format == "text")
      report_.text += fmt::format("  {:<12}{}\n", what, wrapped(text, 14));
  }

  const Settings& settings_;
  const ClassifyArguments& arguments_;
  const System& s_;
  SystemClassification& c_;
  Report& report_;
  const ReportAgain& again_;
  std::optional<TheoremResult> proved_;
  std::string why_not_;
  bool is_withdrawn_ = false;
};

} // namespace

std::string system_file_beside(const std::string& theorem_file) {
  return std::filesystem::path(theorem_file).replace_extension(".system.toml");
}

void prove_again(const Settings& settings, const ClassifyArguments& arguments, const System& s,
                 SystemClassification& c, Report& report, const ReportAgain& again) {
  TheoremWriter writer(settings, arguments, s, c, report, again);
  writer.prove();
  if (!arguments.as_theorem.empty()) writer.write_file_of_theorem();
  if (!settings.certificate.empty()) writer.write_certificate();
}

} // namespace kov::cli
