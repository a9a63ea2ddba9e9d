#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/measures/distance/paired_motions.h"

namespace mien::motion {

/// Distance r of virtual points from the bone, metres: a twist by the angle a about the bone moves
/// them by 2·r·sin(a/2).
inline constexpr double virtual_point_m = 0.1;

/// Axes of the bone from a joint to its main child, in the joint's frame: orthonormal vectors,
/// `along` towards the main child (the one with the most descendants) or the tip; +Y if there is
/// neither.
struct BoneAxes {
  Vec3 along;
  Vec3 side;
  Vec3 up;
};

std::vector<BoneAxes> bone_axes(const Skeleton& skeleton);

/// Positions of a joint and of two virtual points that rotate with it, `virtual_point_m` away along
/// `side` and `up` of its BoneAxes. World space, metres.
struct JointPoints {
  Vec3 joint;
  Vec3 side;
  Vec3 up;
};

/// The maximum of a curve (values ≥ 0), and the first frame in which it is reached.
struct CurvePeak {
  double value = 0.0;
  int frame = 0;
};

CurvePeak peak_of(std::span<const double> curve);
double root_mean_square(std::span<const double> curve);

/// Differences of one joint; curves have one value per frame that both motions have
/// (PairedMotions). Poses are compared without alignment unless stated otherwise. Exactly zero
/// where both motions are equal.
struct JointDifference {
  std::string name;  ///< in the first skeleton: "LeftForeArm"
  int index = 0;     ///< in the first skeleton
  std::string part;  ///< body part, "left forearm"; the joint's name if unknown
  int parent = -1;   ///< index into the same list; −1 none

  std::vector<double> position_m;    ///< distance between the joint's two positions, world space
  std::vector<double> point_m;       ///< likewise, the largest of its three JointPoints' distances
  std::vector<double> aligned_m;     ///< distance of the joint after Procrustes alignment of the
                                     ///< second pose with the first in each frame
  std::vector<double> velocity_m_s;  ///< largest velocity difference of its JointPoints, world
  // Local changes of the joint itself, without those of its ancestors.
  std::vector<double> turn_radians;   ///< of its local rotation (for the root, in world space)
  std::vector<double> twist_radians;  ///< twist component of this rotation change about the bone
  std::vector<double> offset_m;       ///< of its position relative to its parent; 0 for the root

  /// Whether its rotation or offset relative to its parent differs by more than the rounding of
  /// files: 1e-4 rad or 1e-5 m.
  bool differs_itself() const;
};

/// Differences of all joints of the pair, in the pair's order. `part` is the joint's name; a caller
/// that knows the body parts replaces it.
std::vector<JointDifference> joint_differences(const PairedMotions& pair, const Skeleton& before,
                                               const Skeleton& now);

/// World positions of a joint and its virtual points in a pose.
JointPoints points_at(const JointTransforms& world, int joint, const BoneAxes& axes);

}  // namespace mien::motion
