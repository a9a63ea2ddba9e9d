#include "scenes/point_light/point_light.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "scenes/stage/shot.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

class PointLight : public testing::Test {
 protected:
  motion::Clip clip = test::walking_clip(60, Vec3::UnitZ(), 0.04);
  DotStage stage = {
      .centre = Vec3(0.4, 0.0, 0.5), .across = Vec3::UnitZ(), .step = mean_step(clip), .seed = 5};

  std::vector<Dot> dots(const PointLightOptions& options = {}) const {
    return point_light(clip, options, stage);
  }
};

/// The largest difference of what two dots do from frame to frame.
double difference_of_velocities(const DotPath& a, const DotPath& b) {
  double most = 0.0;
  for (std::size_t f = 1; f < a.size(); ++f) {
    most = std::max(most, ((a[f] - a[f - 1]) - (b[f] - b[f - 1])).norm());
  }
  return most;
}

TEST_F(PointLight, HasTheThirteenDotsOfTheLiterature) {
  const std::vector<Dot> shown = dots();
  ASSERT_EQ(shown.size(), 13u);
  std::set<std::string> kinds;
  for (const Dot& dot : shown) {
    kinds.insert(dot.kind);
    EXPECT_EQ(dot.path.size(), clip.poses.size());
  }
  EXPECT_EQ(kinds.size(), 13u);
  EXPECT_TRUE(kinds.contains("Head") && kinds.contains("LeftWrist") && kinds.contains("RightKnee"));
  EXPECT_FALSE(kinds.contains("Pelvis"));
  PointLightOptions all;
  all.joint_set = "all";
  EXPECT_EQ(dots(all).size(), static_cast<std::size_t>(motion::body_joint_count));
}

TEST_F(PointLight, IsWhereTheJointsAre) {
  PointLightOptions options;
  options.joint_set.clear();
  options.joints = {"RightWrist", "HeadTop"};
  const std::vector<Dot> shown = dots(options);
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    const motion::JointTransforms world = world_transforms(clip.body, clip.poses[f]);
    EXPECT_LT((shown[0].path[f] - world.positions[motion::RightWrist]).norm(), 1e-12);
    const Vec3 tip = world.positions[motion::Head] +
                     world.rotations[motion::Head] * *clip.body.joints[motion::Head].tip;
    EXPECT_LT((shown[1].path[f] - tip).norm(), 1e-12);
  }
  options.joints = {"LeftWrst"};
  try {
    dots(options);
    FAIL() << "took a joint that is not there";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"LeftWrist\"?"), std::string::npos);
  }
}

TEST_F(PointLight, ScrambledDotsKeepTheirMotionAndStayInTheFiguresRoom) {
  PointLightOptions options;
  options.scrambled = true;
  const std::vector<Dot> intact = dots();
  const std::vector<Dot> scrambled = dots(options);
  double moved = 0.0;
  for (std::size_t d = 0; d < intact.size(); ++d) {
    EXPECT_LT(difference_of_velocities(intact[d].path, scrambled[d].path), 1e-12);
    moved += (intact[d].path[0] - scrambled[d].path[0]).norm();
    for (const Vec3& point : scrambled[d].path) {
      EXPECT_GT(point.y(), -0.7);
      EXPECT_LT(point.y(), 2.4);
    }
  }
  EXPECT_GT(moved / static_cast<double>(intact.size()), 0.2);
}

/// Least and most along the picture and upwards, travel aside.
std::array<double, 4> room_of(const std::vector<Dot>& shown, const DotStage& stage) {
  std::array<double, 4> room = {1e9, -1e9, 1e9, -1e9};
  for (const Dot& dot : shown) {
    for (const Vec3& point : without_travel(dot.path, stage.step)) {
      const double across = point.dot(stage.across);
      room = {std::min(room[0], across), std::max(room[1], across), std::min(room[2], point.y()),
              std::max(room[3], point.y())};
    }
  }
  return room;
}

