#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/separated_order.h"

namespace mien::pipeline {

/// The subjects of a questionnaire's trials, each a stimulus, a pair or a set, in the order of
/// questionnaire_subjects. Sets are an incomplete block design of the stimuli (incomplete_blocks).
struct TrialSubjects {
  std::vector<std::vector<std::string>> stimuli;  ///< ids of each subject
  FactorLevels factor_levels;  ///< levels of the factors in questionnaire.no_repeats
  std::vector<std::string>
      blocks;  ///< block of each subject: level of the blocking factor, or "main"
  /// Of detection, whether each subject is a signal trial; otherwise empty.
  std::vector<bool> is_signal;

  std::size_t size() const { return stimuli.size(); }
};

/// The subjects of a manifest. Of each factor, a pair or set has the level that its stimuli share
/// or, if their levels differ, a combined level.
TrialSubjects trial_subjects(const Manifest& manifest);

/// Number of analysed subjects per participant.
std::size_t subjects_per_participant(const Manifest& manifest, const TrialSubjects& subjects);

/// Indices of the subjects of each of the first `count` participants. Each participant has signal
/// and noise trials about in proportion to the numbers of such subjects.
std::vector<std::vector<std::size_t>> participant_subjects(const Manifest& manifest,
                                                           const TrialSubjects& subjects,
                                                           std::size_t count);

/// What the first participants rate, stimulus by stimulus: of grids, each stimulus of their sets.
struct RatedStimuli {
  std::vector<std::string> ids;                  ///< in the order of the subjects, each once
  std::vector<std::vector<std::size_t>> shares;  ///< of each participant, indices into `ids`
};

/// Of questionnaires that ask for ratings of stimuli: single ones or those of a grid.
RatedStimuli rated_stimuli(const Manifest& manifest, const TrialSubjects& subjects,
                           std::size_t participants);

}  // namespace mien::pipeline
