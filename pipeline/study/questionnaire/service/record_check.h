#pragma once

#include "pipeline/study/live/live_motions.h"
#include "pipeline/study/questionnaire/service/matching_record.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// Throws RecordFault if the page of this session cannot have sent the record: unknown, missing or
/// repeated items, invalid values, or media other than those of the trial.
void check_record(const QuestionnaireFacts& facts, const SessionPlan& plan,
                  const PageRecord& record);

/// The trial of a record such as "trial-7"; nullptr for other records.
const Trial* trial_of(const SessionPlan& plan, const std::string& record_name);

inline constexpr char consent_record[] = "consent";
inline constexpr char screening_record[] = "screening";
inline constexpr char demographics_record[] = "demographics";
inline constexpr char ending_record[] = "ending";

/// Whether a record refuses consent.
bool is_refusal(const PageRecord& record);

/// Recomputes D of the first guess and of the final setting on the server. Throws RecordFault if
/// the record states other values, so that a page cannot claim a better match, or if the motion of
/// a setting cannot be synthesized.
void check_distances(LiveMotions& live, const Trial& trial, const MatchingRecord& record);

}  // namespace mien::pipeline
