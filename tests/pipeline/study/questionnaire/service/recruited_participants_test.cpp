#include "pipeline/study/questionnaire/service/recruited_participants.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/recruitment.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {
namespace {

const nlohmann::ordered_json recruitment = {
    {"url_parameters", {"PROLIFIC_PID", "STUDY_ID"}},
    {"pseudonymise", false},
    {"most_failed_checks", 0},
    {"ends",
     {{"completed", {{"address", "https://back/?cc=DONE"}, {"code", "DONE"}}},
      {"refused", {{"address", "https://back/?cc=NO"}, {"code", "NO"}}},
      {"failed_attention", {{"address", "https://back/?cc=FAILED"}, {"code", "FAILED"}}}}}};

ServedStudy recruiting(const std::filesystem::path& folder, bool pseudonymise) {
  ServedStudy study = example_study(folder, 2);
  study.experiment["recruitment"] = recruitment;
  study.experiment["recruitment"]["pseudonymise"] = pseudonymise;
  study.facts = questionnaire_facts(study.experiment);
  return study;
}

/// A study whose participants come from a recruitment service.
class Recruited : public testing::TestWithParam<bool> {
 protected:
  HttpResponse ask(const std::string& method, const std::string& target,
                   const std::string& body = "") {
    return service_.answer({.method = method,
                            .path = plain_path(target).value(),
                            .headers = {{"content-type", "application/json"}, {"host", "here:80"}},
                            .body = body,
                            .address = "127.0.0.1"});
  }

  nlohmann::json join(const std::string& browser, const nlohmann::json& parameters,
                      const std::string& word = "agreed") {
    nlohmann::json consent = good_record(study_, 0, "consent", browser);
    consent["responses"][0]["value_raw"] = word;
    consent["url_parameters"] = parameters;
    const std::string link = "/join/" + service_.sessions().join_link();
    const HttpResponse answer = ask("POST", link + "/records/consent", consent.dump());
    last_status_ = answer.status;
    return nlohmann::json::parse(answer.body);
  }

  /// Gives all further records of the session; what the server answers to the last.
  nlohmann::json finish(int session, const std::string& browser, int attention) {
    const SessionState state = service_.sessions().state(session);
    nlohmann::json answer;
    for (std::size_t at = 1; at < state.names.size(); ++at) {
      nlohmann::json record = good_record(study_, state.session.plan, state.names[at], browser);
      if (state.names[at] == "trial-4") record["responses"][0]["value_raw"] = attention;
      const HttpResponse given =
          ask("POST", link_of(session) + "records/" + state.names[at], record.dump());
      EXPECT_EQ(given.status, 200) << given.body;
      answer = nlohmann::json::parse(given.body);
      EXPECT_EQ(answer.contains("destination"), state.names[at] == "ending");
    }
    return answer;
  }

  std::string link_of(int session) const {
    return "/s/" + service_.sessions().state(session).session.link + "/";
  }

  std::string exported(const std::string& name) {
    return ask("GET", "/lab/" + service_.sessions().lab_link() + "/" + name).body;
  }

