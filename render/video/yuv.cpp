#include "render/video/yuv.h"

#include <algorithm>
#include <vector>

#include "render/math/for_avx2.h"

namespace mien::render {

namespace {

constexpr int fraction_bits = 13;

constexpr std::int32_t fixed(double gain) {
  return static_cast<std::int32_t>(gain * (1 << fraction_bits) + (gain < 0.0 ? -0.5 : 0.5));
}

// ITU-R BT.709, limited range: what a code adds to a channel.
constexpr double luma_gain = 255.0 / 219.0;
constexpr double difference_gain = 255.0 / 112.0;
constexpr double red = 0.2126, green = 0.7152, blue = 0.0722;
constexpr std::int32_t light = fixed(luma_gain);
constexpr std::int32_t red_of_v = fixed(difference_gain * (1.0 - red));
constexpr std::int32_t blue_of_u = fixed(difference_gain * (1.0 - blue));
constexpr std::int32_t green_of_u = fixed(-difference_gain * (1.0 - blue) * blue / green);
constexpr std::int32_t green_of_v = fixed(-difference_gain * (1.0 - red) * red / green);

std::uint8_t rounded(std::int32_t sum) {
  return static_cast<std::uint8_t>(
      std::clamp((sum + (1 << (fraction_bits - 1))) >> fraction_bits, 0, 255));
}

MIEN_FOR_AVX2_TOO void rgb_row(const std::uint8_t* luma, const std::uint8_t* us,
                               const std::uint8_t* vs, int width, std::uint8_t* out) {
#pragma omp simd
  for (int x = 0; x < width; ++x) {
    const std::int32_t y = light * (luma[x] - 16), u = us[x] - 128, v = vs[x] - 128;
    out[3 * x] = rounded(y + red_of_v * v);
    out[3 * x + 1] = rounded(y + green_of_u * u + green_of_v * v);
    out[3 * x + 2] = rounded(y + blue_of_u * u);
  }
}

/// Colour differences of one row of pixels.
MIEN_FOR_AVX2_TOO void interpolate(const Yuv420& picture, int plane, int y,
                                   std::vector<std::uint16_t>& between,
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
  std::uint8_t* out = row.data();
#pragma omp simd
  for (int x = 0; x < columns; ++x) {
    out[2 * x] = static_cast<std::uint8_t>((quarters[x] + 2) >> 2);
    out[2 * x + 1] = static_cast<std::uint8_t>((quarters[x] + quarters[x + 1] + 4) >> 3);
  }
}

}  // namespace

Image8 rgb_from_yuv(const Yuv420& picture) {
  Image8 image(picture.width, picture.height);
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<std::uint16_t> between(width / 2 + 1);
  std::vector<std::uint8_t> us(width);
  std::vector<std::uint8_t> vs(width);
  for (int y = 0; y < picture.height; ++y) {
    interpolate(picture, 1, y, between, us);
    interpolate(picture, 2, y, between, vs);
    const std::uint8_t* luma =
        picture.planes[0] + static_cast<std::ptrdiff_t>(y) * picture.strides[0];
    rgb_row(luma, us.data(), vs.data(), picture.width, image.at(0, y));
  }
  return image;
}

}  // namespace mien::render
