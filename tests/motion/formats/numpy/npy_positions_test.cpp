#include "motion/formats/numpy/npy_positions.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/numpy/numpy_files.h"
#include "motion/points/joint_orders.h"
#include "motion/points/joint_points.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/refusal.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {
namespace {

using namespace mien::test;

bool has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

std::string shape_text_of(std::size_t frames, std::size_t joints) {
  return "(" + std::to_string(frames) + ", " + std::to_string(joints) + ", 3)";
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = 0.01 * static_cast<double>(i % 97);
  return numbers;
}

std::string positions(std::size_t frames, std::size_t joints) {
  return npy_f8(shape_text_of(frames, joints), counted(frames * joints * 3));
}

ReadOptions at_30_hz() {
  ReadOptions options;
  options.frames_per_second = 30.0;
  return options;
}

std::string refused(const std::string& file, const ReadOptions& options = at_30_hz()) {
  return refusal_of([&] { parse_npy_positions(file, "a.npy", options); });
}

TEST(NpyPositions, OfHumanMl3DHaveItsRateAndNames) {
  const PointRecording read = parse_npy_positions(positions(5, 22), "012314.npy");
  EXPECT_EQ(read.name, "012314");
  EXPECT_EQ(read.format, "npy");
  EXPECT_EQ(read.frames_per_second, 20.0);
  EXPECT_EQ(read.frame_count(), 5);
  EXPECT_EQ(read.points[1], "left_hip");
  EXPECT_EQ(read.points[21], "right_wrist");
  EXPECT_EQ(read.metres_per_unit, 1.0);
  EXPECT_EQ(read.unit, "m");
  EXPECT_TRUE(has(read.notes[0], "taken to be that of humanml3d"));
  EXPECT_TRUE(has(read.notes[1], "20 Hz, that of HumanML3D, is used"));
  const std::vector<double> numbers = counted(330);
  for (int t = 0; t < 5; ++t)
    for (int j = 0; j < 22; ++j) {
      const std::size_t i = read.at(t, j);
      EXPECT_EQ(read.positions[i], Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
      EXPECT_TRUE(read.seen[i]);
    }
}

TEST(NpyPositions, OrdersAreKnownByTheNumberOfJoints) {
  const auto named = [](std::size_t joints, std::size_t index) {
    return parse_npy_positions(positions(2, joints), "a.npy", at_30_hz()).points[index];
  };
  EXPECT_EQ(named(24, 23), "right_hand");
  EXPECT_EQ(named(17, 4), "left_hip");
  EXPECT_EQ(named(17, 10), "head");
  EXPECT_EQ(named(33, 0), "nose");
  EXPECT_EQ(named(33, 23), "left_hip");
  EXPECT_TRUE(has(refused(positions(2, 19)), "the order of its 19 joints is not known"));
  for (const JointOrder& order : joint_orders()) {
    const std::vector<std::string> names(order.joints.begin(), order.joints.end());
    for (const auto& [from, to] : order.bones) {
      EXPECT_LT(std::max(from, to), static_cast<int>(names.size())) << order.name;
    }
  }
}

/// A standing figure in one of the orders of 25, with some noise: places by the joint's name.
std::string figure_of_25(const JointOrder& order) {
  const auto place = [](std::string_view name) {
    const bool is_left = name.starts_with("left");
    const double side = is_left ? 1 : name.starts_with("right") ? -1 : 0;
    const auto any = [&](std::initializer_list<std::string_view> words) {
      for (const std::string_view word : words)
        if (name.find(word) != name.npos) return true;
      return false;
    };
    if (any({"toe", "foot"})) return Vec3(0.1 * side, 0.03, 0.15);
    if (any({"heel"})) return Vec3(0.1 * side, 0.03, -0.05);
    if (any({"ankle"})) return Vec3(0.1 * side, 0.08, 0);
    if (any({"knee"})) return Vec3(0.1 * side, 0.5, 0);
    if (any({"hip", "base"})) return Vec3(0.1 * side, 0.95, 0);
    if (name == "spine_mid") return Vec3(0, 1.2, 0);
    if (any({"wrist", "hand", "thumb"})) return Vec3(0.2 * side, 0.8, 0.05);
    if (any({"elbow"})) return Vec3(0.2 * side, 1.1, 0);
    if (name == "spine_shoulder" || any({"neck", "shoulder"})) return Vec3(0.18 * side, 1.42, 0);
    return Vec3(0.05 * side, 1.6, 0.05);
  };
  std::mt19937 random(25);
  std::normal_distribution<double> noise(0, 0.005);
  std::vector<double> numbers;
  for (int t = 0; t < 20; ++t)
    for (const std::string_view name : order.joints)
      for (const double number : place(name)) numbers.push_back(number + noise(random));
  return npy_f8("(20, 25, 3)", numbers);
}

TEST(NpyPositions, TheTwoOrdersOf25AreToldApartByTheirBones) {
  for (const char* name : {"kinect", "body_25"}) {
    const PointRecording read =
        parse_npy_positions(figure_of_25(*joint_order(name)), "a.npy", at_30_hz());
    EXPECT_EQ(read.points[0], joint_order(name)->joints[0]);
    EXPECT_TRUE(has(read.notes[0], name));
  }
  EXPECT_TRUE(has(refused(positions(2, 25)), "the order of its 25 joints is not known"));
}

TEST(NpyPositions, NamesMayBeGiven) {
  ReadOptions options = at_30_hz();
  options.joints = {"a", "b", "c"};
  const PointRecording read = parse_npy_positions(positions(2, 3), "a.npy", options);
  EXPECT_EQ(read.points, options.joints);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_TRUE(
      has(refused(positions(2, 4), options), "3 names of joints are given, but the array holds 4"));
  options.joints = {"a", "b", "b"};
  EXPECT_TRUE(has(refused(positions(2, 3), options), "a name of its own"));
  options.joints = {"kinect"};
  EXPECT_EQ(parse_npy_positions(positions(2, 25), "a.npy", options).points[20], "spine_shoulder");
  EXPECT_TRUE(
      has(refused(positions(2, 24), options), "kinect has 25 joints, but the array holds 24"));
}

TEST(NpyPositions, NamesBesideTheArrayAreUsed) {
  const std::vector<std::string> names = {"RightHip", "LeftHip", "Pelvis"};
  const auto read = [](const std::string& npz, const ReadOptions& how = {}) {
    return parse_npy_positions(npz, "a.npz", how);
  };
  const ZipMember joints = {"joints", positions(2, 3)};
  const ZipMember rate = {"fps", npy_f8("()", {50})};
  EXPECT_EQ(read(npz_file({joints, rate, {"names", npy_text(names, 8)}})).points, names);
  EXPECT_EQ(read(npz_file({{"labels", npy_text(names, 8)}, joints, rate})).points, names);
  ReadOptions given;
  given.joints = {"a", "b", "c"};
  EXPECT_EQ(read(npz_file({joints, rate, {"names", npy_text(names, 8)}}), given).points,
            given.joints);
  // Two names for three joints, or one name twice, name nothing.
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"a", "b"}, {"a", "a", "b"}})
    EXPECT_TRUE(has(refused(npz_file({joints, rate, {"names", npy_text(wrong, 8)}})),
                    "the order of its 3 joints is not known"));
  // 22 joints with names of their own are not taken for HumanML3D's: the rate must be given.
  std::vector<std::string> own;
  for (int i = 0; i < 22; ++i) own.push_back("joint" + std::to_string(i));
  EXPECT_TRUE(has(refused(npz_file({{"j", positions(2, 22)}, {"names", npy_text(own, 8)}}), {}),
                  "does not state its frame rate"));
}

