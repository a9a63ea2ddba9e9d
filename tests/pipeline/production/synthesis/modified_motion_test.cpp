#include "pipeline/production/synthesis/modified_motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/examples/settled_feet.h"
#include "motion/lint/lint.h"
#include "motion/measures/distance/distance.h"
#include "motion/procedural/builtin_sets.h"

namespace mien::pipeline {
namespace {

const motion::Example& normal_walk() {
  static const motion::Example walk = [] {
    motion::Example made = motion::builtin_examples("walks-10").examples.front();
    made.clip = motion::with_settled_feet(made.clip);
    return made;
  }();
  return walk;
}

Stimulus stimulus_with(const std::vector<motion::PostureChange>& posture, OnFault on_fault) {
  Stimulus stimulus;
  stimulus.id = "s";
  stimulus.on_fault = on_fault;
  ModificationStep step;
  step.edit.values.posture = posture;
  step.modification = with_edit({}, step.edit);
  stimulus.modify.push_back(step);
  return stimulus;
}

/// No neck bends so far.
Stimulus broken_neck(OnFault on_fault) {
  return stimulus_with({{motion::PostureUnit::head_flexion, 85.0}}, on_fault);
}

double moved(const motion::Example& motion) { return motion::distance(normal_walk(), motion).mean; }

TEST(ModifiedMotion, IsTheMotionItselfAtStrengthZero) {
  Stimulus stimulus = broken_neck(OnFault::fail);
  stimulus.modify[0].strength = 0.0;
  const ModifiedMotion result = modify_motion(normal_walk(), stimulus, {});
  EXPECT_LT(moved(result.motion), 1e-9);
  EXPECT_EQ(result.share, 1.0);
}

TEST(ModifiedMotion, SaysThatAGestureIsMissingOnlyIfItsChangeWasAskedFor) {
  Stimulus stimulus;
  stimulus.id = "s";
  ModificationStep step;
  step.modification.paths = 1.1;
  step.modification.gesture.height = 1.2;  // as from a recipe
  stimulus.modify.push_back(step);
  const auto says_it = [&] {
    return std::ranges::any_of(
        modify_motion(normal_walk(), stimulus, {}).notes,
        [](const std::string& note) { return note.find("gesture") != std::string::npos; });
  };
  EXPECT_FALSE(says_it());
  stimulus.modify[0].edit.named.insert("gesture");
  EXPECT_TRUE(says_it());
}

TEST(ModifiedMotion, WarnsOfFaultsAndKeepsThem) {
  const ModifiedMotion result = modify_motion(normal_walk(), broken_neck(OnFault::warn), {});
  EXPECT_TRUE(motion::has_errors(result.findings));
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("makes the motion faulty"), std::string::npos);
  EXPECT_GT(moved(result.motion), 0.002);
}

TEST(ModifiedMotion, FailsWhenAskedTo) {
  try {
    modify_motion(normal_walk(), broken_neck(OnFault::fail), {});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("modified by head-flexion 85°"), std::string::npos) << text;
    EXPECT_NE(text.find("lower the strength"), std::string::npos) << text;
  }
}

TEST(ModifiedMotion, RevertsWhenAskedTo) {
  const ModifiedMotion result = modify_motion(normal_walk(), broken_neck(OnFault::revert), {});
  EXPECT_LT(moved(result.motion), 1e-9);
  EXPECT_FALSE(motion::has_errors(result.findings));
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("left unmodified"), std::string::npos);
}

TEST(ModifiedMotion, IsReducedToTheLargestCleanStrength) {
  const ModifiedMotion result = modify_motion(normal_walk(), broken_neck(OnFault::reduce), {});
  EXPECT_GT(result.share, 0.2);
  EXPECT_LT(result.share, 0.98);
  EXPECT_FALSE(motion::has_errors(result.findings));
  EXPECT_GT(moved(result.motion), 0.001);
  // A sixty-fourth more would break it.
  Stimulus more = broken_neck(OnFault::warn);
  more.modify[0].strength = result.share + 1.0 / 64.0;
  EXPECT_TRUE(motion::has_errors(modify_motion(normal_walk(), more, {}).findings));
}

TEST(ModifiedMotion, DoesItsStepsInOrderAndMovesKeytimesWithTempo) {
  Stimulus stimulus = stimulus_with({{motion::PostureUnit::head_flexion, 10.0}}, OnFault::warn);
  ModificationStep slower;
  slower.edit.values.tempo = 0.8;
  slower.edit.named = {"tempo"};
  slower.strength = 1.0;
  slower.modification = with_edit({}, slower.edit);
  stimulus.modify.push_back(slower);
  const ModifiedMotion result = modify_motion(normal_walk(), stimulus, {});
  const double before = normal_walk().clip.duration_seconds();
  EXPECT_NEAR(result.motion.clip.duration_seconds(), before / 0.8, 0.02);
  EXPECT_EQ(result.motion.keytimes.size(), normal_walk().keytimes.size());
  EXPECT_NEAR(result.motion.keytimes.back(), result.motion.clip.duration_seconds(), 1e-9);
  EXPECT_EQ(described_modifications(stimulus), "head-flexion 10°; then tempo 0.8");
}

