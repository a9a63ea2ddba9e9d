#pragma once

#include <cstdint>

namespace mien::render {

/// What is behind the figure.
enum class Background {
  shown,        ///< the set
  transparent,  ///< nothing
  shadow        ///< nothing but the figure's shadow on the set, as alpha
};

/// How much work goes into a picture. The same values give the same bytes.
struct Quality {
  int samples_per_pixel = 16;  ///< primary rays a pixel, each with one shadow ray a light
  int sky_rays = 2;            ///< rays towards the sky for each primary ray that meets the figure
  int lit_as_one = 1;          ///< so many samples of a pixel, where they meet the same solid

  /// And with them those of the next pixel in the row, of every two, where `lit_as_one` is not less
  /// than `samples_per_pixel`.
  bool lit_in_pairs = false;
  int standing_samples = 64;  ///< samples a pixel of what stands still, done once a camera

  /// The sky that a figure hides from the floor is known at points, each from so many rays that its
  /// noise is about `floor_sky_noise` of the sky's light, and interpolated where a safe estimate of
  /// the error is below `floor_sky_tolerance` (what was measured is a tenth of it and less). Where
  /// points would have to be closer than `floor_sky_cell`, and everywhere with a tolerance of 0,
  /// each pixel looks for itself.
  float floor_sky_noise = 0.004f;
  float floor_sky_tolerance = 0.008f;
  float floor_sky_cell = 0.03f;  ///< metres

  /// Interpolate there all the same: smooth where it would be grainy, and less dark in the very
  /// corner between floor and foot. Not where the tolerance is 0.
  bool floor_sky_smooth = true;

  float filter_width = 2.0f;  ///< whole width of the Blackman–Harris filter, pixels
  Background background = Background::shown;
  float shutter = 1.0f;    ///< share of the way to the closing scene for which the shutter is open
  std::uint64_t seed = 0;  ///< another seed, another noise pattern

  /// Trace the rays that are known to meet nothing too. Same picture, bit for bit, only slower: it
  /// is there to prove that.
  bool exhaustive = false;
};

Quality draft_quality();     ///< previews: 2 samples
Quality standard_quality();  ///< videos: 16 samples
Quality final_quality();     ///< print and publication: 128 samples

}  // namespace mien::render
