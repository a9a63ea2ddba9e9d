#pragma once

#include <vector>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// Lowest and highest coordinate of points along a direction.
struct Extent {
  double low;
  double high;
};

/// Extents of the seen points along a direction, in each frame in which any is seen.
std::vector<Extent> extents(const PointRecording& recording, const Vec3& direction);

/// Range of the middle 90 % of the values; there must be one.
double spread(const std::vector<double>& values);

/// What tells which way is up.
enum class UpwardEvidence {
  names,      ///< points of feet, pelvis, trunk and head
  shape,      ///< of the cloud of points: a body that stands or walks
  statement,  ///< no points, but the file states it
  format,     ///< nothing in the file: as is usual in files of its format
  nothing     ///< the format has no usual axis either: a guess
};

struct Upward {
  Vec3 direction = Vec3::UnitY();  ///< in the file's axes, of any length > 0
  UpwardEvidence evidence = UpwardEvidence::nothing;
};

/// The axis that the file states to be up; the zero vector if it does not.
Vec3 stated_up(const PointRecording& recording);

/// The axis that is usually up in files of a format: +Y in TRC (OpenSim), +Z in C3D (laboratories);
/// the zero vector for others.
Vec3 usual_up(const PointRecording& recording);

/// Which way is up in a recording: by names, else by shape, else as the file states, for statements
/// are often wrong; else as is usual in its format.
///
/// Names: from the feet to the head and trunk, else from the feet to the pelvis, else, if it is
/// nearly along an axis, from the pelvis to the trunk and head or from the knees to the pelvis. A
/// name counts by its role in the recognised marker set (marker_sets.h) or by a word in it
/// ("latKnee", "heel"); no set need be recognised. Shape: the axis along which the points extend
/// most, less their travel, towards the end that the lowest points do not share: feet come to rest
/// on one level, heads do not. It counts if eight points or more extend along it half as far again
/// as along the others, over the height of a person (0.8 to 2.5 m) where the file states its unit,
/// and one end keeps its level twice as well as the other, which moves by 1.5 % of the extent or
/// more: a person who lies still is not taken to stand. These bounds are our decisions.
Upward upward_in(const PointRecording& recording);

}  // namespace mien::motion
