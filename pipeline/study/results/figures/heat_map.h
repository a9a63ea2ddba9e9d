#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/palette.h"
#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// A coloured cell of a table.
struct HeatCell {
  std::string text;  ///< printed in the cell; may be empty
  Colour colour = paper;
  bool is_outlined = false;
  bool is_bold = false;
};

/// A table whose cells are coloured.
struct HeatMap {
  std::string title;
  std::string words;  ///< subtitle
  std::string row_title, column_title;
  std::vector<std::string> row_names, column_names;
  std::vector<std::vector<HeatCell>> cells;  ///< row by row
  bool simulated = false;
};

Plot heat_map_plot(const HeatMap& map);

/// Diverging colormap: red for −1, nearly white for 0, blue for 1.
Colour signed_colour(double value);

/// Sequential colormap: nearly white for 0, blue for 1.
Colour share_colour(double value);

}  // namespace mien::pipeline
