#include "motion/math/pyramid.h"

namespace mien::motion {

double band_peak_hz(int band, double rate_hz) {
  // Where [sin(2^k x) / (2^k sin x)]⁴ loses most from one level to the next, x = π f / rate.
  switch (band) {
    case 0:
      return 0.5 * rate_hz;
    case 1:
      return 0.1405 * rate_hz;
    case 2:
      return 0.0668 * rate_hz;
    default:
      return 0.0330 * rate_hz * std::exp2(3 - band);
  }
}

}  // namespace mien::motion
