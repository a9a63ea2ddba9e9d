#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

/// The video in which an end of a scale is seen most, among those of a setting.
struct BestSeen {
  std::string setting;
  std::string end;       ///< "sad"
  bool is_high = false;  ///< of its scale
  Comparison comparison;
  bool is_found = false;  ///< towards the end, and its paired test below alpha after the correction
};

/// By setting and end: whose answers lie farthest towards the end from the persons' other videos.
std::vector<BestSeen> best_seen(const Gathered& gathered,
                                const std::vector<Comparison>& comparisons);

}  // namespace mien::pipeline
