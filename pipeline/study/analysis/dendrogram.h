#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/base/statistics/partition.h"
#include "pipeline/base/statistics/ward.h"

namespace mien::pipeline {

/// English and Japanese; the latter may be empty.
struct BilingualName {
  std::string english;
  std::string japanese;
};

/// The contents of a dendrogram.
struct Dendrogram {
  std::string title;
  std::string subtitle;
  Linkage linkage;
  Partition partition;                  ///< a cut of the linkage
  std::vector<BilingualName> leaves;    ///< of the linkage
  std::vector<BilingualName> clusters;  ///< of the partition
  bool simulated = false;
};

/// A horizontal tree: leaves in rows at the left, heights √(2ΔE) to the right, the cut as
/// a broken line, each cluster in a colour of its own with its name beside a bracket. As wide as an
/// A4 page's text, as high as it has leaves.
Plot dendrogram_plot(const Dendrogram& dendrogram);

}  // namespace mien::pipeline
