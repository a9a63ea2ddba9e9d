#include "motion/rig/unit_guess.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(UnitGuess, KnowsCommonUnits) {
  EXPECT_DOUBLE_EQ(guess_unit(1.75, "bvh").metres, 1.0);
  EXPECT_DOUBLE_EQ(guess_unit(168.0, "bvh").metres, 0.01);
  EXPECT_DOUBLE_EQ(guess_unit(1800.0, "bvh").metres, 0.001);
  EXPECT_DOUBLE_EQ(guess_unit(68.0, "bvh").metres, 0.0254);
  EXPECT_DOUBLE_EQ(guess_unit(29.5, "bvh").metres, 0.0254 / 0.45);
  EXPECT_DOUBLE_EQ(guess_unit(17.5, "bvh").metres, 0.1);
  EXPECT_TRUE(guess_unit(168.0, "bvh").warning.empty());
}

TEST(UnitGuess, TakesGltfForMetres) {
  for (const double height : {0.15, 0.9, 1.75, 12.0}) {
    EXPECT_EQ(guess_unit(height, "gltf").metres, 1.0) << height;
    EXPECT_EQ(guess_unit(height, "gltf").warning, "") << height;
  }
  // Nobody is so tall; it is guessed, and said.
  EXPECT_DOUBLE_EQ(guess_unit(170.0, "gltf").metres, 0.01);
  EXPECT_NE(guess_unit(170.0, "gltf").warning.find("170 m tall"), std::string::npos);
}

TEST(UnitGuess, ScalesWhatFitsNothing) {
  const UnitGuess guess = guess_unit(0.034, "bvh");
  EXPECT_DOUBLE_EQ(guess.metres, 50.0);
  EXPECT_EQ(guess.warning,
            "The figure stands 0.034 units tall, which does not fit any known unit of length; it "
            "is scaled to 1.70 m.");
}

}  // namespace
}  // namespace mien::motion
