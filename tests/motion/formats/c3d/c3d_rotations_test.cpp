#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/c3d/c3d.h"
#include "motion/formats/c3d/written_c3d.h"
#include "motion/math/rotation.h"
#include "motion/refusal.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {
namespace {

using mien::test::refusal_of;
using mien::test::WrittenC3d;

struct Segment {
  JointTransform transform;
  double mark = 0.0;
};

/// A file without points whose rotations follow the parameters: 17 floats each, by columns.
std::string rotation_file(const std::vector<std::string>& labels,
                          const std::vector<std::vector<Segment>>& frames, int processor = 84) {
  WrittenC3d file;
  file.processor = processor;
  file.labels.clear();
  file.rate = 85.0;
  const auto with_start = [&](int block) {
    file.more = file.group(5, "ROTATION") +
                file.words(5, "USED", {static_cast<int>(labels.size())}) +
                file.words(5, "DATA_START", {block}) +
                file.words(5, "FRAMES", {static_cast<int>(frames.size())}) +
                file.floats_of(5, "RATE", {170.0}) + file.texts(5, "LABELS", labels);
  };
  with_start(0);
  with_start(file.parameter_blocks() + 2);
  std::string bytes = file.bytes();
  for (const std::vector<Segment>& frame : frames) {
    for (const Segment& segment : frame) {
      const Mat3 turn = segment.transform.rotation.toRotationMatrix();
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          file.put_float(bytes, row == 3      ? (column == 3 ? 1.0 : 0.0)
                                : column == 3 ? segment.transform.position[row]
                                              : turn(row, column));
        }
      }
      file.put_float(bytes, segment.mark);
    }
  }
  return WrittenC3d::in_blocks(bytes);
}

const std::vector<std::string> labels = {"worldbody_4X4", "l_shank_4X4", "r_hand_4X4", "torso_4X4",
                                         "l_thigh_4X4",   "pelvis_4X4",  "r_larm_4X4", "racket"};

std::vector<std::vector<Segment>> random_frames(std::mt19937_64& random, std::size_t count) {
  std::normal_distribution<double> normal;
  std::vector<std::vector<Segment>> frames(count);
  for (auto& frame : frames) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Quat turn(normal(random), normal(random), normal(random), normal(random));
      const Vec3 place(normal(random), normal(random), normal(random));
      frame.push_back({{1000.0 * place, turn.normalized()}, 0.0});
    }
  }
  return frames;
}

TEST(C3dRotations, BecomeASkeletonWhoseSegmentsStandWhereTheFileSays) {
  std::mt19937_64 random(1);
  const std::vector<std::vector<Segment>> frames = random_frames(random, 4);
  for (const int processor : {84, 85, 86}) {
    const std::string bytes = rotation_file(labels, frames, processor);
    EXPECT_TRUE(holds_c3d_rotations(bytes));
    const Recording recording = parse_c3d_rotations(bytes, "some/throw.c3d");
    EXPECT_EQ(recording.name, "throw");
    EXPECT_EQ(recording.format, "c3d");
    EXPECT_EQ(recording.frames_per_second, 170.0);
    ASSERT_TRUE(is_well_formed(recording.skeleton));
    ASSERT_EQ(recording.skeleton.size(), 7);
    EXPECT_EQ(recording.skeleton.joints[0].name, "pelvis");
    const auto parent = [&](const char* name) {
      const Joint& joint =
          recording.skeleton.joints[static_cast<std::size_t>(find_joint(recording.skeleton, name))];
      return recording.skeleton.joints[static_cast<std::size_t>(joint.parent)].name;
    };
    EXPECT_EQ(parent("l_thigh"), "pelvis");
    EXPECT_EQ(parent("l_shank"), "l_thigh");
    EXPECT_EQ(parent("torso"), "pelvis");
    EXPECT_EQ(parent("r_hand"), "r_larm");
    EXPECT_EQ(parent("r_larm"), "torso");  // the upper arm is not in the file
    EXPECT_EQ(parent("racket"), "pelvis");
    ASSERT_EQ(recording.frame_count(), 4);
    for (std::size_t frame = 0; frame < 4; ++frame) {
      const JointTransforms world = world_transforms(recording.skeleton, recording.poses[frame]);
      for (std::size_t i = 1; i < labels.size(); ++i) {
        const std::string name = labels[i].substr(0, labels[i].find("_4X4"));
        const auto j = static_cast<std::size_t>(find_joint(recording.skeleton, name));
        const JointTransform& expected = frames[frame][i].transform;
        EXPECT_LT((world.positions[j] - expected.position).norm(), 1e-2);
        EXPECT_LT(world.rotations[j].angularDistance(expected.rotation), 1e-5);
      }
    }
  }
}

TEST(C3dRotations, MissingSegmentsAreInterpolatedAndTold) {
  std::mt19937_64 random(2);
  std::vector<std::vector<Segment>> frames = random_frames(random, 5);
  frames[0][5].mark = -1.0;
  frames[2][5].mark = -1.0;
  for (auto& frame : frames) frame[7].mark = -1.0;
  frames[3][5].transform = frames[1][5].transform;
  const Recording recording = parse_c3d_rotations(rotation_file(labels, frames), "throw.c3d");
  EXPECT_EQ(find_joint(recording.skeleton, "racket"), -1);
  EXPECT_LT((recording.poses[0].root_position - frames[1][5].transform.position).norm(), 1e-2);
  EXPECT_LT((recording.poses[2].root_position - frames[1][5].transform.position).norm(), 1e-2);
  ASSERT_EQ(recording.notes.size(), 2u);
  EXPECT_EQ(recording.notes[0], "Left out, since they are found in no frame: racket.");
  EXPECT_NE(recording.notes[1].find("pelvis (2)"), std::string::npos);
}

TEST(C3dRotations, AreRefusedWithTheirFault) {
  std::mt19937_64 random(3);
  std::vector<std::vector<Segment>> frames = random_frames(random, 2);
  const std::string bytes = rotation_file(labels, frames);
  EXPECT_NE(refusal_of([&] { parse_c3d(bytes, "a.c3d"); }).find("holds rotations of segments"),
            std::string::npos);
  WrittenC3d points;
  points.frames = {{{{1.0, 2.0, 3.0, 0.0}, {1.0, 2.0, 3.0, 0.0}}}};
  EXPECT_FALSE(holds_c3d_rotations(points.bytes()));
  EXPECT_NE(
      refusal_of([&] { parse_c3d_rotations(points.bytes(), "a.c3d"); }).find("holds no rotations"),
      std::string::npos);
  frames[1][4].transform.rotation.coeffs() *= 1.5;  // longer axes
  EXPECT_NE(refusal_of([&] {
              parse_c3d_rotations(rotation_file(labels, frames), "a.c3d");
            }).find("is not a rotation and a position"),
            std::string::npos);
  EXPECT_EQ(parse_c3d_rotations(bytes.substr(0, bytes.size() - 512), "a.c3d").frame_count(), 1);
}

}  // namespace
}  // namespace mien::motion
