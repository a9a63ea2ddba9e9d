#pragma once

namespace mien::motion {

/// Thresholds of a check: values above `warning` are suspicious, above `error` broken.
struct Levels {
  double warning = 0.0;
  double error = 0.0;
};

/// Thresholds of the checks. Lengths hold for a stature of 1.75 m and scale with the body.
struct LintOptions {
  double body_mass_kg = 70.0;

  // The data itself.
  Levels unit_error = {1e-6, 1e-3};    ///< | |q| − 1 |
  Levels bone_drift = {0.001, 0.01};   ///< share of the bone's usual length
  Levels jump_degrees = {20.0, 30.0};  ///< a step beyond the mean of its two neighbours; at less
                                       ///< than 30 frames a second by so much more
  Levels jump_metres = {0.05, 0.1};    ///< the same for the root
  Levels seam_degrees = {3.0, 8.0};    ///< at a loop's seam, beyond the steps elsewhere
  Levels seam_metres = {0.01, 0.03};   ///< the same for the root

  // The body.
  Levels beyond_limit_degrees = {5.0, 15.0};  ///< beyond a joint's range (joint_angles.h)
  Levels intersection_metres = {0.02, 0.06};  ///< depth of two parts of the body in each other
  double intersection_seconds = 0.1;          ///< shorter contacts are ignored
  Levels leg_speed = {15.0, 25.0};            ///< rad/s
  Levels arm_speed = {25.0, 40.0};            ///< rad/s; trunk and head too
  Levels jerk_ratio = {5.0, 20.0};            ///< of hands, feet and head, by the original's

  // The feet.
  Levels skate_metres = {0.02, 0.05};           ///< drift of a foot while it bears the body
  Levels penetration_metres = {0.01, 0.03};     ///< of the sole below the floor
  Levels floating_metres = {0.03, 0.04};        ///< of the lower sole, of a body that does not fall
  Levels contact_shift_seconds = {0.07, 0.15};  ///< against the original
  Levels phase_shift_seconds = {0.1, 0.25};     ///< of a limb against the original
  Levels dissimilarity = {0.6, 0.9};  ///< 1 − correlation of a limb with the original at any shift

  // Balance and forces.
  Levels standing_margin_metres = {0.0, 0.05};  ///< centre of mass outside the support, standing
  Levels lateral_margin_metres = {0.05, 0.15};  ///< extrapolated centre of mass outside, walking
  Levels pressure_margin_metres = {0.2, 0.6};   ///< zero-moment point outside the support
  Levels press = {2.0, 4.0};                    ///< of the feet on the floor, body weights
  Levels pull = {0.3, 1.0};                     ///< of planted feet on the floor, body weights
  Levels friction = {0.5, 1.5};                 ///< horizontal by vertical force
  Levels torque_ratio = {1.0, 2.0};             ///< by what a joint can do (inverse_dynamics.h)
};

}  // namespace mien::motion
