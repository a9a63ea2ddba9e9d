#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/fitting/fit.h"
#include "motion/fitting/hinge_axis.h"
#include "motion/fitting/virtual_points.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;

/// The recording without a point from one time to another, seconds.
PointRecording without(PointRecording recording, const std::string& name, double from, double to) {
  const auto found = std::find(recording.points.begin(), recording.points.end(), name);
  const int point = static_cast<int>(found - recording.points.begin());
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const double seconds = frame / recording.frames_per_second;
    if (seconds < from || seconds >= to) continue;
    recording.seen[recording.at(frame, point)] = false;
    recording.positions[recording.at(frame, point)].setZero();
  }
  return recording;
}

/// Largest distance of a limb's joint between two clips, millimetres.
double largest_difference_mm(const Clip& a, const Clip& b) {
  const auto first = joint_paths(a);
  const auto second = joint_paths(b);
  double most = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (const BodyJoint joint : {LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle})
      most = std::max(most, (first[i][joint] - second[i][joint]).norm());
  return 1000.0 * most;
}

TEST(HiddenPoints, OfThePelvisFollowFromTheOthersHoweverLongTheyAreHidden) {
  const PointRecording whole = recorded(truth(), plug_in_gait_markers());
  const Clip seen = fit_body(whole).clip;
  for (const std::string name : {"LASI", "RPSI"}) {
    const FittedMotion fitted = fit_body(without(whole, name, 0.2, 1.2));
    EXPECT_LT(largest_difference_mm(fitted.clip, seen), 10.0) << name;
    EXPECT_LT(fitted.residual_mm, 10.0) << name;
  }
  // From the first frame on: the motion does not begin later for it.
  const FittedMotion later = fit_body(without(whole, "LASI", 0.0, 0.8));
  ASSERT_EQ(later.clip.frame_count(), seen.frame_count());
  EXPECT_LT(largest_difference_mm(later.clip, seen), 10.0);
}

TEST(HiddenPoints, OfALegLeaveItsOtherPointsWhereTheyWereMeasured) {
  const PointRecording whole = recorded(truth(), plug_in_gait_markers());
  for (const std::string name : {"LKNE", "RANK"}) {
    const FittedMotion fitted = fit_body(without(whole, name, 0.2, 1.0));
    EXPECT_LT(fitted.residual_mm, 10.0) << name;
    for (const FittedPoint& point : fitted.points)
      EXPECT_LT(point.residual_mm, 25.0) << point.name << " without " << name;
  }
}

TEST(HiddenPoints, OfOtherPeopleDoNotMoveTheFirst) {
  const PointRecording alone = recorded(truth(), plug_in_gait_markers());
  PointRecording both = alone;
  both.subjects = {"Anna", "Ben"};
  both.points.clear();
  for (const std::string& subject : both.subjects)
    for (const std::string& point : alone.points) both.points.push_back(subject + ":" + point);
  both.positions.clear();
  for (int frame = 0; frame < alone.frame_count(); ++frame)
    for (const double aside : {0.0, 2.0})
      for (int point = 0; point < alone.point_count(); ++point)
        both.positions.push_back(alone.positions[alone.at(frame, point)] + Vec3(aside, 0, 0.5));
  both.seen.assign(both.positions.size(), true);
  const FittedMotion fitted = fit_body(both);
  EXPECT_LT(fitted.residual_mm, 10.0);
  EXPECT_EQ(fitted.notes.front(), "The body is fitted to the points of \"Anna\", one of 2 people.");
  const std::vector<Pose> first = fit_body(alone).clip.poses;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Vec3 way = fitted.clip.poses[i].root_position - first[i].root_position;
    EXPECT_LT((way - Vec3(0, 0, 0.5)).norm(), 0.005);
  }
}

TEST(HingeAxis, OfALimbThatIsNeverBentIsTheExpectedOne) {
  // A hip that was found 5 cm too far outward bends a straight leg sideways.
  const Track hip(20, Vec3(0.05, 0.85, 0.0));
  const Track knee(20, Vec3(0.0, 0.43, 0.0));
  const Track ankle(20, Vec3(0.0, 0.0, 0.0));
  const Track left(20, Vec3(1.0, 0.0, 0.0));
  for (const auto& axis : hinge_axis(hip, knee, ankle, left, Hinge{})) {
    ASSERT_TRUE(axis);
    EXPECT_GT(axis->x(), std::cos(15.0 * radians_per_degree));
  }
}

}  // namespace
}  // namespace mien::motion
