#include "pipeline/manifest/texts/page_texts.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

JsonReading built_in_reading(const std::string& language) {
  std::vector<Fault> faults;
  return read_json(built_in_texts_yaml(language), language + ".yaml", json::object(), Environment(),
                   faults);
}

std::string faults_of_file(const std::string& yaml) {
  try {
    parse_texts(yaml, "my.yaml");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PageTexts, EveryLanguageHasTheKeysPlaceholdersAndPluralFormsOfItsRules) {
  EXPECT_EQ(built_in_languages(),
            (std::vector<std::string>{"en", "ja", "de", "fr", "es", "fi", "zh", "ar"}));
  for (const std::string& language : built_in_languages()) {
    const JsonReading reading = built_in_reading(language);
    const std::vector<Fault> faults = text_faults(reading.document, language, true, reading.places);
    EXPECT_TRUE(faults.empty()) << fault_lines(faults);
    EXPECT_EQ(reading.document["direction"], language == "ar" ? "rtl" : "ltr") << language;
    EXPECT_EQ(reading.document.size(), 5U) << language;
  }
}

TEST(PageTexts, LackATextThatIsRemovedFromAnyLanguage) {
  for (const std::string& language : built_in_languages()) {
    JsonReading reading = built_in_reading(language);
    reading.document["questionnaire"].erase("rate");
    const std::vector<Fault> faults = text_faults(reading.document, language, true, reading.places);
    ASSERT_EQ(faults.size(), 1U) << language;
    EXPECT_EQ(faults[0].wrong, "has no text \"rate\"");
    EXPECT_TRUE(text_faults(reading.document, language, false, reading.places).empty());
  }
}

TEST(PageTexts, CompleteAFileFromTheLanguageThatItStates) {
  const PageTexts own = parse_texts(
      "language: sv\ncomplete_from: de\n"
      "questionnaire:\n  rate: Hur ser rörelsen ut?\n"
      "  missing: {count: {one: Ett svar saknas., other: '{count} svar saknas.'}}\n"
      "matching:\n  sides: {front: Framsida}\n"
      "chains: {done: Klar}\n",
      "sv.yaml");
  EXPECT_EQ(own.language, "sv");
  const json& german = built_in_texts("de");
  EXPECT_EQ(own.texts["questionnaire"]["rate"], "Hur ser rörelsen ut?");
  EXPECT_EQ(own.texts["questionnaire"]["missing"]["count"]["one"], "Ett svar saknas.");
  EXPECT_EQ(own.texts["questionnaire"]["next"], german["questionnaire"]["next"]);
  EXPECT_EQ(own.texts["matching"]["sides"]["front"], "Framsida");
  EXPECT_EQ(own.texts["matching"]["sides"]["back"], german["matching"]["sides"]["back"]);
  EXPECT_EQ(own.texts["chains"]["done"], "Klar");
  EXPECT_EQ(own.texts["chains"]["make"], german["chains"]["make"]);
  EXPECT_EQ(own.texts["direction"], "ltr");
}

TEST(PageTexts, CompleteAFileOfABuiltInLanguageFromThatLanguage) {
  const PageTexts own = parse_texts("language: ar\nquestionnaire: {play: شغّل}\n", "ar.yaml");
  EXPECT_EQ(own.texts["direction"], "rtl");
  EXPECT_EQ(own.texts["questionnaire"]["play"], "شغّل");
  EXPECT_EQ(own.texts["questionnaire"]["next"], built_in_texts("ar")["questionnaire"]["next"]);
}

TEST(PageTexts, MustBeCompleteInALanguageThatNothingCompletes) {
  const std::string faults = faults_of_file("language: sv\nquestionnaire: {rate: Hur}\n");
  const char* remedy = "more; add it, or complete_from: a language with built-in texts";
  EXPECT_NE(faults.find("my.yaml:2:16: questionnaire: has no text \"about_you\" and "), faults.npos)
      << faults;
  EXPECT_NE(faults.find("my.yaml:1:1: matching: has no text \"add\" and "), faults.npos) << faults;
  EXPECT_NE(faults.find(remedy), faults.npos) << faults;
  EXPECT_EQ(std::ranges::count(faults, '\n'), 3) << faults;
}

TEST(PageTexts, RefuseWrongFilesWithThePlaceAndARemedy) {
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire:\n  raet: How?\n"),
            "my.yaml:3:3: questionnaire.raet: no page has this text; did you mean \"rate\"?");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire:\n  trial_of: '{number}'\n"),
            "my.yaml:3:13: questionnaire.trial_of: the placeholder {all} is missing; add it");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire:\n  trial_of: '{number} {al} {all}'\n"),
            "my.yaml:3:13: questionnaire.trial_of: the text has no placeholder {al}; did you "
            "mean \"all\"?");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire:\n  missing: '{count} left'\n"),
            "my.yaml:3:12: questionnaire.missing: has no plural forms; write {count: {one: …, "
            "other: …}}");
  EXPECT_EQ(faults_of_file("language: de\nquestionnaire:\n  missing: {count: {few: 'a', one: 'b',"
                           " other: '{count}'}}\n"),
            "my.yaml:3:21: questionnaire.missing.count.few: the language has no such plural "
            "category; use one of \"one\", \"other\"");
  EXPECT_EQ(faults_of_file("language: de\nquestionnaire:\n  missing: {count: {other: 'x {count}'"
                           "}}\n"),
            "my.yaml:3:20: questionnaire.missing.count: has no plural form \"one\"; add it");
  EXPECT_EQ(faults_of_file("language: de\nquestionnaire:\n  missing: {cuont: {other: x}}\n"),
            "my.yaml:3:13: questionnaire.missing.cuont: the text has no such placeholder; did you "
            "mean \"count\"?");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire: {rate: [a]}\n"),
            "my.yaml:2:23: questionnaire.rate: is not a text; write a text");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire: {rate: ''}\n"),
            "my.yaml:2:23: questionnaire.rate: is not a text; write a text");
  EXPECT_EQ(faults_of_file("language: en\nmatching: {how: One}\n"),
            "my.yaml:2:17: matching.how: is not a list of paragraphs; write [text, text]");
  EXPECT_EQ(faults_of_file("language: en\nchains: {make: Move the slider.}\n"),
            "my.yaml:2:16: chains.make: the placeholder {word} is missing; add it");
  EXPECT_EQ(faults_of_file("language: en\nquestionnaire: rate\n"),
            "my.yaml:2:16: questionnaire: is not a map of texts; write key: text");
  EXPECT_EQ(faults_of_file("language: e\n"),
            "my.yaml:1:11: language: the texts have no language; add language: and its tag, such "
            "as sv");
  EXPECT_EQ(faults_of_file("language: sv\ncomplete_from: sv\n"),
            "my.yaml:2:16: complete_from: has no built-in texts; use one of \"en\", \"ja\", "
            "\"de\", \"fr\", \"es\", \"fi\", \"zh\", \"ar\"");
  EXPECT_EQ(faults_of_file("language: en\ndirection: up\n"),
            "my.yaml:2:12: direction: is neither ltr nor rtl; write ltr or rtl");
  EXPECT_EQ(faults_of_file("language: en\nquestionaire: {}\n"),
            "my.yaml:2:1: questionaire: unknown key; did you mean \"questionnaire\"?");
}

TEST(PageTexts, TagsOfLanguagesHaveLettersDigitsAndHyphens) {
  for (const char* tag : {"en", "pt-BR", "zh-Hans", "sr-Latn-RS", "es-419", "fil"})
    EXPECT_TRUE(is_language_tag(tag)) << tag;
  for (const char* tag : {"", "e", "en-", "-en", "e-n", "en--GB", "e n", "1n", "deutschland-x-",
                          "../en", "abcdefghi"})
    EXPECT_FALSE(is_language_tag(tag)) << tag;
}

}  // namespace
}  // namespace mien::pipeline
