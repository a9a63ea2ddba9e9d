#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/screening_record.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

const nlohmann::ordered_json screening = {
    {"questions",
     {{{"id", "years"},
       {"ask", "How old?"},
       {"answer", "number"},
       {"accept", {{"from", 18}, {"to", 65}}}},
      {{"id", "gender"}, {"ask", "Which?"}, {"answer", {"woman", "man", "other"}}},
      {{"id", "vision"}, {"ask", "Well?"}, {"answer", {"yes", "no"}}, {"accept", {"yes"}}}}},
    {"quotas", {{{"of", {{"gender", {"woman"}}, {"years", {{"to", 30}}}}}, {"at_most", 1}}}},
    {"window", {800, 600}},
    {"refresh_hz", 50.0}};

/// A study with a screening and places for many.
class ScreeningPage : public testing::Test {
 protected:
  ScreeningPage() {
    study_.experiment["screening"] = screening;
    study_.experiment["consent"] = {{"version", "2"}, {"sha256", "abc"}};
    study_.facts = questionnaire_facts(study_.experiment);
  }

  HttpResponse ask(const std::string& method, const std::string& target,
                   const std::string& body = "") {
    return service().answer({.method = method,
                             .path = plain_path(target).value(),
                             .headers = {{"content-type", "application/json"}},
                             .body = body,
                             .address = "127.0.0.1"});
  }

  /// Made once the study is as it is to be.
  QuestionnaireService& service() {
    if (!service_)
      service_ = std::make_unique<QuestionnaireService>(
          study_, store_, ServiceRates{.joining = {.burst = 1000, .per_second = 1000}},
          [this] { return now_; });
    return *service_;
  }

  /// The number of a session whose participant has agreed.
  int join() {
    const std::string browser = "b" + std::to_string(++browsers_);
    const json consent = good_record(study_, 0, "consent", browser);
    const std::string link = "/join/" + service().sessions().join_link();
    EXPECT_EQ(ask("POST", link + "/records/consent", consent.dump()).status, 200);
    return static_cast<int>(service().sessions().states().size()) - 1;
  }

  std::string of(int session) { return "/s/" + state(session).session.link + "/"; }
  SessionState state(int session) { return service().sessions().state(session); }

  json record_of(int session, double years, const std::string& gender = "man",
                 const std::string& vision = "yes") {
    return {{"record", "screening"},
            {"session", state(session).browser},
            {"responses",
             {{{"item", "years"}, {"value_raw", years}, {"rt_ms", 1}},
              {{"item", "gender"}, {"value_raw", gender}, {"rt_ms", 1}},
              {{"item", "vision"}, {"value_raw", vision}, {"rt_ms", 1}}}},
            {"comment", ""},
            {"started_at", "now"},
            {"viewport_width", 800},
            {"viewport_height", 600},
            {"refresh_hz", 59.9}};
  }

  HttpResponse give(int session, const json& record) {
    return ask("POST", of(session) + "records/" + record.at("record").get<std::string>(),
               record.dump());
  }

  /// How the server says that the session ended; empty: it goes on.
  std::string end_after(const json& record, int session) {
    const HttpResponse answer = give(session, record);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return json::parse(answer.body).value("ended", "");
  }

  void finish(int session) {
    for (std::size_t at = state(session).stored; at < state(session).names.size(); ++at) {
      const SessionState now = state(session);
      const HttpResponse answer =
          give(session, good_record(study_, now.session.plan, now.names[at], now.browser));
      ASSERT_EQ(answer.status, 200) << answer.body;
    }
  }

  test::TemporaryFolder folder_;
  ServedStudy study_ = example_study(folder_.path(), 4);
  SessionStore store_{folder_.path() / "answers.db"};
  std::int64_t now_ = 1'800'000'000;
  int browsers_ = 0;
  std::unique_ptr<QuestionnaireService> service_;
};

TEST_F(ScreeningPage, AcceptsTheEndsOfARangeAndNothingBeyond) {
  const auto end_of = [&](double years) {
    const int session = join();
    return end_after(record_of(session, years), session);
  };
  for (const double years : {18.0, 65.0, 40.5}) EXPECT_EQ(end_of(years), "") << years;
  for (const double years : {17.9, 65.1, -3.0}) EXPECT_EQ(end_of(years), "screened_out") << years;
}

TEST_F(ScreeningPage, TurnsAwayByAnswerWindowAndRefreshRate) {
  const auto fault_of = [&](const json& record, int session) {
    end_after(record, session);
    return word_of(screening_fault_words, state(session).screening_fault);
  };
  int session = join();
  EXPECT_EQ(fault_of(record_of(session, 30, "man", "no"), session), "answer");
  const auto measured = [&](const char* what, const json& value) {
    session = join();
    json record = record_of(session, 30);
    record[what] = value;
    record["responses"] = json::array();  // such participants are asked nothing
    return fault_of(record, session);
  };
  EXPECT_EQ(measured("viewport_width", 799), "window");
  EXPECT_EQ(measured("viewport_height", 599), "window");
  EXPECT_EQ(measured("viewport_width", nullptr), "window");
  EXPECT_EQ(measured("refresh_hz", 30.0), "refresh_hz");
  session = join();
  json unmeasured = record_of(session, 30);
  unmeasured["refresh_hz"] = nullptr;
  EXPECT_EQ(fault_of(unmeasured, session), "none");
}

