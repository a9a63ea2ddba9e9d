#include "render/tone.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/bayer.h"

namespace mien::render {
namespace {

// Turns linear light, 0 … 1, into the code whose interval holds it. Light is looked up by the
// leading bits of its floating-point number, which leaves few thresholds to compare with.
class Quantiser {
 public:
  // A value is given code c when its encoded value times `top` lies in [c − 1 + rounding, c +
  // rounding): one half rounds to the nearest code. Slots of light are 2^-bits wide, relatively.
  Quantiser(int top, double rounding, int bits) : shift_(23 - bits) {
    for (int code = 1; code <= top; ++code)
      thresholds_.push_back(
          static_cast<float>(linear_from_srgb(std::clamp((code - 1 + rounding) / top, 0.0, 1.0))));
    thresholds_.push_back(std::numeric_limits<float>::infinity());
    lowest_ = std::bit_cast<std::uint32_t>(0.999f * thresholds_[0]) >> shift_;
    const std::uint32_t highest = std::bit_cast<std::uint32_t>(1.0f) >> shift_;
    int code = 0;
    for (std::uint32_t slot = lowest_; slot <= highest; ++slot) {
      const float start = std::bit_cast<float>(slot << shift_);
      const int before = code;
      while (start >= thresholds_[static_cast<std::size_t>(code)]) ++code;
      most_in_slot_ = std::max(most_in_slot_, slot == lowest_ ? 0 : code - before);
      first_.push_back(static_cast<std::uint16_t>(code));
    }
    first_[0] = 0;  // of all that is darker, too
  }

  // Light is 0 … 1.
  int code(float light) const {
    int code = start_of(light);
    while (light >= thresholds_[static_cast<std::size_t>(code)]) ++code;
    return code;
  }

  // The same, where no slot has more than one threshold: no branch to guess wrong.
  int code_of_one(float light) const {
    const int code = start_of(light);
    return code + (light >= thresholds_[static_cast<std::size_t>(code)] ? 1 : 0);
  }

  int most_in_slot() const { return most_in_slot_; }

 private:
  int start_of(float light) const {
    const std::uint32_t slot = std::bit_cast<std::uint32_t>(light) >> shift_;
    return first_[slot <= lowest_ ? 0 : slot - lowest_];
  }

  int shift_;
  std::uint32_t lowest_ = 0;
  int most_in_slot_ = 0;
  std::vector<float> thresholds_;     // lowest light of the codes 1 … top; infinity
  std::vector<std::uint16_t> first_;  // code at the start of each slot
};

// 256 slots an octave: sRGB has at most one of 255 codes in each.
constexpr int bits_for_8 = 8;
constexpr int bits_for_16 = 16;

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
    for (int x = 0; x < film.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const float exposed = factor * *light++;
        // Most light is below the shoulder.
        const float shown = exposed > 0.0f && exposed <= tone.shoulder
                                ? exposed
                                : tone_curve(exposed, tone.shoulder);
        *out++ = static_cast<Channel>(code_of(shown, x, y));
      }
    }
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
    static const Quantiser nearest(255, 0.5, bits_for_8);
    assert(nearest.most_in_slot() <= 1);
    return developed<std::uint8_t>(
        film, tone, [](float light, int, int) { return nearest.code_of_one(light); });
  }
  static const std::vector<Quantiser> ranks = [] {
    std::vector<Quantiser> all;
    for (int rank = 0; rank < 64; ++rank) all.emplace_back(255, (rank + 0.5) / 64.0, bits_for_8);
    return all;
  }();
  return developed<std::uint8_t>(film, tone, [](float light, int x, int y) {
    return ranks[static_cast<std::size_t>(bayer(x, y))].code(light);
  });
}

Image16 to_srgb16(const Film& film, const Tone& tone) {
  static const Quantiser nearest(65535, 0.5, bits_for_16);
  return developed<std::uint16_t>(film, tone,
                                  [](float light, int, int) { return nearest.code(light); });
}

}  // namespace mien::render
