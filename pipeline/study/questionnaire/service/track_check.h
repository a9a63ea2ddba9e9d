#pragma once

#include <vector>

#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// The answers of a trial's track before this trial, from records of its session in any order.
/// Trials that were left out are not among them.
std::vector<TrackAnswer> track_answers(const SessionPlan& plan, const Trial& trial,
                                       const std::vector<PageRecord>& earlier);

/// Throws RecordFault if an adaptive trial was shown at another level than the one that follows
/// from the earlier records of its session (TrackLevels::permits), or was left out although its
/// track has not ended. Other trials are not checked.
void check_level_shown(const QuestionnaireFacts& facts, const SessionPlan& plan,
                       const PageRecord& record, const std::vector<PageRecord>& earlier);

/// What a page that is opened again needs of the stored answers to adaptive trials: the name of
/// each record → its level and whether it was positive.
nlohmann::ordered_json answered_levels_json(const SessionPlan& plan,
                                            const std::vector<PageRecord>& stored);

}  // namespace mien::pipeline
