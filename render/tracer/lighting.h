#pragma once

#include <array>

#include "render/light/shading.h"
#include "render/tracer/line_shadow_queue.h"
#include "render/tracer/pixel.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/shared_sky.h"

namespace mien::render {

/// How a shadow ray's light contributes to its pixel.
enum class Contribution {
  figure_if_unoccluded,          ///< added to the figure
  background_if_unoccluded,      ///< added to the background
  minus_figure_if_occluded,      ///< subtracted from the figure
  minus_background_if_occluded,  ///< subtracted from the background
  shared_sky_if_occluded,        ///< subtracted from the sky's light, shared by neighbours
  shadow_if_figure_occludes,     ///< subtracted from the static background, unless a
                                 ///< static solid occludes, too
  shadow_if_occluded             ///< subtracted from the unshadowed background
};

/// Shadow rays, collected and traced eight at a time. Their contributions are added to the pixels,
/// which must not move before `trace`.
class ShadowRayQueue {
 public:
  explicit ShadowRayQueue(const PreparedScene& prepared) : prepared_(prepared) {}

  /// Queues a shadow ray. `light` is the radiance that the ray contributes for each of the
  /// samples that `sample` represents; for shared_sky_if_occluded, irradiance divided by π, of the
  /// sample `sky_sample` of `shared_sky`.
  void enqueue(const Sample& sample, const Vec3& origin, const Vec3& direction, float distance,
               const Color& light, Contribution contribution, int sky_sample = -1) {
    if ((light == 0.0f).all()) return;
    queries_[static_cast<std::size_t>(rays_.count)] = {sample, light, contribution, sky_sample};
    rays_.push(origin, direction, distance, sample.time, sample.present);
    if (rays_.count == packet_size) trace();
  }

  /// Traces the rays that are still queued.
  void trace();

  /// The samples of the tile whose sky is shared; subtract it after `trace`.
  SharedSky& shared_sky() { return shared_sky_; }

 private:
  struct Query {
    Sample sample;
    Color light = Color::Zero();
    Contribution contribution = Contribution::figure_if_unoccluded;
    int sky_sample = -1;
  };

  const PreparedScene& prepared_;
  RayPacket rays_;
  std::array<Query, packet_size> queries_;
  SharedSky shared_sky_;
};

/// Up to eight samples and the surfaces that they hit.
struct SurfaceSamples {
  Samples samples;
  std::array<Surface, lanes> surfaces;

  void push(const Sample& sample, const Surface& surface) {
    surfaces[static_cast<std::size_t>(samples.count)] = surface;
    samples.push(sample);
  }
};

/// Up to eight samples and the points of the floor that they show.
struct FloorSamples {
  Samples samples;
  LaneVectors points;

  void push(const Sample& sample, const Vec3& point) {
    points.set(samples.count, point);
    samples.push(sample);
  }
};

/// Shades surfaces: adds all light from area lights and sky that they reflect to the camera.
void shade_surfaces(const PreparedScene& prepared, const SurfaceSamples& batch, bool of_figure,
                    ShadowRayQueue& shadow_rays);

/// Subtracts from a static solid the light from area lights and sky that the figure occludes.
void shadow_static_solid(const PreparedScene& prepared, const Sample& sample,
                         const Surface& surface, ShadowRayQueue& shadow_rays);

/// Subtracts from the floor the light from area lights that the figure occludes and, for pixels
/// that cast their own sky rays, the light from the sky.
void shadow_floor(const PreparedScene& prepared, const FloorSamples& batch,
                  ShadowRayQueue& shadow_rays, LineShadowQueue& line_shadows);

/// Adds the backdrop or floor to the pixel's background: that shown by the ray if every sample
/// renders its own background, otherwise that at the pixel's centre. Queues shadow rays for the
/// light that figures or static solids may keep from it.
void add_unshadowed_background(const PreparedScene& prepared, const Sample& sample,
                               const CameraFrame& camera, const CameraRay& ray,
                               ShadowRayQueue& shadow_rays);

}  // namespace mien::render
