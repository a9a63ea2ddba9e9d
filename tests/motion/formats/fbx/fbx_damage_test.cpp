// Damaged and hostile FBX files are refused with the right words, in bounded time and memory.

#include <chrono>
#include <cstring>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "motion/formats/fbx/fbx.h"
#include "motion/formats/fbx/fbx_mesh.h"
#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/formats/format_checks.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/text/excerpt.h"

using namespace mien::motion;
using mien::test::fbx_arm;
using mien::test::FbxSceneBuilder;
using mien::test::FbxTestNode;
using mien::test::FbxTestWriter;
using mien::test::replaced;

namespace {

std::string refusal_of(const std::string& bytes) {
  return mien::test::refusal_of([&] { parse_fbx(bytes, "bad.fbx"); });
}

void expect_refused(const std::string& bytes, const std::string& words) {
  const std::string refusal = refusal_of(bytes);
  EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
  EXPECT_LT(refusal.size(), 400u);
}

/// Reads the motion and the meshes, which either succeeds or throws mien::Error.
void try_to_read(const std::string& bytes) {
  try {
    EXPECT_TRUE(mien::test::is_sound(parse_fbx(bytes, "mutant.fbx")));
  } catch (const mien::Error& error) {
    EXPECT_LT(std::string(error.what()).size(), 500u);
  }
  try {
    const FbxScene scene = parse_fbx_scene(bytes, "mutant.fbx");
    for (const FbxMesh& mesh : fbx_meshes(scene)) {
      EXPECT_EQ(posed_vertices(mesh, places_of(scene, at_rest(scene))).size(),
                mesh.positions.size());
    }
  } catch (const mien::Error&) {
  }
}

/// The arm with a square that its bones move.
FbxSceneBuilder skinned_arm() {
  FbxSceneBuilder arm = fbx_arm();
  using Ints = std::vector<std::int32_t>;
  using Numbers = std::vector<double>;
  const std::int64_t mesh = arm.model("skin", "Mesh", 0, {0, 0, 0});
  const FbxTestNode uv{"LayerElementUV",
                       {std::int32_t{0}},
                       {{"MappingInformationType", {std::string("ByPolygonVertex")}, {}},
                        {"ReferenceInformationType", {std::string("IndexToDirect")}, {}},
                        {"UV", {Numbers{0, 0, 1, 1}}, {}},
                        {"UVIndex", {Ints{0, 1, 0, 1}}, {}}}};
  const std::int64_t geometry =
      arm.add("Geometry", "", "Mesh",
              {{"Vertices", {Numbers{0, 0, 0, 10, 0, 0, 10, 300, 0, 0, 300, 0}}, {}},
               {"PolygonVertexIndex", {Ints{0, 1, 2, -4}}, {}},
               uv});
  arm.connect(geometry, mesh);
  const std::int64_t skin = arm.add("Deformer", "", "Skin", {});
  arm.connect(skin, geometry);
  for (const int bone : {0, 1}) {
    const double height = -200.0 * bone;
    const std::int64_t cluster = arm.add(
        "Deformer", "", "Cluster",
        {{"Indexes", {Ints{2 * bone, 2 * bone + 1}}, {}},
         {"Weights", {Numbers{1, 0.5}}, {}},
         {"Transform", {Numbers{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, height, 0, 1}}, {}}});
    arm.connect(cluster, skin);
    arm.connect(1000 + bone, cluster);
  }
  return arm;
}

}  // namespace

