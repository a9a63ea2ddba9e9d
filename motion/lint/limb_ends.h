#pragma once

#include <array>
#include <vector>

#include "motion/biomechanics/lint_motion.h"

namespace mien::motion {

/// The ends of the limbs, whose paths are checked: head, hands, feet.
inline constexpr std::array<int, 5> limb_ends = {Head, LeftWrist, RightWrist, LeftAnkle,
                                                 RightAnkle};

/// Path of a limb's end relative to the part of the trunk that carries the limb (chest or pelvis),
/// in its frame, metres: what the limb itself does.
std::vector<Vec3> limb_path(const LintMotion& motion, int end);

/// Path of a joint relative to another one, in the other one's frame, metres.
std::vector<Vec3> path_in_frame_of(const LintMotion& motion, int base, int joint);

/// Path of a limb's end relative to the pelvis, in the directions of the world, metres: what the
/// limb and the trunk do.
std::vector<Vec3> path_from_pelvis(const LintMotion& motion, int end);

/// A path in `other` at the moments that correspond to the frames of `motion`, linear between
/// frames.
std::vector<Vec3> at_moments_of(const LintMotion& motion, const LintMotion& other,
                                const std::vector<Vec3>& path);

/// Frames `first` to `last`, inclusive.
struct FrameWindow {
  int first;
  int last;
};

/// Windows of `seconds` (at least `least_frames` frames), each beginning in the middle of the one
/// before; one window if the motion is shorter.
std::vector<FrameWindow> windows_of(const LintMotion& motion, double seconds, int least_frames);

/// Windows in which a limb is compared with its original: of 2 s; of a loop, one lap.
std::vector<FrameWindow> limb_windows(const LintMotion& motion);

/// Raises the values in a window to `value`.
void raise_to(std::vector<double>& values, const FrameWindow& window, double value);

}  // namespace mien::motion
