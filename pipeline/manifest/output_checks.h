#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Pixels from side to side, below which a picture shows nothing.
inline constexpr int least_picture_side = 16;

/// Pixels of a picture, cropped or not, that can be drawn in a common machine's memory.
inline constexpr std::int64_t most_picture_pixels = 8192LL * 8192;

/// Pictures and videos that cannot be as they are described: sizes, rates, shutters, names.
std::vector<Fault> check_outputs(const Manifest& manifest);

}  // namespace mien::pipeline
