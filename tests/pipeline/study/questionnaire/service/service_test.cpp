#include "pipeline/study/questionnaire/service/service.h"

#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"
#include "pipeline/study/server/http_server.h"
#include "pipeline/study/server/raw_client.h"

namespace mien::pipeline {
namespace {

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
            "participant,session,design,consented_at,finished,ended,screening_fault,"
            "language,consent_version,consent_sha256,closing_comment,age,hand\n");
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
      "TRACE " + own + " HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n",
      "OPTIONS " + own + " HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n",
      "DELETE " + own + "records/consent HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n"};
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
