#include "scenes/stage/travel.h"

namespace mien::scenes {

namespace {

constexpr double least_speed = 0.05;  // m/s

}  // namespace

motion::Vec3 mean_step(const motion::Clip& clip) {
  if (clip.frame_count() < 2) return motion::Vec3::Zero();
  motion::Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  way.y() = 0.0;
  const motion::Vec3 step = way / (clip.frame_count() - 1);
  const bool goes = step.norm() * clip.frames_per_second >= least_speed;
  return goes ? step : motion::Vec3::Zero();
}

motion::Clip on_the_spot(motion::Clip clip, const motion::Vec3& step) {
  double frame = 0.0;
  for (motion::Pose& pose : clip.poses) pose.root_position -= frame++ * step;
  return clip;
}

}  // namespace mien::scenes
