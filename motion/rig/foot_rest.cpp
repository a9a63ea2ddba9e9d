#include "motion/rig/foot_rest.h"

#include <algorithm>

#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

/// Height of a joint above its own low level (tenth percentile), and its speed, frame by frame.
struct PointMotion {
  std::vector<double> heights;
  std::vector<double> speeds;
};

PointMotion point_motion(const RigMotion& motion, BodyJoint joint) {
  const int count = static_cast<int>(motion.frames.size());
  PointMotion result;
  for (int t = 0; t < count; ++t) {
    const int before = std::max(0, t - 1);
    const int after = std::min(count - 1, t + 1);
    const Vec3 step =
        motion.point(motion.frames[after], joint) - motion.point(motion.frames[before], joint);
    const double seconds = std::max(1, after - before) / motion.frames_per_second;
    result.heights.push_back(motion.point(motion.frames[t], joint).y());
    result.speeds.push_back(step.norm() / seconds);
  }
  const double low = percentile(result.heights, 10);
  for (double& height : result.heights) height -= low;
  return result;
}

}  // namespace

std::vector<int> flat_frames(const RigMotion& motion, BodyJoint ankle) {
  const auto toe = BodyJoint(ankle + 1);
  const PointMotion heel_end = point_motion(motion, ankle);
  const PointMotion toe_end = motion.has(toe) ? point_motion(motion, toe) : heel_end;
  const double leg = leg_length(motion);
  std::vector<int> flat;
  std::vector<double> heights;
  for (size_t t = 0; t < motion.frames.size(); ++t) {
    heights.push_back(std::max(heel_end.heights[t], toe_end.heights[t]));
    const bool low = heights.back() < 0.02 * leg;
    const bool slow = std::max(heel_end.speeds[t], toe_end.speeds[t]) < 0.25 * leg;
    if (low && slow) flat.push_back(static_cast<int>(t));
  }
  if (!flat.empty()) return flat;
  const double lowest_tenth = percentile(heights, 10);
  for (size_t t = 0; t < heights.size(); ++t) {
    if (heights[t] <= lowest_tenth) flat.push_back(static_cast<int>(t));
  }
  return flat;
}

FootRest foot_rest(std::span<const RigMotion> motions, BodyJoint ankle) {
  const auto toe = BodyJoint(ankle + 1);
  FootRest rest;
  for (const RigMotion& motion : motions) {
    for (int t : flat_frames(motion, ankle)) {
      const JointTransforms& frame = motion.frames[t];
      const Vec3 forward = motion.has(toe)
                               ? Vec3(motion.point(frame, toe) - motion.point(frame, ankle))
                               : Vec3(Vec3::Zero());
      const Quat into_ankle = motion.rotation(frame, ankle).conjugate();
      rest.up += into_ankle * Vec3::UnitY();
      rest.forward += into_ankle * forward;
      ++rest.frames;
      if (!motion.turns(toe)) continue;
      const Quat into_toe = motion.rotation(frame, toe).conjugate();
      rest.toe_up += into_toe * Vec3::UnitY();
      rest.toe_forward += into_toe * Vec3(forward.x(), 0.0, forward.z());
    }
  }
  return rest;
}

}  // namespace mien::motion
