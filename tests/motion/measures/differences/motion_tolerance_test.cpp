#include "motion/measures/differences/motion_tolerance.h"

#include <gtest/gtest.h>

#include "motion/changed_motion.h"

namespace mien::motion {
namespace {

using namespace mien::test;

std::vector<std::string> exceeded(const Clip& before, const Clip& now,
                                  const MotionTolerance& tolerance = {}) {
  std::vector<std::string> measures;
  for (const Excess& excess : excesses(motion_difference(before, now), tolerance))
    measures.push_back(excess.measure);
  return measures;
}

bool has(const std::vector<std::string>& measures, const std::string& measure) {
  return std::ranges::find(measures, measure) != measures.end();
}

MotionTolerance nothing_allowed() {
  MotionTolerance none;
  none.position_m = none.rotation_radians = none.velocity_m_s = 0.0;
  none.contact_seconds = none.slide_m = none.duration_seconds = 0.0;
  return none;
}

TEST(MotionTolerance, LetsIdenticalMotionsPassWhateverItIs) {
  const Clip walk = changeable_walk();
  EXPECT_TRUE(exceeded(walk, walk, nothing_allowed()).empty());
}

TEST(MotionTolerance, LetsPassWhatFilesAreRoundedTo) {
  const Clip walk = changeable_walk();
  const Clip now = with_turn(walk, Spine, Vec3(1, 0, 0), 1e-6);
  EXPECT_TRUE(exceeded(walk, now).empty());
  EXPECT_TRUE(has(exceeded(walk, now, nothing_allowed()), "rotation"));
}

TEST(MotionTolerance, IsPassedByEachKindOfChange) {
  const Clip walk = changeable_walk();
  EXPECT_EQ(exceeded(walk, with_turn(walk, LeftWrist, Vec3(1, 0, 0), 0.15 * radians_per_degree)),
            std::vector<std::string>{"rotation"});
  EXPECT_TRUE(has(exceeded(walk, with_turn(walk, LeftHip, Vec3(1, 0, 0), 0.02)), "position"));
  EXPECT_EQ(exceeded(walk, set_elsewhere(walk, Vec3(0.002, 0, 0), 0.0)),
            std::vector<std::string>{"position"});
  EXPECT_EQ(exceeded(walk, without_last(walk, 1)), std::vector<std::string>{"duration"});
  EXPECT_TRUE(has(exceeded(walk, without_first(walk, 1)), "position"));
  Clip leaping = walk;
  leap(leaping, Head, 20, 40.0, Vec3::UnitX());
  EXPECT_TRUE(has(exceeded(walk, leaping), "lint"));
  EXPECT_TRUE(has(exceeded(walk, leaping), "velocity"));
}

TEST(MotionTolerance, CountsAnotherRateUnlessAnyWillDo) {
  const Clip walk = changeable_walk();
  const Clip twice = resampled(walk, 2.0 * walk.frames_per_second);
  EXPECT_TRUE(has(exceeded(walk, twice), "frame-rate"));
  MotionTolerance tolerance;
  tolerance.any_rate = true;
  EXPECT_FALSE(has(exceeded(walk, twice, tolerance), "frame-rate"));
  EXPECT_FALSE(has(exceeded(walk, twice, tolerance), "position"));
}

}  // namespace
}  // namespace mien::motion
