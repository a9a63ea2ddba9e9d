#pragma once

#include <string>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/manifest/screening.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

// The record of the screening, the first page after consent, and what it decides.

/// Why a participant is turned away.
enum class ScreeningFault { none, answer, window, refresh_hz, quota };

inline constexpr Words<ScreeningFault> screening_fault_words = {
    {"none", ScreeningFault::none},
    {"answer", ScreeningFault::answer},
    {"window", ScreeningFault::window},
    {"refresh_hz", ScreeningFault::refresh_hz},
    {"quota", ScreeningFault::quota}};

/// The screening in experiment.json. Throws nlohmann::json::exception for JSON of another form.
Screening screening_of(const nlohmann::ordered_json& experiment);

/// The same in the form that participants may see: without the answers that are accepted and
/// without quotas.
nlohmann::ordered_json public_screening(const nlohmann::ordered_json& screening);

/// Its questions, all of which must be answered.
std::vector<DemographicQuestion> questions_of(const Screening& screening);

/// Why this record turns the participant away, without regard to quotas: first the measured window
/// and refresh rate, then the answers. A refresh rate that could not be measured is accepted.
ScreeningFault screening_fault(const Screening& screening, const PageRecord& record);

/// Whether a participant with these answers counts for the quota.
bool counts_for(const Quota& quota, const std::vector<ItemResponse>& answers);

}  // namespace mien::pipeline
