#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/tracer/prepared_scene.h"
#include "render/tracer/samples.h"
#include "render/tracer/shadow_rays.h"

namespace mien::render {

/// Lights and shadows the points that samples show. Shadow rays are collected and traced eight at a
/// time; what they find is added to the pixels, which must not move before `finish`.
class Lighting {
 public:
  explicit Lighting(const PreparedScene& prepared)
      : prepared_(prepared),
        rays_(prepared),
        shares_sky_(prepared.quality.figure_sharing_pixels > 0),
        shares_lights_(shares_sky_ && prepared.quality.figure_shares_lights) {}

  /// Adds all light from area lights and sky that surfaces reflect to the camera: those of the
  /// figure, or those of static solids in pixels that render their own background.
  void shade(std::span<const ShadingPoint> points, bool of_figure);

  /// Subtracts from points of the static background the light that the figure occludes.
  void subtract_shadow(std::span<const ShadingPoint> points) { subtract(points, false); }

  /// Subtracts from points of an unshadowed floor the light that the figure or a static solid
  /// occludes.
  void subtract_all_shadows(std::span<const ShadingPoint> points) { subtract(points, true); }

  /// Traces the rays that are still queued, and subtracts the light that the samples of the figure
  /// are known to lack (SharedOcclusion).
  void finish();

 private:
  /// Samples of a pixel that show one part of the figure and whose occlusion is shared.
  struct Group {
    Pixel* pixel;
    int part;
    Vec3 normals = Vec3::Zero();  // sum over the samples
    Color light = Color::Zero();  // that they would reflect without occlusion, the same
  };

  void shade_batch(std::span<const ShadingPoint> batch, bool of_figure);
  void subtract(std::span<const ShadingPoint> points, bool of_all);
  void subtract_batch(std::span<const ShadingPoint> batch, bool of_all);
  void add_area_lights(std::span<const ShadingPoint> batch, bool of_figure);
  std::uint32_t add_unoccluded(const AreaLight& light, std::span<const ShadingPoint> batch);
  void add_sky(std::span<const ShadingPoint> batch, const LaneVectors& normals, bool of_figure);
  void add_to_group(std::size_t number, const Sample& sample, const Color& light);
  void assign_groups(std::span<const ShadingPoint> batch);

  const PreparedScene& prepared_;
  ShadowRays rays_;
  const bool shares_sky_;  // occlusion of the sky on figures is shared
  const bool shares_lights_;
  std::vector<Group> groups_;                          // by pixel
  std::array<std::size_t, lanes> group_numbers_ = {};  // of the points of a batch
};

}  // namespace mien::render
