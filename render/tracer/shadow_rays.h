#pragma once

#include <array>
#include <cstddef>

#include "render/geometry/embree_scene.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/samples.h"

namespace mien::render {

/// Shadow rays, traced eight at a time, and the light that each adds to a sum.
class ShadowRays {
 public:
  /// When a ray's light is added.
  enum class Condition {
    visible,   ///< nothing occludes it
    occluded,  ///< the figure or a static solid occludes it
    shadowed   ///< the figure occludes it, and no static solid does
  };

  /// Without `with_figure`, the figure occludes nothing.
  explicit ShadowRays(const PreparedScene& prepared, bool with_figure = true)
      : prepared_(prepared), with_figure_(with_figure) {}

  /// Queues a ray at the time of a sample, with the figures that are present in it; black light
  /// needs none. The sum must not move before the ray is traced. Sums are taken in the order in
  /// which rays are queued.
  void push(const Sample& sample, const Vec3& origin, const Vec3& towards, float distance,
            const Color& light, Condition condition, Color& sum);

  /// Traces the rays that are still queued.
  void finish();

 private:
  struct Contribution {
    Color light;
    Condition condition;
    Color* sum;
  };

  const PreparedScene& prepared_;
  const bool with_figure_;
  RayPacket rays_;
  std::array<Contribution, packet_size> contributions_;
};

}  // namespace mien::render
