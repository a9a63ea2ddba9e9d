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

// The other way: what a channel's code adds to a luma or difference code.
constexpr int weight_bits = 15;

constexpr std::int32_t weight(double share) {
  return static_cast<std::int32_t>(share * (1 << weight_bits) + (share < 0.0 ? -0.5 : 0.5));
}

constexpr std::int32_t luma_of_red = weight(red / luma_gain);
constexpr std::int32_t luma_of_blue = weight(blue / luma_gain);
// White is exactly 235.
constexpr std::int32_t luma_of_green = weight(1.0 / luma_gain) - luma_of_red - luma_of_blue;
constexpr std::int32_t u_of_blue = weight(1.0 / difference_gain);
constexpr std::int32_t u_of_red = weight(-red / (1.0 - blue) / difference_gain);
constexpr std::int32_t u_of_green = -u_of_blue - u_of_red;  // greys have none
constexpr std::int32_t v_of_red = weight(1.0 / difference_gain);
constexpr std::int32_t v_of_blue = weight(-blue / (1.0 - red) / difference_gain);
constexpr std::int32_t v_of_green = -v_of_red - v_of_blue;

MIEN_FOR_AVX2_TOO void luma_of_row(const std::uint8_t* rgb, int width, std::uint8_t* luma) {
  constexpr std::int32_t offset = (16 << weight_bits) + (1 << (weight_bits - 1));
#pragma omp simd
  for (int x = 0; x < width; ++x) {
    const std::int32_t sum =
        luma_of_red * rgb[3 * x] + luma_of_green * rgb[3 * x + 1] + luma_of_blue * rgb[3 * x + 2];
    luma[x] = static_cast<std::uint8_t>((sum + offset) >> weight_bits);
  }
}

MIEN_FOR_AVX2_TOO void add_rows(const std::uint8_t* above, const std::uint8_t* below, int width,
                                std::uint16_t* reds, std::uint16_t* greens, std::uint16_t* blues) {
#pragma omp simd
  for (int x = 0; x < width; ++x) {
    reds[x] = static_cast<std::uint16_t>(above[3 * x] + below[3 * x]);
    greens[x] = static_cast<std::uint16_t>(above[3 * x + 1] + below[3 * x + 1]);
    blues[x] = static_cast<std::uint16_t>(above[3 * x + 2] + below[3 * x + 2]);
  }
}

/// Each channel's sums of two rows, with the first pixel once more before them.
class RowSums {
 public:
  explicit RowSums(int width) : width_(width) {
    for (std::vector<std::uint16_t>& channel : channels_)
      channel.resize(static_cast<std::size_t>(width) + 1);
  }

  void take(const std::uint8_t* above, const std::uint8_t* below) {
    add_rows(above, below, width_, channels_[0].data() + 1, channels_[1].data() + 1,
             channels_[2].data() + 1);
    for (std::vector<std::uint16_t>& channel : channels_) channel[0] = channel[1];
  }

  const std::uint16_t* red() const { return channels_[0].data(); }
  const std::uint16_t* green() const { return channels_[1].data(); }
  const std::uint16_t* blue() const { return channels_[2].data(); }

 private:
  int width_;
  std::vector<std::uint16_t> channels_[3];
};

/// Colour differences of a row from sums that begin one pixel before it.
MIEN_FOR_AVX2_TOO void differences_of_row(const std::uint16_t* reds, const std::uint16_t* greens,
                                          const std::uint16_t* blues, int count, std::uint8_t* us,
                                          std::uint8_t* vs) {
  constexpr int bits = weight_bits + 3;  // eight codes are added up
  constexpr std::int32_t offset = (128 << bits) + (1 << (bits - 1));
#pragma omp simd
  for (int x = 0; x < count; ++x) {
    const std::int32_t r = reds[2 * x] + 2 * reds[2 * x + 1] + reds[2 * x + 2];
    const std::int32_t g = greens[2 * x] + 2 * greens[2 * x + 1] + greens[2 * x + 2];
    const std::int32_t b = blues[2 * x] + 2 * blues[2 * x + 1] + blues[2 * x + 2];
    us[x] =
        static_cast<std::uint8_t>((u_of_red * r + u_of_green * g + u_of_blue * b + offset) >> bits);
    vs[x] =
        static_cast<std::uint8_t>((v_of_red * r + v_of_green * g + v_of_blue * b + offset) >> bits);
  }
}

}  // namespace

Image8 rgb_from_yuv(const Yuv420& picture, int row_step) {
  Image8 image(picture.width, (picture.height + row_step - 1) / row_step);
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<std::uint16_t> between(width / 2 + 1);
  std::vector<std::uint8_t> us(width);
  std::vector<std::uint8_t> vs(width);
  for (int y = 0; y < picture.height; y += row_step) {
    interpolate(picture, 1, y, between, us);
    interpolate(picture, 2, y, between, vs);
    const std::uint8_t* luma =
        picture.planes[0] + static_cast<std::ptrdiff_t>(y) * picture.strides[0];
    rgb_row(luma, us.data(), vs.data(), picture.width, image.at(0, y / row_step));
  }
  return image;
}

void yuv_from_rgb(const Image8& picture, const Yuv420Planes& out) {
  const int width = picture.width;
  RowSums sums(width);
  const auto row_of = [&](int plane, int y) {
    return out.planes[plane] + static_cast<std::ptrdiff_t>(y) * out.strides[plane];
  };
  for (int y = 0; y < picture.height; y += 2) {
    luma_of_row(picture.at(0, y), width, row_of(0, y));
    luma_of_row(picture.at(0, y + 1), width, row_of(0, y + 1));
    sums.take(picture.at(0, y), picture.at(0, y + 1));
    differences_of_row(sums.red(), sums.green(), sums.blue(), width / 2, row_of(1, y / 2),
                       row_of(2, y / 2));
  }
}

}  // namespace mien::render
