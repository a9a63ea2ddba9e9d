#pragma once

#include <string>

#include "pipeline/study/questionnaire/service/study_sessions.h"

namespace mien::pipeline {

// What a served study has collected, from its store.

/// One row an answer (answer_row.h), by participant and trial.
std::string answers_csv(const ServedStudy& study, const StudySessions& sessions);

/// Trials of a matching experiment, and what was done in them (matching_rows.h).
std::string trials_csv(const ServedStudy& study, const StudySessions& sessions);
std::string changes_csv(const ServedStudy& study, const StudySessions& sessions);

/// One row a participant who has agreed to take part (participant_row.h).
std::string participants_csv(const ServedStudy& study, const StudySessions& sessions);

/// Everything, with the plans, the records as they were given and when each was kept.
std::string answers_json(const ServedStudy& study, const StudySessions& sessions);

/// Participants and their links below `base`: "http://127.0.0.1:8080".
std::string links_csv(const StudySessions& sessions, const std::string& base);

}  // namespace mien::pipeline