// The same numbers as in pipeline/study/page/tests/questionnaire/recruitment.mjs.
TEST(ToneCount, IsThatOfThePage) {
  const auto counts = [](const std::string& session) {
    return std::pair(tone_count(session, 1), tone_count(session, 2));
  };
  EXPECT_EQ(counts("b1"), std::pair(5, 3));
  EXPECT_EQ(counts("b2"), std::pair(5, 7));
  EXPECT_EQ(counts("3f9c-77"), std::pair(3, 5));
}

class SoundScreening : public ScreeningPage {
 protected:
  SoundScreening() {
    study_.experiment["screening"]["sound"] = true;
    study_.facts = questionnaire_facts(study_.experiment);
  }

  /// A record with counts of tones that differ from the right ones by these numbers.
  json counted(int session, const std::vector<int>& errors, bool with_questions = true) {
    json record = record_of(session, 30);
    if (!with_questions) record["responses"] = json::array();
    const std::string name = record["session"];
    for (int i = 0; i < static_cast<int>(errors.size()); ++i)
      record["responses"].push_back(
          {{"item", "tones_" + std::to_string(i + 1)},
           {"value_raw", tone_count(name, i + 1) + errors[static_cast<std::size_t>(i)]},
           {"rt_ms", 1}});
    return record;
  }
};