TEST(NpyPositions, WhatIsNoNumberIsMissing) {
  std::vector<double> numbers = counted(2 * 22 * 3);
  numbers[3 * 25 + 1] = std::numeric_limits<double>::quiet_NaN();
  const std::string file = npy_f8("(2, 22, 3)", numbers);
  const PointRecording read = parse_npy_positions(file, "a.npy");
  EXPECT_FALSE(read.seen[read.at(1, 3)]);
  EXPECT_EQ(read.positions[read.at(1, 3)], Vec3(0, 0, 0));
  EXPECT_EQ(std::count(read.seen.begin(), read.seen.end(), false), 1);
  numbers[3 * 25 + 1] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(has(refused(npy_f8("(2, 22, 3)", numbers)), "a number in frame 2 that is too large"));
}

TEST(NpyPositions, TheRateIsNeverGuessed) {
  EXPECT_EQ(refused(positions(2, 24), {}),
            "a.npy: does not state its frame rate; state the rate with fps: "
            "(--recorded-fps on the command line)");
  const std::string npz = npz_file({{"fps", npy_f8("()", {50})}, {"joints", positions(2, 24)}});
  EXPECT_EQ(parse_npy_positions(npz, "a.npz").frames_per_second, 50.0);
  EXPECT_EQ(parse_npy_positions(npz, "a.npz", at_30_hz()).frames_per_second, 50.0);
}

