#include "render/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "render/bayer.h"

namespace mien::render {
namespace {

// Turns linear light into the code whose interval holds it.
class Quantiser {
 public:
  // A value is given code c when its encoded value times `top` lies in [c − 1 + rounding, c +
  // rounding): one half rounds to the nearest code.
  Quantiser(int top, double rounding) : top_(top) {
    for (int code = 1; code <= top; ++code)
      thresholds_.push_back(
          static_cast<float>(linear_from_srgb(std::clamp((code - 1 + rounding) / top, 0.0, 1.0))));
    int code = 0;
    for (int slot = 0; slot <= slots(); ++slot) {
      const float start = static_cast<float>(slot) / static_cast<float>(slots());
      while (code < top && start >= thresholds_[static_cast<std::size_t>(code)]) ++code;
      first_.push_back(code);
    }
  }

  int code(float light) const {
    const float scaled = std::clamp(light, 0.0f, 1.0f) * static_cast<float>(slots());
    // One slot earlier, in case the product was rounded up into the next.
    int code = first_[static_cast<std::size_t>(std::max(static_cast<int>(scaled) - 1, 0))];
    while (code < top_ && light >= thresholds_[static_cast<std::size_t>(code)]) ++code;
    return code;
  }

 private:
  int slots() const { return 8 * (top_ + 1); }

  int top_;
  std::vector<float> thresholds_;  // lowest light of the codes 1 … top
  std::vector<int> first_;         // code at the start of each of equal slots of light
};

float exposure(const Tone& tone) {
  return static_cast<float>(std::exp2(static_cast<double>(tone.exposure_stops)));
}

template <class Channel, class CodeOf>
Image<Channel> developed(const Film& film, const Tone& tone, const CodeOf& code_of) {
  Image<Channel> image(film.width, film.height);
  const float factor = exposure(tone);
  for (int y = 0; y < film.height; ++y) {
    const float* light = film.at(0, y);
    Channel* out = image.at(0, y);
    for (int i = 0; i < 3 * film.width; ++i)
      out[i] =
          static_cast<Channel>(code_of(tone_curve(factor * light[i], tone.shoulder), i / 3, y));
  }
  return image;
}

}  // namespace

float tone_curve(float light, float shoulder) {
  if (!(light > 0.0f)) return 0.0f;
  if (light <= shoulder) return light;
  if (shoulder >= 1.0f) return 1.0f;
  const float u = (light - shoulder) / (1.0f - shoulder);
  if (u > 1e6f) return 1.0f;
  return shoulder + (1.0f - shoulder) * u / (1.0f + u);
}

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Color linear_from_srgb8(int red, int green, int blue) {
  const auto linear = [](int code) { return static_cast<float>(linear_from_srgb(code / 255.0)); };
  return {linear(red), linear(green), linear(blue)};
}

Image8 to_srgb8(const Film& film, const Tone& tone) {
  if (!tone.dither) {
    const Quantiser nearest(255, 0.5);
    return developed<std::uint8_t>(film, tone,
                                   [&](float light, int, int) { return nearest.code(light); });
  }
  std::vector<Quantiser> ranks;
  for (int rank = 0; rank < 64; ++rank) ranks.emplace_back(255, (rank + 0.5) / 64.0);
  return developed<std::uint8_t>(film, tone, [&](float light, int x, int y) {
    return ranks[static_cast<std::size_t>(bayer(x, y))].code(light);
  });
}

Image16 to_srgb16(const Film& film, const Tone& tone) {
  const Quantiser nearest(65535, 0.5);
  return developed<std::uint16_t>(film, tone,
                                  [&](float light, int, int) { return nearest.code(light); });
}

}  // namespace mien::render
