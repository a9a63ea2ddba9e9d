#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/results/report/results_report.h"
#include "pipeline/study/results/two_emotions.h"

#include "shared_set_up.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

/// Six people about five stimuli, without rules. Of p002 all raw answers are equal, p003 failed
/// checks, p004 answered the first two items too fast, and p006 is p001 again.
struct Answered {
  Manifest manifest = two_emotion_study(6);
  std::vector<AnswerRow> rows;
  ReportChoices choices;

  Answered() {
    manifest.questionnaire->attention_every = 2;
    manifest.questionnaire->repeated = 1;
    rows = answers_to(manifest);
    int fast = 2;
    for (AnswerRow& row : rows) {
      row.session = "s" + row.participant;
      row.rt_ms = 1000.0;
      if (row.participant == "p002" && row.kind != "attention") {
        row.value_raw = "50";
        row.value = "0";
      }
      if (row.participant == "p003" && row.kind == "attention") row.passed = false;
      if (row.participant == "p004" && row.counts() && fast-- > 0) row.rt_ms = 100.0;
    }
    choices.session_people = session_people({identified("secret-id")}, {}, "PROLIFIC_PID");
  }

  /// The answers' table with the values of a URL parameter.
  CsvTable identified(const std::string& value) const {
    std::vector<AnswerRow> with_values = rows;
    for (AnswerRow& row : with_values) {
      const bool is_same = row.participant == "p001" || row.participant == "p006";
      row.url_parameters = {is_same ? value : value + row.participant};
    }
    return parse_csv(to_csv(with_values, {"PROLIFIC_PID"}), "answers.csv");
  }

  void state_rules(FlaggedAnswers flagged = FlaggedAnswers::excluded) {
    QualityRules& rules = manifest.questionnaire->analysis.quality;
    rules = {.min_rt_ms = 250.0, .max_longstring = 9, .repeated_by = "PROLIFIC_PID"};
    rules.flagged = flagged;
  }

  AnswerSet collected() const { return collect_answers(manifest, rows, choices); }

  void write_report(const fs::path& report) const {
    clear_results_folder(report);
    write_results(results_of(collected(), rows, {}), rows, {}, report);
  }
};

enum class Rules { none, excluding, keeping };

/// The files of the report with these rules.
Files report_with(Rules rules) {
  constexpr std::array names = {"quality_none", "quality_excluding", "quality_keeping"};
  const fs::path folder =
      test::shared_set_up(names[static_cast<std::size_t>(rules)], [&](const fs::path& made) {
        Answered study;
        if (rules == Rules::excluding) study.state_rules();
        if (rules == Rules::keeping) study.state_rules(FlaggedAnswers::kept);
        study.write_report(made / "report");
      });
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "report"))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder / "report").generic_string()] =
          read_file(entry.path());
  return files;
}

/// The fields of a column, by those of the first one.
std::multimap<std::string, std::string> column_of(const Files& files, const std::string& file,
                                                  const std::string& column) {
  const CsvTable table = parse_csv(files.at(file), file);
  const auto index = static_cast<std::size_t>(require_column(table, column));
  std::multimap<std::string, std::string> fields;
  for (const auto& row : table.rows) fields.emplace(row.front().text, row[index].text);
  return fields;
}

/// The field of a column in the first row that begins with `first`; empty without such a row.
std::string field_of(const std::multimap<std::string, std::string>& column,
                     const std::string& first) {
  const auto found = column.find(first);
  return found == column.end() ? "" : found->second;
}

