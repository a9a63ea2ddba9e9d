#pragma once

#include <array>

#include <Eigen/Core>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How poses are compared for transitions.
struct CloudOptions {
  /// Length of the windows of frames that are compared, seconds: as long as the blend that would
  /// join them, so that speeds count too (Kovar, Gleicher and Pighin 2002: about 1/3 s).
  double window_seconds = 1.0 / 3.0;
  /// Distance of a virtual point off each bone, metres, so that a twist about the bone counts.
  double virtual_point_m = 0.1;
  /// Weight of each joint and its virtual point, by BodyJoint; only ratios matter.
  std::array<double, body_joint_count> joint_weights = [] {
    std::array<double, body_joint_count> weights{};
    weights.fill(1.0);
    return weights;
  }();
};

/// The points of a clip, frame by frame: each joint and one point off its bone. Coordinates are
/// multiplied by the root of the point's weight; the weights sum to 1.
struct PointCloud {
  Eigen::MatrixXd level;   ///< x of all points, then z; a column a frame. Metres
  Eigen::MatrixXd across;  ///< z of all points, then −x: `level` turned by a quarter
  Eigen::MatrixXd up;      ///< y
  Eigen::MatrixXd mean;    ///< weighted mean x and z; 2 × frames
  Eigen::VectorXd square;  ///< weighted mean of the squared length, a frame

  int frame_count() const { return static_cast<int>(square.size()); }
};

/// The point cloud of a clip of the canonical body. Weights are ≥ 0 and not all 0.
PointCloud point_cloud(const Clip& clip, const CloudOptions& options = {});

/// A rigid transform of the floor plane: a rotation about +Y, radians, then a translation along x
/// and z, metres.
struct PlaneAlignment {
  double turn = 0.0;
  double x = 0.0;
  double z = 0.0;
};

Vec3 aligned(const PlaneAlignment& alignment, const Vec3& place);

/// Distance of two windows of frames.
struct WindowDistance {
  double metres = 0.0;       ///< root of the weighted mean squared distance of the points
  PlaneAlignment alignment;  ///< that lays the second window on the first with the least distance
};

/// Distance of the windows of `frames` frames that begin at `first_a` and `first_b`, after the
/// optimal alignment, in closed form (Kovar, Gleicher and Pighin 2002, section 3.1). The same both
/// ways round; 0 of a window with itself, wherever it stands.
WindowDistance window_distance(const PointCloud& a, int first_a, const PointCloud& b, int first_b,
                               int frames);

}  // namespace mien::motion
