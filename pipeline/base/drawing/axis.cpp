#include "pipeline/base/drawing/axis.h"

#include <cmath>

namespace mien::pipeline {

std::vector<double> axis_ticks(double most, int count) {
  if (!(most > 0.0)) return {0.0};
  const double power = std::pow(10.0, std::floor(std::log10(most / count)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (most / (factor * power) <= count * (1.0 + 1e-12)) step = factor * power;
  std::vector<double> ticks;
  for (int i = 0; i * step <= most * (1.0 + 1e-12); ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace mien::pipeline
