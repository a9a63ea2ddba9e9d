#include "pipeline/manifest/ratings/answers/answer_row.h"

#include <set>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

AnswerRow full_row() {
  return {.participant = "p001",
          .session = "a1",
          .trial = 7,
          .block = "main",
          .kind = "rating",
          .stimulus = "walk-sad",
          .stimulus_sha256 = "00ff",
          .against = "walk-normal",
          .item = "sad-happy",
          .value_raw = "5",
          .value = "-2",
          .pole_left = "high",
          .rt_ms = 2310.25,
          .is_check = true,
          .expected = "5",
          .passed = true,
          .replays = 2,
          .trial_ms = 8123,
          .play_start_ms = 12.5,
          .ended_ms = 2420,
          .stalls = 1,
          .stall_ms = 30,
          .dropped_frames = 4,
          .blurs = 1,
          .blur_ms = 830.5,
          .viewport_width = 1366,
          .viewport_height = 768,
          .refresh_hz = 59.94,
          .shown_width = 480.5,
          .shown_height = 360.25,
          .pixel_ratio = 1.25,
          .shown_cm = 12.5,
          .shown_degrees = 11.9,
          .comment = "\"sad\", 悲しい\nor tired",
          .seed = 18446744073709551615ULL,
          .design = "0123456789abcdef",
          .simulated = true};
}

AnswerRow row_of(const std::string& participant, int trial, const std::string& item,
                 const std::string& session = "s") {
  return {.participant = participant,
          .session = session,
          .trial = trial,
          .stimulus = "walk",
          .item = item,
          .value_raw = "1",
          .value = "-2"};
}

std::string faults_of(const std::string& csv) {
  try {
    answer_rows(parse_csv(csv, "a.csv"));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// A good file with one field replaced.
std::string faults_with(std::string_view column, const std::string& text) {
  std::vector<std::string> fields = fields_of_row(full_row());
  const std::vector<std::string> header = header_of(answer_form);
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == column) fields[i] = text;
  CsvWriter writer(header);
  writer.row(fields);
  return faults_of(writer.text());
}

TEST(AnswerRow, GoesThroughCsvUnchanged) {
  const std::vector<AnswerRow> rows = {full_row(), row_of("p002", 1, "weak-strong")};
  const std::string csv = to_csv(rows);
  const std::vector<AnswerRow> read = answer_rows(parse_csv(csv, "a.csv"));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(fields_of_row(read[0]), fields_of_row(rows[0]));
  EXPECT_EQ(fields_of_row(read[1]), fields_of_row(rows[1]));
  EXPECT_EQ(read[0].comment, rows[0].comment);
  EXPECT_EQ(read[0].seed, rows[0].seed);
  EXPECT_EQ(read[0].rt_ms, 2310.25);
  EXPECT_FALSE(read[1].rt_ms);
  EXPECT_FALSE(read[1].passed);
  EXPECT_EQ(to_csv(read), csv);
}

TEST(AnswerRow, HasAColumnForEachOfItsFieldsAndAMeaningForEachColumn) {
  EXPECT_EQ(fields_of_row(full_row()).size(), answer_form.columns.size());
  std::set<std::string_view> names;
  for (const Column& column : answer_form.columns) {
    EXPECT_FALSE(column.meaning.empty()) << column.name;
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
  }
}

/// The table with these columns left out.
std::string without_columns(const std::set<std::string>& left_out) {
  const std::vector<std::string> names = header_of(answer_form), fields = fields_of_row(full_row());
  std::vector<std::string> header, row;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (left_out.contains(names[i])) continue;
    header.push_back(names[i]);
    row.push_back(fields[i]);
  }
  CsvWriter writer(header);
  writer.row(row);
  return writer.text();
}

TEST(AnswerRow, IsReadFromTablesOfEarlierVersions) {
  const auto rows =
      answer_rows(parse_csv(without_columns({"blur_ms", "shown_width", "shown_height",
                                             "pixel_ratio", "shown_cm", "shown_degrees"}),
                            "a.csv"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].blur_ms);
  EXPECT_FALSE(rows[0].shown_degrees);
  EXPECT_EQ(rows[0].refresh_hz, 59.94);
  EXPECT_EQ(rows[0].comment, full_row().comment);
  EXPECT_NE(faults_of(without_columns({"refresh_hz"})).find("there is no column"),
            std::string::npos);
}

