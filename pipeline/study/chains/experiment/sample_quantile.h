#pragma once

#include <vector>

namespace mien::pipeline {

/// A quantile of order statistics, linear between them (Hyndman and Fan 1996, type 7). `sorted`:
/// ascending, not empty; `share`: 0…1.
double quantile_of(const std::vector<double>& sorted, double share);

}  // namespace mien::pipeline
