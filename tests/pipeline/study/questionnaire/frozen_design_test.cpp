#include "pipeline/study/questionnaire/frozen_design.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// A study whose videos are texts, and its bundle.
class FrozenDesign : public testing::Test {
 protected:
  FrozenDesign() {
    for (const ShownMedia& media : shown_media(manifest_)) {
      fs::create_directories((made_ / media.path).parent_path());
      write_file(made_ / media.path, "video of " + media.stimulus);
    }
  }

  Manifest manifest(const std::string& more, int stimuli = 5) const {
    const fs::path file = folder_.path() / "m.yaml";
    write_file(file, test::asked_study_text(
                         stimuli,
                         "participants: 4, scales: [sad-happy], consent: {file: c.txt}, "
                         "analysis: {plan: two t tests}" +
                             more));
    const ManifestReading reading =
        read_manifest(file, [](const std::string&) { return std::nullopt; });
    if (!reading.faults.empty()) throw Faults(reading.faults);
    return reading.manifest;
  }

  ZipFiles files() const {
    const auto plans = plan_sessions(manifest_);
    ZipFiles files = frozen_design(manifest_, plans, made_);
    add_dummy_answers(files, manifest_, plans);
    return files;
  }

  std::string differences(const Manifest& now, const fs::path& made) const {
    std::string text;
    for (const std::string& one : frozen_differences(bundle_, now, made)) text += one + "\n";
    return text;
  }

  static bool holds(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  }

  void put_consent(const std::string& text) const { write_file(folder_.path() / "c.txt", text); }

  test::TemporaryFolder folder_;
  fs::path made_ = folder_.path() / "out";
  fs::path bundle_ = folder_.path() / "frozen.zip";
  bool has_consent_ = (put_consent("I agree."), true);
  Manifest manifest_ = manifest("");
};

TEST_F(FrozenDesign, IsTheSameBytesAndHoldsWhatItRestsOn) {
  const std::string bytes = zip_of(files());
  EXPECT_EQ(zip_of(files()), bytes);
  const ZipFiles again = unzipped(bytes, "frozen.zip");
  EXPECT_EQ(again, files());
  EXPECT_EQ(again.at("inputs/c.txt"), "I agree.");
  EXPECT_TRUE(holds(again.at("scale_words.csv"), "sad-happy,ja,"));
  EXPECT_EQ(
      again.at("analysis-plan.txt"),
      "two t tests\n\nAll tests are two-sided with α = 0.05; p values are corrected within each "
      "family of comparisons (holm).\n\nmien study report computes in any case:\n- Ratings on each "
      "scale are analysed by a repeated-measures analysis of variance with the factors actor and "
      "emotion within participants, as far as their levels are crossed, with p values corrected by "
      "Greenhouse and Geisser's method.\n- Participants without an analysed rating in each cell of "
      "the design are left out of the analysis of variance of that scale.\n- All pairs of levels "
      "of the factors actor and emotion are compared within participants by paired t tests and "
      "Wilcoxon signed-rank tests; the pairs of a factor on all scales form one family.\n- The "
      "answers of participants who do not finish are included.\n");
  EXPECT_TRUE(holds(again.at("stimuli.csv"), "a1,videos/a1.mp4,"));
  EXPECT_TRUE(holds(again.at("dummy-report/answers.csv"), "simulated"));
}

TEST_F(FrozenDesign, HasNoColumnsOfAnswersThatIdentifyParticipants) {
  Manifest rated = manifest_;
  rated.ratings.source = Ratings::Source::file;
  rated.ratings.file = folder_.path() / "answers.csv";
  write_file(rated.ratings.file,
             "participant,stimulus,scale,value,url_PROLIFIC_PID\np1,sad,sad-happy,1,5f01\n");
  const ZipFiles frozen = frozen_design(rated, plan_sessions(rated), made_);
  const std::string kept = "participant,stimulus,scale,value\np1,sad,sad-happy,1\n";
  EXPECT_EQ(frozen.at("inputs/answers.csv"), kept);
  EXPECT_TRUE(holds(frozen.at("inputs.csv"), ("inputs/answers.csv," + hash_of(kept)).c_str()));
}

