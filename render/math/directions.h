#pragma once

#include <cmath>

#include "render/math/constants.h"
#include "render/math/sampler.h"

namespace mien::render {

// These functions use only arithmetic and square roots, no libm, so that results are bit-identical
// on every machine.

/// Arc sine for 0 … 1, radians, to 1e-7.
float arc_sine(float x);

/// A point of the unit disc, uniformly distributed by the concentric mapping (Shirley & Chiu 1997),
/// which maps concentric squares to concentric circles and keeps strata compact.
struct DiscPoint {
  float x;
  float y;
};

// Without branches, so that loops over it become vector code. Chebyshev fits of cosine and sine,
// error below 4e-8.
inline DiscPoint disc_point(Point2 point) {
  const float u = 2.0f * point.u - 1.0f, v = 2.0f * point.v - 1.0f;
  const bool wide = std::abs(u) > std::abs(v);
  const float radius = wide ? u : v;
  const float other = wide ? v : u;
  const float angle = radius == 0.0f ? 0.0f : other / radius * (pi / 4.0f);
  const float z = angle * angle;
  const float cosine =
      1.0f + z * (-0.5f + z * (0.04166661575f + z * (-0.001388661796f + z * 2.437983e-05f)));
  const float sine =
      angle * (1.0f + z * (-0.1666665077f + z * (0.008332035504f + z * -1.9503904e-04f)));
  const float along = radius * cosine, across = radius * sine;
  return {wide ? along : across, wide ? across : along};
}

}  // namespace mien::render
