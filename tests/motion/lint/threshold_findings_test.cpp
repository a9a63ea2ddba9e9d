#include "motion/lint/threshold_findings.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(Spoken, SaysJointsOfTheBodyInWordsAndOthersAsTheFileHasThem) {
  EXPECT_EQ(display_name("LeftKnee"), "left knee");
  EXPECT_EQ(display_name("Pelvis"), "pelvis");
  EXPECT_EQ(display_name("DEF_BN_Leg_L_02"), "DEF_BN_Leg_L_02");
  EXPECT_EQ(display_name("mixamorig:LeftUpLeg"), "mixamorig:LeftUpLeg");
}

}  // namespace
}  // namespace mien::motion
