#include "pipeline/questionnaire/service/service.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/questionnaire/service/collected_answers.h"
#include "pipeline/questionnaire/service/served_example.h"
#include "pipeline/server/http_server.h"
#include "pipeline/server/raw_client.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

class Service : public testing::Test {
 protected:
  HttpResponse get(const std::string& target) { return ask("GET", target); }

  HttpResponse ask(const std::string& method, const std::string& target,
                   const std::string& body = "", const std::string& type = "application/json") {
    return service_.answer({.method = method,
                            .path = plain_path(target).value(),
                            .headers = {{"content-type", type}, {"host", "here:80"}},
                            .body = body,
                            .address = "127.0.0.1"});
  }

  HttpResponse give_text(int session, const nlohmann::json& record) {
    return ask("POST", of(session) + "records/" + record.at("record").get<std::string>(),
               record.dump());
  }

  HttpResponse give(int session, const std::string& name, const std::string& browser = "a1b2") {
    return give_text(session, good_record(study_, session % 2, name, browser));
  }

  void give_all(int session, const std::string& browser = "a1b2") {
    const SessionState before = service_.sessions().state(session);
    for (std::size_t at = before.kept; at < before.names.size(); ++at)
      ASSERT_EQ(give(session, before.names[at], browser).status, 200) << before.names[at];
  }

  HttpResponse agree_to_join(const std::string& browser, const std::string& word = "agreed") {
    nlohmann::json consent = good_record(study_, 0, "consent", browser);
    consent["responses"][0]["value_raw"] = word;
    return ask("POST", join() + "records/consent", consent.dump());
  }

  std::string of(int session) const {
    return "/s/" + service_.sessions().state(session).session.link + "/";
  }
  std::string lab() const { return "/lab/" + service_.sessions().lab_link() + "/"; }
  std::string join() const { return "/join/" + service_.sessions().join_link() + "/"; }

  nlohmann::json status() { return nlohmann::json::parse(get(lab() + "status.json").body); }

  test::TemporaryFolder folder_;
  ServedStudy study_ = example_study(folder_.path(), 2);
  SessionStore store_{folder_.path() / "answers.db"};
  std::int64_t now_ = 1'800'000'000;
  QuestionnaireService service_{study_, store_, {}, [this] { return now_; }};
};

std::string error_in(const HttpResponse& response) {
  return nlohmann::json::parse(response.body).at("error");
}

TEST_F(Service, ShowsAParticipantThePageAndOneSession) {
  EXPECT_EQ(get(of(0)).body, study_.page.at("index.html").bytes);
  EXPECT_EQ(get(of(0) + "questionnaire.js").type, "text/javascript; charset=utf-8");
  EXPECT_EQ(get(of(0).substr(0, of(0).size() - 1)).status, 308);
  give(0, "consent");
  const nlohmann::json session = nlohmann::json::parse(get(of(0) + "session.json").body);
  EXPECT_EQ(session.at("kept"), nlohmann::json({"consent"}));
  ASSERT_EQ(session.at("sessions").size(), 1u);
  EXPECT_EQ(session.at("sessions").at(0).at("participant"), "p001");
  EXPECT_EQ(session.at("sessions").at(0).at("trials").size(), 6u);
}

TEST_F(Service, TellsParticipantsNothingOfConditionsAndOthers) {
  for (const std::string& answer : {get(of(0) + "session.json").body, get(of(0)).body}) {
    EXPECT_EQ(answer.find("walk-sad"), std::string::npos);
    EXPECT_EQ(answer.find("walk-happy"), std::string::npos);
    EXPECT_EQ(answer.find("p002"), std::string::npos);
    EXPECT_EQ(answer.find(folder_.path().string()), std::string::npos);
    EXPECT_EQ(answer.find(service_.sessions().lab_link()), std::string::npos);
    EXPECT_EQ(answer.find(service_.sessions().state(1).session.link), std::string::npos);
  }
}

