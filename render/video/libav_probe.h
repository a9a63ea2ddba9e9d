#pragma once

#include <filesystem>
#include <functional>

#include "render/video/video.h"

namespace mien::render {

// The functions of video.h for files that FFmpeg reads: all kinds except WebP.

VideoSummary libav_probe(const std::filesystem::path& path,
                         const std::function<void(const TimedPicture&)>& on_picture, int row_step);

VideoSummary libav_probe_in_parallel(const std::filesystem::path& path,
                                     const std::function<void(const TimedPicture&)>& on_picture,
                                     int row_step, int threads);

Image8 libav_decode_first_picture(const std::filesystem::path& path);

}  // namespace mien::render
