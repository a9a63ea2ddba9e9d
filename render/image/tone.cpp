#include "render/image/tone.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/image/bayer.h"
#include "render/math/for_avx2.h"

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
      // The first slot holds all that is darker, too.
      const int first = slot == lowest_ ? 0 : code;
      slots_.push_back({thresholds_[static_cast<std::size_t>(first)], first});
    }
  }

  // Light is 0 … 1.
  int code(float light) const {
    int code = slot_of(light).code;
    while (light >= thresholds_[static_cast<std::size_t>(code)]) ++code;
    return code;
  }

  int most_in_slot() const { return most_in_slot_; }

  struct Slot {
    float threshold;  // of the code after
    int code;         // at its start
  };

  const std::vector<Slot>& slots() const { return slots_; }
  std::uint32_t lowest() const { return lowest_; }
  int shift() const { return shift_; }

 private:
  const Slot& slot_of(float light) const {
    const std::uint32_t slot = std::bit_cast<std::uint32_t>(light) >> shift_;
    return slots_[slot <= lowest_ ? 0 : slot - lowest_];
  }

  int shift_;
  std::uint32_t lowest_ = 0;
  int most_in_slot_ = 0;
  std::vector<float> thresholds_;  // lowest light of the codes 1 … top; infinity
  std::vector<Slot> slots_;
};

// 256 slots an octave: sRGB has at most one of 255 codes in each.
constexpr int bits_for_8 = 8;
constexpr int bits_for_16 = 12;

float exposure(const Tone& tone) {
  return static_cast<float>(std::exp2(static_cast<double>(tone.exposure_stops)));
}

// Without branches, and NaN gives 0.
inline float toned(float light, float shoulder) {
  const float u = (light - shoulder) / (1.0f - shoulder);
  const float rolled = shoulder + (1.0f - shoulder) * u / (1.0f + u);
  const float above = (shoulder >= 1.0f) | (u > 1e6f) ? 1.0f : rolled;
  const float shown = light <= shoulder ? light : above;
  return light > 0.0f ? shown : 0.0f;
}

MIEN_FOR_AVX2_TOO void tone_row(const float* light, int count, float factor, float shoulder,
                                float* shown) {
  // Most rows have no light above the shoulder, and need no division.
  float most = 0.0f;
#pragma omp simd reduction(max : most)
  for (int i = 0; i < count; ++i) most = factor * light[i] > most ? factor * light[i] : most;
  if (most <= shoulder) {
#pragma omp simd
    for (int i = 0; i < count; ++i) shown[i] = light[i] > 0.0f ? factor * light[i] : 0.0f;
    return;
  }
#pragma omp simd
  for (int i = 0; i < count; ++i) shown[i] = toned(factor * light[i], shoulder);
}

// The same as a table of one word a slot, where no slot has more than one threshold: the code at
// the slot's start in the upper half, and how far into the slot the next code begins in the lower.
class NearestTable {
 public:
  explicit NearestTable(const Quantiser& quantiser)
      : lowest_(quantiser.lowest()), shift_(quantiser.shift()) {
    assert(quantiser.most_in_slot() <= 1);
    const std::uint32_t beyond = 1u << shift_;
    std::uint32_t slot = lowest_;
    for (const auto& [threshold, code] : quantiser.slots()) {
      const auto bits = std::bit_cast<std::uint32_t>(threshold);
      const std::uint32_t into = (bits >> shift_) == slot ? bits & (beyond - 1u) : beyond;
      words_.push_back((static_cast<std::uint32_t>(code) << 16) | into);
      ++slot;
    }
  }

  /// The codes of light, 0 … 1.
  void codes(const float* light, int count, std::uint8_t* codes) const;

 private:
  std::uint32_t lowest_;
  int shift_;
  std::vector<std::uint32_t> words_;
};

MIEN_FOR_AVX2_TOO void look_up(const std::uint32_t* words, std::uint32_t lowest, const float* light,
                               int count, std::uint8_t* codes) {
  constexpr int shift = 23 - bits_for_8;
  constexpr std::uint32_t inside = (1u << shift) - 1u;
  const std::uint32_t least = lowest << shift;
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    std::uint32_t bits = std::bit_cast<std::uint32_t>(light[i]);
    bits =
        bits > least ? bits : least;  // all that is darker has the code of the first slot's start
    const std::uint32_t word = words[(bits >> shift) - lowest];
    codes[i] = static_cast<std::uint8_t>((word >> 16) + ((bits & inside) >= (word & 0xffffu)));
  }
}

void NearestTable::codes(const float* light, int count, std::uint8_t* codes) const {
  assert(shift_ == 23 - bits_for_8);
  look_up(words_.data(), lowest_, light, count, codes);
}

/// Position of a pixel.
struct Place {
  int x;
  int y;
};

/// Calls to_codes(light, place, codes) for each row of a part, the tone curve applied: `light` has
/// three channels a pixel, `place` is the picture's first pixel.
template <class Channel, class ToCodes>
void develop_rows(const Framebuffer& framebuffer, const Window& part, const Tone& tone,
                  Image<Channel>& picture, const Place& corner, const ToCodes& to_codes) {
  const float factor = exposure(tone);
  std::vector<float> shown(3 * static_cast<std::size_t>(part.width));
  for (int row = 0; row < part.height; ++row) {
    tone_row(framebuffer.at(part.x, part.y + row), 3 * part.width, factor, tone.shoulder,
             shown.data());
    const Place first{corner.x, corner.y + row};
    to_codes(shown, first, picture.at(first.x, first.y));
  }
}

}  // namespace

float tone_curve(float light, float shoulder) { return toned(light, shoulder); }

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

void develop(const Framebuffer& framebuffer, const Window& part, const Tone& tone, Image8& picture,
             int x, int y) {
  if (!tone.dither) {
    static const NearestTable nearest(Quantiser(255, 0.5, bits_for_8));
    return develop_rows(framebuffer, part, tone, picture, {x, y},
                        [](const std::vector<float>& light, Place, std::uint8_t* codes) {
                          nearest.codes(light.data(), static_cast<int>(light.size()), codes);
                        });
  }
  static const std::vector<Quantiser> ranks = [] {
    std::vector<Quantiser> all;
    for (int rank = 0; rank < 64; ++rank) all.emplace_back(255, (rank + 0.5) / 64.0, bits_for_8);
    return all;
  }();
  develop_rows(framebuffer, part, tone, picture, {x, y},
               [](const std::vector<float>& light, Place first, std::uint8_t* codes) {
                 for (std::size_t i = 0; i < light.size(); ++i) {
                   const int column = first.x + static_cast<int>(i / 3);
                   const auto rank = static_cast<std::size_t>(bayer(column, first.y));
                   codes[i] = static_cast<std::uint8_t>(ranks[rank].code(light[i]));
                 }
               });
}

void develop(const Framebuffer& framebuffer, const Window& part, const Tone& tone, Image16& picture,
             int x, int y) {
  static const Quantiser nearest(65535, 0.5, bits_for_16);
  develop_rows(framebuffer, part, tone, picture, {x, y},
               [](const std::vector<float>& light, Place, std::uint16_t* codes) {
                 for (std::size_t i = 0; i < light.size(); ++i)
                   codes[i] = static_cast<std::uint16_t>(nearest.code(light[i]));
               });
}

Image8 to_srgb8(const Framebuffer& framebuffer, const Tone& tone) {
  Image8 picture(framebuffer.width, framebuffer.height);
  develop(framebuffer, {0, 0, framebuffer.width, framebuffer.height}, tone, picture, 0, 0);
  return picture;
}

}  // namespace mien::render
