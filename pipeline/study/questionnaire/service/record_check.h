#pragma once

#include "pipeline/study/live/live_motions.h"
#include "pipeline/study/questionnaire/service/matching_record.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// Throws RecordFault when a record is not what its page in this session can give: another's items,
/// items left out or given twice, values that cannot be chosen, media that was not shown.
void check_record(const AskedFacts& facts, const SessionPlan& plan, const PageRecord& record);

/// The trial of "trial-7", or nullptr.
const Trial* trial_of(const SessionPlan& plan, const std::string& record_name);

inline constexpr char consent_record[] = "consent";
inline constexpr char demographics_record[] = "demographics";
inline constexpr char ending_record[] = "ending";

/// Whether a record of the consent says no.
bool is_refusal(const PageRecord& record);

/// Throws RecordFault when a distance that the record tells, of the guess or of the last setting,
/// is not the one that these sliders have: nobody can send a better match than was made.
void check_distances(LiveMotions& live, const Trial& trial, const MatchingRecord& record);

}  // namespace mien::pipeline
