#include "pipeline/commands/production_options.h"

#include <algorithm>
#include <thread>

#include <CLI/CLI.hpp>

#include "motion/text/shell_word.h"

namespace mien::pipeline {

void add_manifest_options(CLI::App& command, ProductionArguments& arguments) {
  command
      .add_option(
          "manifest", arguments.manifest,
          "Manifest (YAML), the name of one of mien manifests, or a study's provenance.json")
      ->required();
  command
      .add_option("--out,-o", arguments.out, "Folder of all studies; results go to <out>/<study>")
      ->capture_default_str();
  command.add_option("--quality", arguments.quality, "Instead of the manifest's quality")
      ->check(CLI::IsMember({"draft", "standard", "final"}));
  command.add_option("--jobs,-j", arguments.jobs, "Tasks at a time (default: one a processor)")
      ->check(CLI::Range(1, 1024));
}

void add_production_options(CLI::App& command, ProductionArguments& arguments) {
  add_manifest_options(command, arguments);
  command
      .add_option("--only", arguments.only,
                  "Ids of stimuli, overlays or sheets, separated by commas")
      ->delimiter(',');
  command.add_flag("--json", arguments.json, "Result as JSON on standard output");
}

int jobs_of(const ProductionArguments& arguments) {
  if (arguments.jobs > 0) return arguments.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ProductionOptions options_of(const ProductionArguments& arguments) {
  ProductionOptions options;
  if (arguments.quality == "draft") options.quality = Quality::draft;
  if (arguments.quality == "standard") options.quality = Quality::standard;
  if (arguments.quality == "final") options.quality = Quality::final;
  options.only = arguments.only;
  options.jobs = jobs_of(arguments);
  return options;
}

void tell_stale(const std::vector<std::string>& stale, const ProductionArguments& arguments,
                const Console& console) {
  if (stale.empty()) return;
  console.out << "left from earlier runs:\n";
  for (const std::string& path : stale) console.out << "  " << path << '\n';
  const std::string out =
      arguments.out == "out" ? "" : " --out " + motion::shell_path(arguments.out);
  console.out << "mien clean --stale " << motion::shell_path(arguments.manifest) << out
              << " removes them\n";
}

std::filesystem::path folder_of(const ProductionArguments& arguments, const Manifest& manifest) {
  return std::filesystem::path(arguments.out) / manifest.study;
}

}  // namespace mien::pipeline
