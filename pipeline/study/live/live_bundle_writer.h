#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/live/live_bundle.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The contents of a live bundle of a study, and how its motions are synthesized.
struct LiveChoice {
  std::vector<std::string> targets;  ///< stimulus ids
  Interpolation interpolation;       ///< interpolation of motions set by sliders
  Output output;  ///< frame rate, and whether a clip repeats the motion and removes its travel
  std::vector<std::string>
      primary;  ///< adjectives shown initially; empty: the scales' groups or, without groups, all
  /// If not empty, the bundle has this example only, which need not be blendable, and no sliders.
  std::string only = {};
};

/// The manifest's settings; `targets` and `primary` are empty.
LiveChoice live_choice(const Manifest& manifest);

/// Everything that a browser needs to synthesize motions from the study's examples. The motions
/// equal those of stimuli of the manifest with the interpolation and output of `choice`. Throws
/// Error if there are no examples, if they cannot be blended, or if a target is missing.
motion::LiveBundle live_bundle(const Manifest& manifest, Motions& motions,
                               const LiveChoice& choice);

/// A skeleton as JSON for pages: names, parents, offsets and tips of its joints (metres).
nlohmann::ordered_json body_info(const motion::Skeleton& body);

/// The JSON that pages load first (LiveInfo of pipeline/study/page/src/live/core.ts): body,
/// examples, targets, sliders with their texts and the mean value of the examples, and how motions
/// are synthesized (foot locking, method, frame rate). `primary` lists the adjectives shown
/// initially; empty: the scales' groups, or all adjectives if there are no groups.
nlohmann::ordered_json live_info(const motion::LiveBundle& bundle, const ScaleSet& scales,
                                 const std::vector<std::string>& primary);

}  // namespace mien::pipeline
