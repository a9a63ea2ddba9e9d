#include "motion/formats/table/point_table.h"

#include <algorithm>
#include <optional>

#include "motion/formats/reading/option_names.h"
#include "motion/formats/reading/points_of_subject.h"
#include "motion/formats/table/long_table.h"
#include "motion/formats/table/program_tables.h"
#include "motion/formats/table/table_cell.h"
#include "motion/formats/table/wide_table.h"
#include "motion/formats/writing/point_description.h"
#include "motion/points/joint_orders.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_rows_before_table = 8;
constexpr char name_columns[] =
    "name three columns for each point, as in nose_x, nose_y, nose_z, or have the columns frame, "
    "point, x, y, z";

using Names = std::vector<std::string>;

Names names_of(const TableRows& rows) { return {rows.fields().begin(), rows.fields().end()}; }

/// Whether at least half of the cells that are not missing are numbers.
bool is_numeric(const TableRows& rows) {
  DecimalMarks marks;
  marks.may_be_commas = rows.separator() != ',';
  std::size_t numbers = 0;
  std::size_t texts = 0;
  for (const std::string_view field : rows.fields()) {
    const TableCell::Kind kind = read_cell(field, marks).kind;
    numbers += kind == TableCell::number;
    texts += kind == TableCell::text;
  }
  return numbers > 0 && numbers >= texts;
}

bool is_axis(const std::string& name) {
  const std::optional<AxisName> axis = axis_name(name);
  return axis && axis->base.empty();
}

/// Takes the unit from a row of units below the header, if there is one.
void skip_units(TableRows& rows, WideColumns& columns) {
  const std::size_t before = rows.position();
  if (!rows.next()) return;
  std::optional<LengthUnit> unit;
  if (!is_numeric(rows))
    for (const std::string_view field : rows.fields())
      if (!unit) unit = length_unit(field);
  if (!unit) return rows.go_to(before);
  if (!columns.unit) columns.unit = unit;
}

/// The columns of a header of several rows: the axes in the last that has any, the points above.
WideColumns columns_of_rows(TableRows& rows) {
  std::vector<Names> header = {names_of(rows)};
  std::vector<std::size_t> after = {rows.position()};
  while (header.size() < most_rows_before_table && rows.next() && !is_numeric(rows)) {
    header.push_back(names_of(rows));
    after.push_back(rows.position());
  }
  for (std::size_t i = header.size(); i-- > 0;) {
    if (std::ranges::count_if(header[i], is_axis) < 2) continue;
    const Names above = i > 0 ? header[i - 1] : Names();
    WideColumns columns = wide_columns(above, header[i]);
    rows.go_to(after[i]);
    if (!columns.points.empty()) return columns;
    refuse_two_dimensional(header[i], place_at(rows.cursor(), rows.row_start()));
  }
  refuse_two_dimensional(header[0], {rows.cursor().file});
  rows.go_to(0);
  rows.next();
  rows.refuse(0, "no columns of points are found", name_columns);
}

/// Without a header: the names are in the comment above (numpy.savetxt), or told.
WideColumns columns_without_header(TableRows& rows, const ReadOptions& options) {
  const std::size_t width = rows.fields().size();
  TableRows comment(rows.comment(), rows.cursor().file, rows.separator());
  WideColumns columns;
  if (!rows.comment().empty() && comment.next() && comment.fields().size() == width)
    columns = wide_columns(names_of(comment));
  if (!columns.points.empty()) {
    rows.go_to(rows.row_start());
    return columns;
  }
  const std::vector<std::string> joints = given_point_names(options.joints);
  if (joints.empty())
    rows.refuse(
        0, "there is no header that names the columns",
        std::string("name them in the first row, or list the points with ") + joints_option);
  if (width != 3 * joints.size())
    rows.refuse(0,
                "the row has " + std::to_string(width) + " columns, but " +
                    std::to_string(joints.size()) +
                    " points are named, which have three columns each",
                "list all points");
  for (const std::string& name : joints) {
    const int first = 3 * static_cast<int>(columns.points.size());
    columns.points.push_back({name, {first, first + 1, first + 2}});
  }
  columns.width = width;
  rows.go_to(rows.row_start());
  return columns;
}

PointRecording read_named_rows(TableRows& rows, const ReadOptions& options,
                               std::optional<double> described) {
  const Names names = names_of(rows);
  if (std::optional<LongColumns> columns = long_columns(names)) {
    columns->rate = described;
    return read_long_rows(rows, *columns, options);
  }
  WideColumns columns = wide_columns(names);
  if (columns.points.empty()) columns = columns_of_rows(rows);
  skip_units(rows, columns);
  return read_wide_rows(rows, std::move(columns), options);
}

PointRecording read_qualisys(TableRows& rows, const ReadOptions& options) {
  std::int64_t declared = -1;
  WideColumns columns = qualisys_columns(rows, &declared);
  PointRecording recording = read_wide_rows(rows, std::move(columns), options);
  if (declared >= 0 && declared != recording.frame_count())
    recording.notes.push_back("The header says " + std::to_string(declared) +
                              " frames, but the file has " +
                              std::to_string(recording.frame_count()) + ".");
  return recording;
}

PointRecording read_rows(TableRows& rows, const ReadOptions& options,
                         std::optional<double> described) {
  if (!rows.next())
    rows.refuse(0, "there are no rows", "give a table with a header and a row for each frame");
  const std::string_view first = rows.field(0);
  if (first == "Format Version") return read_wide_rows(rows, motive_columns(rows), options);
  if (first == "NO_OF_FRAMES") return read_qualisys(rows, options);
  const bool is_nexus =
      is_nexus_section(first) && std::ranges::all_of(rows.fields().begin() + 1, rows.fields().end(),
                                                     [](std::string_view f) { return f.empty(); });
  if (is_nexus) return read_wide_rows(rows, nexus_columns(rows), options);
  if (is_numeric(rows)) return read_wide_rows(rows, columns_without_header(rows, options), options);
  return read_named_rows(rows, options, described);
}

/// `described`: frames per second that a description beside the file states.
PointRecording parse_table(std::string_view text, const std::string& file_name,
                           const ReadOptions& options, std::optional<double> described) {
  const char separator = text.starts_with("NO_OF_FRAMES") ? '\t' : separator_of(text);
  TableRows rows(text, file_name, separator);
  PointRecording recording = read_rows(rows, options, described);
  recording.name = recording_name(file_name);
  recording.format = separator == '\t' ? "tsv" : "csv";
  if (recording.subjects.empty()) keep_points_of_subject(recording, options, {file_name});
  return recording;
}

}  // namespace

PointRecording parse_point_table(std::string_view text, const std::string& file_name,
                                 const ReadOptions& options) {
  return parse_table(text, file_name, options, std::nullopt);
}

PointRecording read_point_table(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string file = path.string();
  const std::string bytes = read_contents(path);
  require_kind(bytes, file, "csv");
  return parse_table(bytes, file, options, described_rate(path));
}

}  // namespace mien::motion
