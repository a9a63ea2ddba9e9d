#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// A local maximum of a sampled signal.
struct Peak {
  double place = 0.0;       ///< in samples, by a parabola through the three nearest samples
  double height = 0.0;      ///< value of the highest sample
  double prominence = 0.0;  ///< height above the higher of its two bases
};

/// The local maxima whose prominence is at least `prominence`. A peak has a base on either side:
/// the lowest point between the peak and the place where the signal first exceeds it or ends. The
/// prominence is the height above the higher base. If the signal ends on one side, within `margin`
/// samples and without exceeding the peak, only the base on the other side counts, so that peaks
/// close to an end are found.
std::vector<Peak> prominent_peaks(std::span<const double> signal, double prominence, double margin);

}  // namespace mien::motion
