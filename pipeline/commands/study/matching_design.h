#pragma once

#include <filesystem>

#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/matching/experiment/matching_study.h"

namespace mien::pipeline {

struct MatchingDesign {
  int participants = 0;         ///< 0: as planned
  std::filesystem::path plans;  ///< CSV to write; empty: standard output
};

/// Lays out the sessions of a matching experiment and tells how evenly, and how long they take.
int design_matching(const Manifest& manifest, const MatchingDesign& design, const Console& console);

/// Warns of trials in which nothing would have to be done.
void tell_matched_at_start(const Manifest& manifest, const MatchingStudy& study,
                           const Console& console);

}  // namespace mien::pipeline
