#include "motion/formats/table/long_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/table/column_name.h"
#include "motion/formats/table/frame_times.h"
#include "motion/formats/table/table_cell.h"
#include "motion/formats/table/wide_table.h"
#include "motion/points/point_names.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// Names with indices, in order of occurrence.
class NameList {
 public:
  std::uint32_t index_of(std::string_view name) {
    if (!names_.empty() && names_[last_] == name) return last_;
    const auto found = index_of_.find(name);
    if (found != index_of_.end()) return last_ = found->second;
    last_ = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    index_of_.emplace(name, last_);
    return last_;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> index_of_;
  std::vector<std::string> names_;
  std::uint32_t last_ = 0;
};

/// The point of rows of people who are not read.
constexpr std::uint32_t of_another = std::numeric_limits<std::uint32_t>::max();

struct LongRow {
  double moment = 0.0;  ///< number of the frame, or else the time
  double time = 0.0;    ///< NaN if missing
  std::size_t start = 0;
  std::uint32_t point = 0;
  std::uint32_t subject = 0;
  bool is_seen = false;
  Vec3 position = Vec3::Zero();
};

/// Reads the rows of a table in which a row is a point of a frame.
class LongReader {
 public:
  LongReader(TableRows& rows, const LongColumns& columns, const ReadOptions& options)
      : rows_(rows), columns_(columns), options_(options) {
    marks_.may_be_commas = rows.separator() != ',';
  }

  PointRecording read() {
    while (rows_.next()) {
      if (std::ranges::all_of(rows_.fields(), [](std::string_view f) { return f.empty(); }))
        continue;
      read_row();
    }
    if (marks_.are_mixed())
      throw Error({file()}, "numbers have decimal commas and decimal points",
                  "write them all with decimal points");
    if (all_.empty())
      fail(rows_.cursor(), rows_.position(), "there are no frames",
           "give a recording of at least one frame");
    keep_one_subject();
    return finished();
  }

 private:
  const std::string& file() const { return rows_.cursor().file; }

  std::string_view field(int column) const {
    return column < 0 ? std::string_view() : rows_.field(static_cast<std::size_t>(column));
  }

  [[noreturn]] void refuse_cell(int column, const std::string& meaning) const {
    const std::string_view text = field(column);
    rows_.refuse(static_cast<std::size_t>(column),
                 text.empty() ? "the row has no value for " + meaning
                              : in_quotes(text) + " is not a usable number for " + meaning,
                 text.empty() ? "complete the row" : "write a number there, or leave it empty");
  }

  void read_row() {
    if (columns_.trajectory >= 0 && is_of_other_trajectory()) return;
    LongRow row;
    row.start = rows_.row_start();
    read_moment(row);
    row.point = point_of_row();
    if (columns_.subject >= 0) row.subject = subjects_.index_of(field(columns_.subject));
    int given = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int column = columns_.axis[axis];
      const TableCell cell = read_cell(field(column), marks_);
      if (cell.kind == TableCell::text)
        refuse_cell(column,
                    std::string(1, axis_letters[axis]) + " of " + in_quotes(field(columns_.point)));
      given += cell.kind == TableCell::number;
      row.position[static_cast<Eigen::Index>(axis)] = cell.value;
    }
    row.is_seen = given == 3;
    partial_ += given == 1 || given == 2;
    if (!row.is_seen) row.position.setZero();
    all_.push_back(row);
  }

  bool is_of_other_trajectory() {
    const bool is_other = trajectories_.index_of(field(columns_.trajectory)) != 0;
    other_trajectories_ += is_other;
    return is_other;
  }

  void read_moment(LongRow& row) {
    const TableCell time = read_cell(field(columns_.time), marks_);
    if (time.kind == TableCell::text) refuse_cell(columns_.time, "the time");
    row.time = time.kind == TableCell::number ? time.value : std::nan("");
    if (time.kind == TableCell::number) note_last_digit(moments_, field(columns_.time));
    if (columns_.frame < 0) {
      if (time.kind != TableCell::number) refuse_cell(columns_.time, "the time");
      row.moment = time.value;
      return;
    }
    const TableCell number = read_cell(field(columns_.frame), marks_);
    if (number.kind != TableCell::number || number.value != std::floor(number.value))
      refuse_cell(columns_.frame, "the number of the frame");
    row.moment = number.value;
  }

