#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A small picture of the answers about one stimulus on one scale.
struct RatingPanel {
  std::vector<int> counts;  ///< by place on the scale; empty: was not asked
  double mean = 0.0;        ///< 0 at the low end … 1 at the high end
  double low = 0.0;         ///< of its interval; NaN for none
  double high = 0.0;
  bool is_marked = false;  ///< an emotion that was meant lies on this scale
};

struct RatingRow {
  std::string name;
  std::string note;  ///< under the name
  std::vector<RatingPanel> panels;
};

/// A scale at the head of a column.
struct RatingColumn {
  std::string low;
  std::string high;
};

/// Stimuli below each other, scales beside each other.
struct RatingGrid {
  std::string title;
  std::string words;  ///< under the title
  std::vector<RatingColumn> columns;
  std::vector<RatingRow> rows;
  bool simulated = false;
};

/// How the answers are spread: a histogram each, all with the same height for the same share, and
/// the mean as a line.
Plot histogram_grid_plot(const RatingGrid& grid);

/// Where they lie: a point for the mean with its interval.
Plot mean_grid_plot(const RatingGrid& grid);

}  // namespace mien::pipeline
