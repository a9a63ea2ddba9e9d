#pragma once

#include "motion/synthetic_walk.h"

namespace mien::test {

/// A runner whose events are known: each foot stands for `stance` of the stride (less than half),
/// so that between the steps the body flies; it is highest in the middle of each flight. As in
/// people, a foot takes some hundredths of a second to become as fast as the swing is.
struct SyntheticRun {
  double stride = 1.5;   ///< metres
  double stance = 0.32;  ///< share of the stride
  double bounce = 0.03;  ///< metres; amplitude of the pelvis
  double lean = 0.0;     ///< radians; the trunk leans forward
  double frames_per_second = 100.0;
};

/// The distance run by each frame becomes poses.
inline Clip synthetic_run(const SyntheticRun& run, const std::vector<double>& distance) {
  SyntheticWalk feet;
  feet.stride = run.stride;
  feet.stance = run.stance;
  feet.quickening = 0.1;
  feet.frames_per_second = run.frames_per_second;
  feet.distance = distance;
  Clip clip = synthetic_clip(feet);
  const double flight = 0.5 * (run.stance + 0.5);  // its middle, share of the stride
  for (size_t f = 0; f < distance.size(); ++f) {
    Pose& pose = clip.poses[f];
    const double phase = distance[f] / run.stride - flight;
    pose.root_position.y() = 0.82 + run.bounce * std::cos(4.0 * pi * phase);
    put_leg(pose, clip.body, LeftHip, foot_at(feet, distance[f], true));
    put_leg(pose, clip.body, RightHip, foot_at(feet, distance[f], false));
    pose.rotations[Spine] = about(Vec3::UnitX(), run.lean);
  }
  return clip;
}

inline Clip steady_run(const SyntheticRun& run, double speed, double seconds) {
  std::vector<double> distance;
  const int frames = static_cast<int>(std::lround(seconds * run.frames_per_second)) + 1;
  for (int f = 0; f < frames; ++f) distance.push_back(speed * f / run.frames_per_second);
  return synthetic_run(run, distance);
}

}  // namespace mien::test
