#include "motion/formats/table/frame_times.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "motion/formats/reading/frame_rate.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/reading/recording_limits.h"

namespace mien::motion {

namespace {

constexpr double least_rate = 1e-3;
constexpr double greatest_rate = 1e5;
std::string ask_for_rate() {
  return std::string("state the frames per second with ") + rate_option;
}

/// "119.88"
std::string short_number(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                          std::chars_format::general, 6);
  return {digits.data(), end};
}

/// A regular grid of times on which moments lie.
struct TimeGrid {
  double period = 0.0;  ///< of a frame, in the unit of the file
  double tolerance = 0.0;
  double deviation = 0.0;  ///< largest distance of a time from its frame
  std::vector<std::int64_t> frame_of;
  std::optional<std::size_t> off_grid;  ///< the first moment that does not lie on it
};

/// The grid through the first and last time, given the frames.
TimeGrid grid_with(const MomentTimes& moments, std::vector<std::int64_t> frame_of) {
  TimeGrid grid;
  grid.frame_of = std::move(frame_of);
  const auto is_given = [](double time) { return !std::isnan(time); };
  const auto first = std::ranges::find_if(moments.times, is_given);
  const auto last = std::find_if(moments.times.rbegin(), moments.times.rend(), is_given);
  const auto from = static_cast<std::size_t>(first - moments.times.begin());
  const auto to = static_cast<std::size_t>(moments.times.rend() - last) - 1;
  const std::int64_t frames = grid.frame_of[to] - grid.frame_of[from];
  grid.period = (*last - *first) / static_cast<double>(frames);
  grid.tolerance = 1.01 * moments.last_digit + 0.01 * grid.period;
  if (!(grid.period > 0.0)) {
    grid.off_grid = to;
    return grid;
  }
  for (std::size_t i = from; i <= to && !grid.off_grid; ++i) {
    if (std::isnan(moments.times[i])) continue;
    const auto since = static_cast<double>(grid.frame_of[i] - grid.frame_of[from]);
    const double on_grid = *first + since * grid.period;
    grid.deviation = std::max(grid.deviation, std::abs(moments.times[i] - on_grid));
    if (grid.deviation > grid.tolerance) grid.off_grid = i;
  }
  return grid;
}

/// The grid whose period is the median step, with gaps where steps are longer.
TimeGrid grid_with_gaps(const MomentTimes& moments) {
  std::vector<double> steps(moments.count - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = moments.times[i + 1] - moments.times[i];
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  TimeGrid grid;
  std::vector<std::int64_t> frame_of(moments.count, 0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double frames = *middle > 0.0 ? std::round(steps[i] / *middle) : 0.0;
    if (!(frames >= 1.0 && frames < 1e9)) {
      grid.off_grid = i + 1;
      return grid;
    }
    frame_of[i + 1] = frame_of[i] + static_cast<std::int64_t>(frames);
  }
  return grid_with(moments, std::move(frame_of));
}

std::vector<std::int64_t> one_after_another(std::size_t count) {
  std::vector<std::int64_t> frames(count);
  std::iota(frames.begin(), frames.end(), std::int64_t{0});
  return frames;
}

std::vector<std::int64_t> frames_by_number(const MomentTimes& moments, FrameTiming& timing) {
  std::int64_t common = 0;
  for (std::size_t i = 1; i < moments.count; ++i) {
    const std::int64_t step = moments.numbers[i] - moments.numbers[i - 1];
    if (step <= 0) {
      throw Error(moments.place(i),
                  "frame " + std::to_string(moments.numbers[i]) + " follows frame " +
                      std::to_string(moments.numbers[i - 1]),
                  "put the frames in order, each once");
    }
    common = std::gcd(common, step);
  }
  common = std::max<std::int64_t>(common, 1);
  if (common > 1)
    timing.notes.push_back("The frame numbers are multiples of " + std::to_string(common) +
                           " apart: each " + std::to_string(common) + "th is one frame.");
  std::vector<std::int64_t> frames(moments.count);
  for (std::size_t i = 0; i < moments.count; ++i)
    frames[i] = (moments.numbers[i] - moments.numbers[0]) / common;
  return frames;
}

[[noreturn]] void refuse_uneven(const MomentTimes& moments, std::size_t moment) {
  const std::string place_name = moments.moment + " " + std::to_string(moment + 1);
  throw Error(moments.place(moment),
              "the times are not evenly spaced: that of " + place_name + ", " +
                  short_number(moments.times[moment]) + ", does not fit the others",
              "resample the motion at even times, or, to take the " + moments.moment +
                  "s as evenly spaced, " + ask_for_rate());
}

/// Seconds per unit of the times, where they state none: a choice by how many frames a second
/// there would be.
double seconds_per_unit(const MomentTimes& moments, double period, FrameTiming& timing) {
  if (moments.has_unit || period < 1.0 || period > 200.0) return moments.seconds_per_unit;
  timing.notes.emplace_back(
      "The time column states no unit; it is taken as milliseconds, because in seconds there would "
      "be no more than one frame a second.");
  return 1e-3;
}

/// The stated rate if the times as written are also those of it, or else the nearest whole or NTSC
/// rate for which this is so, or else the rate of the period.
double rate_of(const MomentTimes& moments, const TimeGrid& grid, double in_seconds) {
  const double rate = 1.0 / (grid.period * in_seconds);
  const auto frames = static_cast<double>(grid.frame_of.back());
  const double rounding = 1.01 * moments.last_digit + 1e-9 * grid.period;
  const auto agrees = [&](double other) {
    return std::abs(1.0 / (other * in_seconds) - grid.period) * frames <= rounding;
  };
  if (moments.stated_rate && *moments.stated_rate > 0.0 && agrees(*moments.stated_rate))
    return *moments.stated_rate;
  for (const double usual : {std::round(rate), snapped_frame_rate(rate)}) {
    if (usual >= 1.0 && agrees(usual)) return usual;
  }
  return rate;
}

bool has_times(const MomentTimes& moments) {
  return std::ranges::count_if(moments.times, [](double t) { return !std::isnan(t); }) > 1;
}

/// Sets the frames, and returns the rate by the times; nothing without times.
std::optional<double> place_in_time(const MomentTimes& moments, FrameTiming& timing,
                                    bool is_rate_told) {
  if (!moments.numbers.empty()) {
    timing.frame_of = frames_by_number(moments, timing);
  } else {
    timing.frame_of = one_after_another(moments.count);
  }
  if (!has_times(moments)) return std::nullopt;
  TimeGrid grid = grid_with(moments, timing.frame_of);
  if (moments.numbers.empty()) {
    // With few decimals, times with a gap may lie near a coarser grid without one.
    TimeGrid with_gaps = grid_with_gaps(moments);
    const bool fits = !with_gaps.off_grid && with_gaps.frame_of.back() > grid.frame_of.back();
    if (fits && (grid.off_grid || with_gaps.deviation < 0.5 * grid.deviation)) {
      grid = std::move(with_gaps);
      timing.frame_of = grid.frame_of;
    }
  }
  if (grid.off_grid) {
    if (!is_rate_told) refuse_uneven(moments, *grid.off_grid);
    timing.notes.push_back("The times are not evenly spaced; the " + moments.moment +
                           "s are taken as frames at the " +
                           (moments.stated_rate ? "stated" : "given") + " rate.");
    return std::nullopt;
  }
  const double in_seconds = seconds_per_unit(moments, grid.period, timing);
  return rate_of(moments, grid, in_seconds);
}

void require_usable_rate(double rate, const std::string& file) {
  if (rate >= least_rate && rate <= greatest_rate) return;
  throw Error({file}, short_number(rate) + " frames per second are not usable", ask_for_rate());
}

}  // namespace

void note_last_digit(MomentTimes& moments, std::string_view written) {
  constexpr std::size_t most_decimals = 15;
  if (written.find_first_of("eE") != std::string_view::npos) return;
  const std::size_t mark = written.find_first_of(".,");
  const std::size_t decimals = mark == std::string_view::npos ? 0 : written.size() - mark - 1;
  const double digit = std::pow(10.0, -static_cast<double>(std::min(decimals, most_decimals)));
  // Zeros at the end are often not written, so that the coarsest number says little.
  if (moments.last_digit == 0.0 || digit < moments.last_digit) moments.last_digit = digit;
}

FrameTiming timing_of(const MomentTimes& moments, const std::string& file,
                      const ReadOptions& options) {
  FrameTiming timing;
  const std::optional<double> told = options.frames_per_second;
  const std::optional<double> timed = place_in_time(moments, timing, told.has_value());
  timing.frame_count = timing.frame_of.empty() ? 0 : timing.frame_of.back() + 1;
  const std::optional<double> rate = timed                 ? timed
                                     : moments.stated_rate ? moments.stated_rate
                                                           : told;
  if (!rate) throw Error({file}, "states no frame rate", ask_for_rate());
  require_usable_rate(*rate, file);
  timing.frames_per_second = *rate;
  if (moments.stated_rate && std::abs(*moments.stated_rate / *rate - 1.0) > 0.005)
    timing.notes.push_back(moments.rate_source + " says " + short_number(*moments.stated_rate) +
                           " Hz, but the times are those of " + short_number(*rate) +
                           " Hz, which is used.");
  const auto missing = timing.frame_count - static_cast<std::int64_t>(moments.count);
  if (missing > 0)
    timing.notes.push_back(std::to_string(missing) + " of " + std::to_string(timing.frame_count) +
                           " frames have no " + moments.moment + "; they are gaps.");
  return timing;
}

void require_present_size(const Place& place, std::size_t points, std::int64_t frames,
                          std::size_t bytes) {
  constexpr std::size_t positions_per_byte = 16;
  constexpr std::size_t always_allowed = 1'000'000;
  const auto count = static_cast<std::size_t>(frames);
  if (points > 0 && count > (bytes * positions_per_byte + always_allowed) / points)
    throw Error(place,
                std::to_string(count) + " frames of " + std::to_string(points) +
                    " points are far more than the file holds",
                "check the numbers or times of the frames");
  if (!is_reasonable_size(points, count))
    throw Error(place,
                std::to_string(count) + " frames of " + std::to_string(points) +
                    " points are more than can be read",
                "keep the points of one person, or cut the recording into shorter files");
}

}  // namespace mien::motion