TEST(AnswerRow, IsReadFromColumnsInAnyOrderAndBesideOthers) {
  std::string header = "mood";
  std::string line = "good";
  const std::vector<std::string> names = header_of(answer_form);
  const std::vector<std::string> fields = fields_of_row(row_of("p", 3, "sad-happy"));
  for (std::size_t i = names.size(); i-- > 0;) {
    header += "," + names[i];
    line += "," + fields[i];
  }
  const auto rows = answer_rows(parse_csv(header + "\n" + line + "\n", "a.csv"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(fields_of_row(rows[0]), fields);
}

TEST(AnswerRow, IsReadFromTheFormerNameOfItsColumnWithAWarning) {
  const std::string now = to_csv({full_row(), row_of("p002", 1, "weak-strong")});
  std::string former = now;
  former.replace(former.find("is_check"), 8, "is_catch");
  std::vector<Fault> warnings;
  const auto rows = answer_rows(parse_csv(former, "a.csv"), DuplicateAnswers::refused, &warnings);
  EXPECT_TRUE(rows[0].is_check);
  EXPECT_EQ(to_csv(rows), now);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_string(warnings[0]),
            "a.csv:1:142: is_catch: now called is_check; rename the column");
  EXPECT_EQ(to_csv(answer_rows(parse_csv(former, "a.csv"))), now);
}

TEST(AnswerRow, TellsEveryFaultWithItsPlace) {
  EXPECT_EQ(faults_with("kind", "guess"),
            "a.csv:2:16: \"guess\" is not a valid kind; there are rating, emotion, pair, "
            "same_different, yes_no, two_interval, best_worst, grid, continuous, attention");
  EXPECT_NE(faults_with("rt_ms", "soon").find("\"soon\" is not a number"), std::string::npos);
  EXPECT_NE(faults_with("rt_ms", "-3").find("-3 is below 0"), std::string::npos);
  EXPECT_NE(faults_with("stalls", "1.5").find("1.5 is not a whole number"), std::string::npos);
  EXPECT_NE(faults_with("trial", "0").find("there is no trial 0"), std::string::npos);
  EXPECT_NE(faults_with("trial", "").find("the trial is missing"), std::string::npos);
  EXPECT_NE(faults_with("participant", "").find("a.csv:2:1: the participant"), std::string::npos);
  EXPECT_NE(faults_with("simulated", "yes").find("\"yes\" is neither 0 nor 1"), std::string::npos);
  EXPECT_NE(faults_with("pole_left", "up").find("there are low, high"), std::string::npos);
  EXPECT_NE(faults_with("seed", "-1").find("\"-1\" is not a valid seed"), std::string::npos);
  EXPECT_NE(faults_with("item", "").find("the item is missing"), std::string::npos);
}

TEST(AnswerRow, TellsSeveralFaultsAtOnce) {
  std::string table = to_csv({row_of("p", 1, "a")});
  for (const std::string name : {"stimulus", "simulated"})
    table.replace(table.find(name), name.size(), "x_" + name);
  const std::string notes = faults_of(table);
  EXPECT_NE(notes.find("no column \"stimulus\""), std::string::npos);
  EXPECT_NE(notes.find("no column \"simulated\""), std::string::npos);
  EXPECT_NE(faults_of(to_csv({})).find("a.csv:1:1: holds no answers"), std::string::npos);
  EXPECT_NE(faults_of("").find("the table is empty"), std::string::npos);
}

TEST(AnswerRow, IsNotThereTwice) {
  const std::string notes =
      faults_of(to_csv({row_of("p", 1, "a"), row_of("p", 1, "b"), row_of("p", 1, "a")}));
  EXPECT_NE(notes.find("a.csv:4:"), std::string::npos);
  EXPECT_NE(notes.find("participant \"p\" answers trial 1 on \"a\" a second time (first: a.csv:2:"),
            std::string::npos)
      << notes;
}

TEST(AnswerRow, TellsPeopleWithOneNameApartByWhatTheyAnsweredTwice) {
  std::vector<AnswerRow> rows = {row_of("p1", 1, "a", "x"), row_of("p1", 2, "a", "y"),
                                 row_of("p2", 1, "a", "x"), row_of("p2", 1, "a", "y")};
  const std::vector<std::string> notes = separate_participants(rows);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "participant \"p2\" has 2 different sessions, treated as different people: x, y");
  EXPECT_EQ(rows[0].participant, "p1");
  EXPECT_EQ(rows[1].participant, "p1");
  EXPECT_EQ(rows[2].participant, "p2/x");
  EXPECT_EQ(rows[3].participant, "p2/y");
}

TEST(AnswerRow, CountsUnlessItIsPracticeWarmUpACheckOrEmpty) {
  AnswerRow row = row_of("p", 1, "a");
  EXPECT_TRUE(row.counts());
  for (bool AnswerRow::*flag :
       {&AnswerRow::is_practice, &AnswerRow::is_warmup, &AnswerRow::is_check}) {
    AnswerRow other = row;
    other.*flag = true;
    EXPECT_FALSE(other.counts());
  }
  row.value = "NA";
  EXPECT_FALSE(row.counts());
}

}  // namespace
}  // namespace mien::pipeline
