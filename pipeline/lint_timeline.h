#pragma once

#include <string>
#include <vector>

#include "motion/lint/finding.h"
#include "pipeline/study/figure.h"

namespace mien::pipeline {

/// A motion whose findings are drawn.
struct LintedMotion {
  std::string name;
  int frames = 0;
  double frames_per_second = 30.0;
  std::vector<motion::Finding> findings;
};

/// The findings over time: a row for every rule and joint that has any, and one line that names the
/// rules which have none. Errors are dark and tall, warnings light and flat, so that they are told
/// apart by any colour vision and in greyscale. Seconds run below, frames above.
Figure lint_timeline(const LintedMotion& motion);

}  // namespace mien::pipeline
