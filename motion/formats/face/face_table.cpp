#include "motion/formats/face/face_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "motion/formats/table/table_rows.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_weights = 20'000'000;  // 52 of them for 106 minutes at 60 a second

constexpr double day = 86400.0;  // seconds

enum class TimeColumn { seconds, frames, timecode };

struct TimeWord {
  std::string_view name;
  TimeColumn kind;
};

constexpr TimeWord time_words[] = {
    {"time", TimeColumn::seconds},    {"time_s", TimeColumn::seconds},
    {"seconds", TimeColumn::seconds}, {"timestamp", TimeColumn::seconds},
    {"frame", TimeColumn::frames},    {"timecode", TimeColumn::timecode},
};

constexpr std::string_view skipped_words[] = {
    "BlendshapeCount", "HeadYaw",     "HeadPitch",   "HeadRoll",      "LeftEyeYaw",
    "LeftEyePitch",    "LeftEyeRoll", "RightEyeYaw", "RightEyePitch", "RightEyeRoll"};

/// The columns of a table by its first row.
struct Columns {
  std::size_t time = 0;
  TimeColumn kind = TimeColumn::seconds;
  std::vector<std::size_t> weights;  ///< one for each curve
};

/// A moment of a timecode: whole seconds, and frames within the second.
struct Timecode {
  double seconds = 0.0;
  double frames = 0.0;
};

/// The moments of a table as written.
struct Moments {
  std::vector<double> numbers;  ///< seconds or frames
  std::vector<Timecode> codes;
};

std::optional<TimeColumn> time_column(std::string_view name) {
  for (const TimeWord& word : time_words)
    if (same_word(word.name, name)) return word.kind;
  return std::nullopt;
}

bool is_skipped(std::string_view name) {
  return std::ranges::any_of(skipped_words,
                             [&](std::string_view word) { return same_word(word, name); });
}

Columns columns_of(const TableRows& rows, FaceTrack& track) {
  Columns columns;
  std::optional<std::size_t> time;
  for (std::size_t i = 0; i < rows.fields().size(); ++i) {
    const std::string_view name = rows.field(i);
    if (const std::optional<TimeColumn> kind = time_column(name)) {
      if (time) rows.refuse(i, "a second column of times", "keep one of them");
      time = i;
      columns.kind = *kind;
    } else if (!name.empty() && !is_skipped(name)) {
      const auto is_same = [&](const FaceCurve& curve) { return same_word(curve.name, name); };
      if (std::ranges::any_of(track, is_same))
        rows.refuse(i, "a second column " + in_quotes(name), "keep one of them");
      columns.weights.push_back(i);
      track.emplace_back().name = name;
    }
  }
  if (!time)
    rows.refuse(0, "the first row names no column of times",
                "call it time (seconds), frame or Timecode");
  if (track.empty())
    rows.refuse(0, "there are no columns of weights", "name each by its expression");
  columns.time = *time;
  return columns;
}

double weight_in(const TableRows& rows, std::size_t column, const std::string& name) {
  const std::string_view text = rows.field(column);
  const std::optional<double> weight = as_written_number(text);
  if (!weight)
    rows.refuse(column, excerpt(name) + ": " + in_quotes(text) + " is not a number",
                "write a weight from 0 to 1");
  if (*weight < 0.0 || *weight > 1.0)
    rows.refuse(column, excerpt(name) + ": the weight " + std::string(text) + " is not from 0 to 1",
                "divide percentages by 100");
  return *weight;
}

/// "10:21:42:09.123", or with other separators before the frames (";" for drop-frame).
std::optional<Timecode> timecode_of(std::string_view text) {
  std::array<double, 4> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t end = i == 3 ? text.size() : text.find_first_of(":;");
    if (end == std::string_view::npos) return std::nullopt;
    const std::optional<double> number = as_finite_number(text.substr(0, end));
    if (!number || *number < 0.0) return std::nullopt;
    parts[i] = *number;
    text.remove_prefix(i == 3 ? end : end + 1);
  }
  if (parts[1] >= 60.0 || parts[2] >= 60.0 || parts[3] >= 1000.0) return std::nullopt;
  return Timecode{3600.0 * parts[0] + 60.0 * parts[1] + parts[2], parts[3]};
}