TEST_F(FrozenDesign, SaysThatTheDummyReportIsWithoutEffects) {
  EXPECT_TRUE(
      holds(files().at("README.txt"),
            "The dummy report. Its answers are simulated without any effect of the stimuli: "
            "the true rating of every stimulus on every scale is the middle of the scale."));
  EXPECT_EQ(dummy_assumptions(manifest_).find("intended emotion"), std::string::npos);
  Manifest other = manifest_;
  other.questionnaire->trials = &emotion_form;
  EXPECT_TRUE(holds(dummy_assumptions(other), "The intended emotion is chosen in 60 %"));
  other.questionnaire->trials = &same_different_form;
  EXPECT_TRUE(holds(dummy_assumptions(other), "their true sensitivity is 0 (d' = 0)."));
  EXPECT_FALSE(holds(dummy_assumptions(other), "middle of the scale"));
  other.questionnaire->attention_every = 5;
  EXPECT_TRUE(holds(dummy_assumptions(other), "All attention checks are passed."));
}

TEST_F(FrozenDesign, TellsWhatIsNoLongerAsItWas) {
  write_file(bundle_, zip_of(files()));
  EXPECT_EQ(differences(manifest_, made_), "");
  EXPECT_TRUE(holds(differences(manifest_, {}), "stimuli: not compared"));
  write_file(made_ / "videos/b2.mp4", "another");
  EXPECT_EQ(differences(manifest_, made_), "stimuli: b2 changed\n");
  write_file(made_ / "videos/b2.mp4", "video of b2");
  EXPECT_TRUE(holds(differences(manifest(", comments: true"), made_), "design: what participants"));
  const std::string order = differences(manifest(", order: latin"), made_);
  EXPECT_TRUE(holds(order, "plans of participants: p001, p002")) << order;
  EXPECT_TRUE(holds(differences(manifest(""), made_), ""));
  Manifest looser = manifest("");
  looser.questionnaire->analysis.alpha = 0.1;
  EXPECT_TRUE(holds(differences(looser, made_), "analysis: alpha: 0.1 instead of 0.05\n"));
  looser.questionnaire->analysis.factorial.factors = {"a factor"};
  const std::string stated = differences(looser, made_);
  EXPECT_TRUE(holds(stated, "analysis: factors: not in the registered design\n")) << stated;
  put_consent("I do not agree.");
  EXPECT_TRUE(holds(differences(manifest(""), made_), "inputs/c.txt changed"));
}

TEST_F(FrozenDesign, TellsAnotherNumberOfParticipantsAsThatAndNotAsAnotherDesign) {
  write_file(bundle_, zip_of(files()));
  Manifest more = manifest_;
  more.questionnaire->participants = 9;
  EXPECT_EQ(differences(more, made_),
            "participants: the manifest plans 9 instead of the registered 4; everything that "
            "follows is compared for the registered number\n");
  more.questionnaire->comments = true;
  EXPECT_TRUE(holds(differences(more, made_), "design: what participants see differs"));
}

TEST_F(FrozenDesign, IsRefusedWhereSomebodyChangedIt) {
  ZipFiles changed = files();
  changed["plans.csv"] += "p005,1,main,rating,a1,,sad-happy,,0,0,0,,1\n";
  write_file(bundle_, zip_of(changed));
  EXPECT_THROW(frozen_differences(bundle_, manifest_, made_), Error);
  write_file(bundle_, zip_of({{"a.txt", "a"}}));
  EXPECT_THROW(frozen_differences(bundle_, manifest_, made_), Error);
  write_file(bundle_, "no archive");
  EXPECT_THROW(frozen_differences(bundle_, manifest_, made_), Error);
}

