#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/lint_motion.h"

namespace mien::motion {

/// Base of support in one frame: corners in world space, metres, y = 0. A foot that does not bear
/// weight (weight_bearing.h) contributes no corners.
struct Support {
  std::vector<Vec3> left;         ///< corners of the part of the left sole that is on the floor
  std::vector<Vec3> right;        ///< the same of the right sole
  std::vector<Vec3> elsewhere{};  ///< knees, hands and pelvis that rest on the floor

  bool empty() const { return left.empty() && right.empty() && elsewhere.empty(); }
  std::vector<Vec3> all() const;
};

/// The base of support in every frame of the prepared clip. The contact area of a foot that bears
/// weight is the part of the sole less than 0.03 m above its lowest point, with a width of 0.09 m;
/// both lengths are for a stature of 1.75 m.
std::vector<Support> supports(const LintMotion& motion);

/// Horizontal distance of a point from the convex hull of the corners, metres; inside the hull,
/// minus the distance to its edge. `corners` must not be empty.
double signed_distance_to_hull(const Vec3& point, const std::vector<Vec3>& corners);

/// The point on the floor that lies in the convex hull and is nearest to `point`. `corners` must
/// not be empty.
Vec3 nearest_in_hull(const Vec3& point, const std::vector<Vec3>& corners);

/// Dynamics and base of support of a motion, one entry per frame of its prepared clip: the input of
/// the balance and force checks.
struct BodyOnFloor {
  std::vector<BodyDynamics> moments;
  std::vector<Support> supports;
};

BodyOnFloor body_on_floor(const LintMotion& motion);

/// If the motion is not a loop, sets the values of its first and last 0.1 s to NaN, because
/// accelerations are unreliable there. `values` has one entry per frame.
void mask_ends(const LintMotion& motion, std::vector<double>& values);

}  // namespace mien::motion
