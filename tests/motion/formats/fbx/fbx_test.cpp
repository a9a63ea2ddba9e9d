#include "motion/formats/fbx/fbx.h"

#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/formats/format_checks.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/text/file_contents.h"

#include "real_data.h"

using namespace mien::motion;
using mien::test::expect_near;
using mien::test::fbx_arm;
using mien::test::fbx_second;
using mien::test::FbxSceneBuilder;
using mien::test::tip_at;

namespace {

const double half = std::sqrt(0.5);

Recording read(const FbxSceneBuilder& file, const ReadOptions& options = {}) {
  return parse_fbx(file.binary(), "some/arm.fbx", options);
}

void expect_arm(const Recording& recording) {
  EXPECT_EQ(recording.name, "arm");
  EXPECT_EQ(recording.format, "fbx");
  EXPECT_EQ(recording.take, "bend");
  EXPECT_EQ(recording.frames_per_second, 30.0);
  ASSERT_EQ(recording.frame_count(), 31);
  ASSERT_EQ(recording.skeleton.size(), 2);
  EXPECT_EQ(recording.skeleton.joints[1].name, "fore");
  EXPECT_TRUE(recording.poses[0].offsets.empty());
  expect_near(tip_at(recording, 0, 1), {0, 3, 0});
  expect_near(tip_at(recording, 15, 1), {2.0 - half, 2.0 + half, 0}, 1e-9);
  expect_near(tip_at(recording, 30, 1), {3, 2, 0}, 1e-9);
}

/// x of the root, in the file's unit, at the frames of a take in which a curve moves it.
std::vector<double> curve_at(const FbxSceneBuilder::Keys& keys, double frames_per_second) {
  FbxSceneBuilder file;
  const std::int64_t bone = file.model("bone", "LimbNode", 0, {0, 0, 0});
  const auto [stack, layer] = file.take("t");
  file.curve(layer, bone, "Lcl Translation", "d|X", keys);
  ReadOptions options;
  options.frames_per_second = frames_per_second;
  std::vector<double> values;
  for (const Pose& pose : read(file, options).poses)
    values.push_back(100.0 * pose.root_position.x());
  return values;
}

float packed_weights(unsigned right, unsigned left) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(right | left << 16));
}

}  // namespace

TEST(Fbx, IsTheSameInEveryEncoding) {
  const FbxSceneBuilder arm = fbx_arm();
  for (const int version : {7100, 7400, 7500, 7700}) {
    for (const bool deflates : {false, true}) {
      SCOPED_TRACE(version);
      expect_arm(parse_fbx(arm.binary(version, deflates), "some/arm.fbx"));
    }
  }
  expect_arm(parse_fbx(arm.text(), "some/arm.fbx"));
}

TEST(Fbx, TurnsAndScalesTheFilesAxesAndUnit) {
  FbxSceneBuilder arm = fbx_arm();
  // Z up, −Y to the front, inches.
  arm.settings.children = {arm.setting("UpAxis", 2), arm.setting("FrontAxis", 1),
                           arm.setting("FrontAxisSign", -1),
                           arm.property("UnitScaleFactor", {2.54})};
  const Recording recording = read(arm);
  // x stays, y is −z, z is y.
  expect_near(tip_at(recording, 0, 1), {0, 0, -3.0 * 2.54}, 1e-9);
  expect_near(tip_at(recording, 30, 1), {3.0 * 2.54, 0, -2.0 * 2.54}, 1e-9);
}

TEST(Fbx, MirrorsLeftHandedFiles) {
  FbxSceneBuilder arm = fbx_arm();
  arm.settings.children = {arm.setting("CoordAxisSign", -1)};
  const Recording recording = read(arm);
  expect_near(tip_at(recording, 15, 1), {-2.0 + half, 2.0 + half, 0}, 1e-9);
  for (const Quat& rotation : recording.poses[15].rotations) {
    EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
  }
}

