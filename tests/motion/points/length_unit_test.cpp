#include "motion/points/length_unit.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(LengthUnit, IsKnownBySymbolAndNameInAnyCase) {
  for (const char* word : {"mm", "MM", " mm ", "millimetre", "Millimeters"}) {
    const auto unit = length_unit(word);
    ASSERT_TRUE(unit) << word;
    EXPECT_EQ(unit->name, "mm") << word;
    EXPECT_EQ(unit->metres, 0.001) << word;
  }
  EXPECT_EQ(metres_in_unit("metres"), 1.0);
  EXPECT_EQ(metres_in_unit("dm"), 0.1);
  EXPECT_EQ(metres_in_unit("cm"), 0.01);
  EXPECT_EQ(metres_in_unit("um"), 1e-6);
  EXPECT_EQ(metres_in_unit("Inches"), 0.0254);
  EXPECT_EQ(metres_in_unit("feet"), 0.3048);
}

TEST(LengthUnit, IsNothingElse) {
  for (const char* word : {"", " ", "n/a", "deg", "mmm", "m m", "s"}) {
    EXPECT_FALSE(length_unit(word)) << word;
    EXPECT_EQ(metres_in_unit(word), 0.0) << word;
  }
}

}  // namespace
}  // namespace mien::motion