TEST_F(FrozenDesign, HasSimulatedParticipantsWhereTheyAreAskedAboutThemselves) {
  EXPECT_FALSE(files().contains("dummy-report/participants.csv"));
  manifest_ = manifest(", demographics: [{id: hand, ask: Hand, answer: [left, right]}]");
  EXPECT_TRUE(holds(files().at("dummy-report/participants.csv"), "hand"));
}

TEST_F(FrozenDesign, SaysWhereNoAnalysisWasPlanned) {
  Manifest without = manifest_;
  without.questionnaire->analysis.plan = {};
  const ZipFiles files = frozen_design(without, plan_sessions(without), made_);
  EXPECT_TRUE(holds(files.at("analysis-plan.txt"), "No analysis plan"));
}

TEST_F(FrozenDesign, StatesTheQualityRulesAndWhereTheyDiffer) {
  const ZipFiles before = files();
  EXPECT_FALSE(holds(before.at("design.json"), "quality"));
  manifest_.questionnaire->analysis.quality.max_longstring = 12;
  const ZipFiles after = files();
  EXPECT_TRUE(after.at("analysis-plan.txt")
                  .find("(holm).\n\nQuality rules, stated before the data are collected") !=
              std::string::npos);
  EXPECT_TRUE(holds(after.at("design.json"), "\"quality\": {\n      \"max_longstring\": 12\n"));
  write_file(bundle_, zip_of(after));
  EXPECT_EQ(differences(manifest_, made_), "");
  Manifest looser = manifest_;
  looser.questionnaire->analysis.quality.max_longstring = 13;
  EXPECT_EQ(differences(looser, made_), "analysis: quality: max_longstring: 13 instead of 12\n");
  Manifest kept = manifest_;
  kept.questionnaire->analysis.quality.flagged = FlaggedAnswers::kept;
  EXPECT_EQ(differences(kept, made_), "analysis: quality: flagged: not in the registered design\n");
}

TEST_F(FrozenDesign, TellsAnotherPlanOnlyWhereItsTextDiffers) {
  write_file(bundle_, zip_of(files()));
  Manifest other = manifest_;
  other.questionnaire->analysis.alpha = 0.01;
  EXPECT_EQ(differences(other, made_), "analysis: alpha: 0.01 instead of 0.05\n");
  other = manifest_;
  other.questionnaire->analysis.plan.text += " and a third";
  EXPECT_EQ(differences(other, made_), "analysis: the text of the plan differs\n");
  other.questionnaire->analysis.plan = {};
  EXPECT_EQ(differences(other, made_), "analysis: the text of the plan differs\n");
}

TEST_F(FrozenDesign, StatesFactorsAndContrastsAndWhereTheyDiffer) {
  const ZipFiles before = files();
  EXPECT_FALSE(holds(before.at("design.json"), "contrasts"));
  FactorialPlan& plan = manifest_.questionnaire->analysis.factorial;
  plan.factors = {"actor"};
  plan.contrasts = {{"first", {{"actor", {{"a", 1.0}, {"b", -1.0}}}}, {}, {}}};
  const ZipFiles after = files();
  EXPECT_TRUE(after.at("analysis-plan.txt")
                  .find("(holm).\n\nAnalysis of variance of each scale by the factor actor within "
                        "participants") != std::string::npos);
  EXPECT_TRUE(holds(after.at("analysis-plan.txt"), "- “first” (a − b)\n"));
  EXPECT_EQ(before.at("plans.csv"), after.at("plans.csv"));
  write_file(bundle_, zip_of(after));
  EXPECT_EQ(differences(manifest_, made_), "");
  Manifest other = manifest_;
  other.questionnaire->analysis.factorial.contrasts[0].weights[0].second[1].first = "c";
  EXPECT_FALSE(holds(differences(other, made_), "the plan"));
  EXPECT_TRUE(holds(differences(other, made_), "\"weights\":{\"actor\":{\"a\":1.0,\"c\":-1.0}}"));
}

TEST_F(FrozenDesign, NeedsTheStudyToBeMade) {
  fs::remove(made_ / "videos/c3.mp4");
  EXPECT_THROW(files(), Error);
}

}  // namespace
}  // namespace mien::pipeline
