#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/regression/regression.h"

namespace mien::pipeline {

/// Returns text for a terminal: groups by cause, then the differences, a summary line, and lines
/// about stimuli not compared, planted defects, repetitions and unapproved videos.
std::string plain_text(const Regression& regression);

/// Returns the same information in GitHub's Markdown, for a pull request, but without repetitions
/// and, for single stimuli, without causes and body parts.
std::string markdown_text(const Regression& regression);

/// Returns JUnit XML for CI systems: one test case per stimulus and one for the planted defects.
std::string junit_text(const Regression& regression);

/// Returns everything as JSON. Lengths are in metres, angles in radians, times in seconds.
nlohmann::ordered_json as_json(const Regression& regression);

/// Returns a summary, "12 same, 1 alike, 3 differ"; it also states the tolerances that were widened
/// since the approval, and if a planted defect was not detected. "alike": the changes are within
/// tolerance or noise (Verdict).
std::string summary_text(const Regression& regression);

/// Returns one cause: "80 % motion: weights.sad 0.4 → 0.41 (the evidence)".
std::string cause_text(const Attribution& cause);

/// Returns the planted defects, their stimulus, and whether they were detected.
std::string gate_text(const Gate& gate);

/// Returns a line about the differences between repetitions; empty if nothing was repeated.
std::string repetitions_text(const Repetitions& repetitions);

/// Returns one group: "adjectives.quickness 0.6 → 0.61 (motion): 3 stimuli: a, b, c".
std::string group_text(const CauseGroup& group);

/// Returns a sentence about the change of a stimulus's motion; empty if it is unchanged.
std::string motion_text(const StimulusComparison& comparison);

/// Returns the most important difference of a stimulus: that of its motion, otherwise the first
/// reason; without either, the verdict in words ("within tolerance or noise" for `same` and
/// `alike`).
std::string first_words(const StimulusComparison& comparison);

/// Returns a line that names the stimuli whose videos are not compared, because no video of the
/// stimulus was approved; empty if there is no such stimulus.
std::string unapproved_text(const Regression& regression);

/// Returns "NOT COMPARED (excluded by --only): 2 of 3: blend, file" with a line break; empty if all
/// were compared.
std::string not_compared_text(const Regression& regression);

/// Returns "72 % left forearm, 20 % left hand, 8 % without motion (camera, light, noise)".
std::string shares_text(const std::vector<BodyShare>& shares);

}  // namespace mien::pipeline
