#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/trial_subjects.h"

namespace mien::pipeline {

/// A place in the main part of a session.
struct MainTrial {
  std::size_t subject = 0;
  bool warm_up = false;
  bool repeated = false;  ///< shown the second time
};

/// The order in which participant `index` sees his share, with the warm-up before and the repeated
/// ones within. Throws Error when no order keeps apart what has to be apart.
std::vector<MainTrial> main_part(const Manifest& manifest, const TrialSubjects& subjects,
                                 const std::vector<std::size_t>& share, int index);

}  // namespace mien::pipeline
