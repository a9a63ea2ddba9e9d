#include "motion/modify/posture_units.h"

#include <cassert>

namespace mien::motion {

const std::vector<PostureUnitName>& posture_units() {
  using enum PostureUnit;
  static const std::vector<PostureUnitName> units = {
      {head_flexion, "head-flexion", "lowers the head, chin to the chest"},
      {head_lateral, "head-lateral", "tilts the head to the left shoulder"},
      {head_turn, "head-turn", "turns the face to the left"},
      {chest_flexion, "chest-flexion", "bends the chest forward"},
      {spine_flexion, "spine-flexion", "bends the whole back forward"},
      {spine_lateral, "spine-lateral", "bends the back to the left"},
      {spine_turn, "spine-turn", "turns the shoulders to the left"},
      {pelvis_tilt, "pelvis-tilt", "leans the pelvis and all above it forward"},
      {shoulder_elevation, "shoulder-elevation", "draws both shoulders up"},
      {shoulder_protraction, "shoulder-protraction", "draws both shoulders forward"},
      {shoulder_abduction, "shoulder-abduction", "spreads both upper arms from the body"},
      {shoulder_flexion, "shoulder-flexion", "lifts both upper arms forward"},
      {shoulder_internal_rotation, "shoulder-internal-rotation",
       "turns both upper arms inwards about their length"},
      {elbow_flexion, "elbow-flexion", "bends both elbows"},
      {wrist_flexion, "wrist-flexion", "bends both palms towards the forearms"},
      {hip_abduction, "hip-abduction", "spreads both thighs"},
      {hip_flexion, "hip-flexion", "lifts both thighs forward"},
      {hip_internal_rotation, "hip-internal-rotation", "turns both legs inwards, toes together"},
      {knee_flexion, "knee-flexion", "bends both knees"},
      {ankle_dorsiflexion, "ankle-dorsiflexion", "lifts the toes of both feet"},
  };
  return units;
}

std::string_view name_of(PostureUnit unit) {
  return posture_units()[static_cast<size_t>(unit)].name;
}

std::optional<PostureUnit> posture_unit(std::string_view name) {
  for (const PostureUnitName& unit : posture_units()) {
    if (unit.name == name) return unit.unit;
  }
  return std::nullopt;
}

std::vector<UnitTurn> turns_of(PostureUnit unit) {
  using enum PostureUnit;
  constexpr auto own = TurnFrame::own;
  constexpr auto parent = TurnFrame::parent;
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  // A turn of the upper joint in its own frame and of the lower in its parent's is one turn between
  // the two, shared out.
  const auto shared = [](BodyJoint upper, BodyJoint lower, const Vec3& axis) {
    return std::vector<UnitTurn>{{upper, 0.5 * axis, own}, {lower, 0.5 * axis, parent}};
  };
  const auto both_sides = [](BodyJoint left, const Vec3& axis, TurnFrame frame) {
    return std::vector<UnitTurn>{{left, axis, frame},
                                 {mirrored(left), Vec3(axis.x(), -axis.y(), -axis.z()), frame}};
  };
  switch (unit) {
    case head_flexion:
      return shared(Neck, Head, x);
    case head_lateral:
      return shared(Neck, Head, -z);
    case head_turn:
      return shared(Neck, Head, y);
    case chest_flexion:
      return {{Chest, x, own}};
    case spine_flexion:
      return shared(Spine, Chest, x);
    case spine_lateral:
      return shared(Spine, Chest, -z);
    case spine_turn:
      return shared(Spine, Chest, y);
    case pelvis_tilt:
      return {{Pelvis, x, own}, {LeftHip, -x, parent}, {RightHip, -x, parent}};
    case shoulder_elevation:
      return both_sides(LeftClavicle, z, parent);
    case shoulder_protraction:
      return both_sides(LeftClavicle, -y, parent);
    case shoulder_abduction:
      return both_sides(LeftShoulder, z, parent);
    case shoulder_flexion:
      return both_sides(LeftShoulder, -x, parent);
    case shoulder_internal_rotation:
      return both_sides(LeftShoulder, x, own);
    case elbow_flexion:
      return both_sides(LeftElbow, -y, own);
    case wrist_flexion:
      return both_sides(LeftWrist, -z, own);
    case hip_abduction:
      return both_sides(LeftHip, z, parent);
    case hip_flexion:
      return both_sides(LeftHip, -x, parent);
    case hip_internal_rotation:
      return both_sides(LeftHip, -y, own);
    case knee_flexion:
      return both_sides(LeftKnee, x, own);
    case ankle_dorsiflexion:
      return both_sides(LeftAnkle, -x, own);
  }
  assert(false);
  return {};
}

}  // namespace mien::motion
