#include <algorithm>
#include <cmath>

#include "motion/formats/table/column_name.h"
#include "motion/formats/table/frame_times.h"
#include "motion/formats/table/table_cell.h"
#include "motion/formats/table/wide_table.h"
#include "motion/points/point_names.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// "In 3 places"
std::string in_places(std::size_t count) {
  return "In " + std::to_string(count) + (count == 1 ? " place" : " places");
}

/// Reads the rows of a table in which a row is a frame.
class WideReader {
 public:
  WideReader(TableRows& rows, WideColumns columns, const ReadOptions& options)
      : rows_(rows), columns_(std::move(columns)), options_(options) {
    marks_.may_be_commas = rows.separator() != ',';
  }

  PointRecording read() {
    while (rows_.next()) {
      if (is_row_without_cells()) continue;
      if (columns_.may_end_at_text && starts_other_table()) break;
      read_row();
    }
    if (moments_.count == 0)
      fail(rows_.cursor(), rows_.position(), "there are no frames",
           "give a recording of at least one frame");
    return finished();
  }

 private:
  /// Spreadsheets may write such rows after the last one. Without frame numbers and times, it is a
  /// frame in which everything is missing.
  bool is_row_without_cells() const {
    if (columns_.frame < 0 && columns_.time < 0) return false;
    return std::ranges::all_of(rows_.fields(), [](std::string_view f) { return f.empty(); });
  }

  bool starts_other_table() {
    const bool is_other = read_cell(rows_.field(0), marks_).kind == TableCell::text;
    if (is_other)
      columns_.notes.push_back("Only the first table of the file was read; " +
                               in_quotes(rows_.field(0)) + " follows it.");
    return is_other;
  }

  TableCell cell(int column) {
    const std::string_view field = rows_.field(static_cast<std::size_t>(column));
    if (!columns_.missing_word.empty() && field == columns_.missing_word) return {};
    return read_cell(field, marks_);
  }

  [[noreturn]] void refuse_cell(int column, const std::string& meaning) const {
    const auto index = static_cast<std::size_t>(column);
    const std::string_view field = rows_.field(index);
    rows_.refuse(index,
                 field.empty() ? "the row has no value for " + meaning
                               : in_quotes(field) + " is not a usable number for " + meaning,
                 field.empty() ? "complete the row" : "write a number there, or leave it empty");
  }

  void read_row() {
    for (std::size_t i = columns_.width; i < rows_.fields().size(); ++i)
      if (!rows_.fields()[i].empty())
        rows_.refuse(i,
                     "the row has more than the " + std::to_string(columns_.width) +
                         " columns of the header",
                     "check the separators of the columns");
    row_starts_.push_back(rows_.row_start());
    ++moments_.count;
    if (columns_.frame >= 0) read_number();
    if (columns_.time >= 0) read_time();
    for (const PointColumns& point : columns_.points) read_point(point);
  }

  void read_number() {
    const TableCell number = cell(columns_.frame);
    const bool is_whole =
        number.kind == TableCell::number && number.value == std::floor(number.value);
    if (!is_whole) refuse_cell(columns_.frame, "the number of the frame");
    moments_.numbers.push_back(static_cast<std::int64_t>(number.value));
  }

  void read_time() {
    const TableCell time = cell(columns_.time);
    const bool may_be_missing = columns_.frame >= 0 && time.kind == TableCell::missing;
    if (time.kind != TableCell::number && !may_be_missing) refuse_cell(columns_.time, "the time");
    moments_.times.push_back(may_be_missing ? std::nan("") : time.value);
    if (time.kind == TableCell::number)
      note_last_digit(moments_, rows_.field(static_cast<std::size_t>(columns_.time)));
  }

