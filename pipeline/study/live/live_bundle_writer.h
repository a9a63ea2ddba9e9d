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

/// The choice of the manifest, without targets.
LiveChoice live_choice(const Manifest& manifest);

/// Everything that a browser needs to synthesize motions from the study's examples, equal to those
/// of a stimulus of the manifest with the interpolation and output of `choice`. Throws Error when
/// there are no examples, they cannot be blended, or a target is missing.
motion::LiveBundle live_bundle(const Manifest& manifest, Motions& motions,
                               const LiveChoice& choice);

/// A skeleton as JSON for pages: names, parents, offsets and tips of its joints.
nlohmann::ordered_json body_info(const motion::Skeleton& body);

/// What pages read first (LiveInfo of pipeline/study/page/src/live/core.ts): body, examples,
/// sliders with their texts and the mean value of the examples, targets. `primary`:
/// adjectives shown at once; empty: the scales' groups, or all where there are none.
nlohmann::ordered_json live_info(const motion::LiveBundle& bundle, const ScaleSet& scales,
                                 const std::vector<std::string>& primary);

}  // namespace mien::pipeline
