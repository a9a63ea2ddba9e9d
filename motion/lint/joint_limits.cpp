#include <algorithm>
#include <cmath>

#include "motion/biomechanics/joint_angles.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

struct Range {
  double least;
  double most;
};

/// Every angle in every frame, an angle a row.
std::vector<std::vector<double>> angles_of(const LintMotion& motion) {
  std::vector<std::vector<double>> rows(joint_angles().size());
  for (const Pose& pose : motion.clip.poses) {
    const std::vector<double> values = measured_angles(pose);
    for (size_t a = 0; a < rows.size(); ++a) rows[a].push_back(values[a]);
  }
  return rows;
}

/// Healthy ranges, widened to what the original did.
std::vector<Range> ranges(const LintMotion* original) {
  std::vector<Range> result;
  for (const JointAngle& angle : joint_angles()) {
    result.push_back({angle.least_degrees, angle.most_degrees});
  }
  if (!original) return result;
  const auto rows = angles_of(*original);
  for (size_t a = 0; a < rows.size(); ++a) {
    const auto [least, most] = std::minmax_element(rows[a].begin(), rows[a].end());
    result[a] = {std::min(result[a].least, *least), std::max(result[a].most, *most)};
  }
  return result;
}

void add_beyond(const LintMotion& motion, const JointAngle& angle, std::string_view what,
                const Levels& levels, const std::vector<double>& beyond, Findings& findings) {
  const std::string name(name_of(angle.joint));
  const auto sentence = [&](double worst) {
    return "The " + display_name(name) + " " + std::string(what) + ": " + rounded(worst, 0) +
           "° beyond the range of its " + std::string(angle.name) + ".";
  };
  add_threshold_findings(findings, motion, {"joint-limit", name, "°", levels, 0, 1, sentence},
                         beyond);
}

/// The hand against the forearm, degrees from its mean attitude: where a straight hand lies is not
/// known of captures, whose hands are often markers on a wrist band.
std::vector<double> wrist_bends(const LintMotion& motion, BodyJoint wrist) {
  const Vec3 along = rest_direction(wrist);
  Vec3 mean = Vec3::Zero();
  for (const Pose& pose : motion.clip.poses) mean += pose.rotations[wrist] * along;
  mean.normalize();
  std::vector<double> bends;
  for (const Pose& pose : motion.clip.poses) {
    const double cosine = (pose.rotations[wrist] * along).dot(mean);
    bends.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) / radians_per_degree);
  }
  return bends;
}

void find_bent_wrists(const LintMotion& motion, const LintOptions& options, Findings& findings) {
  for (const BodyJoint wrist : {LeftWrist, RightWrist}) {
    std::vector<double> beyond = wrist_bends(motion, wrist);
    for (double& value : beyond) value -= wrist_range_degrees;
    const JointAngle angle = {wrist, "bend", 0, wrist_range_degrees, "", ""};
    add_beyond(motion, angle, "is bent too far", options.beyond_limit_degrees, beyond, findings);
  }
}

constexpr double least_excess_seconds = 0.05;

bool is_leg(int joint) { return joint >= LeftHip; }

/// Toes flick at toe off, wrists and toes have little to move.
bool is_end(int joint) {
  return joint == LeftToe || joint == RightToe || joint == LeftWrist || joint == RightWrist;
}

/// rad/s in every frame: of the step that leads there.
std::vector<double> speeds(const LintMotion& motion, int joint) {
  std::vector<double> values(motion.world.size(), 0.0);
  for (int t = 1; t < motion.frame_count(); ++t) {
    const Quat& before = motion.clip.poses[t - 1].rotations[joint];
    values[t] = angle_between(before, motion.clip.poses[t].rotations[joint]) * motion.rate();
  }
  return values;
}

}  // namespace

Findings find_joints_beyond_limits(const LintMotion& motion, const LintOptions& options,
                                   const LintMotion* original) {
  Findings findings;
  const auto rows = angles_of(motion);
  const std::vector<Range> allowed = ranges(original);
  for (size_t a = 0; a < rows.size(); ++a) {
    const JointAngle& angle = joint_angles()[a];
    std::vector<double> above = rows[a];
    for (double& value : above) value -= allowed[a].most;
    add_beyond(motion, angle, angle.beyond_most, options.beyond_limit_degrees, above, findings);
    if (angle.beyond_least.empty()) continue;
    std::vector<double> below = rows[a];
    for (double& value : below) value = allowed[a].least - value;
    add_beyond(motion, angle, angle.beyond_least, options.beyond_limit_degrees, below, findings);
  }
  find_bent_wrists(motion, options, findings);
  return findings;
}

Findings find_fast_joints(const LintMotion& motion, const LintOptions& options,
                          const LintMotion* original) {
  Findings findings;
  for (int j = 0; j < body_joint_count; ++j) {
    if (is_end(j)) continue;
    const std::string name(name_of(BodyJoint(j)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " turns at " + rounded(worst, 0) +
             " rad/s, faster than humanly possible.";
    };
    const Levels levels = raised_levels(is_leg(j) ? options.leg_speed : options.arm_speed,
                                        original ? speeds(*original, j) : std::vector<double>());
    add_threshold_findings(
        findings, motion, {"joint-speed", name, "rad/s", levels, least_excess_seconds, 2, sentence},
        speeds(motion, j));
  }
  return findings;
}

}  // namespace mien::motion
