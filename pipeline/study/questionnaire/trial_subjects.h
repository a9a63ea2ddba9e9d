#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/apart.h"

namespace mien::pipeline {

/// What the trials of a questionnaire are about, in the order of the manifest: a stimulus each, or
/// a pair.
struct TrialSubjects {
  std::vector<std::vector<std::string>> stimuli;  ///< one or two ids
  Likeness likeness;                              ///< in the factors of `no_repeats`
  std::vector<std::string> blocks;  ///< level of the blocking factor of each; else "main"

  std::size_t size() const { return stimuli.size(); }
};

/// A pair has a level where its stimuli have it both, and else one of its own made of the two.
TrialSubjects trial_subjects(const Manifest& manifest);

/// How many of them one participant sees that are analysed.
std::size_t subjects_per_participant(const Manifest& manifest, const TrialSubjects& subjects);

/// Which subjects the first `count` participants see.
std::vector<std::vector<std::size_t>> shares(const Manifest& manifest,
                                             const TrialSubjects& subjects, std::size_t count);

}  // namespace mien::pipeline
