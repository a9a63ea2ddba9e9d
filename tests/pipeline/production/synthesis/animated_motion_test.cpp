#include <algorithm>

#include <gtest/gtest.h>

#include "motion/examples/settled_feet.h"
#include "motion/procedural/builtin_sets.h"
#include "pipeline/production/synthesis/modified_motion.h"

namespace mien::pipeline {
namespace {

using motion::BodyEnd;

motion::Example settled_walk() {
  motion::Example made = motion::builtin_examples("walks-10").examples.front();
  made.clip = motion::with_settled_feet(made.clip);
  return made;
}

/// Bends the head by some degrees, and then raises the left hand.
Stimulus animated(double bend, double rate) {
  Stimulus stimulus;
  stimulus.id = "s";
  stimulus.output.fps = rate;
  ModificationStep step;
  step.edit.values.posture = {{motion::PostureUnit::head_flexion, bend}};
  step.modification = with_edit({}, step.edit);
  motion::AnimatorKey key;
  key.at = {0.4};
  key.places[static_cast<std::size_t>(BodyEnd::left_hand)] = motion::Vec3(0.3, 1.3, 0.3);
  step.keys = {key};
  stimulus.modify = {step};
  return stimulus;
}

motion::Vec3 hand_at(const motion::Clip& clip, double seconds) {
  const motion::Pose pose = motion::pose_at(clip, seconds);
  return body_frame(pose).from_room(
      place_of(clip.body, world_transforms(clip.body, pose), BodyEnd::left_hand));
}

TEST(AnimatedMotion, HasItsKeysAfterEverythingElseAtEveryStrengthAndRate) {
  const motion::Example walk = settled_walk();
  for (const double rate : {25.0, 50.0}) {
    for (const double strength : {0.0, 0.5, 1.0}) {
      Stimulus stimulus = animated(10.0, rate);
      stimulus.modify[0].strength = strength;
      const ModifiedMotion made = modify_motion(walk, stimulus, {});
      EXPECT_LT((hand_at(made.motion.clip, 0.4) - motion::Vec3(0.3, 1.3, 0.3)).norm(), 1e-6);
      EXPECT_EQ(made.notes.back(), "keys held: 1 of 1");
    }
  }
  EXPECT_EQ(described_modifications(animated(10.0, 30.0)), "head-flexion 10°, 1 key");
}

TEST(AnimatedMotion, CountsFramesOfTheOutput) {
  Stimulus stimulus = animated(0.0, 50.0);
  stimulus.modify[0].keys[0].at = {20.0, true};
  const ModifiedMotion made = modify_motion(settled_walk(), stimulus, {});
  EXPECT_LT((hand_at(made.motion.clip, 0.4) - motion::Vec3(0.3, 1.3, 0.3)).norm(), 1e-6);
}

TEST(AnimatedMotion, IsRevertedTogetherWithAFaultyModification) {
  Stimulus stimulus = animated(85.0, 30.0);
  stimulus.on_fault = OnFault::revert;
  const ModifiedMotion made = modify_motion(settled_walk(), stimulus, {});
  EXPECT_EQ(made.share, 0.0);
  EXPECT_GT((hand_at(made.motion.clip, 0.4) - motion::Vec3(0.3, 1.3, 0.3)).norm(), 0.1);
}

TEST(AnimatedMotion, HasFrozenPartsThatAreNoFault) {
  Stimulus stimulus;
  stimulus.id = "s";
  stimulus.on_fault = OnFault::revert;
  stimulus.modify = {{.freeze = {.parts = {motion::FrozenPart::left_arm}}}};
  const motion::Example walk = settled_walk();
  const ModifiedMotion made = modify_motion(walk, stimulus, {});
  EXPECT_EQ(made.share, 1.0);
  EXPECT_TRUE(made.warnings.empty());
  const auto still = [](const ModifiedMotion& of) {
    std::vector<std::string> joints;
    for (const motion::Finding& finding : of.findings)
      if (finding.check == "still-limb") joints.push_back(finding.joint);
    return joints;
  };
  EXPECT_TRUE(still(made).empty());
  for (const motion::Pose& pose : made.motion.clip.poses)
    EXPECT_EQ(pose.rotations[motion::LeftElbow].coeffs(),
              made.motion.clip.poses.front().rotations[motion::LeftElbow].coeffs());
  EXPECT_EQ(described_modifications(stimulus), "frozen parts");
  // An arm that stops for another reason is one.
  stimulus.on_fault = OnFault::warn;
  stimulus.modify[0].modification.relative.arm_swing = 0.0;
  const std::vector<std::string> others = still(modify_motion(walk, stimulus, {}));
  EXPECT_EQ(std::ranges::count(others, "LeftWrist"), 0);
  EXPECT_EQ(std::ranges::count(others, "RightWrist"), 1);
}

TEST(AnimatedMotion, StatesHowFarPlantedFeetDriftInWhatIsDelivered) {
  constexpr double own = 0.012;  // of the original
  motion::Example walk = settled_walk();
  walk.clip = motion::repeated(walk.clip, 2);
  walk.keytimes = {0.0, walk.clip.duration_seconds()};
  const auto drift_with = [&](const ModificationStep& step, OnFault on_fault = OnFault::warn) {
    Stimulus stimulus;
    stimulus.id = "s";
    stimulus.on_fault = on_fault;
    stimulus.output.fps = walk.clip.frames_per_second;
    stimulus.modify = {step};
    return modify_motion(walk, stimulus, {}, {}, own).planted_drift_m;
  };
  // Feet that nothing touches drift as before.
  EXPECT_DOUBLE_EQ(drift_with({.ends = {.hold_before = 0.5}}), own);
  EXPECT_NEAR(drift_with({.freeze = {.parts = {motion::FrozenPart::left_arm}}}), own, 1e-6);
  EXPECT_DOUBLE_EQ(drift_with(animated(85.0, 30.0).modify[0], OnFault::revert), own);
  // The repair of a modification locks feet.
  EXPECT_LT(drift_with(animated(5.0, 30.0).modify[0]), 0.002);
  // An end that does not fit the beginning is pulled towards it.
  walk.clip.poses.resize(walk.clip.poses.size() * 3 / 10);
  EXPECT_GT(drift_with({.ends = {.loops = true}}), own + 0.005);
}

TEST(AnimatedMotion, HoldsItsEndsWithoutFault) {
  Stimulus stimulus;
  stimulus.id = "s";
  stimulus.on_fault = OnFault::revert;
  motion::Example walk = settled_walk();
  walk.clip = motion::repeated(walk.clip, 2);
  walk.keytimes = {0.0, walk.clip.duration_seconds()};
  stimulus.output.fps = walk.clip.frames_per_second;
  const ModifiedMotion plain = modify_motion(walk, stimulus, {}, {0.25});
  stimulus.modify = {{.ends = {.hold_before = 0.5, .hold_after = 1.0}}};
  const ModifiedMotion held = modify_motion(walk, stimulus, {}, {0.25});
  EXPECT_EQ(held.share, 1.0);
  EXPECT_TRUE(held.warnings.empty());
  const auto before = static_cast<int>(std::lround(0.5 * stimulus.output.fps));
  EXPECT_EQ(held.motion.clip.frame_count(), plain.motion.clip.frame_count() + 3 * before);
  EXPECT_NEAR(held.times[0], 0.75, 1e-9);
  ASSERT_EQ(held.findings.size(), plain.findings.size());
  for (std::size_t f = 0; f < held.findings.size(); ++f)
    EXPECT_EQ(held.findings[f].first, plain.findings[f].first + before);
  EXPECT_EQ(held.motion.keytimes.front(), plain.motion.keytimes.front());
  EXPECT_NEAR(held.motion.keytimes.back(), held.motion.clip.duration_seconds(), 1e-9);
  EXPECT_EQ(described_modifications(stimulus), "first pose held for 0.5 s, last pose held for 1 s");
  // A loop instead.
  stimulus.on_fault = OnFault::warn;
  stimulus.modify[0].ends = {.loops = true};
  const ModifiedMotion loop = modify_motion(walk, stimulus, {});
  EXPECT_TRUE(loop.motion.clip.loops);
  EXPECT_EQ(described_modifications(stimulus), "made to loop");
}

TEST(AnimatedMotion, EditsDrivesBeforeKeys) {
  Stimulus stimulus = animated(0.0, 30.0);
  stimulus.modify[0].drives = {
      {motion::LimbMovement::left_hand_side, motion::BodyMovement::pelvis_side, 1.0, 0.05}};
  const motion::Example walk = settled_walk();
  const ModifiedMotion made = modify_motion(walk, stimulus, {});
  EXPECT_LT((hand_at(made.motion.clip, 0.4) - motion::Vec3(0.3, 1.3, 0.3)).norm(), 1e-6);
  stimulus.modify[0].keys.clear();
  const ModifiedMotion wide = modify_motion(walk, stimulus, {});
  EXPECT_NEAR(hand_at(wide.motion.clip, 0.9).x() - hand_at(walk.clip, 0.9).x(), 0.05, 0.005);
}

}  // namespace
}  // namespace mien::pipeline
