#pragma once

#include "motion/math/geometry.h"
#include "motion/procedural/foot_roll.h"
#include "motion/procedural/walk_curves.h"
#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// Trajectory of the pelvis through a gait cycle of phase 0 … 1 (phase 0 is left heel strike),
/// along +Z with the path's line at x = 0.
struct PelvisPath {
  WalkStyle style;
  double stride_m = 0.0;       ///< forward per cycle
  double mean_height_m = 0.0;  ///< of the pelvis joint above the floor
};

/// Position of the pelvis joint: steady progress with the small surges of double support, two rises
/// a cycle (highest over the standing leg, lowest just after heel strike) and one sway to each
/// side.
Vec3 pelvis_position(const PelvisPath& path, double phase);

/// Rotation of the pelvis: about the vertical, in the frontal plane, then forward tilt.
Quat pelvis_rotation(const PelvisPath& path, double phase);

/// The line from hip to ankle, as a knee angle and two deviations: what a leg does, apart from
/// where the body is.
struct LegLine {
  double knee_flexion = 0.0;  ///< radians, 0 is straight
  double swing = 0.0;         ///< angle from the vertical in the sagittal plane, forward, radians
  double outward = 0.0;       ///< ankle outside of the hip, metres
};

/// A curve over the swing phase that continues the stance at both ends with its value and slope.
struct SwingCurve {
  CurveEnd toe_off;
  CurveEnd heel_strike;
};

/// One leg through the gait cycle, its foot fixed to the floor during stance.
struct LegCycle {
  PelvisPath pelvis;
  double side = 1.0;          ///< +1 left, −1 right
  double phase_offset = 0.0;  ///< cycle phase of this leg's heel strike: 0 left, ½ right
  Vec3 hip_offset;            ///< in the pelvis frame
  double thigh_m = 0.0;
  double shank_m = 0.0;
  FootShape foot;
  double ahead_m = 0.0;  ///< from the pelvis at heel strike to the print, forward

  // The swing, found by `fit_swing`.
  SwingCurve knee_correction;  ///< added to the normal knee curve, radians
  SwingCurve swing_angle;
  SwingCurve outward;
  SwingCurve pitch;
  SwingCurve toe_extension;
  double knee_peak = 0.0;  ///< added in early swing for the style's peak knee flexion, radians
  double lift = 0.0;       ///< knee flexion added in mid-swing to clear the floor, radians
  double landing = 0.0;    ///< knee flexion added in late swing to come down from above, radians
};

/// Hip–ankle distance at a knee flexion (radians), and the reverse; a distance out of reach gives a
/// straight or a fully bent knee.
double leg_length_at(const LegCycle& leg, double knee_flexion);
double knee_flexion_at(const LegCycle& leg, double distance);

/// Position of the hip joint at a cycle phase.
Vec3 hip_position(const LegCycle& leg, double cycle_phase);

/// Where the ankle's plumb line meets the floor while the foot stands flat, and where the foot
/// points (from +Z about +Y, radians).
Vec3 print_of(const LegCycle& leg);
double yaw_of(const LegCycle& leg);

/// The foot during the stance that begins with heel strike at `phase` 0 of the leg's own cycle;
/// `phase` may leave [0, stance_share] a little, for derivatives.
FootPose planted_foot(const LegCycle& leg, double phase);

/// The leg with the curves of its swing: they leave the stance at toe off and meet the next stance
/// at heel strike without a jump in speed or acceleration, and keep the foot clear of the floor.
LegCycle fit_swing(LegCycle leg);

/// As `fit_swing` with given `knee_peak`, `lift` and `landing`: computes the curves only, which is
/// fast.
LegCycle with_swing_curves(LegCycle leg);

/// The foot of a leg with swing curves at a phase of the leg's own cycle in [stance_share, 1].
FootPose swinging_foot(const LegCycle& leg, double phase);

/// The foot at any phase of the cycle (phase 0 is left heel strike; 1 is a stride further on).
FootPose foot_at(const LegCycle& leg, double cycle_phase);

}  // namespace mien::motion
