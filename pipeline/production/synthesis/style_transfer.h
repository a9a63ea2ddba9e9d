#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/style_step.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// The motion restyled, and the feet standing where they stood in share of its time, if wanted.
struct RestyledMotion {
  motion::Example motion;
  double planted_drift_m = 0.0;  ///< largest, of the carried plants; 0 when feet were left alone
  std::vector<std::string> notes;
};

/// Does a style step by `strength`. The neutral and the styled example are taken at the motion's
/// frame rate and on its body. Throws Error when an example is missing or the method cannot take
/// the motion.
RestyledMotion restyled(const motion::Example& motion, const StyleStep& step, double strength,
                        const Repertoire& repertoire);

}  // namespace mien::pipeline
