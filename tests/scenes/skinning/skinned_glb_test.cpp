#include "scenes/skinning/skinned_glb.h"

#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "render/scene/texture_io.h"
#include "scenes/character/character_glb.h"
#include "scenes/face_figure.h"
#include "scenes/glb_contents.h"
#include "scenes/mannequin/mannequin.h"
#include "scenes/skinned_gltf.h"

// Files are read back by glTF's own rules, and posed as three.js does.

namespace mien::scenes {
namespace {

using motion::Vec3;
using test::GlbContents;

const motion::Skeleton body = motion::standard_body();

motion::Pose some_pose(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-0.6, 0.6);
  motion::Pose pose;
  pose.root_position = Vec3(0.3, 1.0, -0.2);
  for (int j = 0; j < motion::body_joint_count; ++j)
    pose.rotations.push_back(motion::exp(Vec3(angle(random), angle(random), angle(random))));
  return pose;
}

std::vector<Eigen::Affine3d> joint_matrices(const GlbContents& glb,
                                            const motion::JointTransforms& now) {
  const std::vector<double> inverse = glb.numbers(glb.json["skins"][0]["inverseBindMatrices"]);
  std::vector<Eigen::Affine3d> matrices;
  for (std::size_t j = 0; j < now.positions.size(); ++j) {
    Eigen::Affine3d bind;
    bind.matrix() = Eigen::Map<const Eigen::Matrix4d>(inverse.data() + 16 * j);
    matrices.push_back(Eigen::Translation3d(now.positions[j]) * now.rotations[j] * bind);
  }
  return matrices;
}

/// The vertices of a primitive with its joints there.
std::vector<Vec3> skinned(const GlbContents& glb, std::size_t primitive,
                          const motion::JointTransforms& now) {
  const nlohmann::json& attributes = glb.json["meshes"][0]["primitives"][primitive]["attributes"];
  const std::vector<Eigen::Affine3d> matrices = joint_matrices(glb, now);
  const std::vector<double> positions = glb.numbers(attributes["POSITION"]),
                            joints = glb.numbers(attributes["JOINTS_0"]),
                            weights = glb.numbers(attributes["WEIGHTS_0"]);
  std::vector<Vec3> vertices;
  for (std::size_t v = 0; 3 * v < positions.size(); ++v) {
    const Vec3 at(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    Vec3 moved = Vec3::Zero();
    for (std::size_t k = 4 * v; k < 4 * v + 4; ++k)
      moved += weights[k] * (matrices[static_cast<std::size_t>(joints[k])] * at);
    vertices.push_back(moved);
  }
  return vertices;
}

TEST(ASkinnedGlb, OfACharacterMovesAsTheCharacterDoes) {
  const auto file = test::skinned_gltf(body, {modelling_pose(body), test::mixamo_names()});
  const Character character = scaled_to_body(parse_character(file.text(), "figure.gltf"), body);
  const GlbContents glb = test::glb_contents(to_glb(character));
  ASSERT_EQ(glb.json["skins"][0]["joints"].size(), character.rig.joints.size());
  EXPECT_EQ(glb.json["nodes"][3]["extras"]["body_joint"], body_joint_of(character)[3]);
  for (unsigned seed = 1; seed < 6; ++seed) {
    const motion::Pose pose = some_pose(seed);
    const std::vector<render::Mesh> meshes = posed(character, pose);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const std::vector<Vec3> vertices = skinned(glb, m, rig_pose(character, pose));
      ASSERT_EQ(vertices.size(), meshes[m].positions.size());
      for (std::size_t v = 0; v < vertices.size(); ++v)
        EXPECT_LT((vertices[v] - meshes[m].positions[v].cast<double>()).norm(), 1e-5);
    }
  }
}

TEST(ASkinnedGlb, OfAMannequinIsNearTheOneOfFilms) {
  const FigureColours colours = colours_of(Role::target);
  const Mannequin mannequin = make_mannequin(body, {}, colours);
  const GlbContents glb = test::glb_contents(to_glb(mannequin, body));
  EXPECT_EQ(glb.json["nodes"].size(), body.joints.size() + 1);
  motion::Pose pose = modelling_pose(body);
  const std::vector<Vec3> still = skinned(glb, 0, motion::world_transforms(body, pose));
  ASSERT_EQ(still.size(), mannequin.mesh.positions.size());
  for (std::size_t v = 0; v < still.size(); ++v)
    EXPECT_LT((still[v] - mannequin.mesh.positions[v]).norm(), 1e-5);
  // Linear and rigid skinning differ where limbs bend, by far less than a limb is wide.
  pose.rotations[motion::LeftElbow] = motion::exp(Vec3(0.0, -1.0, 0.0));
  pose.rotations[motion::RightKnee] = motion::exp(Vec3(0.8, 0.0, 0.0));
  const std::vector<Vec3> bent = skinned(glb, 0, motion::world_transforms(body, pose));
  const render::Mesh film = posed(mannequin, body, pose);
  for (std::size_t v = 0; v < bent.size(); ++v)
    EXPECT_LT((bent[v] - film.positions[v].cast<double>()).norm(), 0.02);
}

/// The three numbers of each vertex.
std::vector<Vec3> vectors(const GlbContents& glb, const nlohmann::json& accessor) {
  const std::vector<double> numbers = glb.numbers(accessor);
  std::vector<Vec3> list;
  for (std::size_t i = 0; i < numbers.size(); i += 3) list.emplace_back(numbers.data() + i);
  return list;
}

/// Positions and normals of a mesh of the file with its targets, as three.js adds them.
MeshShape shape_in(const GlbContents& glb, const nlohmann::json& mesh,
                   const std::vector<double>& weights) {
  const nlohmann::json& primitive = mesh["primitives"][0];
  MeshShape shape{vectors(glb, primitive["attributes"]["POSITION"]),
                  vectors(glb, primitive["attributes"]["NORMAL"])};
  for (std::size_t t = 0; t < primitive["targets"].size(); ++t) {
    const nlohmann::json& target = primitive["targets"][t];
    const double weight = weights[mesh["extras"]["morphs"][t].get<std::size_t>()];
    const auto moves = vectors(glb, target["POSITION"]), turns = vectors(glb, target["NORMAL"]);
    for (std::size_t v = 0; v < moves.size(); ++v) {
      shape.positions[v] += weight * moves[v];
      shape.normals[v] += weight * turns[v];
    }
  }
  return shape;
}

TEST(ASkinnedGlb, HasTheMorphTargetsOfItsCharacter) {
  const Character character =
      parse_character(test::face_figure_glb(test::FaceFormat::vrm), "face.glb");
  const GlbContents glb = test::glb_contents(to_glb(character));
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::vector<double> weights;
  for (int m = 0; m < character.face.morph_count; ++m) weights.push_back(weight(random));
  std::size_t next = 1;  // after the mesh of those without targets
  std::set<std::string> names;
  for (const SkinnedMesh& mesh : character.meshes) {
    if (mesh.morphs.empty()) continue;
    const nlohmann::json& written = glb.json["meshes"].at(next++);
    const MeshShape expected = morphed_shape(mesh, weights),
                    shape = shape_in(glb, written, weights);
    ASSERT_EQ(shape.positions.size(), expected.positions.size());
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
      EXPECT_LT((shape.positions[v] - expected.positions[v]).norm(), 1e-6);
      EXPECT_LT((shape.normals[v].normalized() - expected.normals[v]).norm(), 1e-4);
    }
    for (const nlohmann::json& name : written["extras"]["targetNames"]) names.insert(name);
  }
  EXPECT_EQ(next, glb.json["meshes"].size());
  EXPECT_EQ(names, (std::set<std::string>(test::face_targets.begin(), test::face_targets.end())));
}

