#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/fitting/fit_quality.h"
#include "motion/formats/reading/read_options.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// A recording of points to which a body was fitted.
struct FittedRecording {
  std::filesystem::path file;
  motion::ReadOptions how;  ///< which motion of the file
  motion::FitQuality fit;
  std::vector<std::string> used_by;  ///< stimuli, and "examples", in the manifest's order
};

/// Returns the recordings of points that a study uses, each once: those of the examples, if any
/// stimulus uses them, then those of the stimuli. Makes the motions; reads the files of motion
/// graphs and of poses. Throws Error.
std::vector<FittedRecording> fitted_recordings(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
