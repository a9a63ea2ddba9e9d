#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// The content of a questionnaire's page (page/src/questionnaire/experiment.ts): texts, settings,
/// scales in the first language offered, what is different in others, media by token, and all
/// sessions. `media` must contain every stimulus of the plans; the files are named
/// "media/<token><ending>".
///
/// The member "stimuli" maps tokens to stimuli; a server does not send it to participants. "design"
/// is the design_hash.
nlohmann::ordered_json experiment_json(const Manifest& manifest,
                                       const std::vector<SessionPlan>& plans,
                                       const MediaFiles& media);

/// Adds "languages", what the page shows instead in each of the languages between which browsers
/// choose, and "page_texts", the study's own texts of pages by language. `in_language` makes the
/// experiment in one of these languages. Answers to questions about the participant are recorded as
/// they are in the first language: in the others, "values" states them.
void add_languages(nlohmann::ordered_json& experiment, const PageLanguage& language,
                   const OwnTexts& own,
                   const std::function<nlohmann::ordered_json(const std::string&)>& in_language);

/// The paragraphs of a text, separated by blank lines; lines within a paragraph are joined.
std::vector<std::string> paragraphs_of(std::string_view text, std::string_view language);

/// The demographic questions as JSON for the page.
nlohmann::ordered_json demographics_json(const std::vector<Demographic>& demographics);

}  // namespace mien::pipeline
