#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Command-line arguments of `run`, `plan` and other commands that need the artifacts of a study.
struct ProductionArguments {
  std::string manifest;
  std::string out = "out";
  std::vector<std::string> only;
  std::string quality;  ///< empty: that of the manifest
  int jobs = 0;         ///< number of threads; 0: one per processor
  bool json = false;
  bool exclusive = false;  ///< only for `run`: no other process may use the study's folder
};

/// The option --quality.
CommandOption quality_option(std::string& quality);

std::vector<CommandOption> production_options(ProductionArguments& arguments);

/// The options in production_options that select the study, its quality and the number of threads.
std::vector<CommandOption> manifest_options(ProductionArguments& arguments);

int jobs_of(const ProductionArguments& arguments);
ProductionOptions options_of(const ProductionArguments& arguments);

/// Loads the manifest in a file, see load_manifest, and prints its warnings.
Manifest load_with_warnings(const std::filesystem::path& file, const std::filesystem::path& out,
                            const Console& console);

/// Prints the warnings of a manifest, one per line.
void print_warnings(const std::vector<Fault>& warnings, const Console& console);

/// Lists stale artifacts of earlier runs and how to remove them; prints nothing if there are none.
void print_stale_artifacts(const std::vector<std::string>& stale,
                           const ProductionArguments& arguments, const Console& console);

/// Runs the missing tasks of a study and shows progress on `console.err`. If a task failed, throws
/// Error (for invalid input) or std::runtime_error with the message of the first failed task;
/// throws Interrupted if stopped.
void make_study(Production& production, const std::filesystem::path& folder,
                const ProductionArguments& arguments, const Console& console);

/// The study's folder, out/<study>.
std::filesystem::path folder_of(const ProductionArguments& arguments, const Manifest& manifest);

}  // namespace mien::pipeline