std::string data_file(const Files& files) {
  return std::ranges::find_if(
             files, [](const auto& file) { return file.first.ends_with("answers_data.csv"); })
      ->first;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(QualityReport, LeavesOutFlaggedAnswersAndParticipants) {
  Answered study;
  ASSERT_EQ(study.collected().people.size(), 5u);
  study.state_rules();
  const AnswerSet answer_set = study.collected();
  EXPECT_EQ(answer_set.people, (std::vector<std::string>{"p001", "p004", "p005"}));
  EXPECT_EQ(answer_set.ratings.size(), 3u * 10u - 2u);
  EXPECT_EQ(std::ranges::count(answer_set.ratings, 1u, &AnalysedRating::person), 8);
}

TEST(QualityReport, CountsWhatEachRuleFlags) {
  const Files files = report_with(Rules::excluding);
  const auto counted = [&](const char* column) {
    return column_of(files, "results/quality_rules.csv", column);
  };
  using Fields = std::multimap<std::string, std::string>;
  EXPECT_EQ(counted("bound"), (Fields{{"max_failed_checks", "1"},
                                      {"max_longstring", "9"},
                                      {"repeated_by", "PROLIFIC_PID"},
                                      {"min_rt_ms", "250"},
                                      {"", ""}}));
  EXPECT_EQ(counted("participants"), (Fields{{"max_failed_checks", "1"},
                                             {"max_longstring", "1"},
                                             {"repeated_by", "1"},
                                             {"min_rt_ms", "1"},
                                             {"", "4"}}));
  EXPECT_EQ(counted("answers"), (Fields{{"max_failed_checks", "10"},
                                        {"max_longstring", "10"},
                                        {"repeated_by", "10"},
                                        {"min_rt_ms", "2"},
                                        {"", "32"}}));
}

TEST(QualityReport, GivesTheReasonOfEachFlag) {
  const Files files = report_with(Rules::excluding);
  const auto reasons = column_of(files, "results/quality_flags.csv", "reason");
  EXPECT_EQ(reasons.size(), 5u);
  EXPECT_EQ(field_of(reasons, "p002"), "longest run of equal answers 10 > 9");
  EXPECT_EQ(reasons.count("p004"), 2u);
  EXPECT_EQ(field_of(reasons, "p004"), "response time 100 ms < 250 ms");
  EXPECT_EQ(field_of(reasons, "p006"),
            "participation number 2 of a person who first took part as p001 (by order in the "
            "files)");
  EXPECT_EQ(field_of(column_of(files, "results/sessions.csv", "reasons"), "p002"),
            field_of(reasons, "p002"));
  EXPECT_EQ(field_of(column_of(files, "results/sessions.csv", "answers"), "p004"), "8");
  const std::string& page = files.at("report.html");
  EXPECT_TRUE(holds(page, "<section id=\"quality\">"));
  EXPECT_TRUE(holds(page, "max_longstring: 9"));
  EXPECT_TRUE(holds(page, "<li>p002 (longest run of equal answers 10 &gt; 9)</li>"));
  EXPECT_TRUE(holds(page, "excluded: longest run of equal answers 10 &gt; 9"));
  EXPECT_TRUE(holds(page, "2 answers flagged"));
}

TEST(QualityReport, KeepsAllDataWithTheirFlags) {
  const Answered study;
  const Files files = report_with(Rules::excluding);
  const CsvTable data = parse_csv(files.at(data_file(files)), "data");
  ASSERT_EQ(data.rows.size(), study.rows.size());
  const auto text = [&](std::size_t row, const char* column) {
    return data.rows[row][static_cast<std::size_t>(require_column(data, column))].text;
  };
  std::size_t flagged = 0;
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const std::string participant = study.rows[i].participant;
    const bool is_fast = study.rows[i].rt_ms == 100.0;
    const bool is_out = participant == "p002" || participant == "p003" || participant == "p006";
    EXPECT_EQ(text(i, "excluded"), is_fast || is_out ? "1" : "0");
    EXPECT_EQ(text(i, "answer_flags").empty(), !is_fast);
    EXPECT_EQ(text(i, "participant_flags").empty(), !is_out);
    flagged += is_fast ? 1 : 0;
  }
  EXPECT_EQ(flagged, 2u);
}

