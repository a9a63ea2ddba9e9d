#include "motion/gait/loop.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "motion/gait/gait_events.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {

namespace {

constexpr double velocity_seconds = 0.1;  // weight of a velocity against a position

using Features = std::array<DirectionVectors, body_joint_count>;

Features features_at(const Clip& clip, int frame) {
  const Pose& pose = clip.poses[frame];
  Features features;
  for (int j = 0; j < body_joint_count; ++j) {
    features[j] = to_direction_vectors(pose.rotations[j]);
  }
  const Quat facing = heading(pose.rotations[Pelvis] * Vec3::UnitZ());
  features[Pelvis] = to_direction_vectors(facing.conjugate() * pose.rotations[Pelvis]);
  return features;
}

double squared_distance(const DirectionVectors& a, const DirectionVectors& b) {
  return (a.d1 - b.d1).squaredNorm() + (a.d2 - b.d2).squaredNorm();
}

/// Change of the features per second around a frame, one-sided at the ends of the clip.
Features velocity_at(const Clip& clip, int frame) {
  const int before = std::max(0, frame - 1);
  const int after = std::min(clip.frame_count() - 1, frame + 1);
  const double rate = clip.frames_per_second / std::max(1, after - before);
  Features velocity = features_at(clip, after);
  const Features earlier = features_at(clip, before);
  for (int j = 0; j < body_joint_count; ++j) {
    velocity[j].d1 = (velocity[j].d1 - earlier[j].d1) * rate;
    velocity[j].d2 = (velocity[j].d2 - earlier[j].d2) * rate;
  }
  return velocity;
}

constexpr double fade_seconds = 0.2;

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

/// How the velocities at the ends of a cycle are measured. Where the clip goes on beyond both ends,
/// central differences at both: of a motion that repeats they are equal, however it accelerates.
struct Stencil {
  int before = -1;  ///< frames from the end
  int after = 1;
};

struct EndStencils {
  Stencil start;
  Stencil end;
};

EndStencils end_stencils(const Clip& clip, int start, int end) {
  const bool goes_before = start > 0;
  const bool goes_after = end + 1 < clip.frame_count();
  if (goes_before && goes_after) return {};
  if (goes_after) return {{0, 1}, {0, 1}};
  if (goes_before) return {{-1, 0}, {-1, 0}};
  return {{0, 1}, {-1, 0}};
}

/// The joints of the body, or those of the hands.
using JointList = std::vector<Quat> Pose::*;

Vec3 turning(const Clip& clip, int frame, JointList joints, int joint, const Stencil& stencil) {
  const Quat& from = (clip.poses[frame + stencil.before].*joints)[joint];
  const Quat& to = (clip.poses[frame + stencil.after].*joints)[joint];
  return log(to * from.conjugate()) * (clip.frames_per_second / (stencil.after - stencil.before));
}

Vec3 root_velocity(const Clip& clip, int frame, const Stencil& stencil) {
  return (clip.poses[frame + stencil.after].root_position -
          clip.poses[frame + stencil.before].root_position) *
         (clip.frames_per_second / (stencil.after - stencil.before));
}

void close_rotations(std::vector<Pose>& poses, JointList joints, int joint, const Clip& clip,
                     int start, int end) {
  const int n = static_cast<int>(poses.size());
  const EndStencils stencils = end_stencils(clip, start, end);
  const Vec3 difference =
      log((poses.back().*joints)[joint] * (poses.front().*joints)[joint].conjugate());
  // Offsets turn the velocities at the ends along.
  const Vec3 change = exp(-0.5 * difference) * turning(clip, end, joints, joint, stencils.end) -
                      exp(0.5 * difference) * turning(clip, start, joints, joint, stencils.start);
  for (int i = 0; i < n; ++i) {
    const Fade fade = fade_share(i, n, clip.frames_per_second);
    Quat& rotation = (poses[i].*joints)[joint];
    rotation = (exp((fade.after_start + fade.before_end) * change) *
                exp(offset_share(i, n) * difference) * rotation)
                   .normalized();
  }
}

/// Closes what `travel` does not explain: the way along it stays.
void close_root(std::vector<Pose>& poses, const Vec3& travel, const Clip& clip, int start,
                int end) {
  const int n = static_cast<int>(poses.size());
  const EndStencils stencils = end_stencils(clip, start, end);
  const Vec3 difference = poses.back().root_position - poses.front().root_position - travel;
  const Vec3 change =
      root_velocity(clip, end, stencils.end) - root_velocity(clip, start, stencils.start);
  for (int i = 0; i < n; ++i) {
    const Fade fade = fade_share(i, n, clip.frames_per_second);
    poses[i].root_position +=
        offset_share(i, n) * difference + (fade.after_start + fade.before_end) * change;
  }
}

/// What a step's end must lose to meet the mirror image of its start: of each joint's rotation and
/// of the root's place.
struct StepMismatch {
  std::vector<Vec3> turns;
  std::vector<Vec3> finger_turns;
  Vec3 place;
};

int mirrored_body_joint(int joint) { return mirrored(BodyJoint(joint)); }

void correct(std::vector<Quat>& rotations, const std::vector<Vec3>& turns, int (*mirror)(int),
             double at_start, double at_end) {
  for (int j = 0; j < static_cast<int>(rotations.size()); ++j) {
    const Vec3 image = mirrored_turn(turns[mirror(j)]);
    rotations[j] = (exp(at_start * image + at_end * turns[j]) * rotations[j]).normalized();
  }
}

/// Adds `at_end` times the mismatch, and `at_start` times its mirror image on the other side.
void correct(Pose& pose, const StepMismatch& mismatch, double at_start, double at_end) {
  correct(pose.rotations, mismatch.turns, mirrored_body_joint, at_start, at_end);
  correct(pose.fingers, mismatch.finger_turns, mirrored_finger, at_start, at_end);
  pose.root_position += at_start * mirrored_place(mismatch.place) + at_end * mismatch.place;
}

/// Makes the end of a step along +Z meet the mirror image of its start, `travel` on. A correction
/// at the start shows at the seam as its mirror image, on the other side.
void close_step(std::vector<Pose>& poses, double travel, const Clip& clip, int start, int end) {
  const int n = static_cast<int>(poses.size());
  const EndStencils stencils = end_stencils(clip, start, end);
  const Pose image = mirrored(poses.front());
  StepMismatch poses_differ;
  StepMismatch speeds_differ;
  const auto differences = [&](JointList joints, int (*mirror)(int), std::vector<Vec3>& of_poses,
                               std::vector<Vec3>& of_speeds) {
    const std::vector<Quat>& last = poses.back().*joints;
    for (int j = 0; j < static_cast<int>(last.size()); ++j) {
      of_poses.push_back(log(last[j] * (image.*joints)[j].conjugate()));
      of_speeds.push_back(turning(clip, end, joints, j, stencils.end) -
                          mirrored_turn(turning(clip, start, joints, mirror(j), stencils.start)));
    }
  };
  differences(&Pose::rotations, mirrored_body_joint, poses_differ.turns, speeds_differ.turns);
  differences(&Pose::fingers, mirrored_finger, poses_differ.finger_turns,
              speeds_differ.finger_turns);
  poses_differ.place = poses.back().root_position - image.root_position - Vec3(0, 0, travel);
  speeds_differ.place = root_velocity(clip, end, stencils.end) -
                        mirrored_place(root_velocity(clip, start, stencils.start));
  for (int i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / (n - 1);
    const Fade fade = fade_share(i, n, clip.frames_per_second);
    correct(poses[i], poses_differ, 0.5 * (1.0 - share), -0.5 * share);
    correct(poses[i], speeds_differ, fade.after_start, fade.before_end);
  }
}

/// The clip turned so that frames `start` to `end` walk along +Z, half of their sway on either side
/// of x = 0.
Clip along_z(const Clip& clip, int start, int end) {
  const std::vector<Vec3> directions = walking_directions(clip);
  Vec3 direction = Vec3::Zero();
  for (int t = start; t <= end; ++t) direction += directions[t];
  const Quat turn = heading(direction).conjugate();
  const Vec3 middle =
      turn * (0.5 * (clip.poses[start].root_position + clip.poses[end].root_position));
  Clip turned = clip;
  for (Pose& pose : turned.poses) {
    pose.root_position = turn * pose.root_position - Vec3(middle.x(), 0.0, 0.0);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  return turned;
}

}  // namespace

double seam_cost(const Clip& clip, int start, int end) { return seam_cost(clip, start, clip, end); }

double seam_cost(const Clip& starting, int start, const Clip& ending, int end) {
  const Features at_start = features_at(starting, start);
  const Features at_end = features_at(ending, end);
  const Features speed_at_start = velocity_at(starting, start);
  const Features speed_at_end = velocity_at(ending, end);
  double cost = 0.0;
  for (int j = 0; j < body_joint_count; ++j) {
    cost +=
        squared_distance(at_start[j], at_end[j]) +
        velocity_seconds * velocity_seconds * squared_distance(speed_at_start[j], speed_at_end[j]);
  }
  return cost;
}

CycleRange best_cut(const Clip& clip, CycleRange near, int search) {
  const int last = clip.frame_count() - 1;
  CycleRange best = near;
  double least = seam_cost(clip, near.start, near.end);
  for (int start = std::max(0, near.start - search); start <= std::min(last, near.start + search);
       ++start) {
    for (int end = std::max(start + 2, near.end - search); end <= std::min(last, near.end + search);
         ++end) {
      const double cost = seam_cost(clip, start, end);
      if (cost < least) {
        least = cost;
        best = {start, end};
      }
    }
  }
  return best;
}

Clip closed_ends(const Clip& clip, int start, int end) {
  assert(!clip.loops && start >= 0 && end < clip.frame_count() && end - start >= 3);
  Clip closed = clip;
  closed.poses.assign(clip.poses.begin() + start, clip.poses.begin() + end + 1);
  Vec3 travel = closed.poses.back().root_position - closed.poses.front().root_position;
  travel.y() = 0.0;
  for (const JointList joints : {&Pose::rotations, &Pose::fingers}) {
    const auto count = static_cast<int>((clip.poses[start].*joints).size());
    for (int j = 0; j < count; ++j) close_rotations(closed.poses, joints, j, clip, start, end);
  }
  close_root(closed.poses, travel, clip, start, end);
  return closed;
}

Clip closed_loop(const Clip& clip, int start, int end) {
  Clip loop = closed_ends(clip, start, end);
  loop.cycle_displacement = loop.poses.back().root_position - loop.poses.front().root_position;
  loop.cycle_displacement.y() = 0.0;
  loop.poses.pop_back();
  loop.loops = true;
  return loop;
}

Clip mirrored_loop(const Clip& clip, int start, int end) {
  assert(!clip.loops && start >= 0 && end < clip.frame_count() && end - start >= 3);
  const Clip turned = along_z(clip, start, end);
  Clip loop = turned;
  loop.poses.assign(turned.poses.begin() + start, turned.poses.begin() + end + 1);
  const double travel = loop.poses.back().root_position.z() - loop.poses.front().root_position.z();
  close_step(loop.poses, travel, turned, start, end);
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
