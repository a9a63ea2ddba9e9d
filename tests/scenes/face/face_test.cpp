// Faces of characters: morph targets of glTF, expressions of VRM, files of weights.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "motion/skeleton/clip.h"
#include "motion/text/excerpt.h"
#include "pipeline/temporary_folder.h"
#include "scenes/face/character_face.h"
#include "scenes/face_figure.h"
#include "scenes/skinned_gltf.h"
#include "scenes/stage/actor.h"

namespace mien::scenes {
namespace {

using mien::test::FaceFormat;
using mien::test::TemporaryFolder;
using motion::Quat;
using motion::Vec3;
using nlohmann::json;

const motion::Skeleton face_body = motion::standard_body();

Character face_character(FaceFormat format) {
  const std::string glb = mien::test::face_figure_glb(format);
  return scaled_to_body(parse_character(glb, "face.glb"), face_body);
}

motion::Pose turned_head() {
  motion::Pose pose;
  pose.root_position = Vec3(0.1, 1.0, -0.2);
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  pose.rotations[motion::Head] = motion::exp(Vec3(0.2, 0.7, -0.1));
  return pose;
}

const std::vector<std::string>& listed_targets() {
  static const std::vector<std::string> names(mien::test::face_targets.begin(),
                                              mien::test::face_targets.end());
  return names;
}

/// The largest difference between vertices of two shapes of a character.
double difference(const std::vector<render::Mesh>& one, const std::vector<render::Mesh>& other) {
  float most = 0.0f;
  for (std::size_t m = 0; m < one.size(); ++m)
    for (std::size_t v = 0; v < one[m].positions.size(); ++v)
      most = std::max(most, (one[m].positions[v] - other[m].positions[v]).norm());
  return static_cast<double>(most);
}

TEST(AFace, HasTheTargetsOfItsFile) {
  const Character character = face_character(FaceFormat::gltf);
  EXPECT_EQ(face_names(character.face), listed_targets());
  EXPECT_EQ(character.face.morph_count, 10);
  EXPECT_TRUE(character.warnings.empty()) << motion::listed(character.warnings);
}

TEST(AFace, WithoutWeightsKeepsEveryByte) {
  const Character character = face_character(FaceFormat::gltf);
  const auto plain = posed(character, turned_head());
  const auto zero = posed(character, turned_head(),
                          morph_weights(character, {{"jawOpen", 0.0}, {"eyeBlinkLeft", 0.0}}));
  ASSERT_EQ(plain.size(), zero.size());
  for (std::size_t m = 0; m < plain.size(); ++m) {
    EXPECT_EQ(plain[m].positions, zero[m].positions);
    EXPECT_EQ(plain[m].normals, zero[m].normals);
  }
}

TEST(AFace, MovesHalfAsFarAtHalfTheWeight) {
  const Character character = face_character(FaceFormat::gltf);
  const auto shape = [&](double weight) {
    return posed(character, turned_head(), morph_weights(character, {{"mouthSmileLeft", weight}}));
  };
  const auto neutral = shape(0.0), half = shape(0.5), full = shape(1.0);
  EXPECT_GT(difference(neutral, full), 0.005);
  for (std::size_t m = 0; m < full.size(); ++m)
    for (std::size_t v = 0; v < full[m].positions.size(); ++v)
      EXPECT_LT(
          (half[m].positions[v] - 0.5f * (neutral[m].positions[v] + full[m].positions[v])).norm(),
          2e-6f);
}

TEST(AFace, ClosesItsLids) {
  const Character character = face_character(FaceFormat::gltf);
  motion::Pose pose = turned_head();
  pose.rotations[motion::Head] = Quat::Identity();
  // In the front of the eye, the gap between the lids is where no lid is.
  const auto gap = [&](double blink) {
    const auto meshes = posed(character, pose, morph_weights(character, {{"eyeBlinkLeft", blink}}));
    std::vector<double> heights;
    double front = -1e9;
    std::vector<render::Vec3> lids;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const auto& morphs = character.meshes[m].morphs;
      if (morphs.size() != 1 || morphs.front().morph != 0) continue;
      lids.insert(lids.end(), meshes[m].positions.begin(), meshes[m].positions.end());
    }
    double middle = 0.0;
    for (const render::Vec3& at : lids) middle += static_cast<double>(at.x());
    middle /= static_cast<double>(lids.size());
    for (const render::Vec3& at : lids) front = std::max(front, static_cast<double>(at.z()));
    for (const render::Vec3& at : lids) {
      const bool is_in_front = static_cast<double>(at.z()) > front - 0.005;
      if (is_in_front && std::abs(static_cast<double>(at.x()) - middle) < 0.001)
        heights.push_back(static_cast<double>(at.y()));
    }
    std::ranges::sort(heights);
    double widest = 0.0;
    for (std::size_t i = 1; i < heights.size(); ++i)
      widest = std::max(widest, heights[i] - heights[i - 1]);
    return widest;
  };
  EXPECT_GT(gap(0.0), 1.9 * mien::test::lid_opening_m);
  EXPECT_LT(gap(1.0), 0.002);
  EXPECT_NEAR(gap(0.5), 0.5 * (gap(0.0) + gap(1.0)), 0.002);
}

TEST(AFace, KnowsNamesWithOtherCaseAndSides) {
  FaceControls face;
  face.morph_count = 3;
  face.controls = {{"eyeBlinkLeft", {{0, 1.0}}}, {"head.jaw_R", {{1, 1.0}}}, {"Jaw", {{2, 1.0}}}};
  EXPECT_EQ(control_named(face, "EyeBlinkLeft"), &face.controls[0]);
  EXPECT_EQ(control_named(face, "eyeBlink_L"), &face.controls[0]);
  EXPECT_EQ(control_named(face, "jawRight"), &face.controls[1]);
  EXPECT_EQ(control_named(face, "jaw"), &face.controls[2]);
  EXPECT_EQ(control_named(face, "blink"), nullptr);
  face.controls = {{"Exp001", {{0, 1.0}}}, {"expression_12", {{1, 1.0}}}, {"Explain", {{2, 1.0}}}};
  EXPECT_EQ(control_named(face, "exp1"), &face.controls[0]);
  EXPECT_EQ(control_named(face, "exp12"), &face.controls[1]);
  EXPECT_EQ(control_named(face, "exp2"), nullptr);
}

TEST(AFace, RefusesNamesThatItDoesNotHave) {
  const Character character = face_character(FaceFormat::gltf);
  const std::string said = mien::test::refusal_of([&] {
    morph_weights(character, {{"jawOpne", 0.5}});
  });
  EXPECT_NE(said.find("has no \"jawOpne\"; did you mean \"jawOpen\"?"), std::string::npos) << said;
}

TEST(AVrmFace, HasExpressionsThatEqualTheirBinds) {
  const Character character = face_character(FaceFormat::vrm);
  const std::vector<std::string> names = face_names(character.face);
  ASSERT_EQ(names.size(), 15u);
  EXPECT_EQ(std::vector<std::string>(names.begin(), names.begin() + 5),
            (std::vector<std::string>{"angry", "blink", "happy", "sad", "surprised"}));
  EXPECT_EQ(morph_weights(character, {{"surprised", 0.5}}),
            morph_weights(character, {{"jawOpen", 0.35}, {"browInnerUp", 0.5}}));
  EXPECT_EQ(morph_weights(character, {{"happy", 0.25}, {"mouthSmileLeft", 0.5}}),
            morph_weights(character, {{"mouthSmileLeft", 0.75}, {"mouthSmileRight", 0.25}}));
}

/// A figure of boxes whose mesh has two targets.
mien::test::SkinnedGltf boxes_with_targets() {
  mien::test::SkinnedGltf file = mien::test::skinned_gltf(face_body, {{}, mien::test::vrm_names()});
  mien::test::add_face(file);
  return file;
}

/// Both targets double the figure in its own space, so that each vertex moves by its place there.
TEST(AFace, IsPlacedWithTheMeshThatItMoves) {
  mien::test::SkinnedGltf file = boxes_with_targets();
  json& primitive = file.json["meshes"][0]["primitives"][0];
  const json positions = primitive["attributes"]["POSITION"];
  primitive["attributes"]["NORMAL"] = positions;
  primitive["targets"][0]["NORMAL"] = positions;
  file.json["nodes"].push_back(
      {{"name", "Armature"}, {"scale", {-2.0, 2.0, 2.0}}, {"children", {0}}});
  const Character character = parse_character(file.text(), "mirrored.gltf");
  const SkinnedMesh& mesh = character.meshes.front();
  const MorphTarget& target = mesh.morphs.front();
  ASSERT_EQ(target.vertices.size(), mesh.positions.size());
  const Vec3 origin = mesh.positions[0] - target.positions[0];
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_LT((mesh.positions[v] - target.positions[v] - origin).norm(), 1e-6);
  // Normals are in the same proportion to their changes as in the file: one to one.
  const MeshShape less = morphed_shape(mesh, std::vector<double>{-0.5});
  const MeshShape opposite = morphed_shape(mesh, std::vector<double>{-2.0});
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    EXPECT_LT((less.normals[v] - mesh.normals[v]).norm(), 1e-9);
    EXPECT_LT((opposite.normals[v] + mesh.normals[v]).norm(), 1e-9);
  }
}

