#pragma once

#include <array>
#include <span>

#include "render/tracer/prepared_scene.h"
#include "render/tracer/samples.h"
#include "render/tracer/shared_occlusion.h"

namespace mien::render {

/// Lights and shadows the points that samples show. Shadow rays are collected and traced eight at a
/// time; what they find is added to the pixels, which must not move before `finish`.
class Lighting {
 public:
  explicit Lighting(const PreparedScene& prepared) : prepared_(prepared) {}

  void begin_tile(const Tile& tile) { shared_.begin_tile(tile); }

  /// Adds all light from area lights and sky that surfaces reflect to the camera: those of the
  /// figure, or those of static solids in pixels that render their own background.
  void shade(std::span<const ShadingPoint> points, bool of_figure);

  /// Subtracts from points of the static background the light that the figure occludes.
  void subtract_shadow(std::span<const ShadingPoint> points) { subtract(points, false); }

  /// Subtracts from points of an unshadowed floor the light that the figure or a static solid
  /// occludes.
  void subtract_all_shadows(std::span<const ShadingPoint> points) { subtract(points, true); }

  /// Traces the rays that are still queued. Light that is shared within the tile is added then.
  void finish();

 private:
  /// What a shadow ray decides.
  enum class Decision {
    adds_if_visible,        ///< light is added unless something occludes it
    subtracts_if_occluded,  ///< light is subtracted if something occludes it
    subtracts_if_shadowed,  ///< light is subtracted if the figure alone occludes it
    // Light counts as occluded for the neighbours, too (SharedOcclusion),
    shares_if_occluded,  ///< if something occludes it
    shares_if_shadowed   ///< if the figure alone occludes it
  };
  struct Query {
    Sample sample;
    Color light = Color::Zero();
    Color Pixel::*sum = nullptr;
    Decision decision = Decision::adds_if_visible;
    int shared = -1;  // number in the shared occlusion
  };

  void shade_batch(std::span<const ShadingPoint> batch, bool of_figure);
  void subtract(std::span<const ShadingPoint> points, bool of_all);
  void subtract_batch(std::span<const ShadingPoint> batch, bool of_all);
  void add_area_lights(std::span<const ShadingPoint> batch, const LaneVectors& origins,
                       Color Pixel::*sum);
  void add_sky(std::span<const ShadingPoint> batch, const LaneVectors& normals, bool of_figure);

  /// Queues a shadow ray; `query.light` is the radiance that it contributes for each of the samples
  /// that its sample represents (irradiance divided by π if shared).
  void enqueue(const Query& query, const Vec3& origin, const Vec3& direction, float distance);
  void trace();

  const PreparedScene& prepared_;
  RayPacket rays_;
  std::array<Query, packet_size> queries_;
  SharedOcclusion shared_;
};

}  // namespace mien::render
