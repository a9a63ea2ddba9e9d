#include "pipeline/study/results/report/results_report.h"

#include <algorithm>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/planted_names.h"
#include "pipeline/plot_texts.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/report/dataset.h"
#include "pipeline/study/results/report/page_tables.h"
#include "pipeline/study/results/two_emotions.h"
#include "pipeline/temporary_folder.h"

#include "shared_set_up.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

struct Reported {
  Results results;
  std::vector<AnswerRow> rows;
};

/// Twelve people who see what was meant, and what some of them wrote.
Reported reported_study(bool simulated = true) {
  Manifest manifest = two_emotion_study(12);
  manifest.questionnaire->repeated = 1;
  Reported reported;
  reported.rows = answers_to(manifest, {{{"sad", "sad-happy"}, -0.8},
                                        {{"happy", "sad-happy"}, 0.7},
                                        {{"acted-sad", "sad-happy"}, -1.2},
                                        {{"acted-happy", "sad-happy"}, 1.1}});
  for (AnswerRow& row : reported.rows) row.simulated = simulated;
  reported.rows[0].comment = "<script>alert('x')</script> & \"tired\", 疲れた";
  ParticipantTable people{
      parse_csv("participant,session,design,consented_at,finished,age,gender\n"
                "p001,simulated,d,,1,20,woman\np002,simulated,d,,1,30,man\n"
                "p003,simulated,d,,1,40,woman\n",
                "participants.csv")};
  reported.results = results_of(collect_answers(manifest, reported.rows), reported.rows, people);
  return reported;
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).generic_string()] = read_file(entry.path());
  return files;
}

void write_report(const Reported& reported, const FrozenVerdict& frozen, const fs::path& report) {
  clear_results_folder(report);
  write_results(reported.results, reported.rows, frozen, report);
}

std::map<std::string, std::string> written_report(const Reported& reported,
                                                  const FrozenVerdict& frozen = {}) {
  const test::TemporaryFolder folder;
  write_report(reported, frozen, folder.path() / "report");
  return files_in(folder.path() / "report");
}

/// What is written of reported_study().
std::map<std::string, std::string> usual_report() {
  return files_in(test::shared_set_up("results_report",
                                      [](const fs::path& folder) {
                                        write_report(reported_study(), {}, folder / "report");
                                      }) /
                  "report");
}

TEST(ResultsReport, HoldsEverythingTheSameBytesEachTime) {
  const auto files = usual_report();
  for (const char* name : {"report.html",
                           "results/means.csv",
                           "results/histograms.csv",
                           "results/comparisons.csv",
                           "results/overall.csv",
                           "results/confusion.csv",
                           "results/recall.csv",
                           "results/correlations.csv",
                           "results/agreement.csv",
                           "results/sessions.csv",
                           "results/retest.csv",
                           "results/retest_summary.csv",
                           "results/demographics.csv",
                           "results/comments.csv",
                           "figures/histograms-acted.pdf",
                           "figures/histograms-best-seen.pdf",
                           "figures/confusion-acted.svg",
                           "figures/confusion-modified.png",
                           "figures/differences-modified-acted.svg",
                           "figures/differences-modified-neutral.svg",
                           "figures/differences-modified-best.svg",
                           "figures/means.svg",
                           "figures/correlations.svg",
                           "analysis/lme4.R",
                           "analysis/ordinal.R",
                           "analysis/afex.R",
                           "results/anova.csv",
                           "results/cell_means.csv",
                           "results/contrasts.csv",
                           "figures/cell-means-sad-happy.svg",
                           "codebook.csv",
                           "dataset_description.json",
                           "README.md"})
    EXPECT_TRUE(files.contains(name)) << name;
  EXPECT_EQ(written_report(reported_study()), files);
}

TEST(ResultsReport, NamesNoThesisOfOthers) {
  const std::string page = usual_report().at("report.html");
  EXPECT_NE(page.find("Highest-rated videos"), std::string::npos);
  EXPECT_EQ(page.find("thesis"), std::string::npos);
}

