#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A bar that starts at 0, and its whisker.
struct Bar {
  std::string name;
  double value = 0.0;
  double low = 0.0;              ///< lower end of the whisker; NaN for no whisker
  double high = 0.0;             ///< upper end of the whisker; NaN for no whisker
  std::string note;              ///< under the name: "n = 13"
  std::optional<Colour> colour;  ///< default: by position in the group
  std::string second_note;       ///< under the note
  /// Consecutive bars with the same group are drawn together above its name. All groups use the
  /// same colours in the same order.
  std::string group;
};

struct BarChart {
  std::string title;
  std::string axis;      ///< what is measured, and its unit
  std::string whiskers;  ///< meaning of the whiskers, printed with `axis`; empty: not printed
  std::vector<Bar> bars;
  std::optional<double> line;  ///< a value to mark
  std::string line_name;
  int decimals = 1;          ///< number of decimals of the values printed at the bars
  bool percent = false;      ///< values are shares, shown in percent; the axis reaches 100 %
  bool one_colour = false;   ///< whether all bars have the same colour
  bool simulated = false;    ///< based on simulated sessions or ratings; drawn with a mark
  double slot_width = 92.0;  ///< least width of a bar and its margins, points
};

/// Vertical bars on a common axis that always includes 0, each with its value printed. The width
/// depends on the bars and on the text of the axis.
Plot bar_chart_plot(const BarChart& chart);

/// Charts side by side under a common title, with one mark, whose text is `mark`, if any of them is
/// simulated.
Plot bar_charts_plot(const std::string& title, const std::vector<BarChart>& charts,
                     const std::string& mark);

}  // namespace mien::pipeline
