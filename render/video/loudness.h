#pragma once

#include "render/video/sound_file.h"

namespace mien::render {

/// See loudness_of.
Loudness ebur128_loudness(const Sound& sound);

/// "1.2.6"
std::string ebur128_version();

}  // namespace mien::render
