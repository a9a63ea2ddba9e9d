#include "pipeline/synthesis/walked_path.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/lint/lint.h"
#include "motion/skeleton/body.h"

namespace mien::pipeline {
namespace {

double heading_of(const motion::Pose& pose) {
  const motion::Vec3 forward = pose.rotations[0] * motion::Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z()) / motion::radians_per_degree;
}

double way_over_floor(const motion::Clip& clip) {
  motion::Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  way.y() = 0.0;
  return way.norm();
}

TEST(WalkedPath, WalksTurnsAndStands) {
  WalkPath path;
  path.script = {{.walk_s = 3.0}, {.turn_deg = 90.0}, {.walk_s = 1.0}, {.stand_s = 1.0}};
  const motion::Clip clip = walked(path, 30.0);
  EXPECT_FALSE(clip.loops);
  EXPECT_NEAR(heading_of(clip.poses.back()), 90.0, 12.0);
  EXPECT_GT(way_over_floor(clip), 3.0);
  EXPECT_LT(motion::planted_drift(clip, motion::foot_plants(clip)), 0.02);
}

TEST(WalkedPath, ATurnAfterStandingIsOnTheSpot) {
  WalkPath path;
  path.script = {{.stand_s = 0.5}, {.turn_deg = -90.0}, {.stand_s = 0.5}};
  const motion::Clip clip = walked(path, 30.0);
  EXPECT_NEAR(heading_of(clip.poses.back()), -90.0, 12.0);
  EXPECT_LT(way_over_floor(clip), 0.3);
}

TEST(WalkedPath, EndsAtTheLastPoint) {
  WalkPath path;
  path.points = {{1.0, 0.0}, {1.0, 2.0}, {0.0, 3.5}, {0.0, 5.0}};
  path.mood = {{"sad", 1.0}};
  const motion::Clip clip = walked(path, 30.0);
  EXPECT_LT(
      std::hypot(clip.poses.front().root_position.x() - 1.0, clip.poses.front().root_position.z()),
      0.15);
  EXPECT_LT(
      std::hypot(clip.poses.back().root_position.x(), clip.poses.back().root_position.z() - 5.0),
      0.3);
  EXPECT_FALSE(motion::has_errors(motion::lint(clip)));
}

/// A step of half the pace gets half as far; a mood has its own speed.
TEST(WalkedPath, PaceAndMoodSetTheSpeed) {
  WalkPath path;
  path.script = {{.walk_s = 6.0}};
  const double own = way_over_floor(walked(path, 30.0));
  path.pace = 0.5;
  const double half = way_over_floor(walked(path, 30.0));
  EXPECT_NEAR(half / own, 0.5, 0.06);
  path.pace = 1.0;
  path.script.front().mood = {{"tired", 2.0}};
  EXPECT_LT(way_over_floor(walked(path, 30.0)), 0.85 * own);
}

/// A mood of a step counts from that step on, and until then nothing is changed by it.
TEST(WalkedPath, AMoodBeginsAtItsStep) {
  WalkPath plain, later;
  plain.script = {{.walk_s = 2.0}, {.walk_s = 2.0}};
  later.script = plain.script;
  later.script[1].mood = {{"sad", 1.0}};
  const motion::Clip a = walked(plain, 30.0);
  const motion::Clip b = walked(later, 30.0);
  ASSERT_EQ(a.frame_count(), b.frame_count());
  const auto apart = [&](std::size_t frame) {
    double most = 0.0;
    for (std::size_t j = 0; j < a.poses[frame].rotations.size(); ++j)
      most =
          std::max(most, a.poses[frame].rotations[j].angularDistance(b.poses[frame].rotations[j]));
    return most;
  };
  EXPECT_LT(apart(60), 1e-9);
  EXPECT_GT(apart(75), 0.05);
}

TEST(WalkedPath, OnlyWalksThatAreNamedAreFitted) {
  WalkPath path;
  path.script = {{.walk_s = 1.0}};
  EXPECT_EQ(moods_of(path), std::vector<std::string>{"normal"});
  path.script.front().mood = {{"sad", 1.0}, {"happy", 0.0}};
  EXPECT_EQ(moods_of(path), (std::vector<std::string>{"happy", "sad"}));
  path.set = "builtin:walks-27";
  EXPECT_EQ(walks_of(path).size(), 27U);
}

TEST(WalkedPath, IsDescribedInFewWords) {
  WalkPath path;
  path.script = {{.walk_s = 3.0}, {.turn_deg = 90.0}, {.stand_s = 1.0, .mood = {{"sad", 1.0}}}};
  EXPECT_EQ(described(path), "walk 3 s, turn 90°, stand 1 s like sad");
}

}  // namespace
}  // namespace mien::pipeline
