#include "motion/text/as_number.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(AsNumber, IsAllOfTheTextOrNothing) {
  EXPECT_EQ(as_number<int>("-12"), -12);
  EXPECT_EQ(as_number<double>("1e3"), 1000.0);
  EXPECT_EQ(as_number<std::uint64_t>("18446744073709551615"),
            std::numeric_limits<std::uint64_t>::max());
  for (const char* text : {"", " 1", "1 ", "1x", "x", "+1", "0x10", "1.5", "2147483648"})
    EXPECT_FALSE(as_number<int>(text)) << text;
  EXPECT_FALSE(as_number<std::uint64_t>("-1"));
}

TEST(AsNumber, IsFiniteWhereThatIsAskedFor) {
  EXPECT_EQ(as_finite_number("-0.5"), -0.5);
  for (const char* text : {"inf", "-inf", "nan", "1e999", "", "+1"})
    EXPECT_FALSE(as_finite_number(text)) << text;
}

TEST(AsNumber, MayHaveAPlusWherePeopleWriteIt) {
  EXPECT_EQ(as_written_number("+0.5"), 0.5);
  for (const char* text : {"+", "++1", "+inf", "1,5"})
    EXPECT_FALSE(as_written_number(text)) << text;
}

}  // namespace
}  // namespace mien::motion
