#include "motion/measures/differences/motion_difference.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "motion/lint/lint.h"
#include "motion/measures/differences/feature_change.h"
#include "motion/measures/distance/body_part.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

namespace {

/// Frames of a finding as seconds, from its first frame to the one after its last.
bool touch(const Finding& a, double rate_a, const Finding& b, double rate_b) {
  return a.first / rate_a <= (b.last + 1) / rate_b && b.first / rate_b <= (a.last + 1) / rate_a;
}

bool are_one(const Finding& a, double rate_a, const Finding& b, double rate_b) {
  return a.check == b.check && a.joint == b.joint && touch(a, rate_a, b, rate_b);
}

bool equal_places(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return std::ranges::equal(a, b);
}

bool equal_rotations(const std::vector<Quat>& a, const std::vector<Quat>& b) {
  return std::ranges::equal(a, b,
                            [](const Quat& p, const Quat& q) { return p.coeffs() == q.coeffs(); });
}

bool equal_poses(const Pose& a, const Pose& b) {
  return a.root_position == b.root_position && equal_places(a.offsets, b.offsets) &&
         equal_rotations(a.rotations, b.rotations) && equal_rotations(a.fingers, b.fingers);
}

bool equal_joints(const Joint& a, const Joint& b) {
  return a.name == b.name && a.parent == b.parent && a.offset == b.offset && a.tip == b.tip;
}

bool are_identical(const Clip& a, const Clip& b) {
  return a.frames_per_second == b.frames_per_second && a.loops == b.loops &&
         a.cycle_displacement == b.cycle_displacement &&
         std::ranges::equal(a.body.joints, b.body.joints, equal_joints) &&
         std::ranges::equal(a.poses, b.poses, equal_poses);
}

/// Mean over joints and moments; each pose is seen from its root joint.
double rooted_error(const PairedMotions& pair, int root) {
  double sum = 0.0;
  const SharedJoint& from = pair.joints[root];
  for (int t = 0; t < pair.frames; ++t) {
    const auto& before = pair.before.world[t].positions;
    const auto& now = pair.now.world[t].positions;
    const Vec3 shift = now[from.now] - before[from.before];
    for (const SharedJoint& joint : pair.joints)
      sum += (now[joint.now] - before[joint.before] - shift).norm();
  }
  return sum / (static_cast<double>(pair.joints.size()) * pair.frames);
}

double mean_of(const MotionDifference& difference, std::vector<double> JointDifference::*curve) {
  double sum = 0.0;
  double count = 0.0;
  for (const JointDifference& joint : difference.joints) {
    for (const double value : joint.*curve) sum += value;
    count += static_cast<double>((joint.*curve).size());
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// The whole of a clip as one performance, as D takes it.
Example as_performance(const Clip& clip) {
  return {clip.name, clip, {0.0, clip.duration_seconds()}};
}

void name_parts(MotionDifference& difference, const Clip& before) {
  if (!is_body(before.body)) return;
  for (JointDifference& joint : difference.joints) joint.part = part_name(BodyJoint(joint.index));
}

bool is_above(const MotionDifference& difference, int joint, int below) {
  for (int j = below; j >= 0; j = difference.joints[j].parent) {
    if (j == joint) return true;
  }
  return false;
}

}  // namespace

MotionDifference motion_difference(const Clip& before, const Clip& now,
                                   const MotionDifferenceOptions& options) {
  const PairedMotions pair = paired(before, now);
  MotionDifference result;
  result.identical = are_identical(before, now);
  result.timing = timing_difference(before, now, pair);
  result.joints = joint_differences(pair, before.body, now.body);
  result.only_before = pair.only_before;
  result.only_now = pair.only_now;
  result.root = root_difference(pair, before.body);
  result.whole = whole_change(pair, before.body, now.body);
  result.errors = {mean_of(result, &JointDifference::position_m),
                   rooted_error(pair, result.root.joint),
                   mean_of(result, &JointDifference::aligned_m)};
  name_parts(result, before);
  if (is_body(before.body) && is_body(now.body)) result.body = body_difference(before, now);
  if (options.lint) result.lint = lint_difference(before, now, options.lint_options);
  return result;
}

BodyDifference body_difference(const Clip& before, const Clip& now) {
  const Distance apart = distance(as_performance(before), as_performance(now));
  return {apart.mean, apart.mpjpe, contact_differences(before, now)};
}

std::vector<LintChange> lint_difference(const Clip& before, const Clip& now,
                                        const LintOptions& options) {
  if (are_identical(before, now)) return {};
  return lint_changes(lint(before, options), before.frames_per_second, lint(now, options),
                      now.frames_per_second);
}

bool FeatureDifference::is_notable() const {
  if (std::isfinite(before) != std::isfinite(now)) return true;
  return FeatureChange{feature, before, now, now}.moved();
}

std::vector<FeatureDifference> feature_differences(const FeatureValues& before,
                                                   const FeatureValues& now) {
  std::vector<FeatureDifference> differences;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (std::isfinite(before[i]) || std::isfinite(now[i]))
      differences.push_back({static_cast<int>(i), before[i], now[i]});
  }
  return differences;
}

std::vector<int> causes(const MotionDifference& difference) {
  std::vector<int> joints;
  for (std::size_t j = 0; j < difference.joints.size(); ++j) {
    if (difference.joints[j].differs_itself()) joints.push_back(static_cast<int>(j));
  }
  std::ranges::stable_sort(joints, std::greater{},
                           [&](int j) { return peak_of(difference.joints[j].turn_radians).value; });
  return joints;
}

bool carries_body(const MotionDifference& difference, int joint) {
  return is_above(difference, joint, difference.root.joint);
}

bool is_root_only(const MotionDifference& difference) {
  for (std::size_t j = 0; j < difference.joints.size(); ++j) {
    const bool is_part = !carries_body(difference, static_cast<int>(j));
    if (is_part && difference.joints[j].differs_itself()) return false;
  }
  return peak_of(difference.root.path_m).value > 0.0 ||
         peak_of(difference.root.height_m).value > 0.0 ||
         peak_of(difference.root.heading_radians).value > 0.0 ||
         peak_of(difference.root.tilt_radians).value > 0.0;
}

WorstJoint worst_joint(const MotionDifference& difference,
                       std::vector<double> JointDifference::*curve) {
  WorstJoint worst;
  for (std::size_t j = 0; j < difference.joints.size(); ++j) {
    const CurvePeak peak = peak_of(difference.joints[j].*curve);
    if (peak.value > worst.peak.value) worst = {static_cast<int>(j), peak};
  }
  return worst;
}

double root_mean_square(const MotionDifference& difference,
                        std::vector<double> JointDifference::*curve) {
  double sum = 0.0;
  double count = 0.0;
  for (const JointDifference& joint : difference.joints) {
    for (const double value : joint.*curve) sum += value * value;
    count += static_cast<double>((joint.*curve).size());
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

std::string_view name_of(LintChange::Kind kind) {
  constexpr std::string_view names[] = {"gone", "new", "worse", "better"};
  static_assert(std::size(names) == static_cast<size_t>(LintChange::Kind::better) + 1);
  return names[static_cast<size_t>(kind)];
}

std::vector<LintChange> lint_changes(const std::vector<Finding>& before, double rate_before,
                                     const std::vector<Finding>& now, double rate_now) {
  using enum LintChange::Kind;
  std::vector<LintChange> changes;
  for (const Finding& finding : now) {
    std::optional<Severity> was;
    for (const Finding& old : before) {
      if (are_one(old, rate_before, finding, rate_now))
        was = std::max(was.value_or(old.severity), old.severity);
    }
    if (!was) {
      changes.push_back({appeared, finding});
    } else if (*was != finding.severity) {
      changes.push_back({finding.severity == Severity::error ? worse : better, finding});
    }
  }
  for (const Finding& old : before) {
    bool is_there = false;
    for (const Finding& finding : now) is_there |= are_one(old, rate_before, finding, rate_now);
    if (!is_there) changes.push_back({gone, old});
  }
  return changes;
}

}  // namespace mien::motion
