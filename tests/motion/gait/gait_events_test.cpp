#include "motion/gait/gait_events.h"

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;
using Kind = GaitEvent::Kind;

/// Frames of the walker's own event nearest to `event`, at one stride of 100 frames.
double known_frame(const GaitEvent& event) {
  const double strike = event.left ? 0.0 : 50.0;
  const double phase = event.kind == Kind::heel_strike ? strike : strike + 60.0;
  return phase + 100.0 * std::round((event.frame - phase) / 100.0);
}

TEST(GaitEvents, OfTheSyntheticWalkerAreItsOwn) {
  const std::vector<GaitEvent> events = gait_events(synthetic_clip(steady_walk(1.2, 6.0)));
  int strikes = 0;
  for (const GaitEvent& event : events) {
    if (event.frame < 20 || event.frame > 580) continue;
    EXPECT_NEAR(event.frame, known_frame(event), 2.0) << (event.left ? "left" : "right");
    EXPECT_TRUE(event.confirmed);
    strikes += event.kind == Kind::heel_strike ? 1 : 0;
  }
  EXPECT_EQ(strikes, 11);
}

TEST(GaitEvents, AreTheSameInPlace) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  const Clip loop = straightened(closed_loop(clip, 120, 220));
  const std::vector<GaitEvent> moving = gait_events(loop);
  const std::vector<GaitEvent> still = gait_events(in_place(loop));
  ASSERT_EQ(moving.size(), 4u);
  ASSERT_EQ(still.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(moving[i].left, still[i].left);
    EXPECT_EQ(moving[i].kind, still[i].kind);
    EXPECT_NEAR(moving[i].frame, still[i].frame, 1.0);
    EXPECT_TRUE(still[i].confirmed);
  }
}

TEST(GaitEvents, ExchangeLeftAndRightInTheMirror) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 3.7));
  const std::vector<GaitEvent> events = gait_events(clip);
  const std::vector<GaitEvent> seen = gait_events(mirrored(clip));
  ASSERT_EQ(events.size(), seen.size());
  for (size_t i = 0; i < events.size(); ++i) {
    EXPECT_NE(events[i].left, seen[i].left);
    EXPECT_EQ(events[i].kind, seen[i].kind);
    EXPECT_NEAR(events[i].frame, seen[i].frame, 1e-9);
  }
}

TEST(GaitEvents, DoNotDependOnWhereOneHeads) {
  SyntheticWalk walk = steady_walk(1.2, 3.0);
  const std::vector<GaitEvent> north = gait_events(synthetic_clip(walk));
  walk.heading = 2.1;
  const std::vector<GaitEvent> elsewhere = gait_events(synthetic_clip(walk));
  ASSERT_EQ(north.size(), elsewhere.size());
  for (size_t i = 0; i < north.size(); ++i) {
    EXPECT_NEAR(north[i].frame, elsewhere[i].frame, 1e-6);
  }
}

TEST(GaitEvents, OfStandingAreNone) {
  SyntheticWalk still;
  still.distance.assign(300, 0.3);
  EXPECT_TRUE(gait_events(synthetic_clip(still)).empty());
}

TEST(WalkingDirections, FollowATurn) {
  const SyntheticWalk walk = long_take();
  const std::vector<Vec3> directions = walking_directions(synthetic_clip(walk));
  for (size_t t = 0; t < directions.size(); ++t) {
    const double yaw = heading_at(walk, walk.distance[t]);
    const Vec3 known(std::sin(yaw), 0, std::cos(yaw));
    EXPECT_GT(directions[t].dot(known), std::cos(12 * radians_per_degree)) << t;
  }
}

TEST(FootProgress, OfAPlantedFootGoesBackAtWalkingSpeed) {
  const FootProgress progress = foot_progress(synthetic_clip(steady_walk(1.2, 3.0)));
  // Left stance from frame 100 to 160.
  EXPECT_NEAR(progress.left_heel[115] - progress.left_heel[145], 0.36, 0.005);
  EXPECT_NEAR(progress.left_toe[115] - progress.left_heel[115], 0.13, 0.005);
}

}  // namespace
}  // namespace mien::motion
