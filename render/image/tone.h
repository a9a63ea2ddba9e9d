#pragma once

#include "render/image/framebuffer.h"
#include "render/image/window.h"
#include "render/math/vector.h"

namespace mien::render {

/// The mapping from scene-referred light to display values. It is neutral: values up to `shoulder`
/// are unchanged, so 0.18 stays 0.18; above, each channel rolls off towards 1:
///   s + (1 − s)·u / (1 + u), u = (x − s) / (1 − s),
/// whose slope at s is 1.
struct Tone {
  float exposure_stops = 0.0f;  ///< light is multiplied by 2^stops first
  float shoulder = 0.8f;        ///< value at which the roll-off starts, 0 … 1; 1 clips
  bool dither = false;          ///< 8-bit output: ordered dither (Bayer 8 × 8) of one code value
};

/// Maps one channel, after exposure, to 0 … 1. Negative light becomes 0.
float tone_curve(float light, float shoulder);

/// IEC 61966-2-1 transfer function and its inverse, 0 … 1.
double srgb_from_linear(double linear);
double linear_from_srgb(double encoded);

/// The linear colour of 8-bit sRGB channels.
Color linear_from_srgb8(int red, int green, int blue);

/// Converts the framebuffer to an 8-bit sRGB image: exposure, tone curve, transfer function and
/// rounding to the nearest code value (or dither). Each code is found by comparing the light with
/// thresholds in single precision, so that it does not depend on the last bits of a machine's
/// pow().
Image8 to_srgb8(const Framebuffer& framebuffer, const Tone& tone = {});

/// As to_srgb8, with 8 or 16 bits, for a part of the framebuffer; the upper left pixel of the
/// result is written to column x and row y of the picture. Parts of a picture may be developed
/// concurrently and have the same code values as in the whole picture developed at once.
void develop(const Framebuffer& framebuffer, const Window& part, const Tone& tone, Image8& picture,
             int x, int y);
void develop(const Framebuffer& framebuffer, const Window& part, const Tone& tone, Image16& picture,
             int x, int y);

}  // namespace mien::render
