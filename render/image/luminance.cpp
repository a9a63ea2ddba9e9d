#include "render/image/luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mien::render {

namespace {

constexpr std::array<double, 3> weights = {0.2126, 0.7152, 0.0722};
constexpr double steps = 1 << 20;

using Table = std::array<std::array<std::uint32_t, 256>, 3>;

/// What each code of each channel adds to the luminance, in steps.
Table light_of_codes() {
  Table table{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t code = 0; code < 256; ++code) {
      const double light = linear_from_srgb(static_cast<double>(code) / 255.0);
      table[c][code] = static_cast<std::uint32_t>(std::lround(steps * weights[c] * light));
    }
  }
  return table;
}

}  // namespace

float relative_luminance(const Color& light) {
  return static_cast<float>(weights[0]) * light.x() + static_cast<float>(weights[1]) * light.y() +
         static_cast<float>(weights[2]) * light.z();
}

Luminance luminance_of(const Image8& picture) {
  static const Table table = light_of_codes();
  std::uint64_t sum = 0;
  std::uint64_t squares = 0;  // of 40 bits less 8: room for 2³² pixels
  const std::size_t pixels = picture.channels.size() / 3;
  const std::uint8_t* p = picture.channels.data();
  for (std::size_t i = 0; i < pixels; ++i, p += 3) {
    const std::uint64_t light = table[0][p[0]] + table[1][p[1]] + table[2][p[2]];
    sum += light;
    squares += (light * light) >> 8;
  }
  if (pixels == 0) return {};
  const double mean = static_cast<double>(sum) / static_cast<double>(pixels);
  const double square = 256.0 * static_cast<double>(squares) / static_cast<double>(pixels);
  return {mean / steps, std::sqrt(std::max(0.0, square - mean * mean)) / steps};
}

double mean_luminance(const Framebuffer& framebuffer, const Tone& tone) {
  const auto gain = static_cast<float>(std::exp2(static_cast<double>(tone.exposure_stops)));
  double sum = 0.0;
  for (std::size_t i = 0; i < framebuffer.channels.size(); ++i) {
    sum += weights[i % 3] *
           static_cast<double>(tone_curve(gain * framebuffer.channels[i], tone.shoulder));
  }
  return 3.0 * sum / static_cast<double>(std::max<std::size_t>(1, framebuffer.channels.size()));
}

void ClipLuminance::add(const Luminance& frame) {
  const double share = 1.0 / ++frames;
  mean += share * (frame.mean - mean);
  deviation += share * (frame.deviation - deviation);
  rms_contrast += share * (frame.rms_contrast() - rms_contrast);
  darkest = frames == 1 ? frame.mean : std::min(darkest, frame.mean);
  lightest = std::max(lightest, frame.mean);
}

}  // namespace mien::render
