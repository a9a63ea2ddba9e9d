#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/served_questionnaire.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

/// A study in English and Arabic, between which browsers choose.
class ServiceInLanguages : public Service {
 protected:
  ServiceInLanguages() {
    study_.experiment["consent"] = {{"version", "2"}, {"sha256", "abc"}};
    study_.experiment["screening"] = {{"questions",
                                       {{{"id", "years"},
                                         {"ask", "How old?"},
                                         {"answer", "number"},
                                         {"accept", {{"from", 18}}}}}}};
    study_.experiment["languages"] = {{"en", json::object()},
                                      {"ar",
                                       {{"title", "كيف"},
                                        {"consent", {{"version", "2"}, {"sha256", "def"}}},
                                        {"screening", study_.experiment["screening"]}}}};
    study_.facts = questionnaire_facts(study_.experiment);
  }

  json consent_in(const std::string& language, const std::string& sha256) {
    json consent = good_record(study_, 0, "consent");
    if (!language.empty()) consent["language"] = language;
    consent["consent"] = {{"version", "2"}, {"sha256", sha256}};
    return consent;
  }

  std::vector<std::string> column(const std::string& name) {
    const CsvTable table = parse_csv(participants_csv(study_, service_.sessions()), "p.csv");
    std::vector<std::string> values;
    for (const auto& row : table.rows)
      values.push_back(row[static_cast<std::size_t>(require_column(table, name))].text);
    return values;
  }
};

TEST_F(ServiceInLanguages, StatesTheLanguageAndItsConsentInTheTableOfParticipants) {
  EXPECT_EQ(give_text(0, consent_in("ar", "def")).status, 200);
  EXPECT_EQ(give_text(1, consent_in("en", "abc")).status, 200);
  EXPECT_EQ(column("language"), (std::vector<std::string>{"ar", "en"}));
  EXPECT_EQ(column("consent_sha256"), (std::vector<std::string>{"def", "abc"}));
  EXPECT_EQ(column("consent_version"), (std::vector<std::string>{"2", "2"}));
}

TEST_F(ServiceInLanguages, TakesConsentToTheTextOfItsLanguageOnly) {
  EXPECT_EQ(give_text(0, consent_in("ar", "abc")).status, 400);
  EXPECT_EQ(give_text(0, consent_in("en", "def")).status, 400);
  EXPECT_EQ(give_text(0, consent_in("de", "abc")).status, 400);
  EXPECT_EQ(give_text(0, consent_in("e n", "abc")).status, 400);
  EXPECT_EQ(give_text(0, consent_in("", "xyz")).status, 400);
  EXPECT_EQ(give_text(0, consent_in("", "def")).status, 200);
  EXPECT_EQ(column("language"), std::vector<std::string>{""});
  EXPECT_EQ(column("consent_sha256"), std::vector<std::string>{"def"});
}

TEST_F(ServiceInLanguages, DoesNotTellWhatItAcceptsInAnyLanguage) {
  const json session = json::parse(get(of(0) + "session.json").body);
  EXPECT_EQ(session.at("languages").at("ar").at("title"), "كيف");
  EXPECT_EQ(session.dump().find("accept"), std::string::npos) << session.dump();
}

TEST_F(ServiceInLanguages, SpeaksToVisitorsInTheLanguagesOfTheStudy) {
  const std::string page = get("/").body;
  EXPECT_NE(page.find("<p lang=\"en\" dir=\"ltr\">This link is not valid."), page.npos) << page;
  EXPECT_NE(page.find("<p lang=\"ar\" dir=\"rtl\">هذا الرابط غير صالح."), page.npos) << page;
  EXPECT_EQ(page.find("lang=\"ja\""), page.npos);
}

TEST_F(Service, SpeaksToVisitorsInTheStudysOwnTexts) {
  study_.experiment["page_texts"]["en"] = {{"direction", "rtl"},
                                           {"questionnaire", {{"unknown_link", "<No>"}}}};
  EXPECT_NE(get("/").body.find("<p lang=\"en\" dir=\"rtl\">&lt;No&gt;</p>"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
