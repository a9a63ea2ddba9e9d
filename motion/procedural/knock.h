#pragma once

#include "motion/skeleton/example.h"

namespace mien::motion {

/// How somebody knocks on a door. Lengths are shares of the right arm's, so that they fit every
/// body.
struct KnockStyle {
  int knocks = 3;
  double still_seconds = 0.4;   ///< before the hand rises and after it is down
  double raise_seconds = 0.8;   ///< from the thigh to the door; lowering takes 1.2 times that
  double knock_seconds = 0.32;  ///< from one hit to the next
  double height = 0.1;          ///< of the wrist over the shoulder, where it hits
  double reach = 0.72;          ///< of the wrist before the shoulder, where it hits
  double swing = 0.16;          ///< of the wrist back between hits
  double head_flexion_deg = 4.0;
  double chest_flexion_deg = 2.0;
};

/// A slow, low, small knock with hanging head; and a fast, high, wide one. Ours, by the direction
/// in which acted knocks differ (Pollick et al. 2001): speed and path with activation.
KnockStyle sad_knock();
KnockStyle angry_knock();

/// A body that stands, raises its right hand, knocks, and lowers it: synthesized, not captured. The
/// wrist goes by minimum-jerk paths between its stations (Flash and Hogan 1985), the arm follows by
/// two-bone inverse kinematics. Faces +Z, feet side by side, soles at y = 0, does not loop.
/// Keytimes: start, first hit, last hit, end. Throws Error for fewer than one knock, times or frame
/// rates that are not positive.
Example knock(const KnockStyle& style, double frames_per_second, const Skeleton& body);

/// A second of standing still in a pose, as an example.
Example stand(const Pose& pose, double frames_per_second, const Skeleton& body);

}  // namespace mien::motion
