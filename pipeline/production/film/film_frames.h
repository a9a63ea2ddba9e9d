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

/// "00012.png", "00012.exr"
std::string frame_name(FrameFormat format, int frame);

/// A frame in the form in which a file has it: light, or what a display shows.
using FramePicture =
    std::variant<render::Framebuffer, render::Layers, render::Image8, render::Image16>;

/// Writes one frame: light as EXR, the others as PNG.
void write_frame(const std::filesystem::path& file, const FramePicture& picture);

/// The frame as a display shows it. Throws render::Error when it does not decode or has another
/// size.
render::Image8 read_frame(const std::filesystem::path& file, FrameFormat format,
                          const std::array<int, 2>& size, const render::Tone& tone = {});

}  // namespace mien::pipeline
