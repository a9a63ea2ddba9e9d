#include "motion/text/json_depth.h"

#include <string>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(JsonDepth, CountsBracketsAndBracesThatAreOpen) {
  EXPECT_FALSE(is_nested_deeper("7", 0));
  EXPECT_TRUE(is_nested_deeper("[]", 0));
  EXPECT_FALSE(is_nested_deeper("[[1], {\"a\": 2}, [3]]", 2));
  EXPECT_TRUE(is_nested_deeper("[[1], {\"a\": [2]}]", 2));
  EXPECT_TRUE(is_nested_deeper(std::string(1'000'000, '['), 999'999));
}

TEST(JsonDepth, PassesOverTexts) {
  EXPECT_FALSE(is_nested_deeper(R"(["[[[", "\"[[[", "\\"])", 1));
  EXPECT_TRUE(is_nested_deeper(R"(["\\", [1]])", 1));
  EXPECT_FALSE(is_nested_deeper("\"never closed [[[[\\", 0));
}

}  // namespace
}  // namespace mien::motion
