#include "pipeline/study/matching/target_sampling.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/interpolation/reach.h"
#include "pipeline/base/statistics/named_random.h"

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
  for (const UnreachablePolicy unreachable :
       {UnreachablePolicy::reject, UnreachablePolicy::project}) {
    const auto all = sample_targets(random_table(12), names,
                                    {.targets = 20, .practice = 20, .unreachable = unreachable});
    ASSERT_EQ(all.size(), 40u);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT((all[i].place - all[k].place).norm(), 1e-9);
    }
  }
  EXPECT_THROW(
      sample_targets(random_table(1), names,
                     {.targets = 2, .practice = 0, .unreachable = UnreachablePolicy::project}),
      Error);
}

TEST(TargetSampling, ExamplesThatLeaveNoRoomAreRefused) {
  try {
    sample_targets(random_table(2), names, {.max_distance = 0.001});
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "only 0 of 200000 random samples are within 0.001 of an example and can be made "
                 "by a blend of the examples; use fewer parameters, or allow a larger distance");
  }
  EXPECT_THROW(sample_targets(random_table(9), {"a", "z"}, {}), Error);
}

/// What blends have is within the hull of the examples; nothing far from it is reached.
TEST(TargetSampling, TargetsCanBeMade) {
  const ParameterTable table = random_table(12);
  for (const SampledTarget& target : sample_targets(table, names, {.practice = 20, .seed = 3}))
    EXPECT_LT((target.reached - target.place).cwiseAbs().maxCoeff(), 1.001e-3) << target.id;
}

TEST(TargetSampling, ProjectedTargetsTakeThePlaceOfThoseThatCannotBeMade) {
  const ParameterTable table = random_table(12);
  const auto own = [&](UnreachablePolicy unreachable) {
    return sample_targets(table, names, {.targets = 20, .practice = 0, .unreachable = unreachable});
  };
  for (const SampledTarget& target : own(UnreachablePolicy::project))
    EXPECT_LT((target.reached - target.place).cwiseAbs().maxCoeff(), 1.001e-3) << target.id;
  // Moved to the border of what is possible, they lie farther apart than those drawn within.
  const auto width = [](const std::vector<SampledTarget>& targets) {
    double widest = 0.0;
    for (const SampledTarget& a : targets)
      for (const SampledTarget& b : targets)
        widest = std::max(widest, (a.reached - b.reached).norm());
    return widest;
  };
  EXPECT_GE(width(own(UnreachablePolicy::project)), width(own(UnreachablePolicy::reject)));
}

// Two of four rows are asked about; spread in all, the stimuli differ more in all.
TEST(TargetSampling, SpreadInEverythingThatRatersSee) {
  const ParameterTable table = random_table(12);
  const auto nearest = [&](TargetSpread spread, std::uint64_t seed) {
    const auto targets = sample_targets(
        table, {"a", "b"}, {.targets = 6, .practice = 0, .spread = spread, .seed = seed});
    const Eigen::MatrixXd places = (Eigen::MatrixXd(2, 12) << table.values.row(table.find("a")),
                                    table.values.row(table.find("b")))
                                       .finished()
                                       .transpose();
    const motion::Reach reach = motion::fit_reach(places, 0);
    double least = 10.0;
    for (const SampledTarget& a : targets) {
      for (const SampledTarget& b : targets) {
        if (&a == &b) continue;
        least = std::min(least, (table.values * (motion::weights(reach, a.place) -
                                                 motion::weights(reach, b.place)))
                                    .norm());
      }
    }
    return least;
  };
  double everything = 0.0;
  double parameters = 0.0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    everything += nearest(TargetSpread::everything, seed);
    parameters += nearest(TargetSpread::parameters, seed);
  }
  EXPECT_GT(everything, 1.05 * parameters);
}

}  // namespace
}  // namespace mien::pipeline
