#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// What a file of positions (.npy) does not say itself: "walk.npy.json" beside "walk.npy".
struct NpyDescription {
  std::string file;                 ///< its path
  std::vector<std::string> points;  ///< names, in the order of the array
  double frames_per_second = 30.0;
  std::string unit;  ///< of the positions: "m"; empty if it is not known
};

/// The description of the points as JSON: unit and meaning of the array, and what
/// point_description.h adds.
std::string npy_description(const PointRecording& points, const std::string& axes);

/// The description beside a file; none if there is no such file, or if it is another JSON, without
/// `points`. Throws mien::Error with its path if `points`, `frames_per_second` or `unit` cannot be
/// used.
std::optional<NpyDescription> read_npy_description(const std::filesystem::path& npy);

}  // namespace mien::motion
