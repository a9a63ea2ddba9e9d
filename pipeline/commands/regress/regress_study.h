#pragma once

#include <string>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"

namespace mien::pipeline {

/// What `mien regress` and `mien regress approve` take for a study.
struct StudyArguments {
  ProductionArguments production;
  std::string baseline;  ///< folder or commit; empty: the usual one
  std::string report;    ///< folder; empty: <out>/<study>-regression
  bool without_videos = false;
  int repeat = 1;
  double audits = 0.02;
  std::string approver;
  std::string reason;
  int key_frames = 4;
  bool keep_videos = false;
  std::vector<std::string> given;  ///< options that are of studies alone
};

/// Makes the study, compares it with its baseline and writes the report. Exit code 1 when something
/// differs; throws Error.
int regress_study(const StudyArguments& arguments, const Console& console);

/// Stores the study as it is now.
int approve_study(const StudyArguments& arguments, const Console& console);

}  // namespace mien::pipeline
