#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/live/live_bundle.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// A body as pages read it: names, parents, offsets and tips of its joints.
nlohmann::ordered_json body_info(const motion::Skeleton& body);

/// What pages read first (LiveInfo of pipeline/study/page/src/live/core.ts): body, examples,
/// sliders with their texts and where the examples lie on the average, targets. `primary`:
/// adjectives shown at once; empty: the scales' groups, or all where there are none.
nlohmann::ordered_json live_info(const motion::LiveBundle& bundle, const ScaleSet& scales,
                                 const std::vector<std::string>& primary);

}  // namespace mien::pipeline
