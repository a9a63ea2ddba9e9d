#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A spatial quantity of a pose that can be read and set. Hand positions are relative to the
/// midpoint between the shoulders, in the chest's frame.
enum class DriveQuantity {
  left_hand_forward,   ///< metres
  left_hand_side,      ///< metres outwards from the midline
  left_hand_height,    ///< metres
  left_hand_distance,  ///< metres from the midpoint between the shoulders
  right_hand_forward,
  right_hand_side,
  right_hand_height,
  right_hand_distance,
  torso_bend,     ///< radians, total forward flexion of spine and chest
  head_bend,      ///< radians, total forward flexion of neck and head
  pelvis_height,  ///< metres above the floor; setting it does not move the ankles
};

inline constexpr int drive_quantity_count = 11;

/// The name in manifests and tables: "left-hand-forward", …
std::string_view name_of(DriveQuantity quantity);

/// Values of the quantity, frame by frame.
std::vector<double> quantity_of(const Clip& clip, DriveQuantity quantity);

/// Regression of a quantity y on a quantity x: y ≈ slope·x + intercept by least squares.
struct Drive {
  double slope = 0.0;
  double intercept = 0.0;
  double r_squared = 0.0;  ///< explained share of y's variance; 0 if x or y does not vary
};

Drive drive_between(const std::vector<double>& x, const std::vector<double>& y);

/// Edit of a quantity y: y' = scale·y + shift. The quantities in `correlated` also change: by
/// the change of y times the slope of their regression on y in the motion.
struct DriveEdit {
  DriveQuantity quantity = DriveQuantity::left_hand_distance;
  double scale = 1.0;
  double shift = 0.0;  ///< metres or radians
  std::vector<DriveQuantity> correlated;
};

struct DriveOptions {
  double amount = 1.0;  ///< factor of `scale` − 1 and of `shift`
};

/// Editing by drives and correlations (Neff and Kim 2009). Edits are applied in order. Positions of
/// the hands and the height of the pelvis are set by two-bone inverse kinematics of arms and legs,
/// which keeps the world orientation of hands and feet. A position out of the limb's reach is
/// approached as far as possible. Bone lengths are kept.
Clip driven(const Clip& motion, const std::vector<DriveEdit>& edits,
            const DriveOptions& options = {});

/// The edits that bring the neutral motion's hands (forward, side, height), torso, head and pelvis
/// to those of the styled motion, from the regression of each styled quantity on the neutral one at
/// the same normalized time of the cycle or clip.
std::vector<DriveEdit> drives_towards(const Clip& neutral, const Clip& styled);

}  // namespace mien::motion
