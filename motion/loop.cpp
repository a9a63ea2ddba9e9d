#include "motion/loop.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "motion/gait_events.h"
#include "motion/mirror.h"
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

/// Share of a difference at the seam that sample `i` of n takes: ½ at the start, −½ at the end.
double offset_share(int i, int n) { return 0.5 - static_cast<double>(i) / (n - 1); }

/// The two fades of a speed change of 1 at the seam: ½ of it after the start, ½ before the end.
struct Fade {
  double after_start = 0.0;
  double before_end = 0.0;
};

Fade fade_share(int i, int n, double rate) {
  const double duration = (n - 1) / rate;
  // Two fades must not overlap by more than half a short cycle.
  const double b = std::min(fade_seconds, 0.5 * duration);
  return {0.5 * fading(i / rate, b), 0.5 * fading(duration - i / rate, b)};
}

/// Rotation velocity at the first of three frames.
Vec3 rotation_velocity(const Quat& q0, const Quat& q1, const Quat& q2, double rate) {
  return start_velocity(Vec3::Zero(), log(q1 * q0.conjugate()), log(q2 * q0.conjugate()), rate);
}

/// Velocity at the end − velocity at the start of a joint's rotation.
Vec3 rotation_speed_change(const std::vector<Pose>& poses, int joint, int start_joint,
                           bool mirror_start, double rate) {
  const size_t n = poses.size();
  const Vec3 start =
      rotation_velocity(poses[0].rotations[start_joint], poses[1].rotations[start_joint],
                        poses[2].rotations[start_joint], rate);
  const Vec3 end = -rotation_velocity(poses[n - 1].rotations[joint], poses[n - 2].rotations[joint],
                                      poses[n - 3].rotations[joint], rate);
  return end - (mirror_start ? mirrored_turn(start) : start);
}

Vec3 root_speed_change(const std::vector<Pose>& poses, bool mirror_start, double rate) {
  const size_t n = poses.size();
  const Vec3 start =
      start_velocity(poses[0].root_position, poses[1].root_position, poses[2].root_position, rate);
  const Vec3 end = -start_velocity(poses[n - 1].root_position, poses[n - 2].root_position,
                                   poses[n - 3].root_position, rate);
  return end - (mirror_start ? mirrored_place(start) : start);
}

void close_rotations(std::vector<Pose>& poses, int joint, double rate) {
  const int n = static_cast<int>(poses.size());
  const auto at = [&](int i) -> Quat& { return poses[i].rotations[joint]; };
  const Vec3 difference = log(at(n - 1) * at(0).conjugate());
  for (int i = 0; i < n; ++i) at(i) = exp(offset_share(i, n) * difference) * at(i);
  const Vec3 change = rotation_speed_change(poses, joint, joint, false, rate);
  for (int i = 0; i < n; ++i) {
    const Fade fade = fade_share(i, n, rate);
    at(i) = (exp((fade.after_start + fade.before_end) * change) * at(i)).normalized();
  }
}

/// Closes what `travel` does not explain: the way along it stays.
void close_root(std::vector<Pose>& poses, const Vec3& travel, double rate) {
  const int n = static_cast<int>(poses.size());
  const Vec3 difference = poses.back().root_position - poses.front().root_position - travel;
  for (int i = 0; i < n; ++i) poses[i].root_position += offset_share(i, n) * difference;
  const Vec3 change = root_speed_change(poses, false, rate);
  for (int i = 0; i < n; ++i) {
    const Fade fade = fade_share(i, n, rate);
    poses[i].root_position += (fade.after_start + fade.before_end) * change;
  }
}

/// Makes the end of a step along +Z meet the mirror image of its start, `travel` on. A correction
/// at the start is the mirror image of what it must be at the seam, on the joint of the other side.
void close_step(std::vector<Pose>& poses, double travel, double rate) {
  const int n = static_cast<int>(poses.size());
  const Pose start = mirrored(poses.front());
  std::array<Vec3, body_joint_count> differences;
  for (int j = 0; j < body_joint_count; ++j) {
    differences[j] = log(poses.back().rotations[j] * start.rotations[j].conjugate());
  }
  const Vec3 root = poses.back().root_position - start.root_position - Vec3(0.0, 0.0, travel);
  for (int i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / (n - 1);
    for (int j = 0; j < body_joint_count; ++j) {
      const Vec3 at_start = mirrored_turn(differences[mirrored(BodyJoint(j))]);
      const Vec3 offset = 0.5 * ((1.0 - share) * at_start - share * differences[j]);
      poses[i].rotations[j] = exp(offset) * poses[i].rotations[j];
    }
    poses[i].root_position += 0.5 * ((1.0 - share) * mirrored_place(root) - share * root);
  }
  std::array<Vec3, body_joint_count> changes;
  for (int j = 0; j < body_joint_count; ++j) {
    changes[j] = rotation_speed_change(poses, j, mirrored(BodyJoint(j)), true, rate);
  }
  const Vec3 root_change = root_speed_change(poses, true, rate);
  for (int i = 0; i < n; ++i) {
    const Fade fade = fade_share(i, n, rate);
    for (int j = 0; j < body_joint_count; ++j) {
      const Vec3 after_start = mirrored_turn(changes[mirrored(BodyJoint(j))]);
      const Vec3 turn = fade.after_start * after_start + fade.before_end * changes[j];
      poses[i].rotations[j] = (exp(turn) * poses[i].rotations[j]).normalized();
    }
    poses[i].root_position +=
        fade.after_start * mirrored_place(root_change) + fade.before_end * root_change;
  }
}

}  // namespace

Clip closed_loop(const Clip& clip, int start, int end) {
  assert(!clip.loops && start >= 0 && end < clip.frame_count() && end - start >= 3);
  Clip loop = clip;
  loop.poses.assign(clip.poses.begin() + start, clip.poses.begin() + end + 1);
  Vec3 travel = loop.poses.back().root_position - loop.poses.front().root_position;
  travel.y() = 0.0;
  for (int j = 0; j < body_joint_count; ++j) {
    close_rotations(loop.poses, j, clip.frames_per_second);
  }
  close_root(loop.poses, travel, clip.frames_per_second);
  loop.poses.pop_back();
  loop.loops = true;
  loop.cycle_displacement = travel;
  return loop;
}

Clip mirrored_loop(const Clip& clip, int start, int end) {
  assert(!clip.loops && start >= 0 && end < clip.frame_count() && end - start >= 3);
  const std::vector<Vec3> directions = walking_directions(clip);
  Vec3 direction = Vec3::Zero();
  for (int t = start; t <= end; ++t) direction += directions[t];
  const Quat turn = heading(direction).conjugate();
  Clip loop = clip;
  loop.poses.assign(clip.poses.begin() + start, clip.poses.begin() + end + 1);
  const Vec3 middle =
      turn * (0.5 * (loop.poses.front().root_position + loop.poses.back().root_position));
  for (Pose& pose : loop.poses) {
    pose.root_position = turn * pose.root_position - Vec3(middle.x(), 0.0, 0.0);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  const double travel = loop.poses.back().root_position.z() - loop.poses.front().root_position.z();
  close_step(loop.poses, travel, clip.frames_per_second);
  loop.poses.pop_back();
  const size_t half = loop.poses.size();
  for (size_t i = 0; i < half; ++i) {
    loop.poses.push_back(mirrored(loop.poses[i]));
    loop.poses.back().root_position.z() += travel;
  }
  loop.loops = true;
  loop.cycle_displacement = Vec3(0.0, 0.0, 2.0 * travel);
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
