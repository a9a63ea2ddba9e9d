#include "motion/steered_walk/paced_style.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double standing_knee_deg = 4.0;  // least, of people who stand

double mixed(double at_zero, double at_one, double share) {
  return at_zero + (at_one - at_zero) * share;
}

}  // namespace

WalkStyle paced_style(const WalkStyle& style, double pace) {
  WalkStyle s = style;
  const double slower = std::max(0.0, 1.0 - pace);
  const double cadence = pace < 1.0 ? mixed(0.72, 1.0, pace) : std::pow(pace, 0.7);
  const double step = pace / cadence;
  s.cadence_steps_min *= cadence;
  s.speed_m_s = std::max(1e-3, style.speed_m_s * pace);
  s.stance_share = std::clamp(style.stance_share + 0.05 * (1.0 - pace), 0.56, 0.74);
  s.heel_rise_share =
      s.stance_share * mixed(0.74, style.heel_rise_share / style.stance_share, std::min(step, 1.0));
  s.step_width_m += (0.06 + 0.4 * std::max(0.0, 0.09 - style.step_width_m)) * slower * slower;
  s.foot_clearance_m += 0.015 * slower * slower;
  s.heel_strike_deg *= mixed(0.1, 1.0, step);
  s.toe_off_deg *= mixed(0.12, 1.0, step);
  s.swing_knee_deg *= mixed(0.7, 1.0, std::min(step, 1.0));
  s.bounce_m *= mixed(0.12, 1.0, step * step);
  s.impact_m *= mixed(0.2, 1.0, step);
  s.sway_m *= mixed(1.9, 1.0, pace);
  s.pelvis_rotation_deg *= mixed(0.1, 1.0, step);
  s.pelvis_obliquity_deg *= mixed(0.45, 1.0, step);
  s.trunk_rotation_deg *= mixed(0.15, 1.0, step);
  s.head_sway_deg *= mixed(0.3, 1.0, step);
  s.arm_swing_deg *= mixed(0.1, 1.0, pace);
  s.elbow_swing_deg *= mixed(0.1, 1.0, pace);
  s.wrist_swing_deg *= mixed(0.2, 1.0, pace);
  return s;
}

WalkStyle standing_style(const WalkStyle& style) {
  WalkStyle s = paced_style(style, 0.0);
  s.heel_strike_deg = 0.0;
  s.toe_off_deg = 0.0;
  s.stance_knee_deg = std::max(s.stance_knee_deg, standing_knee_deg);
  for (double WalkStyle::*movement :
       {&WalkStyle::bounce_m, &WalkStyle::impact_m, &WalkStyle::sway_m,
        &WalkStyle::pelvis_rotation_deg, &WalkStyle::pelvis_obliquity_deg,
        &WalkStyle::trunk_rotation_deg, &WalkStyle::trunk_sway_deg, &WalkStyle::head_sway_deg,
        &WalkStyle::arm_swing_deg, &WalkStyle::elbow_swing_deg, &WalkStyle::wrist_swing_deg}) {
    s.*movement = 0.0;
  }
  return s;
}

}  // namespace mien::motion
