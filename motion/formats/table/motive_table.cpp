#include <algorithm>
#include <span>

#include "motion/formats/table/program_tables.h"
#include "motion/formats/table/table_cell.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_header_rows = 10;

using Row = std::vector<std::string>;

Row copy_of(const std::vector<std::string_view>& fields) { return {fields.begin(), fields.end()}; }

std::string_view cell(const Row& row, std::size_t column) {
  return column < row.size() ? std::string_view(row[column]) : std::string_view();
}

/// The rows over the columns.
struct MotiveHeader {
  Row types;
  Row names;
  Row kinds;
  Row axes;
};

MotiveHeader read_header(TableRows& rows) {
  std::vector<Row> header;
  while (header.size() < most_header_rows && rows.next()) {
    header.push_back(copy_of(rows.fields()));
    if (!same_word(cell(header.back(), 0), "Frame")) continue;
    if (header.size() < 4) break;
    return {header[0], header[1], header[header.size() - 2], header.back()};
  }
  rows.refuse(0, "the rows that name the columns are not as Motive writes them",
              "export the take with its header again");
}

void read_first_line(const std::vector<std::string_view>& fields, WideColumns& columns) {
  std::optional<double> capture_rate;
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    const std::string_view value = fields[i + 1];
    if (same_word(fields[i], "Capture Frame Rate")) capture_rate = as_written_number(value);
    if (same_word(fields[i], "Export Frame Rate")) columns.rate = as_written_number(value);
    if (!same_word(fields[i], "Length Units")) continue;
    columns.unit = length_unit(value);
    if (!columns.unit)
      columns.notes.push_back("The unit of length " + in_quotes(value) + " is not known.");
  }
  if (!columns.rate) columns.rate = capture_rate;
}

/// Whether a column begins the position of a point: it and the next two have one type and name,
/// and the three axes.
bool is_position(const MotiveHeader& header, std::size_t column) {
  unsigned axes = 0;
  for (std::size_t i = column; i < column + 3; ++i) {
    const std::string_view axis = cell(header.axes, i);
    const bool is_same = cell(header.names, i) == cell(header.names, column) &&
                         cell(header.types, i) == cell(header.types, column);
    if (!is_same || axis.size() != 1 || !same_word(cell(header.kinds, i), "Position")) return false;
    if (axis[0] >= 'X' && axis[0] <= 'Z') axes |= 1U << static_cast<unsigned>(axis[0] - 'X');
  }
  return axes == 7U;
}

void take_points(const MotiveHeader& header, std::string_view type, WideColumns& columns) {
  for (std::size_t i = 1; i + 2 < header.axes.size();) {
    if (!same_word(cell(header.types, i), type) || !is_position(header, i)) {
      ++i;
      continue;
    }
    PointColumns& point = columns.points.emplace_back();
    point.name = std::string(cell(header.names, i));
    for (std::size_t k = i; k < i + 3; ++k)
      point.column[static_cast<std::size_t>(header.axes[k][0] - 'X')] = static_cast<int>(k);
    i += 3;
  }
}

/// "Rigid Body Rotation" and other kinds of columns that are not read, each once.
std::vector<std::string> other_kinds(const MotiveHeader& header, std::string_view type) {
  std::vector<std::string> kinds;
  for (std::size_t i = 1; i < header.axes.size(); ++i) {
    if (cell(header.types, i).empty()) continue;
    const bool is_read =
        same_word(cell(header.types, i), type) && same_word(cell(header.kinds, i), "Position");
    if (is_read) continue;
    const std::string kind =
        excerpt(cell(header.types, i), 30) + " " + excerpt(cell(header.kinds, i), 30);
    if (kinds.size() < most_header_rows && std::ranges::find(kinds, kind) == kinds.end())
      kinds.push_back(kind);
  }
  std::erase(kinds, "Type ");
  return kinds;
}

}  // namespace

WideColumns motive_columns(TableRows& rows) {
  WideColumns columns;
  read_first_line(rows.fields(), columns);
  const MotiveHeader header = read_header(rows);
  columns.width = header.axes.size();
  columns.frame = 0;
  for (std::size_t i = 1; i < header.axes.size() && columns.time < 0; ++i) {
    const NamedColumn named = named_column(header.axes[i]);
    if (named.use != ColumnUse::time) continue;
    columns.time = static_cast<int>(i);
    columns.time_column = named;
  }
  constexpr std::string_view types[] = {"Marker", "Bone Marker", "Rigid Body Marker", "Bone"};
  for (const std::string_view type : types) {
    take_points(header, type, columns);
    if (columns.points.empty()) continue;
    const std::vector<std::string> others = other_kinds(header, type);
    if (!others.empty())
      columns.notes.push_back("The columns of type " + std::string(type) +
                              " are read as points; others were left out: " + listed(others) + ".");
    return columns;
  }
  rows.refuse(0, "holds no positions of markers or bones", "export markers from Motive");
}

}  // namespace mien::motion
