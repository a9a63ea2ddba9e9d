#include "motion/procedural/walk_style.h"

#include <algorithm>

namespace mien::motion {

double step_length_m(const WalkStyle& style) {
  return style.speed_m_s * 60.0 / style.cadence_steps_min;
}

double natural_bounce_m(double step_length) {
  const WalkStyle normal;
  const double ratio = step_length / step_length_m(normal);
  return normal.bounce_m * ratio * ratio;
}

WalkStyle ordinary_walk(double speed_m_s, double cadence_steps_min) {
  const WalkStyle normal;
  WalkStyle style;
  style.speed_m_s = speed_m_s;
  style.cadence_steps_min = cadence_steps_min;
  const double step = step_length_m(style);
  const double longer = step / step_length_m(normal) - 1.0;
  const double faster = speed_m_s / normal.speed_m_s - 1.0;
  style.stance_share = std::clamp(normal.stance_share - 0.09 * faster, 0.56, 0.70);
  style.heel_rise_share = normal.heel_rise_share * style.stance_share / normal.stance_share;
  style.heel_strike_deg = std::max(0.0, normal.heel_strike_deg * (1.0 + 0.6 * longer));
  style.toe_off_deg = normal.toe_off_deg * (1.0 + 0.45 * longer);
  style.swing_knee_deg = normal.swing_knee_deg * (1.0 + 0.10 * faster);
  style.bounce_m = natural_bounce_m(step);
  style.pelvis_rotation_deg = normal.pelvis_rotation_deg * (1.0 + longer);
  style.arm_swing_deg = std::max(4.0, normal.arm_swing_deg * (1.0 + 0.8 * faster));
  style.elbow_swing_deg = std::max(2.0, normal.elbow_swing_deg * (1.0 + faster));
  style.elbow_flexion_deg = normal.elbow_flexion_deg * (1.0 + 0.4 * faster);
  return style;
}

}  // namespace mien::motion
