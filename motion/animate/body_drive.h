#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A movement of a limb: the place of the middle of a hand in the frame of the body (body_end.h),
/// metres; `side` is away from the body.
enum class LimbMovement {
  left_hand_forward,
  left_hand_side,
  left_hand_height,
  right_hand_forward,
  right_hand_side,
  right_hand_height,
};

/// A movement of the body that may drive a limb.
enum class BodyMovement {
  pelvis_height,       ///< metres
  pelvis_side,         ///< metres to the left of the middle between the feet
  spine_flexion,       ///< radians forward, of spine and chest together
  spine_lateral,       ///< radians to the left
  spine_turn,          ///< radians to the left
  left_foot_forward,   ///< metres in front of the pelvis
  right_foot_forward,  ///< metres in front of the pelvis
};

inline constexpr int limb_movement_count = 6;
inline constexpr int body_movement_count = 7;

/// A relation between the movements of a limb and of the body in a motion: the limb's is slope ·
/// the body's + intercept, by least squares (drives and correlations, Neff and Kim 2009).
struct FoundDrive {
  LimbMovement limb = LimbMovement::left_hand_forward;
  BodyMovement body = BodyMovement::pelvis_height;
  double correlation = 0.0;  ///< −1 … 1
  double slope = 0.0;        ///< metres per metre or per radian
  double limb_range = 0.0;   ///< metres between the extremes of the limb's movement
};

/// The values of a movement, frame by frame.
std::vector<double> movement_of(const Clip& clip, LimbMovement limb);
std::vector<double> movement_of(const Clip& clip, BodyMovement body);

/// For each movement of a limb of at least 2 cm, the movement of the body with which it correlates
/// most, if the correlation is 0.5 or more; the strongest first.
std::vector<FoundDrive> drives_of(const Clip& clip);

/// An edit of a drive: the part of the limb's movement that follows the body's becomes `scale`
/// times as large about its mean, and the limb's movement is shifted.
struct DriveEditing {
  LimbMovement limb = LimbMovement::left_hand_forward;
  BodyMovement body = BodyMovement::pelvis_height;
  double scale = 1.0;
  double shift = 0.0;  ///< metres
};

/// The motion with edited drives, in their order; arms follow by inverse kinematics. A loop stays a
/// loop.
Clip with_drives(const Clip& clip, const std::vector<DriveEditing>& edits);

}  // namespace mien::motion
