#pragma once

#include <array>

namespace mien::pipeline {

/// sRGB, each channel in [0, 1].
struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// The colours of one motion. Those of different motions are distinguishable with any common type
/// of colour vision: hues after Okabe and Ito 2008.
struct MotionColours {
  Colour line;   ///< curves, bars, text; limbs on the right of the body and its midline
  Colour light;  ///< limbs on the left of the body
};

inline constexpr Colour from_hex(unsigned rgb) {
  return {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0};
}

inline constexpr MotionColours target_colours = {from_hex(0x007a59), from_hex(0x62c0a2)};   // green
inline constexpr MotionColours created_colours = {from_hex(0x0a58a6), from_hex(0x74b2e8)};  // blue
inline constexpr MotionColours reference_colours = {from_hex(0xb8420e), from_hex(0xeda077)};  // red

/// Pale colours of a target that is drawn behind another motion.
inline constexpr MotionColours target_pale = {from_hex(0x8fd0b8), from_hex(0xc4e8db)};

inline constexpr Colour ink = from_hex(0x1b1f24);
inline constexpr Colour quiet_ink = from_hex(0x5c6670);
inline constexpr Colour hairline = from_hex(0xc9ced4);
inline constexpr Colour panel = from_hex(0xf3f5f7);
inline constexpr Colour paper = from_hex(0xffffff);
inline constexpr Colour caution = from_hex(0xffe2a8);
inline constexpr Colour caution_ink = from_hex(0x7a4a00);

/// A sequential colormap from light (t = 0) to dark (t = 1); t is clamped to [0, 1].
///
/// It is almost perceptually uniform: steps in OKLab (Ottosson 2020) differ by less than 15 % from
/// their mean. Lightness decreases linearly while the hue changes from yellow through green and
/// blue to violet. The order is preserved in greyscale and for any colour vision.
Colour amount_colour(double t);

/// OKLab coordinates (lightness, a, b) of an sRGB colour.
std::array<double, 3> to_oklab(const Colour& colour);

}  // namespace mien::pipeline
