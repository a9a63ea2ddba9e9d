#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"
#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// When the moments of a recording were taken: rows of a table, or frames of a list.
struct MomentTimes {
  std::size_t count = 0;
  std::vector<std::int64_t> numbers;  ///< of the frames, increasing; empty if there are none
  /// In the unit of the file; NaN where missing, which only moments with numbers may have. Empty
  /// if there are none.
  std::vector<double> times;
  double last_digit = 0.0;        ///< value of the last decimal of the times as written; 0: none
  double seconds_per_unit = 1.0;  ///< of the times
  bool has_unit = true;           ///< whether the file states the unit of time
  std::optional<double> stated_rate;  ///< frames per second that the file states elsewhere
  std::string rate_source;            ///< "The header", to begin a sentence about `stated_rate`
  std::function<Place(std::size_t)> place;  ///< of a moment, for messages
  std::string moment = "row";               ///< what the messages call a moment
};

/// Notes the last decimal of a time as written ("0.0083": 0.0001) if it is the finest so far.
void note_last_digit(MomentTimes& moments, std::string_view written);

/// The frames that moments belong to.
struct FrameTiming {
  double frames_per_second = 30.0;
  std::vector<std::int64_t> frame_of;  ///< frame of each moment, from 0
  std::int64_t frame_count = 0;        ///< including frames that no moment belongs to
  std::vector<std::string> notes;
};

/// The frames by the numbers, or else by the times, or else one after another; and the frame rate:
/// the one by the times, or else the stated one, or else that of the options. Missing moments leave
/// gaps.
///
/// - Times are even if each differs by no more than a last digit and a hundredth of a frame from a
///   regular grid. The rate is the stated one, or else a usual one (frame_rate.h), if the times as
///   written are also those of it.
/// - If all steps of the numbers are multiples of n, each n-th is a frame.
/// - A time column without a unit is in seconds; if that would be a frame a second or fewer, and
///   five or more in milliseconds, it is in milliseconds, and a note says so.
///
/// Throws mien::Error at the moment concerned if times are not even and the options give no rate,
/// or numbers do not increase, and if there is no rate. Sizes are not limited here.
FrameTiming timing_of(const MomentTimes& moments, const std::string& file,
                      const ReadOptions& options);

/// Throws mien::Error if points × frames are more than what a file of so many bytes can reasonably
/// mean, as when a frame number is corrupt, or more than can be read (recording_limits.h).
void require_present_size(const Place& place, std::size_t points, std::int64_t frames,
                          std::size_t bytes);

}  // namespace mien::motion
