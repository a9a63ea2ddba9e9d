#include "motion/formats/trc/trc_times.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/formats/reading/frame_rate.h"
#include "motion/formats/reading/option_names.h"
#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/plain_number.h"

namespace mien::motion {

namespace {

constexpr double most_seconds = 1e9;
constexpr double lowest_rate = 1e-3;
constexpr double highest_rate = 1e6;
constexpr double most_steps = 1e9;         // between two rows
constexpr double most_deviation = 0.4;     // of a step, however its times are rounded
constexpr double most_jitter = 0.01;       // of a step
constexpr double float_rounding = 1.2e-7;  // of times that were floats

/// Times and how exactly their digits state them.
struct Times {
  std::vector<double> seconds;
  std::vector<double> rounding;  ///< largest difference to the true time

  std::size_t size() const { return seconds.size(); }
  double step(std::size_t i) const { return seconds[i] - seconds[i - 1]; }
};

/// Zeros at the end may have been left out, and may have been added: "4.4" and "4.400000" among
/// "4.408" are as exact as that. Digits end by the largest number of decimals, and by the largest
/// number of significant digits.
Times times_of(const std::vector<TrcRow>& rows) {
  int decimals = 0;
  int digits = 0;
  for (const TrcRow& row : rows) {
    decimals = std::max(decimals, row.decimals);
    digits = std::max(digits, row.digits);
  }
  Times times;
  for (const TrcRow& row : rows) {
    const double seconds = *row.time;
    int last = decimals;  // place of the last digit
    if (seconds != 0.0) {
      const int whole = static_cast<int>(std::floor(std::log10(std::abs(seconds)))) + 1;
      last = std::min(decimals, digits - whole);
    }
    const double by_digits = 0.5 * std::pow(10.0, -last);
    times.seconds.push_back(seconds);
    times.rounding.push_back(std::max(by_digits, float_rounding * std::abs(seconds)));
  }
  return times;
}

/// The frames by the column Frame#, from the first row's; nothing if they do not increase.
std::optional<std::vector<std::size_t>> numbered_frames(const std::vector<TrcRow>& rows) {
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].frame || (i > 0 && *rows[i].frame <= *rows[i - 1].frame)) return std::nullopt;
    frames.push_back(static_cast<std::size_t>(*rows[i].frame - *rows[0].frame));
  }
  return frames;
}

std::vector<std::size_t> successive_frames(std::size_t rows) {
  std::vector<std::size_t> frames(rows);
  for (std::size_t i = 0; i < rows; ++i) frames[i] = i;
  return frames;
}

/// The first row whose time is not that of its frame at this rate; the number of rows if there is
/// none. `slack`: how often the rounding of a time may occur.
std::size_t first_deviating(const Times& times, const std::vector<std::size_t>& frames, double rate,
                            double slack) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double expected = times.seconds[0] + static_cast<double>(frames[i]) / rate;
    const double allowed =
        slack * (times.rounding[0] + times.rounding[i]) + most_jitter / rate + 1e-12;
    if (!(std::abs(times.seconds[i] - expected) <= allowed)) return i;
  }
  return frames.size();
}

[[noreturn]] void fail_at_row(const TextCursor& cursor, const TrcRow& row, std::string_view wrong) {
  fail(cursor, row.at, wrong,
       std::string("if the frames are evenly spaced all the same, state their rate with ") +
           rate_option);
}

double usual_step(const TextCursor& cursor, const std::vector<TrcRow>& rows, const Times& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    steps.push_back(times.step(i));
    if (steps.back() > 0.0) continue;
    fail_at_row(cursor, rows[i],
                "Time goes from " + plain_number(times.seconds[i - 1]) + " to " +
                    plain_number(times.seconds[i]) + " s, so it does not increase");
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

/// Frames by steps of Time, each a multiple of the usual one.
std::vector<std::size_t> stepped_frames(const TextCursor& cursor, const std::vector<TrcRow>& rows,
                                        const Times& times, double usual,
                                        std::vector<std::string>& notes) {
  std::vector<std::size_t> frames = {0};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double multiple = times.step(i) / usual;
    const double nearest = std::max(1.0, std::round(multiple));
    const double by_rounding = 2.0 * (times.rounding[i] + times.rounding[i - 1]) / usual;
    const double allowed = std::min(by_rounding + most_jitter * nearest, most_deviation);
    const bool is_even = std::abs(multiple - nearest) <= allowed && nearest < most_steps;
    if (!is_even && i + 1 == times.size() && i >= 3 && multiple < 1.0) {
      notes.push_back("The last row, at " + plain_number(times.seconds[i]) + " s, follows by " +
                      plain_number(times.step(i)) + " s instead of " + plain_number(usual) +
                      " s and is left out.");
      return frames;
    }
    if (!is_even) {
      fail_at_row(cursor, rows[i],
                  "Time advances by " + plain_number(times.step(i)) + " s, but usually by " +
                      plain_number(usual) + " s");
    }
    frames.push_back(frames.back() + static_cast<std::size_t>(nearest));
  }
  return frames;
}

