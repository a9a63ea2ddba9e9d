#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/measures/distance/paired_motions.h"

namespace mien::motion {

/// Distance r of virtual points from the bone: a twist by a about the bone moves them by
/// 2·r·sin(a/2).
inline constexpr double virtual_point_m = 0.1;

/// A joint's frame by the bone that it carries: unit vectors at right angles, `along` towards the
/// main child (of several the one with the most joints below it) or the tip; +Y when there is
/// neither.
struct BoneAxes {
  Vec3 along;
  Vec3 side;
  Vec3 up;
};

std::vector<BoneAxes> bone_axes(const Skeleton& skeleton);

/// The joint itself and two virtual points, `virtual_point_m` off it along `side` and `up` of the
/// bone that it carries, which turn with it. World space.
struct JointPoints {
  Vec3 joint;
  Vec3 side;
  Vec3 up;
};

/// The maximum of a curve and its first frame.
struct CurvePeak {
  double value = 0.0;
  int frame = 0;
};

CurvePeak peak_of(std::span<const double> curve);
double root_mean_square(std::span<const double> curve);

/// How one joint differs: a value a moment that both motions have (PairedMotions). Nothing is
/// aligned or taken away unless said so. Exactly zero where the two are equal.
struct JointDifference {
  std::string name;  ///< in the first skeleton: "LeftForeArm"
  int index = 0;     ///< in the first skeleton
  std::string part;  ///< of the body: "left forearm"; the joint's name if unknown
  int parent = -1;   ///< index into the same list; −1 none

  std::vector<double> position_m;    ///< distance between the places of the joint, world
  std::vector<double> point_m;       ///< largest of the distances of its JointPoints, world
  std::vector<double> aligned_m;     ///< of the joint, when the second pose is laid over the first
                                     ///< by the best similarity of the frame (Procrustes)
  std::vector<double> velocity_m_s;  ///< largest difference of velocities of its JointPoints, world
  // Local changes of the joint itself, without those of its ancestors.
  std::vector<double> turn_radians;   ///< of its rotation on its parent (the root's: in the world)
  std::vector<double> twist_radians;  ///< the part of it about the bone
  std::vector<double> offset_m;       ///< of its place on its parent: the bone above it. Root: 0

  /// Whether its rotation or offset relative to its parent differs by more than the rounding of
  /// files: 1e-4 rad or 1e-5 m.
  bool differs_itself() const;
};

/// Differences of all joints of the pair, in its order. `part` is the joint's name.
std::vector<JointDifference> joint_differences(const PairedMotions& pair, const Skeleton& before,
                                               const Skeleton& now);

/// World places of the joint and its virtual points at a moment, in both motions.
JointPoints points_at(const JointTransforms& world, int joint, const BoneAxes& axes);

}  // namespace mien::motion
