#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A bar from 0 and its whisker.
struct Bar {
  std::string name;
  double value = 0.0;
  double low = 0.0;  ///< ends of the whisker; none where they are NaN
  double high = 0.0;
  std::string note;              ///< under the name: "n = 13"
  std::optional<Colour> colour;  ///< else the chart's
  std::string second_note;       ///< under the note
  /// Bars one after the other with the same group stand together over its name, and have the same
  /// colours in the same order in each.
  std::string group;
};

struct BarChart {
  std::string title;
  std::string axis;      ///< what is measured, and its unit
  std::string whiskers;  ///< what they mean; empty for none
  std::vector<Bar> bars;
  std::optional<double> line;  ///< a value to mark
  std::string line_name;
  int decimals = 1;         ///< of the values printed at the bars
  bool percent = false;     ///< values are shares; the axis goes to 100 %
  bool one_colour = false;  ///< bars are of one kind; else each has a colour of its own
  bool simulated = false;
  double slot_width = 92.0;  ///< points that a bar has with the room beside it
};

/// Upright bars on a common axis that always holds 0, each with its value printed; as wide as it
/// has bars.
Plot bar_chart_plot(const BarChart& chart);

/// Charts side by side under a common title, marked once, with `mark`, when one of them is
/// simulated.
Plot bar_charts_plot(const std::string& title, const std::vector<BarChart>& charts,
                     const std::string& mark);

}  // namespace mien::pipeline
