#pragma once

#include <cstdint>

namespace mien::render {

/// What is rendered behind the figure.
enum class Background {
  shown,        ///< the set
  transparent,  ///< nothing: pixels have alpha
  shadow        ///< only the figure's shadow on the set, as alpha
};

/// Settings for the quality and cost of a picture. The same scene, camera and settings give the
/// same bytes.
///
/// A sample of a solid or of the floor casts one shadow ray per light, unless pixels share what is
/// occluded there.
struct Quality {
  int samples_per_pixel = 16;  ///< each is a primary ray where the pixel may show a solid
  int sky_rays = 2;            ///< rays towards the sky for each shaded sample that does not share
  /// Number of samples of a pixel for which the surface is evaluated once where they show the same
  /// one of a figure, at the mean of their points; each still casts its shadow rays. Has no effect
  /// under motion blur or depth of field. 1 to 4.
  int samples_shaded_together = 4;

  /// Samples that show the same part of a figure share what they find occluded of the sky within so
  /// many pixels: less noise, but blurred. 0: each sample has its own.
  int figure_sharing_pixels = 2;
  /// Whether they share what is occluded of the area lights, too. Otherwise each casts shadow rays.
  bool figure_shares_lights = false;
  /// As figure_sharing_pixels for what shadow rays find occluded of the area lights on the floor.
  /// Has no effect if the camera moves or has an aperture.
  int floor_sharing_pixels = 1;
  /// Of the samples that share, one of so many casts rays: on figures, and on the floor where the
  /// figure may occlude a light.
  int figure_samples_per_ray = 6;
  int floor_samples_per_ray = 2;
  int static_samples = 64;  ///< samples per pixel for static solids, rendered once per camera

  /// A figure's occlusion of the sky, as seen from the floor, is sampled at grid points. At each
  /// point, enough rays are cast to keep the noise at about `floor_sky_noise` of the sky's light.
  /// Between points, the occlusion is interpolated where an estimate of the error is below
  /// `floor_sky_tolerance`. Where points would have to be closer than `floor_sky_cell`, each pixel
  /// casts its own rays, unless `floor_sky_smooth` is set. If the tolerance is 0 or the set has
  /// static solids, nothing is interpolated: pixels cast their own rays.
  float floor_sky_noise = 0.004f;
  float floor_sky_tolerance = 0.008f;
  float floor_sky_cell = 0.03f;  ///< metres

  /// Whether to interpolate also where points would have to be closer than `floor_sky_cell`: less
  /// noise, but too little occlusion right where a foot touches the floor. Has no effect if the
  /// tolerance is 0 or the set has static solids.
  bool floor_sky_smooth = true;

  float filter_width = 2.0f;  ///< full width of the Blackman–Harris filter, pixels
  Background background = Background::shown;
  float shutter = 1.0f;    ///< fraction of the frame interval during which the shutter is open
  std::uint64_t seed = 0;  ///< of the random numbers: selects the noise pattern

  /// Camera and shadow rays alone (tracer/reference.h). Of the members above, only the samples per
  /// pixel, the filter, the background, the shutter and the seed are used.
  bool reference = false;

  /// Whether rays that are known to hit nothing are traced, too; for tests of the culling. The
  /// picture takes longer, but is bit-identical if the set has no static solids, the rounded
  /// 1 / samples_per_pixel, times samples_per_pixel, is 1, and no shadows on the floor are
  /// shared.
  bool exhaustive = false;
};

Quality draft_quality();     ///< previews: 2 samples
Quality standard_quality();  ///< videos: 16 samples
Quality final_quality();     ///< print and publication: 128 samples
Quality
reference_quality();  ///< 256 samples that share nothing: what the others are tested against

}  // namespace mien::render