  void read_point(const PointColumns& point) {
    Vec3 position = Vec3::Zero();
    int given = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int column = point.column[static_cast<std::size_t>(axis)];
      const TableCell coordinate = cell(column);
      if (coordinate.kind == TableCell::text)
        refuse_cell(column, std::string(1, axis_letters[axis]) + " of " + in_quotes(point.name));
      given += coordinate.kind == TableCell::number;
      position[axis] = coordinate.value;
    }
    const bool is_partial = given > 0 && given < 3;
    partial_ += is_partial;
    const bool is_at_origin = given == 3 && position.isZero(0.0);
    at_origin_ += is_at_origin;
    const bool is_seen = given == 3 && !(is_at_origin && columns_.is_missing_at_origin);
    positions_.push_back(is_seen ? position : Vec3::Zero());
    seen_.push_back(is_seen);
  }

  PointRecording finished() {
    if (marks_.are_mixed())
      throw Error({rows_.cursor().file}, "numbers have decimal commas and decimal points",
                  "write them all with decimal points");
    moments_.seconds_per_unit = columns_.time_column.seconds_per_unit;
    moments_.has_unit = columns_.time_column.has_unit;
    moments_.stated_rate = columns_.rate;
    moments_.rate_source = "The header";
    moments_.place = [this](std::size_t row) { return place_at(rows_.cursor(), row_starts_[row]); };
    const FrameTiming timing = timing_of(moments_, rows_.cursor().file, options_);
    PointRecording recording;
    fill_frames(timing, recording);
    recording.frames_per_second = timing.frames_per_second;
    recording.events = std::move(columns_.events);
    if (columns_.unit) {
      recording.unit = std::string(columns_.unit->name);
      recording.metres_per_unit = columns_.unit->metres;
    }
    add_notes(timing, recording);
    return recording;
  }

  void fill_frames(const FrameTiming& timing, PointRecording& recording) {
    const std::size_t points = columns_.points.size();
    require_present_size({rows_.cursor().file}, points, timing.frame_count,
                         rows_.cursor().text.size());
    std::vector<std::string> names;
    for (PointColumns& point : columns_.points) names.push_back(std::move(point.name));
    recording.points = distinct_point_names(std::move(names), recording.notes);
    if (static_cast<std::size_t>(timing.frame_count) == moments_.count) {
      recording.positions = std::move(positions_);
      recording.seen = std::move(seen_);
      return;
    }
    const std::size_t cells = static_cast<std::size_t>(timing.frame_count) * points;
    recording.positions.assign(cells, Vec3::Zero());
    recording.seen.assign(cells, false);
    for (std::size_t row = 0; row < moments_.count; ++row) {
      for (std::size_t p = 0; p < points; ++p) {
        const std::size_t to = static_cast<std::size_t>(timing.frame_of[row]) * points + p;
        recording.positions[to] = positions_[row * points + p];
        recording.seen[to] = seen_[row * points + p];
      }
    }
  }

  void add_notes(const FrameTiming& timing, PointRecording& recording) {
    recording.notes = std::move(columns_.notes);
    recording.notes.insert(recording.notes.end(), timing.notes.begin(), timing.notes.end());
    note_left_out(columns_.left_out, recording.notes);
    if (partial_ > 0)
      recording.notes.push_back(in_places(partial_) +
                                " only one or two coordinates of a point are given; the "
                                "point is taken as missing there.");
    if (at_origin_ > 0 && columns_.is_missing_at_origin)
      recording.notes.push_back(in_places(at_origin_) +
                                " a point is at exactly 0 0 0; it is taken as missing there.");
    if (at_origin_ > 0 && !columns_.is_missing_at_origin)
      recording.notes.push_back(in_places(at_origin_) +
                                " a point is at exactly 0 0 0, which is taken as its "
                                "position; leave the cells empty if it is missing.");
  }

  TableRows& rows_;
  WideColumns columns_;
  const ReadOptions& options_;
  DecimalMarks marks_;
  MomentTimes moments_;
  std::vector<std::size_t> row_starts_;
  std::vector<Vec3> positions_;
  std::vector<bool> seen_;
  std::size_t partial_ = 0;
  std::size_t at_origin_ = 0;
};

}  // namespace

PointRecording read_wide_rows(TableRows& rows, WideColumns columns, const ReadOptions& options) {
  if (columns.has_mixed_units)
    throw Error({rows.cursor().file}, "the columns are in different units",
                "give all positions in one unit");
  return WideReader(rows, std::move(columns), options).read();
}

}  // namespace mien::motion
