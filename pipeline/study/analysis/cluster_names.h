#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

/// Names the clusters of an analysis (analysis.h says how). Throws Error.
void name_clusters(Analysis& analysis, const ScaleSet& scales,
                   const std::vector<std::string>& given);

/// The ends of a cluster's most central scales, for a person who looks for a name: "fast, quick".
std::string central_words(const Analysis& analysis, const ScaleCluster& cluster,
                          const ScaleSet& scales, int words = 3);

}  // namespace mien::pipeline
