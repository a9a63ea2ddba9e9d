#include "motion/formats/c3d/c3d_layout.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/formats/c3d/c3d_bytes.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/reading/recording_limits.h"
#include "motion/text/plain_number.h"

namespace mien::motion {

namespace {

constexpr std::size_t largest_word = 65'535;

// Words of the header, from 1 as in the format's description.
constexpr int word_of_points = 2;
constexpr int word_of_analog = 3;
constexpr int word_of_first_frame = 4;
constexpr int word_of_last_frame = 5;
constexpr int word_of_scale = 7;
constexpr int word_of_data_start = 9;
constexpr int word_of_rate = 11;

const char* header_at(const C3dFile& file, int word) { return file.bytes.data() + 2 * (word - 1); }

std::size_t header_word(const C3dFile& file, int word) {
  return c3d_word(header_at(file, word), file.processor);
}

bool is_rate(double value) { return std::isfinite(value) && value > 1e-3 && value < 1e6; }

/// A frame number of two words, the lower one first; 0 if it is not stated.
std::size_t long_number(const C3dFile& file, std::string_view name) {
  const std::size_t low = c3d_count(file, name).value_or(0);
  const std::size_t high = c3d_count(file, name, 1).value_or(0);
  return high <= largest_word && low <= largest_word ? high << 16 | low : low;
}

std::size_t actual_frames(const C3dFile& file) {
  const std::size_t first = long_number(file, "TRIAL:ACTUAL_START_FIELD");
  const std::size_t last = long_number(file, "TRIAL:ACTUAL_END_FIELD");
  return first >= 1 && last >= first ? last - first + 1 : 0;
}

/// The number of frames that the file states; 0 if it states none.
std::size_t stated_frames(const C3dFile& file, std::size_t held) {
  const std::size_t first = header_word(file, word_of_first_frame);
  const std::size_t last = header_word(file, word_of_last_frame);
  const std::size_t actual = actual_frames(file);
  const std::size_t counted = c3d_count(file, "POINT:FRAMES").value_or(0);
  // Beyond what a word holds, the header is at its limit or begins again at zero.
  for (const std::size_t larger : {actual, counted}) {
    if (larger > largest_word && larger <= held) return larger;
  }
  if (last < largest_word && first <= last && last > 0)
    return last - std::max<std::size_t>(first, 1) + 1;
  if (actual > 0) return actual;
  return counted == largest_word ? 0 : counted;
}

std::size_t data_start(const C3dFile& file) {
  const std::size_t parameters = byte_at(file.bytes.data());
  for (const std::size_t block :
       {c3d_count(file, "POINT:DATA_START").value_or(0), header_word(file, word_of_data_start)}) {
    if (block > parameters && (block - 1) * block_bytes < file.bytes.size())
      return (block - 1) * block_bytes;
  }
  throw Error({file.name}, "the file ends before its points begin",
              "obtain the file again, it is cut short");
}

double scale_of(const C3dFile& file) {
  const double scale = c3d_number(file, "POINT:SCALE")
                           .value_or(c3d_real(header_at(file, word_of_scale), file.processor));
  if (std::isfinite(scale) && scale != 0.0) return scale;
  throw Error({file.name}, "POINT:SCALE is no scale, so the unit of its integers is unknown",
              "export the file again, with floating-point numbers");
}

}  // namespace

std::size_t c3d_point_count(const C3dFile& file) {
  return c3d_count(file, "POINT:USED").value_or(header_word(file, word_of_points));
}

double c3d_first_frame(const C3dFile& file) {
  const std::size_t actual = long_number(file, "TRIAL:ACTUAL_START_FIELD");
  const std::size_t first = actual > 0 ? actual : header_word(file, word_of_first_frame);
  return static_cast<double>(std::max<std::size_t>(first, 1));
}

std::optional<double> c3d_stated_rate(const C3dFile& file, std::vector<std::string>& notes) {
  const double stated = c3d_number(file, "POINT:RATE").value_or(0.0);
  const double in_header = c3d_real(header_at(file, word_of_rate), file.processor);
  if (!is_rate(stated)) return is_rate(in_header) ? std::optional(in_header) : std::nullopt;
  if (is_rate(in_header) && std::abs(in_header - stated) > 1e-3 * stated) {
    notes.push_back("The header says " + plain_number(in_header) + " Hz, but POINT:RATE says " +
                    plain_number(stated) + " Hz, which is used.");
  }
  return stated;
}

double c3d_given_rate(const C3dFile& file, const ReadOptions& options) {
  if (options.frames_per_second) return *options.frames_per_second;
  throw Error({file.name}, "states no frame rate", std::string("state it with ") + rate_option);
}

C3dLayout c3d_layout(const C3dFile& file, const ReadOptions& options,
                     std::vector<std::string>& notes) {
  C3dLayout layout;
  layout.points = c3d_point_count(file);
  layout.analog = header_word(file, word_of_analog);
  const double scale = scale_of(file);
  layout.is_real = scale < 0.0;
  layout.scale = layout.is_real ? 1.0 : scale;
  layout.start = data_start(file);
  layout.first_frame = c3d_first_frame(file);
  const std::optional<double> stated_rate = c3d_stated_rate(file, notes);
  layout.frames_per_second = stated_rate ? *stated_rate : c3d_given_rate(file, options);
  const std::size_t held = (file.bytes.size() - layout.start) / layout.frame_bytes();
  const std::size_t stated = stated_frames(file, held);
  if (held == 0) {
    fail_c3d(file, layout.start, "there is no complete frame of points",
             "obtain the file again, it is cut short");
  }
  if (stated == 0) {
    notes.push_back("The file does not state its number of frames: " + std::to_string(held) +
                    ", by its size.");
  } else if (stated > held) {
    notes.push_back("The header says " + std::to_string(stated) +
                    " frames, but the file ends after " + std::to_string(held) +
                    ": these are read.");
  }
  layout.frames = stated == 0 ? held : std::min(stated, held);
  require_reasonable_size({file.name}, layout.points, layout.frames);
  return layout;
}

}  // namespace mien::motion
