#include "pipeline/manifest/study_texts.h"

#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

constexpr char study[] = R"(mien: 1
study: s
examples: {set: builtin:walks-10}
stimuli: [{id: a, weights: {sad: 1}}]
questionnaire:
  participants: 2
  scales: {file: mood.scales.yaml}
  language: {browser: [de, en]}
  title: {en: Walks, de: Gangarten}
  consent: {en: {file: consent.txt}, de: Ja.}
  demographics:
    - {id: hand, ask: {en: Hand, de: Die Hand}, answer: {de: [links, rechts], en: [left, right]}}
)";

class StudyTexts : public testing::Test {
 protected:
  StudyTexts() {
    write_file(folder_.path() / "consent.txt", "I agree.\n");
    write_file(folder_.path() / "mood.scales.yaml",
               "scales:\n  sad-happy: {low: sad, high: happy, de: [traurig, froh], ja: [悲, 嬉], "
               "in: {sv: [ledsen, glad]}}\n");
  }

  Manifest read(const std::string& text) const {
    ManifestReading reading = parse_manifest(text, folder_.path() / "m.yaml",
                                             [](const std::string&) { return std::nullopt; });
    EXPECT_TRUE(reading.faults.empty()) << fault_lines(reading.faults);
    return std::move(reading.manifest);
  }

  test::TemporaryFolder folder_;
};

TEST_F(StudyTexts, AreThoseOfTheFirstLanguageUnlessAnotherIsAskedFor) {
  const Manifest manifest = read(study);
  EXPECT_EQ(title_of(manifest), "Gangarten");
  EXPECT_EQ(manifest.questionnaire->consent.text, "Ja.");
  const Manifest english = in_language(manifest, "en");
  EXPECT_EQ(title_of(english), "Walks");
  EXPECT_EQ(english.questionnaire->consent.text, "I agree.\n");
  EXPECT_EQ(english.questionnaire->demographics[0].ask.text, "Hand");
  EXPECT_EQ(english.questionnaire->demographics[0].answer.choices.words,
            (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(english.questionnaire->language, (PageLanguage{{"en"}, false}));
}

TEST_F(StudyTexts, AreReadBackAsTheyAreWritten) {
  const Manifest manifest = read(study);
  const std::string yaml = manifest_yaml(manifest, folder_.path());
  EXPECT_NE(yaml.find("language: {browser: [de, en]}"), yaml.npos) << yaml;
  EXPECT_EQ(manifest_yaml(read(yaml), folder_.path()), yaml);
  EXPECT_EQ(in_language(read(yaml), "en").questionnaire->consent.text, "I agree.\n");
}

TEST_F(StudyTexts, OfScalesAreInTheirLanguages) {
  const Scale scale = questionnaire_scales(read(study)).scales.front();
  using Ends = std::array<std::string, 2>;
  EXPECT_EQ(ends_in(scale, "en"), (Ends{"sad", "happy"}));
  EXPECT_EQ(ends_in(scale, "de"), (Ends{"traurig", "froh"}));
  EXPECT_EQ(ends_in(scale, "ja"), (Ends{"悲", "嬉"}));
  EXPECT_EQ(ends_in(scale, "sv"), (Ends{"ledsen", "glad"}));
  EXPECT_EQ(ends_in(scale, "fr"), std::nullopt);
}

}  // namespace
}  // namespace mien::pipeline
