#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/light/shading.h"
#include "render/light/sky_cone.h"
#include "render/math/lanes.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

/// How a pixel is rendered.
enum class PixelKind {
  background,  ///< shows the static background only, which the figure may shadow
  traced,      ///< camera rays decide which samples show the figure or a static solid
  per_sample   ///< so do they, and each sample also renders its own background
};

/// A pixel while its samples are rendered.
struct Pixel {
  Pixel() {}  // user-provided, so that value-initialisation does not zero the members first

  int x = 0;
  int y = 0;
  PixelKind kind = PixelKind::background;
  PixelSampler sampler;
  std::uint32_t shadow_lights = 0;     ///< bit i: its floor samples cast shadow rays to light i
  Color floor_shadow = Color::Zero();  ///< light that its floor lacks, if that is shared
  SkyRays floor_sky;                   ///< rays by which its floor samples the occluded sky
  Color background = Color::Zero();    ///< radiance of the static background
  Color floor_albedo = Color::Zero();  ///< of the static background; black where it has no floor
  int background_samples = 0;          ///< samples that show the static background
  int floor_samples = 0;               ///< those of them that show its floor
  int covered = 0;                     ///< samples that show the figure

  // Sums over the samples. Light that is known at once and light found by rays later are summed
  // separately, so that each sum is always taken in the same order.
  Color known_figure = Color::Zero();  ///< light from the figure
  Color known_set = Color::Zero();     ///< light from the set, of samples that render their own set
  Color figure = Color::Zero();        ///< light of the figure that shadow rays add or subtract,
                                       ///< and occlusion that is shared
  Color set = Color::Zero();           ///< light of the set that shadow rays add or subtract
};

/// A camera ray of a pixel.
struct Sample {
  Pixel* pixel = nullptr;
  int index = 0;
  float time = 0.0f;
  std::uint32_t present = ~0u;  ///< bit f: figure f is present
  int count = 1;                ///< number of its pixel's samples that it represents
};

/// Limit of Quality::samples_shaded_together.
inline constexpr std::size_t most_shaded_together = 4;

/// A point that a sample shows and that is lit or shadowed.
struct ShadingPoint {
  Sample sample;
  Surface surface;
  /// Starts of the shadow rays of the second, third and fourth sample that it represents.
  std::array<Vec3, most_shaded_together - 1> more_origins;
  // For Lighting::subtract_shadow and subtract_all_shadows only.
  std::uint32_t lights = ~0u;  ///< bit i: a shadow ray to light i is cast
  SkyRays sky;                 ///< sky rays of its pixel
};

inline const Sample& sample_of(const Sample& sample) { return sample; }
inline const Sample& sample_of(const ShadingPoint& point) { return point.sample; }

/// The random points of up to eight samples for one dimension, of light or figure number `which`.
/// Each sample has `times` points; returns the one with index `plus` for every sample.
template <class Element>
LanePoints points_for(std::span<const Element> batch, Dimension dimension, int which = 0,
                      int times = 1, int plus = 0) {
  LaneWords index, seed;
  int lane = 0;
  for (const Element& each : batch) {
    const Sample& sample = sample_of(each);
    index[lane] = sample.pixel->sampler.index(times * sample.index + plus, times);
    seed[lane++] = sample.pixel->sampler.seed(dimension, which);
  }
  return sample_points(index, seed);
}

}  // namespace mien::render
