#include "pipeline/commands/line/production_options.h"

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "motion/error.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

CommandOption quality_option(std::string& quality) {
  std::vector<std::string> names;
  for (const auto& [name, value] : quality_words) names.emplace_back(name);
  return option("--quality", &quality, "Quality to use instead of the manifest's").one_of(names);
}

std::vector<CommandOption> manifest_options(ProductionArguments& arguments) {
  return {
      argument("manifest", &arguments.manifest,
               "Manifest (YAML), the name of an installed manifest (listed by mien manifests), or "
               "a study's provenance.json"),
      option("--out,-o", &arguments.out, "Folder of all studies; results go to <out>/<study>")
          .with_default(),
      quality_option(arguments.quality),
      option("--jobs,-j", &arguments.jobs, "Number of threads (default: one per processor)")
          .between(1, 1024)};
}

std::vector<CommandOption> production_options(ProductionArguments& arguments) {
  return all_of(
      manifest_options(arguments),
      option("--only", &arguments.only, "Ids of stimuli, overlays or sheets, separated by commas")
          .with_commas(),
      flag("--json", &arguments.json, "Result as JSON on standard output"));
}

int jobs_of(const ProductionArguments& arguments) {
  if (arguments.jobs > 0) return arguments.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ProductionOptions options_of(const ProductionArguments& arguments) {
  ProductionOptions options;
  options.quality = meaning_of(quality_words, arguments.quality);
  options.only = arguments.only;
  options.jobs = jobs_of(arguments);
  return options;
}

Manifest load_with_warnings(const std::filesystem::path& file, const std::filesystem::path& out,
                            const Console& console) {
  Manifest manifest = load_manifest(file, process_environment(), out);
  print_warnings(manifest.renamed, console);
  return manifest;
}

void print_warnings(const std::vector<Fault>& warnings, const Console& console) {
  if (!warnings.empty()) console.err << fault_lines(warnings, "warning: ") << '\n';
}

void print_stale_artifacts(const std::vector<std::string>& stale,
                           const ProductionArguments& arguments, const Console& console) {
  if (stale.empty()) return;
  console.out << "left over from earlier runs:\n";
  for (const std::string& path : stale) console.out << "  " << path << '\n';
  const std::string out =
      arguments.out == "out" ? "" : " --out " + motion::shell_path(arguments.out);
  console.out << "mien clean --stale " << motion::shell_path(arguments.manifest) << out
              << " removes them\n";
}

std::filesystem::path folder_of(const ProductionArguments& arguments, const Manifest& manifest) {
  return std::filesystem::path(arguments.out) / manifest.study;
}

void make_study(Production& production, const std::filesystem::path& folder,
                const ProductionArguments& arguments, const Console& console) {
  RunResult result;
  {
    Progress progress(console.err, console.err_is_terminal, production.graph(),
                      quick_plan(production.graph(), folder), steady_seconds);
    result = run(production, folder, jobs_of(arguments), console.stop, progress.observer());
  }
  if (result.was_interrupted) throw Interrupted{};
  for (const TaskOutcome& outcome : result.outcomes) {
    if (outcome.state != TaskState::failed) continue;
    if (outcome.is_bad_input)
      throw Error({outcome.error}, "the study cannot be made", "see mien run for all faults");
    throw std::runtime_error(outcome.error);
  }
}

}  // namespace mien::pipeline
