#include "motion/math/pyramid.h"

namespace mien::motion {

double band_peak_hz(int band, double rate_hz) {
  // Where [sin(2^k x) / (2^k sin x)]⁴ loses most from one level to the next, x = π f / rate.
  constexpr double shares[] = {0.5, 0.1405, 0.0668};
  return band < 3 ? shares[band] * rate_hz : 0.0330 * rate_hz * std::exp2(3 - band);
}

}  // namespace mien::motion
