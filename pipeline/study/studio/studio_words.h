#pragma once

#include <nlohmann/json.hpp>

#include "pipeline/study/studio/manifest_file.h"

namespace mien::pipeline {

/// What a page offers beside examples and sliders: "sets" of examples, "recipes" (of the manifest,
/// and what they do), "posture" (units and what they turn), "scenes", "cameras", "figures"
/// and, of these, "bodies", which have a surface.
nlohmann::ordered_json studio_words(const ManifestFile& file);

}  // namespace mien::pipeline
