#include <cmath>

#include <gtest/gtest.h>

#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_files.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/math/rotation.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/floor.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// Where +Y and +Z of ours are in a file of +Z up.
Mat3 to_z_up() {
  Mat3 turn;
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return turn;
}

Clip built_in_walk(const std::string& name) {
  for (const Example& example : builtin_examples("walks-10").examples)
    if (example.name == name) return repeated(example.clip, 3);
  throw std::runtime_error("there is no walk " + name);
}

/// How far two motions are apart: joints in metres, rotations of the world in degrees.
struct Difference {
  double metres = 0.0;
  double degrees = 0.0;
};

Difference difference(const Clip& a, const Clip& b) {
  Difference worst;
  for (std::size_t t = 0; t < a.poses.size(); ++t) {
    const JointTransforms of_a = world_transforms(a.body, a.poses[t]);
    const JointTransforms of_b = world_transforms(b.body, b.poses[t]);
    for (std::size_t j = 0; j < body_joint_count; ++j) {
      if (j == LeftToe || j == RightToe) continue;  // to_body bends toes at the floor
      worst.metres = std::max(worst.metres, (of_a.positions[j] - of_b.positions[j]).norm());
      worst.degrees = std::max(
          worst.degrees, angle_between(of_a.rotations[j], of_b.rotations[j]) / radians_per_degree);
    }
  }
  return worst;
}

Recording standing(std::size_t joints, const Mat3& to_file) {
  Clip clip;
  clip.body = standard_body();
  Pose pose;
  pose.root_position = {0.3, 0.96, -0.2};
  pose.rotations.assign(body_joint_count, Quat::Identity());
  clip.poses.assign(10, pose);
  return parse_smpl(npz_file(amass_members(smpl_motion(clip, joints, to_file), 30.0)), "t.npz");
}

TEST(SmplMapping, ATPoseIsTheCanonicalTPoseAndLeftStaysLeft) {
  for (const std::size_t joints : {22U, 24U, 52U, 55U})
    for (const Mat3& to_file : {Mat3(Mat3::Identity()), to_z_up()}) {
      const Recording recording = standing(joints, to_file);
      const BodyMapping mapping = recognise(recording);
      EXPECT_GE(mapping.confidence, 0.9);
      EXPECT_EQ(mapping.rig, "smpl");
      EXPECT_EQ(mapping.up, to_file(1, 1) == 1 ? "+Y" : "+Z");
      EXPECT_EQ(mapping.metres_per_unit, 1.0);
      for (std::size_t j = 0; j < 22; ++j) {
        if (smpl_to_body[j] < 0) continue;
        EXPECT_EQ(mapping.joints[static_cast<std::size_t>(smpl_to_body[j])].position,
                  static_cast<int>(j));
      }
      const Clip clip = to_body(recording, mapping);
      for (const Quat& rotation : clip.poses[5].rotations)
        EXPECT_LT(angle_between(rotation, Quat::Identity()), 1e-6);
      const std::vector<Vec3> places = world_positions(clip.body, clip.poses[5]);
      EXPECT_GT(places[LeftWrist].x(), places[RightWrist].x() + 1.0);
      EXPECT_GT(places[LeftToe].z(), places[LeftAnkle].z());
      EXPECT_NEAR(places[LeftHip].x() - places[RightHip].x(), 0.18, 1e-9);
    }
}

TEST(SmplMapping, AWalkComesBackFromEitherUpAxis) {
  for (const char* name : {"normal", "happy", "sad"}) {
    const Clip walk = built_in_walk(name);
    for (const Mat3& to_file : {Mat3(Mat3::Identity()), to_z_up()})
      for (const std::size_t joints : {24U, 52U, 55U}) {
        const std::string file =
            npz_file(amass_members(smpl_motion(walk, joints, to_file), walk.frames_per_second));
        const Recording recording = parse_smpl(file, "walk.npz");
        const BodyMapping mapping = recognise(recording);
        EXPECT_GE(mapping.confidence, 0.9);
        const Clip clip = to_body(recording, mapping);
        ASSERT_EQ(clip.poses.size(), walk.poses.size());
        const Difference off = difference(walk, clip);
        EXPECT_LT(off.metres, 0.0001) << name << " " << joints;
        EXPECT_LT(off.degrees, 0.01) << name << " " << joints;
      }
  }
}

TEST(AmassFile, WhatIsWrittenIsTheSameMotion) {
  for (const char* name : {"normal", "angry", "tired"}) {
    const Clip walk = built_in_walk(name);
    const std::string file = to_amass_npz(to_recording(walk));
    EXPECT_EQ(file, to_amass_npz(to_recording(walk)));
    const Recording read = parse_smpl(file, "walk.npz");
    EXPECT_EQ(read.frames_per_second, walk.frames_per_second);
    ASSERT_EQ(read.poses.size(), walk.poses.size());
    // +Z up, as in AMASS; every joint of ours but no more than that.
    for (std::size_t t = 0; t < walk.poses.size(); ++t) {
      const std::vector<Vec3> ours = world_positions(walk.body, walk.poses[t]);
      const std::vector<Vec3> theirs = world_positions(read.skeleton, read.poses[t]);
      for (std::size_t j = 0; j < 22; ++j) {
        if (smpl_to_body[j] < 0) continue;
        const Vec3 expected = to_z_up() * ours[static_cast<std::size_t>(smpl_to_body[j])];
        EXPECT_LT((theirs[j] - expected).norm(), 1e-9) << name << " " << smpl_names[j];
      }
      EXPECT_TRUE(read.poses[t].rotations[6].isApprox(Quat::Identity()));
    }
    const Difference off = difference(walk, to_body(read));
    EXPECT_LT(off.metres, 0.0001) << name;
    EXPECT_LT(off.degrees, 0.01) << name;
  }
}

TEST(AmassFile, HasTheArraysOfAmass) {
  const Clip walk = built_in_walk("normal");
  const Npz npz = parse_npz(to_amass_npz(to_recording(walk)), "a.npz");
  const std::size_t frames = walk.poses.size();
  using Shape = std::vector<std::size_t>;
  EXPECT_EQ(find_array(npz, "poses")->shape, (Shape{frames, 156}));
  EXPECT_EQ(find_array(npz, "trans")->shape, (Shape{frames, 3}));
  EXPECT_EQ(find_array(npz, "betas")->shape, (Shape{16}));
  EXPECT_EQ(find_array(npz, "dmpls")->shape, (Shape{frames, 8}));
  EXPECT_EQ(texts_of(*find_array(npz, "gender"), {}).front(), "neutral");
  EXPECT_EQ(numbers_of(*find_array(npz, "mocap_framerate"), {}).front(), walk.frames_per_second);
}

TEST(AmassFile, OtherSkeletonsAreRefused) {
  Recording recording = to_recording(built_in_walk("normal"));
  recording.skeleton.joints.pop_back();
  EXPECT_NE(refusal_of([&] { to_amass_npz(recording); }).find("not those of the canonical body"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
