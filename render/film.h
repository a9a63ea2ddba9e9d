#pragma once

#include "render/image.h"

namespace mien::render {

/// What the tracer exposes: linear radiance, Rec.709 primaries, scene-referred (0.18 is mid grey,
/// values above 1 are allowed).
using Film = Image<float>;

/// A film, and how much of each pixel is covered where the background does not show.
struct Exposure {
  Film film;                 ///< multiplied by alpha (associated)
  std::vector<float> alpha;  ///< 0 … 1, one a pixel; empty where the background shows
};

}  // namespace mien::render
