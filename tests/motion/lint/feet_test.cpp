#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/skeleton/straighten.h"

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// Stands, leaps with straight legs, and stands again; `gravity` is that of the leap.
Clip leap_up(double seconds, double gravity_m_s2) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int t = 0; t < 150; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const double flown = std::clamp(t / 60.0 - 1.0, 0.0, seconds);
    pose.root_position = Vec3(0, 0.96 + 0.5 * gravity_m_s2 * flown * (seconds - flown), 0);
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(Floating, IsNoLeap) {
  EXPECT_FALSE(find(lint(leap_up(0.4, 9.81)), "floating")) << all_of(lint(leap_up(0.4, 9.81)));
}

TEST(Floating, IsALeapInSlowMotion) {
  const auto findings = lint(leap_up(0.8, 2.0));
  EXPECT_TRUE(find_error(findings, "floating", "", 65, 105)) << all_of(findings);
}

TEST(Floating, ThatTheOriginalDidCountsNoMore) {
  Clip clip = three_cycles(builtin_walks()[0]);
  for (Pose& pose : clip.poses) pose.root_position.y() += 0.045;
  EXPECT_TRUE(find_error(lint(clip), "floating"));
  EXPECT_FALSE(find(lint(clip, {}, &clip), "floating"));
  Clip higher = clip;
  for (Pose& pose : higher.poses) pose.root_position.y() += 0.02;
  EXPECT_TRUE(find_error(lint(higher, {}, &clip), "floating"));
}

TEST(FootSkate, OfAWalkOnTheSpotIsThatOfATreadmill) {
  for (const Clip& loop : builtin_walks()) {
    const Clip still = in_place(loop);
    EXPECT_FALSE(has_errors(lint(still))) << loop.name << "\n" << all_of(lint(still));
    EXPECT_FALSE(find(lint(still), "foot-skate")) << loop.name << "\n" << all_of(lint(still));
    EXPECT_FALSE(find(lint(three_cycles(still)), "foot-skate")) << loop.name;
  }
}

TEST(FootSkate, OfFeetThatNeverStandIsFound) {
  // The legs walk at the usual pace, the body goes twice as far.
  for (const Clip& loop : builtin_walks()) {
    Clip clip = travelling(loop, loop.cycle_displacement);
    clip.cycle_displacement = 2.0 * loop.cycle_displacement;
    clip = three_cycles(clip);
    EXPECT_TRUE(find_error(lint(clip), "foot-skate")) << loop.name << "\n" << all_of(lint(clip));
  }
}

TEST(ContactTiming, OfAFootThatNeverComesDownIsFound) {
  const Clip before = three_cycles(builtin_walks()[0]);
  const std::vector<FootPlant> plants = foot_plants(before);
  const FootPlant plant = plants[plants.size() / 2];
  Clip clip = before;
  const BodyJoint knee = plant.left ? LeftKnee : RightKnee;
  for (int t = plant.first - 8; t <= plant.last + 8; ++t) {
    clip.poses[t].rotations[knee] *=
        exp(Vec3(0.9 * bump(t, plant.first - 8, plant.last + 8), 0, 0));
  }
  const auto findings = lint(clip, {}, &before);
  const std::string foot = plant.left ? "LeftAnkle" : "RightAnkle";
  const Finding* found = find_error(findings, "contact-timing", foot, plant.first, plant.last);
  ASSERT_TRUE(found) << all_of(findings);
}

TEST(ContactTiming, AndPhasesOfTheSameMotionAtAnotherPaceAreKept) {
  for (const Clip& before : builtin_walks()) {
    for (const double pace : {0.6, 0.8, 1.25}) {
      Clip other = before;
      other.frames_per_second = pace * before.frames_per_second;
      const auto findings = lint(resampled(other, 30.0), {}, &before);
      EXPECT_FALSE(find_error(findings, "contact-timing")) << before.name << all_of(findings);
      EXPECT_FALSE(find(findings, "limb-phase")) << before.name << all_of(findings);
    }
  }
}

}  // namespace
}  // namespace mien::motion