TEST(ResultsReport, NamesTheColumnsOfRecallAsPublished) {
  EXPECT_TRUE(usual_report()
                  .at("results/recall.csv")
                  .starts_with("by,of,shown,showings,judged,points,recall,low,high,chance,hits,"
                               "decided,p,p_adjusted,simulated"));
}

/// Answers with a name in the first cell of each column in which it passes for an answer.
std::vector<AnswerRow> planted_answers(const Manifest& manifest, const std::vector<AnswerRow>& rows,
                                       const std::string& name, int& planted) {
  CsvTable table = parse_csv(to_csv(rows), "answers.csv");
  std::vector<AnswerRow> read = rows;
  for (CsvField& cell : table.rows.front()) {
    const std::string usual = std::exchange(cell.text, name);
    try {
      std::vector<AnswerRow> tried = answer_rows(table);
      collect_answers(manifest, tried);
      read = std::move(tried);
      ++planted;
    } catch (const std::runtime_error&) {
      cell.text = usual;
    }
  }
  return read;
}

TEST(ResultsReport, WritesNothingElsewhereWhateverItsTablesName) {
  const test::TemporaryFolder root;
  const fs::path report = root.path() / "study/out/report";
  fs::create_directories(report);
  write_file(root.path() / "planted", "mine");
  const auto before = test::surroundings(root.path(), report);
  const std::string name = "../../../planted";
  Manifest manifest = two_emotion_study(6);
  manifest.stimuli.push_back(manifest.stimuli[1]);
  manifest.stimuli.back().id = "acted-sad-too";
  for (Stimulus& stimulus : manifest.stimuli)
    stimulus.factors.emplace_back(name, stimulus.id == "acted-sad-too" ? name : "usual");
  int planted = 0;
  Reported reported;
  reported.rows = planted_answers(manifest, answers_to(manifest), name, planted);
  EXPECT_GT(planted, 3) << "participant, session, comment and design may be any text";
  CsvTable people =
      parse_csv("participant,session,design,consented_at,finished,gender,a\n" + name + "," + name +
                    ",d,,1," + name + "," + name + "\np002,simulated,d,,1,man,b\n",
                "participants.csv");
  people.header.back().text = name;
  reported.results = results_of(collect_answers(manifest, reported.rows), reported.rows, {people});
  write_report(reported, {}, report);
  EXPECT_TRUE(fs::exists(report / "figures/histograms-by-..-..-..-planted.svg"));
  EXPECT_EQ(test::surroundings(root.path(), report), before);
}

TEST(ResultsReport, TellsWhatWasAnsweredTwice) {
  const std::string page = usual_report().at("report.html");
  EXPECT_NE(page.find("<section id=\"retest\">"), std::string::npos);
  EXPECT_NE(page.find("href=\"results/retest_summary.csv\""), std::string::npos);
}

TEST(ResultsReport, NamesTheFiguresOfTheThesisThatItsOwnAreLike) {
  const CsvTable list = parse_csv(usual_report().at("figures.csv"), "figures.csv");
  std::map<std::string, std::string> files;  // by number; of files without one nothing is claimed
  for (const auto& row : list.rows)
    if (!row[2].text.empty()) {
      EXPECT_TRUE(files.emplace(row[2].text, row[0].text).second);
    }
  const std::map<std::string, std::string> expected = {
      {"31", "results/comparisons.csv"},
      {"32", "figures/histograms-best-seen"},
      {"33", "figures/confusion-acted"},
      {"34", "figures/confusion-modified"},
      {"35", "figures/differences-modified-neutral"},
      {"36", "figures/differences-modified-best"},
      {"37", "results/comparisons.csv"},
      {"40", "figures/means"},
      {"44", "figures/correlations"}};
  EXPECT_EQ(files, expected);  // there is one actor, and nobody was asked for a gender
}

