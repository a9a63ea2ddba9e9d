#pragma once

#include <filesystem>
#include <functional>

#include "render/video/video.h"

namespace mien::render {

// Animated WebP, which FFmpeg writes but does not read.

/// Whether a file begins like a WebP.
bool is_webp(const std::filesystem::path& path);

/// As probe_timed. Throws Error when the file is not whole or a picture does not decode.
VideoSummary probe_webp(const std::filesystem::path& path,
                        const std::function<void(const ShownPicture&)>& on_picture);

/// As first_picture_alone: the bytes of the first picture are its chunk's.
Image8 first_webp_picture(const std::filesystem::path& path);

}  // namespace mien::render
