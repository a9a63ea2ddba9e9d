#pragma once

#include <string>
#include <vector>

#include "pipeline/production/archive/pack.h"

namespace mien::pipeline {

/// The stimuli of a BIDS dataset: files to be packed, and videos that have no place there.
struct BidsStimuli {
  std::vector<PayloadFile> files;    ///< sorted by path
  int videos = 0;                    ///< number of videos among them
  std::vector<std::string> omitted;  ///< paths of the others
};

/// Lays out a study's videos as the stimuli of a BIDS dataset, after the proposal BEP044
/// (Stim-BIDS, github.com/bids-standard/bids-specification/pull/2022; a draft of November 2026):
///
///   stimuli/stimuli.tsv, stimuli.json           one row a stimulus; the meaning of the columns
///   stimuli/stim-<label>_video.mp4              _audiovideo if it has sound
///   stimuli/stim-<label>_video.json             description
///
/// Labels are the ids of the stimuli without other characters than letters and digits; a number is
/// appended to those that would be equal in lower case, first to ids with other characters. Of
/// several videos of a stimulus with the same extension, the first in the order of their paths is
/// taken; animated pictures are omitted because the proposal has no place for them. `licence` is
/// stated in stimuli.tsv unless it is empty. Videos that are not in `payload` or that the study did
/// not make are ignored. Throws Error if metrics/stimuli.csv or a film's record is damaged.
BidsStimuli bids_stimuli(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                         const std::string& licence);

}  // namespace mien::pipeline
