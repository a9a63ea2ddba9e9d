#include "motion/interpolation/word_clicks.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "motion/random_places.h"

namespace mien::motion {
namespace {

using test::random_places;

TEST(WordClicks, MoveTheNamedParameterByAStep) {
  std::mt19937_64 random(51);
  const WordClicks words = fit_word_clicks(random_places(random, 20, 3), 0.1);
  const Eigen::VectorXd equal = Eigen::VectorXd::Constant(20, 0.05);
  for (int m = 0; m < 3; ++m) {
    for (int sign : {-1, 1}) {
      const std::array word = {Click{m, sign}};
      const Eigen::VectorXd after = clicked(words, equal, word);
      EXPECT_NEAR(after.sum(), 1.0, 1e-12);
      EXPECT_NEAR((words.standardised * (after - equal))[m], 0.1 * sign, 1e-9);
    }
  }
}

TEST(WordClicks, ThereAndBackAgainIsWhereOneWasAsLongAsNoWeightVanishes) {
  std::mt19937_64 random(52);
  const WordClicks words = fit_word_clicks(random_places(random, 20, 3), 0.05);
  const Eigen::VectorXd equal = Eigen::VectorXd::Constant(20, 0.05);
  const std::array up = {Click{0, 1}, Click{2, -1}};
  const std::array down = {Click{0, -1}, Click{2, 1}};
  EXPECT_LT((clicked(words, clicked(words, equal, up), down) - equal).norm(), 1e-12);
}

TEST(WordClicks, MostlyArriveWhereAWishCanBeMetAndLogTheWay) {
  std::mt19937_64 random(53);
  const Eigen::MatrixXd places = random_places(random, 25, 2);
  const WordClicks words = fit_word_clicks(places);
  int arrived = 0;
  for (int trial = 0; trial < 20; ++trial) {
    // Inside the examples, so that some blend has it.
    const Eigen::RowVectorXd wish = 0.3 * places.row(trial) + 0.7 * places.colwise().mean();
    const ClickPath path = click_towards(words, wish);
    arrived += path.arrived;
    const Eigen::VectorXd missing =
        ((wish - path.weights.transpose() * places).transpose()).cwiseQuotient(words.deviation);
    EXPECT_EQ(missing.cwiseAbs().maxCoeff() <= 0.5 * words.step, path.arrived);
    // The log tells the whole way.
    Eigen::VectorXd replayed = Eigen::VectorXd::Constant(25, 0.04);
    for (const Click& click : path.clicks) replayed = clicked(words, replayed, {&click, 1});
    EXPECT_EQ(replayed, path.weights);
  }
  EXPECT_GE(arrived, 17);
}

TEST(WordClicks, EndWhereNoClickHelps) {
  std::mt19937_64 random(54);
  const WordClicks words = fit_word_clicks(random_places(random, 6, 2));
  const ClickPath path = click_towards(words, Eigen::RowVector2d(40.0, -40.0));
  EXPECT_FALSE(path.arrived);
  EXPECT_LT(path.clicks.size(), 400u);
  EXPECT_GE(path.weights.minCoeff(), 0.0);
}

}  // namespace
}  // namespace mien::motion