void add_moment(const TableRows& rows, const Columns& columns, Moments& moments) {
  const std::string_view text = rows.field(columns.time);
  if (columns.kind != TimeColumn::timecode) {
    const std::optional<double> number = as_written_number(text);
    if (!number || std::abs(*number) > 1e12)
      rows.refuse(columns.time, "the time " + in_quotes(text) + " is not a number",
                  "write seconds, or numbers of frames");
    return moments.numbers.push_back(*number);
  }
  const std::optional<Timecode> code = timecode_of(text);
  if (!code)
    rows.refuse(columns.time, in_quotes(text) + " is not a timecode",
                "write hours:minutes:seconds:frames, such as 10:21:42:09");
  moments.codes.push_back(*code);
}

/// The least usual rate with so many frames in a second; 60 without a whole second.
double rate_of(const std::vector<Timecode>& codes) {
  constexpr double usual[] = {24.0, 25.0, 30.0, 50.0, 60.0};
  double span = codes.back().seconds - codes.front().seconds;
  if (span < 0.0) span += day;  // it is past midnight
  double most = 0.0;
  for (const Timecode& code : codes) most = std::max(most, std::floor(code.frames));
  const double least = span >= 2.0 ? most + 1.0 : 60.0;
  for (const double rate : usual)
    if (rate >= least) return rate;
  return least;
}

std::vector<double> seconds_of(const Moments& moments, const Columns& columns, double rate) {
  std::vector<double> seconds = moments.numbers;
  for (const Timecode& code : moments.codes) seconds.push_back(code.seconds + code.frames / rate);
  if (columns.kind == TimeColumn::frames)
    for (double& time : seconds) time /= rate;
  double shift = -seconds.front();
  double before = 0.0;
  for (double& time : seconds) {
    const bool is_past_midnight =
        columns.kind == TimeColumn::timecode && time + shift < before - 0.5 * day;
    if (is_past_midnight) shift += day;
    time += shift;
    before = time;
  }
  return seconds;
}

/// Refuses the first row whose time is not after that of the row before.
void require_increasing(std::string_view text, const std::string& file,
                        const std::vector<double>& seconds, std::size_t time_column) {
  const auto stop = std::ranges::adjacent_find(seconds, std::greater_equal<>());
  if (stop == seconds.end()) return;
  TableRows rows(text, file, separator_of(text));
  const auto row = (stop - seconds.begin()) + 2;  // after the first row, which has the names
  for (std::ptrdiff_t i = 0; i <= row; ++i) rows.next();
  rows.refuse(time_column, "the time is not after that of the row before",
              "sort the rows, or state the frames per second of the timecode (fps)");
}

}  // namespace

FaceTrack parse_face_table(std::string_view text, const std::string& file_name,
                           std::optional<double> frames_per_second) {
  TableRows rows(text, file_name, separator_of(text));
  if (!rows.next())
    throw Error({file_name}, "the table is empty", "write a row of names and a row per moment");
  FaceTrack track;
  const Columns columns = columns_of(rows, track);
  if (columns.kind == TimeColumn::frames && !frames_per_second)
    rows.refuse(columns.time, "the table counts frames without stating their rate",
                "state the frames per second (fps)");
  if (columns.kind == TimeColumn::seconds && frames_per_second)
    rows.refuse(columns.time, "its times are in seconds, so that it has no rate of frames",
                "omit fps");
  Moments moments;
  while (rows.next()) {
    if ((track.front().values.size() + 1) * track.size() > most_weights)
      rows.refuse(0, "there are more weights than supported", "cut the table into shorter ones");
    add_moment(rows, columns, moments);
    for (std::size_t i = 0; i < track.size(); ++i)
      track[i].values.push_back(weight_in(rows, columns.weights[i], track[i].name));
  }
  if (track.front().values.empty())
    throw Error({file_name}, "the table has no rows below the names", "write a row per moment");
  const double rate = frames_per_second       ? *frames_per_second
                      : moments.codes.empty() ? 1.0
                                              : rate_of(moments.codes);
  const std::vector<double> seconds = seconds_of(moments, columns, rate);
  require_increasing(text, file_name, seconds, columns.time);
  for (FaceCurve& curve : track) curve.times = seconds;
  return track;
}

FaceTrack read_face_table(const std::filesystem::path& path,
                          std::optional<double> frames_per_second) {
  return parse_face_table(read_contents(path), path.string(), frames_per_second);
}

}  // namespace mien::motion
