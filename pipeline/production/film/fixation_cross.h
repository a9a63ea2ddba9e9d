#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "render/image/image.h"

namespace mien::pipeline {

/// The pictures around a film, on a grey of 8 bits.
render::Image8 blank_picture(std::array<int, 2> size, std::uint8_t grey);
/// A cross of `edge` pixels from end to end, a ninth of that thick, black or white, whichever lies
/// farther from the grey.
render::Image8 fixation_picture(std::array<int, 2> size, std::uint8_t grey, int edge);
/// Lines of text in the middle, as large as fits, at most an 18th of the picture's height.
render::Image8 card_picture(std::array<int, 2> size, std::uint8_t grey, const std::string& text);

}  // namespace mien::pipeline
