#pragma once

#include "pipeline/study/live/live_motions.h"
#include "pipeline/study/questionnaire/service/matching_record.h"

namespace mien::pipeline {

/// Throws RecordFault when a distance that the record tells, of the guess or of the last setting,
/// is not the one that these sliders have: nobody can send a better match than was made.
void check_distances(LiveMotions& live, const Trial& trial, const MatchingRecord& record);

}  // namespace mien::pipeline
