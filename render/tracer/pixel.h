#pragma once

#include <array>
#include <cstdint>

#include "render/light/lanes.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

/// How a pixel is drawn.
enum class PixelKind {
  background,      ///< the background, with the figure's occlusion of the sky on its floor
  shadowed_floor,  ///< as `background`, also with the figure's shadows from the lights
  static_solid,    ///< a static solid may show, and no figure
  figure,          ///< the figure may show, and no static solid
  per_sample       ///< each sample separately: figure and static solids may both show
};

/// A pixel that shows the floor, with the properties on which line shadows depend.
struct FloorPixel {
  int x = 0;
  int y = 0;
  std::uint32_t shadow_lights = 0;  ///< bit i: the figure may occlude light i
  Color radiance = Color::Zero();   ///< radiance of the background
  Color floor_albedo = Color::Zero();
  /// Light of the background that the figure occludes, as far as it is known without rays; summed
  /// over the samples, negative.
  Color known_occluded = Color::Zero();
  int block_samples = 0;  ///< samples that wait for a line shared with other pixels
};

/// Subtracts from a number of samples of a pixel the light that is occluded: `hidden` (irradiance
/// divided by π) for each.
inline void subtract_light(FloorPixel& pixel, int samples, const Color& hidden) {
  pixel.known_occluded -= (static_cast<float>(samples) * hidden) * pixel.floor_albedo;
}

/// A pixel while its samples are traced.
struct Pixel : FloorPixel {
  Pixel() {}  // user-provided, so that value-initialisation does not zero the members first

  PixelKind kind = PixelKind::background;
  PixelSampler sampler;
  bool shows_floor = false;
  int floor_sky_rays = 0;          ///< number of samples that cast a sky ray from the floor
  float floor_sky_samples = 0.0f;  ///< samples that each of those represents
  int background_samples = 0;      ///< samples that show the static background
  int covered = 0;                 ///< samples that show the figure

  /// Whether the figure may hide a light from this pixel's floor.
  bool may_be_shadowed(int light) const { return ((shadow_lights >> light) & 1u) != 0; }

  // Sums over the samples. Light that is known at once and light found by rays later are summed
  // separately, so that each sum is always taken in the same order.
  Color known_figure = Color::Zero();      ///< light from the figure
  Color known_background = Color::Zero();  ///< light from the set, sample by sample
  Color figure = Color::Zero();      ///< light from the figure that shadow rays add or subtract
  Color background = Color::Zero();  ///< the same from the set
  Color occluded = Color::Zero();    ///< as known_occluded, found by rays
};

/// One primary ray of a pixel.
struct Sample {
  Pixel* pixel = nullptr;
  int index = 0;
  float time = 0.0f;
  std::uint32_t present = ~0u;  ///< bit f: figure f is present
  float weight = 1.0f;          ///< number of its pixel's samples that it represents
  Pixel* partner = nullptr;     ///< another pixel, some of whose samples it represents
  float partner_weight = 0.0f;  ///< number of the partner's samples that it represents
};

/// Adds a sample's light to one of the sums of its pixel, and of its partner.
inline void add_light(const Sample& sample, Color Pixel::*sum, const Color& light) {
  sample.pixel->*sum += sample.weight * light;
  if (sample.partner != nullptr) sample.partner->*sum += sample.partner_weight * light;
}

/// Up to eight samples.
struct Samples {
  std::array<Sample, lanes> lane;
  int count = 0;

  /// Appends a default sample.
  Sample& next() { return lane[static_cast<std::size_t>(count++)] = {}; }
  void push(const Sample& sample) { lane[static_cast<std::size_t>(count++)] = sample; }
  const Sample& operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
};

/// The random points of all samples for one dimension, of light or figure number `which`. Each
/// sample has `times` points; returns the one with index `plus` for every sample.
inline LanePoints points_for(const Samples& samples, Dimension dimension, int which = 0,
                             int times = 1, int plus = 0) {
  LaneWords index, seed;
  for (int i = 0; i < samples.count; ++i) {
    const PixelSampler& sampler = samples[i].pixel->sampler;
    index[i] = sampler.index(times * samples[i].index + plus, times);
    seed[i] = sampler.seed(dimension, which);
  }
  return sample_points(index, seed);
}

}  // namespace mien::render
