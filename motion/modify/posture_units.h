#pragma once

#include <vector>

#include "motion/modify/posture.h"

namespace mien::motion {

/// In which frame a joint is turned.
enum class TurnFrame {
  own,     ///< q' = q · turn
  parent,  ///< q' = turn · q
};

/// What a unit difference of posture does to one joint: so many radians about each axis for a
/// radian of the unit.
struct UnitTurn {
  BodyJoint joint;
  Vec3 turn;
  TurnFrame frame;
};

std::vector<UnitTurn> turns_of(PostureUnit unit);

}  // namespace mien::motion