TEST(Fbx, KeepsPositionsUnderScalesPivotsAndInheritance) {
  for (const std::int64_t inherit : {0, 1, 2}) {
    SCOPED_TRACE(inherit);
    FbxSceneBuilder file;
    using Numbers = FbxSceneBuilder::Numbers;
    const std::int64_t top =
        file.model("top", "Null", 0, {100, 0, 0}, {file.property("Lcl Scaling", Numbers{2, 2, 2})});
    const std::int64_t a = file.model("a", "LimbNode", top, {0, 100, 0},
                                      {file.property("Lcl Scaling", Numbers{1, 3, 1})});
    const std::int64_t b = file.model(
        "b", "LimbNode", a, {0, 100, 0},
        {file.setting("InheritType", inherit), file.property("RotationPivot", Numbers{0, 50, 0}),
         file.property("Lcl Rotation", Numbers{0, 0, 90})});
    file.model("c", "LimbNode", b, {0, 100, 0});
    const Recording recording = read(file);
    ASSERT_EQ(recording.skeleton.size(), 3);
    const std::vector<Vec3> world = world_positions(recording.skeleton, recording.poses[0]);
    expect_near(world[0], {1, 2, 0}, 1e-9);
    // b: its pivot is 150 above a; the turn takes its origin to 50 in x beside the pivot. The
    // scales of a and top (2, 6, 2) apply to that.
    expect_near(world[1], {1 + 2 * 0.5, 2 + 6 * 1.5, 0}, 1e-9);
    // c is 100 along b's y, which points to −x of a: scaled after the turn by a (RSrs: 2 along x),
    // along b's own y (RrSs: 6) or without a's own scale (Rrs: 2).
    const double length = inherit == 0 ? 6.0 : 2.0;
    expect_near(world[2], {2 - length, 11, 0}, 1e-9);
  }
}

TEST(Fbx, HoldsConstantKeysAndTakesTheNextValueIfToldSo) {
  EXPECT_EQ(curve_at({{0, 1}, {1, 5}, {0x2}}, 2.0), (std::vector<double>{1, 1, 5}));
  EXPECT_EQ(curve_at({{0, 1}, {1, 5}, {0x102}}, 2.0), (std::vector<double>{1, 5, 5}));
}

TEST(Fbx, FollowsCubicCurves) {
  // Slopes 3 and −2 per second at the ends of two seconds: the Hermite polynomial.
  const std::vector<double> x = curve_at({{0, 2}, {1, 5}, {0x408}, {3, -2, 0, 0}}, 2.0);
  ASSERT_EQ(x.size(), 5u);
  for (int f = 0; f < 5; ++f) {
    const double t = f / 4.0;
    const double expected = (2 * t * t * t - 3 * t * t + 1) * 1 + (t * t * t - 2 * t * t + t) * 6 +
                            (3 * t * t - 2 * t * t * t) * 5 + (t * t * t - t * t) * -4;
    EXPECT_NEAR(x[static_cast<size_t>(f)], expected, 1e-5) << f;
  }
}

TEST(Fbx, FollowsWeightedCubicCurves) {
  // Flat tangents, 0.9 and 0.1 of a second long: at the parameter 0.5 the Bézier curve is at
  // (1/8)(3·0.9 + 3·0.9 + 1) = 0.8 s and half way up.
  const std::vector<double> x =
      curve_at({{0, 1}, {0, 8}, {0x3000408}, {0, 0, packed_weights(8999, 1000), 0}}, 5.0);
  EXPECT_NEAR(x[4], 4.0, 2e-3);
}

TEST(Fbx, FindsAutomaticTangents) {
  // In the middle the slope is (3 − 0) / 2 s; at the ends it is 0.
  const std::vector<double> x = curve_at({{0, 1, 2}, {0, 1, 3}, {0x108}}, 2.0);
  ASSERT_EQ(x.size(), 5u);
  EXPECT_NEAR(x[1], 0.5 - 1.5 / 8.0, 1e-6);
  EXPECT_NEAR(x[3], 2.0 + 1.5 / 8.0, 1e-6);
  // Clamped, a key between equal or turning ones is flat.
  EXPECT_NEAR(curve_at({{0, 1, 2}, {0, 1, 0.5}, {0x6108}}, 2.0)[1], 0.5, 1e-6);
}

TEST(Fbx, KeepsTheStatedSlopeBeforeAKeyThatFollowsAnAutomaticOne) {
  // The first key is automatic (flat at the end), the second one is linear: the curve arrives at it
  // with the slope of 4 per second that is stored with the first one.
  const std::vector<double> x =
      curve_at({{0, 1}, {0, 1}, {0x108, 0x4}, {0, 4, 0, 0, 0, 0, 0, 0}, {1, 1}}, 2.0);
  EXPECT_NEAR(x[1], 0.5 - 4.0 / 8.0, 1e-6);
}

