#pragma once

#include <filesystem>

#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/matching/experiment/matching_study.h"

namespace mien::pipeline {

struct MatchingDesign {
  int participants = 0;         ///< 0: the number planned in the manifest
  std::filesystem::path plans;  ///< CSV to write; empty: standard output
};

/// Plans the sessions of a matching experiment, writes the plans, and prints their balance and
/// duration. Returns the exit code.
int design_matching(const Manifest& manifest, const MatchingDesign& design, const Console& console);

/// Warns about trials in which the initial motion already matches the target.
void warn_of_matched_at_start(const Manifest& manifest, const MatchingStudy& study,
                              const Console& console);

}  // namespace mien::pipeline
