#include "pipeline/study/questionnaire/service/withdrawal.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

/// Somebody who withdraws from a served study.
class Withdrawal : public Service {
 protected:
  HttpResponse withdraw(int session, const std::string& browser) {
    return ask("POST", of(session) + "withdrawal", json{{"session", browser}}.dump());
  }
};

TEST_F(Withdrawal, LeavesNothingButACount) {
  give_all(0, "b0b0");
  give_all(1, "c1c1");
  EXPECT_EQ(json::parse(withdraw(0, "b0b0").body), (json{{"ended", "withdrawn"}}));
  for (const char* name : {"answers.csv", "participants.csv", "answers.json"}) {
    const std::string text = get(lab() + name).body;
    EXPECT_EQ(text.find("b0b0"), std::string::npos) << name;
    EXPECT_NE(text.find("c1c1"), std::string::npos) << name;
  }
  const json now = status();
  EXPECT_EQ(now.at("participants").at(0).at("state"), "withdrawn");
  EXPECT_EQ(now.at("participants").at(0).at("kept"), 0);
  EXPECT_EQ(now.at("participants").at(1).at("state"), "done");
  EXPECT_EQ(now.at("checks"), (json{{"passed", 1}, {"failed", 0}}));
  for (const json& histogram : now.at("histograms")) EXPECT_EQ(histogram.at("answers"), 1);
  QuestionnaireService again(study_, store_);
  EXPECT_EQ(again.sessions().state(0).ended, SessionEnd::withdrawn);
}

TEST_F(Withdrawal, IsForTheBrowserOfTheSessionAlone) {
  give(0, "consent", "b0b0");
  EXPECT_EQ(withdraw(0, "c1c1").status, 409);
  EXPECT_EQ(withdraw(1, "").status, 409) << "a session that has not begun";
  EXPECT_EQ(ask("GET", of(0) + "withdrawal").status, 405);
  EXPECT_EQ(ask("POST", of(0) + "withdrawal", "{").status, 400);
  const std::string deep =
      R"({"session": "b0b0", "x": )" + std::string(17, '[') + std::string(17, ']') + "}";
  EXPECT_EQ(ask("POST", of(0) + "withdrawal", deep).status, 400);
  EXPECT_EQ(ask("POST", of(0) + "withdrawal", "{\"session\": 7}").status, 400);
  EXPECT_EQ(service_.sessions().state(0).stored, 1u);
}

TEST_F(Withdrawal, AcceptsNothingAfterwardsAndMayBeSentAgain) {
  give(0, "consent", "b0b0");
  EXPECT_EQ(withdraw(0, "b0b0").status, 200);
  EXPECT_EQ(withdraw(0, "b0b0").status, 200);
  EXPECT_EQ(error_in(give(0, "consent", "b0b0")), "withdrawn");
  EXPECT_EQ(error_in(give(0, "demographics", "b0b0")), "withdrawn");
  EXPECT_EQ(json::parse(get(of(0) + "session.json").body).at("ended"), "withdrawn");
}

TEST_F(Withdrawal, GivesThePlanToAnother) {
  agree_to_join("b1");
  agree_to_join("b2");
  give_all(2, "b1");
  give_all(3, "b2");
  EXPECT_TRUE(service_.sessions().has_enough());
  const int plan = service_.sessions().state(2).session.plan;
  withdraw(2, "b1");
  EXPECT_FALSE(service_.sessions().has_enough());
  agree_to_join("b3");
  EXPECT_EQ(service_.sessions().state(4).session.plan, plan);
}

TEST_F(Withdrawal, IsDoneByTheExperimenterToo) {
  give_all(0, "b0b0");
  const auto by_lab = [&](const json& body) {
    return ask("POST", lab() + "withdrawal", body.dump());
  };
  EXPECT_EQ(by_lab({{"participant", "p002"}}).status, 404) << "has not begun";
  EXPECT_EQ(by_lab({{"participant", 1}}).status, 400);
  EXPECT_EQ(ask("POST", "/lab/" + std::string(32, '0') + "/withdrawal", "{}").status, 404);
  EXPECT_EQ(json::parse(by_lab({{"participant", "b0b0"}}).body),
            (json{{"participant", "p001"}, {"erased", 9}}));
  EXPECT_EQ(by_lab({{"participant", "p001"}}).status, 404) << "has withdrawn";
  EXPECT_EQ(status().at("participants").at(0).at("state"), "withdrawn");
}

TEST_F(Withdrawal, FindsTheSessionByIdAndByCode) {
  give(0, "consent", "b0b0");
  EXPECT_EQ(session_of(store_, "p001"), 0);
  EXPECT_EQ(session_of(store_, "b0b0"), 0);
  EXPECT_EQ(session_of(store_, "p002"), std::nullopt) << "has not begun";
  EXPECT_EQ(browser_of(store_, 0), "b0b0");
  EXPECT_EQ(browser_of(store_, 1), "");
}

