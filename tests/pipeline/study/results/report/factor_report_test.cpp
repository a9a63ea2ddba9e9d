#include <map>
#include <regex>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/plot_texts.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/report/results_report.h"
#include "pipeline/study/results/two_emotions.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// Of simulated answers, with a table of participants as CSV.
Results results_on(const Manifest& manifest, const std::string& people = "") {
  const std::vector<AnswerRow> rows = answers_to(manifest);
  ParticipantTable table;
  if (!people.empty()) table = {parse_csv(people, "participants.csv")};
  return results_of(collect_answers(manifest, rows), rows, table);
}

std::map<std::string, std::string> report_on(const Manifest& manifest,
                                             const std::string& people = "") {
  const test::TemporaryFolder folder;
  const fs::path report = folder.path() / "report";
  clear_results_folder(report);
  write_results(results_on(manifest, people), answers_to(manifest), {}, report);
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(report))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), report).generic_string()] = read_file(entry.path());
  return files;
}

TEST(FactorReport, HasTheFactorsOfTheDesign) {
  const auto files = report_on(two_emotion_study(5));
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("<section id=\"factors\">"), std::string::npos);
  EXPECT_NE(page.find("Factors within participants: made (acted, modified) × emotion (sad, happy)"),
            std::string::npos);
  const CsvTable table = parse_csv(files.at("results/anova.csv"), "anova.csv");
  std::vector<std::string> effects;
  for (const auto& row : table.rows) effects.push_back(row[0].text + ": " + row[1].text);
  EXPECT_EQ(effects,
            (std::vector<std::string>{"sad-happy: made", "sad-happy: emotion",
                                      "sad-happy: made × emotion", "weak-strong: made",
                                      "weak-strong: emotion", "weak-strong: made × emotion"}));
  EXPECT_EQ(page.find("<h3>Planned contrasts</h3>"), std::string::npos) << "none is planned";
}

/// Three women and five men.
std::string gender_of_eight() {
  std::string people = "participant,gender\n";
  for (int i = 1; i <= 8; ++i) people += fmt::format("p{:03},{}\n", i, i < 4 ? "woman" : "man");
  return people;
}

/// The design of a study with two stimuli in each cell, groups, slopes and contrasts.
Manifest planned_study() {
  Manifest manifest = two_emotion_study(8);
  const std::vector<Stimulus> once = manifest.stimuli;
  for (Stimulus stimulus : once) {
    stimulus.id = "man-" + stimulus.id;
    stimulus.factors[0].second = "man";
    manifest.stimuli.push_back(stimulus);
  }
  FactorialPlan& plan = manifest.questionnaire->analysis.factorial;
  plan.factors = {"made", "emotion"};
  plan.between = "gender";
  plan.random_slopes = true;
  plan.contrasts = {
      {"\"modified\" − acted\n", {{"made", {{"modified", 1.0}, {"acted", -1.0}}}}, {}, {}},
      {"only sad",
       {{"made", {{"modified", 1.0}, {"acted", -1.0}}}},
       {{"emotion", "sad"}},
       {"sad-happy"}}};
  return manifest;
}

TEST(FactorReport, WritesScriptsWithTheFactorsAndContrastsOfTheReport) {
  const auto files = report_on(planned_study(), gender_of_eight());
  const std::string& mixed = files.at("analysis/lme4.R");
  for (const char* part :
       {"value ~ made * emotion * gender + (1 + made + emotion | participant) + (1 | stimulus)",
        "isSingular(model)", "\"\\\"modified\\\" − acted\\n\" = c(-0.5, -0.5, 0.5, 0.5)",
        "\"only sad\" = c(-1, 0, 1, 0)",
        "stimulus = c(\"acted-sad\", \"man-acted-sad\", \"acted-happy\"",
        "levels = c(\"sad\", \"happy\")"})
    EXPECT_NE(mixed.find(part), std::string::npos) << part;
  EXPECT_NE(
      files.at("analysis/ordinal.R").find("clmm(answer ~ made * emotion * gender + (1 + made"),
      std::string::npos);
  EXPECT_NE(
      files.at("analysis/afex.R").find("within = c(\"made\", \"emotion\"), between = \"gender\""),
      std::string::npos);
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("<h3>Planned contrasts</h3>"), std::string::npos);
  EXPECT_NE(page.find("gender × made × emotion"), std::string::npos);
  EXPECT_NE(page.find("with the factors of the videos within participants and gender between them"),
            std::string::npos);
  EXPECT_NE(page.find("analysis/afex.R"), std::string::npos);
}

