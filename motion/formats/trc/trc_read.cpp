#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "motion/error.h"
#include "motion/formats/reading/points_of_subject.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/formats/trc/trc.h"
#include "motion/formats/trc/trc_header.h"
#include "motion/formats/trc/trc_times.h"
#include "motion/points/length_unit.h"
#include "motion/points/point_names.h"
#include "motion/text/as_number.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

constexpr double largest_position = 1e12;
constexpr long largest_frame_number = 2'147'483'647;

/// The rows as they stand in the file.
struct Rows {
  std::vector<TrcRow> heads;
  std::vector<Vec3> positions;  ///< row by row; zero where not seen
  std::vector<bool> seen;
  std::size_t at_origin = 0;   ///< positions of exactly 0 0 0
  std::size_t incomplete = 0;  ///< positions of which only some coordinates are there
};

std::string positions_of(std::size_t count) {
  return count == 1 ? "1 position" : std::to_string(count) + " positions";
}

/// Rows may end short, so that their number of points is not bounded by the size of the file.
/// Throws mien::Error if there are many more than it can hold.
void require_room(const TextCursor& cursor, std::size_t index, std::size_t points,
                  std::size_t frames) {
  constexpr std::size_t always_allowed = std::size_t{1} << 20;
  if (frames <= (always_allowed + 4 * cursor.text.size()) / points &&
      is_reasonable_size(points, frames))
    return;
  fail(cursor, index,
       std::to_string(frames) + " frames of " + std::to_string(points) +
           " points are too many for a file in which most of them are missing",
       "remove empty rows and columns, or correct the frame numbers");
}

/// The next cell of the line, without blanks at either end; `rest` becomes what follows its tab.
std::string_view take_cell(std::string_view& rest) {
  const std::size_t tab = rest.find('\t');
  std::string_view cell = rest.substr(0, tab);
  rest = tab == std::string_view::npos ? rest.substr(rest.size()) : rest.substr(tab + 1);
  while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
  while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
  return cell;
}

/// A coordinate; NaN for an empty cell and for NaN.
double coordinate(const TextCursor& cursor, std::string_view cell) {
  if (cell.empty()) return std::nan("");
  double value = 0.0;
  const std::string_view digits = cell.front() == '+' ? cell.substr(1) : cell;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  const bool is_number = error == std::errc{} && stop == end;
  if (is_number && (std::isnan(value) || std::abs(value) < largest_position)) return value;
  fail(cursor, static_cast<std::size_t>(cell.data() - cursor.text.data()),
       in_quotes(cell) + " is not a valid coordinate",
       cell.find(',') != std::string_view::npos
           ? "write decimals with a point"
           : "give a number below 1e12, or leave the cell empty where the point is missing");
}

void parse_positions(const TextCursor& cursor, std::string_view rest, std::size_t points,
                     Rows& rows) {
  for (std::size_t point = 0; point < points; ++point) {
    Vec3 position;
    int there = 0;
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] = coordinate(cursor, take_cell(rest));
      if (!std::isnan(position[axis])) ++there;
    }
    const bool is_origin = there == 3 && position == Vec3::Zero();
    const bool is_seen = there == 3 && !is_origin;
    if (is_origin) ++rows.at_origin;
    if (there == 1 || there == 2) ++rows.incomplete;
    rows.positions.push_back(is_seen ? position : Vec3::Zero());
    rows.seen.push_back(is_seen);
  }
  while (!rest.empty()) {
    const std::string_view cell = take_cell(rest);
    if (cell.empty()) continue;
    fail(cursor, static_cast<std::size_t>(cell.data() - cursor.text.data()),
         "the row has more cells than the " + std::to_string(points) + " points",
         "name all points in the fourth line");
  }
}

Rows parse_rows(TextCursor& cursor, std::size_t points) {
  Rows rows;
  while (!at_end(cursor)) {
    TrcRow row;
    row.at = cursor.at;
    std::string_view rest = next_line(cursor);
    if (is_blank_line(rest)) continue;
    require_room(cursor, row.at, points, rows.heads.size() + 1);
    const std::string_view frame = take_cell(rest);
    const std::optional<double> number = as_written_number(frame);
    if (!number) {
      fail(cursor, row.at, "the row begins with " + in_quotes(frame) + " and no frame number",
           "correct the first cell, or remove the row");
    }
    if (*number == std::floor(*number) && std::abs(*number) <= largest_frame_number)
      row.frame = static_cast<long>(*number);
    read_time(cursor, take_cell(rest), row);
    rows.heads.push_back(row);
    parse_positions(cursor, rest, points, rows);
  }
  if (rows.heads.empty()) {
    fail(cursor, cursor.text.size(), "there are no rows of positions",
         "obtain the file again, or export it again");
  }
  return rows;
}

