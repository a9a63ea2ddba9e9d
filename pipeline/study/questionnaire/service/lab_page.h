#pragma once

#include <optional>

#include "pipeline/study/questionnaire/service/study_sessions.h"
#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// What the experimenter's page and its exports are: the page itself (""), its parts, status.json
/// (with what troubles the server), answers.csv (of a matching
/// experiment trials.csv and changes.csv), answers.json, participants.csv and links.csv.
/// Nothing for other names. The path has three parts, the last of which is the name.
std::optional<HttpResponse> lab_answer(const HttpRequest& request, const ServedStudy& study,
                                       const StudySessions& sessions, const std::string& trouble,
                                       std::int64_t now);

}  // namespace mien::pipeline
