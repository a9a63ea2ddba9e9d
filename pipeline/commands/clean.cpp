#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/verification_text.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/keep.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/stale_artifacts.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct CleanOptions {
  std::string study;
  std::string out = "out";
  bool stale = false;
  std::vector<ArtifactKind> keep;
  bool dry_run = false;
  bool json = false;
};

WordValues<ArtifactKind> kinds_by_name() {
  WordValues<ArtifactKind> kinds;
  for (const ArtifactKindName& one : artifact_kinds) kinds.emplace_back(one.name, one.kind);
  return kinds;
}

Cleaning stale_cleaned(const fs::path& folder, const Production& production, bool dry_run) {
  Cleaning cleaning;
  if (!fs::is_directory(folder)) return cleaning;
  std::optional<Store> store;
  if (!dry_run) store.emplace(folder, Sharing::exclusive);
  for (Receipt& artifact : stale_in(folder, production)) {
    const bool goes = dry_run ? is_removable(folder, artifact) : remove_artifact(*store, artifact);
    if (goes) cleaning.bytes += artifact.size;
    (goes ? cleaning.removed : cleaning.changed).push_back(std::move(artifact));
  }
  return cleaning;
}

/// The folder of a study given by the folder itself, its provenance.json or its manifest.
fs::path study_folder(const CleanOptions& options, const Console& console) {
  std::error_code unknown;
  const fs::path given = options.study;
  if (fs::is_directory(given, unknown) || given.filename() == "provenance.json")
    return study_folder_of(given);
  const Manifest manifest =
      load_with_warnings(resolve_manifest(options.study, console), options.out, console);
  return fs::path(options.out) / manifest.study;
}

Cleaning cleaned(const CleanOptions& options, const fs::path& folder, const Console& console) {
  if (!options.stale)
    return options.dry_run ? all_but(folder, options.keep) : remove_all_but(folder, options.keep);
  // study_folder has printed the warnings of this manifest.
  const Production production(
      load_manifest(resolve_manifest(options.study, console), process_environment(), options.out),
      {});
  return stale_cleaned(folder, production, options.dry_run);
}

/// Prints how many links of the report are broken by removed files. The report itself is not
/// changed, since the provenance contains its hash.
void print_dead_links(const Cleaning& cleaning, const fs::path& folder, const CleanOptions& options,
                      const Console& console) {
  const int links = options.stale ? 0 : dead_links(folder, cleaning);
  if (links == 0) return;
  console.out << fmt::format(
      "report.html: {} of its links {} broken until mien run makes the files again; see {}\n",
      links, options.dry_run ? "would be" : "are", not_kept_path);
}

void print_result(const Cleaning& cleaning, const fs::path& folder, const CleanOptions& options,
                  const Console& console) {
  const std::string removed = options.dry_run ? "would remove " : "removed ";
  for (const Receipt& artifact : cleaning.removed) {
    if (artifact.path.starts_with(".mien/")) continue;
    console.out << removed << artifact.path;
    if (!options.stale) console.out << ", " << size_text(artifact.size);
    console.out << '\n';
  }
  for (const std::string& path : shown_paths(cleaning.changed))
    console.out << (options.dry_run ? "would leave " : "left ") << path
                << ", which was changed after it was made\n";
  print_dead_links(cleaning, folder, options, console);
  if (cleaning.removed.empty() && cleaning.changed.empty()) {
    console.out << folder.string() << ": nothing to remove\n";
  } else if (!options.stale || options.dry_run) {
    console.out << folder.string() << ": " << removed << size_text(cleaning.bytes) << '\n';
  }
}

ordered_json as_json(const Cleaning& cleaning, const fs::path& folder,
                     const CleanOptions& options) {
  return {{"folder", folder.string()},
          {"dry_run", options.dry_run},
          {"removed", shown_paths(cleaning.removed)},
          {"changed", shown_paths(cleaning.changed)},
          {"dead_links", options.stale ? 0 : dead_links(folder, cleaning)},
          {"bytes", cleaning.bytes}};
}

int clean(const CleanOptions& options, const Console& console) {
  if (!options.stale && options.keep.empty())
    throw Error(
        "nothing to remove was specified",
        "use --stale to remove what the manifest no longer specifies, or --keep videos,sheets "
        "to remove all other kinds");
  const fs::path folder = study_folder(options, console);
  const Cleaning cleaning = cleaned(options, folder, console);
  if (options.json) {
    console.out << as_json(cleaning, folder, options).dump(2) << '\n';
  } else {
    print_result(cleaning, folder, options, console);
  }
  return exit_done;
}

}  // namespace

Command clean_command() {
  const auto options = std::make_shared<CleanOptions>();
  return {
      .name = "clean",
      .summary = "Remove artifacts that are no longer needed",
      .options =
          {argument("study", &options->study,
                    "Manifest (YAML), or the name of an installed manifest (listed by mien "
                    "manifests); with --keep also the "
                    "folder of a study, or its provenance.json"),
           flag("--stale", &options->stale,
                "Remove artifacts that the manifest no longer specifies (listed by mien plan)"),
           choice("--keep", options->keep, kinds_by_name(),
                  "Remove all kinds of artifacts except these, separated by commas")
               .excludes("--stale"),
           flag("--dry-run", &options->dry_run, "List what would be removed, and remove nothing"),
           option("--out,-o", &options->out, "Folder of all studies; results are in <out>/<study>")
               .with_default(),
           flag("--json", &options->json, "List of removed files as JSON on standard output")},
      .notes =
          "Only files that mien made and that are unchanged are removed. provenance.json, inputs/ "
          "and the report are kept. not-kept.json records what --keep removed, so that mien verify "
          "does not report it as missing; mien run makes the removed artifacts again.\n\n"
          "Examples:\n"
          "  mien clean --stale my.yaml\n"
          "  mien clean out/my-study --keep videos,sheets --dry-run",
      .run = [options](const Console& console) { return clean(*options, console); }};
}

}  // namespace mien::pipeline
