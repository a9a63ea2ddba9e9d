#pragma once

#include "motion/fitting/track.h"

namespace mien::motion {

/// The axis about which the middle joint of a limb bends, a unit vector perpendicular to the upper
/// bone. `sign` 1: the axis is (middle − root) × (end − middle), as for knees, whose axis points to
/// the subject's left; −1: the opposite.
///
/// Where the limb is nearly straight (the middle joint about 15 mm or less from the line between
/// the ends), its plane of bend is noise: there the axis turns smoothly into `expected`, turned
/// about the bone by the mean angle between the two axes in the frames in which the limb is bent.
Track hinge_axis(const Track& root, const Track& middle, const Track& end, const Track& expected,
                 double sign);

}  // namespace mien::motion
