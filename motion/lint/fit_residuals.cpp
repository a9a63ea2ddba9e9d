#include "motion/lint/fit_residuals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "motion/lint/threshold_findings.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr char check_id[] = "fit-residual";
constexpr Levels fit_levels_mm = {far_from_points_mm, 2.0 * far_from_points_mm};

/// The frame of the clip at a frame of the recording, not limited to those that it has.
int clip_frame(int recorded, const FitQuality& fit, const Clip& clip, double start_seconds) {
  const double seconds = (recorded - fit.first_frame) / fit.frames_per_second - start_seconds;
  return static_cast<int>(std::lround(seconds * clip.frames_per_second));
}

}  // namespace

std::vector<Finding> find_fit_residuals(const FitQuality& fit, const Clip& clip,
                                        double start_seconds) {
  std::vector<Finding> findings;
  const int end = clip.frame_count() - 1;
  if (fit.residual_mm > fit_levels_mm.warning) {
    Finding whole = graded_finding(check_id, fit.residual_mm, "mm", fit_levels_mm);
    whole.last = end;
    whole.sentence = "The fitted body is " + rounded(fit.residual_mm, 0) +
                     " mm (RMS) away from the recorded points.";
    findings.push_back(whole);
  }
  for (const FittedPoint& point : fit.points) {
    if (point.residual_mm <= fit_levels_mm.warning || !point.first_far) continue;
    const int first = clip_frame(*point.first_far, fit, clip, start_seconds);
    const int last = clip_frame(point.last_far, fit, clip, start_seconds);
    if (first > end || last < 0) continue;
    Finding finding;
    finding.check = check_id;
    finding.joint = point.name;
    finding.first = std::max(first, 0);
    finding.last = std::min(last, end);
    finding.measured = point.residual_mm;
    finding.threshold = fit_levels_mm.warning;
    finding.unit = "mm";
    finding.sentence =
        "The point " + in_quotes(point.name) + " is " + rounded(point.residual_mm, 0) +
        " mm (RMS) away from the fitted body: it may be mislabelled or have moved on "
        "the skin.";
    findings.push_back(finding);
  }
  return findings;
}

}  // namespace mien::motion
