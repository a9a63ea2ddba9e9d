#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "render/image/film.h"
#include "render/image/image.h"
#include "render/image/tone.h"

namespace mien::pipeline {

/// "00012.png", "00012.exr"
std::string frame_name(FrameFormat format, int frame);

/// Writes one frame. `format` is not none. EXR keeps the light as it is, without the tone.
void write_frame(const std::filesystem::path& file, const render::Film& film, FrameFormat format,
                 const render::Tone& tone = {});

/// The frame as a display shows it. Throws render::Error when it does not decode or has another
/// size.
render::Image8 read_frame(const std::filesystem::path& file, FrameFormat format,
                          const std::array<int, 2>& size, const render::Tone& tone = {});

}  // namespace mien::pipeline
