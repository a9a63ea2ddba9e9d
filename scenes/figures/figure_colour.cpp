#include "scenes/figures/figure_colour.h"

#include <charconv>
#include <iterator>

#include "render/image/tone.h"

namespace mien::scenes {

namespace {

FigureColours shades_of(const render::Color& base) {
  const render::Color light = base + 0.34f * (render::Color::Constant(0.92f) - base);
  const render::Color dark = 0.50f * base;
  return {base, light, dark};
}

FigureColours shades_of(int red, int green, int blue) {
  return shades_of(render::linear_from_srgb8(red, green, blue));
}

}  // namespace

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

FigureColours colours_of(Role role) {
  if (role == Role::target) return shades_of(46, 160, 92);
  if (role == Role::created) return shades_of(52, 116, 204);
  return role == Role::reference ? shades_of(206, 72, 60) : shades_of(122, 134, 150);
}

FigureColours colours_of_hex(std::string_view hex) { return shades_of(colour_from_hex(hex)); }

std::string_view person_colour(std::size_t number) {
  constexpr std::string_view colours[] = {"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                          "#56b4e9", "#d55e00", "#f0e442", "#7a8696"};
  return colours[number % std::size(colours)];
}

}  // namespace mien::scenes
