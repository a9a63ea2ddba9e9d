#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

constexpr char reported_text[] = R"(mien: 1
study: gaits
seed: 7
examples: {set: builtin:walks-10}
output: {size: [64, 48], fps: 10, cycles: 1, quality: draft, frames: none, video: [mp4]}
stimuli:
  - {id: usual, weights: {normal: 1}, factors: {made: as-is, emotion: normal}}
  - {id: sad, weights: {normal: 0.4, sad: 0.6}, factors: {made: modified, emotion: sad}}
questionnaire:
  participants: 6
  scales: [sad-happy]
)";

/// From a manifest over answers that nobody gave to a report, without any rendering.
class ReportedStudy : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(downloads);
    const Ended made = run_mien({"study", "simulate", study, "-o", answers});
    ASSERT_EQ(made.code, 0) << made.errors;
  }

  Ended report(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"study", "report", study, "-o", out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  /// The answers without the last, in another file.
  std::string cut_short() const {
    std::string text = text_of(answers);
    text.resize(text.rfind('\n', text.size() - 2) + 1);
    return folder.write("cut.csv", text).string();
  }

  const Scratch folder;
  const std::string study = folder.write("gaits.yaml", reported_text).string();
  const fs::path downloads = folder.path() / "export/answers/data";
  const std::string answers = (downloads / "all_description-answers_data.csv").string();
  const fs::path out = folder.path() / "report";
};

TEST_F(ReportedStudy, GoesFromDesignOverAnswersToTables) {
  const Ended design = run_mien({"study", "design", study});
  ASSERT_EQ(design.code, 0) << design.errors;
  EXPECT_NE(design.output.find("p006,"), std::string::npos);
  const Ended ended = report({(folder.path() / "export").string()});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.output.find("6 of 6 participants analysed"), std::string::npos) << ended.output;
  EXPECT_NE(text_of(out / "report.html").find("12 answers of 6 participants about 2 videos"),
            std::string::npos);
  EXPECT_NE(text_of(out / "results/comparisons.csv").find("modified-neutral,sad"),
            std::string::npos);
}

