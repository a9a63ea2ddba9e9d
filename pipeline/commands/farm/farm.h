#pragma once

#include <filesystem>
#include <string>

#include "pipeline/commands/line/console.h"
#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// What every command of `mien farm` is about.
struct FarmArguments {
  std::string manifest;
  std::string out = "out";
  std::string quality;  ///< empty: as the manifest says
};

/// The manifest, --out and --quality.
std::vector<CommandOption> farm_options(FarmArguments& arguments);

/// A study as the commands of a farm see it. Paths are absolute, because jobs begin elsewhere.
struct FarmStudy {
  /// Throws Faults for what is wrong with the manifest.
  FarmStudy(const FarmArguments& arguments, const Console& console);

  std::filesystem::path file;  ///< the manifest
  Production production;
  std::filesystem::path folder;  ///< out/<study>

  /// The program and all that tells it what to work on.
  StudyCall call(const FarmArguments& arguments) const;
};

/// How the study is told in commands that are proposed: "my.yaml --out /scratch".
std::string study_words(const FarmArguments& arguments);

// Subcommands of `mien farm`, one a source file.
Command farm_cancel_command();
Command farm_export_command();
Command farm_logs_command();
Command farm_resume_command();
Command farm_status_command();
Command farm_submit_command();
Command farm_worker_command();

}  // namespace mien::pipeline
