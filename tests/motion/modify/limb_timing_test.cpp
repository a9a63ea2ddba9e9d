#include "motion/modify/limb_timing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"

#include "path_measures.h"
#include "real_takes.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// An arm that is at `angle(seconds)` radians below the horizontal; 6 s at 100 frames a second.
template <typename Angle>
Clip moving_arm(Angle angle) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 100.0;
  for (int f = 0; f <= 600; ++f) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.rotations[LeftShoulder] = exp(Vec3(0.0, 0.0, -angle(f / 100.0)));
    clip.poses.push_back(pose);
  }
  return clip;
}

Clip sine() {
  return moving_arm([](double t) { return 0.6 + 0.5 * std::sin(2.0 * pi * t / 1.5); });
}

/// Reaches within 0.7 s, pauses for 0.3 s, goes back, and again.
Clip reach_and_pause() {
  return moving_arm([](double t) {
    const double in_round = std::fmod(t, 2.0);
    const double x = std::clamp(std::fmod(in_round, 1.0) / 0.7, 0.0, 1.0);
    const double reach = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
    return 0.2 + 0.9 * (in_round < 1.0 ? reach : 1.0 - reach) + 0.02 * std::sin(9.0 * t);
  });
}

TEST(LimbTiming, AtEvenDurationsIsTheInput) {
  for (const bool loops : {false, true}) {
    const std::vector<double> sources =
        source_frames(std::vector<double>(77, 3.0), 0.4, 100.0, loops);
    ASSERT_EQ(sources.size(), loops ? 77u : 78u);
    for (size_t f = 0; f < sources.size(); ++f) EXPECT_NEAR(sources[f], double(f), 1e-12);
  }
}

TEST(LimbTiming, NeverRunsBackwards) {
  const Clip clip = reach_and_pause();
  const std::vector<double> speeds = limb_speeds(clip, Limb::left_hand);
  for (const auto& durations :
       {constant_speed_durations(speeds), accelerated_durations(speeds, 100.0, false)}) {
    const std::vector<double> sources = source_frames(durations, 0.9, 100.0, false);
    EXPECT_NEAR(sources.front(), 0.0, 1e-12);
    EXPECT_NEAR(sources.back(), 600.0, 1e-9);
    for (size_t f = 1; f < sources.size(); ++f) EXPECT_GE(sources[f], sources[f - 1]);
  }
}

TEST(LimbTiming, KeepsTheLengthOfSegments) {
  std::vector<double> durations(300, 1.0);
  std::fill(durations.begin() + 20, durations.begin() + 40, 10.0);  // in the first segment only
  const std::vector<double> sources = source_frames(durations, 1.0, 100.0, false);
  EXPECT_NEAR(sources[100], 100.0, 4.0);  // corners are rounded off
  for (size_t f = 115; f < sources.size(); ++f) EXPECT_NEAR(sources[f], double(f), 1e-9);
  EXPECT_LT(sources[70], 40.0);  // while the pause lasted
}

TEST(LimbTiming, AtConstantSpeedVariesLess) {
  const Limbs limbs;
  EXPECT_LT(speed_variation(with_constant_speed(sine(), limbs), LeftWrist),
            0.75 * speed_variation(sine(), LeftWrist));
  EXPECT_LT(speed_variation(with_constant_speed(reach_and_pause(), limbs), LeftWrist),
            0.8 * speed_variation(reach_and_pause(), LeftWrist));
}

TEST(LimbTiming, AcceleratedVariesMore) {
  const Limbs limbs;
  EXPECT_GT(speed_variation(with_acceleration(sine(), limbs), LeftWrist),
            1.5 * speed_variation(sine(), LeftWrist));
  EXPECT_GT(speed_variation(with_acceleration(reach_and_pause(), limbs), LeftWrist),
            1.4 * speed_variation(reach_and_pause(), LeftWrist));
}

TEST(LimbTiming, LeavesWhatStandsStill) {
  const Clip still = moving_arm([](double) { return 0.5; });
  EXPECT_LT(largest_distance(with_acceleration(still, {}), still), 1e-12);
  EXPECT_LT(largest_distance(with_constant_speed(still, {}), still), 1e-12);
}

