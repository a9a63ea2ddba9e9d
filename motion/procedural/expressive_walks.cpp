#include "motion/procedural/expressive_walks.h"

namespace mien::motion {

WalkStyle brisk_walk() {
  WalkStyle s = ordinary_walk(1.75, 126.0);
  s.trunk_lean_deg = 3.0;
  s.elbow_flexion_deg = 34.0;
  s.elbow_swing_deg = 32.0;
  s.arm_swing_deg = 52.0;
  s.trunk_rotation_deg = 6.5;
  return s;
}

WalkStyle slow_walk() {
  WalkStyle s = ordinary_walk(0.85, 86.0);
  s.sway_m = 0.054;
  return s;
}

WalkStyle happy_walk() {
  WalkStyle s = ordinary_walk(1.48, 117.0);
  s.bounce_m *= 1.3;
  s.heel_rise_share = 0.26;
  s.sway_m = 0.05;
  s.swing_knee_deg = 66.0;
  s.foot_clearance_m = 0.025;
  s.pelvis_obliquity_deg = 5.0;
  s.trunk_lean_deg = -1.0;
  s.chest_flexion_deg = -5.0;
  s.trunk_rotation_deg = 9.0;
  s.neck_flexion_deg = 6.0;
  s.head_pitch_deg = -6.0;
  s.head_sway_deg = 3.0;
  s.shoulder_protraction_deg = -3.0;
  s.arm_swing_deg = 60.0;
  s.arm_flexion_deg = -2.0;
  s.arm_abduction_deg = 14.0;
  s.elbow_flexion_deg = 28.0;
  s.elbow_swing_deg = 32.0;
  s.shoulder_elevation_deg = -4.0;
  s.arm_rotation_deg = 14.0;
  return s;
}

WalkStyle sad_walk() {
  WalkStyle s = ordinary_walk(0.80, 84.0);
  s.bounce_m *= 0.8;
  s.sway_m = 0.060;
  s.stance_knee_deg = 8.0;
  s.foot_clearance_m = 0.010;
  s.pelvis_tilt_deg = 2.0;
  s.trunk_lean_deg = 6.0;
  s.chest_flexion_deg = 16.0;
  s.trunk_rotation_deg = 2.5;
  s.neck_flexion_deg = 36.0;
  s.head_pitch_deg = 30.0;
  s.shoulder_elevation_deg = -10.0;
  s.shoulder_protraction_deg = 14.0;
  s.arm_swing_deg = 10.0;
  s.arm_flexion_deg = 2.0;
  s.arm_abduction_deg = 7.0;
  s.elbow_flexion_deg = 12.0;
  s.elbow_swing_deg = 5.0;
  s.wrist_swing_deg = 4.0;
  s.sharpness = -0.3;
  return s;
}

WalkStyle angry_walk() {
  WalkStyle s = ordinary_walk(1.68, 122.0);
  s.step_width_m = 0.11;
  s.heel_strike_deg = 24.0;
  s.impact_m = 0.014;
  s.stance_knee_deg = 7.0;
  s.trunk_lean_deg = 8.0;
  s.chest_flexion_deg = 6.0;
  s.trunk_rotation_deg = 9.0;
  s.neck_flexion_deg = 24.0;
  s.head_pitch_deg = 8.0;
  s.shoulder_elevation_deg = 3.0;
  s.shoulder_protraction_deg = 6.0;
  s.arm_swing_deg = 50.0;
  s.arm_flexion_deg = -2.0;
  s.arm_abduction_deg = 19.0;
  s.arm_rotation_deg = 22.0;
  s.elbow_flexion_deg = 56.0;
  s.elbow_swing_deg = 34.0;
  s.forearm_pronation_deg = 45.0;
  s.wrist_flexion_deg = 12.0;
  s.wrist_swing_deg = 2.0;
  s.arm_lag_share = 0.02;
  s.sharpness = 0.7;
  return s;
}

WalkStyle proud_walk() {
  WalkStyle s = ordinary_walk(1.22, 102.0);
  s.step_width_m = 0.11;
  s.foot_progression_deg = 13.0;
  s.heel_strike_deg = 23.0;
  s.foot_clearance_m = 0.022;
  s.sway_m = 0.05;
  s.pelvis_tilt_deg = 6.0;
  s.trunk_lean_deg = -4.0;
  s.chest_flexion_deg = -9.0;
  s.trunk_rotation_deg = 7.0;
  s.trunk_sway_deg = 2.0;
  s.neck_flexion_deg = 0.0;
  s.head_pitch_deg = -10.0;
  s.shoulder_elevation_deg = -3.0;
  s.shoulder_protraction_deg = -10.0;
  s.arm_swing_deg = 40.0;
  s.arm_flexion_deg = -8.0;
  s.arm_abduction_deg = 17.0;
  s.elbow_flexion_deg = 26.0;
  s.arm_rotation_deg = 4.0;
  return s;
}

WalkStyle afraid_walk() {
  WalkStyle s = ordinary_walk(0.72, 98.0);
  s.step_width_m = 0.07;
  s.foot_progression_deg = 1.0;
  s.heel_strike_deg = 6.0;
  s.stance_knee_deg = 20.0;
  s.foot_clearance_m = 0.025;
  s.bounce_m *= 0.7;
  s.sway_m = 0.030;
  s.pelvis_tilt_deg = 0.0;
  s.trunk_lean_deg = 6.0;
  s.chest_flexion_deg = 14.0;
  s.trunk_rotation_deg = 2.0;
  s.neck_flexion_deg = 30.0;
  s.head_pitch_deg = 4.0;
  s.shoulder_elevation_deg = 9.0;
  s.shoulder_protraction_deg = 16.0;
  s.arm_swing_deg = 7.0;
  s.arm_flexion_deg = 4.0;
  s.arm_abduction_deg = 5.0;
  s.arm_rotation_deg = 20.0;
  s.elbow_flexion_deg = 112.0;
  s.elbow_swing_deg = 6.0;
  s.wrist_flexion_deg = 18.0;
  s.wrist_swing_deg = 2.0;
  s.sharpness = 0.4;
  return s;
}

WalkStyle tired_walk() {
  WalkStyle s = ordinary_walk(0.70, 80.0);
  s.stance_share = 0.67;
  s.step_width_m = 0.12;
  s.heel_strike_deg = 7.0;
  s.toe_off_deg = 50.0;
  s.swing_knee_deg = 52.0;
  s.stance_knee_deg = 12.0;
  s.foot_clearance_m = 0.006;
  s.impact_m = 0.010;
  s.sway_m = 0.085;
  s.pelvis_tilt_deg = 0.0;
  s.trunk_lean_deg = 9.0;
  s.chest_flexion_deg = 13.0;
  s.trunk_rotation_deg = 3.0;
  s.trunk_sway_deg = 5.0;
  s.neck_flexion_deg = 32.0;
  s.head_pitch_deg = 16.0;
  s.head_sway_deg = 6.0;
  s.shoulder_elevation_deg = -11.0;
  s.shoulder_protraction_deg = 8.0;
  s.arm_swing_deg = 16.0;
  s.arm_flexion_deg = 6.0;
  s.arm_abduction_deg = 9.0;
  s.elbow_flexion_deg = 9.0;
  s.elbow_swing_deg = 6.0;
  s.wrist_swing_deg = 12.0;
  s.arm_lag_share = 0.09;
  s.sharpness = -0.7;
  return s;
}

WalkStyle relaxed_walk() {
  WalkStyle s = ordinary_walk(1.12, 97.0);
  s.step_width_m = 0.10;
  s.foot_progression_deg = 12.0;
  s.sway_m = 0.056;
  s.pelvis_rotation_deg = 7.0;
  s.pelvis_obliquity_deg = 5.5;
  s.pelvis_tilt_deg = 2.0;
  s.trunk_lean_deg = -4.0;
  s.chest_flexion_deg = 4.0;
  s.trunk_sway_deg = 2.0;
  s.neck_flexion_deg = 14.0;
  s.head_pitch_deg = -2.0;
  s.head_sway_deg = 2.0;
  s.shoulder_elevation_deg = -8.0;
  s.arm_swing_deg = 40.0;
  s.arm_abduction_deg = 12.0;
  s.elbow_flexion_deg = 19.0;
  s.elbow_swing_deg = 20.0;
  s.wrist_swing_deg = 18.0;
  s.arm_lag_share = 0.075;
  s.sharpness = -0.6;
  return s;
}

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
