#pragma once

#include <array>

#include <Eigen/Core>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// Alignment of two motions before they are compared.
enum class Alignment {
  pelvis,  ///< pelvis at x = z = 0 and heading removed in every frame; height kept (default)
  world,   ///< both start with the pelvis at x = z = 0 and the same heading; then as they move
};

inline constexpr int distance_times = 11;             ///< T + 1 of eq. (8)
inline constexpr int distance_joints = 20;            ///< J of eq. (8): all but the pelvis
inline constexpr double distance_threshold_m = 0.06;  ///< "the same motion" in the adjective paper

/// Distance between two motions, eq. (8) of the adjective paper. Metres.
struct Distance {
  double mean = 0.0;   ///< D: the sum divided by its (T+1)·J terms
  double sum = 0.0;    ///< D_sum: as printed
  double mpjpe = 0.0;  ///< mean per-joint position error over all frames of the target
  Alignment alignment = Alignment::pelvis;
  /// Row j−1 is BodyJoint j, column t is time t/10 of the keytime-normalised duration.
  Eigen::Matrix<double, distance_joints, distance_times> by_joint_and_time;

  std::array<double, distance_joints> by_joint() const;  ///< mean over time
  std::array<double, distance_times> by_time() const;    ///< mean over joints
  bool matches() const { return mean < distance_threshold_m; }
};

/// Compares at corresponding moments: time t/T, whose keytimes are half way between those of the
/// two motions, is mapped through the keytimes of each when both have the same number of them, and
/// is otherwise linear in each duration. D is the same when the two change places (`mpjpe` goes by
/// the target's frames). Bones keep their own lengths; nothing is scaled.
Distance distance(const Example& target, const Example& created,
                  Alignment alignment = Alignment::pelvis);

/// The pose at a time, aligned for the comparison: horizontal position and heading removed, bones
/// and height kept.
Pose aligned_pose_at(const Clip& clip, double seconds, Alignment alignment);

/// Time in `motion` (seconds) that corresponds to the share `share` ∈ [0, 1] of `timing`'s
/// duration.
double corresponding_time(const Example& timing, const Example& motion, double share);

}  // namespace mien::motion
