#include "motion/procedural/acted_walks.h"

namespace mien::motion {

WalkStyle excited_walk() {
  WalkStyle s = ordinary_walk(1.66, 128.0);
  s.bounce_m *= 1.35;
  s.heel_rise_share = 0.25;
  s.sway_m = 0.05;
  s.swing_knee_deg = 70.0;
  s.foot_clearance_m = 0.03;
  s.pelvis_rotation_deg = 8.0;
  s.trunk_lean_deg = 2.0;
  s.chest_flexion_deg = -4.0;
  s.trunk_rotation_deg = 11.0;
  s.neck_flexion_deg = 8.0;
  s.head_pitch_deg = -5.0;
  s.head_sway_deg = 4.0;
  s.arm_swing_deg = 70.0;
  s.arm_flexion_deg = 0.0;
  s.arm_abduction_deg = 17.0;
  s.elbow_flexion_deg = 52.0;
  s.elbow_swing_deg = 40.0;
  s.shoulder_elevation_deg = -2.0;
  s.sharpness = 0.35;
  return s;
}

WalkStyle strong_walk() {
  WalkStyle s = ordinary_walk(1.40, 104.0);
  s.step_width_m = 0.14;
  s.foot_progression_deg = 13.0;
  s.heel_strike_deg = 24.0;
  s.impact_m = 0.010;
  s.sway_m = 0.055;
  s.trunk_lean_deg = 1.0;
  s.chest_flexion_deg = -6.0;
  s.trunk_rotation_deg = 9.0;
  s.trunk_sway_deg = 2.5;
  s.neck_flexion_deg = 8.0;
  s.head_pitch_deg = -1.0;
  s.shoulder_protraction_deg = -4.0;
  s.shoulder_elevation_deg = -1.0;
  s.arm_swing_deg = 50.0;
  s.arm_abduction_deg = 24.0;
  s.arm_rotation_deg = 26.0;
  s.elbow_flexion_deg = 34.0;
  s.elbow_swing_deg = 26.0;
  s.forearm_pronation_deg = 50.0;
  s.sharpness = 0.3;
  return s;
}

WalkStyle weak_walk() {
  WalkStyle s = ordinary_walk(0.66, 86.0);
  s.stance_share = 0.66;
  s.step_width_m = 0.08;
  s.heel_strike_deg = 6.0;
  s.toe_off_deg = 52.0;
  s.swing_knee_deg = 52.0;
  s.stance_knee_deg = 13.0;
  s.foot_clearance_m = 0.009;
  s.bounce_m *= 0.8;
  s.sway_m = 0.055;
  s.pelvis_tilt_deg = 2.0;
  s.trunk_lean_deg = 4.0;
  s.chest_flexion_deg = 10.0;
  s.trunk_rotation_deg = 2.0;
  s.trunk_sway_deg = 3.0;
  s.neck_flexion_deg = 22.0;
  s.head_pitch_deg = 8.0;
  s.shoulder_elevation_deg = -9.0;
  s.shoulder_protraction_deg = 10.0;
  s.arm_swing_deg = 7.0;
  s.arm_flexion_deg = 2.0;
  s.arm_abduction_deg = 4.0;
  s.elbow_flexion_deg = 18.0;
  s.elbow_swing_deg = 3.0;
  s.wrist_swing_deg = 5.0;
  s.sharpness = -0.2;
  return s;
}

}  // namespace mien::motion
