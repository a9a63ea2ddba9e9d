#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "motion/measures/differences/feature_change.h"
#include "motion/skeleton/pose.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/recipes/recipe_table.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

std::optional<std::string> data_folder(const std::string& name) {
  const auto data = test::real_data();
  return name == "MIEN_DATA" && data ? std::optional(data->string()) : std::nullopt;
}

/// Of a manifest that comes with mien.
std::vector<RecipeResult> results_in(const char* manifest) {
  return recipe_results(
      load_manifest(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / manifest, data_folder));
}

bool is_gesture(const RecipeResult& result) {
  return result.neutral.ends_with("wave") || result.neutral.ends_with("knock");
}

/// A neutral walk, "neutral", with each of the built-in emotions applied to it.
Manifest walk_with_emotions(const std::string& examples, const std::string& walk) {
  std::string text = "mien: 1\nstudy: s\nexamples: {set: " + examples +
                     "}\nstimuli:\n- {id: neutral, weights: {" + walk + ": 1}}\n";
  for (const char* emotion : {"afraid", "nervous", "strong", "tired", "weak"})
    text += fmt::format("- {{id: {0}, weights: {{{1}: 1}}, modify: {{emotion: {0}}}}}\n", emotion,
                        walk);
  const ManifestReading reading = parse_manifest(text, "/nowhere/m.yaml", data_folder);
  EXPECT_TRUE(reading.faults.empty()) << to_string(reading.faults.at(0));
  return reading.manifest;
}

/// Of the built-in actors and, where there is motion capture, of three captured ones.
std::vector<Manifest> walks_with_emotions() {
  std::vector<Manifest> manifests = {walk_with_emotions("builtin:actors", "woman-walk-neutral"),
                                     walk_with_emotions("builtin:actors", "man-walk-neutral")};
  if (const auto data = test::real_data()) {
    const auto of = [&](const char* folder, const std::string& file) {
      return walk_with_emotions(
          fmt::format("{{folder: {}, include: {}.bvh, cycle: auto, blend: false}}",
                      (*data / "mocap" / folder).string(), file),
          file);
    };
    for (const char* actor : {"k", "t"}) {
      manifests.push_back(
          of("aalto-two-actors",
             fmt::format("{0}_run_slow_{0}_limp_fast_{0}_walk_regular_000_000_100", actor)));
    }
    manifests.push_back(of("bandai-namco-1", "dataset-1_walk_normal_001"));
  }
  return manifests;
}

motion::FeatureValues features_of(Motions& motions, const char* stimulus) {
  return motion::measure_features(motions.of(stimulus).motion);
}

double value_of(const motion::FeatureValues& values, std::string_view id) {
  const auto found = std::ranges::find(motion::motion_features(), id, &motion::MotionFeature::id);
  return values.at(static_cast<std::size_t>(found - motion::motion_features().begin()));
}

/// How many features two motions change in opposite directions, however little.
int opposite_changes(const motion::FeatureValues& neutral, const motion::FeatureValues& one,
                     const motion::FeatureValues& other) {
  int count = 0;
  for (const motion::FeatureChange& change : motion::feature_changes(neutral, one, other))
    count += change.target_change() * change.created_change() < 0.0 ? 1 : 0;
  return count;
}

/// The height of the higher ankle above the lower one, metres, where it is greatest.
double highest_ankle(const motion::Clip& clip) {
  double highest = 0.0;
  for (const motion::Pose& pose : clip.poses) {
    const auto places = motion::world_transforms(clip.body, pose).positions;
    highest =
        std::max(highest, std::abs(places[motion::LeftAnkle].y() - places[motion::RightAnkle].y()));
  }
  return highest;
}

/// The mean distance between the wrists, metres.
double distance_of_hands(const motion::Clip& clip) {
  double sum = 0.0;
  for (const motion::Pose& pose : clip.poses) {
    const auto places = motion::world_transforms(clip.body, pose).positions;
    sum += (places[motion::LeftWrist] - places[motion::RightWrist]).norm();
  }
  return sum / clip.frame_count();
}

TEST(BuiltinRecipes, ChangeFeaturesAsActorsDo) {
  int compared = 0;
  for (const EmotionSummary& summary : emotion_summaries(results_in("acted-emotions.yaml"))) {
    EXPECT_EQ(summary.faulty, 0) << summary.emotion;
    if (summary.comparisons == 0) continue;
    compared += summary.comparisons;
    EXPECT_GE(summary.right, 0.75 * summary.changed) << summary.emotion;
    EXPECT_EQ(summary.nearer, summary.comparisons) << summary.emotion;
  }
  EXPECT_EQ(compared, 18);
}

TEST(BuiltinRecipes, ComeNearCapturedActors) {
  if (!test::real_data()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  std::vector<RecipeResult> walks;
  int compared = 0, farther = 0;
  for (const char* manifest :
       {"real-emotions.yaml", "real-styles.yaml", "real-gestures.yaml", "acted-emotions.yaml"}) {
    for (const RecipeResult& result : results_in(manifest)) {
      EXPECT_TRUE(result.errors.empty()) << result.emotion << " " << result.neutral;
      if (!result.is_compared()) continue;
      ++compared;
      farther += result.is_nearer() ? 0 : 1;
      if (!is_gesture(result)) walks.push_back(result);
    }
  }
  EXPECT_EQ(farther, 0);
  EXPECT_EQ(compared, 67);
  for (const EmotionSummary& summary : emotion_summaries(walks)) {
    EXPECT_GE(summary.right, 0.75 * summary.changed) << summary.emotion;
  }
}

TEST(BuiltinRecipes, TellFearTirednessAndWeaknessApart) {
  for (const Manifest& manifest : walks_with_emotions()) {
    Motions motions(manifest);
    const motion::FeatureValues neutral = features_of(motions, "neutral");
    for (const auto& [one, other] :
         {std::pair("afraid", "tired"), std::pair("afraid", "weak"), std::pair("tired", "weak")}) {
      EXPECT_GE(motions.distance(one, other).mean, 0.02) << one << " " << other;
      EXPECT_GE(opposite_changes(neutral, features_of(motions, one), features_of(motions, other)),
                10)
          << one << " " << other << " of " << motions.of("neutral").motion.name;
    }
  }
}

TEST(BuiltinRecipes, MakeNervousWalksQuickShortAndDrawnIn) {
  for (const Manifest& manifest : walks_with_emotions()) {
    Motions motions(manifest);
    EXPECT_GE(motions.distance("nervous", "neutral").mean, 0.02);
    const motion::FeatureValues before = features_of(motions, "neutral");
    const motion::FeatureValues after = features_of(motions, "nervous");
    const auto ratio = [&](const char* feature) {
      return value_of(after, feature) / value_of(before, feature);
    };
    EXPECT_LT(ratio("duration"), 0.85);
    EXPECT_LT(ratio("step-length-fb"), 0.85);
    EXPECT_LT(ratio("sigma-left-upper-arm-fb"), 0.7);
    EXPECT_LT(distance_of_hands(motions.clip("nervous")),
              distance_of_hands(motions.clip("neutral")) - 0.03);
  }
}

/// In a run heels rise behind the body; strong walks are slow and wide, with feet near the floor.
TEST(BuiltinRecipes, DoNotMakeStrongWalksLookLikeRuns) {
  for (const Manifest& manifest : walks_with_emotions()) {
    Motions motions(manifest);
    EXPECT_LT(highest_ankle(motions.clip("strong")), 1.4 * highest_ankle(motions.clip("neutral")))
        << motions.of("neutral").motion.name;
  }
}

}  // namespace
}  // namespace mien::pipeline
