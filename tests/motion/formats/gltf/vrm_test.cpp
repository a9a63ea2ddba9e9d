// VRM animations (.vrma) and characters (.vrm): glTF files that say which node is which bone.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/gltf/gltf.h"
#include "motion/gltf_text.h"
#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/text/file_kind.h"

#include "real_data.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// Of the canonical joints, in their order.
constexpr std::array<const char*, body_joint_count> bones = {
    "hips",          "spine",         "chest",         "neck",          "head",
    "leftShoulder",  "leftUpperArm",  "leftLowerArm",  "leftHand",      "rightShoulder",
    "rightUpperArm", "rightLowerArm", "rightHand",     "leftUpperLeg",  "leftLowerLeg",
    "leftFoot",      "leftToes",      "rightUpperLeg", "rightLowerLeg", "rightFoot",
    "rightToes"};

std::string three(const Vec3& v) {
  return "[" + std::to_string(v.x()) + "," + std::to_string(v.y()) + "," + std::to_string(v.z()) +
         "]";
}

/// The body's joints as nodes, each called as the joint on the other side, then a node of hair on
/// the head.
std::string nodes_of(const Skeleton& body, const Quat& facing) {
  const auto children = children_of(body);
  std::string text = "\"nodes\":[";
  for (int j = 0; j < body_joint_count; ++j) {
    text += "{\"name\":\"" + std::string(name_of(mirrored(BodyJoint(j)))) +
            "\",\"translation\":" + three(facing * body.joints[static_cast<size_t>(j)].offset);
    std::string below;
    for (const int child : children[static_cast<size_t>(j)])
      below += (below.empty() ? "" : ",") + std::to_string(child);
    if (j == Head) below = std::to_string(body_joint_count);
    text += (below.empty() ? "" : ",\"children\":[" + below + "]") + "},";
  }
  text += R"({"name":"LeftArm","translation":[0,0.1,-0.1]}],"skins":[{"joints":[)";
  for (int j = 0; j < body_joint_count; ++j) text += std::to_string(j) + ",";
  return text + std::to_string(body_joint_count) + "]}]";
}

/// `humanBones` of VRM 1.0 and of animations.
std::string named_bones() {
  std::string text;
  for (size_t j = 0; j < bones.size(); ++j)
    text +=
        (j == 0 ? "\"" : ",\"") + std::string(bones[j]) + "\":{\"node\":" + std::to_string(j) + "}";
  return R"({"humanoid":{"humanBones":{)" + text + "}}}";
}

/// `humanBones` of VRM 0.x; −1 stands for a bone that the figure does not have.
std::string listed_bones() {
  std::string text = R"({"bone":"jaw","node":-1,"useDefaultValues":true})";
  for (size_t j = 0; j < bones.size(); ++j)
    text += ",{\"bone\":\"" + std::string(bones[j]) + "\",\"node\":" + std::to_string(j) + "}";
  return R"({"exporterVersion":"x","humanoid":{"humanBones":[)" + text + "]}}";
}

std::string with_extension(std::string document, const std::string& name,
                           const std::string& value) {
  return document.insert(
      1, "\"extensions\":{\"" + name + "\":" + value + "},\"extensionsUsed\":[\"" + name + "\"],");
}

/// A walk, turned to face elsewhere, as a glTF document.
std::string walk_document(const Clip& clip, const Quat& facing) {
  GltfNumbers numbers;
  std::vector<float> times, places;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    times.push_back(static_cast<float>(static_cast<double>(f) / clip.frames_per_second));
    for (const double x : Vec3(facing * clip.poses[f].root_position))
      places.push_back(static_cast<float>(x));
  }
  const int input = numbers.add(times, "SCALAR");
  std::string samplers = gltf_sampler(input, numbers.add(places, "VEC3"), "LINEAR");
  std::string channels = gltf_channel(0, 0, "translation");
  for (int j = 0; j < body_joint_count; ++j) {
    std::vector<float> turns;
    for (const Pose& pose : clip.poses) {
      const Quat turn = facing * pose.rotations[static_cast<size_t>(j)] * facing.conjugate();
      for (const double x : turn.coeffs()) turns.push_back(static_cast<float>(x));
    }
    samplers += "," + gltf_sampler(input, numbers.add(turns, "VEC4"), "LINEAR");
    channels += "," + gltf_channel(j + 1, j, "rotation");
  }
  return gltf_text(numbers, nodes_of(clip.body, facing), channels, samplers);
}

Clip vrm_walk() { return repeated(walk({}, 30.0, standard_body()).clip, 2); }

void expect_walk(const Recording& recording, const Clip& clip, const Quat& facing) {
  ASSERT_EQ(recording.skeleton.size(), body_joint_count);
  for (const char* bone : bones) EXPECT_GE(find_joint(recording.skeleton, bone), 0) << bone;
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "vrm");
  EXPECT_GT(mapping.confidence, 0.95);
  const Clip read = to_body(recording, mapping);
  ASSERT_EQ(read.frame_count(), clip.frame_count());
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const JointTransforms expected = world_transforms(clip.body, clip.poses[f]);
    const JointTransforms got = world_transforms(read.body, read.poses[f]);
    for (size_t j = 0; j < bones.size(); ++j) {
      EXPECT_LT((got.positions[j] - facing * expected.positions[j]).norm(), 2e-3) << bones[j];
      EXPECT_LT(angle_between(got.rotations[j], facing * expected.rotations[j]),
                2.0 * radians_per_degree)
          << bones[j];
    }
  }
}

