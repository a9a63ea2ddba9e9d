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

/// A point and its three columns.
struct PointColumns {
  std::string name;
  std::array<int, 3> column = {-1, -1, -1};
};

/// What the columns of a table mean in which a row is a frame.
struct WideColumns {
  std::vector<PointColumns> points;
  int frame = -1;  ///< column of frame numbers; −1 if there is none
  int time = -1;
  NamedColumn time_column;
  std::size_t width = 0;              ///< columns that have a meaning or are left out knowingly
  std::optional<LengthUnit> unit;     ///< of the positions, if the file states it
  bool has_mixed_units = false;       ///< whether columns state different units
  std::optional<double> rate;         ///< frames per second, if the header states them
  bool is_missing_at_origin = false;  ///< whether 0 0 0 is missing
  std::string missing_word;           ///< another word for what is missing; may be empty
  bool may_end_at_text = false;       ///< whether other tables may follow, after a row of text
  std::vector<std::string> left_out;  ///< names of columns without a meaning
  std::vector<std::string> notes;
  std::vector<PointEvent> events;
};

/// The columns named by a single row, or by a row of points and the row of axes below it (`names`
/// is then the upper one; its empty cells repeat the cell before them). No points if none has all
/// three axes.
WideColumns wide_columns(const std::vector<std::string>& names,
                         const std::vector<std::string>& axes = {});

/// Throws mien::Error if columns are x and y of points but none is z.
void refuse_two_dimensional(const std::vector<std::string>& names, const Place& place);

/// Adds the sentence about columns that were left out, if any.
void note_left_out(const std::vector<std::string>& left_out, std::vector<std::string>& notes);

/// Reads the rows that follow as frames. Throws mien::Error as `parse_point_table`.
PointRecording read_wide_rows(TableRows& rows, WideColumns columns, const ReadOptions& options);

}  // namespace mien::motion
