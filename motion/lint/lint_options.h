#pragma once

namespace mien::motion {

/// Thresholds of a check: values above `warning` are suspicious, values above `error` are faults.
struct Levels {
  double warning = 0.0;
  double error = 0.0;
};

/// Thresholds of the checks. Lengths are for a stature of 1.75 m and scale with the body, except
/// those under "Data".
struct LintOptions {
  double body_mass_kg = 70.0;

  // Data.
  Levels unit_error = {1e-6, 1e-3};   ///< deviation of quaternion length from 1
  Levels bone_drift = {0.001, 0.01};  ///< change of bone length, as a fraction of the median length
  /// Deviation of a change per frame from the mean of its neighbours, less what fast movement
  /// explains. The thresholds are multiplied by 30 Hz / rate at frame rates below 30 Hz, and those
  /// of toes by 1.5.
  Levels jump_degrees = {20.0, 30.0};
  Levels jump_metres = {0.05, 0.1};  ///< the same for root positions
  Levels seam_degrees = {3.0, 8.0};  ///< deviation at a loop's seam, less twice the usual deviation
  Levels seam_metres = {0.01, 0.03};  ///< the same for root positions

  // Joints and body parts.
  /// Excess beyond the range of a joint (joint_angles.h).
  Levels beyond_limit_degrees = {5.0, 15.0};
  Levels intersection_metres = {0.02, 0.06};  ///< penetration depth of two parts of the body
  double intersection_seconds = 0.1;          ///< shorter intersections are ignored
  Levels leg_speed = {15.0, 25.0};            ///< rad/s, of leg joints
  Levels arm_speed = {25.0, 40.0};            ///< rad/s, of arms, trunk and head
  Levels jerk_ratio = {5.0, 20.0};  ///< jerk of hands, feet and head relative to the original

  // Hands, feet and head.
  /// Deviation of a change of position per frame from those before and after it and their mean,
  /// relative to the pelvis; multiplied by 30 Hz / rate at frame rates below 30 Hz.
  Levels limb_jump_metres = {0.02, 0.04};
  Levels jitter_metres = {0.002, 0.003};  ///< standard deviation of noise on each coordinate
  Levels lost_movement = {0.75, 0.95};    ///< share of the original's movement that is gone

  // Feet.
  Levels skate_metres = {0.02, 0.05};        ///< slip of a foot while it bears weight
  Levels penetration_metres = {0.01, 0.03};  ///< depth of the sole below the floor
  Levels floating_metres = {0.03, 0.04};     ///< height of the lower sole while not in free fall
  /// Time shift of a foot contact relative to the original.
  Levels contact_shift_seconds = {0.07, 0.15};
  Levels phase_shift_seconds = {0.1, 0.25};  ///< time shift of a limb relative to the original
  /// 1 − correlation of the motion of a limb with the original at the best time shift.
  Levels dissimilarity = {0.6, 0.9};

  // Balance and forces.
  /// Distance of the centre of mass outside the base of support, standing.
  Levels standing_margin_metres = {0.0, 0.05};
  /// Distance of the extrapolated centre of mass beyond the outer edge of the foot, walking.
  Levels lateral_margin_metres = {0.05, 0.15};
  /// Distance of the zero-moment point outside the base of support.
  Levels pressure_margin_metres = {0.2, 0.6};
  Levels press = {2.0, 4.0};         ///< vertical ground reaction force, body weights
  Levels pull = {0.3, 1.0};          ///< downward ground reaction force, body weights
  Levels friction = {0.5, 1.5};      ///< required friction coefficient: horizontal / vertical force
  Levels torque_ratio = {1.0, 2.0};  ///< joint torque / limit of the joint (inverse_dynamics.h)
};

}  // namespace mien::motion
