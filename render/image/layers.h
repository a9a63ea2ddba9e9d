#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image/framebuffer.h"

namespace mien::render {

/// A named object that covers a fraction of a pixel.
struct Coverage {
  std::uint32_t id = 0;  ///< layer_id of its name; 0: none
  float share = 0.0f;
};

inline constexpr std::size_t covered_ranks = 6;

/// The figures or parts of figures that cover each pixel, by descending share.
struct CoverageLayer {
  std::vector<std::string> names;  ///< names of all objects, in the scene's order
  std::vector<Coverage> ranks;     ///< covered_ranks per pixel
};

/// A picture with its arbitrary output variables (AOVs). Albedo, normal and coverage are means over
/// a pixel's samples, which are filtered like the picture's. Depth, position and motion, whose
/// means would be meaningless, are those of the ray through the pixel's centre, for which figures
/// are opaque. The backdrop has albedo 0, normal 0, position 0 and an infinite depth.
struct Layers {
  Framebuffer beauty;
  Framebuffer albedo;
  Framebuffer normal;           ///< world space, on the side that is seen
  Framebuffer position;         ///< world space, metres
  std::vector<float> depth;     ///< along the optical axis, metres
  std::vector<float> motion;    ///< two per pixel: displacement to the next picture, pixels; 0 if
                                ///< there is none
  std::vector<float> samples;   ///< number of primary rays; 0: the pixel shows no solid and is
                                ///< known in closed form
  std::vector<float> variance;  ///< variance of the pixel's luminance over noise patterns
  CoverageLayer figures;
  CoverageLayer parts;  ///< "figure/part"
};

/// Crops all layers except the beauty to a window.
Layers crop(Layers layers, const Window& window);

/// Returns the Cryptomatte id of a name: MurmurHash3 (32 bits, seed 0), with the lowest exponent
/// bit flipped where the bits would be a denormal, infinite or NaN float (Friedman & Jones 2015).
std::uint32_t layer_id(const std::string& name);

}  // namespace mien::render