TEST(ASkinnedGlb, StatesTheBoundsOfItsTargets) {
  const Character character =
      parse_character(test::face_figure_glb(test::FaceFormat::gltf), "face.glb");
  const GlbContents glb = test::glb_contents(to_glb(character));
  int targets = 0;
  for (const nlohmann::json& mesh : glb.json["meshes"]) {
    for (const nlohmann::json& target : mesh["primitives"][0].value("targets", nlohmann::json())) {
      Eigen::AlignedBox3d box;
      for (const Vec3& move : vectors(glb, target["POSITION"])) box.extend(move);
      const nlohmann::json& accessor = glb.json["accessors"][target["POSITION"].get<std::size_t>()];
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(accessor["min"][axis].get<double>(), box.min()[axis]);
        EXPECT_EQ(accessor["max"][axis].get<double>(), box.max()[axis]);
      }
      ++targets;
    }
  }
  EXPECT_GE(targets, 10);
}

TEST(ASkinnedGlb, HasFourJointsAVertexWhoseWeightsAreOne) {
  SkinnedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, Vec3::UnitZ());
  mesh.triangles = {{0, 1, 2}};
  mesh.influences = {{{0, 0.4f}, {1, 0.3f}, {2, 0.15f}, {3, 0.1f}, {4, 0.05f}},
                     {{2, 1.0f}},
                     {{1, 0.5f}, {3, 0.5f}}};
  const std::vector<SkinnedMesh> meshes = {mesh};
  const std::vector<render::Material> materials = {render::Material{}};
  SkinnedFigure whole{.joints = {"a", "b", "c", "d", "e"},
                      .body_joints = {0, 1, 2, 3, 4},
                      .meshes = meshes,
                      .materials = materials};
  whole.bind.positions.assign(5, Vec3::Zero());
  whole.bind.rotations.assign(5, motion::Quat::Identity());
  const GlbContents glb = test::glb_contents(skinned_glb(whole));
  const nlohmann::json& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
  const std::vector<double> weights = glb.numbers(attributes["WEIGHTS_0"]);
  ASSERT_EQ(weights.size(), 12u);
  EXPECT_NEAR(weights[0], 0.4 / 0.95, 1e-6);
  for (std::size_t v = 0; v < 3; ++v)
    EXPECT_NEAR(weights[4 * v] + weights[4 * v + 1] + weights[4 * v + 2] + weights[4 * v + 3], 1.0,
                1e-6);
  EXPECT_EQ(glb.numbers(attributes["JOINTS_0"])[4], 2.0);
}

TEST(ASkinnedGlb, KeepsItsPictures) {
  const Mannequin mannequin = make_mannequin(body, {}, colours_of(Role::created));
  const GlbContents glb = test::glb_contents(to_glb(mannequin, body));
  const std::string png = glb.file(glb.json["images"][0]["bufferView"]);
  const render::Texture read = render::read_texture(
      {reinterpret_cast<const unsigned char*>(png.data()), png.size()}, "paint", {}, 16384);
  ASSERT_EQ(read.width, mannequin.paint.width);
  ASSERT_EQ(read.height, mannequin.paint.height);
  for (std::size_t i = 0; i < read.texels.size(); i += 97)
    EXPECT_LT((read.texels[i] - mannequin.paint.texels[i]).abs().maxCoeff(), 5e-3);
  EXPECT_EQ(glb.json["textures"][0]["source"], 0);
}

}  // namespace
}  // namespace mien::scenes
