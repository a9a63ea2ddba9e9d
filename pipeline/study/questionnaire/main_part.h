#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/trial_subjects.h"

namespace mien::pipeline {

/// A trial of the main part of a session.
struct MainTrial {
  std::size_t subject = 0;  ///< index into TrialSubjects
  bool warm_up = false;
  bool repeated = false;  ///< a repetition of an earlier trial
};

/// The main part for participant `index`: warm-up trials, then the subjects of `share` in the order
/// that `questionnaire.order` determines, with repetitions inserted. Throws Error if no order
/// satisfies `questionnaire.no_repeats` or `questionnaire.retest.repeat`, or if there are too few
/// stimuli for the warm-up. `round`, from 0: in continuous trials, the main part is gone through
/// once for each scale, in another order each time unless the order is fixed.
std::vector<MainTrial> main_part(const Manifest& manifest, const TrialSubjects& subjects,
                                 const std::vector<std::size_t>& share, int index, int round = 0);

}  // namespace mien::pipeline