/// A table of three people, two of whom have one id.
const std::string head = "\xEF\xBB\xBFparticipant,comment,session\r\n";
const std::string first = "p001,\"two\r\nlines, \"\"quoted\"\"\",aa\r\n";
const std::string second = "p002,'=1,bb\n\n";
const std::string third = "p001,,cc";

FileWithout table_without(const WithdrawnParticipant& who) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "t.csv", head + first + second + third);
  return without_participant(folder.path() / "t.csv", who).value();
}

TEST(WithdrawalFromTables, KeepsAllOtherBytes) {
  EXPECT_EQ(table_without({.name = "p002", .session = {}, .ids = {}}).text,
            head + first + "\n" + third);
  EXPECT_EQ(table_without({.name = "p001", .session = {}, .ids = {}}).text, head + second);
  EXPECT_EQ(table_without({.name = "p001", .session = {}, .ids = {}}).removed, 2);
  EXPECT_EQ(table_without({.name = "cc", .session = {}, .ids = {}}).text, head + first + second);
  EXPECT_EQ(table_without({.name = "p001", .session = "aa", .ids = {}}).text, head + second + third)
      << "the browser session tells people of one id apart";
  EXPECT_EQ(table_without({.name = "p0", .session = {}, .ids = {}}).removed, 0);
}

TEST_F(Withdrawal, TakesTheSessionOutOfRecords) {
  give_all(0, "b0b0");
  give_all(1, "c1c1");
  const auto file = folder_.path() / "walks-answers.json";
  write_file(file, get(lab() + "answers.json").body);
  const auto without = without_participant(file, {.name = "p001", .session = {}, .ids = {}});
  ASSERT_TRUE(without);
  EXPECT_EQ(without->removed, 1);
  EXPECT_EQ(without->text.find("b0b0"), std::string::npos);
  EXPECT_EQ(json::parse(without->text).at("sessions").size(), 1u);
  const auto page = folder_.path() / "records.json";
  write_file(page, R"({"participant": "p001", "name": "b0b0", "records": {}})");
  EXPECT_TRUE(without_participant(page, {.name = "b0b0", .session = {}, .ids = {}})->is_removed);
  const auto saved = folder_.path() / "saved.json";
  write_file(saved, R"({"format": "mien-session-1", "participant": "p001", "session": "b0b0",
                        "records": {}})");
  EXPECT_TRUE(without_participant(saved, {.name = "b0b0", .session = {}, .ids = {}})->is_removed);
  EXPECT_TRUE(without_participant(saved, {.name = "p001", .session = {}, .ids = {}})->is_removed);
  EXPECT_FALSE(without_participant(page, {.name = "c1c1", .session = {}, .ids = {}})->is_removed);
}

TEST(WithdrawalFromTables, FindsTablesThatNameTheParticipantAlone) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "sessions.csv";
  write_file(file, "participant,trials\np001,3\np003/ab,4\n");
  EXPECT_TRUE(names_participant(file, {"p001"}));
  EXPECT_TRUE(names_participant(file, {"p009", "p003"}));
  EXPECT_FALSE(names_participant(file, {"p002"}));
  write_file(file, "participant,session\np001,aa\n");
  EXPECT_FALSE(names_participant(file, {"p001"})) << "its rows are deleted";
}

TEST(WithdrawalFromTables, AreEachTakenOnceAndNotThroughLinksOutOfTheirFolder) {
  const test::TemporaryFolder folder, elsewhere;
  const auto table = canonical(folder.path()) / "a.csv";
  write_file(table, "participant,session\n");
  write_file(elsewhere.path() / "b.csv", "participant,session\n");
  std::filesystem::create_symlink(elsewhere.path() / "b.csv", folder.path() / "b.csv");
  EXPECT_EQ(files_of_participants({folder.path(), folder.path() / "." / "a.csv"}),
            std::vector<std::filesystem::path>{table});
  EXPECT_EQ(files_of_participants({folder.path() / "b.csv"}),
            std::vector<std::filesystem::path>{canonical(elsewhere.path()) / "b.csv"})
      << "who names a link means its file";
  EXPECT_THROW(files_of_participants({folder.path() / "c.csv"}), Error);
}

TEST(WithdrawalFromTables, LeavesOtherFilesAlone) {
  const test::TemporaryFolder folder;
  const WithdrawnParticipant who{.name = "p001", .session = {}, .ids = {}};
  write_file(folder.path() / "a.csv", "participant,value\np001,3\n");
  EXPECT_FALSE(without_participant(folder.path() / "a.csv", who)) << "without sessions";
  write_file(folder.path() / "a.json", "[1]");
  EXPECT_FALSE(without_participant(folder.path() / "a.json", who));
  write_file(folder.path() / "b.json", "no JSON");
  EXPECT_FALSE(without_participant(folder.path() / "b.json", who));
  write_file(folder.path() / "c.csv", "participant,session\np001\n");
  EXPECT_THROW(without_participant(folder.path() / "c.csv", who), Error);
}

}  // namespace
}  // namespace mien::pipeline
