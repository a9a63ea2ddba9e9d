#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Columns of the curves: three for the root's place, three for each joint.
inline constexpr int curve_count = 3 + 3 * body_joint_count;

/// First of the three columns of a joint's rotation; those of the root's place are 0, 1 and 2.
constexpr int first_curve(int joint) { return 3 + 3 * joint; }

/// A clip as the signals that the older methods of motion editing work on.
///
/// They were published for Euler angles. Here a joint's rotation q is the rotation vector (radians)
/// of q·m⁻¹ about the joint's mean rotation m, axes of the parent's frame: no gimbal lock, and
/// vectors of neighbouring frames are neighbours. The pelvis' rotation and the root's place
/// (metres) are taken in the frame of the clip's mean direction of walking (straighten.h), so that
/// motions that head elsewhere can be compared; the mean travel along the floor is subtracted, and
/// the horizontal part of the rest has mean zero.
struct MotionCurves {
  Clip timing;              ///< name, body, frame rate and whether it loops; no poses
  Quat heading;             ///< +Z → mean direction of walking
  Vec3 origin;              ///< horizontal mean of what the even way leaves, world space, metres
  Vec3 way;                 ///< along the floor in one cycle or take, frame of `heading`, metres
  std::vector<Quat> means;  ///< one a joint
  Eigen::MatrixXd values;   ///< frames × curve_count

  int frame_count() const { return static_cast<int>(values.rows()); }
};

/// The rotation vector of the same rotation that is nearest to `previous`.
Vec3 unwrapped(const Vec3& vector, const Vec3& previous);

/// Mean rotation (Karcher) of every joint, the pelvis' in the frame of the mean direction.
std::vector<Quat> mean_rotations(const Clip& clip);

/// About the clip's own means, or about others, so that curves of several clips can be compared.
/// Throws Error, naming the clip, when it is not of the canonical body or has fewer than 4 frames.
MotionCurves to_curves(const Clip& clip);
MotionCurves to_curves(const Clip& clip, const std::vector<Quat>& means);

/// The inverse of `to_curves`.
Clip to_clip(const MotionCurves& curves);

/// Values at `share` ∈ [0, 1) of a loop or [0, 1] of a take, between the frames by a cubic
/// (Catmull–Rom); at a frame that frame exactly.
Eigen::RowVectorXd curves_at(const MotionCurves& curves, double share);

/// The same curves with `frames` frames, evenly; the frame rate stays.
MotionCurves resampled(const MotionCurves& curves, int frames);

/// Values with the first frame once more at the end of a loop, so that both ends of two loops
/// correspond.
Eigen::MatrixXd with_closing_frame(const MotionCurves& curves);

/// Frames from the first to the last, of a loop to the one after the last.
double frame_span(const MotionCurves& curves);

/// Corresponding frames of `to` at each frame of `from`, found by dynamic programming in whole and
/// half frames, as a smooth course of time: what they are ahead of an even one, below 4 Hz.
std::vector<double> smoothed_times(const std::vector<double>& times, const MotionCurves& from,
                                   const MotionCurves& to);

}  // namespace mien::motion
