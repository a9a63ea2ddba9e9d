#include "motion/gait/seam_cost.h"

#include <algorithm>
#include <array>

#include "motion/math/rotation.h"

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

}  // namespace

double seam_cost(const Clip& clip, int start, int end) {
  const Features at_start = features_at(clip, start);
  const Features at_end = features_at(clip, end);
  const Features speed_at_start = velocity_at(clip, start);
  const Features speed_at_end = velocity_at(clip, end);
  double cost = 0.0;
  for (int j = 0; j < body_joint_count; ++j) {
    cost +=
        squared_distance(at_start[j], at_end[j]) +
        velocity_seconds * velocity_seconds * squared_distance(speed_at_start[j], speed_at_end[j]);
  }
  return cost;
}

CyclePlace best_cut(const Clip& clip, CyclePlace near, int search) {
  const int last = clip.frame_count() - 1;
  CyclePlace best = near;
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

}  // namespace mien::motion
