#pragma once

#include <string>
#include <vector>

#include "motion/measures/differences/motion_tolerance.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// What `mien regress` was asked to do.
struct RegressOptions {
  std::string before;              ///< what was approved
  std::string now;                 ///< what is to be judged
  std::vector<std::string> takes;  ///< of motion files: of both, or of each
  motion::MotionTolerance tolerance;
  double rotation_degrees = 0.1;  ///< of the tolerance, as it is typed
  double perceptual = 0.0;        ///< mean ꟻLIP that pictures may have
  bool json = false;
  std::vector<std::string> given;  ///< options that are of files alone
};

Command regress_command();

/// Compares two motion files: tells how they differ on `console.out`. Exit code 0 when they are
/// alike, 1 when they are not; throws Error for what cannot be read or compared.
int regress_motion_files(const RegressOptions& options, const Console& console);

/// Likewise two pictures, videos or folders of pictures.
int regress_media_files(const RegressOptions& options, const Console& console);

}  // namespace mien::pipeline
