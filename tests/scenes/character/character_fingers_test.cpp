#include "scenes/character/character_fingers.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "scenes/bent_fingers.h"
#include "scenes/character/character.h"
#include "scenes/skinned_gltf.h"

namespace mien::scenes {
namespace {

using motion::Finger;
using motion::Quat;
using motion::Vec3;
using test::FingerNaming;

const motion::Skeleton body = motion::standard_body();

struct Spelling {
  const char* name;
  std::vector<std::string> (*names)();
  FingerNaming fingers;
};

const Spelling spellings[] = {{"Mixamo", test::mixamo_names, FingerNaming::mixamo},
                              {"VRM", test::vrm_names, FingerNaming::vrm},
                              {"SMPL-X", test::smpl_names, FingerNaming::smpl}};

/// The body of a figure with fingers in a pose of the body's.
motion::Pose bind_with(std::vector<Quat> fingers) {
  motion::Pose pose;
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  pose.fingers = std::move(fingers);
  return pose;
}

std::vector<Quat> straight() {
  return test::bent_fingers([](int) { return 0.0; });
}

/// A character of the body's size whose bind pose this is.
Character character_of(const Spelling& spelling, const motion::Pose& bind, bool z_up = false) {
  test::SkinnedGltfOptions options;
  options.bind = motion::with_fingers(bind);
  options.names = test::with_finger_names(spelling.names(), spelling.fingers);
  options.z_up = z_up;
  const std::string file = test::skinned_gltf(motion::with_fingers(body), options).text();
  return scaled_to_body(parse_character(file, "figure.gltf"), body);
}

/// Joints of a character by their numbers on the body with fingers.
struct JointsByName {
  const Character& character;
  std::vector<std::string> names;

  JointsByName(const Character& of, const Spelling& spelling)
      : character(of), names(test::with_finger_names(spelling.names(), spelling.fingers)) {}

