#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/live/live_motions.h"
#include "pipeline/study/page/served_page.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/service/record.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// A video, or a clip that is turned.
struct ServedMedia {
  std::filesystem::path file;
  std::string type;
};

/// All that is served of a study. Requests name media by tokens and pages by names; no file is
/// sought by what a request says.
struct ServedStudy {
  nlohmann::ordered_json experiment;         ///< experiment.json, with all sessions
  std::vector<SessionPlan> plans;            ///< of the same sessions, in the same order
  std::map<std::string, ServedMedia> media;  ///< by token
  std::map<std::string, ServedFile> page;    ///< by name; "index.html" is the page itself
  std::map<std::string, ServedFile> lab;     ///< the laboratory's page, likewise
  AskedFacts facts;                          ///< of `experiment`
  std::unique_ptr<LiveMotions> live;         ///< of a matching experiment: what its sliders make
};

/// A study that has been made, to be served with the pages of that folder (page_bundle).
ServedStudy served_study(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                         const MediaFiles& media, const std::filesystem::path& pages);

/// A hash of what participants are shown: other videos are another study.
Hash media_hash(const ServedStudy& study);

/// What was given in a session already.
struct GivenAlready {
  std::vector<std::string> kept;  ///< names of records
  std::string browser;            ///< that gave them
  bool has_refused = false;
};

/// What one participant's page is given: experiment.json of one session, without what tells the
/// conditions or belongs to others.
std::string session_json(const ServedStudy& study, int plan, const std::string& participant,
                         const GivenAlready& given);

/// What a page is given that asks for consent before there is a session: the texts alone.
std::string joining_json(const ServedStudy& study);

}  // namespace mien::pipeline