TEST(QualityReport, DescribesEveryColumnItAdds) {
  const Files files = report_with(Rules::excluding);
  std::set<std::string> described, measured;
  const CsvTable book = parse_csv(files.at("codebook.csv"), "codebook.csv");
  for (const auto& row : book.rows) described.insert(row[0].text + ": " + row[2].text);
  const auto description = nlohmann::json::parse(files.at("dataset_description.json"));
  for (const auto& variable : description.at("variableMeasured"))
    measured.insert(variable.at("name"));
  for (const auto& [name, bytes] : files) {
    if (!name.starts_with("results/") && name != data_file(files)) continue;
    const CsvTable table = parse_csv(bytes, name);
    for (const CsvField& field : table.header) {
      EXPECT_TRUE(described.contains(name + ": " + field.text)) << name << ": " << field.text;
      if (name == data_file(files)) {
        EXPECT_TRUE(measured.contains(field.text)) << field.text;
      }
    }
  }
}

TEST(QualityReport, OfKeptAnswersHasTheResultsOfNoRules) {
  const Files without = report_with(Rules::none);
  const Files kept = report_with(Rules::keeping);
  for (const auto& [name, bytes] : without) {
    const bool is_added_to = name == "results/sessions.csv" || name == "report.html" ||
                             name == "codebook.csv" || name == "dataset_description.json" ||
                             name == data_file(without);
    if (!is_added_to) {
      EXPECT_EQ(kept.at(name), bytes) << name;
    }
  }
  EXPECT_EQ(kept.size(), without.size() + 2);
  EXPECT_EQ(column_of(kept, data_file(kept), "excluded"),
            column_of(without, data_file(without), "excluded"));
  EXPECT_EQ(column_of(kept, "results/sessions.csv", "answers"),
            column_of(without, "results/sessions.csv", "answers"));
  EXPECT_EQ(column_of(kept, "results/quality_flags.csv", "reason").size(), 5u);
  const std::string& page = kept.at("report.html");
  EXPECT_TRUE(holds(page, "Flagged, but included:"));
  EXPECT_TRUE(holds(page, "<li>p003 (failed attention checks"));
}

TEST(QualityReport, IsTheUsualOneWithoutRules) {
  for (const auto& [name, bytes] : report_with(Rules::none)) {
    EXPECT_FALSE(holds(name, "quality")) << name;
    if (name.ends_with(".csv") || name.ends_with(".html") || name.ends_with(".json")) {
      EXPECT_FALSE(holds(bytes, "flag")) << name;
    }
  }
}

TEST(QualityReport, HoldsNothingThatIdentifiesPeople) {
  for (const auto& [name, bytes] : report_with(Rules::excluding))
    EXPECT_FALSE(holds(bytes, "secret-id")) << name;
}

TEST(QualityReport, SaysWhereRepetitionsCannotBeFound) {
  Answered study;
  study.state_rules();
  study.choices.session_people = {};
  const AnswerSet answer_set = study.collected();
  ASSERT_FALSE(answer_set.notes.empty());
  EXPECT_TRUE(holds(answer_set.notes.back(), "no table has the column url_PROLIFIC_PID"));
  EXPECT_EQ(answer_set.people.size(), 4u);
}

TEST(QualityReport, OfRetestsUsesOnlyFirstAnswersThatAreAnalysed) {
  Answered study;
  const std::size_t all = retest_answers_of(study.collected(), study.rows).size();
  for (AnswerRow& row : study.rows)
    if (row.participant == "p005") row.rt_ms = row.counts() ? 100.0 : 1000.0;
  study.state_rules();
  const std::vector<RetestAnswer> fewer = retest_answers_of(study.collected(), study.rows);
  EXPECT_LT(fewer.size(), all);
  EXPECT_EQ(std::ranges::count(fewer, "p005", &RetestAnswer::participant), 0);
  study.state_rules(FlaggedAnswers::kept);
  EXPECT_EQ(retest_answers_of(study.collected(), study.rows).size(), all);
}

TEST(QualityReport, RefusesAnswersOfWhichNothingRemains) {
  Answered study;
  study.state_rules();
  study.manifest.questionnaire->analysis.quality.min_rt_ms = 1001.0;
  try {
    study.collected();
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_TRUE(holds(error.what(), "holds no answers to analyse: of ")) << error.what();
  }
}

}  // namespace
}  // namespace mien::pipeline
