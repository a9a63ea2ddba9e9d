#include "pipeline/ratings/expectation.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

ParameterTable two_parameters() {
  ParameterTable table;
  table.names = {"energy", "slow-fast"};
  table.values.resize(2, 3);
  table.values << 0.5, 0.5, 0.5, 0.2, 0.6, 0.9;
  return table;
}

ExpectationCheck check(const Expectation& expectation) {
  return check_expectations({expectation}, two_parameters(), {"a", "b", "c"}).at(0);
}

TEST(Expectation, HoldsWhereEachExampleIsAboveTheOneBefore) {
  const ExpectationCheck result = check({"slow-fast", {"a", "b", "c"}});
  EXPECT_TRUE(result.holds());
  EXPECT_EQ(sentence_of(result), "slow-fast: a 0.200 < b 0.600 < c 0.900, as expected");
}

TEST(Expectation, TellsWhereItFails) {
  const ExpectationCheck result = check({"slow-fast", {"b", "a", "c"}});
  EXPECT_EQ(result.violated, std::vector<std::size_t>{0});
  EXPECT_EQ(sentence_of(result), "slow-fast: b 0.600 ≥ a 0.200 < c 0.900, not as expected");
}

TEST(Expectation, IsNotMetByEqualValues) {
  EXPECT_EQ(check({"energy", {"a", "b", "c"}}).violated, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace mien::pipeline
