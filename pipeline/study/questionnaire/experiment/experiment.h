#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// The content of a questionnaire's page (page/src/questionnaire/experiment.ts): texts, settings,
/// scales in the questionnaire's language, media by token, and all sessions. `media` must contain
/// every stimulus of the plans; the files are named "media/<token><ending>".
///
/// The member "stimuli" maps tokens to stimuli; a server does not send it to participants. "design"
/// is the design_hash.
nlohmann::ordered_json experiment_json(const Manifest& manifest,
                                       const std::vector<SessionPlan>& plans,
                                       const MediaFiles& media);

/// The paragraphs of a text, separated by blank lines; lines within a paragraph are joined.
std::vector<std::string> paragraphs_of(std::string_view text, InterfaceLanguage language);

/// The demographic questions as JSON for the page.
nlohmann::ordered_json demographics_json(const std::vector<Demographic>& demographics);

}  // namespace mien::pipeline
