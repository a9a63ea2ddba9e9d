#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {
namespace {

TEST(PValue, IsNeverZero) {
  EXPECT_EQ(p_field(3.2e-15), "3.2e-15");
  EXPECT_EQ(p_field(0.0), "< 1e-300");
  EXPECT_EQ(p_field(4e-310), "< 1e-300");
  EXPECT_EQ(p_field(2e-300), "2e-300");
  EXPECT_EQ(p_field(1.0), "1");
  EXPECT_EQ(p_field(std::nan("")), "");
  EXPECT_EQ(p_label(0.0), "< 1e-300");
  EXPECT_EQ(p_label(3.21e-15), "3.2e-15");
  EXPECT_EQ(p_label(0.0339), "0.034");
  EXPECT_EQ(p_label(std::nan("")), "–");
}

TEST(PValue, ReadsBackFromTables) {
  for (double p = 1.0; p > 1e-299; p *= 0.37)
    EXPECT_EQ(std::strtod(p_field(p).c_str(), nullptr), p);
}

}  // namespace
}  // namespace mien::pipeline
