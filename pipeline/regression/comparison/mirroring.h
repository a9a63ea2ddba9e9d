#pragma once

#include <string_view>
#include <vector>

#include "pipeline/regression/comparison/frame_alignment.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// How a whole picture lies otherwise than another.
enum class Mirroring { none, left_right, upside_down, half_turn };

/// "mirrored: left and right are exchanged"; empty for none.
std::string_view name_of(Mirroring mirroring);

/// Each is undone by itself.
render::Image8 mirrored(const render::Image8& picture, Mirroring mirroring);

/// How the second sequence lies, of thumbnails of so many pixels: as the first unless its frames
/// are at most a quarter as far from it when they are mirrored, frame by frame.
Mirroring mirroring_of(const std::vector<Thumbnail>& before, const std::vector<Thumbnail>& now,
                       int width, int height);

}  // namespace mien::pipeline
