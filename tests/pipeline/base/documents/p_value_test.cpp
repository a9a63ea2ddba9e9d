#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {
namespace {

TEST(PValue, IsNeverZero) {
  EXPECT_EQ(p_of_table(3.2e-15), "3.2e-15");
  EXPECT_EQ(p_of_table(0.0), "< 1e-300");
  EXPECT_EQ(p_of_table(4e-310), "< 1e-300");
  EXPECT_EQ(p_of_table(2e-300), "2e-300");
  EXPECT_EQ(p_of_table(1.0), "1");
  EXPECT_EQ(p_of_table(std::nan("")), "");
  EXPECT_EQ(p_for_people(0.0), "< 1e-300");
  EXPECT_EQ(p_for_people(3.21e-15), "3.2e-15");
  EXPECT_EQ(p_for_people(0.0339), "0.034");
  EXPECT_EQ(p_for_people(std::nan("")), "–");
}

TEST(PValue, ReadsBackFromTables) {
  for (double p = 1.0; p > 1e-299; p *= 0.37)
    EXPECT_EQ(std::strtod(p_of_table(p).c_str(), nullptr), p);
}

}  // namespace
}  // namespace mien::pipeline
