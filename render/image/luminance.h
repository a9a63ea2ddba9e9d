#pragma once

#include "render/image/framebuffer.h"
#include "render/image/image.h"
#include "render/image/tone.h"
#include "render/math/vector.h"

namespace mien::render {

/// Relative luminance of a picture as a display shows it: linear light of sRGB channels, weighted
/// by BT.709, 0 black … 1 white.
struct Luminance {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation over the pixels

  /// Root-mean-square contrast: deviation / mean (Moulden, Kingdom and Gatley 1990); 0 for black.
  double rms_contrast() const { return mean > 0.0 ? deviation / mean : 0.0; }
};

/// Returns the relative luminance of a linear colour with Rec.709 primaries, weighted by BT.709.
float relative_luminance(const Color& light);

/// Returns the mean and deviation of a picture. Sums are integers (steps of 2⁻²⁰), so the result is
/// the same on every machine.
Luminance luminance_of(const Image8& picture);

/// Mean luminance of the framebuffer as a display shows it with this tone curve, without rounding
/// to code values.
double mean_luminance(const Framebuffer& framebuffer, const Tone& tone);

/// Luminance of the frames of a clip.
struct ClipLuminance {
  int frames = 0;
  double mean = 0.0;          ///< mean of the frames' means
  double deviation = 0.0;     ///< mean of the frames' deviations
  double rms_contrast = 0.0;  ///< mean of the frames' RMS contrasts
  double darkest = 0.0;       ///< smallest mean of a frame
  double lightest = 0.0;      ///< largest mean of a frame

  void add(const Luminance& frame);
};

}  // namespace mien::render