TEST(NpyPositions, OfAnNpzFileAreItsOnlySuchArray) {
  const std::string one =
      npz_file({{"text", npy_text({"x"}, 1)}, {"kp", npy_f8("(1, 2, 22, 3)", counted(132))}});
  EXPECT_EQ(parse_npy_positions(one, "a.npz").frame_count(), 2);
  EXPECT_TRUE(has(refused(npz_file({{"a", positions(2, 22)}, {"b", positions(2, 22)}})),
                  "holds several arrays of positions: a, b"));
  EXPECT_TRUE(has(refused(npz_file({{"a", npy_f8("(2,)", {1, 2})}, {"b", npy_f8("()", {1})}})),
                  "holds no array of positions, T × J × 3, but a, b"));
  EXPECT_TRUE(has(refused(npz_file({{"a", npy_file("'|O'", "()", "x")}})),
                  "the array \"a\" holds Python objects"));
}

TEST(NpyPositions, OtherArraysAreRefusedByName) {
  EXPECT_TRUE(has(refused(npy_f8("(2, 263)", counted(526))),
                  "(2, 263), which is that of HumanML3D features, not of positions; recover the "
                  "joints with recover_from_ric(data, 22)"));
  EXPECT_TRUE(has(refused(npy_f8("(2, 251)", counted(502))), "KIT-ML features"));
  EXPECT_TRUE(has(refused(npy_f8("(2, 17, 2)", counted(68))), "in the picture plane (2-D)"));
  EXPECT_TRUE(has(refused(npy_f8("(2, 66)", counted(132))), "(2, 66), which is not T × J × 3"));
  EXPECT_TRUE(has(refused(npy_f8("(2, 2, 22, 3)", counted(264))), "which is not T × J × 3"));
  EXPECT_TRUE(has(refused(npy_f8("(0, 22, 3)", {})), "which is not T × J × 3"));
  EXPECT_TRUE(has(refused(npy_file("'|O'", "()", "x")), "holds Python objects"));
}

TEST(NpyPositions, WhatIsWrittenIsReadAgain) {
  const Clip walk = builtin_examples("walks-10").examples[0].clip;
  ReadOptions options = at_30_hz();
  for (const Joint& joint : walk.body.joints) options.joints.push_back(joint.name);
  const PointRecording read =
      parse_npy_positions(to_positions_npy(joint_points(to_recording(walk))), "walk.npy", options);
  ASSERT_EQ(read.frame_count(), walk.frame_count());
  for (int t = 0; t < read.frame_count(); ++t) {
    const std::vector<Vec3> places =
        world_positions(walk.body, walk.poses[static_cast<std::size_t>(t)]);
    for (int j = 0; j < body_joint_count; ++j)
      EXPECT_LT((read.positions[read.at(t, j)] - places[static_cast<std::size_t>(j)]).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace mien::motion