  /// Points of one name that different models found are different points.
  std::uint32_t point_of_row() {
    const std::string_view name = field(columns_.point);
    if (name.empty()) refuse_cell(columns_.point, "the name of the point");
    if (columns_.model < 0) return points_.index_of(name);
    key_.assign(name);
    key_ += '\n';
    key_ += field(columns_.model);
    return points_.index_of(key_);
  }

  void keep_one_subject() {
    if (subjects_.names().size() < 2 && !options_.subject) return;
    if (subjects_.names().empty())
      throw Error({file()}, "names no people, so none can be chosen", "omit the subject");
    const std::size_t chosen = chosen_subject({file()}, subjects_.names(), options_.subject);
    if (const std::string note = note_on_subject(subjects_.names(), chosen, options_.subject);
        !note.empty())
      notes_.push_back(note);
    subject_ = subjects_.names()[chosen];
    NameList kept;
    // The rows of others stay for the times, which are common to all.
    for (LongRow& row : all_)
      row.point = row.subject == chosen ? kept.index_of(points_.names()[row.point]) : of_another;
    points_ = std::move(kept);
  }

  /// The different moments, each with the first row of it.
  std::vector<std::size_t> rows_of_moments() const {
    std::vector<std::size_t> order(all_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto is_earlier = [&](std::size_t a, std::size_t b) {
      return all_[a].moment < all_[b].moment;
    };
    if (!std::ranges::is_sorted(order, is_earlier)) std::ranges::stable_sort(order, is_earlier);
    const auto is_same = [&](std::size_t a, std::size_t b) {
      return all_[a].moment == all_[b].moment;
    };
    order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
    return order;
  }

  FrameTiming timing(const std::vector<std::size_t>& first_rows) {
    moments_.count = first_rows.size();
    for (const std::size_t row : first_rows) {
      if (columns_.frame >= 0)
        moments_.numbers.push_back(static_cast<std::int64_t>(all_[row].moment));
      if (columns_.time >= 0) moments_.times.push_back(all_[row].time);
    }
    moments_.seconds_per_unit = columns_.time_column.seconds_per_unit;
    moments_.has_unit = columns_.time_column.has_unit;
    moments_.stated_rate = columns_.rate;
    moments_.rate_source = "The description beside the file";
    moments_.moment = "frame";
    moments_.place = [this, &first_rows](std::size_t moment) {
      return place_at(rows_.cursor(), all_[first_rows[moment]].start);
    };
    return timing_of(moments_, file(), options_);
  }

  PointRecording finished() {
    const std::vector<std::size_t> first_rows = rows_of_moments();
    const FrameTiming times = timing(first_rows);
    PointRecording recording;
    recording.points = point_names();
    recording.frames_per_second = times.frames_per_second;
    recording.subjects = subjects_.names();
    recording.subject = subject_;
    if (columns_.unit) {
      recording.unit = std::string(columns_.unit->name);
      recording.metres_per_unit = columns_.unit->metres;
    }
    place_rows(first_rows, times, recording);
    recording.notes = std::move(notes_);
    recording.notes.insert(recording.notes.end(), times.notes.begin(), times.notes.end());
    note_left_out(columns_.left_out, recording.notes);
    if (partial_ > 0)
      recording.notes.push_back("In " + std::to_string(partial_) +
                                (partial_ == 1 ? " row" : " rows") +
                                " only one or two coordinates are given; the point is taken "
                                "as missing there.");
    if (other_trajectories_ > 0)
      recording.notes.push_back("Rows of other trajectories than " +
                                in_quotes(trajectories_.names()[0]) + " were left out (" +
                                std::to_string(other_trajectories_) + ").");
    return recording;
  }

  /// Without the model where the name alone is different from all others.
  std::vector<std::string> point_names() {
    if (columns_.model < 0) return points_.names();
    std::unordered_map<std::string_view, int> count;
    const auto name_of = [](std::string_view key) { return key.substr(0, key.find('\n')); };
    for (const std::string& key : points_.names()) ++count[name_of(key)];
    std::vector<std::string> names;
    for (const std::string& key : points_.names()) {
      const std::string_view name = name_of(key);
      names.push_back(count[name] == 1 ? std::string(name)
                                       : key.substr(name.size() + 1) + " " + std::string(name));
    }
    return distinct_point_names(std::move(names), notes_);
  }

  void place_rows(const std::vector<std::size_t>& first_rows, const FrameTiming& times,
                  PointRecording& recording) const {
    const std::size_t points = recording.points.size();
    require_present_size({file()}, points, times.frame_count, rows_.cursor().text.size());
    const std::size_t cells = static_cast<std::size_t>(times.frame_count) * points;
    recording.positions.assign(cells, Vec3::Zero());
    recording.seen.assign(cells, false);
    std::vector<bool> is_given(cells, false);
    std::size_t moment = 0;
    for (const LongRow& row : all_) {
      if (row.point == of_another) continue;
      if (all_[first_rows[moment]].moment != row.moment) {
        const auto found = std::ranges::lower_bound(first_rows, row.moment, {},
                                                    [&](std::size_t r) { return all_[r].moment; });
        moment = static_cast<std::size_t>(found - first_rows.begin());
      }
      const std::size_t to = static_cast<std::size_t>(times.frame_of[moment]) * points + row.point;
      if (is_given[to])
        fail(rows_.cursor(), row.start,
             "the point " + in_quotes(recording.points[row.point]) + " occurs twice in a frame",
             "keep one of the rows");
      is_given[to] = true;
      recording.positions[to] = row.position;
      recording.seen[to] = row.is_seen;
    }
  }

  TableRows& rows_;
  const LongColumns& columns_;
  const ReadOptions& options_;
  DecimalMarks marks_;
  MomentTimes moments_;
  NameList points_;
  NameList subjects_;
  NameList trajectories_;
  std::string key_;
  std::vector<LongRow> all_;
  std::string subject_;
  std::vector<std::string> notes_;
  std::size_t partial_ = 0;
  std::size_t other_trajectories_ = 0;
};

}  // namespace

