#pragma once

#include <optional>
#include <string>

#include "pipeline/study/questionnaire/service/study_sessions.h"
#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

// Exports of the records of a served study.

/// CSV with a row for each answer (answer_row.h), sorted by participant and trial.
std::string answers_csv(const ServedStudy& study, const StudySessions& sessions);

/// CSV with a row for each sample of the traces of continuous trials (trace_table.h).
std::string traces_csv(const ServedStudy& study, const StudySessions& sessions);

/// CSV of the trials of a matching experiment, and of the changes made in them (matching_rows.h).
std::string trials_csv(const ServedStudy& study, const StudySessions& sessions);
std::string changes_csv(const ServedStudy& study, const StudySessions& sessions);

/// CSV of the answers to steps of an adaptive experiment (chain_rows.h), those of withdrawn
/// participants last and without them.
std::string steps_csv(const ServedStudy& study, const StudySessions& sessions);

/// CSV with a row for each participant who gave consent (participant_row.h).
std::string participants_csv(const ServedStudy& study, const StudySessions& sessions);

/// All plans and records as JSON, with the time at which each record was stored.
std::string answers_json(const ServedStudy& study, const StudySessions& sessions);

/// CSV of participants and their links. `base` is the server's address: "http://127.0.0.1:8080".
std::string links_csv(const StudySessions& sessions, const std::string& base);

/// The response to a request for the experimenter's page (""), its files, status.json (with
/// `last_failure`, the server's last storage failure), answers.csv (or, in a matching experiment,
/// trials.csv and changes.csv, and in an adaptive experiment steps.csv), answers.json,
/// participants.csv or links.csv. Nullopt for other names. The request's path must have three
/// segments, of which the last is the name. `now` is in seconds since 1970.
std::optional<HttpResponse> lab_answer(const HttpRequest& request, const ServedStudy& study,
                                       const StudySessions& sessions,
                                       const std::string& last_failure, std::int64_t now);

}  // namespace mien::pipeline
