#pragma once

#include <span>
#include <vector>

namespace mien::motion {

/// A local maximum of a sampled signal.
struct Peak {
  double place = 0.0;  ///< in samples, by a parabola through the three nearest samples
  double height = 0.0;
  double prominence = 0.0;  ///< height above the higher of its two bases
};

/// The local maxima whose prominence is at least `prominence`. A peak has a base on either side:
/// the lowest point before the signal rises above the peak or ends; its prominence is its height
/// above the higher base. If the signal ends on one side, within `margin` samples and without
/// rising above the peak, only the other base counts, so that peaks close to an end are found.
std::vector<Peak> prominent_peaks(std::span<const double> signal, double prominence, double margin);

}  // namespace mien::motion
