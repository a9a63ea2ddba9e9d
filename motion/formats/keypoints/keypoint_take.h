#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/reading/read_options.h"
#include "motion/formats/table/frame_times.h"
#include "motion/math/geometry.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// A JSON file of keypoints, without its frames' values.
struct KeypointFile {
  const nlohmann::json& json;
  std::string name;
  const ReadOptions& options;
};

/// Position and whether it is seen.
struct Keypoint {
  Vec3 position = Vec3::Zero();
  bool is_seen = false;
};

/// Where the points of one person are in the JSON.
struct KeypointTake {
  std::string format;  ///< "openpose", "mediapipe", "freemocap"
  std::vector<std::string> points;
  std::vector<const nlohmann::json*> moments;  ///< the points of each moment; null if not found
  /// Reads the points of a moment, as many as `points`, which are not seen before.
  std::function<void(const nlohmann::json& moment, std::size_t frame, std::span<Keypoint> points)>
      read_points;
  MomentTimes times;
  std::string unit;
  double metres_per_unit = 0.0;
  std::vector<std::string> subjects;
  std::string subject;
  std::vector<std::string> notes;
};

/// A person found in a frame.
struct KeypointPerson {
  std::string name;
  const nlohmann::json* points = nullptr;
};

using PeopleOfFrames = std::vector<std::vector<KeypointPerson>>;

/// Takes the points of the person that the options choose, or else of the first who is found, for
/// each frame. Throws mien::Error if nobody is found.
void choose_person(const PeopleOfFrames& people, const KeypointFile& file, KeypointTake& take);

/// A coordinate; nothing if it is null, an empty text or absent (null pointer). Throws mien::Error
/// for anything else that is not a number. `frame` is counted from 0.
std::optional<double> coordinate(const nlohmann::json* value, const KeypointFile& file,
                                 std::size_t frame);

/// Names for so many points: those told, or the known ones if there are as many. Throws mien::Error
/// if the number fits neither.
std::vector<std::string> names_for(std::size_t count, const std::vector<std::string>& known,
                                   const KeypointFile& file);

/// Throws mien::Error about two-dimensional keypoints; `what` names them.
[[noreturn]] void refuse_flat(const KeypointFile& file, const std::string& what);

/// Throws mien::Error if a recording of so many bytes is more than `max_keypoint_bytes`.
void require_keypoint_bytes(std::size_t bytes, const std::string& file);

/// The recording of a file whose frames have these numbers, increasing; `bytes` is its size.
PointRecording recording_of_frames(const KeypointFile& file, std::vector<std::int64_t> numbers,
                                   std::size_t bytes);

/// Reads the frames of a folder, or all those that belong to a frame (keypoint_frames.h).
PointRecording read_keypoint_files(const std::filesystem::path& path, const ReadOptions& options);

// The layouts. `frames` are the frames of the file.

KeypointTake openpose_take(const std::vector<const nlohmann::json*>& frames,
                           const KeypointFile& file);
KeypointTake mediapipe_take(const std::vector<const nlohmann::json*>& frames,
                            const KeypointFile& file);
KeypointTake freemocap_take(const KeypointFile& file);

}  // namespace mien::motion
