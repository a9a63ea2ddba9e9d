#include "motion/modify/gesture_change.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gestures/acting_hand.h"
#include "motion/math/rotation.h"
#include "motion/modify/modification.h"
#include "motion/modify/posture.h"
#include "motion/procedural/knock.h"
#include "motion/procedural/walker.h"

namespace mien::motion {
namespace {

Clip neutral_knock() { return knock({}, 60.0, standard_body()).clip; }

Gesture gesture_of(const Clip& clip) { return *acting_hand(clip); }

double highest(const Gesture& gesture) {
  double most = 0.0;
  for (const Vec3& place : gesture.away) most = std::max(most, place.y());
  return most;
}

TEST(GestureChange, MultipliesTheHeightOfTheHand) {
  const Clip clip = neutral_knock();
  for (const double factor : {0.6, 1.2}) {
    const Clip changed = with_gesture(clip, {.height = factor}).clip;
    EXPECT_NEAR(highest(gesture_of(changed)) / highest(gesture_of(clip)), factor, 0.03) << factor;
    EXPECT_EQ(changed.frame_count(), clip.frame_count());
    for (size_t f = 0; f < clip.poses.size(); f += 9) {  // the other arm rests
      EXPECT_EQ(changed.poses[f].rotations[LeftShoulder].coeffs(),
                clip.poses[f].rotations[LeftShoulder].coeffs());
    }
  }
}

TEST(GestureChange, ReachesNoFartherThanTheArm) {
  const Clip clip = neutral_knock();
  const Clip high = with_gesture(clip, {.height = 2.0, .width = 1.5}).clip;
  for (const Pose& pose : high.poses) {
    const auto places = world_positions(high.body, pose);
    const double length =
        high.body.joints[RightElbow].offset.norm() + high.body.joints[RightWrist].offset.norm();
    EXPECT_LE((places[RightWrist] - places[RightShoulder]).norm(), length + 1e-9);
  }
  // The hand makes no leaps.
  for (size_t f = 1; f < high.poses.size(); ++f) {
    EXPECT_LT(angle_between(high.poses[f - 1].rotations[RightShoulder],
                            high.poses[f].rotations[RightShoulder]),
              25.0 / 60.0);  // the speed at which lint finds an arm too fast
  }
}

/// The right arm is raised overhead and lowered again; its elbow is bent by 50 degrees at first,
/// and by `least` degrees when it is highest.
Clip overhead(double least) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int f = 0; f < 180; ++f) {
    const double s = std::sin(pi * f / 179.0);
    Pose pose = standing_pose(clip.body);
    pose.rotations[RightShoulder] =
        exp(Vec3(0.0, 0.0, (82.0 - 150.0 * s * s) * radians_per_degree));
    pose.rotations[RightElbow] =
        exp(Vec3(0.0, (50.0 - (50.0 - least) * s) * radians_per_degree, 0.0));
    clip.poses.push_back(pose);
  }
  return clip;
}

/// The largest change of the elbow's velocity from one frame to the next, metres.
double elbow_leap(const Clip& clip) {
  std::vector<Vec3> places;
  for (const Pose& pose : clip.poses)
    places.push_back(world_positions(clip.body, pose)[RightElbow]);
  double most = 0.0;
  for (size_t f = 1; f + 1 < places.size(); ++f)
    most = std::max(most, (places[f + 1] - 2.0 * places[f] + places[f - 1]).norm());
  return most;
}

TEST(GestureChange, StretchesAndBendsElbowsSmoothly) {
  for (const double least : {0.5, 10.0, 25.0}) {
    const Clip clip = overhead(least);
    for (const double height : {0.85, 1.2, 1.5}) {
      const Clip changed = with_gesture(clip, {.height = height}).clip;
      EXPECT_LT(elbow_leap(changed), 3.0 * elbow_leap(clip) + 0.006) << least << " " << height;
    }
  }
}

TEST(GestureChange, AddsAndLeavesOutStrokes) {
  const Clip clip = neutral_knock();
  const size_t own = gesture_of(clip).strokes.size();
  for (const int more : {-2, -1, 1, 3}) {
    const ChangedGesture changed = with_gesture(clip, {.repetitions = more});
    EXPECT_EQ(gesture_of(changed.clip).strokes.size(), own + static_cast<size_t>(more)) << more;
    EXPECT_NEAR(changed.clip.frame_count() - clip.frame_count(), more * 0.32 * 60.0, 4.0) << more;
    EXPECT_EQ(changed.frames.back(), changed.clip.frame_count() - 1) << more;
    EXPECT_TRUE(changed.remarks.empty());
  }
  EXPECT_EQ(gesture_of(with_gesture(clip, {.repetitions = -10}).clip).strokes.size(), 1u);
}

TEST(GestureChange, IsFasterWhileTheHandIsRaisedOnly) {
  const Clip clip = neutral_knock();
  const ChangedGesture fast = with_gesture(clip, {.speed = 2.0});
  const Gesture before = gesture_of(clip), after = gesture_of(fast.clip);
  const auto period = [](const Gesture& g) {
    return (g.strokes.back() - g.strokes.front()) / static_cast<double>(g.strokes.size() - 1);
  };
  EXPECT_NEAR(period(before) / period(after), 2.0, 0.15);
  EXPECT_NEAR(after.first, before.first, 5);
  EXPECT_NEAR(fast.frames.back(), fast.clip.frame_count() - 1, 1e-9);
  for (size_t f = 1; f < fast.frames.size(); ++f) EXPECT_GT(fast.frames[f], fast.frames[f - 1]);
  // Each frame of the original is where `frames` says.
  const auto at = static_cast<size_t>(before.strokes.front());
  const Pose pose = pose_at(fast.clip, fast.frames[at] / fast.clip.frames_per_second);
  EXPECT_LT(angle_between(pose.rotations[RightElbow], clip.poses[at].rotations[RightElbow]), 0.1);
}

TEST(GestureChange, LeavesAWalkAsItIsAndSaysSo) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  Modification modification;
  modification.gesture = {.height = 1.5, .repetitions = 1};
  const ModifiedClip made = modify(clip, modification);
  ASSERT_EQ(made.report.remarks.size(), 1u);
  EXPECT_NE(made.report.remarks[0].find("no single hand"), std::string::npos);
  ASSERT_EQ(made.clip.frame_count(), clip.frame_count());
  EXPECT_EQ(made.clip.poses[3].rotations[RightElbow].coeffs(),
            clip.poses[3].rotations[RightElbow].coeffs());
}

TEST(GestureChange, OfNoStrengthIsNone) {
  const GestureChange change{.height = 1.5, .width = 0.5, .speed = 0.7, .repetitions = 2};
  EXPECT_TRUE(is_identity(scaled(change, 0.0)));
  EXPECT_EQ(scaled(change, 0.5).repetitions, 1);
  EXPECT_NEAR(scaled(change, 2.0).height, 2.0, 1e-12);  // the most there is
  EXPECT_THROW(check(GestureChange{.height = 2.1}), Error);
  EXPECT_THROW(check(GestureChange{.speed = 0.2}), Error);
  EXPECT_THROW(check(GestureChange{.repetitions = 11}), Error);
}

}  // namespace
}  // namespace mien::motion
