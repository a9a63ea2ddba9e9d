#include "motion/style_profile.h"

#include <cmath>

namespace mien::motion {

namespace {

/// Departures from the ordinary walk, in units of a clearly visible change.
struct Cues {
  double speed;      ///< per 0.35 m/s
  double cadence;    ///< per 14 steps/min
  double step;       ///< longer, per 0.15 m
  double width;      ///< feet apart, per 0.06 m
  double arm_swing;  ///< wider, per 18°
  double elbow;      ///< more flexed, per 20°
  double spread;     ///< arms away from the trunk, per 7°
  double upright;    ///< trunk and chest, per 10°
  double head_up;    ///< head and neck, per 14°
  double shrug;      ///< shoulders up and forward, per 10°
  double bounce;     ///< against what the step length asks for, per half of that
  double sway;       ///< pelvis, trunk and head sideways, per 0.02 m and 2.5°
  double turn;       ///< pelvis against shoulders, per 6°
  double crouch;     ///< knees in stance, per 8°
  double footwork;   ///< heel strike and clearance, per 10° and 0.02 m
  double sharpness;  ///< per 0.6
  double impact;     ///< per 0.012 m
};

Cues cues_of(const WalkStyle& style) {
  const WalkStyle n;
  const double natural = natural_bounce_m(step_length_m(style));
  const double lean = style.trunk_lean_deg - n.trunk_lean_deg;
  const double nod = style.head_pitch_deg - n.head_pitch_deg;
  const double neck = style.neck_flexion_deg - n.neck_flexion_deg;
  Cues c;
  c.speed = (style.speed_m_s - n.speed_m_s) / 0.35;
  c.cadence = (style.cadence_steps_min - n.cadence_steps_min) / 14.0;
  c.step = (step_length_m(style) - step_length_m(n)) / 0.15;
  c.width = (style.step_width_m - n.step_width_m) / 0.06;
  c.arm_swing = (style.arm_swing_deg - n.arm_swing_deg) / 18.0;
  c.elbow = (style.elbow_flexion_deg - n.elbow_flexion_deg) / 20.0;
  c.spread = (style.arm_abduction_deg - n.arm_abduction_deg) / 7.0;
  c.upright = -(0.5 * lean + style.chest_flexion_deg - n.chest_flexion_deg) / 10.0;
  c.head_up = -(nod + 0.5 * neck) / 14.0;
  c.shrug = (style.shoulder_elevation_deg - n.shoulder_elevation_deg +
             0.5 * (style.shoulder_protraction_deg - n.shoulder_protraction_deg)) /
            10.0;
  c.bounce = (style.bounce_m - natural) / (0.5 * natural);
  c.sway = (style.sway_m - n.sway_m) / 0.02 + (style.trunk_sway_deg - n.trunk_sway_deg) / 2.5 +
           (style.head_sway_deg - n.head_sway_deg) / 2.5;
  c.turn = (style.pelvis_rotation_deg + style.trunk_rotation_deg - n.pelvis_rotation_deg -
            n.trunk_rotation_deg) /
           6.0;
  c.crouch = (style.stance_knee_deg - n.stance_knee_deg) / 8.0;
  c.footwork = (style.heel_strike_deg - n.heel_strike_deg) / 10.0 +
               (style.foot_clearance_m - n.foot_clearance_m) / 0.02;
  c.sharpness = style.sharpness / 0.6;
  c.impact = style.impact_m / 0.012;
  return c;
}

}  // namespace

StyleProfile profile(const WalkStyle& style) {
  const Cues c = cues_of(style);
  StyleProfile sums{};
  sums[Quickness] = 0.55 * c.speed + 0.30 * c.cadence + 0.15 * c.sharpness;
  sums[Clearness] = 0.35 * c.upright + 0.25 * c.head_up + 0.15 * c.footwork + 0.10 * c.step -
                    0.20 * c.crouch - 0.15 * c.shrug - 0.15 * c.sway - 0.15 * c.impact;
  sums[Activeness] =
      0.35 * c.arm_swing + 0.25 * c.bounce + 0.20 * c.turn + 0.20 * c.speed + 0.15 * c.head_up;
  sums[Largeness] = 0.30 * c.step + 0.25 * c.arm_swing + 0.25 * c.spread + 0.20 * c.width +
                    0.20 * c.upright + 0.10 * c.head_up - 0.15 * c.shrug;
  sums[Valence] = 0.30 * c.upright + 0.25 * c.head_up + 0.30 * c.bounce + 0.15 * c.arm_swing -
                  0.30 * c.shrug - 0.20 * c.sharpness - 0.25 * c.impact;
  sums[Arousal] =
      0.35 * c.speed + 0.20 * c.cadence + 0.20 * c.elbow + 0.15 * c.arm_swing + 0.15 * c.sharpness;
  sums[Tension] =
      0.35 * c.shrug + 0.35 * c.elbow + 0.35 * c.sharpness + 0.10 * c.crouch - 0.10 * c.sway;
  sums[Stability] = 0.20 * c.width - 0.40 * c.sway - 0.20 * c.crouch - 0.15 * c.shrug +
                    0.15 * c.upright + 0.10 * c.footwork;
  StyleProfile result{};
  for (size_t i = 0; i < sums.size(); ++i) result[i] = std::tanh(sums[i]);
  return result;
}

}  // namespace mien::motion
