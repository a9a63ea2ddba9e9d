#include <algorithm>
#include <array>

#include "motion/formats/table/program_tables.h"
#include "motion/formats/table/table_cell.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

bool is_number(std::string_view field) {
  DecimalMarks marks;
  return read_cell(field, marks).kind == TableCell::number;
}

bool is_keyword(std::string_view field) {
  constexpr std::array<std::string_view, 8> words = {
      "NO_OF_",     "FREQUENCY",     "ANALOG_",      "DESCRIPTION",
      "TIME_STAMP", "DATA_INCLUDED", "MARKER_NAMES", "TRAJECTORY_TYPES"};
  const auto begins = [&](std::string_view word) { return field.starts_with(word); };
  return std::ranges::any_of(words, begins) || field == "EVENT" || field == "BODY_NAMES";
}

void take_keyword(const TableRows& rows, WideColumns& columns, std::int64_t* declared_frames) {
  const std::string_view word = rows.field(0);
  if (word == "NO_OF_FRAMES")
    *declared_frames = as_number<std::int64_t>(rows.field(1)).value_or(-1);
  if (word == "FREQUENCY") columns.rate = as_written_number(rows.field(1));
  if (word == "DATA_INCLUDED" && rows.field(1) != "3D")
    rows.refuse(1, "holds " + in_quotes(rows.field(1)) + " data", "export 3D data as TSV");
  if (word == "EVENT") {
    const std::optional<double> seconds = as_finite_number(rows.field(3));
    if (seconds) columns.events.push_back({std::string(rows.field(1)), "", *seconds});
  }
  if (word != "MARKER_NAMES") return;
  for (std::size_t i = 1; i < rows.fields().size(); ++i)
    columns.points.push_back({std::string(rows.field(i)), {-1, -1, -1}});
  while (!columns.points.empty() && columns.points.back().name.empty()) columns.points.pop_back();
}

/// The columns before the positions, by their names.
std::size_t take_names(const TableRows& rows, WideColumns& columns) {
  std::size_t first = 0;
  for (; first < 2; ++first) {
    const NamedColumn named = named_column(rows.field(first));
    if (named.use == ColumnUse::frame) {
      columns.frame = static_cast<int>(first);
    } else if (named.use == ColumnUse::time) {
      columns.time = static_cast<int>(first);
      columns.time_column = named;
    } else {
      break;
    }
  }
  return first;
}

/// The columns before the positions, by the first row: positions have decimals, numbers of frames
/// have none, and a row may end with a tab.
std::size_t take_unnamed(const TableRows& rows, WideColumns& columns) {
  const std::size_t width = rows.fields().size();
  const std::size_t needed = 3 * columns.points.size();
  const bool begins_with_count =
      !rows.field(0).empty() && rows.field(0).find_first_of(".,eE") == std::string_view::npos;
  if (width <= needed || !begins_with_count) return 0;
  columns.frame = 0;
  if (width < needed + 2) return 1;
  columns.time = 1;
  return 2;
}

}  // namespace

WideColumns qualisys_columns(TableRows& rows, std::int64_t* declared_frames) {
  WideColumns columns;
  *declared_frames = -1;
  columns.unit = length_unit("mm");
  columns.is_missing_at_origin = true;
  columns.time_column = {ColumnUse::time, 1.0, true};
  std::size_t first = 0;
  bool is_named = false;
  std::size_t before = 0;
  bool has_row = true;
  for (; has_row && !is_number(rows.field(0)); has_row = rows.next()) {
    if (is_keyword(rows.field(0))) {
      take_keyword(rows, columns, declared_frames);
    } else if (!columns.points.empty() && !is_named && !rows.field(0).empty()) {
      first = take_names(rows, columns);
      is_named = true;
    } else {
      break;
    }
    before = rows.position();
  }
  if (columns.points.empty())
    rows.refuse(0, "holds no MARKER_NAMES", "export 3D data with their header as TSV");
  if (!is_named && has_row) first = take_unnamed(rows, columns);
  for (std::size_t p = 0; p < columns.points.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis)
      columns.points[p].column[axis] = static_cast<int>(first + 3 * p + axis);
  columns.width = first + 3 * columns.points.size();
  rows.go_to(before);
  return columns;
}

bool is_nexus_section(std::string_view word) {
  constexpr std::array<std::string_view, 6> sections = {"Trajectories", "Joints", "Segments",
                                                        "Devices",      "Events", "Model Outputs"};
  return std::ranges::any_of(sections, [&](std::string_view s) { return same_word(s, word); });
}

WideColumns nexus_columns(TableRows& rows) {
  std::vector<std::string> others;
  bool has_row = true;
  for (; has_row && !same_word(rows.field(0), "Trajectories"); has_row = rows.next()) {
    const std::string word(rows.field(0));
    if (is_nexus_section(word) && std::ranges::find(others, word) == others.end())
      others.push_back(word);
  }
  if (!has_row || !rows.next())
    rows.refuse(0, "holds no section \"Trajectories\"", "export the trajectories from Nexus");
  const std::optional<double> rate = as_written_number(rows.field(0));
  std::array<std::vector<std::string>, 3> header;
  for (std::vector<std::string>& row : header) {
    if (!rows.next())
      rows.refuse(0, "the section \"Trajectories\" has no rows", "export it from Nexus again");
    row.assign(rows.fields().begin(), rows.fields().end());
  }
  WideColumns columns = wide_columns(header[0], header[1]);
  columns.rate = rate;
  columns.may_end_at_text = true;
  if (!others.empty())
    columns.notes.push_back(
        "Only the section \"Trajectories\" is read; others were left out: " + listed(others) + ".");
  std::erase_if(columns.left_out, [](const std::string& name) { return name == "Sub Frame"; });
  for (const std::string& word : header[2])
    if (!columns.unit) columns.unit = length_unit(word);
  if (columns.points.empty())
    rows.refuse(0, "the section \"Trajectories\" holds no points", "export it from Nexus again");
  return columns;
}

}  // namespace mien::motion