TEST(ResultsReport, NamesFiguresOfActorsAndGenderWhereThereAreTwo) {
  Manifest manifest = two_emotion_study(12);
  const std::size_t stimuli = manifest.stimuli.size();
  for (std::size_t i = 0; i < stimuli; ++i) {
    Stimulus man = manifest.stimuli[i];
    man.id = "man-" + man.id;
    for (auto& [factor, level] : man.factors)
      if (factor == "actor") level = "man/../..";  // any text may be a level
    manifest.stimuli.push_back(man);
  }
  Demographic gender;
  gender.id = "gender";
  gender.answer.choices.words = {"woman", "man"};
  manifest.questionnaire->demographics = {gender};
  const std::vector<AnswerRow> rows = answers_to(manifest);
  std::string table = "participant,session,gender\n";
  for (int i = 1; i <= 12; ++i)
    table += fmt::format("p{:03},simulated,{}\n", i, i % 2 == 0 ? "woman" : "man");
  const auto files = written_report(
      {results_of(collect_answers(manifest, rows), rows, {parse_csv(table, "participants.csv")}),
       rows});
  const CsvTable list = parse_csv(files.at("figures.csv"), "figures.csv");
  std::map<std::string, std::string> numbered;
  for (const auto& row : list.rows)
    if (!row[2].text.empty()) numbered[row[2].text] = row[0].text;
  EXPECT_EQ(numbered["38"], "results/comparisons.csv");
  EXPECT_EQ(numbered["39"], "figures/histograms-by-actor");
  EXPECT_EQ(numbered["41"], "results/groups.csv");
  EXPECT_EQ(numbered["42"], "figures/histograms-by-gender");
  EXPECT_EQ(numbered["43"], "figures/histograms-by-gender-other");
  EXPECT_TRUE(files.contains("results/groups.csv"));
  EXPECT_TRUE(files.contains("figures/differences-actor-woman-man-..-...svg"));
}

TEST(ResultsReport, PrintsDashesWhereNobodyRatedBothVideos) {
  Results results = reported_study().results;
  Comparison unseen;
  unseen.against = 1;
  unseen.family = ComparisonFamily::between_levels;
  unseen.within = within_participants({});
  unseen.paired_adjusted = unseen.wilcoxon_adjusted = std::numeric_limits<double>::quiet_NaN();
  results.comparisons = {unseen};
  const std::string table = comparisons_html(results, ComparisonFamily::between_levels, "");
  const std::string cells = table.substr(table.find("<td>0</td>"));
  std::size_t dashes = 0;
  for (std::size_t at = cells.find("<td>–</td>"); at != std::string::npos;
       at = cells.find("<td>–</td>", at + 1))
    ++dashes;
  EXPECT_EQ(dashes, 13u) << cells;
  EXPECT_EQ(cells.find("1.000"), std::string::npos) << cells;
}

TEST(ResultsReport, SaysWhatFilesOfFiguresWereCalledBefore) {
  const auto files = usual_report();
  EXPECT_EQ(files.at("report.html").find("figure-33-confusion-acted"), std::string::npos);
  EXPECT_NE(files.at("figures.csv").find("figure-33-confusion-acted"), std::string::npos);
  EXPECT_NE(files.at("figures.csv").find("figure-36-differences-modified-neutral"),
            std::string::npos);
}

TEST(ResultsReport, MarksWhatIsSimulatedEverywhere) {
  const auto files = usual_report();
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("<title>Simulated: "), std::string::npos);
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t times = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
    return times;
  };
  EXPECT_EQ(count(page, "<h2>"), count(page, "<span class=\"mark\">simulated</span>"));
  for (const auto& [name, bytes] : files) {
    if (!name.starts_with("results/")) continue;
    const CsvTable table = parse_csv(bytes, name);
    EXPECT_EQ(table.header.back().text, "simulated") << name;
    for (const auto& row : table.rows) EXPECT_EQ(row.back().text, "1") << name;
  }
  EXPECT_NE(files.at("dataset_description.json").find("SIMULATED"), std::string::npos);
  EXPECT_NE(files.at("analysis/lme4.R").find("SIMULATED"), std::string::npos);
  EXPECT_NE(files.at("README.md").find("Simulated"), std::string::npos);
}

TEST(ResultsReport, DrawsFiguresWhoseTextsAreApartAndMarked) {
  for (const ResultFigure& figure : result_figures(reported_study().results)) {
    SCOPED_TRACE(figure.name);
    test::expect_texts_apart(figure.plot);
    EXPECT_TRUE(test::says(figure.plot, std::string(simulated_ratings_mark)));
  }
}