TEST(Fbx, GivesRunsOfKeysTheirForms) {
  // Two constant keys, then linear.
  const std::vector<double> x =
      curve_at({{0, 1, 2, 3}, {0, 4, 8, 12}, {0x2, 0x4}, {0, 0, 0, 0, 0, 0, 0, 0}, {2, 2}}, 2.0);
  EXPECT_EQ(x, (std::vector<double>{0, 0, 4, 4, 8, 10, 12}));
}

TEST(Fbx, ChoosesTheFirstTakeThatMovesTheFigure) {
  FbxSceneBuilder file;
  const std::int64_t bone = file.model("bone", "LimbNode", 0, {0, 0, 0});
  const std::int64_t camera = file.model("eye", "Camera", 0, {0, 0, 0});
  const auto still = file.take("still").second;
  file.curve(still, bone, "Lcl Translation", "d|X", {{0, 1}, {7, 7}});
  const auto pan = file.take("pan").second;
  file.curve(pan, camera, "Lcl Translation", "d|X", {{0, 1}, {0, 7}});
  for (const double end : {10.0, 20.0}) {
    const auto walk = file.take("walk").second;
    file.curve(walk, bone, "Lcl Translation", "d|X", {{0, 1}, {0, static_cast<float>(end)}});
  }
  const Recording first = read(file);
  EXPECT_EQ(first.take, "walk");
  EXPECT_EQ(first.takes, (std::vector<std::string>{"still", "pan", "walk", "walk 2"}));
  EXPECT_NEAR(first.poses.back().root_position.x(), 0.1, 1e-9);
  ASSERT_EQ(first.notes.size(), 1u);
  EXPECT_NE(first.notes[0].find("4 motions"), std::string::npos);
  ReadOptions options;
  options.take = "walk 2";
  EXPECT_NEAR(read(file, options).poses.back().root_position.x(), 0.2, 1e-9);
  options.take = "run";
  const std::string refusal = mien::test::refusal_of([&] { read(file, options); });
  EXPECT_NE(refusal.find("there is no take \"run\""), std::string::npos) << refusal;
}

TEST(Fbx, SamplesTheTakesSpanAtTheRateOfTheKeysOrTheTimeMode) {
  FbxSceneBuilder file;
  const std::int64_t bone = file.model("bone", "LimbNode", 0, {0, 0, 0});
  const auto layer = file.take("t", fbx_second, 3 * fbx_second).second;
  FbxSceneBuilder::Keys keys;
  for (int k = 0; k <= 240; ++k) {
    keys.seconds.push_back(k / 60.0);
    keys.values.push_back(static_cast<float>(k));
  }
  file.curve(layer, bone, "Lcl Translation", "d|X", keys);
  file.settings.children = {file.setting("TimeMode", 11)};
  const Recording sixty = read(file);
  EXPECT_EQ(sixty.frames_per_second, 60.0);
  EXPECT_EQ(sixty.frame_count(), 121);
  EXPECT_NEAR(sixty.poses.front().root_position.x(), 0.60, 1e-9);
  ASSERT_EQ(sixty.notes.size(), 1u);
  EXPECT_NE(sixty.notes[0].find("24 frames per second"), std::string::npos);
  file.settings.children = {file.setting("TimeMode", 1)};
  ReadOptions options;
  options.frames_per_second = 10.0;
  EXPECT_EQ(read(file, options).frames_per_second, 120.0);
}

/// The arm, and a figure of four joints that stands still.
FbxSceneBuilder fbx_of_two_figures() {
  FbxSceneBuilder file = fbx_arm();
  std::int64_t parent = 0;
  for (const char* name : {"hips", "spine", "neck", "head"}) {
    parent = file.model(name, "LimbNode", parent, {0, 50, 0});
  }
  return file;
}

TEST(Fbx, ReadsTheFigureThatIsAskedFor) {
  const FbxSceneBuilder file = fbx_of_two_figures();
  const Recording alone = read(fbx_arm());
  ReadOptions options;
  for (const char* wanted : {"upper", "1"}) {
    options.subject = wanted;
    const Recording arm = read(file, options);
    EXPECT_EQ(arm.subject, "upper");
    EXPECT_EQ(arm.subjects, (std::vector<std::string>{"upper", "hips"}));
    EXPECT_TRUE(arm.notes.empty());
    EXPECT_EQ(mien::test::largest_joint_distance(arm, alone), 0.0);
  }
  // Both have the time of the take, though only one moves.
  options.subject = "hips";
  EXPECT_EQ(read(file, options).frame_count(), alone.frame_count());
  options.subject = "tail";
  const std::string said = mien::test::refusal_of([&] { read(file, options); });
  EXPECT_NE(said.find("there is no subject \"tail\"; it holds upper, hips"), std::string::npos)
      << said;
}

