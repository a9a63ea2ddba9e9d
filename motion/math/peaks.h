#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// A local maximum of a sampled signal.
struct Peak {
  double place = 0.0;  ///< samples, by a parabola through the three nearest
  double height = 0.0;
  double prominence = 0.0;  ///< height above the base that counted
};

/// The local maxima that rise by `prominence` above the higher of the two lowest points between
/// them and a higher sample (or the end) on either side. Within `margin` samples of an end only the
/// other side counts, so that a peak that the signal just covers is still found.
std::vector<Peak> prominent_peaks(std::span<const double> signal, double prominence, double margin);

}  // namespace mien::motion
