#pragma once

#include "motion/math/geometry.h"
#include "motion/procedural/foot_roll.h"
#include "motion/procedural/walk_curves.h"
#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// Trajectory of the pelvis through a gait cycle of phase 0 … 1 (phase 0 is left heel strike),
/// walking along +Z on the line x = 0.
struct PelvisPath {
  WalkStyle style;
  double stride_m = 0.0;       ///< forward per cycle
  double mean_height_m = 0.0;  ///< of the pelvis joint above the floor
};

/// Position of the pelvis joint: steady progress with a small surge in double support, two rises
/// per cycle (highest over the stance leg, lowest just after heel strike) and one sway to each
/// side.
Vec3 pelvis_position(const PelvisPath& path, double phase);

/// Rotation of the pelvis: axial rotation, obliquity, then forward tilt.
Quat pelvis_rotation(const PelvisPath& path, double phase);

/// The configuration of a leg independent of the body's position: the knee angle and the direction
/// of the line from hip to ankle.
struct LegLine {
  double knee_flexion = 0.0;  ///< radians, 0 is straight
  double swing = 0.0;         ///< angle from the vertical in the sagittal plane, forward, radians
  double outward = 0.0;       ///< lateral distance of the ankle outside the hip, metres
};

/// A curve over the swing phase, given by its values and slopes at both ends: those of the stance,
/// except that the slope of `LegCycle::knee_correction` at heel strike is 0.
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
  double ahead_m = 0.0;  ///< how far the footprint lies ahead of the pelvis (without its surge) at
                         ///< heel strike

  // The swing, found by `fit_swing`.
  SwingCurve knee_correction;  ///< added to the normal knee curve, radians
  SwingCurve swing_angle;
  SwingCurve outward;
  SwingCurve pitch;
  SwingCurve toe_extension;
  double knee_peak = 0.0;  ///< added in early swing for the style's peak knee flexion, radians
  double lift = 0.0;       ///< knee flexion added in mid-swing to clear the floor, radians
  double landing = 0.0;    ///< knee flexion added in late swing to descend from above, radians
};

/// The distance from hip to ankle (metres) at a knee flexion (radians), and the inverse function;
/// for a distance out of reach it returns a straight or fully bent knee.
double leg_length_at(const LegCycle& leg, double knee_flexion);
double knee_flexion_at(const LegCycle& leg, double distance);

/// Position of the hip joint at a cycle phase.
Vec3 hip_position(const LegCycle& leg, double cycle_phase);

/// The footprint (vertical projection of the ankle on the floor while the sole is flat), and the
/// direction of the foot, radians about +Y from +Z.
Vec3 print_of(const LegCycle& leg);
double yaw_of(const LegCycle& leg);

/// The foot during the stance that begins with heel strike at `phase` 0 of the leg's own cycle;
/// `phase` may lie slightly outside [0, stance_share], for numerical derivatives.
FootPose planted_foot(const LegCycle& leg, double phase);

/// The leg with the curves of its swing: they join the stance at toe off and the next stance at
/// heel strike with the same position and velocity (except for the velocity of the knee at heel
/// strike), and keep the foot clear of the floor.
LegCycle fit_swing(LegCycle leg);

/// Like `fit_swing`, with given `knee_peak`, `lift` and `landing`: computes the curves only, which
/// is fast.
LegCycle with_swing_curves(LegCycle leg);

/// The foot of a leg with swing curves at a phase of the leg's own cycle in [stance_share, 1].
FootPose swinging_foot(const LegCycle& leg, double phase);

/// The foot at any phase of the cycle (phase 0 is left heel strike; phase 1 is one stride farther).
FootPose foot_at(const LegCycle& leg, double cycle_phase);

}  // namespace mien::motion