TEST(FbxMesh, FollowsItsBones) {
  const std::string bytes = skinned_arm().binary();
  const FbxScene scene = parse_fbx_scene(bytes, "arm.fbx");
  const std::vector<FbxMesh> meshes = fbx_meshes(scene);
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].triangles, (std::vector<std::array<int, 3>>{{{0, 1, 2}}, {{0, 2, 3}}}));
  EXPECT_EQ(meshes[0].uv_sets.at(0).uv[1], (std::array<float, 2>{1.0f, 1.0f}));
  std::vector<FbxMoving> moving = at_rest(scene);
  apply(parse_fbx_animation(scene.document, scene.objects, scene.models, scene.takes[0]),
        scene.models, fbx_ticks_per_second, moving);
  const std::vector<Vec3> posed = posed_vertices(meshes[0], places_of(scene, moving));
  mien::test::expect_near(posed[1], {410, 0, 0}, 1e-9);
  // A forearm at 90°: what was above the elbow is to its left.
  mien::test::expect_near(posed[2], {300, 210, 0}, 1e-9);
}

TEST(FbxDamage, OtherVersionsAreRefusedByNumber) {
  expect_refused(fbx_arm().binary(5800), "is FBX of version 5.8 (5800)");
  expect_refused(fbx_arm().binary(8100), "(8100)");
  expect_refused("; FBX 5.0.0 project file\nObjects: {\n}\n", "(5000)");
  expect_refused("Objects: {\n}\n", "states no version");
}

TEST(FbxDamage, FilesWithoutAFigureAreRefused) {
  FbxSceneBuilder file;
  expect_refused(file.binary(), "holds no skeleton and nothing that moves");
  file.model("box", "Mesh", 0, {0, 0, 0});
  expect_refused(file.binary(), "holds no skeleton and nothing that moves");
  expect_refused(FbxTestWriter(7400, false).file({}), "holds no objects");
}

TEST(FbxDamage, ModelsInACircleAreRefused) {
  FbxSceneBuilder file;
  const std::int64_t a = file.model("a", "LimbNode", 1001, {0, 0, 0});
  file.model("b", "LimbNode", a, {0, 0, 0});
  expect_refused(file.binary(), "in a circle");
  FbxSceneBuilder chain;
  std::int64_t parent = 0;
  for (int i = 0; i < 1100; ++i) parent = chain.model("a", "LimbNode", parent, {0, 0, 0});
  expect_refused(chain.binary(), "1024 deep");
}

TEST(FbxDamage, CurvesOfUnequalListsOrTimesThatDecreaseAreRefused) {
  const auto with_keys = [](const FbxSceneBuilder::Keys& keys) {
    FbxSceneBuilder file;
    const std::int64_t bone = file.model("bone", "LimbNode", 0, {0, 0, 0});
    file.curve(file.take("t").second, bone, "Lcl Rotation", "d|X", keys);
    return file.binary();
  };
  expect_refused(with_keys({{0, 1, 2}, {0, 1}}), "a curve has 3 times, but 2 values");
  expect_refused(with_keys({{1, 0}, {0, 1}}), "times of a curve's keys decrease");
  expect_refused(with_keys({{0, 1}, {0, INFINITY}}), "too large");
  expect_refused(with_keys({{0, 4000}, {0, 1}}), "longer than an hour");
  // Runs that do not add up use the last form.
  parse_fbx(with_keys({{0, 1}, {0, 1}, {4}, {}, {-3}}), "runs.fbx");
}

TEST(FbxDamage, ArraysThatInflateTooFarAreRefusedBeforeTheyAre) {
  // Half a billion zeros, as the header says, in a few bytes.
  const std::string arm = fbx_arm().binary();
  const size_t at = arm.find("KeyTime");
  ASSERT_NE(at, std::string::npos);
  std::string bomb = arm;
  const std::uint32_t many = 1u << 29;
  std::memcpy(bomb.data() + at + 8, &many, 4);
  expect_refused(bomb, "an array states 536870912 elements");
  expect_refused(bomb, "at byte " + std::to_string(at + 7));
  // A number that is wrong by one.
  std::string wrong = arm;
  wrong[at + 8] = 3;
  expect_refused(wrong, "a compressed array is damaged or not of the stated length");
}

