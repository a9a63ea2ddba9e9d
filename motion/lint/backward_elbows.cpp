#include <algorithm>
#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

// Chosen for this project. In 73 captures (walks, waves, runs, climbing) the forearm points
// outwards by up to 88° and inwards by up to 90°; a hand behind the back comes to about 120°
// inwards.
constexpr double outward_degrees = 85.0;
constexpr double inward_degrees = 125.0;
constexpr double least_bend_degrees = 20.0;  // a straight arm has no direction of bending
constexpr double least_hanging = -0.5;       // cosine; of raised arms forward means nothing
constexpr double least_seconds = 0.25;

/// Angle about the upper arm from forward to the forearm, degrees, inwards positive; `no_value`
/// where it means nothing. Forward is that of the chest, turned with the upper arm from hanging
/// straight down.
double forearm_angle(const JointTransforms& world, bool left) {
  const auto at = [&](BodyJoint joint) { return world.positions[left ? joint : mirrored(joint)]; };
  const Quat to_chest = world.rotations[Chest].conjugate();
  const Vec3 upper = (to_chest * (at(LeftElbow) - at(LeftShoulder))).normalized();
  const Vec3 fore = (to_chest * (at(LeftWrist) - at(LeftElbow))).normalized();
  const double bend = std::acos(std::clamp(upper.dot(fore), -1.0, 1.0)) / radians_per_degree;
  if (bend < least_bend_degrees || -upper.y() < least_hanging) return no_value;
  const Vec3 forward = Quat::FromTwoVectors(-Vec3::UnitY(), upper) * Vec3::UnitZ();
  const Vec3 inward = left ? upper.cross(forward) : forward.cross(upper);
  return std::atan2(fore.dot(inward), fore.dot(forward)) / radians_per_degree;
}

/// Degrees beyond the range, on its nearer side, in every frame.
std::vector<double> beyond_range(const LintMotion& motion, bool left) {
  std::vector<double> beyond;
  for (const JointTransforms& world : motion.world) {
    const double angle = forearm_angle(world, left);
    if (std::isnan(angle)) {
      beyond.push_back(no_value);
    } else if (angle >= -outward_degrees && angle <= inward_degrees) {
      beyond.push_back(0.0);
    } else {
      const double outwards = -outward_degrees - angle + (angle > 0.0 ? 360.0 : 0.0);
      const double inwards = angle - inward_degrees + (angle > 0.0 ? 0.0 : 360.0);
      beyond.push_back(std::min(outwards, inwards));
    }
  }
  return beyond;
}

}  // namespace

Findings find_backward_elbows(const LintMotion& motion, const LintOptions& options,
                              const LintMotion* original) {
  Findings findings;
  for (const bool left : {true, false}) {
    const std::string name(name_of(left ? LeftElbow : RightElbow));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " is bent backwards: the forearm points " +
             rounded(worst, 0) + "° beyond where elbow and shoulder let it point.";
    };
    const Levels levels =
        raised_levels(options.beyond_limit_degrees,
                      original ? beyond_range(*original, left) : std::vector<double>());
    add_threshold_findings(findings, motion,
                           {"joint-limit", name, "°", levels, least_seconds, 2, sentence},
                           beyond_range(motion, left));
  }
  return findings;
}

}  // namespace mien::motion
