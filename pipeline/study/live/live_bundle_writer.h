#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/live/live_bundle.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Which of a study's motions a live bundle contains.
struct LiveChoice {
  std::vector<std::string> targets;  ///< stimulus ids
  Interpolation interpolation;       ///< of what sliders make
  Output output;                     ///< its frame rate, and how often and where a clip shows it
  std::vector<std::string>
      primary;  ///< adjectives shown at once; empty: the scales' groups, or all
};

/// As the manifest has it, without targets.
LiveChoice live_choice(const Manifest& manifest);

/// What a browser needs to make motions of the study's examples: the same as a stimulus of the
/// manifest with the choice's interpolation and output would have. Throws Error when the examples
/// cannot be blended, there are none, or there is no such stimulus.
motion::LiveBundle live_bundle(const Manifest& manifest, Motions& motions,
                               const LiveChoice& choice);

/// A body as pages read it: names, parents, offsets and tips of its joints.
nlohmann::ordered_json body_info(const motion::Skeleton& body);

/// What pages read first (LiveInfo of pipeline/study/page/src/live/core.ts): body, examples,
/// sliders with their texts and where the examples lie on the average, targets. `primary`:
/// adjectives shown at once; empty: the scales' groups, or all where there are none.
nlohmann::ordered_json live_info(const motion::LiveBundle& bundle, const ScaleSet& scales,
                                 const std::vector<std::string>& primary);

}  // namespace mien::pipeline
