#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "pipeline/checks/checked_manifest.h"
#include "pipeline/commands/cli.h"
#include "pipeline/commands/installed_manifests.h"
#include "pipeline/commands/production_options.h"
#include "pipeline/production/run.h"
#include "pipeline/tasks/stale.h"

namespace mien::pipeline {

namespace {

struct CleanOptions {
  std::string manifest;
  std::string out = "out";
  bool stale = false;
  bool json = false;
};

struct Cleaned {
  std::vector<Receipt> removed;
  std::vector<Receipt> changed;  ///< since they were made, and so left
};

Cleaned clean_folder(const std::filesystem::path& folder, const Production& production) {
  Cleaned cleaned;
  if (!std::filesystem::is_directory(folder)) return cleaned;
  const Store store(folder, Sharing::exclusive);
  for (const Receipt& artifact : stale_in(folder, production))
    (remove_artifact(store, artifact) ? cleaned.removed : cleaned.changed).push_back(artifact);
  return cleaned;
}

int clean(const CleanOptions& options, const Console& console) {
  if (!options.stale) {
    throw Error("there is nothing else to clean than --stale",
                "mien clean --stale removes what the manifest no longer makes");
  }
  const Production production(
      load_manifest(manifest_meant(options.manifest, console), process_environment(), options.out),
      {});
  const std::filesystem::path folder =
      std::filesystem::path(options.out) / production.manifest().study;
  const Cleaned cleaned = clean_folder(folder, production);
  const std::vector<std::string> removed = shown_paths(cleaned.removed);
  const std::vector<std::string> changed = shown_paths(cleaned.changed);
  if (options.json) {
    const nlohmann::ordered_json result = {
        {"folder", folder.string()}, {"removed", removed}, {"changed", changed}};
    console.out << result.dump(2) << '\n';
    return exit_done;
  }
  for (const std::string& path : removed) console.out << "removed " << path << '\n';
  for (const std::string& path : changed)
    console.out << "left " << path << ", which was changed since it was made\n";
  if (removed.empty() && changed.empty()) console.out << folder.string() << ": nothing to remove\n";
  return exit_done;
}

}  // namespace

void add_clean_command(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("clean", "Remove artifacts that a manifest no longer makes");
  const auto options = std::make_shared<CleanOptions>();
  command
      ->add_option("manifest", options->manifest,
                   "Manifest (YAML), or the name of one of mien manifests")
      ->required();
  command->add_flag("--stale", options->stale,
                    "What the manifest does not make any more: mien plan lists it");
  command
      ->add_option("--out,-o", options->out, "Folder of all studies; results are in <out>/<study>")
      ->capture_default_str();
  command->add_flag("--json", options->json, "What was removed as JSON on standard output");
  command->footer(
      "\nOnly what mien made and nobody has changed is removed.\n\nExample:\n"
      "  mien clean --stale my.yaml");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return clean(*options, console); };
  });
}

}  // namespace mien::pipeline
