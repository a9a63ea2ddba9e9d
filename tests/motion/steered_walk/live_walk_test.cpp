#include "motion/steered_walk/live_walk.h"

#include <limits>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/procedural/builtin_sets.h"

namespace mien::motion {
namespace {

LiveWalk ten_moods() { return make_live_walk(builtin_styles("walks-10"), standard_body()); }

TEST(LiveWalk, KnowsItsMoodsAndStandsAtTheOrigin) {
  LiveWalk walk = ten_moods();
  EXPECT_EQ(walk.moods.size(), 10U);
  EXPECT_EQ(walk.moods.front(), "normal");
  const Pose pose = advance(walk, 0.0, {});
  EXPECT_LT(horizontal(pose.root_position).norm(), 0.05);
}

TEST(LiveWalk, WalksWhereItIsWanted) {
  LiveWalk walk = ten_moods();
  WalkRequest request;
  request.pace = 1.0;
  request.heading_deg = 450.0;
  Pose pose;
  for (int i = 0; i < 360; ++i) pose = advance(walk, 1.0 / 60.0, request);
  EXPECT_GT(pose.root_position.x(), 3.0);
}

TEST(LiveWalk, AFrameAfterAPauseIsNoLeap) {
  LiveWalk walk = ten_moods();
  WalkRequest request;
  request.pace = 1.0;
  for (int i = 0; i < 180; ++i) advance(walk, 1.0 / 60.0, request);
  const Pose before = advance(walk, 1.0 / 60.0, request);
  const Pose after = advance(walk, 30.0, request);
  EXPECT_LT((after.root_position - before.root_position).norm(), 0.5);
}

TEST(LiveWalk, RefusesNumbersThatAreNoneAndStaysAsItWas) {
  LiveWalk walk = ten_moods();
  const double none = std::numeric_limits<double>::quiet_NaN();
  WalkRequest request;
  request.pace = none;
  EXPECT_THROW(advance(walk, 0.1, request), Error);
  request = {};
  request.moods = {1.0, -1.0};
  EXPECT_THROW(advance(walk, 0.1, request), Error);
  request.moods.assign(11, 1.0);
  EXPECT_THROW(advance(walk, 0.1, request), Error);
  EXPECT_THROW(advance(walk, none, {}), Error);
  EXPECT_THROW(advance(walk, -1.0, {}), Error);
  EXPECT_EQ(walk.walker.seconds, 0.0);
}

}  // namespace
}  // namespace mien::motion
