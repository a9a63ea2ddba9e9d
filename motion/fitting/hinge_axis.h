#pragma once

#include "motion/fitting/track.h"

namespace mien::motion {

/// How the axis of a hinge follows from the bones beside it.
struct Hinge {
  /// 1: the axis is (middle − root) × (end − middle), as for knees, whose axis points to the
  /// subject's left; −1: the opposite.
  double sign = 1.0;
  /// Angle between the lower bone and the plane in which it turns (the carrying angle of the
  /// elbow), radians.
  double valgus = 0.0;
  /// Distance of the middle joint from the line between the ends at which the plane of bend is half
  /// trusted.
  double noise_metres = 0.015;
};

/// The axis about which the middle joint of a limb bends, a unit vector perpendicular to the upper
/// bone.
///
/// Where the limb is nearly straight (the middle joint about 15 mm or less from the line between
/// the ends), its plane of bend is noise: there the axis turns smoothly into `expected`, turned
/// about the bone by the mean angle between the two axes over the frames in which the limb is bent
/// (by more than 3 cm, fully by 9 cm); a limb that is never bent keeps `expected`. An axis
/// across or against that one counts only if the limb is far bent.
Track hinge_axis(const Track& root, const Track& middle, const Track& end, const Track& expected,
                 const Hinge& hinge);

/// A limb of which the middle is marked on its outer side only.
struct Limb {
  Track end;                  ///< the joint at the end, or a point on its outer side
  bool end_is_outer = false;  ///< `end` is such a point
  double end_inward = 0.0;    ///< from that point to the joint along the axis, metres (signed)
  Track expected;             ///< of the axis
};

/// The middle joint of a limb: `inward` metres (signed) along the hinge's axis from the point on
/// its outer side. The axis follows from the joint and the joint from the axis: five rounds.
Track joint_beside(const Track& root, const Track& outer, const Limb& limb, double inward,
                   const Hinge& hinge);

}  // namespace mien::motion
