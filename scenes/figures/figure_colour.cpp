#include "scenes/figures/figure_colour.h"

#include "render/image/tone.h"

namespace mien::scenes {

namespace {

FigureColours shades_of(int red, int green, int blue) {
  const render::Color base = render::linear_from_srgb8(red, green, blue);
  const render::Color light = base + 0.34f * (render::Color::Constant(0.92f) - base);
  const render::Color dark = 0.50f * base;
  return {base, light, dark};
}

}  // namespace

FigureColours colours_of(Role role) {
  switch (role) {
    case Role::target:
      return shades_of(46, 160, 92);
    case Role::created:
      return shades_of(52, 116, 204);
    case Role::reference:
      return shades_of(206, 72, 60);
    case Role::neutral:
      break;
  }
  return shades_of(122, 134, 150);
}

}  // namespace mien::scenes
