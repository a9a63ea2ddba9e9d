#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// What the page of a questionnaire shows (page/src/questionnaire/experiment.ts): texts, settings,
/// scales in the questionnaire's language, media by their tokens, and all sessions. `media` holds
/// every stimulus of the plans; their files are named "media/<token><ending>".
///
/// "stimuli" maps tokens to stimuli; a server does not send it to participants. "design" is the
/// design_hash.
nlohmann::ordered_json experiment_json(const Manifest& manifest,
                                       const std::vector<SessionPlan>& plans,
                                       const MediaFiles& media);

/// The paragraphs of a text, separated by blank lines; lines within a paragraph are joined.
std::vector<std::string> paragraphs_of(std::string_view text, InterfaceLanguage language);

/// The questions about participants, as the page reads them.
nlohmann::ordered_json demographics_json(const std::vector<Demographic>& demographics);

}  // namespace mien::pipeline
