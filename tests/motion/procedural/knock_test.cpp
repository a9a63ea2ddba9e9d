#include "motion/procedural/knock.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/lint/lint.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"

namespace mien::motion {
namespace {

std::vector<double> wrist_reach(const Example& example) {
  std::vector<double> reach;
  for (const Pose& pose : example.clip.poses) {
    const auto places = world_positions(example.clip.body, pose);
    reach.push_back((places[RightWrist] - places[RightShoulder]).z());
  }
  return reach;
}

TEST(Knock, HitsAsOftenAsAskedAtItsKeytimes) {
  for (const int knocks : {1, 3, 5}) {
    const Example example = knock({.knocks = knocks}, 120.0, standard_body());
    const std::vector<double> reach = wrist_reach(example);
    int hits = 0;
    const double most = *std::max_element(reach.begin(), reach.end());
    for (std::size_t f = 1; f + 1 < reach.size(); ++f) {
      hits += reach[f] >= reach[f - 1] && reach[f] > reach[f + 1] && reach[f] > most - 0.005;
    }
    EXPECT_EQ(hits, knocks);
    const auto first = static_cast<std::size_t>(std::lround(example.keytimes[1] * 120.0));
    EXPECT_NEAR(reach[first], most, 0.003);
    EXPECT_EQ(example.keytimes.size(), knocks == 1 ? 3u : 4u);
  }
}

TEST(Knock, StartsAndEndsAtRestWithTheFeetStill) {
  const Example example = knock(angry_knock(), 60.0, standard_female_body());
  const auto& body = example.clip.body;
  const auto first = world_positions(body, example.clip.poses.front());
  const auto last = world_positions(body, example.clip.poses.back());
  for (std::size_t j = 0; j < first.size(); ++j) EXPECT_LT((first[j] - last[j]).norm(), 1e-9);
  for (const Pose& pose : example.clip.poses) {
    const auto places = world_positions(body, pose);
    EXPECT_LT((places[LeftToe] - first[LeftToe]).norm(), 1e-12);
    EXPECT_LT((places[RightAnkle] - first[RightAnkle]).norm(), 1e-12);
  }
}

TEST(Knock, RefusesWhatIsNone) {
  EXPECT_THROW(knock({.knocks = 0}, 30.0, standard_body()), Error);
  EXPECT_THROW(knock({.knock_seconds = 0.0}, 30.0, standard_body()), Error);
  EXPECT_THROW(knock({}, 0.0, standard_body()), Error);
}

TEST(Actors, WalkKnockAndStandWithoutErrorsOnBodiesOfTheirOwn) {
  const ExampleSet set = builtin_examples("actors");
  EXPECT_FALSE(set.blendable);
  EXPECT_TRUE(set.simulated);
  EXPECT_EQ(set.examples.size(), 34u);
  const std::vector<std::string> names = builtin_example_names("actors");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Example& example = set.examples[i];
    EXPECT_EQ(example.name, names[i]);
    EXPECT_FALSE(has_errors(lint(example.clip))) << example.name;
    EXPECT_NEAR(standing_height(example.clip.body), names[i].starts_with("woman") ? 1.63 : 1.78,
                0.03);
  }
}

}  // namespace
}  // namespace mien::motion
