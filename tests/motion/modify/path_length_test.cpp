#include "motion/modify/path_length.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/straighten.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip ordinary_at(double frames_per_second) {
  return walk(WalkStyle{}, frames_per_second, standard_body()).clip;
}

/// An arm that swings about `mean_deg` by `swing_deg`, `hz` times a second; 8 s at 100 frames a
/// second.
Clip swinging_arm(double mean_deg, double swing_deg, double hz) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 100.0;
  clip.loops = true;
  for (int f = 0; f < 800; ++f) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const double angle = mean_deg + swing_deg * std::sin(2.0 * pi * hz * f / 100.0);
    pose.rotations[LeftShoulder] = exp(Vec3(0.0, 0.0, -angle * radians_per_degree));
    clip.poses.push_back(pose);
  }
  return clip;
}

double swing_of(const Clip& clip) {
  double least = 1e9;
  double most = -1e9;
  for (const Pose& pose : clip.poses) {
    const double angle = -log(pose.rotations[LeftShoulder]).z() / radians_per_degree;
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  return 0.5 * (most - least);
}

TEST(PathLength, AtUnitGainsIsTheInput) {
  for (const double rate : {24.0, 30.0, 60.0, 100.0, 120.0}) {
    for (const auto signal : {RotationSignal::direction_vectors, RotationSignal::quaternions}) {
      const Clip clip = ordinary_at(rate);
      EXPECT_LT(largest_distance(with_path_gains(clip, {}, signal), clip), 1e-12);
    }
  }
}

TEST(PathLength, GroupsTheBandsOfAHundredFramesASecondAsTheThesis) {
  const std::vector<double> gains = band_gains({1.0, 2.0, 0.5, {}}, 100.0);
  ASSERT_EQ(gains.size(), 5u);  // the sixth peaks at 0.83 Hz
  EXPECT_DOUBLE_EQ(gains[0], 0.5);
  EXPECT_LT(gains[1], 0.8);  // 14 Hz: over the border by less than the transition
  EXPECT_DOUBLE_EQ(gains[2], 2.0);
  EXPECT_DOUBLE_EQ(gains[3], 2.0);
  EXPECT_DOUBLE_EQ(gains[4], 2.0);
}

TEST(PathLength, TakesFewFramesASecondFourfold) {
  EXPECT_EQ(oversampling(30.0), 4);
  EXPECT_EQ(oversampling(24.0), 4);
  EXPECT_EQ(oversampling(60.0), 1);
  EXPECT_EQ(oversampling(100.0), 1);
}

// Bands are octaves of the frame rate, and a walk repeats just where two groups meet.
TEST(PathLength, IsMuchTheSameAtEveryFrameRate) {
  const auto ratio = [](double rate) {
    const Clip clip = ordinary_at(rate);
    const Clip longer =
        with_path_gains(clip, longest_path_gains(), RotationSignal::direction_vectors);
    return path_length(longer, LeftWrist) / path_length(clip, LeftWrist);
  };
  const double at_100 = ratio(100.0);
  for (const double rate : {24.0, 30.0, 60.0, 120.0}) EXPECT_NEAR(ratio(rate), at_100, 0.1) << rate;
}

TEST(PathLength, OfQuaternionsScalesAnglesByTheBandsGain) {
  // 3.3 Hz is the peak of the fourth band; its neighbours have the same gain.
  const Clip clip = swinging_arm(60.0, 10.0, 3.25);
  const Clip longer = with_path_gains(clip, {1.0, 1.8, 1.8, {}}, RotationSignal::quaternions);
  EXPECT_NEAR(swing_of(longer), 18.0, 1.0);
  const Clip shorter = with_path_gains(clip, {1.0, 0.3, 0.3, {}}, RotationSignal::quaternions);
  EXPECT_NEAR(swing_of(shorter), 3.0, 1.0);
}

/// A hand whose index finger bends as the arm of `swinging_arm` swings.
Clip bending_finger(double mean_deg, double swing_deg, double hz) {
  Clip clip = swinging_arm(mean_deg, swing_deg, hz);
  const int index = finger_joint(true, Finger::index, 1);
  for (Pose& pose : clip.poses) {
    pose.fingers.assign(finger_joint_count, Quat::Identity());
    const double angle = -log(pose.rotations[LeftShoulder]).z();
    pose.fingers[size_t(index)] = exp(angle * flexion_axis(index));
  }
  return clip;
}

TEST(PathLength, OfFingersStaysUnlessTheyAreScaledAsTheBodyIs) {
  const int index = finger_joint(true, Finger::index, 1);
  const Clip clip = bending_finger(0.0, 40.0, 3.25);
  const PathGains gains{1.0, 1.8, 1.8, {}};
  for (const auto signal : {RotationSignal::direction_vectors, RotationSignal::quaternions}) {
    const Clip kept = with_path_gains(clip, gains, signal, FingerPaths::kept);
    const Clip scaled = with_path_gains(clip, gains, signal, FingerPaths::scaled);
    for (size_t f = 0; f < clip.poses.size(); ++f) {
      const std::vector<Quat>& fingers = scaled.poses[f].fingers;
      for (size_t j = 0; j < fingers.size(); ++j) {
        EXPECT_EQ(kept.poses[f].fingers[j].coeffs(), clip.poses[f].fingers[j].coeffs());
        if (j == size_t(index)) continue;
        EXPECT_LT(angle_between(fingers[j], Quat::Identity()), 1e-9);
      }
      // The finger bends by the angle of the arm, about another axis.
      EXPECT_NEAR(angle_between(fingers[size_t(index)], Quat::Identity()),
                  angle_between(scaled.poses[f].rotations[LeftShoulder], Quat::Identity()), 0.02);
    }
    EXPECT_NEAR(swing_of(scaled), swing_of(kept), 1e-12);
  }
}

TEST(PathLength, OfDirectionVectorsScalesTheTangentAndDoesNotWindRound) {
  const double swing = 40.0 * radians_per_degree;
  const auto gained = [](double gain) {
    const Clip clip = swinging_arm(0.0, 40.0, 3.25);
    return swing_of(
        with_path_gains(clip, {1.0, gain, gain, {}}, RotationSignal::direction_vectors));
  };
  // The cosine keeps its mean, a Bessel function of the swing.
  const double mean = std::cyl_bessel_j(0.0, swing);
  for (const double gain : {1.4, 1.8, 5.0}) {
    const double expected =
        std::atan2(gain * std::sin(swing), mean + gain * (std::cos(swing) - mean));
    EXPECT_NEAR(gained(gain), expected / radians_per_degree, 0.5) << gain;
  }
  EXPECT_LT(gained(5.0), 90.0);
}

TEST(PathLength, OfDirectionVectorsMindsRatiosOfGainsOnly) {
  const Clip clip = ordinary_at(100.0);
  const auto signal = RotationSignal::direction_vectors;
  const Clip doubled = with_path_gains(clip, {1.0, 2.0, 2.0, {}}, signal);
  const Clip halved = with_path_gains(clip, {0.5, 1.0, 1.0, {}}, signal);
  EXPECT_LT(largest_distance(doubled, halved), 1e-9);
}

TEST(PathLength, OfSingleBandsIsThatOfTheirGroup) {
  const Clip clip = ordinary_at(100.0);
  const PathGains groups = longest_path_gains();
  PathGains single = groups;
  single.bands = band_gains(groups, 100.0);
  EXPECT_LT(largest_distance(with_path_gains(clip, single, RotationSignal::direction_vectors),
                             with_path_gains(clip, groups, RotationSignal::direction_vectors)),
            1e-12);
}

TEST(PathLength, OfALoopDoesNotMindWhereItBegins) {
  Clip clip = in_place(ordinary_at(30.0));
  Clip turned = shifted_loop(clip, 7);
  clip = with_path_gains(clip, longest_path_gains(), RotationSignal::direction_vectors);
  turned = with_path_gains(turned, longest_path_gains(), RotationSignal::direction_vectors);
  EXPECT_LT(largest_distance(turned, shifted_loop(clip, 7)), 1e-9);
}

TEST(PathLength, FiltersAHundredThousandFrames) {
  Clip clip = swinging_arm(40.0, 20.0, 1.0);
  clip.loops = false;
  const std::vector<Pose> once = clip.poses;
  while (clip.poses.size() < 100000) {
    clip.poses.insert(clip.poses.end(), once.begin(), once.end());
  }
  const Clip longer =
      with_path_gains(clip, longest_path_gains(), RotationSignal::direction_vectors);
  EXPECT_GT(swing_of(longer), 22.0);
}

}  // namespace
}  // namespace mien::motion
