#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/ratings/answers/session_end.h"
#include "pipeline/study/questionnaire/service/record.h"
#include "pipeline/study/server/session_store.h"

namespace mien::pipeline {

// Participants of recruitment services: the parameters of their links, and where they go at the end
// of their session (recruitment.h).

/// The hash that is kept instead of the value of a URL parameter: 32 hexadecimal digits, the first
/// of SHA-256 of salt, name and value, so that the same value of one study has the same hash.
std::string pseudonym_of(const std::string& salt, const std::string& name,
                         const std::string& value);

/// Replaces the values of a record's URL parameters, also in its JSON, by their hashes.
void pseudonymise(PageRecord& record, nlohmann::json& text, const std::string& salt);

/// How a session that has been completed ended: failed_attention if more attention checks than
/// allowed, not counting practice, were failed. `records` are all that were stored.
SessionEnd completed_end(const QuestionnaireFacts& facts, const SessionPlan& plan,
                         const std::vector<StoredRecord>& records);

/// The address and code of an end, from experiment.json: {"address": …, "code": …};
/// null if participants are not sent anywhere then. Where none is set for failed_attention, that of
/// completed.
nlohmann::ordered_json destination_json(const nlohmann::ordered_json& experiment, SessionEnd end);

/// The recruitment in experiment.json as participants may see it beforehand: without codes and
/// addresses of ends that they have yet to reach.
nlohmann::ordered_json public_recruitment(const nlohmann::ordered_json& recruitment);

}  // namespace mien::pipeline
