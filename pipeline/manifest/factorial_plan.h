#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/factor_crossing.h"
#include "pipeline/manifest/factors.h"

namespace mien::pipeline {

/// A comparison of levels of factors that is planned beforehand: in each participant, the sum of
/// the means of the levels times their weights.
struct PlannedContrast {
  std::string name;
  /// Weights of the levels of one factor, with a sum of 0; those of several factors are multiplied,
  /// so that the contrast is an interaction. Levels without a weight are not compared.
  std::vector<std::pair<std::string, LevelWeights>> weights;
  Factors at;                       ///< only at these levels of other factors; empty: at all
  std::vector<std::string> scales;  ///< ids; empty: all
};

void fields_of(auto&& field, MaybeConst<PlannedContrast> auto& contrast) {
  field("name", contrast.name, concerns::required);
  field("weights", contrast.weights, concerns::required);
  field.by("at", contrast.at, concerns::nothing, FactorsForm());
  field("scales", contrast.scales, concerns::nothing);
}

/// The factors whose effects are tested.
struct FactorialPlan {
  /// Within participants; empty: design_factors. Of pairs, worths are those of the combinations of
  /// their levels; empty: of single stimuli.
  std::vector<std::string> factors;
  std::string between;  ///< id of the question whose answers form groups of participants; or empty
  std::vector<PlannedContrast> contrasts;
  /// Whether the mixed models have a random slope of each factor for participants, in addition to
  /// random intercepts.
  bool random_slopes = false;

  /// Whether nothing is planned.
  bool empty() const {
    return factors.empty() && between.empty() && contrasts.empty() && !random_slopes;
  }
};

/// The largest number of factors of an analysis of variance.
inline constexpr std::size_t most_factors = 4;

/// The factors of the analysis: those that the plan names, or else the stated ones (`factors:` of
/// stimuli) and `emotion`, if the rated stimuli have at least two levels of them. The manifest must
/// have a questionnaire.
std::vector<std::string> design_factors(const Manifest& manifest);

/// The levels of the design's factors for all stimuli of the manifest, in its order; only rated
/// ones have levels. The manifest must have a questionnaire.
FactorTable design_table(const Manifest& manifest);

/// "modified − acted" or "(sad − happy) × (walk − 0.5 run)"
std::string weights_text(const PlannedContrast& contrast);

/// What is analysed by the factors.
enum class AnalysedAnswers {
  ratings,  ///< of single stimuli: by an analysis of variance
  choices,  ///< between two stimuli: by the worths of the combinations of levels
};

/// The answers that the questionnaire asks for.
AnalysedAnswers analysed_answers(const Manifest& manifest);

/// What is planned, as a part of an analysis plan: a paragraph with a list, ended by a line end.
/// Empty if nothing is planned.
std::string factorial_plan_text(const FactorialPlan& plan, AnalysedAnswers answers);

/// The same as a sentence for the methods section of a paper, without its full stop.
std::string factorial_sentence(const FactorialPlan& plan, AnalysedAnswers answers);

}  // namespace mien::pipeline
