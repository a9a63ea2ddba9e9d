#pragma once

#include <map>
#include <string>

#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

/// A scales file (pipeline/manifest/ratings/scales/scales.h) that reads back as the same set.
/// `head` are lines of comment without their "# "; `remarks` are put behind scales, by id.
std::string to_yaml(const ScaleSet& set, const std::string& head,
                    const std::map<std::string, std::string>& remarks = {});

/// The scales of a study with the clusters of its analysis as groups, for `scales:` in a manifest.
/// Scales that were removed stay, because answers name them, with a remark why.
std::string clusters_yaml(const Analysis& analysis, const ScaleSet& scales);

/// The 41 built-in adjective pairs as a scales file, the clusters of Table 2 as groups.
std::string adjective_pairs_yaml();

}  // namespace mien::pipeline