TEST(ResultsReport, SaysNothingOfSimulationWhereAnswersWereGiven) {
  const auto files = written_report(reported_study(false));
  EXPECT_EQ(files.at("report.html").find("Simulated"), std::string::npos);
  EXPECT_EQ(files.at("report.html").find(">simulated<"), std::string::npos);
  EXPECT_EQ(files.at("results/means.csv").find("simulated"), std::string::npos);
}

/// Of any study, answered by nobody.
std::map<std::string, std::string> report_on(const Manifest& manifest,
                                             const std::vector<AnswerRow>& rows) {
  return written_report({results_of(collect_answers(manifest, rows), rows, {}), rows});
}

TEST(ResultsReport, OfPairsNamesNoScriptsAndSaysWhatWasAsked) {
  const Manifest manifest = pair_study();
  const auto files = report_on(manifest, answers_to(manifest));
  const std::string& page = files.at("report.html");
  EXPECT_FALSE(files.contains("analysis/lme4.R"));
  EXPECT_EQ(page.find("analysis/"), std::string::npos);
  EXPECT_EQ(files.at("README.md").find("analysis/"), std::string::npos);
  EXPECT_NE(page.find("more happy"), std::string::npos);
  EXPECT_NE(page.find("results/preferences.csv"), std::string::npos);
  EXPECT_EQ(page.find("results/pairs.csv"), std::string::npos);
}

TEST(ResultsReport, HasTheWorthOfConditionsAndTheirPlannedContrasts) {
  Manifest manifest = all_pairs_study(12);
  PlannedContrast contrast;
  contrast.name = "happy against sad";
  contrast.weights = {{"emotion", {{"happy", 1.0}, {"sad", -1.0}}}};
  manifest.questionnaire->analysis.factorial = {.factors = {"emotion"}, .contrasts = {contrast}};
  const auto files = report_on(manifest, answers_to(manifest));
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("by their levels of emotion"), std::string::npos);
  EXPECT_NE(page.find("<h4>Planned contrasts</h4>"), std::string::npos);
  EXPECT_NE(page.find("24 further comparisons of two stimuli of the same condition are not used"),
            std::string::npos);
  EXPECT_NE(page.find("<summary>All pairs of conditions</summary>"), std::string::npos);
  const CsvTable worth = parse_csv(files.at("results/worth.csv"), "worth.csv");
  ASSERT_EQ(worth.rows.size(), 3u);
  EXPECT_EQ(worth.rows[0][1].text, "neutral");
  const CsvTable tests = parse_csv(files.at("results/worth_contrasts.csv"), "contrasts.csv");
  ASSERT_EQ(tests.rows.size(), 4u);
  EXPECT_EQ(tests.rows[0][2].text, "happy against sad");
}

TEST(ResultsReport, HasTheWorthOfComparedStimuli) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest, {{{"happy", "sad-happy"}, 2.0}});
  const auto files = report_on(manifest, rows);
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("<section id=\"worth\">"), std::string::npos);
  EXPECT_NE(page.find("odds of e to 1"), std::string::npos);
  EXPECT_NE(page.find("figures/worth-sad-happy.svg"), std::string::npos);
  EXPECT_TRUE(files.contains("figures/worth-sad-happy.pdf"));
  EXPECT_NE(files.at("figures.csv").find("figures/worth-sad-happy"), std::string::npos);
  const CsvTable worth = parse_csv(files.at("results/worth.csv"), "worth.csv");
  EXPECT_EQ(worth.rows.size(), 5u);
  EXPECT_EQ(parse_csv(files.at("results/worth_tests.csv"), "worth_tests.csv").rows.size(), 1u);
  EXPECT_EQ(parse_csv(files.at("results/worth_contrasts.csv"), "contrasts.csv").rows.size(), 10u);
  EXPECT_NE(page.find("<summary>All pairs of stimuli</summary>"), std::string::npos);
  EXPECT_EQ(parse_csv(files.at("results/circular_triads.csv"), "triads.csv").rows.size(), 12u);
  for (const CsvField& column : worth.header)
    EXPECT_NE(files.at("codebook.csv")
                  .find("results/worth.csv,scale and stimulus or condition of a study of pairs or "
                        "sets," +
                        column.text + ","),
              std::string::npos)
        << column.text;
  // Infinite or undefined numbers are never printed.
  for (const char* name : {"results/worth.csv", "results/worth_tests.csv"}) {
    EXPECT_EQ(files.at(name).find("nan"), std::string::npos) << name;
    EXPECT_EQ(files.at(name).find("inf"), std::string::npos) << name;
  }
}

