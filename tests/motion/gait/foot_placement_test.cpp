#include "motion/gait/foot_placement.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/gait/foot_path.h"
#include "motion/math/rotation.h"
#include "motion/modify/posture.h"

namespace mien::motion {
namespace {

constexpr double rate = 100.0;

/// Stands on legs that are bent by 5 degrees at the knees.
Clip standing_on_straight_legs(int frames) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = rate;
  Pose pose = standing_pose(clip.body);
  for (const BodyJoint knee : {LeftKnee, RightKnee})
    pose.rotations[knee] = exp(Vec3(5.0 * radians_per_degree, 0.0, 0.0));
  clip.poses.assign(static_cast<size_t>(frames), pose);
  return clip;
}

/// The left foot goes away from the hip to the front and back, farthest in the middle.
FootTrajectory out_and_back(const Clip& clip, double metres) {
  const FootPath path = foot_path(clip, true);
  FootTrajectory trajectory{true, 0, {}};
  for (int f = 0; f < clip.frame_count(); ++f) {
    const double s = std::sin(pi * f / (clip.frame_count() - 1.0));
    trajectory.places.push_back(
        {path.ankle_at(f) + Vec3(0.0, 0.0, metres * s * s), path.rotation_at(f)});
  }
  return trajectory;
}

double flexion(const Pose& pose) { return log(pose.rotations[LeftKnee]).norm(); }

TEST(FootPlacement, SwingsNoKneeThroughTheEndOfItsReach) {
  const Clip clip = standing_on_straight_legs(50);
  for (const double metres : {0.1, 0.2, 0.3, 0.4}) {
    const FootTrajectory trajectory = out_and_back(clip, metres);
    const Clip placed = with_feet_placed(clip, {trajectory});
    const FootPath path = foot_path(placed, true);
    double fastest = 0.0;
    for (int f = 1; f + 1 < placed.frame_count(); ++f) {
      EXPECT_LT((path.ankle_at(f) - trajectory.places[static_cast<size_t>(f)].ankle).norm(), 1e-3);
      const auto at = static_cast<size_t>(f);
      fastest = std::max(fastest,
                         std::abs(flexion(placed.poses[at + 1]) - 2.0 * flexion(placed.poses[at]) +
                                  flexion(placed.poses[at - 1])));
    }
    // In degrees per frame, by which the knee's speed changes from one frame to the next.
    EXPECT_LT(fastest / radians_per_degree, 3.0) << metres;
    // Where it reaches farthest, the knee is bent more than the 5 degrees that it stood at.
    EXPECT_GT(flexion(placed.poses[24]) / radians_per_degree, 5.5) << metres;
  }
}

TEST(FootPlacement, LeavesLegsAsStraightAsTheyWere) {
  const Clip clip = standing_on_straight_legs(20);
  const Clip placed = with_feet_placed(clip, {out_and_back(clip, 0.0)});
  for (const Pose& pose : placed.poses) {
    EXPECT_NEAR(pose.root_position.y(), clip.poses[0].root_position.y(), 1e-9);
    EXPECT_NEAR(flexion(pose), flexion(clip.poses[0]), 1e-6);
  }
}

}  // namespace
}  // namespace mien::motion
