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

/// A frame as stored in a file: light, or tone-mapped pixels for a display.
using FramePicture =
    std::variant<render::Framebuffer, render::Layers, render::Image8, render::Image16>;

/// Writes one frame: light as EXR, pixels as PNG.
void write_frame(const std::filesystem::path& file, const FramePicture& picture);

/// Reads a frame, tone-mapped to 8 bits per channel for a display. Throws render::Error if the file
/// cannot be decoded or the frame has a different size.
render::Image8 read_frame(const std::filesystem::path& file, FrameFormat format,
                          const std::array<int, 2>& size, const render::Tone& tone = {});

}  // namespace mien::pipeline