TEST(Vrm, AnimationsAreReadByTheirBonesWhateverTheNodesAreCalled) {
  const Clip clip = vrm_walk();
  const Quat facing = Quat::Identity();
  const Recording recording = parse_gltf(
      with_extension(walk_document(clip, facing), "VRMC_vrm_animation", named_bones()), "a.vrma");
  expect_walk(recording, clip, facing);
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_EQ(recording.notes[0],
            "The bones of the body are read, without 1 other joint, such as those of hair and "
            "clothes.");
}

TEST(Vrm, FiguresOfTheOldKindFaceTheOtherWay) {
  const Clip clip = vrm_walk();
  const Quat facing(Eigen::AngleAxisd(pi, Vec3::UnitY()));
  expect_walk(
      parse_gltf(with_extension(walk_document(clip, facing), "VRM", listed_bones()), "a.vrm"), clip,
      facing);
}

TEST(Vrm, CharactersWithoutMotionAreATPose) {
  const std::string document =
      R"({"asset":{"version":"2.0"},)" + nodes_of(standard_body(), Quat::Identity()) + "}";
  const Recording recording =
      parse_gltf(with_extension(document, "VRMC_vrm", named_bones()), "a.vrm");
  ASSERT_EQ(recording.frame_count(), 1);
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "vrm");
  EXPECT_GT(mapping.confidence, 0.95);
  const Clip read = to_body(recording, mapping);
  for (const Quat& rotation : read.poses[0].rotations)
    EXPECT_LT(angle_between(rotation, Quat::Identity()), 2.0 * radians_per_degree);
}

TEST(Vrm, WithoutItsExtensionIsReadByTheNamesOfTheNodes) {
  const Recording recording = parse_gltf(walk_document(vrm_walk(), Quat::Identity()), "a.gltf");
  EXPECT_EQ(recording.skeleton.size(), body_joint_count + 1);
  EXPECT_EQ(recording.skeleton.joints[1].name, "Spine");
}

TEST(Vrm, BonesThatAreWrongAreRefused) {
  const std::string document =
      R"({"asset":{"version":"2.0"},)" + nodes_of(standard_body(), Quat::Identity()) + "}";
  struct Case {
    const char* bones;
    const char* words;
  };
  const Case cases[] = {
      {R"({"hips":{"node":99}})", "VRM bone \"hips\" is a node that does not exist"},
      {R"({"hips":{"node":18446744073709551615}})", "is a node that does not exist"},
      {R"({"hips":{"node":"a"}})", "VRM bone \"hips\" has no node"},
      {R"({"hips":3})", "VRM bone \"hips\" has no node"},
      {R"({"hips":{"node":0},"spine":{"node":0}})", "VRM bone \"spine\" is the node of another"},
  };
  for (const Case& bad : cases) {
    const std::string extension = R"({"humanoid":{"humanBones":)" + std::string(bad.bones) + "}}";
    const std::string said =
        refusal_of([&] { parse_gltf(with_extension(document, "VRMC_vrm", extension), "a.vrm"); });
    EXPECT_NE(said.find(bad.words), std::string::npos) << said;
  }
  for (const char* odd : {"[]", "3", "null", R"({"humanoid":[]})", R"({"humanoid":{}})",
                          R"({"humanoid":{"humanBones":[1,{},{"bone":2}]}})"}) {
    EXPECT_EQ(parse_gltf(with_extension(document, "VRM", odd), "a.vrm").skeleton.size(),
              body_joint_count + 1)
        << odd;
  }
}

TEST(Vrm, OfTheRealAnimationIsAHumanWhoMovesAnArm) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real data";
  const std::filesystem::path file = *data / "recordings" / "vrma" / "test.vrma";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no VRM animation";
  const Recording recording = read_gltf(file);
  EXPECT_EQ(recording.skeleton.size(), 51);  // neither the expression nor the gaze
  EXPECT_EQ(find_joint(recording.skeleton, "happy"), -1);
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "vrm");
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_GT(mapping.confidence, 0.95);
  const Clip clip = to_body(recording, mapping);
  const JointTransforms first = world_transforms(clip.body, clip.poses.front());
  EXPECT_GT(first.positions[LeftWrist].x(), 0.3);
  EXPECT_GT(first.positions[LeftToe].z(), first.positions[LeftAnkle].z());
  double most = 0.0;
  for (const Pose& pose : clip.poses) {
    const JointTransforms now = world_transforms(clip.body, pose);
    EXPECT_LT((now.positions[LeftWrist] - first.positions[LeftWrist]).norm(), 1e-3);
    most = std::max(most, (now.positions[RightWrist] - first.positions[RightWrist]).norm());
  }
  EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace mien::motion