json vrm_0_group(const char* name, const char* preset, int index, double weight) {
  return {{"name", name},
          {"presetName", preset},
          {"isBinary", std::string(name) == "Fixed"},
          {"binds", {{{"mesh", 0}, {"index", index}, {"weight", weight}}}}};
}

TEST(AVrmFace, HasTheGroupsOfVrm0) {
  mien::test::SkinnedGltf file = boxes_with_targets();
  json& vrm = file.json["extensions"]["VRM"];
  const std::vector<std::string> bones = mien::test::vrm_names();
  for (std::size_t j = 0; j < bones.size(); ++j)
    vrm["humanoid"]["humanBones"].push_back({{"bone", bones[j]}, {"node", j}});
  vrm["blendShapeMaster"]["blendShapeGroups"] = {vrm_0_group("Joy", "joy", 1, 80.0),
                                                 vrm_0_group("Fixed", "unknown", 0, 100.0),
                                                 vrm_0_group("Lost", "unknown", 2, 100.0)};
  const Character character = parse_character(file.text(), "figure.vrm");
  const auto weights = [&](const FaceWeights& given) { return morph_weights(character, given); };
  EXPECT_EQ(weights({{"happy", 0.5}}), (std::vector<double>{0.0, 0.4}));
  EXPECT_EQ(weights({{"Fixed", 0.51}}), (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(weights({{"Fixed", 0.5}}), (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(weights({{"Lost", 1.0}}), (std::vector<double>{0.0, 0.0}));
  ASSERT_EQ(character.warnings.size(), 1u);
  EXPECT_NE(character.warnings.front().find("\"Lost\""), std::string::npos);
}

TEST(AFace, IsRefusedWithFaultyTargets) {
  const auto refused = [](const std::function<void(json&)>& change, const std::string& wrong) {
    mien::test::SkinnedGltf file = boxes_with_targets();
    change(file.json);
    const std::string said =
        mien::test::refusal_of([&] { parse_character(file.text(), "figure.gltf"); });
    EXPECT_NE(said.find(wrong), std::string::npos) << said;
  };
  const auto target = [](json& file) -> json& {
    return file["meshes"][0]["primitives"][0]["targets"][1];
  };
  refused([&](json& file) { target(file)["POSITION"] = 999; }, "target 1: there is no POSITION");
  refused([&](json& file) { target(file)["POSITION"] = 1; }, "target 1, POSITION: ");
  refused([&](json& file) { target(file)["POSITION"] = file["skins"][0]["inverseBindMatrices"]; },
          "target 1, POSITION: not one per vertex");
  refused(
      [&](json& file) {
        json& targets = file["meshes"][0]["primitives"][0]["targets"];
        const json one = targets[0];
        for (int i = 0; i < 5000; ++i) targets.push_back(one);
      },
      "more morph targets than supported");
}

TEST(AFace, HasNumbersForNamesWhereTheFileHasNone) {
  mien::test::SkinnedGltf file = boxes_with_targets();
  file.json["meshes"][0]["extras"]["targetNames"] = {"one", 7};
  const Character character = parse_character(file.text(), "figure.gltf");
  EXPECT_EQ(face_names(character.face), (std::vector<std::string>{"one", "target_1"}));
}

TEST(AFaceMotion, FollowsATableFromItsStart) {
  const TemporaryFolder folder;
  const std::filesystem::path table = folder.path() / "face.csv";
  std::ofstream(table) << "time,JawOpen,tongueOut\n0,0,0\n1,1,1\n";
  const Character character = face_character(FaceFormat::gltf);
  Face face;
  face.file = table;
  face.start_s = 0.5;
  const FaceMotion motion(character, face, 61, 30.0);
  for (int frame = 0; frame <= 60; ++frame) {
    const double expected = std::clamp(frame / 30.0 - 0.5, 0.0, 1.0);
    EXPECT_NEAR(motion.at(frame)[2], expected, 1e-12) << frame;
    EXPECT_EQ(motion.at(frame)[0], 0.0);
  }
  ASSERT_EQ(motion.warnings().size(), 1u);
  EXPECT_EQ(motion.warnings().front(),
            "The face does not have these names of face.csv: tongueOut.");
  std::ofstream(table) << "time,tongueOut\n0,0\n";
  const std::string said = mien::test::refusal_of([&] { FaceMotion(character, face, 10, 30.0); });
  EXPECT_NE(said.find("none of its names"), std::string::npos) << said;
}

TEST(AnActor, HasTheFaceOfItsFigureInEachFrame) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "face.glb";
  std::ofstream(file, std::ios::binary) << mien::test::face_figure_glb(FaceFormat::gltf);
  std::ofstream(folder.path() / "face.csv") << "time,jawOpen\n0,0\n1,1\n";
  motion::Clip clip;
  clip.body = face_body;
  clip.frames_per_second = 4.0;
  clip.poses.assign(5, turned_head());
  const auto drawn = [&](const Face& face, int frame) {
    const Actor actor =
        make_actor(clip, with_face(CharacterOptions{file, {}}, face), Role::neutral);
    render::Scene scene;
    add_actor(scene, actor, frame, frame, {});
    return scene.solids.meshes;
  };
  Face moving;
  moving.file = folder.path() / "face.csv";
  Face half;
  half.weights = {{"jawOpen", 0.5}};
  EXPECT_EQ(difference(drawn({}, 0), drawn({}, 2)), 0.0);
  EXPECT_EQ(difference(drawn(moving, 0), drawn({}, 0)), 0.0);
  EXPECT_LT(difference(drawn(moving, 2), drawn(half, 2)), 1e-7);
  EXPECT_GT(difference(drawn(moving, 2), drawn({}, 2)), 0.005);
  moving.start_s = 1.0;
  EXPECT_EQ(difference(drawn(moving, 4), drawn({}, 4)), 0.0);
  moving.start_s = 1.25;
  const std::string said = mien::test::refusal_of([&] { drawn(moving, 4); });
  EXPECT_NE(said.find("begin at 1.25 s, but the film ends at 1.25 s"), std::string::npos) << said;
  Face hidden;
  hidden.is_hidden = true;
  EXPECT_EQ(drawn(hidden, 0).size(), drawn({}, 0).size() + 1);
}

}  // namespace
}  // namespace mien::scenes
