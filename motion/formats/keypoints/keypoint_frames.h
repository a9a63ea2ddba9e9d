#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace mien::motion {

/// The most frames of a recording that are read.
inline constexpr std::size_t max_keypoint_frames = 1'000'000;

/// All frames of the recording that a frame is of (text/frame_file_name.h), in the order of their
/// numbers: the files of the same name in its folder, with it. Other files are ignored, and so are
/// hidden ones.
std::vector<std::filesystem::path> keypoint_frames(const std::filesystem::path& frame);

/// The first frame of each recording in a folder, in the order of their names; empty if it cannot
/// be read or holds no frames. A recording is known by any of its frames: `read_keypoints` reads
/// all of them.
std::vector<std::filesystem::path> keypoint_recordings(const std::filesystem::path& folder);

/// The first frame of the only recording in a folder. Throws mien::Error, which lists them, if
/// there are several, and if there is none.
std::filesystem::path only_keypoint_recording(const std::filesystem::path& folder);

/// Throws mien::Error if the frames of a recording are more, or have more bytes, than are read.
/// Only their sizes are looked up.
void require_readable_frames(const std::vector<std::filesystem::path>& frames);

}  // namespace mien::motion
