#pragma once

#include <vector>

namespace mien::motion {

/// A smooth curve that is nowhere below `needed`: the largest need within `half_width` frames, then
/// averaged over as many by a raised cosine. Needs are ≥ 0. The envelope of a loop is periodic.
std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops);

/// Smooth step from 1 (x ≤ 0) to 0 (x ≥ 1), with zero slope at both ends.
double fade(double x);

}  // namespace mien::motion
