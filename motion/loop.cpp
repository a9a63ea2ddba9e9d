#include "motion/loop.h"

#include <algorithm>
#include <cassert>

#include "motion/rotation.h"

namespace mien::motion {

namespace {

constexpr double fade_seconds = 0.2;

/// Derivative by three points at the first frames, per second.
Vec3 start_velocity(const Vec3& x0, const Vec3& x1, const Vec3& x2, double rate) {
  return (-1.5 * x0 + 2.0 * x1 - 0.5 * x2) * rate;
}

/// A displacement of unit speed at time 0 that is back at rest after `fade`: b(s³ − 2s² + s).
double fading(double seconds, double fade) {
  const double s = std::min(seconds / fade, 1.0);
  return fade * (s * s * s - 2.0 * s * s + s);
}

/// What to add to sample `i` of a signal of n samples so that its end meets its start: `difference`
/// is end − start, `speed_change` the velocity at the end − at the start.
struct Closing {
  Vec3 difference = Vec3::Zero();
  Vec3 speed_change = Vec3::Zero();

  Vec3 offset(int i, int n) const {
    return (0.5 - static_cast<double>(i) / (n - 1)) * difference;
  }

  Vec3 fade(int i, int n, double rate) const {
    const double duration = (n - 1) / rate;
    const double time = i / rate;
    // Two fades must not overlap by more than half a short cycle.
    const double b = std::min(fade_seconds, 0.5 * duration);
    return 0.5 * (fading(time, b) + fading(duration - time, b)) * speed_change;
  }
};

/// Rotation as seen from the frame before it, as velocities: exact for steady turning.
Vec3 rotation_velocity(const Quat& q0, const Quat& q1, const Quat& q2, double rate) {
  return start_velocity(Vec3::Zero(), log(q1 * q0.conjugate()), log(q2 * q0.conjugate()), rate);
}

void close_rotations(std::vector<Pose>& poses, size_t joint, double rate) {
  const int n = static_cast<int>(poses.size());
  const auto at = [&](int i) -> Quat& { return poses[i].rotations[joint]; };
  Closing closing;
  closing.difference = log(at(n - 1) * at(0).conjugate());
  for (int i = 0; i < n; ++i) at(i) = exp(closing.offset(i, n)) * at(i);
  closing.speed_change = -rotation_velocity(at(n - 1), at(n - 2), at(n - 3), rate) -
                         rotation_velocity(at(0), at(1), at(2), rate);
  for (int i = 0; i < n; ++i) {
    at(i) = (exp(closing.fade(i, n, rate)) * at(i)).normalized();
  }
}

/// Closes what `travel` does not explain: the way along it stays.
void close_root(std::vector<Pose>& poses, const Vec3& travel, double rate) {
  const int n = static_cast<int>(poses.size());
  const auto at = [&](int i) -> Vec3& { return poses[i].root_position; };
  Closing closing;
  closing.difference = at(n - 1) - at(0) - travel;
  for (int i = 0; i < n; ++i) at(i) += closing.offset(i, n);
  closing.speed_change = -start_velocity(at(n - 1), at(n - 2), at(n - 3), rate) -
                         start_velocity(at(0), at(1), at(2), rate);
  for (int i = 0; i < n; ++i) at(i) += closing.fade(i, n, rate);
}

}  // namespace

Clip closed_loop(const Clip& clip, int start, int end) {
  assert(!clip.loops && start >= 0 && end < clip.frame_count() && end - start >= 3);
  Clip loop = clip;
  loop.poses.assign(clip.poses.begin() + start, clip.poses.begin() + end + 1);
  Vec3 travel = loop.poses.back().root_position - loop.poses.front().root_position;
  travel.y() = 0.0;
  for (size_t j = 0; j < body_joint_count; ++j) {
    close_rotations(loop.poses, j, clip.frames_per_second);
  }
  close_root(loop.poses, travel, clip.frames_per_second);
  loop.poses.pop_back();
  loop.loops = true;
  loop.cycle_displacement = travel;
  return loop;
}

Clip shifted_loop(const Clip& loop, int frames) {
  assert(loop.loops);
  const int count = loop.frame_count();
  Clip result = loop;
  for (int i = 0; i < count; ++i) {
    const int from = i + frames;
    const int lap = from >= 0 ? from / count : -((-from + count - 1) / count);
    result.poses[i] = loop.poses[from - lap * count];
    result.poses[i].root_position += lap * loop.cycle_displacement;
  }
  return result;
}

}  // namespace mien::motion
