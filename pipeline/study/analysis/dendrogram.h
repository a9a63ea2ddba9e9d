#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/base/statistics/partition.h"
#include "pipeline/base/statistics/ward.h"

namespace mien::pipeline {

/// A name in English and Japanese; the latter may be empty.
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
  std::vector<BilingualName> leaves;    ///< names of the leaves of the linkage
  std::vector<BilingualName> clusters;  ///< names of the groups of the partition
  bool simulated = false;
};

/// A horizontal tree: one row per leaf at the left, merge heights √(2ΔE) to the right, the cut as a
/// dashed line, and each cluster in one of six colours, which repeat, with its name beside a bar.
/// The width fits an A4 page; the height grows with the number of leaves.
Plot dendrogram_plot(const Dendrogram& dendrogram);

}  // namespace mien::pipeline
