#pragma once

#include <string_view>

#include "render/math/vector.h"

namespace mien::scenes {

/// Whether a text is # and six hexadecimal digits.
bool is_hex_colour(std::string_view text);

/// The linear colour of "#rrggbb" (sRGB).
render::Color colour_from_hex(std::string_view hex);

}  // namespace mien::scenes
