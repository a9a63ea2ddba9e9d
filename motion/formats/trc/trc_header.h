#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text/text_cursor.h"

namespace mien::motion {

/// What a TRC file says before its rows.
struct TrcHeader {
  std::vector<std::string> names;     ///< of the points; may be empty or occur twice
  std::optional<double> data_rate;    ///< frames per second; nothing if it is not a number above 0
  std::optional<std::size_t> frames;  ///< NumFrames
  std::string unit;                   ///< as written; empty if not stated
};

/// A line without its end and without a carriage return; the cursor moves to the next line.
std::string_view next_line(TextCursor& cursor);

/// The cells of a line between its tabs, without blanks at either end.
std::vector<std::string_view> trc_cells(std::string_view line);

/// Whether a line has no characters but blanks.
bool is_blank_line(std::string_view line);

/// Parses the lines before the rows, and leaves the cursor at the first row (or the end). The
/// number of points is that of the coordinate labels (X1 Y1 Z1 …), or else of the names. If
/// NumMarkers differs, a note says so. Throws mien::Error, also for more than 65,536 points.
TrcHeader parse_trc_header(TextCursor& cursor, std::vector<std::string>& notes);

}  // namespace mien::motion
