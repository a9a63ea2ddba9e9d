#include "motion/formats/written_motion.h"

#include <cassert>
#include <utility>

#include "motion/error.h"
#include "motion/points/joint_points.h"
#include "motion/text/compressed_file.h"

namespace mien::motion {

namespace {

/// The files of a path with their bytes, which are in the same order.
std::vector<ResultBytes> joined(std::vector<std::filesystem::path> files,
                                std::vector<std::string> bytes) {
  assert(files.size() == bytes.size());
  std::vector<ResultBytes> results;
  for (std::size_t i = 0; i < files.size(); ++i)
    results.push_back({std::move(files[i]), std::move(bytes[i])});
  return results;
}

}  // namespace

const MotionFormat& written_format(const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  if (format == nullptr || !format->is_written()) {
    throw Error({path.string(), 0, 0}, "is not a motion file that can be written",
                "use " + formats_written());
  }
  if (without_compression(path) != path) {
    throw Error({path.string(), 0, 0}, "would be compressed, but compressed files are only read",
                "write " + without_compression(path).filename().string());
  }
  if (format->require_name != nullptr) format->require_name(path);
  return *format;
}

std::vector<std::filesystem::path> companion_files(const std::filesystem::path& path) {
  const MotionFormat* format = motion_format(path);
  const std::string name = without_compression(path).filename().string();
  if (format == nullptr || name.size() < format->written_ending.size()) return {};
  const std::string beginning = name.substr(0, name.size() - format->written_ending.size());
  std::vector<std::filesystem::path> files;
  for (const std::string_view companion : format->companions)
    if (!companion.empty())
      files.push_back(path.parent_path() / (beginning + std::string(companion)));
  return files;
}

std::vector<std::filesystem::path> written_files(const std::filesystem::path& path) {
  (void)written_format(path);
  std::vector<std::filesystem::path> files = companion_files(path);
  files.insert(files.begin(), path);
  return files;
}

std::vector<ResultBytes> motion_files(const Recording& recording,
                                      const std::filesystem::path& path) {
  const MotionFormat& format = written_format(path);
  if (!format.holds_points()) return {{path, format.bytes_of_motion(recording)}};
  const PointFile file{path.filename().string(), "right-handed, +Y up"};
  return joined(written_files(path), format.bytes_of_points(joint_points(recording), file));
}

std::vector<ResultBytes> point_files(const PointRecording& points,
                                     const std::filesystem::path& path) {
  const MotionFormat& format = written_format(path);
  assert(format.holds_points());
  return joined(written_files(path),
                format.bytes_of_points(points, {.name = path.filename().string()}));
}

void write_motion(const Recording& recording, const std::filesystem::path& path) {
  write_results(motion_files(recording, path));
}

}  // namespace mien::motion
