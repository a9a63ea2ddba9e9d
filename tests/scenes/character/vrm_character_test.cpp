// VRM characters: meshes of several skins, and a figure that faces -Z (VRM 0.x) or +Z (VRM 1.0).

#include <string>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "scenes/character/character.h"
#include "scenes/skinned_gltf.h"

namespace mien::scenes {
namespace {

using motion::Quat;
using motion::Vec3;
using test::SkinnedGltf;

const motion::Skeleton vrm_body = motion::standard_body();

enum class Version { vrm_0, vrm_1 };

/// A figure whose nodes have the names of the joints on the other side.
SkinnedGltf vrm_figure(Version version) {
  test::SkinnedGltfOptions options;
  options.bind.rotations.assign(motion::body_joint_count, Quat::Identity());
  if (version == Version::vrm_0)
    options.bind.rotations[0] = Quat(Eigen::AngleAxisd(motion::pi, Vec3(Vec3::UnitY())));
  for (int j = 0; j < motion::body_joint_count; ++j)
    options.names.emplace_back(motion::name_of(motion::mirrored(motion::BodyJoint(j))));
  SkinnedGltf file = test::skinned_gltf(vrm_body, options);
  nlohmann::json& extensions = file.json["extensions"];
  const std::vector<std::string> names = test::vrm_names();
  if (version == Version::vrm_0) {
    nlohmann::json& bones = extensions["VRM"]["humanoid"]["humanBones"];
    // Bones that the figure does not have.
    bones.push_back({{"bone", "jaw"}, {"node", -1}});
    for (size_t j = 0; j < names.size(); ++j)
      bones.push_back({{"bone", names[j]}, {"node", j}, {"useDefaultValues", true}});
  } else {
    nlohmann::json& bones = extensions["VRMC_vrm"]["humanoid"]["humanBones"];
    for (size_t j = 0; j < names.size(); ++j) bones[names[j]]["node"] = j;
  }
  // Face and hair have skins of their own on the same joints.
  file.json["skins"].push_back(file.json["skins"][0]);
  file.json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  return file;
}

TEST(AVrmCharacter, FollowsTheBodyWhereverItsFileFaces) {
  for (const Version version : {Version::vrm_0, Version::vrm_1}) {
    const Character character =
        scaled_to_body(parse_character(vrm_figure(version).text(), "figure.vrm"), vrm_body);
    ASSERT_EQ(character.meshes.size(), 2u);
    motion::Pose pose;
    pose.root_position = Vec3(0.1, 1.0, 0.2);
    for (int j = 0; j < motion::body_joint_count; ++j)
      pose.rotations.push_back(motion::exp(Vec3(0.02 * j, 0.3 - 0.03 * j, 0.1)));
    const motion::JointTransforms expected = motion::world_transforms(vrm_body, pose);
    const motion::JointTransforms rig = rig_pose(character, pose);
    for (size_t j = 0; j < expected.positions.size(); ++j) {
      EXPECT_EQ(character.joints[j].found_by, "name");
      const auto joint = static_cast<size_t>(character.joints[j].position);
      EXPECT_LT((rig.positions[joint] - expected.positions[j]).norm(), 1e-5)
          << motion::name_of(motion::BodyJoint(j));
    }
    const std::vector<render::Mesh> meshes = posed(character, pose);
    EXPECT_EQ(meshes[0].positions, meshes[1].positions);
  }
}

}  // namespace
}  // namespace mien::scenes
