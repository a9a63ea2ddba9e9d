#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/regression/regression.h"

namespace mien::pipeline {

/// For a terminal: groups by cause, then what differs, then a line that sums up.
std::string plain_text(const Regression& regression);

/// For a pull request: the same as GitHub's Markdown.
std::string markdown_text(const Regression& regression);

/// For CI systems: JUnit's XML, a test case a stimulus and one for the gate.
std::string junit_text(const Regression& regression);

/// Everything as JSON. Lengths are metres, angles radians, times seconds.
nlohmann::ordered_json as_json(const Regression& regression);

/// "3 differ, 1 alike, 12 same"; also when a planted defect was not seen.
std::string summary_text(const Regression& regression);

/// "80 % motion: weights.sad 0.4 → 0.41 (the evidence)"
std::string cause_text(const Attribution& cause);

/// What was planted in a copy of which stimulus, and whether it was seen.
std::string gate_text(const Gate& gate);

/// What differed when everything was repeated, a line; empty unless it was.
std::string repetitions_text(const Repetitions& repetitions);

/// "adjectives.quickness 0.6 → 0.61 (motion): 3 stimuli" and the like.
std::string group_text(const CauseGroup& group);

/// How a stimulus's motion changed, in a sentence; empty when it did not.
std::string motion_text(const StimulusComparison& comparison);

/// The most important difference of a stimulus: that of its motion, or the first reason.
std::string first_words(const StimulusComparison& comparison);

/// Of which stimuli videos were made and none approved, a line; empty where there are none such.
std::string unapproved_text(const Regression& regression);

/// "NOT COMPARED, …: 2 of 3: blend, file", with a line break; empty when all were compared.
std::string not_compared_text(const Regression& regression);

/// "72 % left forearm, 20 % left hand, 8 % where nothing moved (camera, light, noise)"
std::string shares_text(const std::vector<BodyShare>& shares);

}  // namespace mien::pipeline