TEST(Fbx, UsesTheLargerOfTwoFigures) {
  const FbxSceneBuilder file = fbx_of_two_figures();
  const Recording recording = read(file);
  EXPECT_EQ(recording.skeleton.size(), 4);
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_NE(recording.notes[0].find("upper"), std::string::npos) << recording.notes[0];
}

TEST(Fbx, GivesJointsDifferentNames) {
  FbxSceneBuilder file;
  std::int64_t parent = 0;
  for (const char* name : {"bone", "bone", "bone 2", "bone", ""}) {
    parent = file.model(name, "LimbNode", parent, {0, 50, 0});
  }
  std::vector<std::string> names;
  for (const Joint& joint : read(file).skeleton.joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"bone", "bone 2", "bone 2 2", "bone 3", "joint_4"}));
}

TEST(Fbx, AddsLayers) {
  FbxSceneBuilder arm = fbx_arm();
  const std::int64_t stack = 1003;
  const std::int64_t upper = 1000;
  const std::int64_t layer = arm.layer(stack, {arm.property("Weight", {50.0})});
  arm.curve(layer, upper, "Lcl Translation", "d|Y", {{0, 1}, {0, 100}});
  const Recording recording = read(arm);
  EXPECT_EQ(recording.notes.size(), 1u);
  expect_near(recording.poses[30].root_position, {4, 0.5, 0}, 1e-9);
  expect_near(recording.poses[15].root_position, {2, 0.25, 0}, 1e-9);
}

TEST(Fbx, ReadsOldTakes) {
  const std::string text = R"(; FBX 6.1.0 project file
FBXHeaderExtension:  {
  FBXVersion: 6100
}
Objects:  {
  Model: "Model::say &quot;bone&quot;", "Limb" {
    Properties60:  {
      Property: "Lcl Translation", "Lcl Translation", "A+",1,2,3
    }
    Shading: W
  }
}
Connections:  {
  Connect: "OO", "Model::say &quot;bone&quot;", "Model::Scene"
}
Takes:  {
  Current: "Walk"
  Take: "Walk" {
    LocalTime: 0,92372316000
    Model: "Model::say &quot;bone&quot;" {
      Channel: "Transform" {
        Channel: "T" {
          Channel: "X" {
            Default: 1
            KeyVer: 4005
            KeyCount: 3
            Key: 
              0,100,U,s,0,0,n
              ,46186158000,200,C,s,92372316000,300,L
          }
          Channel: "Y" { 
            Default: 50
          }
          LayerType: 1
        }
      }
    }
  }
}
)";
  ReadOptions options;
  options.frames_per_second = 2.0;
  const Recording recording = parse_fbx(text, "old.fbx", options);
  EXPECT_EQ(recording.takes, std::vector<std::string>{"Walk"});
  EXPECT_EQ(recording.skeleton.joints[0].name, "say \"bone\"");
  ASSERT_EQ(recording.frame_count(), 5);
  const double x[] = {1.0, 1.5, 2.0, 2.0, 3.0};
  for (size_t f = 0; f < 5; ++f) {
    expect_near(recording.poses[f].root_position, {x[f], 0.5, 0.03}, 1e-9);
  }
  const std::string wrong = mien::test::replaced(text, "KeyCount: 3", "KeyCount: 4");
  const std::string refusal = mien::test::refusal_of([&] { parse_fbx(wrong, "old.fbx"); });
  EXPECT_NE(refusal.find("old.fbx:27:"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("states 4 keys"), std::string::npos) << refusal;
}

TEST(Fbx, CharactersOfMayaAreRecognisedByName) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  for (const char* name : {"maya_character_7500_binary.fbx", "maya_human_ik_7400_binary.fbx"}) {
    const Recording recording = parse_fbx(read_contents(*data / "recordings/fbx" / name), name);
    EXPECT_EQ(recording.skeleton.size(), 62) << name;
    const BodyMapping mapping = recognise(recording);
    EXPECT_EQ(mapping.rig, "by names") << name;
    EXPECT_NEAR(mapping.metres_per_unit, 1.0, 1e-9) << name;
    EXPECT_EQ(mapping.up, "+Y") << name;
  }
}
