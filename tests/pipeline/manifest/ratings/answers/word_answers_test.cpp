#include "pipeline/manifest/ratings/answers/word_answers.h"

#include <map>

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/answers/impressions.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

constexpr const char* word_header = "participant,language,order,motion,verb,modifier1,modifier2\n";

ScaleSet small_scales() {
  return parse_scales(
      "scales:\n"
      "  slow-fast: {low: slow, high: fast}\n"
      "  even-limping: {low: even, high: limping, range: [1, 7]}\n"
      "  never: {low: a, high: b}\n"
      "languages:\n"
      "  english: {called: [EN], strengthened: [very, badly], softened: [slightly]}\n"
      "words:\n"
      "  slow-fast: {low: {english: [slowly]}, high: {english: [quickly]}}\n"
      "  even-limping: {high: {english: [limps, limping]}}\n",
      "l.yaml");
}

WordAnswers read_words(const std::string& rows, Unmentioned unmentioned = Unmentioned::neutral) {
  return answers_from_words(parse_csv(word_header + rows, "w.csv"), small_scales(), unmentioned);
}

std::map<std::string, double> by_scale(const WordAnswers& words) {
  std::map<std::string, double> values;
  for (const Answer& answer : words.answers.answers) values[answer.scale] = answer.value;
  return values;
}

std::string words_refusal(const std::string& rows) {
  try {
    read_words(rows);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(WordAnswers, LieInTheRangeOfEachScale) {
  const auto values = by_scale(read_words("1,en,1,walk,limps,very slowly,\n"));
  EXPECT_EQ(values.at("slow-fast"), -2.0);
  EXPECT_EQ(values.at("even-limping"), 5.5);  // 1 of 2 from the middle, 4, to the end, 7
}

TEST(WordAnswers, GradeTheVerbByModifiersOfDegree) {
  EXPECT_EQ(by_scale(read_words("1,en,1,walk,limps,badly,\n")).at("even-limping"), 7.0);
  EXPECT_EQ(by_scale(read_words("1,en,1,walk,limps,slightly,\n")).at("even-limping"), 5.5);
}

TEST(WordAnswers, TakeTheStrongestMentionAndCancelContradictions) {
  EXPECT_EQ(by_scale(read_words("1,en,1,walk,,slowly,very quickly\n")).at("slow-fast"), 2.0);
  EXPECT_EQ(by_scale(read_words("1,en,1,walk,,slowly,quickly\n")).at("slow-fast"), 0.0);
}

TEST(WordAnswers, CountTheUnmentionedAsNeutralOnlyByThatRule) {
  const std::string rows = "1,en,1,walk,,slowly,\n2,en,1,walk,limps,,\n";
  const WordAnswers neutral = read_words(rows);
  EXPECT_EQ(neutral.answers.answers.size(), 4u);  // two people, two scales that were mentioned
  const WordAnswers sparse = read_words(rows, Unmentioned::no_answer);
  EXPECT_EQ(sparse.answers.answers.size(), 2u);
}

TEST(WordAnswers, LeaveOutLanguagesTheLexiconLacksAndSaySo) {
  const WordAnswers words = read_words("1,EN,1,walk,,slowly,\n2,فارسی,1,walk,,به آرامی,\n");
  EXPECT_EQ(words.answers.answers.size(), 1u);
  ASSERT_EQ(words.left_out.size(), 1u);
  EXPECT_EQ(words.left_out[0].text, "فارسی");
  EXPECT_EQ(words.left_out[0].language, "");
  EXPECT_EQ(words.left_out[0].count, 1);
}

TEST(WordAnswers, TellTheirCoverage) {
  const WordAnswers words =
      read_words("1,en,1,a,,slowly,horsely\n2,en,1,a,,horsely,\n3,en,1,b,limps,,\n");
  ASSERT_EQ(words.coverage.size(), 1u);
  EXPECT_EQ(words.coverage[0].answers, 2);
  EXPECT_EQ(words.coverage[0].understood, 1);
  EXPECT_EQ(words.coverage[0].modifiers, 3);
  EXPECT_EQ(words.coverage[0].modifiers_understood, 1);
  ASSERT_EQ(words.not_understood.size(), 1u);
  EXPECT_EQ(words.not_understood[0].text, "horsely");
  EXPECT_EQ(words.not_understood[0].count, 2);
  ASSERT_EQ(words.stimuli.size(), 2u);
  EXPECT_EQ(words.stimuli[0].answers, 2);
  EXPECT_EQ(words.stimuli[0].understood, 1);
}

TEST(WordAnswers, RefuseASecondAnswerAndATableThatSaysNothing) {
  EXPECT_EQ(words_refusal("1,en,1,walk,,slowly,\n1,en,2,walk,,quickly,\n"),
            "w.csv:3:8: a second answer of participant \"1\" about \"walk\"; keep one of them");
  EXPECT_EQ(words_refusal("1,en,1,walk,,horsely,\n"),
            "w.csv: the lexicon matches none of the answers; check the languages and words of both "
            "files");
}

TEST(WordAnswers, NeedALexicon) {
  try {
    parse_answers(std::string(word_header) + "1,en,1,walk,,slowly,\n", "w.csv", builtin_scales());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the scales file has no lexicon"), std::string::npos);
  }
}

/// The answers of Förger, Honkela and Takala 2013, read by the lexicon of this project.
class RealWords : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::real_data();
    if (!folder) GTEST_SKIP() << "no real answers here; set MIEN_DATA";
    scales = read_scales(MIEN_SOURCE_DIR "/manifests/walking-words.scales.yaml");
    words = answers_from_words(read_csv(*folder / "mocap/aalto-two-actors/words.csv"), scales,
                               Unmentioned::neutral);
  }

  double mean(const std::string& motion, const std::string& scale) {
    double sum = 0.0;
    int count = 0;
    for (const Answer& answer : words.answers.answers) {
      if (answer.stimulus != motion || answer.scale != scale) continue;
      sum += answer.value;
      ++count;
    }
    EXPECT_GT(count, 5) << motion << ' ' << scale;
    return sum / count;
  }

  ScaleSet scales;
  WordAnswers words;
};

