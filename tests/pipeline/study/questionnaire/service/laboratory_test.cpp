#include <map>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"

namespace mien::pipeline {
namespace {

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

TEST_F(Service, ShowsTheLaboratoryItsPageAndParticipantsNoneOfIt) {
  EXPECT_EQ(get(lab()).body, "<title>lab</title>");
  EXPECT_EQ(get(lab() + "questionnaire.js").status, 404);
  EXPECT_NE(get(of(0)).body, "<title>lab</title>");
}

TEST_F(Service, ExportsWhatWasGiven) {
  give_all(1);
  const std::string csv = get(lab() + "answers.csv").body;
  EXPECT_EQ(answer_rows(parse_csv(csv, "answers.csv")).size(), 7u);
  EXPECT_EQ(get(lab() + "participants.csv").body,
            "participant,session,design,consented_at,finished,ended,screening_fault,"
            "language,consent_version,consent_sha256,closing_comment,age,hand\n"
            "p002,a1b2,0123abcd,2027-01-15T08:00:00Z,1,completed,,,,,\"Nice, \"\"really\"\" \",31,"
            "left\n");
  const nlohmann::json all = nlohmann::json::parse(get(lab() + "answers.json").body);
  EXPECT_EQ(all.at("sessions").at(1).at("records").size(), 9u);
  study_.public_url = "https://lab.example.org";
  EXPECT_NE(get(lab() + "links.csv").body.find("p001,https://lab.example.org" + of(0) + "\n"),
            std::string::npos);
  study_.public_url.clear();
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
  EXPECT_EQ(again.sessions().state(1).stored, 4u);
  EXPECT_EQ(again.sessions().histograms(), service_.sessions().histograms());
}

TEST_F(Service, RefusesAnotherStudyOrDesign) {
  ServedStudy other = example_study(folder_.path() / "other", 2);
  other.facts = study_.facts;
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

}  // namespace
}  // namespace mien::pipeline