TEST_F(SoundScreening, TurnsAwayWhoCountsTonesWrongTwice) {
  int session = join();
  EXPECT_EQ(end_after(counted(session, {0}), session), "");
  session = join();
  EXPECT_EQ(end_after(counted(session, {1, 0}), session), "");
  session = join();
  EXPECT_EQ(end_after(counted(session, {1, -1}, false), session), "screened_out");
  EXPECT_EQ(state(session).screening_fault, ScreeningFault::sound);
  session = join();
  EXPECT_EQ(end_after(counted(session, {1}, false), session), "screened_out");
  const std::string csv = participants_csv(study_, service().sessions());
  EXPECT_NE(csv.find(",tones_1,tones_2,years,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",sound,"), std::string::npos) << csv;
}

TEST_F(SoundScreening, RefusesCountsThatItsPageCannotHaveSent) {
  const int session = join();
  EXPECT_EQ(give(session, counted(session, {}, false)).status, 400);        // no count
  EXPECT_EQ(give(session, counted(session, {1, 1}, true)).status, 400);     // was asked more
  EXPECT_EQ(give(session, counted(session, {0, 0, 0}, true)).status, 400);  // a third count
  json word = counted(session, {0});
  word["responses"].back()["value_raw"] = "five";
  EXPECT_EQ(give(session, word).status, 400);
}

TEST_F(ScreeningPage, RefusesRecordsThatItsPageCannotHaveSent) {
  const int session = join();
  json missing = record_of(session, 30);
  missing["responses"].erase(2);
  EXPECT_EQ(give(session, missing).status, 400);
  json word = record_of(session, 30, "nobody");
  EXPECT_EQ(give(session, word).status, 400);
  json text = record_of(session, 30);
  text["responses"][0]["value_raw"] = "30";
  EXPECT_EQ(give(session, text).status, 400);
  json demographics = good_record(study_, 0, "demographics", state(session).browser);
  EXPECT_EQ(give(session, demographics).status, 409) << "before the screening";
  EXPECT_EQ(state(session).stored, 1u);
}

TEST_F(ScreeningPage, EndsTheSessionForGood) {
  const int session = join();
  const json record = record_of(session, 12);
  EXPECT_EQ(end_after(record, session), "screened_out");
  EXPECT_EQ(end_after(record, session), "screened_out") << "sent again";
  const json next = good_record(study_, 0, "demographics", state(session).browser);
  EXPECT_EQ(give(session, next).status, 409);
  const json shown = json::parse(ask("GET", of(session) + "session.json").body);
  EXPECT_EQ(shown.at("ended"), "screened_out");
  service_.reset();  // and after a restart
  EXPECT_EQ(state(session).ended, SessionEnd::screened_out);
  EXPECT_EQ(state(session).screening_fault, ScreeningFault::answer);
  EXPECT_EQ(give(session, next).status, 409);
}

TEST_F(ScreeningPage, DoesNotTellWhatItAccepts) {
  const std::string shown = ask("GET", of(join()) + "session.json").body;
  EXPECT_NE(shown.find("vision"), std::string::npos);
  EXPECT_EQ(shown.find("accept"), std::string::npos);
  EXPECT_EQ(shown.find("at_most"), std::string::npos);
}

TEST_F(ScreeningPage, HoldsQuotasOverAllWhoFinishOrAreUnderWay) {
  const int first = join(), second = join(), third = join(), fourth = join();
  EXPECT_EQ(end_after(record_of(first, 25, "woman"), first), "");
  EXPECT_EQ(end_after(record_of(second, 31, "woman"), second), "") << "counted by no quota";
  EXPECT_EQ(end_after(record_of(third, 30, "woman"), third), "screened_out");
  EXPECT_EQ(state(third).screening_fault, ScreeningFault::quota);
  EXPECT_EQ(end_after(record_of(first, 25, "woman"), first), "") << "sent again";
  service_.reset();
  const int later = join();
  EXPECT_EQ(end_after(record_of(later, 30, "woman"), later), "screened_out")
      << "the first is still there after a restart";
  now_ += 3600;  // the first has left
  EXPECT_EQ(end_after(record_of(fourth, 20, "woman"), fourth), "");
  finish(fourth);
  now_ += 3600;
  const int fifth = join();
  EXPECT_EQ(end_after(record_of(fifth, 20, "woman"), fifth), "screened_out") << "one has finished";
  service_.reset();
  EXPECT_EQ(state(fifth).screening_fault, ScreeningFault::quota) << "after a restart";
}

TEST_F(ScreeningPage, GivesTheirPlansToOthers) {
  for (int turned_away = 0; turned_away < 30; ++turned_away) {
    const int session = join();
    EXPECT_EQ(end_after(record_of(session, 90), session), "screened_out");
  }
  std::set<int> plans;
  for (int taken = 0; taken < 4; ++taken) {
    const int session = join();
    EXPECT_EQ(end_after(record_of(session, 30), session), "");
    plans.insert(state(session).session.plan);
    finish(session);
  }
  EXPECT_EQ(plans.size(), 4u);
  EXPECT_TRUE(service().sessions().has_enough());
}

TEST_F(ScreeningPage, IsBoundedInAll) {
  int joined = 0;
  for (; joined < 200 && !service().sessions().has_enough(); ++joined) {
    const int session = join();
    end_after(record_of(session, 90), session);
  }
  EXPECT_EQ(joined, 156) << "forty for each of four plans, with the planned ones";
}

TEST_F(ScreeningPage, StandsInTheTableOfParticipants) {
  const int out = join(), in = join();
  end_after(record_of(out, 90, "other"), out);
  end_after(record_of(in, 30, "woman"), in);
  finish(in);
  const std::string lab = "/lab/" + service().sessions().lab_link() + "/participants.csv";
  const CsvTable table = parse_csv(ask("GET", lab).body, "participants.csv");
  ASSERT_EQ(table.rows.size(), 2u);
  const auto text = [&](std::size_t row, const char* column) {
    return table.rows[row][static_cast<std::size_t>(require_column(table, column))].text;
  };
  EXPECT_EQ(text(0, "ended"), "screened_out");
  EXPECT_EQ(text(0, "screening_fault"), "answer");
  EXPECT_EQ(text(0, "years"), "90");
  EXPECT_EQ(text(0, "gender"), "other");
  EXPECT_EQ(text(0, "finished"), "0");
  EXPECT_EQ(text(1, "ended"), "completed");
  EXPECT_EQ(text(1, "screening_fault"), "");
  EXPECT_EQ(text(1, "consent_version"), "2");
  EXPECT_EQ(text(1, "consent_sha256"), "abc");
}

// A page can send any character of JSON, a table cannot hold it.
TEST_F(ScreeningPage, TablesHaveNoControlCharactersOfAnswers) {
  study_.experiment["demographics"] = {{{"id", "job"}, {"ask", "Which?"}, {"answer", "text"}}};
  study_.facts = questionnaire_facts(study_.experiment);
  const int session = join();
  end_after(record_of(session, 30), session);
  json about = good_record(study_, 0, "demographics", state(session).browser);
  about["responses"] = {{{"item", "job"}, {"value_raw", std::string("a\0b\x1b\n\"c", 7)}}};
  ASSERT_EQ(give(session, about).status, 200);
  const CsvTable table = parse_csv(participants_csv(study_, service().sessions()), "p.csv");
  const auto column = static_cast<std::size_t>(require_column(table, "job"));
  EXPECT_EQ(table.rows.at(0).at(column).text, "a b \n\"c");
}

TEST_F(ScreeningPage, TakesConsentToItsOwnTextOnly) {
  json consent = good_record(study_, 0, "consent", "b");
  const std::string link = "/join/" + service().sessions().join_link() + "/records/consent";
  consent["consent"] = {{"version", "1"}, {"sha256", "abc"}};
  EXPECT_EQ(ask("POST", link, consent.dump()).status, 400);
  consent["consent"] = {{"version", "2"}, {"sha256", "abc"}};
  EXPECT_EQ(ask("POST", link, consent.dump()).status, 200);
  const int session = static_cast<int>(service().sessions().states().size()) - 1;
  json later = record_of(session, 30);
  later["consent"] = consent["consent"];
  EXPECT_EQ(give(session, later).status, 400);
}

}  // namespace
}  // namespace mien::pipeline