TEST_F(PointLight, ScrambledDotsTakeTheFiguresRoomWhateverTheSeed) {
  const std::array<double, 4> intact = room_of(dots(), stage);
  PointLightOptions options;
  options.scrambled = true;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    options.seed = seed;
    const std::array<double, 4> scrambled = room_of(dots(options), stage);
    for (std::size_t end = 0; end < 4; ++end) EXPECT_NEAR(scrambled[end], intact[end], 1e-9);
  }
}

TEST_F(PointLight, WithScrambledPhasesEachDotGoesThroughTheSamePlaces) {
  PointLightOptions options;
  options.phase_scrambled = true;
  const std::vector<Dot> intact = dots();
  const std::vector<Dot> scrambled = dots(options);
  int shifted = 0;
  for (std::size_t d = 0; d < intact.size(); ++d) {
    const DotPath places = without_travel(intact[d].path, stage.step);
    const DotPath taken = without_travel(scrambled[d].path, stage.step);
    double longest = 0.0;
    for (std::size_t f = 1; f < places.size(); ++f) {
      longest = std::max(longest, (places[f] - places[f - 1]).norm());
    }
    for (std::size_t f = 0; f < taken.size(); ++f) {
      // The path is closed first, so that there is no leap from its end to its beginning.
      EXPECT_TRUE(std::any_of(places.begin(), places.end(),
                              [&](const Vec3& one) { return (one - taken[f]).norm() < 0.06; }));
      const double step = f > 0 ? (taken[f] - taken[f - 1]).norm() : 0.0;
      EXPECT_LT(step, 1.3 * longest + 1e-3);
    }
    shifted += (places[0] - taken[0]).norm() > 1e-3 ? 1 : 0;
  }
  EXPECT_EQ(shifted, 4);  // knees and ankles; nothing else moves on the spot
}

TEST_F(PointLight, MirroredTwiceInvertedTwiceAndReversedTwiceAreTheSameDisplay) {
  const std::vector<Dot> intact = dots();
  PointLightOptions options;
  options.mirrored = options.inverted = options.reversed = true;
  options.rotated_degrees = 30.0;
  const std::vector<Dot> changed = dots(options);
  double lowest = 1e9, highest = -1e9;
  for (const Dot& dot : intact) {
    for (const Vec3& point : dot.path) {
      lowest = std::min(lowest, point.y());
      highest = std::max(highest, point.y());
    }
  }
  for (std::size_t d = 0; d < intact.size(); ++d) {
    DotPath back = inverted(changed[d].path, 0.5 * (lowest + highest));
    back = mirrored(back, stage.centre, stage.across);
    back = reversed(rotated(back, stage.centre, -30.0));
    for (std::size_t f = 0; f < back.size(); ++f) {
      EXPECT_LT((back[f] - intact[d].path[f]).norm(), 1e-9);
    }
  }
}

TEST_F(PointLight, TheSameSeedGivesTheSameDotsAndAnotherOneOthers) {
  PointLightOptions options;
  options.scrambled = true;
  options.noise = 7;
  options.mask = 9;
  const std::vector<Dot> once = dots(options);
  const std::vector<Dot> again = dots(options);
  options.seed = 6;
  const std::vector<Dot> others = dots(options);
  ASSERT_EQ(once.size(), 29u);
  for (std::size_t d = 0; d < once.size(); ++d) {
    EXPECT_EQ(once[d].path, again[d].path);
    EXPECT_NE(once[d].path, others[d].path);
  }
}

TEST_F(PointLight, MoreNoiseLeavesTheOtherDotsAsTheyWere) {
  PointLightOptions few, many;
  few.scrambled = many.scrambled = true;
  few.noise = 3;
  many.noise = 30;
  const std::vector<Dot> a = dots(few), b = dots(many);
  for (std::size_t d = 0; d < a.size(); ++d) EXPECT_EQ(a[d].path, b[d].path);
}

TEST_F(PointLight, NoiseGoesAsFastAsTheFiguresDotsAndStaysInItsRoom) {
  PointLightOptions options;
  options.noise = 40;
  const std::vector<Dot> shown = dots(options);
  double figure = 0.0, noise = 0.0;
  for (const Dot& dot : shown) {
    const double way = length_of(without_travel(dot.path, stage.step));
    (dot.kind == "noise" ? noise : figure) += way;
  }
  // Where a dot turns back within a frame it goes a little less.
  EXPECT_NEAR(noise / 40.0, figure / 13.0, 0.05 * figure / 13.0);
}