TEST_F(Service, SendsMediaByTokensAlone) {
  const nlohmann::json session = nlohmann::json::parse(get(of(0) + "session.json").body);
  for (const auto& [token, media] : session.at("media").items()) {
    EXPECT_EQ(media.at("file"), "../../media/" + token);
    const HttpResponse response = get("/media/" + token);
    ASSERT_TRUE(response.part);
    EXPECT_EQ(response.type, "video/mp4");
  }
  EXPECT_EQ(get("/media/walk-sad.mp4").status, 404);
  EXPECT_EQ(get("/media/").status, 404);
  EXPECT_EQ(get("/media").status, 404);
}

TEST_F(Service, KeepsEachRecordOnceAndInOrder) {
  EXPECT_EQ(error_in(give(0, "trial-1")), "order");
  EXPECT_EQ(nlohmann::json::parse(give(0, "trial-1").body).at("next"), "consent");
  EXPECT_EQ(give(0, "consent").body, "{\"kept\":\"consent\"}");
  EXPECT_EQ(give(0, "consent").body, "{\"kept\":\"consent\"}");
  give(0, "demographics");
  nlohmann::json other = good_record(study_, 0, "trial-1");
  EXPECT_EQ(give_text(0, other).status, 200);
  other["responses"][0]["value_raw"] = 3;
  EXPECT_EQ(give_text(0, other).status, 409);
  EXPECT_EQ(error_in(give_text(0, other)), "other");
  EXPECT_EQ(store_.records_of(0).size(), 3u);
}

TEST_F(Service, TakesNothingOfThoseWhoRefuse) {
  nlohmann::json refusal = good_record(study_, 0, "consent");
  refusal["responses"][0]["value_raw"] = "refused";
  EXPECT_EQ(give_text(0, refusal).status, 200);
  EXPECT_EQ(give_text(0, refusal).status, 200);
  EXPECT_EQ(error_in(give(0, "demographics")), "refused");
  EXPECT_EQ(status().at("participants").at(0).at("state"), "refused");
  EXPECT_EQ(participants_csv(study_, service_.sessions()),
            "participant,session,design,consented_at,finished,age,hand\n");
}

