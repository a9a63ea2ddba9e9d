#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/adaptive/next_pairs.h"

namespace mien::pipeline {

/// The comparisons so far in a study whose trials are pairs.
struct PairStudy {
  std::vector<std::string> stimuli;  ///< ids of those that can be compared
  std::vector<StimulusPair> pairs;   ///< those that can be asked
  std::vector<ComparedItem> items;   ///< those of `asked` with answers, in this order
  bool simulated = false;
  std::vector<std::string> notes;  ///< sentences on answers that are not used
};

/// Counts the answers of several rounds to the manifest's questionnaire, each with rows of one
/// design (collect_answers: answers that quality rules or attention checks exclude do not count).
///
/// The stimuli are those that the questionnaire names; if it lists pairs and names no stimuli,
/// those of its pairs; and those with answers. All their pairs can be asked, of stimuli with equal
/// levels of the factors in preference.alike.
///
/// Throws Faults as collect_answers, and Error if the trials are not pairs, if no answer remains or
/// if nothing can be compared.
PairStudy pair_study(const Manifest& manifest, const std::vector<std::vector<AnswerRow>>& rounds,
                     const std::vector<std::string>& asked);

/// The number of answers to each pair, or film, of the next round that the manifest plans, if it
/// asks about `count`.
double planned_answers(const Manifest& manifest, std::size_t count);

/// The manifest of the next round: that of the study so far, with a questionnaire that lists the
/// chosen pairs and names all stimuli that can be compared. `name`: of the study.
Manifest next_pair_round(const Manifest& manifest, const PairStudy& study, const NextPairs& next,
                         const std::string& name);

}  // namespace mien::pipeline