TEST_F(PointLight, NoiseGoesAsFastAsWhatIsSeenOfTheFigure) {
  stage.across = Vec3::UnitX();  // seen from the front, legs swing in depth
  PointLightOptions options;
  options.noise = 40;
  double figure = 0.0, noise = 0.0;
  for (const Dot& dot : dots(options)) {
    DotPath path = without_travel(dot.path, stage.step);
    for (Vec3& point : path) point.z() = 0.0;
    (dot.kind == "noise" ? noise : figure) += length_of(path);
  }
  EXPECT_NEAR(noise / 40.0, figure / 13.0, 0.05 * figure / 13.0);
}

TEST_F(PointLight, LimitedLifetimesNeedLimbs) {
  PointLightOptions options;
  options.joint_set.clear();
  options.joints = {"Head", "LeftWrist"};
  options.lifetime = 4;
  EXPECT_THROW(dots(options), Error);
  options.joints = {"LeftElbow", "LeftWrist"};
  EXPECT_EQ(dots(options).size(), 2u);
}

/// Cameras frame what the dots do, which may be elsewhere than the walk.
TEST_F(PointLight, IsInThePictureWhateverIsDoneToIt) {
  std::vector<PointLightOptions> all(5);
  all[1].reversed = true;
  all[2].mirrored = true;
  all[3].rotated_degrees = 90.0;
  all[4].rotated_degrees = -45.0;
  for (const char* view : {"front", "side", "three-quarter", "follow", "orbit"}) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      Look look;
      look.figure = all[i];
      look.camera.view = view;
      const Shot shot = scenes::stage(test::walking_clip(90, Vec3(0.6, 0.0, 0.8), 0.05), look);
      for (int frame = 0; frame < shot.frame_count(); frame += 7) {
        const render::Camera& camera = camera_at(shot, frame);
        for (const Dot& dot : shot.actors[0].dots) {
          const auto seen =
              render::project(camera, dot.path[static_cast<std::size_t>(frame)].cast<float>());
          ASSERT_TRUE(seen) << view << i;
          EXPECT_TRUE(seen->x() >= 0.0f && seen->x() <= static_cast<float>(camera.width) &&
                      seen->y() >= 0.0f && seen->y() <= static_cast<float>(camera.height))
              << view << ' ' << i << ' ' << frame << ' ' << dot.kind;
        }
      }
    }
  }
}

TEST_F(PointLight, OnATreadmillThatGoesTheOtherWayTheGroundDoesToo) {
  Look look;
  look.set.in_place = true;
  PointLightOptions options;
  look.figure = options;
  const motion::Clip walk = test::walking_clip(60, Vec3::UnitZ(), 0.04);
  const Vec3 forwards = scenes::stage(walk, look).step;
  options.reversed = true;
  look.figure = options;
  EXPECT_LT((scenes::stage(walk, look).step + forwards).norm(), 1e-9);
}

TEST_F(PointLight, DotsOfLimitedLifetimeStayOnTheLimbsForSoManyFrames) {
  PointLightOptions options;
  options.lifetime = 6;
  const std::vector<Dot> shown = dots(options);
  ASSERT_EQ(shown.size(), 13u);
  std::map<int, int> begun;  // frame → dots whose life began
  for (const Dot& dot : shown) {
    std::vector<int> births;
    for (std::size_t f = 1; f < dot.path.size(); ++f) {
      if ((dot.path[f] - dot.path[f - 1]).norm() > 0.12) births.push_back(static_cast<int>(f));
    }
    for (std::size_t b = 1; b < births.size(); ++b) {
      EXPECT_EQ((births[b] - births[b - 1]) % options.lifetime, 0);
    }
    for (const int birth : births) ++begun[birth % options.lifetime];
  }
  EXPECT_GE(begun.size(), 4u) << "the dots change all at once";
  options.scrambled = true;
  EXPECT_THROW(dots(options), Error);
}

}  // namespace
}  // namespace mien::scenes
