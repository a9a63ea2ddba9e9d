#include "motion/lint/stretches.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(Spoken, SaysJointsOfTheBodyInWordsAndOthersAsTheFileHasThem) {
  EXPECT_EQ(spoken("LeftKnee"), "left knee");
  EXPECT_EQ(spoken("Pelvis"), "pelvis");
  EXPECT_EQ(spoken("DEF_BN_Leg_L_02"), "DEF_BN_Leg_L_02");
  EXPECT_EQ(spoken("mixamorig:LeftUpLeg"), "mixamorig:LeftUpLeg");
}

}  // namespace
}  // namespace mien::motion
