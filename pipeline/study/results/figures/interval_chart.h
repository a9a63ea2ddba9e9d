#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/base/statistics/bradley_terry.h"

namespace mien::pipeline {

/// An estimate with its interval.
struct IntervalLine {
  std::string name;
  std::string note;  ///< beside the axis; why there is no estimate, say
  double value;      ///< NaN: no estimate
  Interval95 ends;   ///< NaN: no interval
};

/// A row for each estimate, on a common axis.
struct IntervalChart {
  std::string title;
  std::string words;  ///< subtitle
  std::string axis;   ///< what the axis shows
  std::vector<IntervalLine> lines;
  double low = -1.0;  ///< ends of the axis
  double high = 1.0;
  double step = 0.5;  ///< distance of its ticks
};

/// Sets an axis that has all intervals between two ticks, and 0: in its middle if it is symmetric.
void set_axis(IntervalChart& chart, bool is_symmetric);

Plot interval_plot(const IntervalChart& chart);

}  // namespace mien::pipeline