TEST(FbxDamage, NodesNestedTooDeepAreRefused) {
  FbxTestNode node{"N", {}, {}};
  for (int depth = 0; depth < 80; ++depth) node = {"N", {}, {node}};
  expect_refused(FbxTestWriter(7400, false).file({node}), "more than 64 deep");
  std::string text = "; FBX 7.4.0 project file\n";
  for (int depth = 0; depth < 100'000; ++depth) text += "N: {";
  expect_refused(text, "bad.fbx:2:257: nodes are nested more than 64 deep");
}

TEST(FbxDamage, TextIsRefusedWithLineAndColumn) {
  const std::string text = fbx_arm().text();
  expect_refused(text.substr(0, text.size() - 3), "a brace is not closed");
  expect_refused("; FBX 7.4.0\nA: 1 }\n", "bad.fbx:2:6: a brace is closed that was not opened");
  expect_refused("; FBX 7.4.0\nA: \"x\n", "bad.fbx:2:4: a text in quotes has no end");
  expect_refused("; FBX 7.4.0\n\n  : 1\n", "bad.fbx:3:3: expected a name");
  expect_refused(replaced(text, "*2", "*7"), "an array states \"7\" elements, but has 2");
  expect_refused(replaced(text, "a: 0,90", "a: 0,1x0"), "\"1x0\" is not a valid number");
}

TEST(FbxDamage, HostileTextIsQuotedInParts) {
  const std::string text = fbx_arm().text();
  const std::string refusal =
      refusal_of(replaced(text, "a: 0,90", "a: 0,1\x1b[2J" + std::string(100'000, 'x')));
  EXPECT_LT(refusal.size(), 400u);
  EXPECT_EQ(printable(refusal), refusal);
}

TEST(FbxDamage, EveryTruncationIsReadOrRefused) {
  const FbxSceneBuilder arm = skinned_arm();
  for (const std::string& bytes : {arm.binary(7400, true), arm.binary(7500, false), arm.text()}) {
    const size_t step = bytes.size() > 4000 ? 3 : 1;
    for (size_t size = 0; size < bytes.size(); size += step) {
      // An own copy, so that the sanitizers see any byte read beyond it.
      try_to_read(std::string(bytes.data(), size));
    }
  }
}

TEST(FbxDamage, MutationsAreReadOrRefused) {
  const FbxSceneBuilder arm = skinned_arm();
  std::mt19937_64 random(38);
  for (const std::string& bytes : {arm.binary(7400, true), arm.binary(7500, false), arm.text()}) {
    for (int trial = 0; trial < 400; ++trial) {
      std::string mutant = bytes;
      const int changes = 1 + static_cast<int>(random() % 4);
      for (int i = 0; i < changes; ++i) {
        const size_t at = random() % mutant.size();
        switch (random() % 4) {
          case 0:
            mutant[at] = static_cast<char>(random());
            break;
          case 1:
            mutant[at] = static_cast<char>(random() % 2 == 0 ? 0xFF : 0);
            break;
          case 2:
            mutant.erase(at, 1 + random() % 8);
            break;
          default:
            mutant.insert(at, mutant.substr(random() % mutant.size(), random() % 30));
        }
        if (mutant.empty()) mutant = "x";
      }
      try_to_read(mutant);
    }
  }
}

// Curve nodes and layers that all share one another would give far more tracks than connections.
TEST(FbxDamage, SharedCurvesTakeBoundedTime) {
  FbxSceneBuilder file;
  std::vector<std::int64_t> models;
  for (int m = 0; m < 2000; ++m) models.push_back(file.model("m", "LimbNode", 0, {0, 0, 0}));
  const auto [stack, layer] = file.take("t");
  file.curve(layer, models[0], "Lcl Translation", "d|X", {{0, 1}, {0, 1}});
  const std::int64_t node = file.next - 2;
  for (const std::int64_t model : models) file.connect(node, model, "Lcl Rotation");
  for (int i = 0; i < 2000; ++i) file.connect(node, layer);
  expect_refused(file.binary(), "share too many curves");
}
