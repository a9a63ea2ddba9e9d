#include "motion/lint/limb_ends.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

std::vector<Vec3> limb_path(const LintMotion& motion, int end) {
  return path_in_frame_of(motion, end == LeftAnkle || end == RightAnkle ? Pelvis : Chest, end);
}

std::vector<Vec3> path_in_frame_of(const LintMotion& motion, int base, int joint) {
  std::vector<Vec3> path;
  for (const JointTransforms& world : motion.world) {
    const Vec3 from_base = world.positions[joint] - world.positions[base];
    path.push_back(world.rotations[base].conjugate() * from_base);
  }
  return path;
}

std::vector<Vec3> path_from_pelvis(const LintMotion& motion, int end) {
  std::vector<Vec3> path;
  for (const JointTransforms& world : motion.world)
    path.push_back(world.positions[end] - world.positions[Pelvis]);
  return path;
}

std::vector<Vec3> at_moments_of(const LintMotion& motion, const LintMotion& other,
                                const std::vector<Vec3>& path) {
  std::vector<Vec3> result;
  for (int t = 0; t < motion.frame_count(); ++t) {
    const double frame = corresponding_frame(motion, t, other);
    const auto whole = static_cast<size_t>(frame);
    const double part = frame - std::floor(frame);
    const size_t next = std::min(whole + 1, path.size() - 1);
    result.push_back((1.0 - part) * path[whole] + part * path[next]);
  }
  return result;
}

std::vector<FrameWindow> windows_of(const LintMotion& motion, double seconds, int least_frames) {
  const int whole = motion.frame_count();
  const int wanted = static_cast<int>(std::lround(seconds * motion.rate()));
  const int length = std::min(whole, std::max(wanted, least_frames));
  const int hop = std::max(1, length / 2);
  std::vector<FrameWindow> windows;
  int first = 0;
  for (; first + length < whole; first += hop) windows.push_back({first, first + length - 1});
  windows.push_back({whole - length, whole - 1});
  return windows;
}

std::vector<FrameWindow> limb_windows(const LintMotion& motion) {
  if (motion.was_loop) return {{motion.start, motion.start + motion.frames - 1}};
  return windows_of(motion, 2.0, 1);
}

void raise_to(std::vector<double>& values, const FrameWindow& window, double value) {
  for (int t = window.first; t <= window.last; ++t) values[t] = std::max(values[t], value);
}

}  // namespace mien::motion
