#include "render/math/directions.h"

#include <algorithm>
#include <cmath>

namespace mien::render {
float arc_sine(float x) {
  const bool upper = x > 0.5f;
  const float z = upper ? 0.5f * (1.0f - x) : x * x;
  const float s = upper ? std::sqrt(std::max(z, 0.0f)) : x;
  const float series =
      s * (1.0f + z * (0.166667819f +
                       z * (0.0749469697f +
                            z * (0.0455206372f + z * (0.0239939988f + z * 0.0424173735f)))));
  return upper ? 0.5f * pi - 2.0f * series : series;
}

}  // namespace mien::render
