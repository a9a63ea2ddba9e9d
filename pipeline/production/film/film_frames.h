#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "pipeline/manifest/manifest.h"
#include "render/image/framebuffer.h"
#include "render/image/image.h"
#include "render/image/layers.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// Returns the file name of a frame: "00012.png", "00012.exr".
std::string frame_name(FrameFormat format, int frame);

/// A frame as stored in a file: light, or pixels as a display shows them.
using FramePicture =
    std::variant<render::Framebuffer, render::Layers, render::Image8, render::Image16>;

/// Writes one frame: light as EXR, pixels as PNG.
void write_frame(const std::filesystem::path& file, const FramePicture& picture);

/// Returns the frame as a display shows it. Throws render::Error if it cannot be decoded or has a
/// different size.
render::Image8 read_frame(const std::filesystem::path& file, FrameFormat format,
                          const std::array<int, 2>& size, const render::Tone& tone = {});

}  // namespace mien::pipeline
