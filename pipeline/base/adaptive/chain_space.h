#pragma once

#include <cstdint>
#include <vector>

namespace mien::pipeline {

/// The values that a dimension may have; low < high.
struct DimensionRange {
  double low = 0.0;
  double high = 1.0;
};

/// The box in which chains move, one range for each dimension.
using ChainSpace = std::vector<DimensionRange>;

/// A point of the space, uniformly distributed, that depends only on seed, chain and attempt. If
/// not all points of the box can be shown, the first attempt that can is the start of the chain.
std::vector<double> random_start(const ChainSpace& space, std::uint64_t seed, int chain,
                                 int attempt = 0);

}  // namespace mien::pipeline
