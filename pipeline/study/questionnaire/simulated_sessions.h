#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/questionnaire/rating_spread.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// What is true of stimuli: (stimulus, scale) → the mean of what people would answer, in the
/// scale's own range. What is not there is the middle.
using StatedTruth = std::map<std::pair<std::string, std::string>, double>;

/// Reads a CSV with the columns stimulus, scale and value. Throws Faults: stimuli and scales that
/// the questionnaire does not ask about, values outside the scale.
StatedTruth read_truth(const Manifest& manifest, const std::filesystem::path& file);

/// What simulated raters (simulated_raters.h) see in the motions, measured against each other.
/// Makes the motions. Throws Error, also for scales that they do not know.
StatedTruth measured_truth(const Manifest& manifest);

/// How people answer who are not there.
struct SimulatedPeople {
  RatingSpread spread = {.participant = 0.3, .stimulus = 0.0, .residual = 0.7};  ///< stimulus: none
  double attentive = 0.98;      ///< share of attention checks that are passed
  double seen = 0.6;            ///< share of emotion trials in which the stimulus's own is chosen
  double answer_seconds = 2.5;  ///< median of an item's
};

/// Answers to all trials of all plans: the truth, the participant's lean to one end of each scale
/// and a residual part, put onto the points that the questionnaire offers. Of a pair the one whose
/// answer would be higher. Each number depends on the plan's seed and the names alone; every row is
/// marked as simulated.
std::vector<AnswerRow> simulated_sessions(const Manifest& manifest,
                                          const std::vector<SessionPlan>& plans,
                                          const StatedTruth& truth,
                                          const SimulatedPeople& people = {});

/// Hash of all that the participants see: the plans, the texts and the settings.
std::string design_hash(const Manifest& manifest, const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
