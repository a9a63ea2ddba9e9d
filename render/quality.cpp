#include "render/quality.h"

namespace mien::render {

Quality draft_quality() {
  Quality quality;
  quality.samples_per_pixel = 4;
  quality.sky_rays = 1;
  quality.standing_samples = 16;
  return quality;
}

Quality standard_quality() { return {}; }

Quality final_quality() {
  Quality quality;
  quality.samples_per_pixel = 128;
  quality.standing_samples = 256;
  return quality;
}

}  // namespace mien::render
