#pragma once

#include <filesystem>
#include <functional>

#include "render/video/video.h"

namespace mien::render {

// As the functions of video.h, of what FFmpeg reads: everything but WebP.

VideoSummary libav_probe(const std::filesystem::path& path,
                         const std::function<void(const ShownPicture&)>& on_picture, int row_step);

VideoSummary libav_probe_side_by_side(const std::filesystem::path& path,
                                      const std::function<void(const ShownPicture&)>& on_picture,
                                      int row_step, int threads);

Image8 libav_first_picture(const std::filesystem::path& path);

}  // namespace mien::render
