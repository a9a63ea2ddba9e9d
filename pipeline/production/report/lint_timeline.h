#pragma once

#include <string>
#include <vector>

#include "motion/lint/finding.h"
#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A motion whose findings are drawn.
struct LintedMotion {
  std::string name;
  int frames = 0;
  double frames_per_second = 30.0;
  bool was_compared = false;  ///< with an original, as some rules need
  std::vector<motion::Finding> findings;
  bool loops = false;  ///< otherwise there is no seam to look at
};

/// The findings over time: a row for every rule and joint that has any, and a line that names the
/// rules which found nothing. Errors are dark and tall, warnings light and flat, so that they are
/// told apart by any colour vision and in greyscale. Seconds run below, frames above.
Plot lint_timeline(const LintedMotion& motion);

}  // namespace mien::pipeline
