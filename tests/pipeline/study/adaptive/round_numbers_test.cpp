#include "pipeline/study/adaptive/round_numbers.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

/// A file with an answer about each of these stimuli.
Answers file_about(const std::vector<std::string>& stimuli) {
  Answers file;
  for (const std::string& stimulus : stimuli)
    file.answers.push_back({"p1", stimulus, "sad-happy", 0.0});
  return file;
}

using Numbers = std::map<std::string, int>;

TEST(RoundInName, IsThatOfChosenFilms) {
  EXPECT_EQ(round_in_name("round2-01"), 2);
  EXPECT_EQ(round_in_name("round13-07"), 13);
  for (const char* name : {"round-01", "round2", "round2_1", "roundabout-2", "round0-1",
                           "round-2-1", "around2-1", "round99999999999-1", ""})
    EXPECT_EQ(round_in_name(name), std::nullopt) << name;
}

TEST(RoundNumbers, AreThoseInNames) {
  const Numbers expected = {{"a", 1}, {"b", 1}, {"round2-01", 2}, {"round3-01", 3}};
  EXPECT_EQ(round_numbers({file_about({"round3-01", "a"}), file_about({"b", "round2-01"})}),
            expected);
}

TEST(RoundNumbers, WithoutNamesFollowFromFilesThatShareStimuli) {
  // The first and the third have no stimulus in common, but both share one with the last.
  EXPECT_EQ(round_numbers({file_about({"a", "b"}), file_about({"x"}), file_about({"c"}),
                           file_about({"b", "c"}), file_about({"y", "x"})}),
            (Numbers{{"a", 1}, {"b", 1}, {"c", 1}, {"x", 2}, {"y", 2}}));
  EXPECT_EQ(round_numbers({file_about({"a"}), file_about({"a"})}), (Numbers{{"a", 1}}));
  EXPECT_TRUE(round_numbers({}).empty());
}

}  // namespace
}  // namespace mien::pipeline
