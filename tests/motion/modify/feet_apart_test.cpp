#include "motion/modify/feet_apart.h"

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

/// Feet that are put down by hand: the pelvis and both legs turned rigidly, so that only the ways
/// of the ankles count.
Clip footprints(const std::vector<Vec3>& left, const std::vector<Vec3>& right) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 100.0;
  const Pose standing = standing_pose(clip.body);
  const auto ankle = [&](BodyJoint joint) -> Vec3 {
    return world_positions(clip.body, standing)[static_cast<size_t>(joint)] -
           standing.root_position;
  };
  for (size_t i = 0; i < left.size(); ++i) {
    for (const auto& [joint, place] :
         {std::pair{LeftAnkle, left[i]}, std::pair{RightAnkle, right[i]}}) {
      for (int f = 0; f < 10; ++f) {
        Pose pose = standing;
        pose.root_position = place - ankle(joint);
        clip.poses.push_back(pose);
      }
    }
  }
  return clip;
}

std::vector<FootPlant> plants_of_footprints(size_t count) {
  std::vector<FootPlant> plants;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    plants.push_back({true, 20 * i, 20 * i + 9});
    plants.push_back({false, 20 * i + 10, 20 * i + 19});
  }
  return plants;
}

TEST(StepWidth, IsTheDistanceFromTheLineOfTheOtherFoot) {
  const Clip clip = footprints({{0.06, 0, 0}, {0.06, 0, 1}, {0.06, 0, 2}},
                               {{-0.06, 0, 0.5}, {-0.01, 0, 1.5}, {-0.06, 0, 2.5}});
  // The second step of the right foot is 7 cm from the line of the left one.
  EXPECT_NEAR(*least_step_width(clip, plants_of_footprints(3)), 0.07, 1e-9);
}

TEST(StepWidth, IsNegativeOfFeetThatCross) {
  const Clip clip = footprints({{-0.03, 0, 0}, {-0.03, 0, 1}}, {{0.02, 0, 0.5}, {0.02, 0, 1.5}});
  EXPECT_NEAR(*least_step_width(clip, plants_of_footprints(2)), -0.05, 1e-9);
}

TEST(StepWidth, IsTheSameWhereverSomebodyWalksAndMirrored) {
  const Clip clip = walk({}, 100.0, standard_body()).clip;
  const double width = *least_step_width(clip, foot_plants(clip));
  const Clip turned = mirrored(clip);
  EXPECT_NEAR(*least_step_width(turned, foot_plants(turned)), width, 1e-3);
}

TEST(StepWidth, OfWhoStandsIsThatOfHisAnkles) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 30.0;
  clip.poses.assign(30, standing_pose(clip.body));
  const auto places = world_positions(clip.body, clip.poses.front());
  const std::vector<FootPlant> plants = {{true, 0, 29}, {false, 0, 29}};
  EXPECT_NEAR(*least_step_width(clip, plants), places[LeftAnkle].x() - places[RightAnkle].x(),
              1e-9);
  EXPECT_FALSE(least_step_width(clip, {}));
}

}  // namespace
}  // namespace mien::motion