TEST_F(Service, RefusesWhatIsNoRecordOfThatPage) {
  const std::string place = of(0) + "records/consent";
  const std::string good = good_record(study_, 0, "consent").dump();
  EXPECT_EQ(ask("POST", place, good, "text/plain").status, 415);
  EXPECT_EQ(ask("POST", place, good.substr(1)).status, 400);
  EXPECT_EQ(ask("POST", place, "").status, 400);
  EXPECT_EQ(ask("POST", place, std::string(60'000, '[')).status, 400);
  EXPECT_EQ(ask("POST", place, "{\"record\": \"\xff\"}").status, 400);
  EXPECT_EQ(ask("POST", place, good_record(study_, 0, "ending").dump()).status, 400);
  EXPECT_EQ(ask("POST", of(0) + "records/trial-99", good).status, 404);
  EXPECT_EQ(ask("POST", of(0) + "session.json", good).status, 405);
  EXPECT_EQ(ask("POST", of(0), good).status, 405);
  EXPECT_EQ(get(place).status, 405);
  EXPECT_EQ(ask("PUT", place, good).status, 405);
  EXPECT_EQ(ask("DELETE", place).status, 405);
  EXPECT_EQ(ask("POST", lab() + "status.json", good).status, 405);
  EXPECT_EQ(ask("POST", join(), good).status, 405);
  EXPECT_EQ(ask("POST", place, good, "application/json; charset=utf-8").status, 200);
  EXPECT_EQ(store_.records().size(), 1u);
}

TEST_F(Service, KnowsNoLinkButItsOwn) {
  const std::string link = service_.sessions().state(0).session.link;
  for (const std::string& target :
       {std::string("/s/"), std::string("/s"), "/s/" + std::string(32, '0') + "/",
        "/s/" + link.substr(1) + "/", "/s/" + link + "0/", "/lab/" + link + "/",
        "/join/" + link + "/", "/s/" + service_.sessions().lab_link() + "/", of(0) + "a/b",
        of(0) + "records", of(0) + "answers.csv", lab() + "a/b", lab() + "answers.db",
        std::string("/"), std::string("/favicon.ico"), "/s/" + link + "/media/x"}) {
    EXPECT_EQ(get(target).status, 404) << target;
  }
}

TEST_F(Service, SlowsDownThoseWhoGuess) {
  int guesses = 0;
  while (get("/s/" + random_link() + "/").status == 404 && guesses < 1000) ++guesses;
  EXPECT_GE(guesses, 30);
  EXPECT_LT(guesses, 200);
  EXPECT_EQ(get(of(0)).status, 200);  // participants at the same address are not held up
}

TEST_F(Service, LimitsWhatOneLinkAsks) {
  int requests = 0;
  while (get(of(0)).status == 200 && requests < 5000) ++requests;
  EXPECT_LT(requests, 1000);
  EXPECT_EQ(get(of(0)).status, 429);
  EXPECT_EQ(get(of(1)).status, 200);
}

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
  EXPECT_EQ(again.sessions().state(0).kept, 3u);
}

TEST_F(Service, TellsAPageThatItsParticipantHasRefused) {
  const auto is_refused = [&] {
    return nlohmann::json::parse(get(of(0) + "session.json").body).at("refused").get<bool>();
  };
  EXPECT_FALSE(is_refused());
  nlohmann::json refusal = good_record(study_, 0, "consent");
  refusal["responses"][0]["value_raw"] = "refused";
  give_text(0, refusal);
  EXPECT_TRUE(is_refused());
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
  give_all(2, "b1");
  give_all(3, "b2");
  EXPECT_EQ(get(join()).status, 403);
  EXPECT_EQ(error_in(agree_to_join("b3")), "enough");
  EXPECT_EQ(status().at("participants").size(), 4u);
  EXPECT_EQ(status().at("participants").at(0).at("state"), "waiting");
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
  EXPECT_EQ(ask("POST", join() + "records/trial-1", "{}").status, 405);
  EXPECT_EQ(ask("POST", join() + "records/consent", "{}").status, 400);
  get(of(0) + "session.json");
  EXPECT_EQ(status().at("participants").at(0).at("state"), "opened");
  agree_to_join("b1");
  EXPECT_EQ(service_.sessions().state(2).session.plan, 0);
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

TEST_F(Service, TellsTheLaboratoryWhoIsWhere) {
  EXPECT_EQ(status().at("participants").at(0).at("state"), "waiting");
  get(of(0) + "session.json");
  give(0, "consent");
  nlohmann::json one = status().at("participants").at(0);
  EXPECT_EQ(one.at("state"), "here");
  EXPECT_EQ(one.at("kept"), 1);
  EXPECT_EQ(one.at("records"), 9);
  EXPECT_EQ(one.at("next"), "demographics");
  now_ += 3600;
  EXPECT_EQ(status().at("participants").at(0).at("state"), "away");
  give_all(1);
  EXPECT_EQ(status().at("participants").at(1).at("state"), "done");
}

TEST_F(Service, ShowsHistogramsOfWhatIsAnalysed) {
  give_all(0);
  give_all(1);
  const nlohmann::json now = status();
  EXPECT_EQ(now.at("checks"), nlohmann::json({{"passed", 2}, {"failed", 0}}));
  std::map<std::string, nlohmann::json> items;
  for (const nlohmann::json& one : now.at("histograms"))
    items[one.at("item").get<std::string>() + (one.at("is_pair") ? " of two" : "")] = one;
  EXPECT_EQ(items.at("calm-wild").at("answers"), 2);
  EXPECT_EQ(items.at("calm-wild").at("mean"), 1.2);
  EXPECT_EQ(items.at("calm-wild").at("bins").at(7).at("count"), 2);
  EXPECT_EQ(items.at("emotion").at("bins").at(1).at("count"), 2);
  EXPECT_EQ(items.at("sad-happy").at("answers"), 2);
  EXPECT_EQ(items.at("sad-happy of two").at("bins").at(0).at("label"), "walk-sad");
  EXPECT_EQ(items.at("words").at("bins").size(), 0u);
}

TEST_F(Service, ExportsWhatWasGiven) {
  give_all(1);
  const std::string csv = get(lab() + "answers.csv").body;
  EXPECT_EQ(answer_rows(parse_csv(csv, "answers.csv")).size(), 7u);
  EXPECT_EQ(get(lab() + "participants.csv").body,
            "participant,session,design,consented_at,finished,age,hand\n"
            "p002,a1b2,0123abcd,2027-01-15T08:00:00Z,1,31,left\n");
  const nlohmann::json all = nlohmann::json::parse(get(lab() + "answers.json").body);
  EXPECT_EQ(all.at("sessions").at(1).at("records").size(), 9u);
  EXPECT_EQ(get(lab() + "links.csv").body, "participant,link\np001,http://here:80" + of(0) +
                                               "\np002,http://here:80" + of(1) + "\n");
}

TEST_F(Service, GoesOnWhereAnEarlierOneEnded) {
  give(1, "consent");
  give(1, "demographics");
  give(1, "trial-1");
  give(1, "trial-2");
  QuestionnaireService again(study_, store_);
  EXPECT_EQ(again.sessions().lab_link(), service_.sessions().lab_link());
  EXPECT_EQ(again.sessions().state(1).kept, 4u);
  EXPECT_EQ(again.sessions().histograms(), service_.sessions().histograms());
}

TEST_F(Service, RefusesAnotherStudyOrDesign) {
  ServedStudy other = study_;
  other.facts.design = "else";
  try {
    const QuestionnaireService changed(other, store_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("--store"), std::string::npos);
  }
  other.experiment["study"] = "runs";
  EXPECT_THROW(QuestionnaireService(other, store_), Error);
}

TEST_F(Service, WithstandsWhatIsSentToHarmIt) {
  const HttpServer server(HttpSettings{},
                          [&](const HttpRequest& request) { return service_.answer(request); });
  const std::string own = of(0);
  nlohmann::json script = good_record(study_, 0, "consent");
  script["comment"] = "<script>alert(1)</script>'; DROP TABLE records; --";
  EXPECT_EQ(
      status_in(reply_of(server.port(), post_request(own + "records/consent", script.dump()))),
      200);
  const std::string replayed = post_request(own + "records/consent", script.dump());
  EXPECT_EQ(status_in(reply_of(server.port(), replayed)), 200);
  nlohmann::json changed = script;
  changed["comment"] = "else";
  const std::vector<std::string> attacks = {
      get_request(own + "../../../../etc/passwd"),
      get_request("/media/../answers.db"),
      get_request("/media/%2e%2e/answers.db"),
      get_request("/media/..%2fanswers.db"),
      get_request("/media/walk-sad.mp4"),
      get_request("//etc/passwd"),
      get_request(own + "%2e%2e/"),
      get_request("/s/%00/"),
      get_request("/lab//status.json"),
      get_request("/lab/../lab/"),
      post_request(own + "records/consent", changed.dump()),
      post_request(own + "records/../consent", script.dump()),
      post_request(of(1) + "records/trial-1", good_record(study_, 1, "trial-1").dump()),
      post_request("/s/0/records/consent", script.dump()),
      post_request(own + "records/consent", std::string(100'000, ' ')),
      "TRACE " + own + " HTTP/1.1\r\nConnection: close\r\n\r\n",
      "OPTIONS " + own + " HTTP/1.1\r\nConnection: close\r\n\r\n",
      "DELETE " + own + "records/consent HTTP/1.1\r\nConnection: close\r\n\r\n"};
  for (const std::string& attack : attacks) {
    const std::string answer = reply_of(server.port(), attack);
    EXPECT_GE(status_in(answer), 400) << attack.substr(0, 80);
    EXPECT_LT(status_in(answer), 500) << attack.substr(0, 80);
    for (const std::string& secret :
         {std::string("root:"), std::string("film of"), std::string("p002"),
          folder_.path().string(), service_.sessions().lab_link()})
      EXPECT_EQ(answer.find(secret), std::string::npos) << attack.substr(0, 80);
  }
  ASSERT_EQ(store_.records().size(), 1u);
  EXPECT_EQ(nlohmann::json::parse(store_.records().at(0).content), script);
}

}  // namespace
}  // namespace mien::pipeline
