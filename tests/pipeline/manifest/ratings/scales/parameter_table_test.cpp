#include "pipeline/manifest/ratings/scales/parameter_table.h"

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

TEST(ParameterTable, TellsWhereExamplesLieOnTheParametersThatAreNamed) {
  const ParameterTable table{{"quickness", "largeness", "slow-fast"},
                             Eigen::Matrix<double, 3, 2>{{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}}};
  const Eigen::Matrix2d expected{{0.5, 0.1}, {0.6, 0.2}};
  EXPECT_EQ(places_of_examples(std::vector<std::string>{"slow-fast", "quickness"}, table),
            expected);
  EXPECT_EQ(places_of_examples({}, table).rows(), 2);
  EXPECT_THROW(places_of_examples(std::vector<std::string>{"zeal"}, table), Error);
}

}  // namespace
}  // namespace mien::pipeline
