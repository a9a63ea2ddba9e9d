#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/hand.h"
#include "pipeline/production/sheets/sheet.h"

namespace mien::pipeline {
namespace {

motion::Example with_straight_fingers(motion::Example example) {
  for (motion::Pose& pose : example.clip.poses)
    pose.fingers.assign(motion::finger_joint_count, motion::Quat::Identity());
  return example;
}

// A little finger alone that is bent at its knuckle by 60° moves its tip by its own length: the
// chord of 60° is the radius.
TEST(FingertipsText, TellsHowFarTheTipsAreApartWhereBothHaveFingers) {
  const motion::Example plain = motion::builtin_examples("walks-10").examples.front();
  const motion::Example straight = with_straight_fingers(plain);
  EXPECT_EQ(fingertips_text(plain, straight), "");
  EXPECT_EQ(fingertips_text(straight, plain), "");
  EXPECT_EQ(fingertips_text(straight, straight), "fingertips 0.000 m apart");
  motion::Example bent = straight;
  for (const bool left : {true, false}) {
    const int joint = motion::finger_joint(left, motion::Finger::little, 0);
    for (motion::Pose& pose : bent.clip.poses)
      pose.fingers[static_cast<std::size_t>(joint)] =
          motion::Quat(Eigen::AngleAxisd(motion::pi / 3.0, motion::flexion_axis(joint)));
  }
  // Of the table in hand.cpp: 30, 18 and 17 mm on a hand of 170 mm, here of 0.108 of the stature;
  // one of five fingers.
  const double length = 0.065 / 0.170 * 0.108 * 1.75 / 5.0;
  const double told = std::stod(fingertips_text(straight, bent).substr(11));
  EXPECT_NEAR(told, length, 0.001);
  const motion::Distance distance = motion::distance(straight, bent);
  EXPECT_NE(beside_verdict(distance, straight, bent).find("  ·  fingertips "), std::string::npos);
  EXPECT_EQ(beside_verdict(distance, plain, bent).find("fingertips"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
