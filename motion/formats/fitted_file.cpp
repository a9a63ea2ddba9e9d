#include "motion/formats/fitted_file.h"

#include <utility>
#include <variant>

#include "motion/fitting/recorded_points.h"
#include "motion/formats/motion_file.h"

namespace mien::motion {

FittedFile read_fitted(const std::filesystem::path& path, const ReadOptions& options) {
  FileContents contents = read_file(path, options);
  if (auto* recording = std::get_if<Recording>(&contents)) return {std::move(*recording), {}};
  RecordedPoints points = recorded_points(std::get<PointRecording>(contents));
  FittedFile file{std::move(points.recording), {}};
  if (points.fit) file.fit = std::move(*points.fit);
  return file;
}

}  // namespace mien::motion
