#include "motion/gait/contact.h"

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Contact, BeginsAndEndsWhereFeetStandStill) {
  const SyntheticWalk walk = steady_walk(1.2, 5.0);  // one stride a second
  const Clip clip = synthetic_clip(walk);
  int plants = 0;
  for (const FootPlant& plant : foot_plants(clip)) {
    if (plant.first < 30 || plant.last > 470) continue;
    const double start = plant.left ? 0.0 : 50.0;
    const double cycle = std::round((plant.first - start) / 100.0);
    EXPECT_NEAR(plant.first, start + 100 * cycle, 6) << plant.left;
    EXPECT_NEAR(plant.last, start + 100 * cycle + 60, 6) << plant.left;
    ++plants;
  }
  EXPECT_EQ(plants, 8);
}

TEST(Contact, ToleratesAShortLossAndDropsAShortTouch) {
  SyntheticWalk still;
  still.frames_per_second = 200.0;
  still.distance.assign(100, 0.3);
  Clip clip = synthetic_clip(still);
  for (int t = 40; t < 42; ++t) clip.poses[t].root_position.y() += 0.045;
  const std::vector<FootPlant> plants = foot_plants(clip);
  ASSERT_EQ(plants.size(), 2u);
  EXPECT_EQ(plants[0].first, 0);
  EXPECT_EQ(plants[0].last, 99);
  // Up in the air but for a twentieth of a second.
  for (int t = 0; t < 100; ++t) {
    if (t < 70 || t >= 80) clip.poses[t].root_position.y() += 0.2;
  }
  EXPECT_TRUE(foot_plants(clip).empty());
}

TEST(Contact, OfALoopRunsOverItsSeam) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  // Cut in the middle of a left stance: 30 frames after its start.
  const Clip loop = closed_loop(clip, 130, 230);
  int left = 0;
  for (const FootPlant& plant : foot_plants(loop)) {
    if (!plant.left) continue;
    ++left;
    EXPECT_NEAR(plant.first, 70, 6);
    EXPECT_NEAR(plant.last, 130, 6);
  }
  EXPECT_EQ(left, 1);
  const FootContact contact = foot_contact(loop, true);
  ASSERT_EQ(contact.foot.size(), 100u);
  EXPECT_TRUE(contact.foot[0]);
  EXPECT_TRUE(contact.foot[99]);
  EXPECT_FALSE(contact.foot[50]);
}

TEST(Contact, ALoopStaysInPlaceThoughItsCycleDoesNotCloseExactly) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  EXPECT_FALSE(stays_in_place(clip));
  EXPECT_TRUE(floor_velocity(clip).isZero());
  for (const double drift : {0.0, 0.0005, 0.02}) {
    const Clip belt = travelling(in_place(clip), Vec3(drift, 0.0, 0.0));
    EXPECT_TRUE(stays_in_place(belt)) << drift;
    EXPECT_NEAR(floor_velocity(belt).norm(),
                clip.cycle_displacement.norm() / clip.duration_seconds(), 0.1);
  }
  // Somebody who creeps along on planted feet does not walk on a treadmill.
  Clip standing = clip;
  for (Pose& pose : standing.poses) pose = clip.poses.front();
  standing.cycle_displacement = Vec3::Zero();
  EXPECT_FALSE(stays_in_place(travelling(standing, Vec3(0.0, 0.0, 0.05))));
}

TEST(Contact, InPlaceIsToldByTheVelocityOfTheFloor) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  const Clip loop = in_place(straightened(closed_loop(clip, 100, 200)));
  const Vec3 floor = floor_velocity(loop);
  EXPECT_NEAR(floor.z(), -1.2, 0.03);
  ContactOptions options;
  options.floor_velocity = floor;
  EXPECT_EQ(foot_plants(loop, options).size(), 2u);
  EXPECT_TRUE(floor_velocity(travelling(loop, Vec3(0, 0, 1.2))).isZero());
}

}  // namespace
}  // namespace mien::motion
