// Jaw and eyes that are joints of a character's rig.

#include "scenes/character/face_joints.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "motion/formats/numpy/npz.h"
#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "motion/skeleton/clip.h"
#include "pipeline/temporary_folder.h"
#include "scenes/face/character_face.h"
#include "scenes/face_figure.h"
#include "scenes/fbx_of_gltf.h"
#include "scenes/skinned_gltf.h"
#include "scenes/stage/actor.h"

namespace mien::scenes {
namespace {

using mien::test::FaceFormat;
using mien::test::TemporaryFolder;
using motion::Quat;
using motion::Vec3;

Character jointed_character(FaceFormat format = FaceFormat::joints) {
  return scaled_to_body(parse_character(mien::test::face_figure_glb(format), "face.glb"),
                        motion::standard_body());
}

/// The head turned about all axes.
motion::Pose pose_of_jointed() {
  motion::Pose pose;
  pose.root_position = Vec3(0.1, 1.0, -0.2);
  pose.rotations.assign(motion::body_joint_count, Quat::Identity());
  pose.rotations[motion::Head] = motion::exp(Vec3(0.2, 0.7, -0.1));
  return pose;
}

int joint_of_face(const Character& character, FaceJoint joint) {
  return character.face.joints[static_cast<std::size_t>(joint)];
}

/// How a joint of the face is turned on the head, in the head's axes.
Quat turn_on_head(const Character& character, const FaceTurns& turns, FaceJoint joint) {
  const motion::JointTransforms rig = rig_pose(character, pose_of_jointed(), turns);
  const auto own = static_cast<std::size_t>(joint_of_face(character, joint));
  const auto head = static_cast<std::size_t>(character.rig.joints[own].parent);
  const Quat& axes = character.bind_rotations[motion::Head];
  return axes.conjugate() * rig.rotations[head].conjugate() * rig.rotations[own] * axes;
}

/// Where a point of the head's bind pose is, seen from the turned head, if it follows a joint.
Vec3 moved(const Character& character, const FaceTurns& turns, FaceJoint joint, const Vec3& at) {
  const motion::JointTransforms bind = rig_bind_pose(character);
  const JointMotions with = joint_motions(bind, rig_pose(character, pose_of_jointed(), turns));
  const JointMotions without = joint_motions(bind, rig_pose(character, pose_of_jointed()));
  const auto own = static_cast<std::size_t>(joint_of_face(character, joint));
  return without[own].inverse() * (with[own] * at);
}

TEST(FaceJoints, AreKnownByTheNamesOfCommonRigs) {
  for (const char* name : {"jaw", "Jaw", "mixamorig:Jaw", "lowerJaw", "CC_Base_JawRoot", "DEF-jaw",
                           "FACIAL_C_Jaw", "jaw_master"})
    EXPECT_EQ(face_joint_named(name), FaceJoint::jaw) << name;
  for (const char* name : {"leftEye", "LeftEye", "mixamorig:LeftEye", "left_eye_smplhf", "eye.L",
                           "lEye", "J_Adj_L_FaceEye", "CC_Base_L_Eye", "FACIAL_L_Eye"})
    EXPECT_EQ(face_joint_named(name), FaceJoint::left_eye) << name;
  EXPECT_EQ(face_joint_named("right_eye_smplhf"), FaceJoint::right_eye);
  EXPECT_EQ(face_joint_named("J_Adj_R_FaceEye"), FaceJoint::right_eye);
  for (const char* name : {"LeftEyelid", "LeftEye_End", "LeftBrow", "Head", "eye", "JawEnd",
                           "LeftEyeBrow", "tongue", "joint_7"})
    EXPECT_EQ(face_joint_named(name), std::nullopt) << name;
}

TEST(FaceJoints, GiveAFaceWithoutMorphTargetsItsControls) {
  const Character character = jointed_character();
  EXPECT_EQ(character.face.morph_count, 0);
  EXPECT_EQ(face_names(character.face),
            (std::vector<std::string>{"jawOpen", "eyeLookUpLeft", "eyeLookUpRight",
                                      "eyeLookDownLeft", "eyeLookDownRight", "eyeLookInLeft",
                                      "eyeLookInRight", "eyeLookOutLeft", "eyeLookOutRight",
                                      "lookUp", "lookDown", "lookLeft", "lookRight"}));
  EXPECT_NE(mien::test::refusal_of([&] {
              face_pose(character, {{"jaw_pose_x", 0.5}});
            }).find("its face has no \"jaw_pose_x\""),
            std::string::npos);
  // A face of targets has no joints, so that its own jawOpen remains.
  const Character targets = jointed_character(FaceFormat::gltf);
  EXPECT_EQ(control_named(targets.face, "lookLeft"), nullptr);
  EXPECT_EQ(control_named(targets.face, "jaw_pose_x"), nullptr);
}

TEST(FaceJoints, AreOnlyThoseThatMoveVerticesOfTheHead) {
  Character character = jointed_character();
  for (SkinnedMesh& mesh : character.meshes)
    for (auto& influences : mesh.influences)
      for (Influence& one : influences)
        if (one.joint == joint_of_face(character, FaceJoint::left_eye)) one.joint = motion::Head;
  character.face = {};
  add_face_joints(character);
  EXPECT_EQ(joint_of_face(character, FaceJoint::left_eye), -1);
  EXPECT_GE(joint_of_face(character, FaceJoint::right_eye), 0);
  EXPECT_EQ(control_named(character.face, "eyeLookUpLeft"), nullptr);
  EXPECT_NE(control_named(character.face, "lookLeft"), nullptr);
  const FaceTurns turns = face_pose(character, {{"lookLeft", 1.0}}).turns;
  EXPECT_EQ(turns[FaceJoint::left_eye], Vec3(Vec3::Zero()));
}

TEST(FaceJoints, AreFoundInFbxFiles) {
  const std::string gltf = mien::test::text_of_glb(mien::test::face_figure_glb(FaceFormat::joints));
  const Character character = scaled_to_body(
      parse_character(mien::test::fbx_of_gltf(gltf).binary(), "face.fbx"), motion::standard_body());
  const Character same = jointed_character();
  EXPECT_EQ(face_names(character.face), face_names(same.face));
  const FacePose open = face_pose(character, {{"jawOpen", 1.0}, {"lookLeft", 1.0}});
  for (const FaceJoint joint : {FaceJoint::jaw, FaceJoint::left_eye, FaceJoint::right_eye})
    EXPECT_LT(turn_on_head(character, open.turns, joint)
                  .angularDistance(turn_on_head(same, open.turns, joint)),
              1e-6);
}

TEST(FaceJoints, LeaveNamesToMorphTargets) {
  Character character = jointed_character();
  character.face.controls = {{"JawOpen", {{0, 1.0}}}, {"lookUp", {}}};
  character.face.morph_count = 1;
  add_face_joints(character);
  EXPECT_EQ(face_pose(character, {{"jawOpen", 1.0}}).turns, FaceTurns());
  EXPECT_EQ(morph_weights(character, {{"jawOpen", 0.5}}), (std::vector<double>{0.5}));
  // An expression that moves no target turns the joints.
  EXPECT_LT(face_pose(character, {{"lookUp", 1.0}}).turns[FaceJoint::left_eye].x(), -0.4);
}

TEST(AJaw, OpensDownAndBackAboutItsJoint) {
  const Character character = jointed_character();
  const auto jaw = static_cast<std::size_t>(joint_of_face(character, FaceJoint::jaw));
  const Vec3 hinge = rig_bind_pose(character).positions[jaw];
  const Vec3 chin = hinge + Vec3(0.0, -0.06, 0.08);
  const FaceTurns open = face_pose(character, {{"jawOpen", 1.0}}).turns;
  const Vec3 at = moved(character, open, FaceJoint::jaw, chin);
  EXPECT_LT(at.y(), chin.y() - 0.02);
  EXPECT_LT(at.z(), chin.z() - 0.02);
  EXPECT_NEAR(at.x(), chin.x(), 1e-9);
  EXPECT_NEAR((at - hinge).norm(), (chin - hinge).norm(), 1e-9);
  const double angle = std::acos((at - hinge).normalized().dot((chin - hinge).normalized()));
  EXPECT_NEAR(angle, 20.0 * motion::radians_per_degree, 1e-6);
  const FaceTurns half = face_pose(character, {{"jawOpen", 0.5}}).turns;
  EXPECT_NEAR(half[FaceJoint::jaw].x(), 0.5 * open[FaceJoint::jaw].x(), 1e-15);
}

/// Where an eye looks, in the head's axes.
Vec3 gaze(const Character& character, const FaceWeights& weights, FaceJoint eye) {
  return turn_on_head(character, face_pose(character, weights).turns, eye) * Vec3::UnitZ();
}

TEST(Eyes, LookWhereTheirWeightsSay) {
  const Character character = jointed_character();
  const double aside = std::sin(30.0 * motion::radians_per_degree);
  const double high = std::sin(25.0 * motion::radians_per_degree);
  constexpr FaceJoint left = FaceJoint::left_eye, right = FaceJoint::right_eye;
  const auto expect = [&](const FaceWeights& weights, double left_x, double right_x, double y) {
    const Vec3 of_left = gaze(character, weights, left), of_right = gaze(character, weights, right);
    EXPECT_NEAR(of_left.x(), left_x, 1e-9) << weights.front().first;
    EXPECT_NEAR(of_right.x(), right_x, 1e-9) << weights.front().first;
    EXPECT_NEAR(of_left.y(), y, 1e-9) << weights.front().first;
  };
  // To the left, the left eye turns outwards and the right one inwards.
  expect({{"eyeLookOutLeft", 1.0}, {"eyeLookInRight", 1.0}}, aside, aside, 0.0);
  expect({{"eyeLookInLeft", 1.0}, {"eyeLookOutRight", 1.0}}, -aside, -aside, 0.0);
  expect({{"lookLeft", 1.0}}, aside, aside, 0.0);
  expect({{"lookRight", 1.0}}, -aside, -aside, 0.0);
  expect({{"eyeLookInLeft", 1.0}, {"eyeLookInRight", 1.0}}, -aside, aside, 0.0);
  expect({{"eyeLookUpLeft", 1.0}}, 0.0, 0.0, high);
  expect({{"eyeLookDownLeft", 1.0}}, 0.0, 0.0, -high);
  expect({{"lookUp", 1.0}}, 0.0, 0.0, high);
  EXPECT_NEAR(gaze(character, {{"lookUp", 1.0}}, right).y(), high, 1e-9);
  EXPECT_NEAR(gaze(character, {{"eyeLookUpLeft", 1.0}}, right).y(), 0.0, 1e-12);
}

TEST(FaceJoints, KeepEveryByteAtZero) {
  const Character character = jointed_character();
  const FacePose zero = face_pose(character, {{"jawOpen", 0.0}, {"lookLeft", 0.0}});
  const auto plain = posed(character, pose_of_jointed());
  const auto still = posed(character, pose_of_jointed(), zero.morphs, zero.turns);
  for (std::size_t m = 0; m < plain.size(); ++m) EXPECT_EQ(plain[m].positions, still[m].positions);
}

/// A file of SMPL-X with 165 numbers a frame at 10 frames per second, the first frame at rest, and
/// in the second frame these rotation vectors of the face.
std::string smplx_file(const Vec3& jaw, const Vec3& left_eye) {
  std::vector<double> numbers(std::size_t{2} * 165, 0.0);
  std::ranges::copy(jaw, numbers.begin() + 165 + 66);
  std::ranges::copy(left_eye, numbers.begin() + 165 + 69);
  const double rate[] = {10.0};
  const std::vector<motion::NamedArray> arrays = {{"poses", motion::array_of(numbers, {2, 165})},
                                                  {"mocap_frame_rate", motion::array_of(rate, {})}};
  return motion::to_npz(arrays);
}

TEST(FaceJoints, TakeTheRotationsOfSmplX) {
  const TemporaryFolder folder;
  const Vec3 jaw(0.31, -0.04, 0.02), eye(-0.1, 0.25, 0.0);
  Face face;
  face.file = folder.path() / "talk.npz";
  std::ofstream(face.file, std::ios::binary) << smplx_file(jaw, eye);
  const Character character = jointed_character();
  const FaceMotion motion(character, face, 3, 20.0);
  EXPECT_TRUE(motion.warnings().empty());
  EXPECT_EQ(motion.turns_at(0), FaceTurns());
  const auto expect_turn = [&](FaceJoint joint, const Vec3& turn) {
    const Quat is = turn_on_head(character, motion.turns_at(2), joint);
    EXPECT_LT(is.angularDistance(motion::exp(turn)), 1e-6);
  };
  expect_turn(FaceJoint::jaw, jaw);
  expect_turn(FaceJoint::left_eye, eye);
  expect_turn(FaceJoint::right_eye, Vec3::Zero());
  EXPECT_LT((motion.turns_at(1)[FaceJoint::jaw] - 0.5 * jaw).norm(), 1e-12);
}

TEST(AnActor, TurnsTheJointsOfItsFace) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "face.glb";
  std::ofstream(file, std::ios::binary) << mien::test::face_figure_glb(FaceFormat::joints);
  motion::Clip clip;
  clip.body = motion::standard_body();
  clip.frames_per_second = 4.0;
  clip.poses.assign(1, pose_of_jointed());
  const auto drawn = [&](const FaceWeights& weights) {
    Face face;
    face.weights = weights;
    const Actor actor =
        make_actor(clip, with_face(CharacterOptions{file, {}}, face), Role::neutral);
    render::Scene scene;
    add_actor(scene, actor, 0, 0, {});
    return scene.solids.meshes;
  };
  const auto moved_vertices = [&](const FaceWeights& weights) {
    const auto plain = drawn({}), changed = drawn(weights);
    int moved = 0;
    for (std::size_t m = 0; m < plain.size(); ++m)
      for (std::size_t v = 0; v < plain[m].positions.size(); ++v)
        moved += (plain[m].positions[v] - changed[m].positions[v]).norm() > 1e-3f;
    return moved;
  };
  EXPECT_GT(moved_vertices({{"jawOpen", 1.0}}), 500);
  EXPECT_GT(moved_vertices({{"lookLeft", 1.0}}), 500);
  EXPECT_EQ(moved_vertices({{"jawOpen", 0.0}}), 0);
}

}  // namespace
}  // namespace mien::scenes
