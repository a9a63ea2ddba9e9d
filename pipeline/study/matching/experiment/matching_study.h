#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/live/live_bundle_writer.h"
#include "pipeline/study/questionnaire/service/served_study.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A matching experiment, ready to be served, exported or simulated.
struct MatchingStudy {
  nlohmann::ordered_json experiment;  ///< what the page reads (page/src/matching/experiment.ts)
  std::vector<SessionPlan> plans;
  motion::LiveBundle bundle;
};

/// Makes the targets; nothing is drawn. Throws Error when an adjective has no rating, or the
/// examples cannot be blended.
MatchingStudy matching_study(const Manifest& manifest, Motions& motions, int participants = 0);

/// With the pages of that folder (page_bundle("matching")), and motions that the server makes.
ServedStudy served_matching(MatchingStudy study, const std::filesystem::path& pages);

}  // namespace mien::pipeline
