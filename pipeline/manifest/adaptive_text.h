#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// Adaptive trials in words. The manifest must have a questionnaire with adaptive trials.

/// "7 levels of sadness (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)", from the hardest
std::string levels_text(const Manifest& manifest);

/// What counts as a positive answer, in the plural: "right answers", "answers “yes”"
std::string positive_answers_text(const TrialForm& form);

/// The rule by which levels are chosen, without its full stop.
std::string level_rule_text(const Manifest& manifest);

/// When a track ends: "40 trials", "10 reversals, or 60 trials", "the first trial with a posterior
/// standard deviation of the threshold of at most 0.05, or 60 trials"
std::string track_end_text(const AdaptiveTrialSettings& adaptive);

/// The design of the sessions in sentences: levels, tracks, rule and end.
std::vector<std::string> adaptive_sentences(const Manifest& manifest);

/// What is planned, as a part of an analysis plan: a paragraph, ended by a line end. Empty if
/// trials are not adaptive.
std::string adaptive_plan_text(const Manifest& manifest);

/// How thresholds are determined from the answers, for a present or past report, without a full
/// stop. `was`: "is" or "was".
std::vector<std::string> threshold_sentences(const Manifest& manifest, const std::string& was);

}  // namespace mien::pipeline
