#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image/framebuffer.h"

namespace mien::render {

/// A named thing that covers a share of a pixel.
struct Coverage {
  std::uint32_t id = 0;  ///< of its name, see layer_id; 0: nothing
  float share = 0.0f;
};

inline constexpr std::size_t covered_ranks = 6;

/// What covers each pixel, by falling share.
struct CoverageLayer {
  std::vector<std::string> names;  ///< all that the scene holds, in its order
  std::vector<Coverage> ranks;     ///< covered_ranks a pixel
};

/// A picture with its arbitrary output variables (AOVs). Means over a pixel's samples, under the
/// same filter as the picture: albedo, normal, ids. Taken from the ray through the pixel's centre,
/// because a mean would be meaningless: depth, position, motion. The backdrop has albedo 0, normal
/// 0, position 0 and an infinite depth.
struct Layers {
  Framebuffer beauty;
  Framebuffer albedo;
  Framebuffer normal;           ///< world space, on the side that is seen
  Framebuffer position;         ///< world space, metres
  std::vector<float> depth;     ///< along the optical axis, metres
  std::vector<float> motion;    ///< two a pixel: to where it is in the next picture, pixels
  std::vector<float> samples;   ///< primary rays that were traced; 0: known in closed form
  std::vector<float> variance;  ///< of the pixel's luminance between noise patterns
  CoverageLayer figures;
  CoverageLayer parts;  ///< "figure/part"
};

/// Crops all layers of the size of `layers.albedo` to a window.
Layers crop(Layers layers, const Window& window);

/// The id that Cryptomatte gives a name: MurmurHash3 (32 bits, seed 0), with the exponent kept off
/// the values that are no finite number (Friedman & Jones 2015).
std::uint32_t layer_id(const std::string& name);

}  // namespace mien::render
