#include "motion/live/live_modification.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/live/live_core.h"
#include "motion/live/small_bundle.h"
#include "motion/modify/modified_example.h"

namespace mien::motion {
namespace {

/// Sadness, anger, a rotation, paths, acceleration and tempo of one walk.
LiveModification six_dimensions(const std::string& original) {
  Modification sad, angry;
  sad.posture = {{PostureUnit::head_flexion, 20.0}};
  sad.relative.arm_swing = 0.5;
  sad.tempo = 0.8;
  angry.gains = PathGains{1.0, 1.3, 1.1, {}};
  angry.acceleration = 0.4;
  angry.stiffness.left_arm = 1.4;
  angry.relative.range = {{PostureUnit::elbow_flexion, 0.2}};
  return {
      original,
      {{.name = "sad", .recipe = sad, .high = 1.5},
       {.name = "angry", .recipe = angry},
       {.name = "chest-flexion",
        .value = ModificationValue::rotation,
        .unit = PostureUnit::chest_flexion,
        .low = -10.0,
        .high = 20.0},
       {.name = "paths", .value = ModificationValue::paths, .low = 0.5, .high = 1.5},
       {.name = "acceleration", .value = ModificationValue::acceleration, .low = -0.5, .high = 0.5},
       {.name = "tempo", .value = ModificationValue::tempo, .low = 0.7, .high = 1.4}}};
}

LiveBundle modified_bundle() {
  LiveBundle bundle = test::small_bundle();
  bundle.modification = six_dimensions(bundle.examples.examples[0].name);
  return bundle;
}

bool are_same(const Clip& a, const Clip& b) {
  if (a.poses.size() != b.poses.size() || a.frames_per_second != b.frames_per_second) return false;
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    if (a.poses[i].root_position != b.poses[i].root_position) return false;
    for (std::size_t j = 0; j < a.poses[i].rotations.size(); ++j)
      if (a.poses[i].rotations[j].coeffs() != b.poses[i].rotations[j].coeffs()) return false;
  }
  return true;
}

TEST(LiveModification, ChangesNothingAtItsNeutralPoint) {
  const LiveBundle bundle = modified_bundle();
  const Example& walk = bundle.examples.examples[0];
  std::vector<double> neutral;
  for (const ModificationDimension& dimension : bundle.modification.dimensions)
    neutral.push_back(neutral_value(dimension.value));
  EXPECT_EQ(neutral, (std::vector<double>{0, 0, 0, 1, 0, 1}));
  EXPECT_TRUE(are_same(modified_at(walk, bundle.modification, neutral).clip, walk.clip));
  LiveCore core(bundle);
  EXPECT_TRUE(are_same(core.make({InterfaceKind::modifications, {}, {}}).motion.clip,
                       core.example(walk.name).motion.clip));
}

TEST(LiveModification, IsEachRecipeInTurnAndThenTheRest) {
  const LiveBundle bundle = modified_bundle();
  const LiveModification& by = bundle.modification;
  const Example& walk = bundle.examples.examples[0];
  Clip step_by_step = modified(walk.clip, scaled(by.dimensions[0].recipe, 1.2));
  step_by_step = modified(step_by_step, scaled(by.dimensions[1].recipe, 0.5));
  Modification others;
  others.posture = {{PostureUnit::chest_flexion, 8.0}};
  others.paths = 1.3;
  others.acceleration = -0.2;
  others.tempo = 1.25;
  step_by_step = modified(step_by_step, others);
  const Example made = modified_at(walk, by, {1.2, 0.5, 8.0, 1.3, -0.2, 1.25});
  EXPECT_TRUE(are_same(made.clip, step_by_step));
  ASSERT_EQ(made.keytimes.size(), walk.keytimes.size());
  EXPECT_EQ(made.keytimes.front(), 0.0);
  EXPECT_NEAR(made.keytimes.back(), made.clip.duration_seconds(), 1e-9);
  EXPECT_TRUE(std::is_sorted(made.keytimes.begin(), made.keytimes.end()));
  // Something is left of each: without it, the motion is another.
  const std::vector<double> point = {1.2, 0.5, 8.0, 1.3, -0.2, 1.25};
  for (std::size_t d = 0; d < point.size(); ++d) {
    std::vector<double> without = point;
    without[d] = neutral_value(by.dimensions[d].value);
    EXPECT_FALSE(are_same(modified_at(walk, by, without).clip, made.clip)) << by.dimensions[d].name;
  }
}

TEST(LiveModification, ComesBackFromTheBytesOfABundle) {
  const LiveBundle bundle = modified_bundle();
  const std::string bytes = to_bytes(bundle);
  const LiveBundle read = parse_live_bundle(bytes);
  EXPECT_EQ(to_bytes(read), bytes);
  LiveCore here(bundle), there(read);
  const LiveSetting setting{InterfaceKind::modifications,
                            {"tempo", "sad", "angry", "acceleration", "chest-flexion"},
                            {1.2, 0.9, 0.3, 0.5, -5.0}};
  EXPECT_TRUE(are_same(here.make(setting).motion.clip, there.make(setting).motion.clip));
  EXPECT_EQ(here.make(setting).plants.size(), there.make(setting).plants.size());
  // Bundles without modifications are as they were.
  LiveBundle plain = bundle;
  plain.modification = {};
  EXPECT_TRUE(bytes.substr(32).starts_with(to_bytes(plain).substr(32)));
}

TEST(LiveModification, IsRefusedWhereItCannotBeUsed) {
  const auto refused = [](const auto& change) {
    LiveBundle bundle = modified_bundle();
    change(bundle.modification);
    EXPECT_THROW(parse_live_bundle(to_bytes(bundle)), Error);
  };
  refused([](LiveModification& by) { by.original = "nobody"; });
  refused([](LiveModification& by) { by.dimensions[2].low = 30.0; });
  refused([](LiveModification& by) { by.dimensions[0].recipe.tempo = 9.0; });
  refused([](LiveModification& by) { by.dimensions[0].high = 1e9; });
}

TEST(LiveModification, RefusesSlidersThatItDoesNotHaveAndValuesBeyondTheLimits) {
  const LiveBundle bundle = modified_bundle(), plain = test::small_bundle();
  LiveCore core(bundle), without(plain);
  const auto wrong = [](LiveCore& of, const LiveSetting& setting) {
    try {
      of.make(setting);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const InterfaceKind kind = InterfaceKind::modifications;
  EXPECT_EQ(wrong(core, {kind, {"sad"}, {1.5}}), "");
  EXPECT_NE(wrong(core, {kind, {"sad"}, {1.6}}).find("not within its limits"), std::string::npos);
  EXPECT_NE(wrong(core, {kind, {"sad"}, {std::nan("")}}).find("limits"), std::string::npos);
  EXPECT_NE(wrong(core, {kind, {"glad"}, {1.0}}).find("no modification \"glad\""),
            std::string::npos);
  EXPECT_NE(wrong(core, {kind, {"sad", "sad"}, {1.0, 1.0}}).find("twice"), std::string::npos);
  EXPECT_NE(wrong(core, {kind, {"sad"}, {}}).find("0 values"), std::string::npos);
  EXPECT_NE(wrong(without, {kind, {}, {}}).find("no motion is modified"), std::string::npos);
}

}  // namespace
}  // namespace mien::motion
