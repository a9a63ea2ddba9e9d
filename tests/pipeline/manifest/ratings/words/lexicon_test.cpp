#include "pipeline/manifest/ratings/words/lexicon.h"

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {
namespace {

constexpr const char* small =
    "scales:\n"
    "  slow-fast: {low: slow, high: fast}\n"
    "languages:\n"
    "  finnish: {called: [Suomi], strengthened: [Hyvin], negated: [ei]}\n"
    "words:\n"
    "  slow-fast: {low: {finnish: [HIDAS, hitaasti]}, high: {finnish: [nopea]}}\n";

std::string lexicon_refusal(const std::string& yaml) {
  try {
    parse_scales(yaml, "l.yaml");
  } catch (const Faults& faults) {
    return faults.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Folded, UnifiesCaseSpacesAndQuotes) {
  EXPECT_EQ(folded("  HYVIN \t Väsyneesti "), "hyvin väsyneesti");
  EXPECT_EQ(folded("ÄÄNEKKÄÄSTI"), "äänekkäästi");
  EXPECT_EQ(folded(R"(\"varoo toista\")"), "varoo toista");
  EXPECT_EQ(folded(" "), "");
}

TEST(Folded, ComposesLettersWithMarks) {
  EXPECT_EQ(folded("a\xCC\x88"), "ä");  // a and a combining diaeresis
}

TEST(Lexicon, KnowsALanguageByAllItsNames) {
  const Lexicon lexicon = parse_scales(small, "l.yaml").lexicon;
  ASSERT_EQ(lexicon.languages.size(), 1u);
  EXPECT_EQ(find_language(lexicon, "SUOMI"), &lexicon.languages[0]);
  EXPECT_EQ(find_language(lexicon, "finnish"), &lexicon.languages[0]);
  EXPECT_EQ(find_language(lexicon, "svenska"), nullptr);
}

TEST(Lexicon, FoldsItsWords) {
  const Language finnish = parse_scales(small, "l.yaml").lexicon.languages.at(0);
  EXPECT_EQ(finnish.words.at("hidas"), (WordMeaning{"slow-fast", -1}));
  EXPECT_EQ(finnish.words.at("nopea"), (WordMeaning{"slow-fast", 1}));
  EXPECT_EQ(finnish.grades.at("hyvin"), Grade::strengthened);
}

TEST(Lexicon, RefusesAWordOfTwoMeanings) {
  EXPECT_EQ(lexicon_refusal(replaced(small, "[nopea]", "[nopea, hidas]")),
            "l.yaml:6:74: words.slow-fast.high.finnish[1]: \"hidas\" has a second meaning; remove "
            "one of them, or the word altogether if it is ambiguous");
  EXPECT_NE(
      lexicon_refusal(replaced(small, "[nopea]", "[hyvin]")).find("\"hyvin\" has a second meaning"),
      std::string::npos);
}

TEST(Lexicon, RefusesUnknownScalesAndLanguages) {
  EXPECT_NE(lexicon_refusal(replaced(small, "  slow-fast: {low: {", "  slow-fist: {low: {"))
                .find("l.yaml:6:3: words.slow-fist: unknown scale \"slow-fist\"; did you mean "
                      "\"slow-fast\"?"),
            std::string::npos);
  EXPECT_NE(lexicon_refusal(replaced(small, "high: {finnish", "high: {svenska"))
                .find("unknown language \"svenska\"; describe it under languages"),
            std::string::npos);
}

TEST(Lexicon, RefusesTwoLanguagesOfOneName) {
  EXPECT_NE(lexicon_refusal(replaced(small, "words:\n", "  other: {called: [suomi]}\nwords:\n"))
                .find("is also named \"suomi\"; name each language once"),
            std::string::npos);
}

TEST(Lexicon, IsEmptyWithoutWords) { EXPECT_TRUE(builtin_scales().lexicon.languages.empty()); }

TEST(WalkingWords, KeepTheirSchemaAndHaveThreeLanguages) {
  const ScaleSet set = read_scales(MIEN_SOURCE_DIR "/manifests/walking-words.scales.yaml");
  ASSERT_EQ(set.lexicon.languages.size(), 3u);
  for (const Language& language : set.lexicon.languages) {
    EXPECT_GT(language.words.size(), 80u) << language.name;
  }
}

TEST(WalkingWords, NameScalesOfTheBuiltInPairsTheSame) {
  const ScaleSet set = read_scales(MIEN_SOURCE_DIR "/manifests/walking-words.scales.yaml");
  const ScaleSet builtin = builtin_scales();
  int shared = 0;
  for (const Scale& scale : set.scales) {
    const Scale* pair = find_scale(builtin, scale.id);
    if (pair == nullptr) continue;
    ++shared;
    EXPECT_EQ(scale.low, pair->low);
    EXPECT_EQ(scale.high, pair->high);
    EXPECT_EQ(scale.japanese_low, pair->japanese_low);
    EXPECT_EQ(scale.japanese_high, pair->japanese_high);
  }
  EXPECT_GT(shared, 15);
}

}  // namespace
}  // namespace mien::pipeline
