#include <algorithm>
#include <cmath>

#include "motion/biomechanics/support.h"
#include "motion/biomechanics/weight_bearing.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double shortest_seconds = 0.1;
constexpr double soft_seconds = 0.07;

std::vector<double> sole_heights(const LintMotion& motion, bool left) {
  std::vector<double> heights;
  for (const JointTransforms& world : motion.world) {
    const SolePoints sole = sole_points(motion.clip.body, world, left);
    heights.push_back(std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()}) / motion.scale);
  }
  return heights;
}

/// Leaves out the frames in which the body rests on more than its feet, or falls freely and stands
/// on none; also those next to a fall, for feet leave and meet the floor softly, and those of a
/// motion's ends where that is unknown.
void without_flights(const LintMotion& motion, std::vector<double>& heights) {
  const WeightBearing bears = weight_bearing_of(motion);
  const int count = motion.frame_count();
  const int soft = static_cast<int>(std::lround(soft_seconds * motion.rate()));
  std::vector<double> ends(heights.size(), 0.0);
  mask_ends(motion, ends);
  const auto falls_near = [&](int t) {
    const auto from = bears.falls.begin() + std::max(t - soft, 0);
    const auto to = bears.falls.begin() + std::min(t + soft + 1, count);
    return std::find(from, to, true) != to;
  };
  for (int t = 0; t < count; ++t) {
    const bool may_fly = falls_near(t) || std::isnan(ends[t]);
    if (bears.elsewhere[t] || (may_fly && !bears.planted[t])) heights[t] = no_value;
  }
}

/// Height of the lower sole wherever the body does not fly.
std::vector<double> hanging_heights(const LintMotion& motion) {
  std::vector<double> lower = sole_heights(motion, true);
  const std::vector<double> right = sole_heights(motion, false);
  for (size_t t = 0; t < lower.size(); ++t) lower[t] = std::min(lower[t], right[t]);
  without_flights(motion, lower);
  return lower;
}

std::vector<double> depths(const LintMotion& motion, bool left) {
  std::vector<double> values = sole_heights(motion, left);
  for (double& value : values) value = -value;
  return values;
}

}  // namespace

Findings find_sunken_feet(const LintMotion& motion, const LintOptions& options,
                          const LintMotion* original) {
  Findings findings;
  for (const bool left : {true, false}) {
    const auto sentence = [&](double worst) {
      return std::string("The ") + (left ? "left" : "right") + " foot sinks " +
             rounded(100.0 * worst, 1) + " cm into the floor.";
    };
    const std::string joint(name_of(left ? LeftAnkle : RightAnkle));
    const Levels levels = raised_levels(options.penetration_metres,
                                        original ? depths(*original, left) : std::vector<double>());
    add_threshold_findings(findings, motion, {"penetration", joint, "m", levels, 0, 2, sentence},
                           depths(motion, left));
  }
  return findings;
}

Findings find_floating(const LintMotion& motion, const LintOptions& options,
                       const LintMotion* original) {
  Findings findings;
  const auto sentence = [](double worst) {
    return "The body floats: the lower foot is " + rounded(100.0 * worst, 1) +
           " cm above the floor.";
  };
  const Levels levels = raised_levels(
      options.floating_metres, original ? hanging_heights(*original) : std::vector<double>());
  add_threshold_findings(findings, motion,
                         {"floating", "", "m", levels, shortest_seconds, 3, sentence},
                         hanging_heights(motion));
  return findings;
}

}  // namespace mien::motion
