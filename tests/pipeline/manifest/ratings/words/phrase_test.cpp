#include "pipeline/manifest/ratings/words/phrase.h"

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {
namespace {

class Phrase : public testing::Test {
 protected:
  Lexicon lexicon = parse_scales(
                        "scales:\n"
                        "  slow-fast: {low: slow, high: fast}\n"
                        "  painless-painful: {low: painless, high: painful}\n"
                        "  sad-happy: {low: sad, high: happy}\n"
                        "languages:\n"
                        "  english: {strengthened: [very], softened: [a little], negated: [not]}\n"
                        "  finnish: {strengthened: [hyvin], softened: [hieman]}\n"
                        "words:\n"
                        "  slow-fast:\n"
                        "    low: {english: [slowly, in no hurry], finnish: [hitaasti]}\n"
                        "    high: {english: [in a hurry, quickly], finnish: [nopeasti]}\n"
                        "  painless-painful: {high: {english: [painfully], finnish: [kipeästi]}}\n"
                        "  sad-happy: {low: {english: [sadly]}, high: {english: [gladly]}}\n",
                        "l.yaml")
                        .lexicon;
  const Language& english = *find_language(lexicon, "english");
  const Language& finnish = *find_language(lexicon, "finnish");

  PhraseReading read(const std::string& text) { return read_phrase(text, lexicon, english); }

  double value(const std::string& text) {
    const PhraseReading reading = read(text);
    return reading.mentions.size() == 1 ? reading.mentions[0].value : 99.0;
  }
};

TEST_F(Phrase, IsWorthOneTowardsItsEnd) {
  EXPECT_EQ(value("Slowly"), -1.0);
  EXPECT_EQ(value("quickly"), 1.0);
}

TEST_F(Phrase, IsWorthTwoWhenStrengthenedAndOneWhenSoftened) {
  EXPECT_EQ(value("very slowly"), -2.0);
  EXPECT_EQ(value("very very quickly"), 2.0);
  EXPECT_EQ(value("a little quickly"), 1.0);
}

TEST_F(Phrase, IsTurnedRoundByANegation) {
  EXPECT_EQ(value("not painfully"), -1.0);
  EXPECT_EQ(value("not very slowly"), 1.0);
}

TEST_F(Phrase, TakesTheLongestEntry) {
  EXPECT_EQ(value("in no hurry"), -1.0);
  EXPECT_EQ(value("in a hurry"), 1.0);
}

TEST_F(Phrase, MayHoldSeveralThings) {
  const PhraseReading reading = read("very slowly, sadly/painfully");
  ASSERT_EQ(reading.mentions.size(), 3u);
  EXPECT_EQ(reading.mentions[0].value, -2.0);
  EXPECT_EQ(reading.mentions[1].value, -1.0);  // "very" does not reach across a comma
  EXPECT_EQ(reading.mentions[2].scale, "painless-painful");
}

TEST_F(Phrase, PassesOverOtherWords) {
  EXPECT_EQ(value("somebody walks slowly there"), -1.0);
  EXPECT_FALSE(read("like a horse").is_read());
}

TEST_F(Phrase, ReadsOtherLanguagesAfterItsOwn) {
  EXPECT_EQ(value("hyvin hitaasti"), -2.0);
  EXPECT_EQ(read_phrase("slowly", lexicon, finnish).mentions.at(0).value, -1.0);
}

TEST_F(Phrase, ReadsAMisspeltWordOfItsOwnLanguage) {
  const PhraseReading reading = read("painfuly");
  ASSERT_EQ(reading.mentions.size(), 1u);
  EXPECT_EQ(reading.mentions[0].value, 1.0);
  const std::vector<std::pair<std::string, std::string>> expected = {{"painfuly", "painfully"}};
  EXPECT_EQ(reading.respelled, expected);
}

TEST_F(Phrase, DoesNotGuessAtShortWordsOrFirstLetters) {
  EXPECT_FALSE(read("badly").is_read());       // one letter from "sadly"
  EXPECT_FALSE(read("quirkly").is_read());     // another letter, another word
  EXPECT_FALSE(read("xpainfully").is_read());  // an edit before the first letter
  EXPECT_FALSE(read("rainfully").is_read());
}

TEST_F(Phrase, OfDegreeAloneSpeaksOfTheVerb) {
  const PhraseReading reading = read("a little");
  EXPECT_TRUE(reading.mentions.empty());
  EXPECT_EQ(reading.degree, std::vector<Grade>{Grade::softened});
  EXPECT_TRUE(read("very horsely").degree.empty());
}

}  // namespace
}  // namespace mien::pipeline