TEST(ResultsReport, HasNoWorthWithoutPairs) {
  for (const auto& [name, bytes] : usual_report())
    EXPECT_EQ(name.find("worth"), std::string::npos) << name;
  EXPECT_EQ(usual_report().at("report.html").find("id=\"worth\""), std::string::npos);
}

TEST(ResultsReport, ExplainsChoicesAsChoices) {
  Manifest manifest = two_emotion_study(6);
  manifest.questionnaire->trials = &emotion_form;
  std::vector<AnswerRow> rows = answers_to(manifest);
  std::erase_if(rows, [](const AnswerRow& row) { return row.item != "emotion"; });
  const auto files = report_on(manifest, rows);
  const std::string& page = files.at("report.html");
  EXPECT_NE(page.find("Each presentation is one choice out of 3"), std::string::npos);
  EXPECT_NE(page.find("one of the 3)."), std::string::npos);
  EXPECT_EQ(page.find("Ratings are converted to points"), std::string::npos);
  EXPECT_EQ(page.find("number of ends"), std::string::npos);
  EXPECT_EQ(page.find("lme4"), std::string::npos);
}

TEST(ResultsReport, StatesTheEndsOfScalesWithAMinusSign) {
  const auto report = written_report(reported_study());
  EXPECT_NE(report.at("report.html").find("−2 at the low end, 2 at the high end"),
            std::string::npos);
}

TEST(ResultsReport, CountsOnePersonAsOne) {
  const Manifest manifest = two_emotion_study(1);
  const std::string page = report_on(manifest, answers_to(manifest)).at("report.html");
  EXPECT_NE(page.find("10 answers of 1 participant about 5 videos"), std::string::npos);
  EXPECT_NE(page.find("1 of 1 participant analysed."), std::string::npos);
  EXPECT_EQ(page.find("1 participants"), std::string::npos);
}

TEST(ResultsReport, EscapesWhatParticipantsWrote) {
  const std::string page = usual_report().at("report.html");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp;"), std::string::npos);
}

TEST(ResultsReport, IsNotWrittenOverWhatItDidNotWrite) {
  const test::TemporaryFolder folder;
  const fs::path foreign = folder.path() / "foreign";
  make_folder(foreign);
  write_file(foreign / "thesis.tex", "mine");
  EXPECT_THROW(clear_results_folder(foreign), Error);
  EXPECT_THROW(clear_results_folder(foreign / "thesis.tex"), Error);
  const fs::path own = folder.path() / "own";
  clear_results_folder(own);
  make_folder(own / "figures");
  write_file(own / "figures/old.png", "old");
  clear_results_folder(own);
  EXPECT_FALSE(fs::exists(own / "figures/old.png"));
}

TEST(ResultsReport, TellsWhatDiffersFromAFrozenDesign) {
  const std::string page =
      written_report(reported_study(), {"What was run differs:", {"scales: <one> more"}})
          .at("report.html");
  EXPECT_NE(page.find("What was run differs:"), std::string::npos);
  EXPECT_NE(page.find("scales: &lt;one&gt; more"), std::string::npos);
}

