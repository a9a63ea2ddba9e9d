#include <cmath>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/math/geometry.h"
#include "scenes/cameras/camera_rig.h"
#include "scenes/marked_clip.h"
#include "scenes/stage/shot.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

motion::Clip walk() {
  return test::with_markers(test::walking_clip(20, Vec3(1.0, 0.0, 2.0).normalized(), 0.05));
}

/// Distances between all joints of two frames: what no rigid motion changes.
void expect_same_shape(const motion::Clip& one, const motion::Clip& other) {
  const auto before = motion::joint_paths(one), after = motion::joint_paths(other);
  for (std::size_t j = 0; j < before[0].size(); ++j) {
    for (const std::size_t frame : {std::size_t{0}, before.size() - 1}) {
      EXPECT_NEAR((before[0][0] - before[frame][j]).norm(), (after[0][0] - after[frame][j]).norm(),
                  1e-9);
      EXPECT_NEAR(before[frame][j].y(), after[frame][j].y(), 1e-9);
    }
  }
}

/// Markers stay on their joints.
void expect_markers_on_joints(const motion::Clip& clip) {
  const motion::Markers* markers = motion::markers_of(clip);
  ASSERT_NE(markers, nullptr);
  const auto joints = motion::joint_paths(clip);
  for (int frame = 0; frame < clip.frame_count(); ++frame) {
    for (int point = 0; point < markers->point_count(); ++point) {
      const auto joint = test::carriers()[static_cast<std::size_t>(point)].second;
      EXPECT_LT((markers->positions[markers->at(frame, point)] -
                 joints[static_cast<std::size_t>(frame)][joint])
                    .norm(),
                1e-9);
    }
  }
}

TEST(PlacedClips, BeginAtTheirPlaceAndGoInTheirDirection) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> metres(-5.0, 5.0), degrees(-180.0, 180.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 place(metres(random), 0.0, metres(random));
    const double turn = degrees(random) * motion::radians_per_degree;
    const motion::Clip clip = placed(walk(), place, turn);
    EXPECT_LT((motion::horizontal(clip.poses[0].root_position) - place).norm(), 1e-9);
    const Vec3 forward = action_of(clip).forward;
    EXPECT_NEAR(forward.x(), std::sin(turn), 1e-9);
    EXPECT_NEAR(forward.z(), std::cos(turn), 1e-9);
    expect_same_shape(walk(), clip);
    expect_markers_on_joints(clip);
  }
}

TEST(PlacedClips, AreShiftedAsAWhole) {
  const Vec3 shift(0.5, 0.0, -2.0);
  const motion::Clip clip = shifted(walk(), shift);
  EXPECT_LT((clip.poses[3].root_position - walk().poses[3].root_position - shift).norm(), 1e-12);
  expect_same_shape(walk(), clip);
  expect_markers_on_joints(clip);
}

TEST(PersonColours, AreEightDifferentOnesAndThenRepeat) {
  std::set<std::string> colours;
  for (std::size_t number = 0; number < 8; ++number) {
    EXPECT_TRUE(is_hex_colour(person_colour(number)));
    colours.emplace(person_colour(number));
  }
  EXPECT_EQ(colours.size(), 8u);
  EXPECT_EQ(person_colour(8), person_colour(0));
}

}  // namespace
}  // namespace mien::scenes
