#include "render/yuv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mien::render {

namespace {

constexpr int fraction_bits = 6;
constexpr double fraction = 1 << fraction_bits;
constexpr int lowest = -320;  // of a sum before it is clipped
constexpr int highest = 640;

using Part = std::array<std::int16_t, 256>;

/// What each code adds to the channels, in 64ths (ITU-R BT.709, limited range).
struct Parts {
  Part light;
  Part red_of_v;
  Part green_of_u;
  Part green_of_v;
  Part blue_of_u;
  std::array<std::uint8_t, highest - lowest> clipped;

  Parts() {
    const auto fill = [](Part& part, double gain, int zero, double half) {
      for (int code = 0; code < 256; ++code) {
        part[static_cast<std::size_t>(code)] =
            static_cast<std::int16_t>(std::lround(fraction * (gain * (code - zero) + half)));
      }
    };
    fill(light, 255.0 / 219.0, 16, 0.5);
    fill(red_of_v, 255.0 / 112.0 * (1.0 - 0.2126), 128, 0.0);
    fill(blue_of_u, 255.0 / 112.0 * (1.0 - 0.0722), 128, 0.0);
    fill(green_of_u, -255.0 / 112.0 * (1.0 - 0.0722) * 0.0722 / 0.7152, 128, 0.0);
    fill(green_of_v, -255.0 / 112.0 * (1.0 - 0.2126) * 0.2126 / 0.7152, 128, 0.0);
    for (int i = lowest; i < highest; ++i) {
      clipped[static_cast<std::size_t>(i - lowest)] =
          static_cast<std::uint8_t>(std::clamp(i, 0, 255));
    }
  }
};

/// Colour differences of one row of pixels.
void interpolate(const Yuv420& picture, int plane, int y, std::vector<std::uint16_t>& between,
                 std::vector<std::uint8_t>& row) {
  const int columns = picture.width / 2;
  const int rows = picture.height / 2;
  const int near = y / 2;
  const int far = std::clamp(y % 2 == 0 ? near - 1 : near + 1, 0, rows - 1);
  const std::uint8_t* a =
      picture.planes[plane] + static_cast<std::ptrdiff_t>(near) * picture.strides[plane];
  const std::uint8_t* b =
      picture.planes[plane] + static_cast<std::ptrdiff_t>(far) * picture.strides[plane];
  std::uint16_t* quarters = between.data();
  for (int x = 0; x < columns; ++x) quarters[x] = static_cast<std::uint16_t>(3 * a[x] + b[x]);
  quarters[columns] = quarters[columns - 1];
  for (int x = 0; x < columns; ++x) {
    row[static_cast<std::size_t>(2 * x)] = static_cast<std::uint8_t>((quarters[x] + 2) >> 2);
    row[static_cast<std::size_t>(2 * x + 1)] =
        static_cast<std::uint8_t>((quarters[x] + quarters[x + 1] + 4) >> 3);
  }
}

}  // namespace

Image8 rgb_from_yuv(const Yuv420& picture) {
  static const Parts parts;
  Image8 image(picture.width, picture.height);
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<std::uint16_t> between(width / 2 + 1);
  std::vector<std::uint8_t> us(width);
  std::vector<std::uint8_t> vs(width);
  const std::uint8_t* const clipped = parts.clipped.data() - lowest;
  for (int y = 0; y < picture.height; ++y) {
    interpolate(picture, 1, y, between, us);
    interpolate(picture, 2, y, between, vs);
    const std::uint8_t* luma =
        picture.planes[0] + static_cast<std::ptrdiff_t>(y) * picture.strides[0];
    std::uint8_t* out = image.at(0, y);
    for (std::size_t x = 0; x < width; ++x, out += 3) {
      const int light = parts.light[luma[x]];
      out[0] = clipped[(light + parts.red_of_v[vs[x]]) >> fraction_bits];
      out[1] =
          clipped[(light + parts.green_of_u[us[x]] + parts.green_of_v[vs[x]]) >> fraction_bits];
      out[2] = clipped[(light + parts.blue_of_u[us[x]]) >> fraction_bits];
    }
  }
  return image;
}

}  // namespace mien::render
