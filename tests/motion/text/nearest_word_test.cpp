#include "motion/text/nearest_word.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::string random_word(std::mt19937_64& random) {
  std::uniform_int_distribution<int> length(0, 7);
  std::uniform_int_distribution<int> letter('a', 'c');
  std::string word(static_cast<size_t>(length(random)), ' ');
  for (char& c : word) c = static_cast<char>(letter(random));
  return word;
}

TEST(NearestWord, EditDistanceHasTheTextbookValues) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("ab", "ba"), 1);
  EXPECT_EQ(edit_distance("ca", "abc"), 2);  // 3 when only restricted exchanges are allowed
  EXPECT_EQ(edit_distance("", "four"), 4);
  EXPECT_EQ(edit_distance("same", "same"), 0);
  EXPECT_EQ(edit_distance("quicknes", "quickness"), 1);
}

TEST(NearestWord, EditDistanceIsAMetric) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::string a = random_word(random);
    const std::string b = random_word(random);
    const std::string c = random_word(random);
    EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
    EXPECT_EQ(edit_distance(a, b) == 0, a == b);
    EXPECT_LE(edit_distance(a, c), edit_distance(a, b) + edit_distance(b, c));
  }
}

const std::vector<std::string> known_names = {"quickness",   "clearness", "activeness",
                                              "largeness",   "sad-happy", "narrow-broad",
                                              "narrow-wide", "ugly-cute"};

TEST(NearestWord, FindsWhatWasMeantBehindATypingSlip) {
  EXPECT_EQ(nearest_word("quicknes", known_names), "quickness");
  EXPECT_EQ(nearest_word("Clearnes", known_names), "clearness");
  EXPECT_EQ(nearest_word("sda-happy", known_names), "sad-happy");
  EXPECT_EQ(nearest_word("narow_wide", known_names), "narrow-wide");
}

TEST(NearestWord, SeesHalvesThatWereExchanged) {
  EXPECT_EQ(nearest_word("happy-sad", known_names), "sad-happy");
  EXPECT_EQ(nearest_word("cute-ugli", known_names), "ugly-cute");
}

TEST(NearestWord, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("extraversion", known_names), std::nullopt);
  EXPECT_EQ(nearest_word("x", known_names), std::nullopt);
  EXPECT_EQ(nearest_word("quickness", {}), std::nullopt);
}

TEST(NearestWord, TakesTheFirstOfEquallyNearCandidates) {
  const std::vector<std::string> candidates = {"walk-2", "walk-3"};
  EXPECT_EQ(nearest_word("walk-1", candidates), "walk-2");
}

TEST(NearestWord, IsTheOnlyOneThatTheWordBegins) {
  const std::vector<std::string> keys = {"head-flexion", "chest-flexion", "head-turn", "limit_s",
                                         "limited"};
  EXPECT_EQ(nearest_word("chest", keys), "chest-flexion");
  EXPECT_EQ(nearest_word("head", keys), std::nullopt);  // of two
  EXPECT_EQ(nearest_word("che", keys), std::nullopt);   // no whole part
  const std::vector<std::string> seconds = {"threshold_m", "limit_s"};
  EXPECT_EQ(did_you_mean("limit", seconds), "did you mean \"limit_s\"?");
}

TEST(NearestWord, RemedyAsksOrElseListsWhatThereIs) {
  EXPECT_EQ(did_you_mean("quicknes", known_names), "did you mean \"quickness\"?");
  const std::vector<std::string> few = {"front", "side"};
  EXPECT_EQ(did_you_mean("follow", few), "use one of \"front\", \"side\"");
  EXPECT_EQ(did_you_mean("follow", {}), "");
}

}  // namespace
}  // namespace mien::motion
