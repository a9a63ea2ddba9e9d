#pragma once

#include <array>

#include <Eigen/Core>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How poses are compared for transitions.
struct CloudOptions {
  /// Length of the compared windows of frames, seconds: the duration of the blend that would join
  /// them, so that velocities are compared too (Kovar, Gleicher and Pighin 2002: about 1/3 s).
  double window_seconds = 1.0 / 3.0;
  /// Distance of each joint's virtual point from the bone, metres, so that a twist about the bone
  /// counts.
  double virtual_point_m = 0.1;
  /// Weight of each joint and its virtual point, by BodyJoint; only ratios matter.
  std::array<double, body_joint_count> joint_weights = [] {
    std::array<double, body_joint_count> weights{};
    weights.fill(1.0);
    return weights;
  }();
};

/// The points of a clip, frame by frame: each joint and one point off its bone. Coordinates are
/// multiplied by the square root of the point's weight; the weights sum to 1.
struct PointCloud {
  Eigen::MatrixXd level;   ///< x of all points, then z; one column per frame; metres
  Eigen::MatrixXd across;  ///< z of all points, then −x: `level` rotated by 90°
  Eigen::MatrixXd up;      ///< y
  Eigen::MatrixXd mean;    ///< weighted mean x and z; 2 × frames
  Eigen::VectorXd square;  ///< weighted mean squared distance from the origin, per frame

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
  PlaneAlignment alignment;  ///< of the second window with the first, at the least distance
};

/// Distance of the windows of `frames` frames that begin at `first_a` and `first_b`, after the
/// optimal alignment, in closed form (Kovar, Gleicher and Pighin 2002, section 3.1). Symmetric; 0
/// for a window and a copy of it that is moved or rotated on the floor.
WindowDistance window_distance(const PointCloud& a, int first_a, const PointCloud& b, int first_b,
                               int frames);

}  // namespace mien::motion
