#pragma once

#include <array>
#include <cstdint>

#include "render/light/lanes.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

/// How a pixel is drawn.
enum class PixelKind {
  untouched,  ///< the set, and what the figure hides of the sky from its floor
  floor,      ///< likewise, and what it hides of the lights
  wall,       ///< a standing solid may show, and no figure
  figure,     ///< the figure may show, and no standing solid
  piecemeal   ///< every sample by itself: figure and standing solids may both show
};

/// A pixel that shows the floor, as far as lines of the lights may take away from it.
struct FloorPixel {
  int x = 0;
  int y = 0;
  std::uint32_t shadow_lights = 0;  ///< bit i: the figure may hide light i from here
  Color radiance = Color::Zero();   ///< of the set
  Color floor_albedo = Color::Zero();
  Color known_taken = Color::Zero();  ///< what the figure takes away from the set as it is known,
                                      ///< summed over the samples
  int block_samples = 0;              ///< that lack what the line of its block finds
};

/// Takes from so many samples of a pixel what is hidden from each of them, irradiance over π.
inline void take_light(FloorPixel& pixel, int samples, const Color& hidden) {
  pixel.known_taken -= (static_cast<float>(samples) * hidden) * pixel.floor_albedo;
}

/// A pixel while its samples are drawn.
struct Pixel : FloorPixel {
  Pixel() {}  // sets no more to zero than what has no other beginning

  PixelKind kind = PixelKind::untouched;
  PixelSampler sampler;
  bool shows_floor = false;
  int floor_sky_rays = 0;          ///< so many of the samples look from the floor at the sky
  float floor_sky_samples = 0.0f;  ///< that each of those stands for
  int set_samples = 0;             ///< samples that show the set as it is known
  int covered = 0;                 ///< samples that show the figure

  /// Whether the figure may hide a light from here.
  bool may_lack(int light) const { return ((shadow_lights >> light) & 1u) != 0; }

  // Sums over the samples. What is known at once and what rays find are kept apart, so that either
  // is always added up in the same order; of what the set loses `known_taken` is known at once.
  Color known_figure = Color::Zero();  ///< light from the figure
  Color known_set = Color::Zero();     ///< light from the set, sample by sample
  Color figure = Color::Zero();        ///< more or less light from the figure, by rays
  Color set = Color::Zero();           ///< from the set
  Color taken = Color::Zero();         ///< as known_taken, by rays
};

/// One primary ray of a pixel.
struct Sample {
  Pixel* pixel = nullptr;
  int index = 0;
  float time = 0.0f;
  std::uint32_t present = ~0u;  ///< bit f: figure f is there
  float weight = 1.0f;          ///< of so many samples, whose light its own stands for
  Pixel* partner = nullptr;     ///< another pixel whose samples it stands for,
  float partner_weight = 0.0f;  ///< so many
};

/// Adds light from a sample to what its pixels sum up so.
inline void add_light(const Sample& sample, Color Pixel::*sum, const Color& light) {
  sample.pixel->*sum += sample.weight * light;
  if (sample.partner != nullptr) sample.partner->*sum += sample.partner_weight * light;
}

/// Up to eight samples.
struct Samples {
  std::array<Sample, lanes> lane;
  int count = 0;

  /// Room for one more, as nothing has been said of it.
  Sample& next() { return lane[static_cast<std::size_t>(count++)] = {}; }
  void push(const Sample& sample) { lane[static_cast<std::size_t>(count++)] = sample; }
  const Sample& operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
};

/// The random numbers of all samples for one purpose.
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
