#include "motion/fitting/hip_centres.h"

namespace mien::motion {

Vec3 hip_centre(const PelvisMeasures& measures, bool left) {
  const double forward = -0.24 * measures.depth - 0.0099;
  const double up = measures.leg_length
                        ? -0.16 * measures.width - 0.04 * *measures.leg_length - 0.0071
                        : -0.30 * measures.width - 0.0109;
  const double outward = 0.28 * measures.depth + 0.16 * measures.width + 0.0079;
  return {left ? outward : -outward, up, forward};
}

}  // namespace mien::motion