TEST(LimbTiming, NearMomentsActsNowhereWithoutAny) {
  EXPECT_EQ(largest_distance(with_acceleration_near(sine(), {}, {}), sine()), 0.0);
  const std::vector<int> moments = {300};
  const Clip near = with_acceleration_near(sine(), {}, moments);
  EXPECT_GT(largest_distance(near, sine()), 0.0);
  EXPECT_LT(largest_distance(near, sine()),
            largest_distance(with_acceleration(sine(), {}), sine()));
}

TEST(LimbTiming, LeavesFeetUnlessAsked) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const Clip after = with_acceleration(clip, {});
  Limbs all;
  all.left_foot = true;
  const Clip with_foot = with_acceleration(clip, all);
  double moved = 0.0;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (const int joint : {LeftHip, LeftKnee, RightHip, RightAnkle}) {
      EXPECT_EQ(after.poses[f].rotations[size_t(joint)].coeffs(),
                clip.poses[f].rotations[size_t(joint)].coeffs());
    }
    moved = std::max(moved, angle_between(with_foot.poses[f].rotations[LeftKnee],
                                          clip.poses[f].rotations[LeftKnee]));
  }
  EXPECT_GT(moved, 0.1);
}

TEST(LimbTiming, NearMomentsLeavesTheRest) {
  const std::vector<double> durations(200, 10.0);
  const std::vector<int> moments = {50};
  const std::vector<double> near = near_only(durations, moments, 100.0, false);
  EXPECT_DOUBLE_EQ(near[50], 10.0);
  EXPECT_DOUBLE_EQ(near[45], 10.0);
  EXPECT_GT(near[65], 1.5);
  EXPECT_DOUBLE_EQ(near[75], 1.0);
  EXPECT_DOUBLE_EQ(near[199], 1.0);
  const std::vector<int> seam = {0};
  EXPECT_DOUBLE_EQ(near_only(durations, seam, 100.0, true)[199], 10.0);
}

TEST(LimbTiming, AcceleratesNearContactsAlone) {
  const Clip clip = repeated(walk({}, 100.0, standard_body()).clip, 4);
  const std::vector<int> moments = {110};
  const Clip everywhere = with_acceleration(clip, {});
  const Clip near = with_acceleration_near(clip, {}, moments);
  const auto moved = [&](const Clip& after, size_t first, size_t last) {
    double largest = 0.0;
    for (size_t f = first; f < last; ++f) {
      largest = std::max(largest, angle_between(after.poses[f].rotations[LeftShoulder],
                                                clip.poses[f].rotations[LeftShoulder]));
    }
    return largest;
  };
  EXPECT_GT(moved(near, 90, 180), 0.02);  // within the segment of the contact
  EXPECT_LT(moved(near, 220, 420), 1e-9);
  EXPECT_GT(moved(everywhere, 220, 420), 0.02);
}

TEST(LimbTiming, OfRealHandsDoesWhatItSays) {
  std::vector<Clip> takes = real_walks();
  if (takes.empty()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  const std::vector<Clip> waves = real_waves();
  takes.insert(takes.end(), waves.begin(), waves.end());
  ASSERT_EQ(takes.size(), 45u);
  int hands = 0;
  int steadier = 0;
  for (const Clip& take : takes) {
    const Clip constant = with_constant_speed(take, {});
    const Clip accelerated = with_acceleration(take, {});
    for (const BodyJoint hand : {LeftWrist, RightWrist}) {
      if (path_length(take, hand) < 0.25 * take.duration_seconds()) continue;  // hangs
      const double before = speed_variation(take, hand);
      EXPECT_GT(speed_variation(accelerated, hand), before) << take.name << " " << name_of(hand);
      steadier += speed_variation(constant, hand) < before;
      ++hands;
    }
  }
  EXPECT_GT(hands, 60);
  // The trunk, which keeps its time, carries two hands more than their own arms do.
  EXPECT_GE(steadier, hands - 2);
}

}  // namespace
}  // namespace mien::motion
