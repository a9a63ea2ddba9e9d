#pragma once

#include <string>
#include <vector>

#include "motion/lint/finding.h"
#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A motion and its lint findings to be plotted.
struct LintedMotion {
  std::string name;
  int frames = 0;
  double frames_per_second = 30.0;
  bool was_compared = false;  ///< compared with an original, which some rules need
  std::vector<motion::Finding> findings;
  bool loops = false;      ///< false: the seam is not checked
  bool is_fitted = false;  ///< to recorded points, whose distance from the body was checked
};

/// Returns a plot of the findings over time: a row for each pair of rule and joint that has
/// findings, and lines that name the checked rules that have none. Errors are dark and tall,
/// warnings light and flat, so that they differ in greyscale and for any colour vision. The axis
/// below shows seconds, the one above frames.
Plot lint_timeline(const LintedMotion& motion);

}  // namespace mien::pipeline
