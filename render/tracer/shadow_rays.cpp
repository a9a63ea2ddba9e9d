#include "render/tracer/shadow_rays.h"

#include <cstdint>

namespace mien::render {

void ShadowRays::push(const Sample& sample, const Vec3& origin, const Vec3& towards, float distance,
                      const Color& light, Condition condition, Color& sum) {
  if ((light == 0.0f).all()) return;
  contributions_[static_cast<std::size_t>(rays_.count)] = {light, condition, &sum};
  rays_.push(origin, towards, distance, sample.time, sample.present);
  if (rays_.count == packet_size) finish();
}

void ShadowRays::finish() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = with_figure_ ? prepared_.figure.occluded(rays_) : 0;
  const std::uint32_t by_set =
      prepared_.static_solids != nullptr ? prepared_.static_solids->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Contribution& ray = contributions_[static_cast<std::size_t>(i)];
    const bool figure = ((by_figure >> i) & 1u) != 0, set = ((by_set >> i) & 1u) != 0;
    const bool adds = ray.condition == Condition::visible    ? !figure && !set
                      : ray.condition == Condition::occluded ? figure || set
                                                             : figure && !set;
    if (adds) *ray.sum += ray.light;
  }
  rays_.count = 0;
}

}  // namespace mien::render
