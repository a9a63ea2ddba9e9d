#pragma once

#include <filesystem>
#include <optional>

#include "render/video/sound_file.h"

namespace mien::render {

// The functions of sound_file.h that FFmpeg's libraries do.

Sound libav_read_sound(const std::filesystem::path& file);

std::optional<VideoSound> libav_sound_of_video(const std::filesystem::path& file);

}  // namespace mien::render
