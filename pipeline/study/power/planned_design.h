#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/analysis_of_variance.h"
#include "pipeline/manifest/factor_crossing.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// A contrast of cells that is planned (PlannedContrast), with stimuli as indices into
/// PlannedDesign::stimuli.
struct DesignContrast {
  std::string name;
  std::vector<double> weights;                  ///< of each cell, divided by the number of settings
  std::vector<std::vector<std::size_t>> cells;  ///< stimuli of each cell
  std::vector<bool> scales;                     ///< whether it is tested on each scale
};

/// What a study's participants rate, and the planned tests of the ratings.
struct PlannedDesign {
  std::vector<std::string> stimuli;  ///< ids of the rated stimuli
  std::vector<Scale> scales;         ///< those that are asked
  FactorTable factors;               ///< levels of each of `stimuli`
  Crossing crossing;  ///< of the analysis of variance; its cells have indices into `stimuli`
  std::vector<VarianceTerm> terms;   ///< the effects that the analysis of variance tests
  std::vector<std::string> effects;  ///< their names
  std::vector<DesignContrast> contrasts;
  /// Indices of the stimuli that each participant rates, for the largest number of participants.
  std::vector<std::vector<std::size_t>> shares;
  std::vector<std::size_t> groups;  ///< group of each participant; empty without groups
  std::size_t group_count = 1;
  bool is_complete = false;  ///< each participant rates every stimulus

  /// Levels of the crossing's factors.
  std::vector<int> levels() const;
};

/// The design of a manifest with a questionnaire of ratings, for so many participants. If groups
/// are compared (FactorialPlan::between), `group_shares` gives their relative sizes; empty: two of
/// the same size. Throws Error for other trials, or if no effect and no contrast can be tested.
PlannedDesign planned_design(const Manifest& manifest, std::size_t participants,
                             const std::vector<double>& group_shares);

}  // namespace mien::pipeline
