#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Number of curves: three for the root position and three per joint.
inline constexpr int curve_count = 3 + 3 * body_joint_count;

/// First of the three columns of a joint's rotation. Columns 0, 1 and 2 are the root position.
constexpr int first_curve(int joint) { return 3 + 3 * joint; }

/// A clip as signals for the classic signal-based methods of motion editing.
///
/// These methods were published for Euler angles. Here a joint's rotation q is represented by the
/// rotation vector (radians, in the parent's frame) of q·m⁻¹, where m is the joint's mean rotation.
/// This avoids gimbal lock, and the vectors are continuous over time. The pelvis' rotation and the
/// root position (metres) are expressed in the frame of the clip's mean direction of travel
/// (straighten.h), so that motions with different headings can be compared. The mean horizontal
/// travel is subtracted from the root position, and the horizontal remainder has mean zero.
struct MotionCurves {
  Clip timing;   ///< name, body, frame rate and whether it loops; no poses
  Quat heading;  ///< rotation from +Z to the mean direction of travel
  Vec3 origin;   ///< horizontal mean of the root position after subtracting the mean travel, world
                 ///< space, metres
  Vec3 way;  ///< horizontal travel in one cycle, or in the whole clip, in the frame of `heading`,
             ///< metres
  std::vector<Quat> means;  ///< mean rotation per joint
  Eigen::MatrixXd values;   ///< frames × curve_count

  int frame_count() const { return static_cast<int>(values.rows()); }
};

/// `vector` or the rotation vector of the same rotation in the opposite direction, whichever is
/// nearer to `previous`.
Vec3 unwrapped(const Vec3& vector, const Vec3& previous);

/// Mean rotation (Karcher mean) of every joint; that of the pelvis in the frame of the mean
/// direction of travel.
std::vector<Quat> mean_rotations(const Clip& clip);

/// The curves of a clip, relative to its own mean rotations or to given ones (so that several clips
/// can be compared). Throws Error, naming the clip, if it is not of the canonical body or has fewer
/// than 4 frames.
MotionCurves to_curves(const Clip& clip);
MotionCurves to_curves(const Clip& clip, const std::vector<Quat>& means);

/// The inverse of `to_curves`.
Clip to_clip(const MotionCurves& curves);

/// Values at normalized time `share`, in [0, 1) for a loop and [0, 1] for other clips, by
/// Catmull–Rom interpolation; exact at the frames.
Eigen::RowVectorXd curves_at(const MotionCurves& curves, double share);

/// The same curves resampled uniformly to `frames` frames; the frame rate is unchanged.
MotionCurves resampled(const MotionCurves& curves, int frames);

/// The values; for a loop with the first frame repeated at the end, so that two loops correspond at
/// both ends.
Eigen::MatrixXd with_closing_frame(const MotionCurves& curves);

/// Number of frame intervals: frames − 1, or the number of frames for a loop.
double frame_span(const MotionCurves& curves);

/// Smooths `times`: for each frame of `from` the corresponding frame of `to`, which dynamic
/// programming determines in coarse steps only. The deviation of `times` from a uniform time
/// mapping is low-pass filtered at 4 Hz.
std::vector<double> smoothed_times(const std::vector<double>& times, const MotionCurves& from,
                                   const MotionCurves& to);

}  // namespace mien::motion
