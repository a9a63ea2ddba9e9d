#include "motion/measures/differences/feature_change.h"

#include <limits>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

/// Just above what can be measured of a capture.
double noticeable(FeatureUnit unit) {
  if (unit == FeatureUnit::degrees) return 1.01;
  if (unit == FeatureUnit::metres) return 0.0101;
  return unit == FeatureUnit::metres_per_second ? 0.0501 : 0.0301;
}

TEST(FeatureChange, IsMovedByWhatCanBeMeasuredWhicheverWay) {
  for (int i = 0; i < motion_feature_count; ++i) {
    const double step = noticeable(motion_features()[static_cast<size_t>(i)].unit);
    for (const double way : {1.0, -1.0}) {
      EXPECT_TRUE((FeatureChange{i, 2.0, 2.0 + way * step, 2.0}).moved()) << i;
      EXPECT_FALSE((FeatureChange{i, 2.0, 2.0 + 0.95 * way * step, 2.0}).moved()) << i;
    }
  }
}

TEST(FeatureChange, AgreesFromATenthOfTheTargetsWayOn) {
  const auto agrees = [](double target, double created) {
    return FeatureChange{find_motion_feature("mu-head-fb"), 7.0, 7.0 + target, 7.0 + created}
        .agrees();
  };
  for (const double way : {1.0, -1.0}) {
    EXPECT_TRUE(agrees(way * 10.0, way * 1.01));
    EXPECT_TRUE(agrees(way * 10.0, way * 40.0));
    EXPECT_FALSE(agrees(way * 10.0, way * 0.99));
    EXPECT_FALSE(agrees(way * 10.0, -way * 10.0));
    EXPECT_FALSE(agrees(way * 0.5, way * 0.5));  // nothing to agree with
  }
}

TEST(FeatureChange, OpposesFromATenthOfTheTargetsWayBackOn) {
  const auto opposes = [](double target, double created) {
    return FeatureChange{find_motion_feature("mu-head-fb"), 7.0, 7.0 + target, 7.0 + created}
        .opposes();
  };
  for (const double way : {1.0, -1.0}) {
    EXPECT_TRUE(opposes(way * 10.0, -way * 1.01));
    EXPECT_FALSE(opposes(way * 10.0, -way * 0.99));
    EXPECT_FALSE(opposes(way * 10.0, way * 10.0));
    EXPECT_FALSE(opposes(way * 0.5, -way * 0.5));  // nothing to oppose
  }
}

TEST(FeatureChanges, LeaveOutWhatOneOfTheMotionsLacks) {
  FeatureValues reference{};
  FeatureValues target{};
  FeatureValues created{};
  reference[3] = target[5] = created[8] = std::numeric_limits<double>::quiet_NaN();
  const auto changes = feature_changes(reference, target, created);
  ASSERT_EQ(changes.size(), motion_feature_count - 3u);
  int before = -1;
  for (const FeatureChange& change : changes) {
    EXPECT_GT(change.feature, before);
    before = change.feature;
    EXPECT_TRUE(change.feature != 3 && change.feature != 5 && change.feature != 8);
  }
}

}  // namespace
}  // namespace mien::motion
