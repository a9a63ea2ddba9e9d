#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"
#include "pipeline/regression/comparison.h"

namespace mien::pipeline {
namespace {

motion::Clip walk() { return motion::builtin_examples("walks-10").examples.front().clip; }

/// A walk whose left forearm is turned.
StimulusComparison with_turned_forearm(double radians) {
  motion::Clip now = walk();
  for (motion::Pose& pose : now.poses)
    pose.rotations[motion::LeftElbow] =
        pose.rotations[motion::LeftElbow] *
        motion::Quat(Eigen::AngleAxisd(radians, motion::Vec3::UnitY()));
  StimulusComparison comparison;
  comparison.motion = motion::motion_difference(walk(), now);
  comparison.causes = {{Cause::motion, "weights", "", {}}};
  return comparison;
}

FrameComparison other_frame(bool is_bias) {
  FrameComparison frame{.frame = 3, .same = false};
  frame.perceived.mean = 0.02;
  frame.noise.is_bias = is_bias;
  return frame;
}

Verdict judged(StimulusComparison comparison, const RegressionLimits& limits = {}) {
  judge(comparison, limits);
  EXPECT_EQ(comparison.verdict == Verdict::differs, !comparison.reasons.empty());
  return comparison.verdict;
}

TEST(Verdict, OfNothingIsSame) { EXPECT_EQ(judged({}), Verdict::same); }

TEST(Verdict, OfAMotionIsByItsLimits) {
  const StimulusComparison degree = with_turned_forearm(0.0175);
  EXPECT_EQ(judged(degree), Verdict::differs);
  EXPECT_EQ(judged(degree, {.position_mm = 50, .turn_degrees = 2}), Verdict::alike);
  EXPECT_EQ(judged(degree, {.position_mm = 50, .turn_degrees = 0.5}), Verdict::differs);
  EXPECT_EQ(judged(degree, {.position_mm = 1, .turn_degrees = 2}), Verdict::differs);
}

TEST(Verdict, HoldsPartsToLimitsOfTheirOwn) {
  const StimulusComparison degree = with_turned_forearm(0.0175);
  RegressionLimits limits{.position_mm = 1, .turn_degrees = 2};
  limits.parts_mm = {{"left hand", 50}};
  EXPECT_EQ(judged(degree, limits), Verdict::differs);  // the forearm goes beyond 1 mm
  limits.parts_mm = {{"left hand", 50}, {"left forearm", 50}};
  EXPECT_EQ(judged(degree, limits), Verdict::alike);
  limits.position_mm = 50;
  limits.parts_mm = {{"left hand", 1}};
  EXPECT_EQ(judged(degree, limits), Verdict::differs);
}

TEST(Verdict, AcceptsThePicturesOfAMotionWithinItsLimits) {
  StimulusComparison comparison = with_turned_forearm(0.0175);
  comparison.frames = {other_frame(true)};
  const RegressionLimits limits{.position_mm = 50, .turn_degrees = 2};
  EXPECT_EQ(judged(comparison, limits), Verdict::alike);
  comparison.causes.push_back({Cause::renderer, "mien", "", {}});
  EXPECT_EQ(judged(comparison, limits), Verdict::differs);
}

TEST(Verdict, LetsNoisePassButNotInAnotherScene) {
  StimulusComparison comparison;
  comparison.causes = {{Cause::drawing, "seed", "", 1.0}};
  comparison.frames = {other_frame(false)};
  EXPECT_EQ(judged(comparison), Verdict::alike);
  comparison.causes = {{Cause::scene, "look.camera", "", 1.0}};
  EXPECT_EQ(judged(comparison), Verdict::differs);
  comparison.causes[0].share = 0.0;
  EXPECT_EQ(judged(comparison), Verdict::alike);
}

TEST(Verdict, OfBiasIsByThePerceptualLimit) {
  StimulusComparison comparison;
  comparison.frames = {other_frame(true)};
  EXPECT_EQ(judged(comparison), Verdict::differs);
  EXPECT_EQ(judged(comparison, {.perceptual = 0.03}), Verdict::alike);
  comparison.frames[0].same_size = false;
  EXPECT_EQ(judged(comparison, {.perceptual = 0.03}), Verdict::differs);
}

TEST(Verdict, OfVideosIsByFramesAndPsnr) {
  StimulusComparison comparison;
  comparison.videos = {{"mp4", {"other bytes"}, true, 0.05}};
  EXPECT_EQ(judged(comparison), Verdict::alike);
  EXPECT_EQ(judged(comparison, {.psnr_db = 0.01}), Verdict::differs);
  comparison.videos[0].same_frames = false;
  EXPECT_EQ(judged(comparison), Verdict::differs);
}

TEST(Verdict, OfVideosWithOtherFramesIsByWhatKeyFramesCannotShow) {
  StimulusComparison comparison;
  comparison.videos = {{"mp4", {"shows other frames"}, true, 0.0, false}};
  EXPECT_EQ(judged(comparison), Verdict::differs);
  comparison.frames = {other_frame(false)};  // noise, in the video too
  EXPECT_EQ(judged(comparison), Verdict::alike);
  comparison.settings = {{"output.presentation.card", Aspect::video, "\"A\"", "\"B\""}};
  EXPECT_EQ(judged(comparison), Verdict::differs);
  comparison.videos[0].same_pictures = true;
  EXPECT_EQ(judged(comparison), Verdict::alike);
  comparison.videos[0].same_pictures.reset();
  EXPECT_EQ(judged(comparison), Verdict::differs);
  comparison.settings.clear();
  EXPECT_EQ(judged(comparison), Verdict::alike);
}

TEST(Verdict, TellsThePartFarthestBeyondItsLimitAndCountsTheOthers) {
  StimulusComparison comparison = with_turned_forearm(0.0175);
  judge(comparison, {.position_mm = 1, .turn_degrees = 2, .parts_mm = {{"left hand", 0.1}}});
  ASSERT_EQ(comparison.reasons.size(), 1U);
  EXPECT_NE(comparison.reasons[0].find(", left hand at "), std::string::npos)
      << comparison.reasons[0];
  EXPECT_NE(comparison.reasons[0].find("1 more part is beyond tolerance"), std::string::npos)
      << comparison.reasons[0];
}

TEST(Verdict, TellsNumbersAsPeopleReadThem) {
  motion::Clip now = walk();
  for (motion::Pose& pose : now.poses) pose.root_position.x() += 1.39;
  StimulusComparison comparison;
  comparison.motion = motion::motion_difference(walk(), now);
  judge(comparison, {});
  ASSERT_FALSE(comparison.reasons.empty());
  EXPECT_EQ(comparison.reasons[0].find("position: 1390 mm, "), 0U) << comparison.reasons[0];
  comparison.motion = motion::motion_difference(walk(), motion::resampled(walk(), 24));
  judge(comparison, {.position_mm = 1e3, .turn_degrees = 180, .speed_m_s = 100});
  ASSERT_FALSE(comparison.reasons.empty());
  EXPECT_EQ(comparison.reasons.back(), "frame-rate: 30 → 24 frames per second");
}

// Other noise is encoded otherwise: what the video loses then is no change of the encoder.
TEST(Verdict, LetsTheVideoOfOtherNoiseBeLessLikeItsFrames) {
  StimulusComparison comparison;
  comparison.causes = {{Cause::drawing, "seed", "", 1.0}};
  comparison.frames = {other_frame(false)};
  comparison.videos = {{"mp4", {"worst PSNR 34.53 dB → 33.00 dB"}, true, 1.53}};
  EXPECT_EQ(judged(comparison), Verdict::alike);
  comparison.settings = {{"output.crf", Aspect::video, "18", "30"}};
  EXPECT_EQ(judged(comparison), Verdict::differs);
}

}  // namespace
}  // namespace mien::pipeline
