#include "sections/section.hpp"

#include "commands.hpp"
#include "exact/lists.hpp"
#include "flow/scene/system_scene.hpp"
#include "sections/section_files.hpp"
#include "symbol/document.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace kov::cli {

void declare_section(CLI::App& command, SectionArguments& a) {
  command.add_option("FILE", a.files, "scenes, and system files with [scene]; - is standard input")
      ->type_name("");
  command
      .add_option("--pictures", a.formats,
                  "png,svg,pdf (the default), html (a page, for a system file) or none")
      ->delimiter(',')
      ->check(CLI::IsMember({"png", "svg", "pdf", "html", "none"}).description(""))
      ->type_name("LIST");
  command.add_flag("--resume", a.resume, "go on with a scan where it was stopped or killed");
  command
      .add_option("--part", a.part,
                  "the K-th of N parts of a scan, into a file of its own; --resume merges them")
      ->type_name("K/N");
  command.add_option("-j,--jobs", a.threads, "threads")
      ->check(CLI::Range(1, 256).description(""))
      ->type_name("N");
  command.add_flag("--fixed-points", a.fixed_points,
                   "find and prove fixed points of the section map, with their stability");
  command.add_flag("--homoclinic", a.homoclinic,
                   "prove chaos: a transverse homoclinic point (system files)");
  command
      .add_option("--period", a.period, "of --fixed-points, --in and --homoclinic (system files)")
      ->check(CLI::Range(1, 64).description(""))
      ->type_name("N");
  command
      .add_option("--in", a.rectangle,
                  "prove which are all fixed points of the N-th return in this rectangle of the "
                  "picture (system files)")
      ->delimiter(',')
      ->expected(4)
      ->type_name("A,B,C,D");
  command.add_option("--scene", a.names, "only these scenes of a system file")
      ->delimiter(',')
      ->type_name("NAMES");
  command
      .add_option("--lanes", a.lanes,
                  "orbits at a time in a thread: 1, 4, 8; 0 = what is fastest here")
      ->check(CLI::IsMember({0, 1, 4, 8}).description(""))
      ->type_name("N");
}

namespace {

// The scene that was chosen for a system without one.
void tell_scene(const Entry& document) {
  const Entry& scene = document.at("scene").array().front();
  std::string chosen = scene.at("section").string() + " = 0";
  for (const char* key : {"levels", "set"})
    if (const Entry* table = scene.find(key))
      for (const auto& [name, value] : table->members())
        chosen += ", " + name + " = " + value.string();
  std::fprintf(stderr,
               "kovacic: no scene: drawn on %s (--energy, --set; kovacic new scene -H '...' "
               "writes it as a file)\n",
               printable(chosen).c_str());
}

} // namespace

int section(const Settings& settings, const SectionArguments& arguments) {
  int code = exit_decided;
  const auto begun = Clock::now();
  for (const std::string& file : arguments.files) {
    const double left = settings.timeout - seconds_since(begun);
    const double seconds = settings.timeout > 0 ? std::max(left, 1e-3) : 0;
    Entry document = settings.document(file);
    const bool has_scene = !is_system_document(document) || flow::has_system_scenes(document);
    if (has_scene && (!settings.energy.empty() || !settings.set.empty()))
      throw InputError(file, 0, 0, 1, "--energy and --set are for a system without a scene",
                       "the scene says it: levels = { H = ... }, set = { ... }");
    if (!has_scene) {
      document = parse_document(with_scene(settings, document.file_text()), file);
      if (!settings.quiet) tell_scene(document);
    }
    if (!flow::has_system_scenes(document))
      throw InputError(file, 0, 0, 1, "this system has no scene",
                       "kovacic new scene shows a [[scene]] table");
    code = std::max(code, system_sections(settings, arguments, file, document, seconds));
    if (code == exit_interrupted) break;
  }
  return code;
}

} // namespace kov::cli
