#include "render/scene/quality.h"

namespace mien::render {

Quality draft_quality() {
  Quality quality;
  quality.samples_per_pixel = 2;
  quality.sky_rays = 1;
  quality.figure_sharing_pixels = 3;
  quality.figure_shares_lights = true;
  quality.floor_sharing_pixels = 2;
  quality.static_samples = 16;
  quality.floor_sky_noise = 0.032f;
  quality.floor_sky_tolerance = 0.032f;
  quality.floor_sky_cell = 0.06f;
  return quality;
}

Quality standard_quality() { return {}; }

Quality final_quality() {
  Quality quality;
  quality.samples_per_pixel = 128;
  quality.samples_shaded_together = 1;
  quality.figure_sharing_pixels = quality.floor_sharing_pixels = 0;
  quality.static_samples = 256;
  quality.floor_sky_noise = 0.001f;
  quality.floor_sky_tolerance = 0.002f;
  quality.floor_sky_cell = 0.015f;
  return quality;
}

Quality reference_quality() {
  Quality quality;
  quality.samples_per_pixel = 256;
  quality.reference = true;
  return quality;
}

}  // namespace mien::render
