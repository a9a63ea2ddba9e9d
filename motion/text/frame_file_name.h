#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace mien::motion {

/// What the name of a frame's file says: OpenPose writes each frame of a recording to a separate
/// file, "walk_000000000012_keypoints.json".
struct FrameFileName {
  std::string recording;    ///< "walk"
  std::int64_t number = 0;  ///< 12

  friend bool operator==(const FrameFileName&, const FrameFileName&) = default;
};

/// The parts of a file's name, perhaps compressed; nothing if it is not that of a frame.
std::optional<FrameFileName> frame_file_name(const std::filesystem::path& file);

}  // namespace mien::motion