TEST(FactorReport, WritesScriptsWithTheGroupsOfTheReport) {
  std::string people = gender_of_eight();
  people.replace(people.find("p008,man"), 8, "p008,other");  // alone in a group
  const auto files = report_on(planned_study(), people);
  for (const char* script : {"analysis/afex.R", "analysis/lme4.R"}) {
    EXPECT_NE(files.at(script).find("\"sad-happy man\", \"sad-happy woman\""), std::string::npos)
        << files.at(script);
    EXPECT_EQ(files.at(script).find("happy other"), std::string::npos) << script;
  }
}

TEST(FactorReport, WritesScriptsThatReadTextsAsTexts) {
  const std::string script = report_on(two_emotion_study(5)).at("analysis/lme4.R");
  std::smatch list;
  ASSERT_TRUE(std::regex_search(script, list, std::regex(R"(texts <- c\(([^)]*)\))")));
  const std::string texts = list[1];
  const std::regex quoted("\"([^\"]*)\"");
  std::set<std::string> names;
  for (std::sregex_iterator at(texts.begin(), texts.end(), quoted), end; at != end; ++at)
    names.insert((*at)[1]);
  for (const std::string& name : names)
    EXPECT_NE(find_column(answer_form, name), nullptr) << name << " would be a warning in R";
  for (const char* name : {"stimulus", "item", "kind", "value_raw", "against", "block", "level"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_NE(script.find("na.strings = \"\""), std::string::npos) << "\"NA\" is a text";
}

TEST(FactorReport, WritesScriptsThatMatchGroupsByTheNamesOfTheData) {
  const std::string script = report_on(planned_study(), gender_of_eight()).at("analysis/afex.R");
  EXPECT_NE(script.find("match(counted$participant, people$participant)"), std::string::npos);
}

TEST(FactorReport, WritesScriptsWithOtherNamesForFactorsThatAreCalledLikeColumns) {
  Manifest manifest = two_emotion_study(5);
  for (Stimulus& stimulus : manifest.stimuli)
    for (auto& [factor, level] : stimulus.factors)
      if (factor == "emotion") factor = "level";
  manifest.questionnaire->analysis.factorial.factors = {"made", "level"};
  const std::string script = report_on(manifest).at("analysis/lme4.R");
  EXPECT_NE(script.find("value ~ made * level_ + "), std::string::npos) << script;
}

TEST(FactorReport, WritesNoRandomStimuliWhereEachCellHasOne) {
  const auto files = report_on(two_emotion_study(5));
  const std::string& mixed = files.at("analysis/lme4.R");
  EXPECT_NE(mixed.find("value ~ made * emotion + (1 | participant), data"), std::string::npos);
  EXPECT_EQ(mixed.find("(1 | stimulus)"), std::string::npos);
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("fit mixed models with random participants (each cell of the design has one "
                      "video, which cannot be told apart from the cell)"),
            std::string::npos);
  EXPECT_EQ(page.find("random stimuli"), std::string::npos);
  EXPECT_EQ(page.find("participants and stimuli"), std::string::npos);
}

TEST(FactorReport, NamesTheRandomEffectsOfTheScripts) {
  const std::string page = report_on(planned_study(), gender_of_eight()).at("report.html");
  EXPECT_NE(page.find("fit mixed models with random participants and stimuli"), std::string::npos);
  EXPECT_NE(page.find("analysis/lme4.R tests the same planned contrasts with random participants "
                      "and stimuli"),
            std::string::npos);
}

TEST(FactorReport, WritesScriptsWithoutInteractionsWhereNothingIsCrossed) {
  Manifest manifest = two_emotion_study(4);
  for (Stimulus& stimulus : manifest.stimuli) stimulus.factors.emplace_back("own", stimulus.id);
  const auto files = report_on(manifest);
  EXPECT_FALSE(files.contains("analysis/afex.R"));
  EXPECT_FALSE(files.contains("results/anova.csv"));
  EXPECT_NE(files.at("analysis/lme4.R")
                .find("value ~ made + emotion + setting + (1 | participant) + (1 | stimulus)"),
            std::string::npos);
  EXPECT_NE(files.at("report.html").find("No analysis of variance: no factor"), std::string::npos);
}

TEST(FactorReport, DrawsTheCellsOfGroupsWithTextsApart) {
  const Results results = results_on(planned_study(), gender_of_eight());
  int drawn = 0;
  for (const ResultFigure& figure : result_figures(results)) {
    if (figure.section != "factors") continue;
    ++drawn;
    test::expect_texts_apart(figure.plot);
    EXPECT_TRUE(test::says(figure.plot, "gender man (n = 5)"));
  }
  EXPECT_EQ(drawn, 2);
}

}  // namespace
}  // namespace mien::pipeline
