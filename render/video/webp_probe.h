#pragma once

#include <filesystem>
#include <functional>

#include "render/video/video.h"

namespace mien::render {

// Animated WebP, which FFmpeg writes but does not read.

/// Whether a file begins like a WebP.
bool is_webp(const std::filesystem::path& path);

/// See probe_timed. Throws Error when the file is cut short or a picture does not decode.
VideoSummary probe_webp(const std::filesystem::path& path,
                        const std::function<void(const TimedPicture&)>& on_picture);

/// See decode_first_picture: the bytes of the first picture are those of its chunk.
Image8 decode_first_webp_picture(const std::filesystem::path& path);

}  // namespace mien::render
