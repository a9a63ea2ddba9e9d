#pragma once

#include <array>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// Simple measures of a motion, for motions without ratings.
struct MotionMeasures {
  double speed_m_s = 0.0;          ///< of the pelvis over the floor
  double tempo_hz = 0.0;           ///< cycles (or performances) a second
  double travel_m = 0.0;           ///< over the floor, a cycle
  double hand_range_m = 0.0;       ///< extent of the hands' ways relative to the pelvis, mean
  double hand_speed_m_s = 0.0;     ///< relative to the pelvis, mean of both
  double hand_spread_m = 0.0;      ///< between the hands, mean
  double elbow_flexion_rad = 0.0;  ///< mean of both
  double trunk_lean_rad = 0.0;     ///< pelvis to neck, from the vertical, forward; mean
  double head_pitch_rad = 0.0;     ///< neck to head's top, from the vertical, forward; mean
  double trunk_turn_rad = 0.0;     ///< range of the shoulders' line about the vertical
  double least_knee_rad = 0.0;     ///< least flexion of a knee, mean of both: crouching
  double bounce_m = 0.0;           ///< vertical range of the pelvis
  double sway_m = 0.0;             ///< lateral range of the pelvis
  double lift_share = 0.0;         ///< bounce / (bounce + sway); ½ when the pelvis rests
  double asymmetry_m = 0.0;        ///< between the ranges of the left and right ankle
};

inline constexpr int motion_measure_count = 15;

/// The measures in the order of the struct.
std::array<double, motion_measure_count> values_of(const MotionMeasures& measures);

/// Measures one cycle of a travelling loop, or a whole performance.
MotionMeasures measure(const Example& example);

}  // namespace mien::motion
