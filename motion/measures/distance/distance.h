#pragma once

#include <array>

#include <Eigen/Core>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// Alignment of two motions before they are compared.
enum class Alignment {
  pelvis,  ///< horizontal pelvis position and heading removed in every frame; height kept (default)
  world,   ///< horizontal pelvis position and heading aligned in the first frame only
};

inline constexpr int distance_times = 11;             ///< T + 1 of eq. (8)
inline constexpr int distance_joints = 20;            ///< J of eq. (8): all but the pelvis
inline constexpr double distance_threshold_m = 0.06;  ///< "the same motion" in the adjective paper

/// Distance between two motions, eq. (8) of the adjective paper. Metres.
struct Distance {
  double mean = 0.0;   ///< D: the sum divided by its (T+1)·J terms
  double sum = 0.0;    ///< D_sum: the sum itself, as eq. (8) is printed
  double mpjpe = 0.0;  ///< mean per-joint position error over all frames of the target
  Alignment alignment = Alignment::pelvis;
  /// Row j−1 is BodyJoint j, column t is time t/10 of the keytime-normalised duration.
  Eigen::Matrix<double, distance_joints, distance_times> by_joint_and_time;

  std::array<double, distance_joints> by_joint() const;  ///< mean over time
  std::array<double, distance_times> by_time() const;    ///< mean over joints
  bool matches() const { return mean < distance_threshold_m; }
};

/// Compares the motions at corresponding times. If their keytimes are equal in number but differ,
/// both are warped to common keytimes (the means of their normalized ones) and compared at the
/// normalized times t/T. Otherwise t/T is a fraction of each duration. D is symmetric; `mpjpe` is
/// not, because it uses the target's frames. Bone lengths are not changed or scaled.
Distance distance(const Example& target, const Example& created,
                  Alignment alignment = Alignment::pelvis);

/// The pose at a time without the horizontal pelvis position and heading of that pose
/// (Alignment::pelvis) or of the clip's first frame (Alignment::world).
Pose aligned_pose_at(const Clip& clip, double seconds, Alignment alignment);

/// Time in `motion`, seconds, that corresponds to the normalized time `share` ∈ [0, 1] of `timing`.
double corresponding_time(const Example& timing, const Example& motion, double share);

}  // namespace mien::motion
