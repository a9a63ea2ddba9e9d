#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// The answers about one stimulus on one scale, for a panel of the grid.
struct RatingPanel {
  std::vector<int> counts;  ///< number of answers by scale point; empty: not rated
  double mean = 0.0;        ///< 0 at the low end … 1 at the high end
  double low = 0.0;         ///< lower limit of the mean's interval; NaN if there is none
  double high = 0.0;        ///< upper limit of the interval
  bool is_marked = false;   ///< an end of the scale is the stimulus's intended emotion
};

struct RatingRow {
  std::string name;
  std::string note;  ///< small text below the name
  std::vector<RatingPanel> panels;
};

/// The ends of a scale, shown as the heading of a column.
struct RatingColumn {
  std::string low;
  std::string high;
};

/// A grid with one row per stimulus and one column per scale.
struct RatingGrid {
  std::string title;
  std::string words;  ///< subtitle
  std::vector<RatingColumn> columns;
  std::vector<RatingRow> rows;
  bool simulated = false;
};

/// A grid of histograms with a common vertical axis, with the mean as a line.
Plot histogram_grid_plot(const RatingGrid& grid);

/// A grid of means as points with their intervals.
Plot mean_grid_plot(const RatingGrid& grid);

}  // namespace mien::pipeline
