#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
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

/// A video or a 3-D clip.
struct ServedMedia {
  std::filesystem::path file;
  std::string type;
};

/// A study with everything that a server needs. Requests name media by tokens and pages by names,
/// which are looked up in these maps, never in the file system.
struct ServedStudy {
  nlohmann::ordered_json experiment;         ///< experiment.json, with all sessions
  std::vector<SessionPlan> plans;            ///< plans of these sessions, in the same order
  std::map<std::string, ServedMedia> media;  ///< by token
  std::map<std::string, ServedFile> page;    ///< by name; "index.html" is the page itself
  std::map<std::string, ServedFile> lab;     ///< the experimenter's page, by name
  QuestionnaireFacts facts;                  ///< read from `experiment`
  /// Address at which participants reach the server, without a slash at its end; empty: the one at
  /// which the experimenter's page was asked for.
  std::string public_url;
  std::unique_ptr<LiveMotions>
      live;  ///< synthesizes the motions of a matching experiment; else null
};

/// A study with its media, to be served with the pages in the folder `pages` (page_bundle).
ServedStudy served_study(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                         const MediaFiles& media, const std::filesystem::path& pages);

/// A hash of the media (in a matching experiment, of the motions), by which a session store detects
/// that they have changed.
Hash media_hash(const ServedStudy& study);

/// The progress of a session.
struct SessionProgress {
  std::vector<std::string> stored;  ///< names of the stored records
  std::string browser;              ///< the browser session that sent them
  std::optional<SessionEnd> ended;  ///< the session ended early
  /// Where the participant is sent to (recruited_participants.h); null: nowhere, or not yet.
  nlohmann::ordered_json destination = nullptr;
  /// Of adaptive trials: answered_levels_json; null in other studies.
  nlohmann::ordered_json answered = nullptr;
};

/// experiment.json for one participant's page, with only the session of this participant (which
/// follows the plan with index `plan`) and its media, and without the member "stimuli", the
/// answers that the screening accepts, and the codes of ends that have not been reached.
std::string session_json(const ServedStudy& study, int plan, const std::string& participant,
                         const SessionProgress& progress);

/// experiment.json for the page that asks for consent before a session is assigned: with one
/// session, which has no trials, and without media and stimuli. `has_enough`: nobody new can begin.
std::string joining_json(const ServedStudy& study, bool has_enough);

}  // namespace mien::pipeline
