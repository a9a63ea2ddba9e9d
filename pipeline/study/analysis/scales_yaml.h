#pragma once

#include <map>
#include <string>

#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

/// The text of a scales file (pipeline/manifest/ratings/scales/scales.h) that reads back as the
/// same set. `head` has the lines of the leading comment, without "# "; `remarks` are comments
/// written after scales, by scale id.
std::string to_yaml(const ScaleSet& set, const std::string& head,
                    const std::map<std::string, std::string>& remarks = {});

/// The scales of a study as a scales file for `scales:` in a manifest, with the clusters of its
/// analysis as groups. It also contains the scales without answers and those that the thresholds
/// exclude, each with a comment that gives the reason.
std::string clusters_yaml(const Analysis& analysis, const ScaleSet& scales);

/// The 41 built-in adjective pairs as a scales file, the clusters of Table 2 as groups.
std::string adjective_pairs_yaml();

}  // namespace mien::pipeline
