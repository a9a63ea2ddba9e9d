#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/style_step.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A motion after style transfer. If foot locking is enabled and the motion does not walk in place,
/// its feet have the contacts of the original, in the time of the result (contacts_carried.h).
struct RestyledMotion {
  motion::Example motion;
  /// Largest slide of a planted foot, metres; 0 if the feet are not locked.
  double planted_drift_m = 0.0;
  std::vector<std::string> notes;
  std::vector<double> times = {};  ///< given times of the motion, in the result, seconds
};

/// Applies a style step with the given strength. The neutral and the styled example are converted
/// to the motion's frame rate and body. Throws Error if an example is missing or the method cannot
/// handle the motion. `times` are times of the motion, seconds, that are moved with it.
RestyledMotion restyled(const motion::Example& motion, const StyleStep& step, double strength,
                        const Repertoire& repertoire, const std::vector<double>& times = {});

}  // namespace mien::pipeline
