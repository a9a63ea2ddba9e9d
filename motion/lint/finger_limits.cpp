#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/skeleton/finger_angles.h"

namespace mien::motion {

namespace {

constexpr double no_error = std::numeric_limits<double>::infinity();

/// An angle of one joint, and how to say that it is beyond its range.
struct CheckedAngle {
  double FingerAngles::*angle;
  FingerRange FingerRanges::*range;
  std::string_view below;
  std::string_view above;
};

constexpr std::array<CheckedAngle, 2> checked_angles = {{
    {&FingerAngles::flexion, &FingerRanges::flexion, "bent backwards", "bent too far"},
    {&FingerAngles::abduction, &FingerRanges::abduction, "bent sideways", "bent sideways"},
}};

std::vector<double> angle_curve(const LintMotion& motion, int joint, double FingerAngles::*angle) {
  std::vector<double> values;
  for (const Pose& pose : motion.clip.poses) values.push_back(finger_angles(pose, joint).*angle);
  return values;
}

/// "left index finger", "right thumb".
std::string finger_in_words(int joint) {
  constexpr std::array<std::string_view, fingers_per_hand> words = {
      "thumb", "index finger", "middle finger", "ring finger", "little finger"};
  return (is_left_finger(joint) ? "left " : "right ") +
         std::string(words[static_cast<size_t>(finger_of(joint))]);
}

void find_beyond(const LintMotion& motion, int joint, const CheckedAngle& checked,
                 const LintOptions& options, const LintMotion* original, Findings& findings) {
  constexpr std::array<std::string_view, joints_per_finger> places = {"first", "second", "third"};
  FingerRange range = finger_ranges(joint).*checked.range;
  if (original && !original->clip.poses.front().fingers.empty()) {
    const std::vector<double> before = angle_curve(*original, joint, checked.angle);
    const auto [least, most] = std::minmax_element(before.begin(), before.end());
    range = {std::min(range.least, *least), std::max(range.most, *most)};
  }
  const Levels levels = {options.beyond_limit_degrees.warning, no_error};
  const auto add = [&](std::string_view what, std::vector<double> beyond) {
    const auto sentence = [&](double worst) {
      return "The " + finger_in_words(joint) + " is " + std::string(what) + " at its " +
             std::string(places[static_cast<size_t>(segment_of(joint))]) +
             " joint: " + rounded(worst, 0) + "° beyond its range.";
    };
    add_threshold_findings(findings, motion,
                           {"finger-limit", finger_joint_name(joint), "°", levels, 0, 1, sentence},
                           beyond);
  };
  std::vector<double> above = angle_curve(motion, joint, checked.angle);
  std::vector<double> below = above;
  for (double& value : above) value -= range.most;
  for (double& value : below) value = range.least - value;
  add(checked.above, std::move(above));
  add(checked.below, std::move(below));
}

}  // namespace

Findings find_fingers_beyond_limits(const LintMotion& motion, const LintOptions& options,
                                    const LintMotion* original) {
  Findings findings;
  if (motion.clip.poses.front().fingers.empty()) return findings;
  for (int joint = 0; joint < finger_joint_count; ++joint)
    for (const CheckedAngle& checked : checked_angles)
      find_beyond(motion, joint, checked, options, original, findings);
  return findings;
}

}  // namespace mien::motion
