#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A spatial quantity of a pose that can be read and set. Places of hands are relative to the
/// middle between the shoulders, in the frame of the chest.
enum class DriveQuantity {
  left_hand_forward,   ///< metres
  left_hand_side,      ///< metres away from the body's middle
  left_hand_height,    ///< metres
  left_hand_distance,  ///< metres from the middle between the shoulders
  right_hand_forward,
  right_hand_side,
  right_hand_height,
  right_hand_distance,
  torso_bend,     ///< radians, forward flexion of spine and chest together
  head_bend,      ///< radians, forward flexion of neck and head together
  pelvis_height,  ///< metres above the floor; the ankles stay where they are
};

inline constexpr int drive_quantity_count = 11;

/// The name in manifests and tables: "left-hand-forward", …
std::string_view name_of(DriveQuantity quantity);

/// Values of the quantity, frame by frame.
std::vector<double> quantity_of(const Clip& clip, DriveQuantity quantity);

/// Correlation of two quantities: y ≈ slope·x + intercept by least squares.
struct Drive {
  double slope = 0.0;
  double intercept = 0.0;
  double r_squared = 0.0;  ///< share of y's variance; 0 when x or y does not vary
};

Drive drive_between(const std::vector<double>& x, const std::vector<double>& y);

/// y' = scale·y + shift. With `correlated`, quantities move along by the slope with which they
/// follow y in the motion.
struct DriveEdit {
  DriveQuantity quantity = DriveQuantity::left_hand_distance;
  double scale = 1.0;
  double shift = 0.0;  ///< metres or radians
  std::vector<DriveQuantity> correlated;
};

struct DriveOptions {
  double amount = 1.0;  ///< of scale − 1 and of shift
};

/// Editing by drives and correlations (Neff and Kim 2009): edits in their order; hands and legs
/// follow by two-bone inverse kinematics, hands keep their orientation in the world and feet
/// theirs. A place beyond the limb's reach is approached. Bone lengths are kept.
Clip driven(const Clip& motion, const std::vector<DriveEdit>& edits,
            const DriveOptions& options = {});

/// The edits that take the neutral motion's hands (forward, side, height), torso, head and pelvis
/// to the styled one's at corresponding shares of the cycle or take: regression of the styled
/// quantity on the neutral one.
std::vector<DriveEdit> drives_towards(const Clip& neutral, const Clip& styled);

}  // namespace mien::motion
