#pragma once

#include <string>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"

namespace mien::pipeline {

/// Arguments of `mien regress` and `mien regress approve` for a study.
struct StudyArguments {
  ProductionArguments production;
  std::string baseline;  ///< folder or commit; empty: the default folder
  std::string report;    ///< folder; empty: <out>/<study>-regression
  bool without_videos = false;
  int repeat = 1;        ///< number of times that motions and key frames are made
  double audits = 0.02;  ///< share of unchanged stimuli that are rendered and compared anyway
  std::string approver;
  std::string reason;
  int key_frames = 4;              ///< kept per stimulus by `approve`
  bool keep_videos = false;        ///< `approve` keeps the videos, too
  std::vector<std::string> given;  ///< names of used options that only apply to studies
};

/// Makes the motions and key frames of the study (and, unless `without_videos` is set, runs it),
/// compares them with its baseline and writes the report. Returns exit code 0 if the comparison
/// passes (Regression::passes), otherwise 1. Throws Error, for example if there is no baseline.
int regress_study(const StudyArguments& arguments, const Console& console);

/// Stores the current state of the study as its baseline. Returns the exit code.
int approve_study(const StudyArguments& arguments, const Console& console);

}  // namespace mien::pipeline
