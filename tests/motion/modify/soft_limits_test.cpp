#include "motion/modify/soft_limits.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/modify/posture.h"
#include "motion/procedural/walker.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(SoftLimits, NeverPassTheLimitAndNeverGoBack) {
  double before = -1.0;
  for (double value = 0.0; value < 5.0; value += 0.01) {
    const double limited = softly_limited(value, 1.0, 1.5);
    EXPECT_LE(limited, 1.5);
    EXPECT_GE(limited, before);
    EXPECT_LE(limited, value);
    if (value <= 1.0) {
      EXPECT_EQ(limited, value);
    }
    before = limited;
  }
  // No kink where bending begins.
  EXPECT_NEAR((softly_limited(1.0 + 1e-6, 1.0, 1.5) - 1.0) / 1e-6, 1.0, 1e-3);
}

TEST(SoftLimits, LeaveWhatTheOriginalDoes) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const SoftLimits limits = with_soft_limits(clip, clip);
  EXPECT_LT(largest_difference(limits.clip, clip), 1e-12);
  EXPECT_EQ(limits.largest_excess, 0.0);
}

TEST(SoftLimits, BendKneesAndElbowsOfBothSidesBack) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  const Clip bent =
      with_posture(clip, {{PostureUnit::knee_flexion, -60.0}, {PostureUnit::elbow_flexion, -60.0}});
  const SoftLimits limits = with_soft_limits(bent, clip);
  EXPECT_GT(limits.largest_excess, 0.5);
  for (const Pose& pose : limits.clip.poses) {
    const double allowed = 3.5 * radians_per_degree;
    EXPECT_GT(log(pose.rotations[LeftKnee]).x(), -allowed);
    EXPECT_GT(log(pose.rotations[RightKnee]).x(), -allowed);
    EXPECT_LT(log(pose.rotations[LeftElbow]).y(), allowed);
    EXPECT_GT(log(pose.rotations[RightElbow]).y(), -allowed);
  }
}

}  // namespace
}  // namespace mien::motion
