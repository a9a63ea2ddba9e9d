#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/service/served_questionnaire.h"
#include "pipeline/study/server/full_disk.h"

namespace mien::pipeline {
namespace {

TEST_F(Service, TellsASecondBrowserThatTheSessionIsOpenElsewhere) {
  give(0, "consent");
  give(0, "demographics");
  const auto from = [&](const std::string& name, const std::string& browser) {
    return give_text(0, good_record(study_, 0, name, browser));
  };
  for (const char* name : {"consent", "demographics", "trial-1", "trial-2"})
    EXPECT_EQ(error_in(from(name, "c3d4")), "elsewhere") << name;
  EXPECT_EQ(nlohmann::json::parse(get(of(0) + "session.json").body).at("browser"), "a1b2");
  EXPECT_EQ(from("trial-1", "a1b2").status, 200);
  QuestionnaireService again(study_, store_);  // and after a restart
  EXPECT_EQ(again.sessions().state(0).browser, "a1b2");
  EXPECT_EQ(again.sessions().state(0).stored, 3u);
}

TEST_F(Service, TellsAPageThatItsParticipantHasRefused) {
  const auto ended = [&] {
    return nlohmann::json::parse(get(of(0) + "session.json").body).value("ended", "");
  };
  EXPECT_EQ(ended(), "");
  nlohmann::json refusal = good_record(study_, 0, "consent");
  refusal["responses"][0]["value_raw"] = "refused";
  give_text(0, refusal);
  EXPECT_EQ(ended(), "refused");
}

TEST_F(Service, GivesThoseWhoAgreeSessionsOfTheirOwnUntilThereIsEnough) {
  const std::string answer = agree_to_join("b1").body;
  ASSERT_EQ(service_.sessions().states().size(), 3u);
  EXPECT_EQ(nlohmann::json::parse(answer),
            nlohmann::json({{"kept", "consent"}, {"session", "../.." + of(2)}}));
  EXPECT_EQ(service_.sessions().state(2).session.participant, "p003");
  EXPECT_EQ(service_.sessions().state(2).session.plan, 0);
  EXPECT_EQ(agree_to_join("b1").status, 200);  // sent again
  EXPECT_EQ(service_.sessions().states().size(), 3u);
  agree_to_join("b2");
  EXPECT_EQ(service_.sessions().state(3).session.plan, 1);
  const auto has_enough = [&] {
    return nlohmann::json::parse(get(join() + "session.json").body).value("enough", false);
  };
  give_all(2, "b1");
  EXPECT_FALSE(has_enough());
  give_all(3, "b2");
  EXPECT_TRUE(has_enough());
  EXPECT_EQ(error_in(agree_to_join("b3")), "enough");
  EXPECT_EQ(status().at("participants").size(), 4u);
  EXPECT_EQ(status().at("participants").at(0).at("state"), "waiting");
}

// The page leads those who have a session there, to go on or to see their code again.
TEST_F(Service, ShowsTheOpenPageAlsoWhenAllPlacesAreTaken) {
  agree_to_join("b1");
  agree_to_join("b2");
  agree_to_join("b3");
  give_all(2, "b1");
  give_all(3, "b2");
  ASSERT_TRUE(service_.sessions().has_enough());
  EXPECT_EQ(get(join()).status, 200);
  EXPECT_EQ(get(join()).body, study_.page.at("index.html").bytes);
  EXPECT_EQ(give(4, "demographics", "b3").status, 200) << "whoever is under way may finish";
}

// Tables of answers show the names of browser sessions.
TEST_F(Service, GivesTheLinkOfASessionToNobodyWhoKnowsItsName) {
  const HttpResponse first = agree_to_join("b1");
  EXPECT_EQ(agree_to_join("b1").body, first.body) << "the answer may have been lost";
  nlohmann::json other = good_record(study_, 0, "consent", "b1");
  other["comment"] = "by somebody else";
  EXPECT_EQ(error_in(ask("POST", join() + "records/consent", other.dump())), "elsewhere");
  give(2, "demographics", "b1");
  EXPECT_EQ(error_in(agree_to_join("b1")), "elsewhere") << "the session has gone on";
  EXPECT_EQ(service_.sessions().states().size(), 3u);
}

TEST_F(Service, GivesNoPlanToThoseWhoOnlyLookOrRefuse) {
  for (int visit = 0; visit < 3; ++visit) {  // a phone that is sent away asks for all of that
    EXPECT_EQ(get(join()).body, study_.page.at("index.html").bytes);
    EXPECT_EQ(get(join() + "questionnaire.js").status, 200);
    const nlohmann::json shown = nlohmann::json::parse(get(join() + "session.json").body);
    EXPECT_TRUE(shown.at("joining").get<bool>());
    EXPECT_TRUE(shown.at("media").empty());
    EXPECT_TRUE(shown.at("sessions").at(0).at("trials").empty());
  }
  EXPECT_EQ(agree_to_join("b1", "refused").body, "{\"kept\":\"consent\"}");
  EXPECT_EQ(service_.sessions().states().size(), 2u);
  EXPECT_TRUE(store_.records().empty());
  EXPECT_EQ(status().at("refused_at_join"), 1);
  agree_to_join("b1", "refused");  // sent again
  agree_to_join("b2", "refused");
  EXPECT_EQ(status().at("refused_at_join"), 2);
  EXPECT_EQ(ask("POST", join() + "records/trial-1", "{}").status, 405);
  EXPECT_EQ(ask("POST", join() + "records/consent", "{}").status, 400);
  get(of(0) + "session.json");
  EXPECT_EQ(status().at("participants").at(0).at("state"), "opened");
  agree_to_join("b1");
  EXPECT_EQ(service_.sessions().state(2).session.plan, 0);
}

TEST_F(Service, LetsThoseWhoRefuseGoWhenTheDiskIsFull) {
  {
    const FullDisk full(1);
    EXPECT_EQ(agree_to_join("b1", "refused").status, 200);
    EXPECT_EQ(agree_to_join("b2").status, 507);
    EXPECT_NE(status().at("trouble"), "");
  }
  EXPECT_EQ(agree_to_join("b1", "refused").status, 200);
  EXPECT_EQ(status().at("refused_at_join"), 1);
}

TEST_F(Service, GivesThePlanOfThoseWhoLeftAgain) {
  agree_to_join("b1");
  agree_to_join("b2");
  give_all(2, "b1");
  now_ += 3600;  // the other has gone
  agree_to_join("b3");
  EXPECT_EQ(service_.sessions().state(4).session.plan, 1);
  const nlohmann::json session = nlohmann::json::parse(get(of(4) + "session.json").body);
  EXPECT_EQ(session.at("sessions").at(0).at("participant"), "p005");
  EXPECT_EQ(session.at("kept"), nlohmann::json({"consent"}));
  EXPECT_EQ(store_.records_of(4).size(), 1u);
}

TEST_F(Service, DoesNotTakeThosePeopleForGoneWhosePagesAreOpen) {
  agree_to_join("b1");
  agree_to_join("b2");
  give_all(2, "b1");
  for (int minute = 0; minute < 20; ++minute) {  // a long film: nothing is sent but signs of life
    now_ += 60;
    EXPECT_EQ(ask("HEAD", of(3) + "session.json").status, 200);
  }
  agree_to_join("b3");
  EXPECT_EQ(service_.sessions().state(4).session.plan, 0) << "the other plan is being followed";
}

TEST_F(Service, KnowsAfterARestartWhoWasThere) {
  agree_to_join("b1");
  give(2, "demographics", "b1");
  EXPECT_EQ(seconds_of(iso_time(now_)), now_);
  EXPECT_EQ(seconds_of("soon"), 0);
  QuestionnaireService again(study_, store_, {}, [this] { return now_ + 60; });
  EXPECT_EQ(again.sessions().state(2).last_seen, now_);
  EXPECT_TRUE(again.sessions().state(2).is_online(now_ + 60));
  EXPECT_FALSE(again.sessions().state(2).is_online(now_ + 3600));
}

}  // namespace
}  // namespace mien::pipeline
