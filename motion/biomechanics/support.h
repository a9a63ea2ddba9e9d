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

/// Horizontal distance, metres, of a point from the convex hull of the corners; negative inside.
/// `corners` must not be empty.
double distance_outside(const Vec3& point, const std::vector<Vec3>& corners);

/// The point of the convex hull that is nearest to `point`, on the floor.
Vec3 nearest_in(const Vec3& point, const std::vector<Vec3>& corners);

}  // namespace mien::motion
