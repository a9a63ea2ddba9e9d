#pragma once

#include <cmath>

#include "motion/modify/posture.h"
#include "motion/synthetic_walk.h"

namespace mien::test {

/// A figure that jumps up and down on the spot. Its pelvis follows a parabola in the air and a
/// parabola on the floor, which meet with the same speed; its feet stay on the floor or go with it.
struct JumpingFigure {
  double flight = 0.36;   ///< seconds in the air
  double contact = 0.44;  ///< seconds on the floor between flights
  double frames_per_second = 100.0;
  double gravity = 9.81;  ///< m/s² in which it jumps
  int jumps = 3;          ///< of a motion that does not loop

  double period() const { return flight + contact; }

  /// Height above the height at take-off.
  double rise(double seconds) const {
    const double t = seconds - std::floor(seconds / period()) * period();
    if (t < contact) return -0.5 * gravity * flight / contact * t * (contact - t);
    return 0.5 * gravity * (t - contact) * (period() - t);
  }
};

inline Clip jumping(const JumpingFigure& figure, bool loops) {
  Clip clip;
  clip.name = "jumping";
  clip.body = standard_body();
  clip.frames_per_second = figure.frames_per_second;
  clip.loops = loops;
  const Pose standing = standing_pose(clip.body);
  const std::vector<Vec3> places = world_positions(clip.body, standing);
  const double seconds = figure.period() * (loops ? 1 : figure.jumps);
  const int frames = static_cast<int>(std::lround(seconds * figure.frames_per_second));
  for (int f = 0; f < (loops ? frames : frames + 1); ++f) {
    const double rise = figure.rise(f / figure.frames_per_second);
    Pose pose = standing;
    pose.root_position.y() += rise - 0.01;
    const double lift = std::max(0.0, rise);
    for (const BodyJoint hip : {LeftHip, RightHip}) {
      const Vec3 ankle = places[static_cast<size_t>(hip + 2)] + Vec3(0, lift, 0);
      put_leg(pose, clip.body, hip, {ankle, 0.0});
    }
    clip.poses.push_back(pose);
  }
  return clip;
}

}  // namespace mien::test
