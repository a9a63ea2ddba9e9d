#pragma once

#include "motion/skeleton/example.h"

namespace mien::motion {

/// The style of a knock on a door. Lengths are relative to the length of the right arm, so that
/// they apply to every body.
struct KnockStyle {
  int knocks = 3;
  double still_seconds = 0.4;  ///< before the hand rises and after it is lowered
  double raise_seconds = 0.8;  ///< from rest to in front of the door; lowering takes 1.2 times that
  double knock_seconds = 0.32;  ///< from one hit to the next
  double height = 0.1;          ///< of the wrist above the shoulder at a hit
  double reach = 0.72;          ///< of the wrist in front of the shoulder at a hit
  double swing = 0.16;          ///< distance by which the wrist draws back between hits
  double head_flexion_deg = 4.0;
  double chest_flexion_deg = 2.0;
};

/// A slow, low, small knock with the head hanging, and a fast, high, wide one. The numbers are our
/// own choice; the directions of the differences follow acted knocks (Pollick et al. 2001): speed
/// and path length increase with activation.
KnockStyle sad_knock();
KnockStyle angry_knock();

/// A body that stands, raises its right hand, knocks, and lowers it: synthesized, not captured. The
/// wrist follows minimum-jerk trajectories between its key positions (Flash and Hogan 1985); the
/// arm is posed by two-bone inverse kinematics. The body faces +Z with feet side by side and soles
/// at y = 0; the clip does not loop. Keytimes: start, first hit, last hit (if there are several),
/// end. Throws Error for fewer than one knock, or for durations or a frame rate that are not
/// positive.
Example knock(const KnockStyle& style, double frames_per_second, const Skeleton& body);

/// An example of standing still in a pose for one second.
Example stand(const Pose& pose, double frames_per_second, const Skeleton& body);

}  // namespace mien::motion
