#pragma once

#include <string>
#include <vector>

#include "motion/modify/modification.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// What the value of a dimension is.
enum class ModificationValue {
  strength,      ///< of a modification
  rotation,      ///< of a unit of posture, degrees
  paths,         ///< Modification::paths
  acceleration,  ///< Modification::acceleration
  tempo,         ///< Modification::tempo
};

/// A dimension in which a motion is modified.
struct ModificationDimension {
  std::string name;
  ModificationValue value = ModificationValue::strength;
  Modification recipe;  ///< of a strength: the modification at a strength of 1
  PostureUnit unit = PostureUnit::head_flexion;  ///< of a rotation
  double low = 0.0, high = 1.0;                  ///< limits of the values
};

/// One motion that is modified in some dimensions.
struct LiveModification {
  std::string original;  ///< name of an example
  std::vector<ModificationDimension> dimensions;

  bool empty() const { return dimensions.empty(); }
};

/// The value that changes nothing.
double neutral_value(ModificationValue value);

/// The motion at a point, which has a value for each dimension: modified by each strength above 0
/// in turn, then by everything else together. The same as a stimulus with these steps of `modify:`.
/// Throws Error as `modify` does.
Example modified_at(const Example& original, const LiveModification& by,
                    const std::vector<double>& point);

/// Lists the members of a modification for bytes.h, except a pose_difference, which it must not
/// have.
template <class Bytes, class M>
void modification_parts(Bytes& bytes, M& modification) {
  bytes.number(modification.paths);
  bytes.maybe(modification.gains, [&](auto& gains) {
    bytes.number(gains.low);
    bytes.number(gains.middle);
    bytes.number(gains.high);
    bytes.numbers(gains.bands);
  });
  bytes.choice(modification.signal, 2);
  bytes.number(modification.acceleration);
  bytes.choice(modification.acceleration_place, 3);
  for (auto* limb :
       {&modification.limbs.head, &modification.limbs.left_hand, &modification.limbs.right_hand,
        &modification.limbs.left_foot, &modification.limbs.right_foot})
    bytes.flag(*limb);
  bytes.list(modification.posture, 12, [&](auto& change) {
    bytes.choice(change.unit, static_cast<int>(posture_units().size()));
    bytes.number(change.degrees);
  });
  bytes.number(modification.gesture.height);
  bytes.number(modification.gesture.width);
  bytes.number(modification.gesture.speed);
  bytes.whole(modification.gesture.repetitions);
  auto& relative = modification.relative;
  for (auto* factor : {&relative.step_width, &relative.step_length, &relative.sway,
                       &relative.arm_swing, &relative.trunk_swing})
    bytes.number(*factor);
  bytes.list(relative.range, 12, [&](auto& share) {
    bytes.choice(share.unit, static_cast<int>(posture_units().size()));
    bytes.number(share.share);
  });
  bytes.number(modification.tempo.factor);
  bytes.list(modification.tempo.curve, 16, [&](auto& point) {
    bytes.number(point.share);
    bytes.number(point.factor);
  });
  bytes.choice(modification.gravity, 2);
  auto& stiffness = modification.stiffness;
  for (auto* part : {&stiffness.head, &stiffness.trunk, &stiffness.left_arm, &stiffness.right_arm,
                     &stiffness.legs})
    bytes.number(*part);
  bytes.number(modification.weight);
  bytes.number(modification.variation);
  bytes.seed(modification.seed);
  bytes.choice(modification.repair, 3);
  bytes.flag(modification.soft_joint_limits);
}

}  // namespace mien::motion