// The rules of the Psych-DS validator that bear on such a folder (psych-ds.github.io, schema 0.4):
// names of data files, columns that the metadata lack, metadata without a column, the JSON-LD.
TEST(ResultsReport, IsADatasetByTheRulesOfPsychDs) {
  const auto files = usual_report();
  const nlohmann::json description = nlohmann::json::parse(files.at("dataset_description.json"));
  EXPECT_EQ(description.at("@type"), "Dataset");
  EXPECT_EQ(std::string(description.at("@context")).rfind("https://schema.org", 0), 0u);
  for (const char* key : {"name", "description"})
    EXPECT_FALSE(std::string(description.at(key)).empty());
  std::set<std::string> told;
  for (const auto& variable : description.at("variableMeasured")) {
    EXPECT_EQ(variable.at("@type"), "PropertyValue");
    EXPECT_FALSE(std::string(variable.at("description")).empty());
    EXPECT_TRUE(told.insert(variable.at("name")).second) << variable.at("name");
  }
  const std::set<std::string> keywords = {"study",     "site",  "subject",  "session",    "task",
                                          "condition", "trial", "stimulus", "description"};
  const std::regex form("([a-z]+-[a-zA-Z0-9]+)(_[a-z]+-[a-zA-Z0-9]+)*_data\\.csv");
  const std::regex keyword("([a-z]+)-[a-zA-Z0-9]+");
  std::set<std::string> there;
  int data_files = 0;
  for (const auto& [name, bytes] : files) {
    if (!name.starts_with("data/")) continue;
    ++data_files;
    const std::string own = name.substr(5);
    EXPECT_TRUE(std::regex_match(own, form)) << own;
    for (std::sregex_iterator match(own.begin(), own.end(), keyword), end; match != end; ++match)
      EXPECT_TRUE(keywords.contains((*match)[1])) << own;
    const CsvTable table = parse_csv(bytes, name);
    EXPECT_FALSE(table.rows.empty());
    for (const CsvField& field : table.header) {
      EXPECT_TRUE(told.contains(field.text)) << name << ": " << field.text;
      there.insert(field.text);
    }
  }
  EXPECT_EQ(data_files, 3);
  EXPECT_EQ(there, told);
  EXPECT_TRUE(files.contains("README.md"));
}

TEST(ResultsReport, TellsEveryColumnOfItsTablesInTheCodebook) {
  const auto files = usual_report();
  const CsvTable codebook = parse_csv(files.at("codebook.csv"), "codebook.csv");
  std::set<std::pair<std::string, std::string>> told;
  for (const auto& row : codebook.rows) {
    told.emplace(row[0].text, row[2].text);
    EXPECT_FALSE(row[4].text.empty()) << row[2].text;
  }
  for (const auto& [name, bytes] : files) {
    if (!name.starts_with("data/") && !name.starts_with("results/")) continue;
    for (const CsvField& field : parse_csv(bytes, name).header)
      EXPECT_TRUE(told.contains({name, field.text})) << name << ": " << field.text;
  }
}

TEST(ResultsReport, KeepsAnswersThatGoBackInAsRatings) {
  const auto files = usual_report();
  const std::string& csv = files.at(dataset_paths("two-emotions").answers);
  ScaleSet scales;
  scales.scales = reported_study().results.answer_set.scales;
  const Answers answers = parse_answers(csv, "answers.csv", scales);
  EXPECT_EQ(answers.answers.size(), 12u * 5u * 2u);
  EXPECT_TRUE(answers.simulated);
}

TEST(ResultsReport, NamesParticipantsAlikeInAllOfItsData) {
  const Manifest manifest = two_emotion_study(3);
  Reported reported;
  reported.rows = answers_to(manifest);
  for (std::size_t i = 0, own = reported.rows.size(); i < own; ++i) {
    if (reported.rows[i].participant != "p001") continue;
    reported.rows.push_back(reported.rows[i]);
    reported.rows.back().session = "other";
  }
  const ParticipantTable people{
      parse_csv("participant,session,age\np001,simulated,20\np001,other,30\np002,simulated,40\n"
                "p002,left,50\np003,simulated,60\n",
                "participants.csv")};
  reported.results = results_of(collect_answers(manifest, reported.rows), reported.rows, people);
  const auto files = written_report(reported);
  const DatasetPaths paths = dataset_paths("two-emotions");
  const auto names_in = [&](const std::string& path) {
    const CsvTable table = parse_csv(files.at(path), path);
    const auto column = static_cast<std::size_t>(require_column(table, "participant"));
    std::set<std::string> names;
    for (const auto& row : table.rows) names.insert(row[column].text);
    return names;
  };
  std::set<std::string> known = {"p001/other", "p001/simulated", "p002", "p003"};
  EXPECT_EQ(names_in(paths.answers), known);
  known.insert("p002/left");  // gave no answers
  EXPECT_EQ(names_in(paths.participants), known);
}

