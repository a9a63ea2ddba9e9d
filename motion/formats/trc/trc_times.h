#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text/text_cursor.h"

namespace mien::motion {

/// The first two cells of a row of a TRC file.
struct TrcRow {
  std::size_t at = 0;          ///< where the row begins in the text
  std::optional<long> frame;   ///< its number as written; nothing if it is not a whole number
  std::optional<double> time;  ///< seconds; nothing if the cell is empty or NaN
  int decimals = 0;            ///< of the time as written, without zeros at the end
  int digits = 0;              ///< significant digits of the time, likewise
};

/// Reads the time and its digits from a cell; throws mien::Error if it is not a number.
void read_time(const TextCursor& cursor, std::string_view cell, TrcRow& row);

/// At which frames of an evenly spaced recording the rows stand.
struct TrcFrames {
  double frames_per_second = 0.0;
  std::vector<std::size_t> frame_of_row;  ///< from 0, increasing; shorter if last rows are left out
};

/// Frames and their rate:
///
/// - The header's rate and the column Frame#, if Time agrees with them in all rows.
/// - Otherwise those of Time, with a note if the header's rate differs by more than 1 %. The rate
///   is the header's or a usual one (frame_rate.h) if Time agrees with it. Times are evenly spaced
///   if they deviate from multiples of their usual step by no more than the rounding of their
///   digits and a hundredth of a step; steps of twice the length and so on are frames without rows.
///   A last row that follows too early, as programs that resample write it, is left out.
/// - If no row has a time or all times are the same, the header's rate and Frame#, with a note.
///
/// Without a rate, or if times are not evenly spaced, the rows stand at the frames of Frame#, or
/// one after the other if these do not increase, at the header's rate or else the `given` one.
/// Throws mien::Error if none is given.
TrcFrames trc_frames(const TextCursor& cursor, const std::vector<TrcRow>& rows,
                     std::optional<double> data_rate, std::optional<double> given,
                     std::vector<std::string>& notes);

}  // namespace mien::motion