TEST_F(RealWords, AreUnderstoodInAtLeastSeventyOfAHundredModifiers) {
  for (const WordCoverage& language : words.coverage) {
    EXPECT_GE(language.modifiers_understood, 0.7 * language.modifiers) << language.language;
    EXPECT_GE(language.understood, 0.7 * language.answers) << language.language;
  }
}

TEST_F(RealWords, OrderTheWalksAsTheyWereActed) {
  const std::string k_fast = "k_walk_fast_k_walk_angry_k_walk_regular_100_000_000";
  const std::string k_slow = "k_limp_slow_k_walk_slow_000_100";
  const std::string t_fast = "t_walk_fast_t_walk_angry_t_walk_regular_100_000_000";
  const std::string t_slow = "t_limp_slow_t_walk_slow_000_100";
  EXPECT_GT(mean(k_fast, "slow-fast"), mean(k_slow, "slow-fast"));
  EXPECT_GT(mean(t_fast, "slow-fast"), mean(t_slow, "slow-fast"));
  const std::string k_regular = "k_run_slow_k_limp_fast_k_walk_regular_000_000_100";
  const std::string t_regular = "t_run_slow_t_limp_fast_t_walk_regular_000_000_100";
  EXPECT_LT(mean("k_limp_sad_k_walk_sad_000_100", "sad-happy"), mean(k_regular, "sad-happy"));
  EXPECT_LT(mean("t_limp_sad_t_walk_sad_000_100", "sad-happy"), mean(t_regular, "sad-happy"));
  EXPECT_GT(mean("k_limp_angry_k_walk_angry_000_100", "placid-angry"),
            mean(k_regular, "placid-angry"));
  EXPECT_GT(mean("t_limp_angry_t_walk_angry_000_100", "placid-angry"),
            mean(t_regular, "placid-angry"));
}

}  // namespace
}  // namespace mien::pipeline
