#pragma once

#include <vector>

namespace mien::motion {

/// A smooth curve that is nowhere below `needed`: the largest need within `half_width` frames, then
/// averaged over as many by a raised cosine. Needs are ≥ 0. That of a loop goes on over its seam.
std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops);

/// 1 at and below 0, 0 at and beyond 1, level at both.
double fade(double x);

}  // namespace mien::motion
