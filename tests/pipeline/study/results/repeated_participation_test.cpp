#include "pipeline/study/results/repeated_participation.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

using Repeated = std::map<std::string, std::string>;

/// An answer of a session.
AnswerRow answered(const std::string& participant, const std::string& session, int trial) {
  AnswerRow row;
  row.participant = participant;
  row.session = session;
  row.trial = trial;
  row.stimulus = "walk";
  row.item = "sad-happy";
  return row;
}

SessionPeople people_by(const std::string& answers, const std::string& participants = "") {
  std::vector<CsvTable> tables;
  if (!participants.empty()) tables.push_back(parse_csv(participants, "participants.csv"));
  return session_people({parse_csv(answers, "answers.csv")}, tables, "PID");
}

Repeated repeated(std::vector<AnswerRow> rows, const SessionPeople& people) {
  const std::vector<SessionStart> sessions = session_starts(rows);
  separate_participants(rows);
  return repeated_participants(sessions, rows, people);
}

const std::string three_sessions =
    "participant,session,url_PID\np001,a,X\np001,a,X\np002,b,Y\np003,c,X\n";
const std::vector<AnswerRow> three_answered = {answered("p001", "a", 1), answered("p002", "b", 1),
                                               answered("p003", "c", 1)};

TEST(RepeatedParticipation, IsOfTheSameValueAfterTheFirstInTheFiles) {
  const Repeated found = repeated(three_answered, people_by(three_sessions));
  EXPECT_EQ(found, (Repeated{{"p003",
                              "participation number 2 of a person who first took part as p001 "
                              "(by order in the files)"}}));
}

TEST(RepeatedParticipation, OfOtherFilesFirstIsOfOthers) {
  const std::vector<AnswerRow> other_way = {three_answered[2], three_answered[1],
                                            three_answered[0]};
  const Repeated found = repeated(other_way, people_by(three_sessions));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found.contains("p001"));
}

TEST(RepeatedParticipation, GoesByTheTimeOfConsentWhereAllHaveOne) {
  const auto found = [&](const std::string& first, const std::string& third) {
    return repeated(three_answered,
                    people_by(three_sessions, "participant,session,consented_at\np001,a," + first +
                                                  "\np003,c," + third + "\n"));
  };
  EXPECT_EQ(found("2026-03-02T09:30:00.000Z", "2026-03-01T09:30:00.000Z"),
            (Repeated{{"p001",
                       "participation number 2 of a person who first took part as p003 (by "
                       "time of consent)"}}));
  EXPECT_TRUE(found("2026-03-01T09:30:00Z", "2026-03-01T09:30:00.001Z").contains("p003"));
  EXPECT_TRUE(found("2026-03-01T09:30:00.001Z", "2026-03-01T09:30:00Z").contains("p001"));
  EXPECT_EQ(found("2026-03-02T09:30:00.000Z", ""),
            (Repeated{{"p003",
                       "participation number 2 of a person who first took part as p001 (by "
                       "order in the files)"}}));
}

TEST(RepeatedParticipation, OfAllButTheFirstIsCounted) {
  const std::vector<AnswerRow> rows = {answered("p001", "a", 1), answered("p002", "b", 1),
                                       answered("p003", "c", 1), answered("p004", "d", 1)};
  const Repeated found = repeated(
      rows, people_by("participant,session,url_PID\np001,a,X\np002,b,X\np003,c,X\np004,d,\n"));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found.at("p003").starts_with(
      "participation number 3 of a person who first took part as p001"));
}

TEST(RepeatedParticipation, IsNotOfEmptyValues) {
  EXPECT_TRUE(repeated(three_answered, people_by("participant,session,url_PID\np001,a,\np002,b,\n"
                                                 "p003,c,NA\n"))
                  .empty());
}

TEST(RepeatedParticipation, IsNotOfASessionThatGoesOn) {
  const SessionPeople people = people_by("participant,session,url_PID\np001,a,X\np001,b,X\n");
  EXPECT_TRUE(repeated({answered("p001", "a", 1), answered("p001", "b", 2)}, people).empty());
  // Both answer the first trial: two people, or one who came back.
  const Repeated found = repeated({answered("p001", "a", 1), answered("p001", "b", 1)}, people);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found.contains("p001/b"));
}

TEST(RepeatedParticipation, IsNotOfSessionsWithoutAnswers) {
  const SessionPeople people =
      people_by("participant,session,url_PID\np002,b,X\n",
                "participant,session,consented_at,url_PID\np001,a,2026-03-01T09:30:00.000Z,X\n"
                "p002,b,2026-03-02T09:30:00.000Z,X\n");
  EXPECT_TRUE(repeated({answered("p002", "b", 1)}, people).empty());
}

TEST(RepeatedParticipation, IsFoundByTablesOfParticipantsAlone) {
  const std::string answers = "participant,session\np001,a\np002,b\n";
  EXPECT_FALSE(people_by(answers).is_known);
  const SessionPeople people =
      people_by(answers, "participant,session,url_PID\np001,a,X\np002,b,X\n");
  EXPECT_TRUE(people.is_known);
  EXPECT_TRUE(
      repeated({answered("p001", "a", 1), answered("p002", "b", 1)}, people).contains("p002"));
}

TEST(RepeatedParticipation, KeepsNoValues) {
  const SessionPeople people = people_by(three_sessions);
  EXPECT_EQ(people.person.at({"p001", "a"}), 0);
  EXPECT_EQ(people.person.at({"p002", "b"}), 1);
  EXPECT_EQ(people.person.at({"p003", "c"}), 0);
}

TEST(RepeatedParticipation, RefusesTimesThatCannotBeCompared) {
  for (const char* time : {"1.3.2026 09:30", "2026-03-01", "2026-03-01T09:30:00+01:00",
                           "2026-03-01T09:30:00.0x0Z", "2026-03-01 09:30:00Z"}) {
    try {
      people_by(three_sessions,
                "participant,session,consented_at\np001,a,\"" + std::string(time) + "\"\n");
      ADD_FAILURE() << time;
    } catch (const Faults& faults) {
      EXPECT_NE(
          std::string(faults.what())
              .find("participants.csv:2:8: \"" + std::string(time) + "\" is not a time of consent"),
          std::string::npos)
          << faults.what();
    }
  }
  EXPECT_THROW(people_by("participant,url_PID\np001,X\n"), Error);
}

}  // namespace
}  // namespace mien::pipeline
