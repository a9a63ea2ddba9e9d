#pragma once

#include <span>

namespace mien::motion {

/// The value below which `percent` (0–100) of the values lie, interpolated linearly. `values` must
/// not be empty.
double percentile(std::span<const double> values, double percent);

}  // namespace mien::motion
