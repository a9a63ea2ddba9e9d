#include "render/picture.h"

#include <stdexcept>

namespace mien::render {

Picture prepare(const EmbreeDevice& device, const Scene& scene, const Camera& camera,
                const Quality& quality) {
  validate(scene);
  if (quality.samples_per_pixel < 1 || quality.sky_rays < 1 || !(quality.filter_width > 0.0f))
    throw std::invalid_argument("quality: samples, sky rays and filter width must be positive");

  const std::vector<RoundCone> cones = round_cones(scene);
  std::vector<ShadowMask> shadow_masks;
  for (const AreaLight& light : scene.lights) shadow_masks.emplace_back(light, cones);
  return {.scene = scene,
          .quality = quality,
          .camera = frame_of(camera),
          .filter = Filter(quality.filter_width),
          .figure = EmbreeScene(device, cones),
          .bounds = bounding_sphere(cones),
          .film_mask = FilmMask(camera, cones, 0.5f * quality.filter_width),
          .shadow_masks = std::move(shadow_masks)};
}

}  // namespace mien::render
