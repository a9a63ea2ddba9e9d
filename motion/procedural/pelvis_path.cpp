#include "motion/procedural/pelvis_path.h"

#include <cmath>

#include "motion/procedural/walk_curves.h"

namespace mien::motion {

namespace {

constexpr double top = 0.285;           // phase of the highest point, in left single support
constexpr double fastest = 0.08;        // phase of the greatest forward speed
constexpr double surge = 0.04;          // amplitude of the forward speed, of its mean
constexpr double leftmost = 0.30;       // phase
constexpr double tilt_amplitude = 1.0;  // degrees, twice a cycle

/// A dip of depth 1 in each loading response, otherwise near 0: a raised cosine to the fourth
/// power.
double loading_dip(double phase) {
  constexpr double deepest = 0.12;
  const double raised = 0.5 + 0.5 * wave(2, phase, deepest);
  return raised * raised;
}

}  // namespace

Vec3 pelvis_position(const PelvisPath& path, double phase) {
  const double surge_length = surge * path.stride_m / (4.0 * pi);
  return {0.5 * path.style.sway_m * wave(1, phase, leftmost),
          path.mean_height_m +
              0.5 * path.style.bounce_m * (wave(2, phase, top) + 0.14 * wave(4, phase, 0.14)) -
              path.style.impact_m * loading_dip(phase),
          path.stride_m * phase + surge_length * std::sin(4.0 * pi * (phase - fastest))};
}

Quat pelvis_rotation(const PelvisPath& path, double phase) {
  const double yaw = -path.style.pelvis_rotation_deg * pelvis_rotation_shape(phase);
  const double obliquity = path.style.pelvis_obliquity_deg * pelvis_obliquity_shape(phase);
  const double tilt = path.style.pelvis_tilt_deg + tilt_amplitude * wave(2, phase, 0.02);
  return Quat(Eigen::AngleAxisd(radians_per_degree * yaw, Vec3::UnitY()) *
              Eigen::AngleAxisd(radians_per_degree * obliquity, Vec3::UnitZ()) *
              Eigen::AngleAxisd(radians_per_degree * tilt, Vec3::UnitX()));
}

}  // namespace mien::motion
