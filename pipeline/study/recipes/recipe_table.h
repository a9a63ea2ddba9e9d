#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// One recipe on one neutral motion, compared with what an actor did if there is an acted version.
struct RecipeResult {
  std::string study;
  std::string neutral;  ///< id of the stimulus
  std::string emotion;
  std::string acted;  ///< id of the acted stimulus; empty if there is none
  int changed = 0;  ///< features in which the acted motion differs measurably from the neutral one
  int right = 0;    ///< of these, changed by the recipe in the same direction (feature_change.h)
  int wrong = 0;    ///< of these, changed by the recipe in the opposite direction
  std::optional<double> neutral_distance_m;   ///< D of the neutral motion from the acted one
  std::optional<double> modified_distance_m;  ///< D of the modified motion from the acted one
  std::vector<std::string>
      errors;  ///< new lint errors of the modified motion: "joint-limit LeftKnee"

  bool is_compared() const { return !acted.empty(); }
  /// Of the changed features, the share changed in the same direction; 1 if none changed.
  double share_right() const;
  /// Whether the modified motion is no farther from the acted motion than the neutral one is.
  bool is_nearer() const;
};

/// Applies every recipe of the manifest's `recipes:` to every stimulus with `role: reference`, and
/// compares the result with the acted versions: stimuli whose factors state `neutral` (the id of
/// the reference) and `emotion` (the name of a recipe). Throws Error for a factor `neutral` that is
/// no such stimulus, for an `emotion` without a recipe, and if the manifest has no stimulus with
/// `role: reference`.
std::vector<RecipeResult> recipe_results(const Manifest& manifest);

/// Results of one emotion over all neutral motions.
struct EmotionSummary {
  std::string emotion;
  int motions = 0;                        ///< neutral motions
  int faulty = 0;                         ///< of these, with new errors
  int comparisons = 0;                    ///< acted versions
  int changed = 0, right = 0, wrong = 0;  ///< features, over all comparisons
  int mostly_right = 0;  ///< comparisons with at least `wanted_share` of the features right
  int nearer = 0;  ///< comparisons in which the modified motion is no farther than the neutral
};

/// Share of the changed features that a recipe should change in the same direction.
inline constexpr double wanted_share = 0.75;

/// One summary per emotion, in the order of the names.
std::vector<EmotionSummary> emotion_summaries(const std::vector<RecipeResult>& results);

WrittenTable recipe_results_table(const std::vector<RecipeResult>& results);
WrittenTable emotion_summaries_table(const std::vector<EmotionSummary>& summaries);

}  // namespace mien::pipeline
