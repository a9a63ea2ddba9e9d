#pragma once

#include <optional>
#include <string>

#include "pipeline/study/questionnaire/service/study_sessions.h"
#include "pipeline/study/server/http_message.h"

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

/// What the experimenter's page and its exports are: the page itself (""), its parts, status.json
/// (with what troubles the server), answers.csv (of a matching
/// experiment trials.csv and changes.csv), answers.json, participants.csv and links.csv.
/// Nothing for other names. The path has three parts, the last of which is the name.
std::optional<HttpResponse> lab_answer(const HttpRequest& request, const ServedStudy& study,
                                       const StudySessions& sessions, const std::string& trouble,
                                       std::int64_t now);

}  // namespace mien::pipeline
