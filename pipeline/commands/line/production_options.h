#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// What `run` and `plan` take on the command line.
struct ProductionArguments {
  std::string manifest;
  std::string out = "out";
  std::vector<std::string> only;
  std::string quality;  ///< empty: as the manifest says
  int jobs = 0;         ///< 0: one a processor
  bool json = false;
  bool exclusive = false;
};

/// --quality
CommandOption quality_option(std::string& quality);

std::vector<CommandOption> production_options(ProductionArguments& arguments);

/// Those of them that tell which study it is and with how many threads it is made.
std::vector<CommandOption> manifest_options(ProductionArguments& arguments);

int jobs_of(const ProductionArguments& arguments);
ProductionOptions options_of(const ProductionArguments& arguments);

/// Warnings of a manifest, a line each; nothing when there are none.
void tell_warnings(const std::vector<Fault>& warnings, const Console& console);

/// What is left of earlier runs, and how to be rid of it; nothing when there is none.
void tell_stale(const std::vector<std::string>& stale, const ProductionArguments& arguments,
                const Console& console);

/// Makes what is missing of a study, with progress on `err`. Throws for the first task that failed,
/// and Interrupted.
void make_study(Production& production, const std::filesystem::path& folder,
                const ProductionArguments& arguments, const Console& console);

/// out/<study>
std::filesystem::path folder_of(const ProductionArguments& arguments, const Manifest& manifest);

}  // namespace mien::pipeline
