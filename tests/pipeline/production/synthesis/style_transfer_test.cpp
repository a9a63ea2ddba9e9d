#include "pipeline/production/synthesis/style_transfer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/examples/settled_feet.h"
#include "motion/gait/gait.h"
#include "motion/gait/loop.h"
#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/finger_angles.h"
#include "motion/skeleton/recorded_hands.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_run.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/production/synthesis/modified_motion.h"

namespace mien::pipeline {
namespace {

const Repertoire& builtin_repertoire() {
  static const Repertoire repertoire = [] {
    Repertoire made;
    made.examples = motion::builtin_examples("walks-10");
    made.settled = motion::with_settled_feet(made.examples);
    return made;
  }();
  return repertoire;
}

const motion::Example& example(const char* name) {
  for (const motion::Example& one : builtin_repertoire().settled.examples) {
    if (one.name == name) return one;
  }
  throw Error(std::string("no example ") + name, "");
}

StyleStep step_by(StyleMethod method) {
  StyleStep step;
  step.method = method;
  step.neutral = "normal";
  step.styled = "sad";
  return step;
}

class EveryStyleMethod : public testing::TestWithParam<std::pair<const char*, StyleMethod>> {};

TEST_P(EveryStyleMethod, BringsTheNormalWalkNearerToTheSadOne) {
  const motion::Example& normal = example("normal");
  const RestyledMotion result =
      restyled(normal, step_by(GetParam().second), 1.0, builtin_repertoire());
  EXPECT_TRUE(result.motion.clip.loops);
  EXPECT_NEAR(result.motion.keytimes.back(), result.motion.clip.duration_seconds(), 1e-9);
  const double before = motion::distance(example("sad"), normal).mean;
  const double after = motion::distance(example("sad"), result.motion).mean;
  switch (GetParam().second) {
    case StyleMethod::amaya:  // moves no posture, in which sadness lies
      EXPECT_NE(after, before);
      break;
    default:
      EXPECT_LT(after, before);
  }
  EXPECT_LT(result.planted_drift_m, 0.002);
}

TEST_P(EveryStyleMethod, LeavesTheMotionAloneAtNoStrength) {
  const motion::Example& happy = example("happy");
  const RestyledMotion result =
      restyled(happy, step_by(GetParam().second), 0.0, builtin_repertoire());
  EXPECT_EQ(motion::distance(happy, result.motion).mean, 0.0);
}

TEST_P(EveryStyleMethod, IsReadFromAManifest) {
  const std::string text =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n  - {id: a, weights: "
      "{normal: 1}, modify: {method: " +
      std::string(GetParam().first) + ", neutral: normal, styled: sad, strength: 1.3}}\n";
  const ManifestReading reading = parse_manifest(
      text, "m.yaml", [](const std::string&) { return std::optional<std::string>(); });
  ASSERT_TRUE(reading.faults.empty()) << to_string(reading.faults.front());
  ASSERT_EQ(reading.manifest.stimuli.size(), 1u);
  const ModificationStep& step = reading.manifest.stimuli[0].modify.at(0);
  ASSERT_TRUE(step.style);
  EXPECT_EQ(step.style->method, GetParam().second);
  EXPECT_EQ(described(step), "normal → sad by " + std::string(GetParam().first) + " × 1.3");
}

INSTANTIATE_TEST_SUITE_P(All, EveryStyleMethod, testing::ValuesIn(style_methods),
                         [](const auto& method) { return std::string(method.param.first); });

TEST_P(EveryStyleMethod, KeepsTheFingersOfTheMotionAtTheirMoments) {
  motion::Example handed = example("normal");
  const auto count = static_cast<double>(handed.clip.frame_count());
  const int joint = motion::finger_joint(true, motion::Finger::ring, 1);
  for (std::size_t f = 0; f < handed.clip.poses.size(); ++f) {
    const double phase = 2.0 * motion::pi * static_cast<double>(f) / count;
    handed.clip.poses[f].fingers = motion::relaxed_fingers();
    handed.clip.poses[f].fingers[static_cast<std::size_t>(joint)] =
        motion::exp(0.4 * (1.0 - std::cos(phase)) * motion::flexion_axis(joint));
  }
  const RestyledMotion result =
      restyled(handed, step_by(GetParam().second), 1.0, builtin_repertoire());
  const motion::Clip& clip = result.motion.clip;
  ASSERT_TRUE(motion::has_fingers(clip));
  const auto bend_at = [&](std::size_t frame) {
    return motion::finger_angles(clip.poses[frame], joint).flexion;
  };
  EXPECT_LT(bend_at(0), 8.0);
  EXPECT_GT(bend_at(clip.poses.size() / 2), 38.0);
  EXPECT_LT(bend_at(clip.poses.size() - 1), 8.0);
}

TEST(StyleTransfer, SaysWhichComponentsItSwapped) {
  const RestyledMotion result =
      restyled(example("normal"), step_by(StyleMethod::shapiro), 1.0, builtin_repertoire());
  ASSERT_FALSE(result.notes.empty());
  EXPECT_EQ(result.notes[0].rfind("style components swapped: ", 0), 0u);
}

bool warns_of_another_gait(const RestyledMotion& result) {
  return std::ranges::any_of(result.notes, [](const std::string& note) {
    return note.find("run, but the neutral") != std::string::npos ||
           note.find("runs, but the neutral") != std::string::npos;
  });
}

TEST(StyleTransfer, WarnsWhereTheStyleOfAWalkIsAppliedToARun) {
  test::SyntheticRun gait;
  const motion::Clip take = test::steady_run(gait, 2.0 * gait.stride, 2.5);
  motion::Example running;
  running.name = "run";
  running.clip = motion::straightened(motion::closed_loop(take, 100, 150));
  const auto cycle = motion::cycle_of_loop(running.clip);
  ASSERT_TRUE(cycle);
  running.keytimes.assign(cycle->keytimes.begin(), cycle->keytimes.end());
  StyleStep step = step_by(StyleMethod::unuma);
  EXPECT_TRUE(warns_of_another_gait(restyled(running, step, 1.0, builtin_repertoire())));
  EXPECT_FALSE(warns_of_another_gait(restyled(example("normal"), step, 1.0, builtin_repertoire())));
  Repertoire runs = builtin_repertoire();
  runs.settled.examples.push_back(running);
  step.neutral = "run";
  EXPECT_TRUE(warns_of_another_gait(restyled(example("normal"), step, 1.0, runs)));
  EXPECT_FALSE(warns_of_another_gait(restyled(running, step, 1.0, runs)));
}

TEST(StyleTransfer, RefusesAnExampleThatIsNotThere) {
  StyleStep step = step_by(StyleMethod::unuma);
  step.styled = "sadd";
  EXPECT_THROW(restyled(example("normal"), step, 1.0, builtin_repertoire()), Error);
}

}  // namespace
}  // namespace mien::pipeline
