#include "motion/formats/trc/trc_header.h"

#include <algorithm>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_points = 65'536;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = trimmed(line)).empty()) {
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
  return words;
}

/// The value of each field: by place where there is one for each, otherwise by cell.
class Fields {
 public:
  Fields(std::string_view names, std::string_view values)
      : names_(words_of(names)), values_(words_of(values)) {
    if (names_.size() == values_.size()) return;
    names_ = trc_cells(names);
    values_ = trc_cells(values);
  }

  std::string_view operator[](std::string_view name) const {
    for (std::size_t i = 0; i < std::min(names_.size(), values_.size()); ++i) {
      if (same_word(names_[i], name)) return values_[i];
    }
    return {};
  }

 private:
  std::vector<std::string_view> names_;
  std::vector<std::string_view> values_;
};

/// How many points a line of coordinate labels has: X1 Y1 Z1 X2 …; nothing if it is no such line.
std::optional<std::size_t> labelled_points(std::string_view line) {
  std::size_t labels = 0;
  for (const std::string_view cell : trc_cells(line)) {
    if (cell.empty()) continue;
    const char letter = static_cast<char>(cell.front() & ~0x20);  // in upper case
    if (letter != "XYZ"[labels % 3]) return std::nullopt;
    ++labels;
  }
  return labels > 0 && labels % 3 == 0 ? std::optional(labels / 3) : std::nullopt;
}

/// The names of the points: as many as `points` if that is stated. A name that is empty is known by
/// its place, two cells before that of the next one.
std::vector<std::string> names_in(const std::vector<std::string_view>& cells,
                                  std::optional<std::size_t> points) {
  std::vector<std::string> names;
  for (std::size_t i = 2; i < cells.size(); ++i) {
    if (!cells[i].empty()) names.emplace_back(cells[i]);
  }
  if (!points || *points <= names.size()) return names;
  const bool in_threes = std::ranges::all_of(cells.begin() + 2, cells.end(), [&](const auto& cell) {
    return cell.empty() || (&cell - cells.data()) % 3 == 2;
  });
  if (!in_threes) return names;
  names.assign(*points, "");
  for (std::size_t i = 0; i < *points && 2 + 3 * i < cells.size(); ++i)
    names[i] = std::string(cells[2 + 3 * i]);
  return names;
}

}  // namespace

std::string_view next_line(TextCursor& cursor) {
  const std::size_t start = cursor.at;
  while (!at_line_end(cursor)) ++cursor.at;
  const std::string_view line = cursor.text.substr(start, cursor.at - start);
  skip_line(cursor);
  return line;
}

std::vector<std::string_view> trc_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t tab = 0; tab != std::string_view::npos;) {
    tab = line.find('\t');
    cells.push_back(trimmed(line.substr(0, tab)));
    if (tab != std::string_view::npos) line.remove_prefix(tab + 1);
  }
  return cells;
}

bool is_blank_line(std::string_view line) { return trimmed(line).empty(); }

TrcHeader parse_trc_header(TextCursor& cursor, std::vector<std::string>& notes) {
  if (words_of(next_line(cursor)).empty() || !cursor.text.starts_with("PathFileType")) {
    fail(cursor, 0, "is not a TRC file: it does not begin with PathFileType",
         "name a TRC file, or export it again");
  }
  const std::string_view field_names = next_line(cursor);
  const Fields fields(field_names, next_line(cursor));
  TrcHeader header;
  header.data_rate = as_written_number(fields["DataRate"]);
  if (header.data_rate && !(*header.data_rate > 1e-3 && *header.data_rate < 1e6))
    header.data_rate.reset();
  header.frames = as_number<std::size_t>(fields["NumFrames"]);
  header.unit = std::string(fields["Units"]);

  const std::size_t names_at = cursor.at;
  const std::vector<std::string_view> cells = trc_cells(next_line(cursor));
  if (cells.size() < 3 || !same_word(cells[0].substr(0, 5), "Frame") ||
      !same_word(cells[1].substr(0, 4), "Time")) {
    fail(cursor, names_at, "the fourth line does not name the columns Frame#, Time and the points",
         "export the file again, with its cells separated by tabs");
  }
  if (cells.size() > 2 + 3 * most_points) {
    fail(cursor, names_at, "there are more than " + std::to_string(most_points) + " points",
         "keep the markers of the recording");
  }
  std::optional<std::size_t> labelled;
  for (std::size_t line_at = cursor.at; !at_end(cursor); line_at = cursor.at) {
    const std::string_view line = next_line(cursor);
    const std::optional<std::size_t> points = labelled_points(line);
    if (!is_blank_line(line) && !points) {
      cursor.at = line_at;
      break;
    }
    if (points) labelled = points;
  }
  header.names = names_in(cells, labelled);
  if (header.names.empty()) {
    fail(cursor, names_at, "there are no points", "export the file again with its markers");
  }
  if (labelled && *labelled != header.names.size()) {
    fail(cursor, names_at,
         std::to_string(header.names.size()) + " points are named, but the next line has " +
             "coordinates of " + std::to_string(*labelled),
         "give each point a name and three coordinates");
  }
  const std::optional<std::size_t> stated = as_number<std::size_t>(fields["NumMarkers"]);
  if (stated && *stated != header.names.size()) {
    notes.push_back("The header says " + std::to_string(*stated) + " markers, but " +
                    std::to_string(header.names.size()) + " have names and coordinates.");
  }
  return header;
}

}  // namespace mien::motion
