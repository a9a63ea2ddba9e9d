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
///
/// Every shaded surface sample has one shadow ray a light; samples of the floor share the lines of
/// line_shadow.h where penumbrae are wide, and cast shadow rays only where lines do not apply.
struct Quality {
  int samples_per_pixel = 16;       ///< where a pixel may show a solid each is a primary ray
  int sky_rays = 2;                 ///< rays towards the sky for each shaded surface sample
  int samples_shaded_together = 1;  ///< of a pixel, where they hit the same solid

  /// Whether two neighbours in a row are shaded together too; only where `samples_shaded_together`
  /// is not less than `samples_per_pixel`.
  bool shades_pixel_pairs = false;
  int static_samples = 64;  ///< samples a pixel for static solids, once a camera

  /// How much of the sky a figure hides from the floor is sampled at grid points, with as many rays
  /// each as keep the noise at about `floor_sky_noise` of the sky's light, and interpolated where a
  /// conservative estimate of the error is below `floor_sky_tolerance` (measured errors are at most
  /// a tenth of it). Where points would have to be closer than `floor_sky_cell`, and everywhere
  /// with a tolerance of 0, each pixel casts its own rays.
  float floor_sky_noise = 0.004f;
  float floor_sky_tolerance = 0.008f;
  float floor_sky_cell = 0.03f;  ///< metres

  /// Interpolate there all the same: less noise, but too little occlusion right where a foot
  /// touches the floor. Has no effect where the tolerance is 0.
  bool floor_sky_smooth = true;

  float filter_width = 2.0f;  ///< whole width of the Blackman–Harris filter, pixels
  Background background = Background::shown;
  float shutter = 1.0f;    ///< share of the frame interval for which it is open
  std::uint64_t seed = 0;  ///< another seed, another noise pattern

  /// Camera and shadow rays alone (tracer/reference.h); of the members above, the samples per
  /// pixel, the filter, the background, the shutter and the seed count.
  bool reference = false;

  /// Also trace rays that are known to hit nothing. The picture is the same, bit for bit, only
  /// slower; for tests of the culling.
  bool exhaustive = false;
};

Quality draft_quality();     ///< previews: 2 samples
Quality standard_quality();  ///< videos: 16 samples
Quality final_quality();     ///< print and publication: 128 samples
Quality
reference_quality();  ///< 256 samples that share nothing: what the others are tested against

}  // namespace mien::render
