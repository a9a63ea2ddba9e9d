#pragma once

#include <filesystem>
#include <memory>

#include "render/video/video_files.h"

namespace mien::render {

/// As VideoFiles::writer.
std::unique_ptr<VideoEncoder> libav_writer(const std::filesystem::path& path,
                                           const VideoFormat& format);

}  // namespace mien::render