TEST(ResultsReport, FindsWhatWasPutIn) {
  const Reported reported = reported_study();
  int found = 0;
  for (const Comparison& c : reported.results.comparisons)
    if (c.family == ComparisonFamily::modified_neutral && c.intended_end != 0)
      found += c.paired_adjusted < 0.05 && c.intended_end * c.within.t.mean > 0.0 ? 1 : 0;
  EXPECT_EQ(found, 2);
  EXPECT_GT(reported.results.reliability[0].intraclass.two_k, 0.8);
}

TEST(Demographics, AreMeansOfNumbersAndCountsOfWords) {
  const Reported reported = reported_study();
  const auto all = demographics_of(reported.results.demographics, reported.results.answer_set);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].question, "age");
  EXPECT_DOUBLE_EQ(all[0].value, 30.0);
  EXPECT_DOUBLE_EQ(all[1].value, 10.0);
  EXPECT_EQ(all[4].answer, "man");
  EXPECT_EQ(all[5].value, 2.0);
  EXPECT_EQ(all[5].people, 3);
}

TEST(Demographics, AreOfTheSessionsThatGaveTheAnswers) {
  const Manifest manifest = two_emotion_study(2);
  const ParticipantTable people{
      parse_csv("participant,session,age\np001,simulated,20\np001,left,50\np002,simulated,30\n"
                "p002,simulated,30\n",
                "participants.csv")};
  const auto all = demographics_of(people, collect_answers(manifest, answers_to(manifest)));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].answer, "mean");
  EXPECT_DOUBLE_EQ(all[0].value, 25.0);
  EXPECT_EQ(all[0].people, 2);
}

TEST(Demographics, OfTextsAreCountedEvenWhereTheyAreDigits) {
  Manifest manifest = two_emotion_study(2);
  manifest.questionnaire->demographics.resize(1);
  manifest.questionnaire->demographics[0].id = "shoe";
  manifest.questionnaire->demographics[0].answer = {};
  const ParticipantTable people{
      parse_csv("participant,shoe\np001,33\np002,33\n", "participants.csv")};
  const auto all = demographics_of(people, collect_answers(manifest, answers_to(manifest)));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].answer, "33");
  EXPECT_TRUE(all[0].is_count);
  EXPECT_EQ(all[0].value, 2.0);
}

TEST(Demographics, CountLanguagesOfPagesIfThereAreSeveral) {
  const AnswerSet answers = collect_answers(two_emotion_study(3), answers_to(two_emotion_study(3)));
  const auto counted = [&](const std::string& csv) {
    std::string text;
    for (const DemographicSummary& one :
         demographics_of({parse_csv(csv, "participants.csv")}, answers))
      text += fmt::format("{}: {} {} of {}; ", one.question, one.answer, one.value, one.people);
    return text;
  };
  EXPECT_EQ(counted("participant,language\np001,de\np002,en\np003,de\np009,fr\n"),
            "language of the pages: de 2 of 3; language of the pages: en 1 of 3; ");
  EXPECT_EQ(counted("participant,language\np001,de\np002,de\np003,de\n"), "");
}

TEST(Demographics, OfDifferentQuestionnairesAreNotJoined) {
  const ParticipantTable one{parse_csv("participant,age\np,1\n", "a.csv")};
  const ParticipantTable other{parse_csv("participant,height\np,1\n", "b.csv")};
  const ParticipantTable another{parse_csv("participant,age\nq,1\n", "c.csv")};
  EXPECT_EQ(joined({one, another}).table.rows.size(), 2u);
  EXPECT_EQ(joined({one, one}).table.rows.size(), 1u);  // saved twice
  EXPECT_THROW(joined({one, other}), Error);
}

}  // namespace
}  // namespace mien::pipeline
