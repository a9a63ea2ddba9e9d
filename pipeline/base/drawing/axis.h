#pragma once

#include <vector>

namespace mien::pipeline {

/// Round numbers from 0 up to `most`, a step of 1, 2 or 5 times a power of ten, at most `count`
/// steps. Just 0 when `most` is not above 0.
std::vector<double> axis_ticks(double most, int count);

}  // namespace mien::pipeline
