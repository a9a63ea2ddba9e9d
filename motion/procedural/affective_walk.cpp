#include "motion/procedural/affective_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/math/geometry.h"

namespace mien::motion {

namespace {

Emotion at_angle(std::string_view name, double degrees) {
  const double angle = radians_per_degree * degrees;
  return {name, std::cos(angle), std::sin(angle)};
}

}  // namespace

std::vector<Emotion> circumplex_emotions() {
  return {at_angle("happy", 7.8),    at_angle("excited", 48.6),     at_angle("tense", 92.8),
          at_angle("afraid", 116.0), at_angle("frustrated", 141.1), at_angle("sad", 207.5),
          at_angle("bored", 241.9),  at_angle("tired", 267.7),      at_angle("calm", 316.2)};
}

WalkStyle affective_walk(double valence, double arousal) {
  const double v = valence;
  const double a = arousal;
  const double tension = std::max(a, 0.0) * 0.5 * (1.0 - v);
  const double weariness = std::max(-a, 0.0) * 0.5 * (1.0 - v);
  const double gloom = std::max(-v, 0.0);

  WalkStyle s = ordinary_walk(1.32 + 0.30 * a + 0.10 * v - 0.15 * tension, 111.0 + 12.0 * a);
  s.bounce_m *= 1.0 + 0.25 * v + 0.08 * a;
  s.heel_rise_share -= 0.03 * std::max(v, 0.0);
  s.sway_m += 0.020 * weariness + 0.012 * gloom - 0.012 * tension;
  s.step_width_m += 0.02 * weariness - 0.012 * tension;
  s.stance_knee_deg += 9.0 * tension + 5.0 * weariness;
  s.impact_m = 0.008 * tension + 0.008 * weariness;
  s.foot_clearance_m += 0.006 * v - 0.006 * weariness;
  s.foot_progression_deg += 3.0 * v - 3.0 * tension;

  s.trunk_lean_deg += -2.5 * v + 5.0 * tension + 4.0 * weariness;
  s.chest_flexion_deg += -5.0 * v - 1.5 * a + 4.0 * gloom + 4.0 * weariness;
  s.trunk_rotation_deg = std::max(2.0, s.trunk_rotation_deg * (1.0 + 0.45 * v + 0.30 * a));
  s.trunk_sway_deg += 2.5 * weariness;
  s.neck_flexion_deg += -6.0 * v + 5.0 * gloom + 10.0 * weariness + 6.0 * tension;
  s.head_pitch_deg += -7.0 * v - 3.0 * a + 8.0 * gloom + 10.0 * weariness - 6.0 * tension;
  s.head_sway_deg += 2.0 * std::max(v, 0.0) + 2.0 * weariness;

  s.shoulder_elevation_deg += 9.0 * tension - 5.0 * weariness;
  s.shoulder_protraction_deg += -5.0 * v + 5.0 * tension + 3.0 * weariness;
  s.arm_swing_deg = std::max(6.0, s.arm_swing_deg * (1.0 + 0.30 * v + 0.15 * a - 0.50 * tension));
  s.arm_flexion_deg += 3.0 * gloom + 4.0 * tension;
  s.arm_abduction_deg += 3.0 * v + 2.0 * tension;
  s.arm_rotation_deg += 14.0 * tension;
  s.elbow_flexion_deg = std::max(8.0, s.elbow_flexion_deg + 9.0 * a + 36.0 * tension);
  s.elbow_swing_deg = std::max(4.0, s.elbow_swing_deg * (1.0 + 0.25 * v - 0.30 * tension));
  s.arm_lag_share += 0.03 * std::max(-a, 0.0) - 0.02 * tension;
  s.sharpness = 0.6 * tension - 0.5 * std::max(-a, 0.0);
  return s;
}

WalkStyle at_pace(const WalkStyle& style, double factor) {
  const double share = std::sqrt(factor);
  const WalkStyle before = ordinary_walk(style.speed_m_s, style.cadence_steps_min);
  const WalkStyle after = ordinary_walk(style.speed_m_s * factor, style.cadence_steps_min * share);
  WalkStyle s = style;
  s.speed_m_s = after.speed_m_s;
  s.cadence_steps_min = after.cadence_steps_min;
  s.stance_share += after.stance_share - before.stance_share;
  for (double WalkStyle::*member :
       {&WalkStyle::heel_rise_share, &WalkStyle::heel_strike_deg, &WalkStyle::toe_off_deg,
        &WalkStyle::swing_knee_deg, &WalkStyle::bounce_m, &WalkStyle::pelvis_rotation_deg,
        &WalkStyle::arm_swing_deg, &WalkStyle::elbow_flexion_deg, &WalkStyle::elbow_swing_deg}) {
    s.*member *= after.*member / before.*member;
  }
  return s;
}

}  // namespace mien::motion
