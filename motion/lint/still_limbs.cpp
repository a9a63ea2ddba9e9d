#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/limb_ends.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double least_movement = 0.04;  // m of a stature of 1.75 m; what moves less may be still

/// The joint that carries a limb. The hand of an arm that no longer swings is still moved by the
/// shoulder girdle, in captures by up to 9 cm.
int carrier_of(int end) {
  switch (end) {
    case LeftWrist:
      return LeftClavicle;
    case RightWrist:
      return RightClavicle;
    case LeftAnkle:
    case RightAnkle:
      return Pelvis;
    default:
      return Chest;
  }
}

/// Root mean square distance from the mean place, metres.
double movement(const std::vector<Vec3>& path, const FrameWindow& window) {
  const int count = window.last - window.first + 1;
  Vec3 mean = Vec3::Zero();
  for (int t = window.first; t <= window.last; ++t) mean += path[t] / count;
  double squares = 0.0;
  for (int t = window.first; t <= window.last; ++t) squares += (path[t] - mean).squaredNorm();
  return std::sqrt(squares / count);
}

/// Around each frame, the share of the original's movement that is gone; 0 where the original
/// hardly moves.
std::vector<double> lost_movement(const LintMotion& motion, const LintMotion& original, int end) {
  std::vector<double> lost(motion.world.size(), 0.0);
  const int carrier = carrier_of(end);
  const std::vector<Vec3> path = path_in_frame_of(motion, carrier, end);
  const std::vector<Vec3> before =
      at_moments_of(motion, original, path_in_frame_of(original, carrier, end));
  for (const FrameWindow& window : limb_windows(motion)) {
    const double usual = movement(before, window);
    if (usual < least_movement * original.scale) continue;
    raise_to(lost, window, 1.0 - movement(path, window) / usual);
  }
  return lost;
}

}  // namespace

Findings find_still_limbs(const LintMotion& motion, const LintOptions& options,
                          const LintMotion& original) {
  Findings findings;
  for (const int end : limb_ends) {
    const std::string name(name_of(BodyJoint(end)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " hardly moves: " + rounded(100.0 * (1.0 - worst), 0) +
             " % as much as in the original.";
    };
    add_threshold_findings(findings, motion,
                           {"still-limb", name, "", options.lost_movement, 0, 1, sentence},
                           lost_movement(motion, original, end));
  }
  return findings;
}

}  // namespace mien::motion