  test::TemporaryFolder folder_;
  ServedStudy study_ = recruiting(folder_.path(), GetParam());
  SessionStore store_{folder_.path() / "answers.db"};
  QuestionnaireService service_{study_, store_, {}, [] { return std::int64_t{1'800'000'000}; }};
  int last_status_ = 0;
};

INSTANTIATE_TEST_SUITE_P(WithValuesAndHashes, Recruited, testing::Bool());

TEST_P(Recruited, StandWithTheParametersOfTheirLinkInEveryRow) {
  const std::string id = "5f1c0ffee";
  join("b1", {{"PROLIFIC_PID", id}, {"STUDY_ID", "s-1"}});
  join("b2", {{"PROLIFIC_PID", id}});  // the same person once more
  ASSERT_EQ(last_status_, 200);
  finish(2, "b1", 5);
  const std::string kept =
      GetParam() ? pseudonym_of(service_.sessions().salt(), "PROLIFIC_PID", id) : id;
  const std::string answers_text = exported("answers.csv");
  const CsvTable answers = parse_csv(answers_text, "answers.csv");
  const auto column = static_cast<std::size_t>(find_column(answers, "url_PROLIFIC_PID"));
  ASSERT_GT(answers.rows.size(), 5u);
  for (const auto& row : answers.rows) EXPECT_EQ(row[column].text, kept);
  const std::string participants = exported("participants.csv");
  EXPECT_NE(participants.find("p003"), std::string::npos);
  EXPECT_NE(participants.find(kept, participants.find(kept) + 1), std::string::npos)
      << "the second visit has the same\n"
      << participants;
  // Nothing else holds what was hashed.
  std::string all = answers_text + exported("answers.json") + participants;
  for (const StoredRecord& record : store_.records()) all += record.content;
  EXPECT_EQ(all.find(id) == std::string::npos, GetParam());
}

TEST_P(Recruited, AreSentBackByHowTheirSessionEnded) {
  join("b1", {});
  join("b2", {});
  const nlohmann::json before = nlohmann::json::parse(ask("GET", link_of(2) + "session.json").body);
  EXPECT_FALSE(before.contains("destination"));
  EXPECT_EQ(before.dump().find("DONE"), std::string::npos) << "the code before the end";
  EXPECT_EQ(before.at("recruitment").at("ends").at("refused").at("code"), "NO");
  EXPECT_EQ(finish(2, "b1", 5).at("destination").at("code"), "DONE");
  EXPECT_EQ(finish(3, "b2", 1).at("destination").at("code"), "FAILED");
  const auto again = nlohmann::json::parse(ask("GET", link_of(2) + "session.json").body);
  EXPECT_EQ(again.at("destination").at("address"), "https://back/?cc=DONE");
}

TEST_P(Recruited, HaveValuesOfOneLine) {
  join("b1", {{"PROLIFIC_PID", "a\nb\tc"}, {"STUDY_ID", ""}});
  EXPECT_EQ(last_status_, 200);
  const std::string kept =
      GetParam() ? pseudonym_of(service_.sessions().salt(), "PROLIFIC_PID", "a b c") : "a b c";
  EXPECT_NE(exported("participants.csv").find("," + kept + ",\n"), std::string::npos);
}

TEST_P(Recruited, GiveNoOtherParametersAndNoneThatAreTooLong) {
  join("b1", {{"credit_token", "x"}});
  EXPECT_EQ(last_status_, 400);
  join("b1", {{"PROLIFIC_PID", std::string(201, 'x')}});
  EXPECT_EQ(last_status_, 400);
  join("b1", {{"PROLIFIC_PID", 5}});
  EXPECT_EQ(last_status_, 400);
  join("b1", nlohmann::json::array());
  EXPECT_EQ(last_status_, 400);
  EXPECT_TRUE(store_.records().empty());
  join("b1", {{"PROLIFIC_PID", "x"}}, "refused");
  EXPECT_EQ(last_status_, 200);
  EXPECT_TRUE(store_.records().empty()) << "nothing is kept of whoever refuses";
}

TEST(Recruitment, AndWhatIdentifiesPeopleAreNotSeenByReports) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "p.csv",
             "participant,session,design,consented_at,finished,url_PROLIFIC_PID,age,jatos_worker,"
             "closing_comment,tones_1\n"
             "p001,a1,d,2026-01-31T09:00:00Z,1,5f1c,31,7,I am Jo,5\n");
  const ParticipantTable table = read_participants(folder.path() / "p.csv");
  EXPECT_EQ(table.questions(), std::vector<std::string>{"age"});
  ASSERT_EQ(table.table.rows.size(), 1u);
  EXPECT_EQ(table.table.rows[0].size(), 7u) << "the count of tones is kept, and asks nothing";
  EXPECT_EQ(table.table.rows[0][5].text, "31");
}

TEST(Recruitment, KeepsEachParameterOnce) {
  Recruitment from{.url_parameters = {"STUDY_ID", "source"}};
  from.prolific.completed = "C1";
  from.redirect.refused = "https://x/{source}?a={hitId}&b={hitId}";
  EXPECT_EQ(kept_parameters(from), (std::vector<std::string>{"STUDY_ID", "source", "PROLIFIC_PID",
                                                             "SESSION_ID", "hitId"}));
  EXPECT_EQ(address_after(from, SessionEnd::completed),
            "https://app.prolific.com/submissions/complete?cc=C1");
  EXPECT_EQ(address_after(from, SessionEnd::refused), from.redirect.refused);
  EXPECT_EQ(address_after(from, SessionEnd::screened_out), "");
}

}  // namespace
}  // namespace mien::pipeline
