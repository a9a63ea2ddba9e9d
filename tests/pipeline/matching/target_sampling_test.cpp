#include "pipeline/matching/target_sampling.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/statistics/named_random.h"

namespace mien::pipeline {
namespace {

const std::vector<std::string> names = {"a", "b", "c", "d"};

ParameterTable random_table(int examples) {
  ParameterTable table;
  table.names = {"d", "c", "b", "a"};
  table.values.resize(4, examples);
  for (int r = 0; r < 4; ++r) {
    for (int i = 0; i < examples; ++i) {
      table.values(r, i) = uniform(5, std::to_string(r) + " " + std::to_string(i));
    }
  }
  return table;
}

Eigen::RowVectorXd example(const ParameterTable& table, int i) {
  Eigen::RowVectorXd place(4);
  for (int d = 0; d < 4; ++d) {
    place[d] = table.values(table.find(names[static_cast<std::size_t>(d)]), i);
  }
  return place;
}

TEST(TargetSampling, TargetsLieNearExamplesAndSayWhich) {
  const ParameterTable table = random_table(12);
  for (const SampledTarget& target : sample_targets(table, names, {.seed = 3})) {
    EXPECT_GE(target.place.minCoeff(), 0.0);
    EXPECT_LE(target.place.maxCoeff(), 1.0);
    EXPECT_LE(target.distance, 0.35);
    for (int i = 0; i < 12; ++i) {
      const double d = (example(table, i) - target.place).norm();
      EXPECT_GE(d, target.distance - 1e-12);
      if (i == target.nearest_example) {
        EXPECT_NEAR(d, target.distance, 1e-12);
      }
    }
  }
}

TEST(TargetSampling, TheSeedAloneDecides) {
  const ParameterTable table = random_table(12);
  const auto first = sample_targets(table, names, {.seed = 3});
  const auto again = sample_targets(table, names, {.seed = 3});
  const auto other = sample_targets(table, names, {.seed = 4});
  ASSERT_EQ(first.size(), 8u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].id, again[i].id);
    EXPECT_EQ(first[i].place, again[i].place);
    EXPECT_NE(first[i].place, other[i].place);
  }
}

TEST(TargetSampling, TargetsAreSpreadFartherThanPracticeDraws) {
  const auto nearest_pair = [](const std::vector<SampledTarget>& all) {
    double nearest = 10.0;
    for (const SampledTarget& a : all) {
      for (const SampledTarget& b : all) {
        if (&a != &b) nearest = std::min(nearest, (a.place - b.place).norm());
      }
    }
    return nearest;
  };
  const ParameterTable table = random_table(12);
  double spread = 0.0;
  double drawn = 0.0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    spread += nearest_pair(sample_targets(table, names, {.practice = 0, .seed = seed}));
    auto all = sample_targets(table, names, {.targets = 1, .practice = 5, .seed = seed});
    all.erase(all.begin());
    for (const SampledTarget& t : all) EXPECT_TRUE(t.practice);
    drawn += nearest_pair(all);
  }
  EXPECT_GT(spread, 1.5 * drawn);
}

TEST(TargetSampling, NoTwoTargetsAreTheSame) {
  const auto all = sample_targets(random_table(12), names, {.targets = 20, .practice = 20});
  ASSERT_EQ(all.size(), 40u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT((all[i].place - all[k].place).norm(), 1e-9);
  }
}

TEST(TargetSampling, ExamplesThatLeaveNoRoomAreRefused) {
  try {
    sample_targets(random_table(2), names, {.farthest_from_example = 0.001});
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "only 0 of 200000 random places lie within 0.001 of an example; name fewer "
                 "parameters, or allow a larger distance");
  }
  EXPECT_THROW(sample_targets(random_table(9), {"a", "z"}, {}), Error);
}

}  // namespace
}  // namespace mien::pipeline
