#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/service/served_example.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {

/// A small study of two planned participants, asked without a network; the clock stands still
/// unless a test moves it.
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
    for (std::size_t at = before.stored; at < before.names.size(); ++at)
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

/// The word by which a page knows why it was refused.
inline std::string error_in(const HttpResponse& response) {
  return nlohmann::json::parse(response.body).at("error");
}

}  // namespace mien::pipeline