TEST(ModifiedMotion, MovesKeytimesAlongACurveOfTempos) {
  ModificationStep step;
  step.edit.values.tempo.curve = {{0.0, 0.5}, {0.5, 2.0}};
  step.edit.named = {"tempo"};
  step.modification = with_edit({}, step.edit);
  Stimulus stimulus = stimulus_with({}, OnFault::warn);
  stimulus.modify = {step};
  const motion::Example original = normal_walk();
  const ModifiedMotion result = modify_motion(original, stimulus, {});
  const double before = original.clip.duration_seconds();
  const double after = result.motion.clip.duration_seconds();
  const motion::Retiming retiming =
      motion::retiming(original.clip.frame_count(), true, step.modification.tempo);
  for (std::size_t i = 0; i < original.keytimes.size(); ++i) {
    // The moment of the original that is shown at the new keytime is the keytime.
    const double frame = result.motion.keytimes[i] / after * retiming.frames_after();
    const auto whole = static_cast<std::size_t>(std::min(frame, retiming.frames_after() - 1.0));
    const double next = whole + 1 < retiming.sources.size()
                            ? retiming.sources[whole + 1]
                            : static_cast<double>(original.clip.frame_count());
    const double source =
        std::lerp(retiming.sources[whole], next, frame - static_cast<double>(whole));
    EXPECT_NEAR(source, original.keytimes[i] / before * original.clip.frame_count(), 0.05);
  }
  EXPECT_NEAR(result.motion.keytimes.back(), after, 1e-9);
  EXPECT_NE(result.motion.keytimes[1] / after, original.keytimes[1] / before);
  EXPECT_EQ(described_modifications(stimulus), "tempo 0.5 → 2");
}

TEST(ModifiedMotion, IsNotBlamedForWhatWasBrokenBefore) {
  motion::Example torn = normal_walk();
  torn.clip.loops = false;
  // A wrist that leaps for one frame.
  torn.clip.poses[12].rotations[motion::LeftElbow] = motion::Quat(0.0, 0.0, 1.0, 0.0);
  Stimulus stimulus = stimulus_with({{motion::PostureUnit::head_flexion, 5.0}}, OnFault::fail);
  ModifiedMotion result = modify_motion(torn, stimulus, {});
  EXPECT_TRUE(motion::has_errors(result.findings));
  EXPECT_TRUE(result.warnings.empty());
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes.back().find("without the modification"), std::string::npos);
}

TEST(ModifiedMotion, IsBlamedForWhatItMakesMuchWorse) {
  motion::Example bowed = normal_walk();
  bowed.clip = motion::with_posture(bowed.clip, {{motion::PostureUnit::head_flexion, 85.0}});
  const auto findings = motion::lint(bowed.clip);
  ASSERT_TRUE(motion::has_errors(findings));  // beyond the neck's range before anything is done
  const ModifiedMotion little = modify_motion(
      bowed, stimulus_with({{motion::PostureUnit::head_flexion, 1.0}}, OnFault::warn), {});
  EXPECT_TRUE(little.warnings.empty());
  const ModifiedMotion much = modify_motion(
      bowed, stimulus_with({{motion::PostureUnit::head_flexion, 60.0}}, OnFault::warn), {});
  EXPECT_EQ(much.warnings.size(), 1u);
}

TEST(ModifiedMotion, DoesTheSameAtEveryRateItIsShownAt) {
  motion::Example captured = normal_walk();
  captured.clip = motion::repeated(captured.clip, 3);
  captured.keytimes = {0.0, captured.clip.duration_seconds()};
  Stimulus stimulus = stimulus_with({}, OnFault::warn);
  stimulus.modify[0].modification.paths = 0.4;
  std::vector<double> ways;
  for (const double fps : {10.0, 30.0, 120.0}) {
    stimulus.output.fps = fps;
    const motion::Clip clip = modify_motion(captured, stimulus, {}).motion.clip;
    EXPECT_EQ(clip.frames_per_second, fps);
    // By the time that is shown: the last frame of a coarse rate lies before the motion's end.
    ways.push_back((clip.poses.back().root_position - clip.poses.front().root_position).norm() /
                   clip.duration_seconds());
  }
  EXPECT_NEAR(ways[0], ways[1], 0.01 * ways[1]);
  EXPECT_NEAR(ways[2], ways[1], 0.01 * ways[1]);
}

TEST(ModifiedMotion, TakesPosesFromExamples) {
  Repertoire repertoire;
  repertoire.examples = motion::builtin_examples("actors");
  Stimulus stimulus = stimulus_with({}, OnFault::warn);
  stimulus.modify[0].pose = {{.example = "man-stand-neutral"}, {.example = "man-stand-sad"}};
  EXPECT_GT(moved(modify_motion(normal_walk(), stimulus, repertoire).motion), 0.003);
  stimulus.modify[0].pose->posed.frame = 1000;
  EXPECT_THROW(modify_motion(normal_walk(), stimulus, repertoire), Error);
  stimulus.modify[0].pose->posed = {.example = "nobody"};
  EXPECT_THROW(modify_motion(normal_walk(), stimulus, repertoire), Error);
}

}  // namespace
}  // namespace mien::pipeline