/// Moves the rows to their frames; those without a row have no points.
void set_frames(const TextCursor& cursor, Rows rows, const std::vector<std::size_t>& frame_of_row,
                PointRecording& recording) {
  const std::size_t points = recording.points.size();
  const std::size_t frames = frame_of_row.back() + 1;
  require_room(cursor, rows.heads[frame_of_row.size() - 1].at, points, frames);
  recording.positions = std::move(rows.positions);
  recording.seen = std::move(rows.seen);
  for (const std::size_t count : {frame_of_row.size(), frames}) {  // without rows left out
    recording.positions.resize(count * points, Vec3::Zero());
    recording.seen.resize(count * points, false);
  }
  if (frames == frame_of_row.size()) return;
  std::size_t first_without = 0;
  for (std::size_t row = 0; row < frame_of_row.size(); ++row) {
    if (frame_of_row[row] == row) first_without = row + 1;
  }
  // From the last row, so that none is overwritten: frames are never before their rows.
  for (std::size_t row = frame_of_row.size(); row-- > first_without;) {
    for (std::size_t point = 0; point < points; ++point) {
      const std::size_t from = row * points + point;
      const std::size_t to = frame_of_row[row] * points + point;
      recording.positions[to] = std::exchange(recording.positions[from], Vec3::Zero());
      recording.seen[to] = recording.seen[from];
      recording.seen[from] = false;
    }
  }
  const std::size_t missing = frames - frame_of_row.size();
  recording.notes.push_back(std::to_string(missing) +
                            (missing == 1 ? " frame has" : " frames have") +
                            " no row in the file, the first one after frame " +
                            std::to_string(first_without) + ": all points are missing there.");
}

void add_notes(const TrcHeader& header, const Rows& rows, std::vector<std::string>& notes) {
  if (header.frames && *header.frames != rows.heads.size()) {
    notes.push_back("The header says " + std::to_string(*header.frames) +
                    " frames, but the file has rows of " + std::to_string(rows.heads.size()) + ".");
  }
  if (rows.at_origin > 0) {
    notes.push_back(positions_of(rows.at_origin) + " of exactly 0 0 0 " +
                    (rows.at_origin == 1 ? "counts" : "count") + " as missing.");
  }
  if (rows.incomplete > 0) {
    notes.push_back(positions_of(rows.incomplete) + " with one or two coordinates only " +
                    (rows.incomplete == 1 ? "counts" : "count") + " as missing.");
  }
}

void set_unit(const TrcHeader& header, PointRecording& recording) {
  recording.unit = header.unit;
  recording.metres_per_unit = metres_in_unit(header.unit);
  if (recording.metres_per_unit > 0.0) return;
  recording.notes.push_back(header.unit.empty()
                                ? "The file does not state the unit of its positions."
                                : "The unit of the positions, " + in_quotes(header.unit) +
                                      ", is not known.");
}

}  // namespace

PointRecording parse_trc(std::string_view text, const std::string& file_name,
                         const ReadOptions& options) {
  TextCursor cursor = start_of(text, file_name);
  PointRecording recording;
  recording.name = recording_name(file_name);
  recording.format = "trc";
  TrcHeader header = parse_trc_header(cursor, recording.notes);
  recording.points = distinct_point_names(std::move(header.names), recording.notes);
  Rows rows = parse_rows(cursor, recording.points.size());
  const TrcFrames frames =
      trc_frames(cursor, rows.heads, header.data_rate, options.frames_per_second, recording.notes);
  recording.frames_per_second = frames.frames_per_second;
  add_notes(header, rows, recording.notes);
  set_unit(header, recording);
  set_frames(cursor, std::move(rows), frames.frame_of_row, recording);
  keep_points_of_subject(recording, options, {file_name});
  return recording;
}

PointRecording read_trc(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string text = read_contents(path);
  require_kind(text, path.string(), "trc");
  return parse_trc(text, path.string(), options);
}

}  // namespace mien::motion
