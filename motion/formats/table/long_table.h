#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/formats/reading/read_options.h"
#include "motion/formats/table/column_name.h"
#include "motion/formats/table/table_rows.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// What the columns of a table mean in which a row is a point of a frame; −1 where there is none.
struct LongColumns {
  int point = -1;
  std::array<int, 3> axis = {-1, -1, -1};
  int frame = -1;
  int time = -1;
  NamedColumn time_column;
  int subject = -1;
  int model = -1;       ///< what found the point (FreeMoCap): points of one name may have several
  int trajectory = -1;  ///< kind of the position (FreeMoCap)
  std::optional<LengthUnit> unit;
  std::optional<double> rate;         ///< frames per second as described beside the file
  std::vector<std::string> left_out;  ///< names of columns without a meaning
};

/// The columns of a header row; nothing unless one column names the point and three are its axes.
std::optional<LongColumns> long_columns(const std::vector<std::string>& names);

/// Reads the rows that follow, in any order. Throws mien::Error as `parse_point_table`, and if a
/// point occurs twice in a frame.
PointRecording read_long_rows(TableRows& rows, const LongColumns& columns,
                              const ReadOptions& options);

}  // namespace mien::motion
