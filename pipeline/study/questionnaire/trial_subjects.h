#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/separated_order.h"

namespace mien::pipeline {

/// The subjects of a questionnaire's trials, each a stimulus or a pair, in the order of the
/// manifest.
struct TrialSubjects {
  std::vector<std::vector<std::string>> stimuli;  ///< one or two ids per subject
  FactorLevels factor_levels;  ///< levels of the factors in questionnaire.no_repeats
  std::vector<std::string>
      blocks;  ///< block of each subject: level of the blocking factor, or "main"

  std::size_t size() const { return stimuli.size(); }
};

/// The subjects of a manifest. Of each factor, a pair has the level that its stimuli share or, if
/// their levels differ, a combined level.
TrialSubjects trial_subjects(const Manifest& manifest);

/// Number of analysed subjects per participant.
std::size_t subjects_per_participant(const Manifest& manifest, const TrialSubjects& subjects);

/// Indices of the subjects of each of the first `count` participants.
std::vector<std::vector<std::size_t>> participant_subjects(const Manifest& manifest,
                                                           const TrialSubjects& subjects,
                                                           std::size_t count);

}  // namespace mien::pipeline
