#include "pipeline/study/questionnaire/service/track_check.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/service/record_check.h"

namespace mien::pipeline {

namespace {

/// The answer in a record of an adaptive trial; nullopt if it has none.
std::optional<TrackAnswer> answer_in(const Trial& trial, const PageRecord& record) {
  if (!record.level || record.responses.empty() || !record.measured.play_fault.empty())
    return std::nullopt;
  return TrackAnswer{static_cast<std::size_t>(*record.level),
                     record.responses.front().value_raw == trial.adaptive.positive};
}

}  // namespace

std::vector<TrackAnswer> track_answers(const SessionPlan& plan, const Trial& trial,
                                       const std::vector<PageRecord>& earlier) {
  std::vector<TrackAnswer> answers;
  for (const Trial& other : plan.trials) {
    if (other.adaptive.track != trial.adaptive.track || other.number >= trial.number) continue;
    const auto record =
        std::ranges::find(earlier, fmt::format("trial-{}", other.number), &PageRecord::name);
    if (record == earlier.end()) continue;
    if (const auto answer = answer_in(other, *record)) answers.push_back(*answer);
  }
  return answers;
}

void check_level_shown(const QuestionnaireFacts& facts, const SessionPlan& plan,
                       const PageRecord& record, const std::vector<PageRecord>& earlier) {
  const Trial* trial = trial_of(plan, record.name);
  if (trial == nullptr || !trial->is_adaptive() || !facts.tracks) return;
  const TrackLevels levels(*facts.tracks);
  const std::vector<TrackAnswer> answers = track_answers(plan, *trial, earlier);
  if (!levels.permits_end(answers, record.is_track_ended))
    throw RecordFault(record.is_track_ended ? "the track of this trial has not ended"
                                            : "the track of this trial has ended");
  if (!record.is_track_ended &&
      !levels.permits(answers, static_cast<std::size_t>(record.level.value_or(0))))
    throw RecordFault("the level shown does not follow from the answers so far");
}

nlohmann::ordered_json answered_levels_json(const SessionPlan& plan,
                                            const std::vector<PageRecord>& stored) {
  nlohmann::ordered_json answered = nlohmann::ordered_json::object();
  for (const PageRecord& record : stored) {
    const Trial* trial = trial_of(plan, record.name);
    if (trial == nullptr || !trial->is_adaptive()) continue;
    if (const auto answer = answer_in(*trial, record))
      answered[record.name] = {{"place", answer->place}, {"positive", answer->is_positive}};
  }
  return answered;
}

}  // namespace mien::pipeline
