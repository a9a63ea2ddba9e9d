#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

TEST(FailureText, SaysWhatHelpsWhereTheMemoryDoesNotSuffice) {
  const std::string said = failure_text(std::bad_alloc());
  EXPECT_NE(said.find("not enough memory"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos);
  try {
    std::vector<int>().reserve(std::vector<int>().max_size() + 1);
    FAIL() << "there is memory for anything";
  } catch (const std::exception& failure) {
    EXPECT_EQ(failure_text(failure), said);
  }
}

TEST(FailureText, IsTheFailuresOwnOtherwise) {
  EXPECT_EQ(failure_text(std::runtime_error("the disk failed")), "the disk failed");
}

}  // namespace
}  // namespace mien::pipeline
