#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/formats/c3d/c3d_parameters.h"
#include "motion/formats/reading/read_options.h"

namespace mien::motion {

/// Where the points of a C3D file lie: frame after frame, four values for each point (x, y, z and
/// one that is negative if the point was not seen), then the analog values of the frame.
struct C3dLayout {
  std::size_t points = 0;  ///< in each frame
  std::size_t analog = 0;  ///< analog values in each frame
  bool is_real = false;    ///< values are floats; otherwise 16-bit integers, times `scale`
  double scale = 1.0;
  std::size_t start = 0;     ///< byte of the first frame
  std::size_t frames = 0;    ///< as many as are to be read: all of them are in the file
  double first_frame = 1.0;  ///< number that the file gives its first frame
  double frames_per_second = 0.0;

  std::size_t value_bytes() const { return is_real ? 4 : 2; }
  std::size_t frame_bytes() const { return (4 * points + analog) * value_bytes(); }
};

/// Number of points in each frame, of POINT:USED or else of the header.
std::size_t c3d_point_count(const C3dFile& file);

/// Number that the file gives its first frame, of TRIAL:ACTUAL_START_FIELD or else of the header.
double c3d_first_frame(const C3dFile& file);

/// The frame rate of points that the file states: POINT:RATE, or else that of the header.
std::optional<double> c3d_stated_rate(const C3dFile& file, std::vector<std::string>& notes);

/// The rate of the options, for a file that states none. Throws mien::Error if there is none.
double c3d_given_rate(const C3dFile& file, const ReadOptions& options);

/// The layout of a file that has points. The header's numbers of frames end at 65,535: a larger one
/// is taken from TRIAL:ACTUAL_START_FIELD and ACTUAL_END_FIELD, or from POINT:FRAMES, or else from
/// the size of the file. A file that ends before its last frame is read as far as its frames are
/// complete, with a note. Throws mien::Error if there is no complete frame.
C3dLayout c3d_layout(const C3dFile& file, const ReadOptions& options,
                     std::vector<std::string>& notes);

}  // namespace mien::motion