  std::size_t operator()(int joint) const {
    const int found = motion::find_joint(character.rig, names[static_cast<std::size_t>(joint)]);
    EXPECT_GE(found, 0);
    return static_cast<std::size_t>(std::max(found, 0));
  }
};

int wrist_of(bool left) { return left ? motion::LeftWrist : motion::RightWrist; }

/// A pose of the whole body with these fingers.
motion::Pose moved_pose(std::vector<Quat> fingers) {
  motion::Pose pose = bind_with(std::move(fingers));
  pose.root_position = Vec3(0.3, 0.9, -0.2);
  pose.rotations[motion::Pelvis] = motion::exp(Vec3(0.1, 0.7, 0.05));
  pose.rotations[motion::LeftShoulder] = motion::exp(Vec3(0.2, -0.3, -0.9));
  pose.rotations[motion::RightElbow] = motion::exp(Vec3(0.0, 1.2, 0.1));
  pose.rotations[motion::LeftWrist] = motion::exp(Vec3(0.6, 0.2, -0.3));
  return pose;
}

/// Largest distance, over all finger joints, of where they are from their wrist in the character
/// and on the canonical hand.
double farthest_apart(const Character& character, const Spelling& spelling,
                      const motion::Pose& pose) {
  const JointsByName rig_joint(character, spelling);
  const motion::JointTransforms rig = rig_pose(character, pose);
  const motion::JointTransforms hands =
      motion::world_transforms(motion::with_fingers(body), motion::with_fingers(pose));
  double farthest = 0.0;
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const int j = motion::body_joint_count + joint;
    const int wrist = wrist_of(motion::is_left_finger(joint));
    const Vec3 apart = (rig.positions[rig_joint(j)] - rig.positions[rig_joint(wrist)]) -
                       (hands.positions[static_cast<std::size_t>(j)] -
                        hands.positions[static_cast<std::size_t>(wrist)]);
    farthest = std::max(farthest, apart.norm());
  }
  return farthest;
}

TEST(ACharactersFingers, FollowTheCanonicalHandInEverySpelling) {
  for (const Spelling& spelling : spellings) {
    SCOPED_TRACE(spelling.name);
    for (const bool z_up : {false, true}) {
      const Character character = character_of(spelling, bind_with(straight()), z_up);
      for (std::uint32_t seed = 1; seed <= 3; ++seed)
        EXPECT_LT(farthest_apart(character, spelling, moved_pose(test::random_fingers(seed))), 1e-4)
            << z_up;
    }
  }
}

TEST(ACharactersFingers, CountTheBendOfTheirBindPose) {
  const std::vector<Quat> bent =
      test::bent_fingers([](int joint) { return motion::segment_of(joint) < 2 ? 13.0 : 0.0; });
  for (const Spelling& spelling : spellings) {
    SCOPED_TRACE(spelling.name);
    const Character character = character_of(spelling, bind_with(bent));
    // As bent as they were modelled, they are as modelled.
    const motion::JointTransforms same = rig_pose(character, bind_with(bent));
    for (const Quat& rotation : same.rotations)
      EXPECT_LT(motion::angle_between(rotation, Quat::Identity()), 1e-3);
    EXPECT_LT(farthest_apart(character, spelling, moved_pose(test::random_fingers(7))), 1e-3);
    EXPECT_LT(farthest_apart(character, spelling, moved_pose(straight())), 1e-3);
  }
}

TEST(ACharactersFingers, BendTowardsItsPalmHoweverTheHandWasModelled) {
  // Palms that look forward in the bind pose: hands turned about the forearm.
  motion::Pose bind = bind_with(straight());
  bind.rotations[motion::LeftWrist] = motion::exp(Vec3(-0.5 * motion::pi, 0, 0));
  bind.rotations[motion::RightWrist] = motion::exp(Vec3(-0.5 * motion::pi, 0, 0));
  const Character character = character_of(spellings[0], bind);
  const motion::Pose fist = bind_with(test::bent_fingers([](int) { return 60.0; }));
  const motion::JointTransforms rig = rig_pose(character, fist);
  const JointsByName rig_joint(character, spellings[0]);
  for (const bool left : {true, false}) {
    const auto at = [&](Finger finger, int segment) -> const Vec3& {
      return rig.positions[rig_joint(motion::body_joint_count +
                                     motion::finger_joint(left, finger, segment))];
    };
    const Vec3 along = at(Finger::middle, 0) - rig.positions[rig_joint(wrist_of(left))];
    const Vec3 to_thumb = at(Finger::index, 0) - at(Finger::little, 0);
    const Vec3 out_of_palm = left ? Vec3(along.cross(to_thumb)) : Vec3(to_thumb.cross(along));
    for (const Finger finger : {Finger::index, Finger::middle, Finger::ring, Finger::little}) {
      EXPECT_GT((at(finger, 2) - at(finger, 0)).dot(out_of_palm.normalized()), 0.02);
    }
  }
}

TEST(ACharactersFingers, CarryWhatHangsOnThem) {
  motion::Skeleton rig = motion::with_fingers(body);
  test::SkinnedGltfOptions options;
  options.names = test::with_finger_names(test::mixamo_names(), FingerNaming::mixamo);
  const int last = motion::body_joint_count + motion::finger_joint(true, Finger::index, 2);
  const Vec3 tip = *rig.joints[static_cast<std::size_t>(last)].tip;
  rig.joints.push_back({.name = "end", .parent = last, .offset = tip, .tip = Vec3(0.01, 0, 0)});
  options.names.emplace_back("mixamorig:LeftHandIndex4");
  const Character character =
      scaled_to_body(parse_character(test::skinned_gltf(rig, options).text(), "figure.gltf"), body);
  const motion::Pose pose = moved_pose(test::random_fingers(5));
  const motion::JointTransforms posed_rig = rig_pose(character, pose);
  const motion::JointTransforms hands =
      motion::world_transforms(motion::with_fingers(body), motion::with_fingers(pose));
  const auto at = [&](const char* name) {
    return posed_rig.positions[static_cast<std::size_t>(motion::find_joint(character.rig, name))];
  };
  const auto j = static_cast<std::size_t>(last);
  const Vec3 wanted = hands.positions[j] + hands.rotations[j] * tip -
                      hands.positions[static_cast<std::size_t>(motion::LeftWrist)];
  EXPECT_LT((at("mixamorig:LeftHandIndex4") - at("mixamorig:LeftHand") - wanted).norm(), 1e-4);
}

TEST(ACharactersFingers, StayAsModelledWithoutThoseOfAMotion) {
  const Character character = character_of(spellings[1], bind_with(test::random_fingers(3)));
  const motion::Pose pose = moved_pose({});
  const motion::JointTransforms rig = rig_pose(character, pose);
  const JointsByName rig_joint(character, spellings[1]);
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    const Quat& finger = rig.rotations[rig_joint(motion::body_joint_count + joint)];
    const Quat& wrist = rig.rotations[rig_joint(wrist_of(motion::is_left_finger(joint)))];
    EXPECT_LT(motion::angle_between(finger, wrist), 1e-6);
  }
}

TEST(ACharactersFingers, MoveItsMesh) {
  const Character character = character_of(spellings[0], bind_with(straight()));
  const auto moved = [&](std::vector<Quat> fingers) {
    const auto open = posed(character, moved_pose(straight()));
    const auto bent = posed(character, moved_pose(std::move(fingers)));
    int count = 0;
    for (std::size_t m = 0; m < open.size(); ++m) {
      for (std::size_t v = 0; v < open[m].positions.size(); ++v)
        count += (open[m].positions[v] - bent[m].positions[v]).norm() > 0.003f ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(moved(straight()), 0);
  // Eight corners of each box, of which those at a joint hardly move.
  EXPECT_GT(moved(test::bent_fingers([](int) { return 50.0; })), motion::finger_joint_count * 4);
}

}  // namespace
}  // namespace mien::scenes
