#include "pipeline/base/drawing/figure_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"

namespace mien::pipeline {
namespace {

motion::Pose standing_pose() {
  motion::Pose pose;
  pose.root_position.y() = 1.0;
  pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
  return pose;
}

std::ptrdiff_t limbs_with(const Figure& figure, std::size_t joints) {
  return std::ranges::count_if(figure,
                               [&](const Limb& limb) { return limb.joints.size() == joints; });
}

TEST(AFigureOnASheet, HasOneStrokeForAHandWithoutFingers) {
  const Figure figure = figure_of(motion::standard_body(), standing_pose());
  EXPECT_EQ(figure.size(), 6u);
  EXPECT_EQ(limbs_with(figure, 6), 4);  // arms and legs with their ends
}

TEST(AFigureOnASheet, HasTheFingersOfAMotion) {
  const motion::Skeleton body = motion::standard_body();
  motion::Pose pose = standing_pose();
  pose.fingers = motion::relaxed_fingers();
  const Figure figure = figure_of(body, pose);
  EXPECT_EQ(figure.size(), 16u);
  EXPECT_EQ(limbs_with(figure, 6), 2);   // legs
  EXPECT_EQ(limbs_with(figure, 5), 13);  // trunk, arms to the wrist, ten fingers
  const motion::Skeleton handed = motion::with_fingers(body);
  const motion::JointTransforms world =
      motion::world_transforms(handed, motion::with_fingers(pose));
  const auto last = static_cast<std::size_t>(motion::body_joint_count +
                                             motion::finger_joint(true, motion::Finger::index, 2));
  const motion::Vec3 tip = world.positions[last] + world.rotations[last] * *handed.joints[last].tip;
  EXPECT_TRUE(std::ranges::any_of(figure, [&](const Limb& limb) {
    return limb.left && std::abs(limb.joints.back().up - tip.y()) < 1e-9;
  }));
}

}  // namespace
}  // namespace mien::pipeline
