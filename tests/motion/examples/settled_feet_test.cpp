#include "motion/examples/settled_feet.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/examples/example_set.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_path.h"
#include "motion/measures/distance/distance.h"
#include "motion/procedural/builtin_sets.h"

#include "real_data.h"

namespace mien::motion {
namespace {

double moved_by_another_lock(const Example& example) {
  Example locked = example;
  locked.clip = foot_locked(example.clip, foot_plants(example.clip));
  return distance(example, locked).mean;
}

/// Largest second difference, metres, of the knee against the line from hip to ankle.
double largest_knee_jerk(const Clip& clip, bool left) {
  const LegJoints leg = leg_joints(left);
  std::vector<Vec3> path;
  for (const Pose& pose : clip.poses) {
    const auto joints = world_positions(clip.body, pose);
    path.push_back(joints[leg.knee] - 0.5 * (joints[leg.hip] + joints[leg.ankle]));
  }
  double largest = 0.0;
  const size_t count = path.size();
  for (size_t f = 0; f < count; ++f) {
    const Vec3 jerk = path[(f + 2) % count] - 2.0 * path[(f + 1) % count] + path[f];
    largest = std::max(largest, jerk.norm());
  }
  return largest;
}

TEST(SettledFeet, OfBuiltInWalksStayAsTheyAre) {
  for (const char* name : {"walks-10", "walks-27"}) {
    const ExampleSet set = builtin_examples(name);
    const ExampleSet settled = with_settled_feet(set);
    for (size_t i = 0; i < set.examples.size(); ++i) {
      EXPECT_LT(moved_by_another_lock(settled.examples[i]), 1e-5) << set.examples[i].name;
      EXPECT_LT(distance(set.examples[i], settled.examples[i]).mean, 0.01) << set.examples[i].name;
      EXPECT_EQ(set.examples[i].keytimes, settled.examples[i].keytimes);
    }
  }
}

class RealFeet : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    set = load_examples({.path = *folder / "mocap" / "bandai-namco-1", .include = "*_walk_*"}).set;
    ASSERT_EQ(set.examples.size(), 30u);
  }

  ExampleSet set;
};

TEST_F(RealFeet, OnceSettledAreMovedByNoFurtherLock) {
  double before = 0.0;
  for (const Example& example : set.examples) {
    before = std::max(before, moved_by_another_lock(example));
    Example settled = example;
    settled.clip = with_settled_feet(example.clip);
    EXPECT_LT(moved_by_another_lock(settled), 1e-5) << example.name;
    EXPECT_LT(planted_drift(settled.clip, foot_plants(settled.clip)), 1e-3) << example.name;
    // As captured, the feet of one walk hang 2 cm above the floor.
    EXPECT_LT(distance(example, settled).mean, 0.035) << example.name;
  }
  EXPECT_GT(before, 1e-3);  // as captured, they would be
}

// Eight of these legs come so near to straight that noise puts the knee behind the line from hip to
// ankle; when the pelvis sinks, such a knee must not bend backwards for a frame.
TEST_F(RealFeet, AreLockedWithoutSnappingTheKnees) {
  for (const Example& example : set.examples) {
    const Clip locked = foot_locked(example.clip, foot_plants(example.clip));
    for (const bool left : {true, false}) {
      EXPECT_LT(largest_knee_jerk(locked, left), largest_knee_jerk(example.clip, left) + 0.045)
          << example.name << (left ? " left" : " right");
    }
  }
}

}  // namespace
}  // namespace mien::motion
