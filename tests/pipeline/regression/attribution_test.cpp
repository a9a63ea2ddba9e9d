#include "pipeline/regression/attribution.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

constexpr Exchanged all{.motion = true, .scene = true, .drawing = true};

/// Errors that add up: each has its own.
double sum_of(const Exchanged& set) {
  return 1.0 * set.motion + 2.0 * set.scene + 5.0 * set.drawing;
}

TEST(CauseShares, OfErrorsThatAddUpAreTheirOwn) {
  const CauseShares shares = cause_shares(all, 2.0, sum_of);
  EXPECT_DOUBLE_EQ(shares.program, 0.2);
  EXPECT_DOUBLE_EQ(shares.motion, 0.1);
  EXPECT_DOUBLE_EQ(shares.scene, 0.2);
  EXPECT_DOUBLE_EQ(shares.drawing, 0.5);
  EXPECT_NEAR(shares.interaction, 0.0, 1e-15);
}

TEST(CauseShares, OfAProductAreEqualAndAllInteraction) {
  const CauseShares shares = cause_shares(all, 0.0, [](const Exchanged& set) {
    return set.motion && set.scene && set.drawing ? 6.0 : 0.0;
  });
  EXPECT_DOUBLE_EQ(shares.motion, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(shares.scene, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(shares.drawing, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(shares.interaction, 1.0);
}

/// Shapley's own axioms: efficiency, the null player, symmetry.
TEST(CauseShares, AreWhatShapleyAsksFor) {
  const auto error = [](const Exchanged& set) {  // the drawing changes nothing
    return set.motion && set.scene ? 7.0 : set.motion || set.scene ? 3.0 : 0.0;
  };
  const CauseShares shares = cause_shares(all, 1.0, error);
  EXPECT_NEAR(shares.program + shares.motion + shares.scene + shares.drawing, 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(shares.drawing, 0.0);
  EXPECT_DOUBLE_EQ(shares.motion, shares.scene);
  EXPECT_DOUBLE_EQ(shares.motion, 3.5 / 8.0);
  EXPECT_DOUBLE_EQ(shares.interaction, 1.0 / 8.0);
}

TEST(CauseShares, MayBeNegativeWhereOneHidesWhatAnotherDoes) {
  const CauseShares shares =
      cause_shares({.motion = true, .scene = true}, 0.0, [](const Exchanged& set) {
        return set.scene ? 1.0 : set.motion ? 4.0 : 0.0;
      });
  EXPECT_DOUBLE_EQ(shares.motion, 2.0);
  EXPECT_DOUBLE_EQ(shares.scene, -1.0);
}

TEST(CauseShares, AskOnceForEachSetThatCanBe) {
  int asked = 0;
  const auto count = [&](const Exchanged& set) {
    EXPECT_FALSE(set.scene);
    ++asked;
    return sum_of(set);
  };
  cause_shares({.motion = true, .drawing = true}, 0.0, count);
  EXPECT_EQ(asked, 3);
}

TEST(CauseShares, OfNoErrorAreNothing) {
  const CauseShares shares = cause_shares(all, 0.0, [](const Exchanged&) { return 0.0; });
  EXPECT_EQ(shares.program + shares.motion + shares.scene + shares.drawing, 0.0);
}

}  // namespace
}  // namespace mien::pipeline
