#pragma once

#include <cstdint>

#include "render/sample_mean.h"
#include "render/tracer/tracer.h"

namespace mien::render::test {

/// A camera that sees nothing but a patch of 4 mm round a point, `eye` away from it, so that each
/// pixel is an independent estimate of the radiance there.
inline Camera camera_on(const Vec3& point, const Vec3& eye) {
  const Vec3 up = eye.x() == 0.0f && eye.z() == 0.0f ? Vec3::UnitZ() : Vec3::UnitY();
  return {.position = point + eye,
          .target = point,
          .up = up,
          .vertical_field_of_view = 0.004f / eye.norm(),
          .width = 32,
          .height = 32};
}

/// Radiance of the patch, first channel: an estimate a pixel and seed.
inline SampleMean radiance_at(const Scene& scene, const Camera& camera, Quality quality,
                              std::uint64_t seeds) {
  Tracer tracer({.threads = 1});
  SampleMean estimates;
  for (quality.seed = 0; quality.seed < seeds; ++quality.seed) {
    const Framebuffer framebuffer = tracer.trace(scene, camera, quality);
    for (int y = 0; y < framebuffer.height; ++y)
      for (int x = 0; x < framebuffer.width; ++x)
        estimates.add(static_cast<double>(framebuffer.at(x, y)[0]));
  }
  return estimates;
}

/// Radiance of the patch with one estimate per seed, the mean of all pixels: for quantities that
/// neighbouring pixels share.
inline SampleMean mean_radiance_at(const Scene& scene, const Camera& camera, Quality quality,
                                   std::uint64_t seeds) {
  Tracer tracer({.threads = 1});
  SampleMean estimates;
  for (quality.seed = 0; quality.seed < seeds; ++quality.seed) {
    const Framebuffer framebuffer = tracer.trace(scene, camera, quality);
    double sum = 0.0;
    for (std::size_t i = 0; i < framebuffer.channels.size(); i += 3)
      sum += static_cast<double>(framebuffer.channels[i]);
    estimates.add(3.0 * sum / static_cast<double>(framebuffer.channels.size()));
  }
  return estimates;
}

inline Sky even_sky(const Color& radiance) {
  return {radiance, radiance, radiance, radiance, radiance};
}

}  // namespace mien::render::test
