#include "scenes/figures/hex_colour.h"

#include <charconv>

#include "render/image/tone.h"

namespace mien::scenes {

bool is_hex_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

render::Color colour_from_hex(std::string_view hex) {
  const auto channel = [&](std::size_t at) {
    int value = 0;
    std::from_chars(hex.data() + at, hex.data() + at + 2, value, 16);
    return value;
  };
  return render::linear_from_srgb8(channel(1), channel(3), channel(5));
}

}  // namespace mien::scenes
