#pragma once

#include <array>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// Simple measures of a motion, used for motions without ratings.
struct MotionMeasures {
  double speed_m_s = 0.0;          ///< of the pelvis over the floor
  double tempo_hz = 0.0;           ///< cycles per second; without a loop, 1 / duration
  double travel_m = 0.0;           ///< horizontal travel per cycle
  double hand_range_m = 0.0;       ///< extent of a hand's path relative to the pelvis, mean of both
  double hand_speed_m_s = 0.0;     ///< relative to the pelvis, mean of both
  double hand_spread_m = 0.0;      ///< mean distance between the hands
  double elbow_flexion_rad = 0.0;  ///< mean over time and of both elbows
  double trunk_lean_rad = 0.0;     ///< of the line pelvis–neck, forward from the vertical; mean
  double head_pitch_rad = 0.0;     ///< of the line neck–head joint, likewise
  double trunk_turn_rad = 0.0;     ///< range of axial rotation of the shoulder line
  double least_knee_rad = 0.0;     ///< least knee flexion, mean of both knees; large when crouching
  double bounce_m = 0.0;           ///< vertical range of the pelvis
  double sway_m = 0.0;             ///< lateral range of the pelvis
  double lift_share = 0.0;         ///< bounce / (bounce + sway); ½ if the pelvis does not move
  double asymmetry_m = 0.0;        ///< difference between the extents of the two ankles' paths
};

inline constexpr int motion_measure_count = 15;

/// The measures in the order of the struct.
std::array<double, motion_measure_count> values_of(const MotionMeasures& measures);

/// Measures one cycle of a travelling loop, or the whole of any other motion. Directions assume
/// travel along +Z (`straightened`, straighten.h).
MotionMeasures measure(const Example& example);

}  // namespace mien::motion
