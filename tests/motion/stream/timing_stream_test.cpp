#include "motion/stream/timing_stream.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/modify/path_measures.h"
#include "motion/stream/streamed_modification.h"
#include "motion/stream/streamed_motions.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Modification accelerated(double acceleration) {
  Modification modification;
  modification.acceleration = acceleration;
  return modification;
}

TEST(TimingStream, MakesSpeedsOfHandsMoreOrLessUneven) {
  for (const Clip& walk : performed("walks-10", 30.0, 5)) {
    const double before = speed_variation(walk, LeftWrist);
    for (const int look_ahead : {0, 6}) {
      const StreamDelay delay = {0, look_ahead, 0};
      EXPECT_GT(speed_variation(streamed(walk, accelerated(1.0), delay), LeftWrist), 1.05 * before)
          << walk.name;
      EXPECT_LT(speed_variation(streamed(walk, accelerated(-1.0), delay), LeftWrist), 0.95 * before)
          << walk.name;
    }
  }
}

TEST(TimingStream, ChangesNothingBelowOrBesideTheLimbs) {
  const Clip walk = performed("walks-10").front();
  const Clip timed = streamed(walk, accelerated(1.0), {});
  for (size_t f = 0; f < walk.poses.size(); ++f) {
    EXPECT_EQ(timed.poses[f].root_position, walk.poses[f].root_position);
    for (const BodyJoint joint : {Pelvis, Chest, LeftHip, RightKnee, RightAnkle}) {
      EXPECT_EQ(timed.poses[f].rotations[joint].coeffs(), walk.poses[f].rotations[joint].coeffs());
    }
  }
}

TEST(TimingStream, ShowsNothingThatHasNotComeAndNothingTooOld) {
  // An arm whose angle is the number of the frame tells which frame is shown.
  constexpr double degrees_a_frame = 0.5;
  Clip clip = performed("walks-10", 30.0, 4).front();
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    // Stops now and then, so that there is something to stretch.
    const double swing = 6.0 * std::sin(0.3 * static_cast<double>(f));
    clip.poses[f].rotations[LeftShoulder] =
        exp(Vec3(0, (swing + degrees_a_frame * static_cast<double>(f)) * radians_per_degree, 0));
    clip.poses[f].rotations[LeftElbow] =
        exp(Vec3(0, degrees_a_frame * static_cast<double>(f) * radians_per_degree, 0));
  }
  for (const double acceleration : {1.0, -1.0}) {
    for (const int look_ahead : {0, 5}) {
      const Clip timed = streamed(clip, accelerated(acceleration), {0, look_ahead, 0});
      double before = -1.0;
      for (size_t f = 0; f < timed.poses.size(); ++f) {
        const double shown =
            log(timed.poses[f].rotations[LeftElbow]).y() / (degrees_a_frame * radians_per_degree);
        const auto now = static_cast<double>(f);
        EXPECT_LE(shown, now + look_ahead + 1e-6);
        EXPECT_GE(shown, now - TimingStream::longest_lag_seconds * 30.0 - 1e-6);
        EXPECT_GE(shown, before - 1e-6) << "time runs backwards at " << f;
        before = shown;
      }
    }
  }
}

TEST(TimingStream, DoesNotPop) {
  for (const Clip& clip : performed("walks-10", 60.0, 4)) {
    for (const double acceleration : {0.5, 1.0}) {
      const Clip timed = streamed(clip, accelerated(acceleration), {});
      EXPECT_LT(largest_second_difference(timed), 1.6 * largest_second_difference(clip))
          << clip.name;
    }
  }
}

}  // namespace
}  // namespace mien::motion
