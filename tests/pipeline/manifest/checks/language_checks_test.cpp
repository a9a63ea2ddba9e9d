#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

std::string language_faults(const std::string& members, const fs::path& folder = "/nowhere") {
  const ManifestReading reading =
      parse_manifest(test::asked_study_text(5, members), folder / "m.yaml",
                     [](const std::string&) { return std::nullopt; });
  std::string text = reading.faults.empty() ? "" : Faults(reading.faults).what();
  const std::string prefix = folder.string() + "/";
  while (text.find(prefix) != text.npos) text.erase(text.find(prefix), prefix.size());
  return text;
}

constexpr char in_two[] = "participants: 4, scales: emotions, language: {browser: [en, ja]}, ";

TEST(LanguageChecks, AcceptOneLanguageWithTextsAsTheyAreWritten) {
  for (const char* language : {"en", "ja", "de", "fr", "es", "fi", "zh", "ar"})
    EXPECT_EQ(
        language_faults("participants: 4, scales: all, title: Walks, consent: Yes., language: " +
                        std::string(language)),
        "");
}

TEST(LanguageChecks, AcceptSeveralLanguagesWithAllTextsInEach) {
  EXPECT_EQ(
      language_faults(std::string(in_two) +
                      "title: {en: Walks, ja: 歩行, de: Gang}, consent: {en: 'Yes.', ja: はい。}, "
                      "question: {ja: 何, en: What}, trials: emotion, "
                      "choices: {sad: {en: sad, ja: 悲}, happy: {en: happy, ja: 嬉}}, "
                      "demographics: [{id: hand, ask: {en: Hand, ja: 手}, "
                      "answer: {en: [left, right], ja: [左, 右]}}]"),
      "");
}

TEST(LanguageChecks, NameWhatIsMissingInALanguage) {
  struct Wrong {
    std::string members;
    std::string fault;
  };
  const std::string two(in_two);
  const Wrong wrong_ones[] = {
      {two + "title: Walks",
       "questionnaire.title: is in one language, but the pages are in en and ja; write {en: …, "
       "ja: …}"},
      {two + "title: {en: Walks, de: Gang}", "questionnaire.title: has no text in ja; add ja: …"},
      {two + "title: {en: Walks, ja: 歩行, xx: Gang}",
       "questionnaire.title.xx: unknown language; use one of \"en\", \"ja\", \"de\", \"fr\", "
       "\"es\", \"fi\", \"zh\", \"ar\""},
      {two + "consent: {en: 'Yes.'}", "questionnaire.consent: has no text in ja; add ja: …"},
      {two + "answer: {words: true, suggest: [happy]}",
       "questionnaire.answer.suggest: is in one language, but the pages are in en and ja; write "
       "{en: …, ja: …}"},
      {two + "demographics: [{id: a, ask: Which, answer: number}]",
       "questionnaire.demographics[0].ask: is in one language, but the pages are in en and ja; "
       "write {en: …, ja: …}"},
      {two + "demographics: [{id: a, ask: {en: A, ja: B}, answer: {en: [l, r], ja: [左]}}]",
       "questionnaire.demographics[0].answer.ja: has 1 word, but there are 2 in en; give the "
       "same words in the same order in all languages"},
      {two + "screening: {questions: [{id: a, ask: {en: A}, answer: number}]}",
       "questionnaire.screening.questions[0].ask: has no text in ja; add ja: …"},
      {two + "trials: emotion",
       "questionnaire.trials: the levels of the factor emotion have no texts in en and ja; add "
       "choices: {sad: {en: …, ja: …}}"},
      {"participants: 4, scales: emotions, language: {browser: [en, de]}",
       "questionnaire.scales: sad-happy and 5 more scales have no words in de; add de: [low, "
       "high] to them in a scales file"},
      {"participants: 4, scales: all, language: xx",
       "questionnaire.language: there are no texts of pages in \"xx\"; use one of \"en\", "
       "\"ja\", \"de\", \"fr\", \"es\", \"fi\", \"zh\", \"ar\", or add them: texts: my.yaml"},
      {"participants: 4, scales: all, language: {browser: [en, en]}",
       "questionnaire.language.browser[1]: \"en\" appears twice; name it once"},
      {"participants: 4, scales: all, language: english language",
       "questionnaire.language: \"english language\" is not a language: write its tag; for example "
       "de"},
      {"participants: 4, scales: all, texts: my.yaml", "questionnaire.texts: "},
  };
  for (const Wrong& wrong : wrong_ones) {
    const std::string text = language_faults(wrong.members);
    EXPECT_NE(text.find(wrong.fault), text.npos) << wrong.members << "\n" << text;
    EXPECT_TRUE(text.starts_with("m.yaml:5:")) << text;
    EXPECT_EQ(text.find('\n'), text.npos) << text;
  }
}

TEST(LanguageChecks, ReadFilesOfTextsAndTellWhatIsWrongInThem) {
  const test::TemporaryFolder folder;
  const std::string asked = "participants: 4, scales: all, texts: my.texts.yaml, language: ";
  write_file(folder.path() / "my.texts.yaml",
             "language: sv\ncomplete_from: en\nquestionnaire: {rate: Hur}\n");
  EXPECT_EQ(language_faults(asked + "sv", folder.path()), "");
  EXPECT_NE(language_faults(asked + "en", folder.path())
                .find("questionnaire.texts: no page is in the language of this file, sv; add it "
                      "to language: {browser: […]}, or omit the file"),
            std::string::npos);
  write_file(folder.path() / "my.texts.yaml",
             "language: sv\ncomplete_from: en\nquestionnaire: {raet: Hur}\n");
  EXPECT_EQ(language_faults(asked + "sv", folder.path()),
            "my.texts.yaml:3:17: questionnaire.raet: no page has this text; did you mean "
            "\"rate\"?");
}

TEST(LanguageChecks, KnowAFileOfTexts) {
  EXPECT_EQ(kind_of_document("language: sv\nquestionnaire: {rate: Hur}\n", "sv.yaml"),
            DocumentKind::texts);
  EXPECT_EQ(kind_of_document("questionnaire: {participants: 3}\n", "m.yaml"),
            DocumentKind::manifest);
}

TEST(LanguageChecks, RefuseMatchingWithSlidersWithoutNames) {
  const auto faults_with = [](const std::string& members) {
    const ManifestReading reading = parse_manifest(
        "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nmatching: {participants: 2, " +
            members + "}\nstimuli: [{id: a, role: target, weights: {sad: 1}}]\n",
        "m.yaml", [](const std::string&) { return std::nullopt; });
    return reading.faults.empty() ? std::string() : Faults(reading.faults).what();
  };
  EXPECT_EQ(faults_with("language: {browser: [en, ja]}"), "");
  EXPECT_EQ(faults_with("language: de"), "");
  EXPECT_EQ(faults_with("language: {browser: [de, en]}, interfaces: [weights]"), "");
  const std::string text = faults_with("language: {browser: [de, en]}");
  EXPECT_NE(text.find("motion features have no names in de"), text.npos) << text;
  EXPECT_NE(text.find("the group quickness has no name in de"), text.npos) << text;
  EXPECT_NE(text.find("slow-fast and 40 more scales have no words in de"), text.npos) << text;
}

}  // namespace
}  // namespace mien::pipeline
