#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"

namespace mien::motion {

/// What carries the body in one frame: corners, world space, y = 0. A foot that does not bear
/// (bearing.h) has none.
struct Support {
  std::vector<Vec3> left;         ///< the part of the sole on the floor
  std::vector<Vec3> right;        ///< likewise
  std::vector<Vec3> elsewhere{};  ///< knees, hands and seat on the floor

  bool empty() const { return left.empty() && right.empty() && elsewhere.empty(); }
  std::vector<Vec3> all() const;
};

/// The support in every frame. Of a foot that bears all of the sole counts that is within 0.03 m of
/// its lowest point, 0.09 m wide (at a stature of 1.75 m).
std::vector<Support> supports(const LintSubject& subject);

/// The support of the canonical body in a pose that it holds still: of both soles what is within
/// 0.03 m of their lowest point, as wide.
Support standing_support(const Skeleton& body, const JointTransforms& world);

/// Horizontal distance, metres, of a point from the convex hull of the corners; negative inside.
/// `corners` must not be empty.
double distance_outside(const Vec3& point, const std::vector<Vec3>& corners);

/// How far the centre of mass lies inside the area that the soles hold, metres on the floor's
/// plane; negative outside, where nobody can stand.
double standing_margin(const Skeleton& body, const Pose& pose);

/// The point of the convex hull that is nearest to `point`, on the floor.
Vec3 nearest_in(const Vec3& point, const std::vector<Vec3>& corners);

}  // namespace mien::motion
