#include "pipeline/base/drawing/palette.h"

#include <algorithm>
#include <cmath>

namespace mien::pipeline {

namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

double decoded(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double cubed(double x) { return x * x * x; }

Colour from_oklab(double lightness, double a, double b) {
  const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

std::array<double, 3> to_oklab(const Colour& colour) {
  const double r = decoded(colour.red);
  const double g = decoded(colour.green);
  const double b = decoded(colour.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour amount_colour(double t) {
  t = std::clamp(t, 0.0, 1.0);
  const double lightness = 0.97 - 0.70 * t;
  const double chroma = 0.04 + 0.11 * t - 0.03 * t * t;  // as much as sRGB holds at every lightness
  const double hue = (100.0 + 200.0 * t) * radians_per_degree;
  return from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

}  // namespace mien::pipeline
