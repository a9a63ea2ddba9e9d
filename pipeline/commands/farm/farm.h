#pragma once

#include <filesystem>
#include <string>

#include "pipeline/commands/line/console.h"
#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/production/run/production.h"

namespace mien::pipeline {

/// Arguments of all commands of `mien farm`, which select the study.
struct FarmArguments {
  std::string manifest;
  std::string out = "out";
  std::string quality;  ///< empty: that of the manifest
};

/// The argument for the manifest and the options --out and --quality.
std::vector<CommandOption> farm_options(FarmArguments& arguments);

/// The path from the root, normalised, without a slash at its end.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// The manifest of a farm command.
struct FarmManifest {
  /// Reads the manifest. Throws Faults if it is invalid.
  FarmManifest(const FarmArguments& arguments, const Console& console);

  std::filesystem::path file;  ///< absolute
  Manifest manifest;
  std::filesystem::path folder;  ///< out/<study>, absolute
};

/// The study of a farm command. Paths are absolute, because jobs start in other folders.
struct FarmStudy {
  FarmStudy(const FarmArguments& arguments, const Console& console)
      : FarmStudy(FarmManifest(arguments, console), arguments) {}
  FarmStudy(FarmManifest read, const FarmArguments& arguments);

  std::filesystem::path file;  ///< the manifest
  Production production;
  std::filesystem::path folder;  ///< out/<study>

  /// The program and the arguments with which jobs call it.
  StudyCall call(const FarmArguments& arguments) const;
};

/// The study's arguments as text for suggested commands: "my.yaml --out /scratch".
std::string study_arguments(const FarmArguments& arguments);

// Subcommands of `mien farm`, one per source file.
Command farm_cancel_command();
Command farm_export_command();
Command farm_logs_command();
Command farm_resume_command();
Command farm_status_command();
Command farm_submit_command();
Command farm_worker_command();

}  // namespace mien::pipeline
