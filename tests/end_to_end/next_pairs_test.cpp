#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

constexpr char pairs_text[] = R"(mien: 1
study: pairs
seed: 7
examples: {set: builtin:walks-10, ratings: builtin}
stimuli:
  - {id: usual, weights: {normal: 1}}
  - {id: sad, weights: {sad: 1}}
  - {id: tired, weights: {tired: 1}}
  - {id: happy, weights: {happy: 1}}
  - {id: proud, weights: {proud: 1}}
questionnaire:
  participants: 6
  trials: pair
  scales: [sad-happy, slow-fast]
)";

/// Two rounds of choices by simulated people.
class RoundsOfPairs : public testing::Test {
 protected:
  void SetUp() override {
    const Ended made = run_mien({"study", "simulate", first, "-o", answers});
    ASSERT_EQ(made.code, 0) << made.errors;
  }

  Ended next(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"study", "next"};
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  const Scratch folder;
  const std::string first = folder.write("pairs.yaml", pairs_text).string();
  const std::string answers = (folder.path() / "answers.csv").string();
  const std::string second = (folder.path() / "pairs-2.yaml").string();
  const std::string third = (folder.path() / "pairs-3.yaml").string();
};

TEST_F(RoundsOfPairs, FollowFromTheChoicesOfAllRoundsBefore) {
  const Ended chosen = next({answers, first, "-o", second, "--pairs", "3"});
  ASSERT_EQ(chosen.code, 0) << chosen.errors;
  EXPECT_EQ(chosen.output.find("simulated answers\n3 of 10 pairs of 5 stimuli"), 0u)
      << chosen.output;
  EXPECT_EQ(run_mien({"check", second}).code, 0);
  const std::string more = (folder.path() / "answers-2.csv").string();
  const Ended simulated = run_mien({"study", "simulate", second, "-o", more});
  ASSERT_EQ(simulated.code, 0) << simulated.errors;
  const std::string rows = text_of(more);  // 6 people, 3 pairs, 2 scales
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 6 * 3 * 2);
  const fs::path tables = folder.path() / "tables";
  const Ended again =
      next({answers, more, second, "-o", third, "--pairs", "4", "--tables", tables.string()});
  ASSERT_EQ(again.code, 0) << again.errors;
  EXPECT_EQ(again.output.find("simulated answers\n4 of 10 pairs of 5 stimuli"), 0u) << again.output;
  const std::string text = text_of(third);
  EXPECT_NE(text.find("study: pairs-3\n"), std::string::npos);
  EXPECT_NE(text.find("stimuli: [usual, sad, tired, happy, proud]"), std::string::npos) << text;
  const std::string listed = text_of(tables / "next_pairs.csv");
  EXPECT_EQ(std::count(listed.begin(), listed.end(), '\n'), 1 + 4 * 2) << listed;
  const std::string codebook = text_of(tables / "codebook.csv");
  for (const char* table : {"next_pairs.csv,", "known_worths.csv,"})
    EXPECT_NE(codebook.find(table), std::string::npos) << codebook;
  // Again: the same bytes, over the same file.
  EXPECT_EQ(next({answers, more, second, "-o", third, "--pairs", "4"}).code, 0);
  EXPECT_EQ(text_of(third), text);
}

TEST_F(RoundsOfPairs, AreRefusedBeforeAnythingIsWritten) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& with) {
    const Ended ended = next(words);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_NE(ended.errors.find(with), std::string::npos) << ended.errors;
    EXPECT_FALSE(fs::exists(second));
  };
  for (const auto& [option, value] :
       {std::pair("--films", "3"), std::pair("--highest", "sad-happy"),
        std::pair("--candidates", "50"), std::pair("--show", "map.png"), std::pair("--seed", "2"),
        std::pair("--features", "step-length")})
    refused({answers, first, "-o", second, option, value},
            std::string(option) + " is about ratings, and the questionnaire has pairs");
  refused({answers, first, "-o", second, "--scales", "dull-quick"}, "no scale \"dull-quick\"");
  const std::string ratings =
      folder
          .write("ratings.yaml", std::string(pairs_text)
                                     .replace(std::string(pairs_text).find("  trials: pair\n"),
                                              std::string("  trials: pair\n").size(), ""))
          .string();
  refused({answers, ratings, "-o", second, "--pairs", "2"}, "rating trials, no pairs");
  refused({answers, first, "-o", second, "--pairs", "2", "--films", "2"}, "--films");
}

}  // namespace
}  // namespace mien::test