std::optional<LongColumns> long_columns(const std::vector<std::string>& names) {
  LongColumns columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int column = static_cast<int>(i);
    const std::optional<AxisName> axis = axis_name(names[i]);
    if (axis && axis->base.empty() && axis->axis < 3) {
      int& of_axis = columns.axis[static_cast<std::size_t>(axis->axis)];
      if (of_axis >= 0) return std::nullopt;
      of_axis = column;
      if (axis->unit) columns.unit = axis->unit;
      continue;
    }
    const NamedColumn named = named_column(names[i]);
    int LongColumns::*const use = named.use == ColumnUse::frame        ? &LongColumns::frame
                                  : named.use == ColumnUse::time       ? &LongColumns::time
                                  : named.use == ColumnUse::point      ? &LongColumns::point
                                  : named.use == ColumnUse::subject    ? &LongColumns::subject
                                  : named.use == ColumnUse::model      ? &LongColumns::model
                                  : named.use == ColumnUse::trajectory ? &LongColumns::trajectory
                                                                       : nullptr;
    if (use == nullptr || columns.*use >= 0) {
      if (!names[i].empty()) columns.left_out.push_back(names[i]);
      continue;
    }
    columns.*use = column;
    if (named.use == ColumnUse::time) columns.time_column = named;
  }
  const bool has_all = columns.point >= 0 && columns.axis[0] >= 0 && columns.axis[1] >= 0 &&
                       columns.axis[2] >= 0 && (columns.frame >= 0 || columns.time >= 0);
  return has_all ? std::optional(columns) : std::nullopt;
}

PointRecording read_long_rows(TableRows& rows, const LongColumns& columns,
                              const ReadOptions& options) {
  return LongReader(rows, columns, options).read();
}

}  // namespace mien::motion
