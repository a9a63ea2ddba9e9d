#include "motion/biomechanics/lint_motion.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/contact.h"

namespace mien::motion {

namespace {

constexpr int laps = 3;
constexpr double slowest_walk = 0.15;  // m/s

/// Floor velocity under the planted feet of a motion in place; zero for all others.
Vec3 floor_under(const Clip& motion) {
  if (motion.loops) return floor_velocity(motion);
  if (motion.frame_count() < 3) return Vec3::Zero();
  Vec3 travel = motion.poses.back().root_position - motion.poses.front().root_position;
  travel.y() = 0.0;
  if (travel.norm() > slowest_walk * motion.duration_seconds()) return Vec3::Zero();
  Clip round = motion;
  round.loops = true;
  round.cycle_displacement = Vec3::Zero();
  return floor_velocity(round);
}

/// Zero where that is too slow to be one.
Vec3 treadmill_under(const Clip& motion) {
  const Vec3 floor = floor_under(motion);
  return floor.norm() < slowest_treadmill_m_s ? Vec3::Zero() : floor;
}

Clip off_treadmill(Clip motion, const Vec3& floor) {
  if (floor.isZero()) return motion;
  const double step_seconds = 1.0 / motion.frames_per_second;
  for (int t = 0; t < motion.frame_count(); ++t) {
    motion.poses[t].root_position -= t * step_seconds * floor;
  }
  if (motion.loops) motion.cycle_displacement = -motion.duration_seconds() * floor;
  return motion;
}

}  // namespace

std::vector<Vec3> LintMotion::path(int joint) const {
  std::vector<Vec3> positions;
  positions.reserve(world.size());
  for (const JointTransforms& frame : world) positions.push_back(frame.positions[joint]);
  return positions;
}

LintMotion lint_motion(const Clip& motion) {
  LintMotion prepared;
  prepared.frames = motion.frame_count();
  prepared.was_loop = motion.loops;
  prepared.clip = motion;
  for (Pose& pose : prepared.clip.poses) {
    for (Quat& rotation : pose.rotations) rotation.normalize();
  }
  const bool is_human = is_body(motion.body);
  if (is_human) {
    prepared.floor = treadmill_under(prepared.clip);
    prepared.clip = off_treadmill(std::move(prepared.clip), prepared.floor);
    prepared.scale = relative_stature(motion.body);
  }
  if (motion.loops) {
    prepared.clip = repeated(prepared.clip, laps);
    prepared.start = prepared.frames;
  }
  prepared.world.reserve(prepared.clip.poses.size());
  for (const Pose& pose : prepared.clip.poses) {
    prepared.world.push_back(world_transforms(prepared.clip.body, pose));
  }
  return prepared;
}

namespace {

/// Duration of the given motion, frames.
double duration_frames(const LintMotion& motion) {
  return motion.was_loop ? motion.frames : std::max(motion.frames - 1, 1);
}

}  // namespace

double corresponding_frame(const LintMotion& motion, double frame, const LintMotion& other) {
  const double share = (frame - motion.start) / duration_frames(motion);
  const double there = other.start + share * duration_frames(other);
  return std::clamp(there, 0.0, other.frame_count() - 1.0);
}

double pace(const LintMotion& motion, const LintMotion& other) {
  const double seconds = duration_frames(motion) / motion.rate();
  return duration_frames(other) / other.rate() / seconds;
}

}  // namespace mien::motion
