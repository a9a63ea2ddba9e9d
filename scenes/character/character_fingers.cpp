#include "scenes/character/character_fingers.h"

namespace mien::scenes {

namespace {

using motion::Quat;

std::size_t side_of_finger(int joint) { return motion::is_left_finger(joint) ? 0 : 1; }

/// World rotations, from the bind pose, of the joints of the canonical hands that the rig has.
std::vector<Quat> turns_of_fingers(const CharacterFingers& hands,
                                   const motion::JointTransforms& pose,
                                   const std::vector<Quat>& fingers) {
  std::vector<Quat> turns(hands.joints.size(), Quat::Identity());
  Quat bent = Quat::Identity();  // from the canonical hand
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    bent = motion::segment_of(joint) == 0 ? fingers[j] : bent * fingers[j];
    if (hands.joints[j] < 0) continue;
    const std::size_t side = side_of_finger(joint);
    const Quat& hand = pose.rotations[static_cast<std::size_t>(hands.wrists[side])];
    turns[j] = (hand * hands.palms[side] * bent * hands.bind_rotations[j].conjugate()).normalized();
  }
  return turns;
}

}  // namespace

CharacterFingers character_fingers(const motion::BodyMapping& mapping) {
  CharacterFingers hands;
  hands.joints = mapping.hands.joints;
  hands.wrists = {mapping.joints[motion::LeftWrist].rotation(),
                  mapping.joints[motion::RightWrist].rotation()};
  for (std::size_t side = 0; side < hands.palms.size(); ++side)
    hands.palms[side] = (mapping.to_y_up * mapping.hands.palm[side]).normalized();
  for (std::size_t j = 0; j < hands.bind_rotations.size(); ++j)
    hands.bind_rotations[j] = (mapping.to_y_up * mapping.hands.calibration[j]).normalized();
  return hands;
}

void bend_fingers(const CharacterFingers& hands, const motion::Skeleton& rig,
                  const std::vector<Quat>& fingers, motion::JointTransforms& pose) {
  if (fingers.empty()) return;
  const std::vector<Quat> turns = turns_of_fingers(hands, pose, fingers);
  std::vector<int> finger_at(rig.joints.size(), -1);
  for (std::size_t f = 0; f < turns.size(); ++f) {
    if (hands.joints[f] >= 0)
      finger_at[static_cast<std::size_t>(hands.joints[f])] = static_cast<int>(f);
  }
  std::vector<bool> moves(rig.joints.size(), false);
  for (std::size_t j = 1; j < rig.joints.size(); ++j) {
    const auto parent = static_cast<std::size_t>(rig.joints[j].parent);
    moves[j] = finger_at[j] >= 0 || moves[parent];
    if (!moves[j]) continue;
    pose.positions[j] = pose.positions[parent] + pose.rotations[parent] * rig.joints[j].offset;
    pose.rotations[j] =
        finger_at[j] >= 0 ? turns[static_cast<std::size_t>(finger_at[j])] : pose.rotations[parent];
  }
}

}  // namespace mien::scenes
