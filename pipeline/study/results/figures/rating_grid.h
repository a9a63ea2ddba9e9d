#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A small picture of the answers about one stimulus on one scale.
struct RatingPanel {
  std::vector<int> counts;  ///< by point of the scale; empty: not rated
  double mean = 0.0;        ///< 0 at the low end … 1 at the high end
  double low = 0.0;         ///< of its interval; NaN for none
  double high = 0.0;
  bool is_marked = false;  ///< the scale has the stimulus's intended emotion
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

/// Histograms of answers with a common vertical scale, and the mean as a line.
Plot histogram_grid_plot(const RatingGrid& grid);

/// Means as points with their intervals.
Plot mean_grid_plot(const RatingGrid& grid);

}  // namespace mien::pipeline
