#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/subject.h"

namespace mien::motion {

/// Base of support in one frame: corners, world space, y = 0. A foot without weight
/// (weight_bearing.h) has none.
struct Support {
  std::vector<Vec3> left;         ///< corners of the part of the left sole on the floor
  std::vector<Vec3> right;        ///< of the right sole
  std::vector<Vec3> elsewhere{};  ///< knees, hands and seat on the floor

  bool empty() const { return left.empty() && right.empty() && elsewhere.empty(); }
  std::vector<Vec3> all() const;
};

/// The base of support in every frame. Of a bearing foot the sole within 0.03 m of its lowest point
/// counts, with a width of 0.09 m (at a stature of 1.75 m).
std::vector<Support> supports(const LintSubject& subject);

/// Horizontal distance, metres, of a point from the convex hull of the corners; negative inside.
/// `corners` must not be empty.
double signed_distance_to_hull(const Vec3& point, const std::vector<Vec3>& corners);

/// The point of the convex hull that is nearest to `point`, on the floor.
Vec3 nearest_in_hull(const Vec3& point, const std::vector<Vec3>& corners);

/// Dynamics and support of a subject, frame by frame: the input of the checks of balance and
/// forces.
struct BodyOnFloor {
  std::vector<BodyDynamics> moments;
  std::vector<Support> supports;
};

BodyOnFloor body_on_floor(const LintSubject& subject);

/// Sets the values of the first and last 0.1 s to NaN, unless the motion loops: accelerations are
/// unreliable there.
void mask_ends(const LintSubject& subject, std::vector<double>& values);

}  // namespace mien::motion
