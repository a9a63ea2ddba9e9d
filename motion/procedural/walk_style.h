#pragma once

namespace mien::motion {

/// Parameters of the parametric walker on level ground. The defaults describe an ordinary adult
/// walk at a comfortable speed. Angles are in degrees, shares in fractions of the gait cycle.
/// Lengths (metres) and the speed are those for a stature of 1.75 m; on other bodies they are
/// scaled with leg length.
///
/// A "range" is measured from one extreme to the other; an "amplitude" is half of it.
struct WalkStyle {
  // Time and steps. Step length = speed · 60 / cadence.
  double speed_m_s = 1.35;
  double cadence_steps_min = 112.0;
  double stance_share = 0.605;  ///< share of the cycle with the foot on the floor; above ½, since
                                ///< otherwise it would be a run
  double step_width_m = 0.09;   ///< between the lines on which left and right foot land
  double foot_progression_deg = 7.0;  ///< toes out, from the line of travel

  // Feet and legs.
  double heel_strike_deg = 20.0;    ///< angle of sole and floor at heel strike, toes up
  double heel_rise_share = 0.31;    ///< phase at which the heel begins to leave the floor
  double toe_off_deg = 66.0;        ///< angle of sole and floor at toe off, heel up
  double swing_knee_deg = 61.0;     ///< peak knee flexion of the swing
  double stance_knee_deg = 5.0;     ///< least knee flexion in stance; 2° more at heel strike
  double foot_clearance_m = 0.015;  ///< least height of swinging toes above planted toes
  double knee_splay_deg = 0.0;      ///< knees out, from a direction between pelvis and foot

  // Pelvis.
  double bounce_m = 0.043;            ///< vertical range, two periods per cycle
  double sway_m = 0.045;              ///< lateral range, one period per cycle
  double pelvis_rotation_deg = 6.0;   ///< amplitude of axial rotation, swinging side forward
  double pelvis_obliquity_deg = 4.0;  ///< amplitude in the frontal plane, swinging side down
  double pelvis_tilt_deg = 4.0;       ///< mean, forward

  // Trunk and head.
  double trunk_lean_deg = 0.5;      ///< of the lumbar spine from the vertical, forward
  double chest_flexion_deg = 3.0;   ///< of the chest on the spine (slumped); below 0 chest out
  double trunk_rotation_deg = 5.0;  ///< amplitude of the shoulder line, opposite to the pelvis
  double trunk_sway_deg = 1.5;      ///< amplitude of leaning sideways over the stance leg
  double neck_flexion_deg = 13.0;   ///< of the neck from the vertical, forward
  double head_pitch_deg = 0.0;  ///< of the head from level, positive looking down; below 0 chin up
  double head_sway_deg = 0.0;   ///< amplitude of tilting sideways with the steps

  // Shoulders and arms.
  double shoulder_elevation_deg = -5.0;   ///< clavicles up (shrugged); negative when relaxed
  double shoulder_protraction_deg = 0.0;  ///< clavicles forward (rounded); below 0 drawn back
  double arm_swing_deg = 38.0;            ///< range of the upper arm, forward–backward
  double arm_flexion_deg = -4.0;          ///< mean of the upper arm from the vertical, forward
  double arm_abduction_deg = 11.0;        ///< upper arms away from the trunk
  double arm_rotation_deg = 12.0;         ///< internal rotation of the upper arms
  double elbow_flexion_deg = 24.0;        ///< mean
  double elbow_swing_deg = 22.0;          ///< range, most flexed at the forward end of the swing
  double forearm_pronation_deg = 25.0;    ///< from palms facing the thighs to palms facing back
  double wrist_flexion_deg = 6.0;         ///< mean
  double wrist_swing_deg = 10.0;          ///< range; the hand trails the forearm
  double arm_lag_share = 0.045;           ///< delay of the forearm's swing after the upper arm's

  /// How abruptly arms and trunk swing: 0 sinusoidal; towards 1 they move quickly between the ends
  /// and pause there (tense, marching); towards −1 they move at a more even speed, without
  /// lingering at the ends (languid). In [−1, 1].
  double sharpness = 0.0;

  /// Heaviness of the steps: additional drop of the pelvis after each heel strike, metres.
  double impact_m = 0.0;
};

/// Step length, metres.
double step_length_m(const WalkStyle& style);

/// Vertical range of the pelvis, metres, that results from a step length (metres) when the knees
/// stay near their normal curves: it grows with the square of the step, as for an inverted
/// pendulum.
double natural_bounce_m(double step_length);

/// The style of an ordinary adult walk at another speed and cadence. With longer steps, the heel
/// strikes and the toe leaves the floor at a steeper angle, and the pelvis rotates and bounces
/// more; with higher speed, stance is shorter and the arms swing wider (Murray et al. 1984; Winter
/// 1991). `ordinary_walk(1.35, 112)` is the default style.
WalkStyle ordinary_walk(double speed_m_s, double cadence_steps_min);

}  // namespace mien::motion
