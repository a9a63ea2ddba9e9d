#pragma once

#include <cstddef>
#include <string_view>

#include "render/math/vector.h"

namespace mien::scenes {

/// Whether a text consists of "#" and six hexadecimal digits.
bool is_hex_colour(std::string_view text);

/// The linear colour of "#rrggbb" (sRGB).
render::Color colour_from_hex(std::string_view hex);

/// The role of a figure, which determines its hue.
enum class Role { target, created, reference, neutral };

/// A figure's colours, linear Rec.709 albedo. Left limbs are lighter than right ones, so that
/// crossing limbs can be distinguished.
struct FigureColours {
  render::Color middle;
  render::Color left;
  render::Color right;
};

/// Target green, created blue, reference red, neutral slate.
FigureColours colours_of(Role role);

/// The colours of a figure in "#rrggbb" (sRGB).
FigureColours colours_of_hex(std::string_view hex);

/// The colour, as "#rrggbb", of one of several people, by number from 0; repeats after 8. Seven are
/// those of Okabe and Ito (2008), which people with any colour vision can tell apart.
std::string_view person_colour(std::size_t number);

}  // namespace mien::scenes
