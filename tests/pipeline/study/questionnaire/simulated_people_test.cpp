#include "pipeline/study/questionnaire/simulated_people.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/answer_files.h"
#include "pipeline/study/results/results.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

Manifest people_study(int participants) {
  return test::asked_study(
      4, "participants: " + std::to_string(participants) +
             ", scales: [sad-happy], demographics: [{id: gender, ask: Gender, answer: [woman, man, "
             "other]}, {id: years, ask: 'How long?', answer: number}, {id: job, ask: 'What?', "
             "answer: text}], screening: {questions: [{id: age, ask: 'How old?', answer: number, "
             "accept: {from: 20, to: 29}}, {id: hand, ask: Hand, answer: [l, r, both], accept: "
             "[l, r]}]}");
}

TEST(SimulatedPeople, AnswerWhatTheScreeningAcceptsAndAreMarked) {
  const Manifest manifest = people_study(200);
  EXPECT_TRUE(asks_about_participants(manifest));
  EXPECT_FALSE(
      asks_about_participants(test::asked_study(4, "participants: 4, scales: [sad-happy]")));
  const std::string csv = simulated_people_csv(manifest, plan_sessions(manifest));
  EXPECT_EQ(simulated_people_csv(manifest, plan_sessions(manifest)), csv);
  const CsvTable table = parse_csv(csv, "p.csv");
  ASSERT_EQ(table.rows.size(), 200u);
  std::map<std::string, std::map<std::string, int>> answers;
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) ++answers[table.header[i].text][row[i].text];
  EXPECT_EQ(answers["simulated"]["1"], 200);
  EXPECT_EQ(answers["finished"]["1"], 200);
  EXPECT_EQ(answers["ended"]["completed"], 200);
  EXPECT_EQ(answers["job"]["simulated"], 200);
  EXPECT_EQ(answers["hand"].size(), 2u);
  EXPECT_EQ(answers["gender"].size(), 3u);
  for (const auto& [gender, count] : answers["gender"]) EXPECT_GT(count, 40) << gender;
  EXPECT_EQ(answers["age"].size(), 10u);
  EXPECT_EQ(answers["age"].begin()->first, "20");
  EXPECT_EQ(answers["age"].rbegin()->first, "29");
  EXPECT_GE(std::stoi(answers["years"].begin()->first), 18);
  EXPECT_LE(std::stoi(answers["years"].rbegin()->first), 65);
}

TEST(SimulatedPeople, AreFoundBesideTheirAnswersAndReported) {
  const test::TemporaryFolder folder;
  const Manifest manifest = people_study(12);
  const auto plans = plan_sessions(manifest);
  const auto answers = folder.path() / "pilot.csv";
  const std::vector<AnswerRow> rows = simulated_sessions(manifest, plans, {});
  write_file(answers, to_csv(rows));
  EXPECT_EQ(participants_of(answers), folder.path() / "pilot_participants.csv");
  write_file(participants_of(answers), simulated_people_csv(manifest, plans));
  const AnswerFiles found = answer_files({answers});
  ASSERT_EQ(found.participants.size(), 1u);
  const Results results = results_of(collect_answers(manifest, rows), rows,
                                     read_participants(found.participants.front()));
  std::set<std::string> questions;
  for (const DemographicSummary& one : demographics_of(results.demographics, results.answer_set))
    questions.insert(one.question);
  EXPECT_EQ(questions, (std::set<std::string>{"age", "gender", "hand", "job", "years"}));
}

}  // namespace
}  // namespace mien::pipeline
