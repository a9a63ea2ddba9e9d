#pragma once

#include <string>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/manifest/screening.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

// The record of the screening, the first page after consent, and what it decides.

/// Why a participant is turned away.
enum class ScreeningFault { none, answer, window, refresh_hz, sound, quota };

inline constexpr Words<ScreeningFault> screening_fault_words = {
    {"none", ScreeningFault::none},     {"answer", ScreeningFault::answer},
    {"window", ScreeningFault::window}, {"refresh_hz", ScreeningFault::refresh_hz},
    {"sound", ScreeningFault::sound},   {"quota", ScreeningFault::quota}};

/// The screening in experiment.json. Throws nlohmann::json::exception for JSON of another form.
Screening screening_of(const nlohmann::ordered_json& experiment);

/// The same in the form that participants may see: without the answers that are accepted and
/// without quotas.
nlohmann::ordered_json public_screening(const nlohmann::ordered_json& screening);

/// The counts of tones, if sound is tested: "tones_1", which must be answered, and "tones_2".
std::vector<DemographicQuestion> tone_questions_of(const Screening& screening);

/// The counts of tones and the questions, all of which must be answered.
std::vector<DemographicQuestion> questions_of(const Screening& screening);

/// The number of tones, 3 to 7, that the page plays to a browser session at an attempt, counted
/// from 1 (page/src/questionnaire/tone_count.ts): from the hash FNV-1a of "session/attempt".
int tone_count(const std::string& session, int attempt);

/// Why this record turns the participant away, without regard to quotas: first the measured window
/// and refresh rate, then the counts of tones, of which one must be right, then the answers. A
/// refresh rate that could not be measured is accepted.
ScreeningFault screening_fault(const Screening& screening, const PageRecord& record);

/// Whether a participant with these answers counts for the quota.
bool counts_for(const Quota& quota, const std::vector<ItemResponse>& answers);

}  // namespace mien::pipeline