TrcFrames timed_frames(const TextCursor& cursor, const std::vector<TrcRow>& rows,
                       const Times& times, std::optional<double> data_rate,
                       std::vector<std::string>& notes) {
  const double usual = usual_step(cursor, rows, times);
  TrcFrames found;
  found.frame_of_row = stepped_frames(cursor, rows, times, usual, notes);
  const std::vector<std::size_t>& frames = found.frame_of_row;
  const std::size_t last = frames.size() - 1;
  const double measured =
      static_cast<double>(frames[last]) / (times.seconds[last] - times.seconds[0]);
  if (!(measured > lowest_rate && measured < highest_rate)) {
    fail_at_row(cursor, rows[1],
                "Time advances by " + plain_number(1.0 / measured) + " s, as in no motion");
  }
  for (const double rate : {data_rate.value_or(measured), snapped_frame_rate(measured), measured}) {
    found.frames_per_second = rate;
    if (first_deviating(times, frames, rate, rate == measured ? 2.5 : 1.0) == frames.size()) break;
  }
  const std::size_t deviating = first_deviating(times, frames, found.frames_per_second, 2.5);
  if (deviating < frames.size()) {
    fail_at_row(cursor, rows[deviating],
                "Time is not evenly spaced: " + plain_number(times.seconds[deviating]) +
                    " s is no multiple of " + plain_number(1.0 / measured) + " s");
  }
  if (data_rate && std::abs(found.frames_per_second - *data_rate) > 0.01 * *data_rate) {
    notes.push_back("The header says " + plain_number(*data_rate) +
                    " Hz, but the Time column advances by " +
                    plain_number(1.0 / found.frames_per_second) +
                    " s: " + plain_number(found.frames_per_second) + " Hz is used.");
  }
  return found;
}

}  // namespace

void read_time(const TextCursor& cursor, std::string_view cell, TrcRow& row) {
  if (cell.empty() || same_word(cell, "NaN")) return;
  row.time = as_written_number(cell);
  if (!row.time || std::abs(*row.time) > most_seconds) {
    fail(cursor, row.at, "the time " + in_quotes(cell) + " is not a number of seconds",
         "correct the second cell of the row");
  }
  const std::size_t exponent_at = std::min(cell.find_first_of("eE"), cell.size());
  std::string_view mantissa = cell.substr(0, exponent_at);
  while (mantissa.ends_with('0') && mantissa.find('.') != std::string_view::npos)
    mantissa.remove_suffix(1);
  bool is_after_point = false;
  for (const char c : mantissa) {
    if (c == '.') is_after_point = true;
    if (c < '0' || c > '9') continue;
    if (c != '0' || row.digits > 0) ++row.digits;
    if (is_after_point) ++row.decimals;
  }
  if (exponent_at == cell.size()) return;
  std::string_view exponent = cell.substr(exponent_at + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  row.decimals -= std::clamp(as_number<int>(exponent).value_or(0), -1000, 1000);
}

namespace {

/// As `trc_frames`, without a given rate.
TrcFrames stated_frames(const TextCursor& cursor, const std::vector<TrcRow>& rows,
                        std::optional<double> data_rate, std::vector<std::string>& notes) {
  const std::optional<std::vector<std::size_t>> numbered = numbered_frames(rows);
  const auto untimed = std::ranges::find_if(rows, [](const TrcRow& row) { return !row.time; });
  const bool has_times = std::ranges::any_of(
      rows, [&](const TrcRow& row) { return row.time && row.time != rows[0].time; });
  if (!has_times) {
    if (!data_rate) {
      fail(cursor, 0, "neither the header nor the Time column states a frame rate",
           std::string("state it with ") + rate_option);
    }
    if (rows.size() > 1) {
      notes.push_back("The Time column is empty or does not advance: the header's " +
                      plain_number(*data_rate) + " Hz is used.");
    }
    return {*data_rate, numbered.value_or(successive_frames(rows.size()))};
  }
  if (untimed != rows.end()) fail_at_row(cursor, *untimed, "the row has no time");
  const Times times = times_of(rows);
  if (data_rate && numbered && first_deviating(times, *numbered, *data_rate, 1.0) == rows.size())
    return {*data_rate, *numbered};
  return timed_frames(cursor, rows, times, data_rate, notes);
}

}  // namespace

TrcFrames trc_frames(const TextCursor& cursor, const std::vector<TrcRow>& rows,
                     std::optional<double> data_rate, std::optional<double> given,
                     std::vector<std::string>& notes) {
  std::vector<std::string> found;
  TrcFrames frames;
  try {
    frames = stated_frames(cursor, rows, data_rate, found);
  } catch (const Error&) {
    // The rate is what the error asks for.
    if (!given) throw;
    found.clear();
    frames = {data_rate.value_or(*given),
              numbered_frames(rows).value_or(successive_frames(rows.size()))};
    const bool has_times =
        std::ranges::any_of(rows, [](const TrcRow& row) { return row.time.has_value(); });
    if (has_times)
      found.push_back("The times are not evenly spaced; the rows are taken as frames at " +
                      plain_number(frames.frames_per_second) + " Hz.");
  }
  notes.insert(notes.end(), found.begin(), found.end());
  return frames;
}

}  // namespace mien::motion