TEST_F(ReportedStudy, TellsAFileOfAnswersFromAManifest) {
  const Ended ended = report({folder.write("gaits-answers.db", "SQLite format 3").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("is the file of answers of a served study; save answers.csv"),
            std::string::npos)
      << ended.errors;
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(ReportedStudy, IsDesignedWithNumbersOfTrialsAndNotWithSpreadsOfOtherScales) {
  const std::string plans = (folder.path() / "plans.csv").string();
  const auto design = [&](const std::string& more, const std::vector<std::string>& words) {
    std::string text = reported_text;
    text.replace(text.find("scales: [sad-happy]"), 19, more);
    std::vector<std::string> all = {
        "study",     "design", folder.write("other.yaml", text).string(), "-o", plans, "--power",
        "--studies", "100"};
    all.insert(all.end(), words.begin(), words.end());
    return run_mien(all);
  };
  constexpr char refusal[] = "--spread 12.5,12.5,20 --difference 12.5";
  const Ended plain = design("scales: [sad-happy]\n  practice: [usual]", {});
  ASSERT_EQ(plain.code, 0) << plain.errors;
  EXPECT_NE(plain.output.find("gaits: 6 participants, 3 trials each: 2 analysed, 1 for practice\n"),
            std::string::npos)
      << plain.output;
  const std::string grid = "scales: [sad-happy]\n  trials: grid\n  grid: {sets: [[usual, sad]]}";
  const Ended unstated = design(grid, {});
  EXPECT_EQ(unstated.code, 2);
  EXPECT_NE(unstated.errors.find(refusal), std::string::npos) << unstated.errors;
  EXPECT_EQ(unstated.output.find("participants (simulation interval"), std::string::npos);
  EXPECT_EQ(design(grid, {"--spread", "8,8,15", "--difference", "10"}).code, 0);
}

TEST_F(ReportedStudy, IsNotDesignedIfFilmsEndBeforeTheLeadOfContinuousRatings) {
  std::string text = reported_text;
  text += "  trials: continuous\n  continuous: {lead: 10}\n";
  const std::string plans = (folder.path() / "plans.csv").string();
  const Ended ended =
      run_mien({"study", "design", folder.write("short.yaml", text).string(), "-o", plans});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("short.yaml:7:5: stimuli[0]: the film of \"usual\" lasts"),
            std::string::npos)
      << ended.errors;
  EXPECT_FALSE(fs::exists(plans));
}

// More participants change none of the earlier plans: it is the same design.
TEST_F(ReportedStudy, TakesAnswersOfMorePeopleThanWerePlanned) {
  const std::string more = (folder.path() / "more.csv").string();
  ASSERT_EQ(run_mien({"study", "simulate", study, "--participants", "8", "-o", more}).code, 0);
  const Ended ended = report({more});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_EQ(ended.errors, "");
  EXPECT_NE(ended.output.find("8 of 8 participants analysed"), std::string::npos) << ended.output;
  EXPECT_EQ(text_of(out / "report.html").find("the manifest"), std::string::npos);
}

// Frozen, then reported as it was frozen and otherwise.
TEST_F(ReportedStudy, IsHeldAgainstWhatWasFrozenWithItsOptions) {
  const std::string made = (folder.path() / "made").string();
  const std::string bundle = (folder.path() / "frozen.zip").string();
  ASSERT_EQ(run_mien({"run", study, "--out", made}).code, 0);
  const fs::path beside = bundle + ".part.d";  // a folder of the user's
  fs::create_directory(beside);
  const Ended frozen = run_mien({"study", "design", study, "-o", (folder.path() / "p.csv").string(),
                                 "--freeze", bundle, "--out", made});
  ASSERT_EQ(frozen.code, 0) << frozen.errors;
  EXPECT_NE(frozen.errors.find("the manifest has no analysis plan"), std::string::npos)
      << frozen.errors;
  EXPECT_NE(frozen.errors.find("the archive states that the videos are of draft quality"),
            std::string::npos)
      << frozen.errors;
  EXPECT_EQ(frozen.errors.find("completion codes"), std::string::npos) << frozen.errors;
  const std::string paid =
      folder
          .write("paid.yaml",
                 reported_text + std::string("  recruitment: {prolific: {completed: CPAID01}}\n"))
          .string();
  const Ended with_code =
      run_mien({"study", "design", paid, "-o", (folder.path() / "paid.csv").string(), "--freeze",
                (folder.path() / "paid.zip").string(), "--out", made});
  EXPECT_NE(with_code.errors.find("the archive contains the manifest with its completion codes"),
            std::string::npos)
      << with_code.errors;
  EXPECT_TRUE(fs::is_directory(beside));
  const std::string names = text_of(bundle);  // those of a zip stand in it as they are
  EXPECT_NE(names.find("dummy-report/report.html"), std::string::npos);
  EXPECT_NE(names.find("dummy-report/results/means.csv"), std::string::npos);
  EXPECT_EQ(names.find("dummy-report/results/participant_flow.csv"), std::string::npos);
  const auto count_of = [](const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_NE(frozen.errors.find("the archive states no power analysis"), std::string::npos)
      << frozen.errors;
  const std::string with_power = (folder.path() / "power.zip").string();
  const Ended powered =
      run_mien({"study", "design", study, "-o", (folder.path() / "p.csv").string(), "--freeze",
                with_power, "--out", made, "--power", "--studies", "100"});
  ASSERT_EQ(powered.code, 0) << powered.errors;
  // Before its bytes, in the list of checksums and in the list at the end.
  EXPECT_EQ(count_of(text_of(with_power), "power.txt"), count_of(names, "power.txt") + 3);
  EXPECT_EQ(powered.errors.find("no power analysis"), std::string::npos) << powered.errors;

  const Ended same = report({answers, "--frozen", bundle, "--studies", made});
  EXPECT_NE(same.output.find("No differences from the study registered in frozen.zip. The answers "
                             "are simulated. Sessions of 6 of the 6 registered participants, 6 of "
                             "them analysed."),
            std::string::npos)
      << same.output << same.errors;
  const std::string all = text_of(answers);
  const std::string two = folder.write("two.csv", all.substr(0, all.find("\np003,") + 1)).string();
  const Ended so_far = report({two, "--frozen", bundle, "--studies", made});
  EXPECT_NE(so_far.output.find("Sessions of 2 of the 6 registered participants so far, 2 of them "
                               "analysed."),
            std::string::npos)
      << so_far.output << so_far.errors;
  const Ended other = report({answers, "--frozen", bundle, "--studies", made, "--correction",
                              "none", "--max-failed-checks", "5"});
  EXPECT_NE(other.output.find("The study differs from the one registered"), std::string::npos)
      << other.output;
  for (const char* told : {"--correction none instead of the registered holm",
                           "--max-failed-checks 5 instead of the registered 1"})
    EXPECT_NE(other.output.find(told), std::string::npos) << other.output;
  EXPECT_NE(text_of(out / "report.html")
                .find("Deviation from the analysis that the manifest states: --max-failed-checks 5 "
                      "instead of 1."),
            std::string::npos);
}

TEST_F(ReportedStudy, HasADummyReportWithParticipantsWhereTheyAreAskedAboutThemselves) {
  const std::string made = (folder.path() / "made").string();
  const std::string asked = std::string(reported_text) +
                            "  demographics: [{id: hand, ask: Hand, answer: [left, right]}]\n";
  const std::string own = folder.write("asked.yaml", asked).string();
  ASSERT_EQ(run_mien({"run", own, "--out", made}).code, 0);
  const std::string bundle = (folder.path() / "asked.zip").string();
  const Ended frozen = run_mien({"study", "design", own, "-o", (folder.path() / "p.csv").string(),
                                 "--freeze", bundle, "--out", made});
  ASSERT_EQ(frozen.code, 0) << frozen.errors;
  const std::string names = text_of(bundle);
  for (const char* name : {"dummy-report/participants.csv", "dummy-report/results/demographics.csv",
                           "dummy-report/results/participant_flow.csv"})
    EXPECT_NE(names.find(name), std::string::npos) << name;
}

TEST_F(ReportedStudy, CountsWhatWasSavedTwiceOnce) {
  fs::copy_file(answers, downloads / "all_description-answers_data (1).csv");
  const Ended ended = report({(folder.path() / "export").string()});
  ASSERT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.errors.find("2 answers were saved more than once and counted once"),
            std::string::npos)
      << ended.errors;
  EXPECT_NE(text_of(out / "report.html").find("12 answers"), std::string::npos);
}

TEST_F(ReportedStudy, TellsWhoDidNotFinishAndLeavesThemOutWhenAsked) {
  const std::string cut = cut_short();
  const Ended kept = report({cut});
  EXPECT_NE(kept.errors.find("\"p006\" did not finish (1 of 2 trials): answers given are included"),
            std::string::npos)
      << kept.errors;
  EXPECT_NE(kept.output.find("6 of 6 participants analysed"), std::string::npos);
  const Ended left_out = report({cut, "--unfinished", "leave-out"});
  EXPECT_NE(left_out.output.find("5 of 6 participants analysed"), std::string::npos)
      << left_out.output;
}

TEST_F(ReportedStudy, RefusesAnswersSeparatedBySemicolons) {
  std::string text = text_of(answers);
  for (char& c : text)
    if (c == ',') c = ';';
  const Ended ended = report({folder.write("semicolons.csv", text).string()});
  EXPECT_NE(ended.code, 0);
  EXPECT_NE(ended.errors.find("is separated by ;, not by commas"), std::string::npos)
      << ended.errors;
}

// A file's name becomes a folder's.
TEST(StudyResults, LieInNoFolderThatANameLeadsOutTo) {
  const Scratch folder;
  const std::string walks = (folder.path() / "...csv").string();
  ASSERT_EQ(run_mien({"study", "simulate", "--examples", "builtin:walks-10", "-o", walks}).code, 0);
  const std::string matches =
      folder.write("x/...csv",
                   "participant,target,interface,first_guess_d,time_s,success\n"
                   "p1,a,weights,0.1,10,1\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"study", "analyze", walks, "--examples", "builtin:walks-10"},
        std::vector<std::string>{"study", "evaluate", matches}}) {
    const Ended ended = run_mien(words);
    EXPECT_EQ(ended.code, 2) << ended.errors;
    EXPECT_NE(ended.errors.find("...csv: the name \"..\" "), std::string::npos) << ended.errors;
  }
}

}  // namespace
}  // namespace mien::test
