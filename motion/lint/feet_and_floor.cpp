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

std::vector<double> sole_heights(const LintSubject& subject, bool left) {
  std::vector<double> heights;
  for (const JointTransforms& world : subject.world) {
    const SolePoints sole = sole_points(subject.clip.body, world, left);
    heights.push_back(std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()}) / subject.scale);
  }
  return heights;
}

/// Leaves out the frames in which the body rests on more than its feet, or falls freely and stands
/// on none; also those next to a fall, for feet leave and meet the floor softly, and those of a
/// motion's ends where that is unknown.
void without_flights(const LintSubject& subject, std::vector<double>& heights) {
  const WeightBearing bears = weight_bearing_of(subject);
  const int count = subject.frame_count();
  const int soft = static_cast<int>(std::lround(soft_seconds * subject.rate()));
  std::vector<double> ends(heights.size(), 0.0);
  mask_ends(subject, ends);
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
std::vector<double> hanging_heights(const LintSubject& subject) {
  std::vector<double> lower = sole_heights(subject, true);
  const std::vector<double> right = sole_heights(subject, false);
  for (size_t t = 0; t < lower.size(); ++t) lower[t] = std::min(lower[t], right[t]);
  without_flights(subject, lower);
  return lower;
}

std::vector<double> depths(const LintSubject& subject, bool left) {
  std::vector<double> values = sole_heights(subject, left);
  for (double& value : values) value = -value;
  return values;
}

}  // namespace

Findings find_sunken_feet(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original) {
  Findings findings;
  for (const bool left : {true, false}) {
    const auto sentence = [&](double worst) {
      return std::string("The ") + (left ? "left" : "right") + " foot sinks " +
             rounded(100.0 * worst, 1) + " cm into the floor.";
    };
    const std::string joint(name_of(left ? LeftAnkle : RightAnkle));
    const Levels levels = raised_levels(options.penetration_metres,
                                        original ? depths(*original, left) : std::vector<double>());
    add_threshold_findings(findings, subject, {"penetration", joint, "m", levels, 0, 2, sentence},
                           depths(subject, left));
  }
  return findings;
}

Findings find_floating(const LintSubject& subject, const LintOptions& options,
                       const LintSubject* original) {
  Findings findings;
  const auto sentence = [](double worst) {
    return "The body floats: the lower foot is " + rounded(100.0 * worst, 1) +
           " cm above the floor.";
  };
  const Levels levels = raised_levels(
      options.floating_metres, original ? hanging_heights(*original) : std::vector<double>());
  add_threshold_findings(findings, subject,
                         {"floating", "", "m", levels, shortest_seconds, 3, sentence},
                         hanging_heights(subject));
  return findings;
}

}  // namespace mien::motion
