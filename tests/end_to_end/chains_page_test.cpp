#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/live_page.h"
#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

using nlohmann::json;
using Point = std::vector<double>;
using Row = std::map<std::string, std::string>;

/// Two chains of four steps, or of one choice in each of four dimensions, and practice.
constexpr char adaptive_text[] = R"(mien: 1
study: words
seed: 7
examples: {set: builtin:walks-10, ratings: builtin}
adaptive:
  title: Words for movements
  participants: 2
  consent: Taking part is voluntary.
  ending: Thank you.
  words: [sad, happy]
  space: {groups: all}
  practice: 1
  phones: served
  demographics:
    - {id: age, ask: "How old are you?", answer: number}
)";
constexpr char gibbs[] = "  method: gibbs\n  iterations: 1\n";
constexpr char choices[] = "  method: mcmc\n  iterations: 4\n  deviation: 0.6\n";

Point point_in(const std::string& text) {
  Point point;
  for (std::size_t at = 0; at < text.size(); at = text.find_first_of(' ', at) + 1) {
    point.push_back(std::stod(text.substr(at)));
    if (text.find(' ', at) == text.npos) break;
  }
  return point;
}

std::vector<Row> by_trial(const json& told) { return rows_in(told.at("steps").get<std::string>()); }

/// Folded into a range, by steps from one end to the other.
double folded(double value, double low, double high) {
  while (value < low || value > high) value = value < low ? 2.0 * low - value : 2.0 * high - value;
  return value;
}

/// Participants of Gibbs sampling or MCMC with people.
class ChainsPage : public LivePage {
 protected:
  ChainsPage() : LivePage("chains", std::string(adaptive_text) + gibbs) {}

  void use(const std::string& more) { scratch.write("study.yaml", adaptive_text + more); }

  json experiment() const { return json::parse(text_of(folder() / "experiment.json")); }

  json session_of(const std::string& participant) const {
    const json made = experiment();
    for (const json& session : made.at("sessions"))
      if (session.at("participant") == participant) return session;
    return {};
  }

  /// Every trial of the plan is a row, and each chain goes from its start to where the answers
  /// lead.
  void expect_planned(const std::vector<Row>& rows) const {
    ASSERT_FALSE(rows.empty());
    const json plan = session_of(rows.front().at("participant"));
    const json chains = experiment().at("chains");
    std::map<std::string, Point> points = plan.at("starts").get<std::map<std::string, Point>>();
    ASSERT_EQ(rows.size(), plan.at("trials").size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows[i];
      const json& trial = plan.at("trials").at(i);
      SCOPED_TRACE(trial.dump());
      const bool is_practice = trial.at("practice");
      const std::string word = trial.at("word");
      const std::string chain = std::to_string(trial.at("chain").get<int>());
      EXPECT_EQ(row.at("trial"), std::to_string(trial.at("number").get<int>()));
      EXPECT_EQ(row.at("is_practice"), is_practice ? "1" : "0");
      EXPECT_EQ(row.at("word") + "/" + row.at("chain"), word + "/" + chain);
      EXPECT_EQ(row.at("step"), std::to_string(trial.at("step").get<int>()));
      const bool is_check = trial.contains("expected");
      EXPECT_EQ(row.at("is_check"), is_check ? "1" : "0");
      EXPECT_EQ(row.at("passed"), is_check ? "1" : "");
      // An answer to a check leads nowhere.
      Point check = plan.at("starts").value("check/1", Point());
      Point& point = is_check ? check : points.at((is_practice ? "practice" : word) + "/" + chain);
      EXPECT_EQ(point_in(row.at("point")), point);
      if (chains.at("method") == "gibbs")
        expect_slider(trial, chains, row, point);
      else
        expect_choice(trial, chains, row, point);
    }
  }

  static void expect_slider(const json& trial, const json& chains, const Row& row, Point& point) {
    const std::size_t free = trial.at("dimension");
    const json& dimension = chains.at("dimensions").at(free);
    EXPECT_EQ(row.at("dimension"), dimension.at("name").get<std::string>());
    EXPECT_EQ(std::stod(row.at("slider_start")), trial.at("slider").at("start").get<double>());
    EXPECT_EQ(row.at("is_reversed"), trial.at("slider").at("reversed").get<bool>() ? "1" : "0");
    EXPECT_EQ(row.at("proposal") + row.at("is_proposal_first") + row.at("chose_proposal"), "");
    EXPECT_GE(std::stoi(row.at("moves")), 1);
    const double value = std::stod(row.at("value"));
    const double low = dimension.at("low"), high = dimension.at("high");
    const double share = 1000.0 * (value - low) / (high - low);
    EXPECT_NEAR(share, std::round(share), 1e-6);
    EXPECT_GE(share, -1e-6);
    EXPECT_LE(share, 1000.0 + 1e-6);
    point[free] = value;
  }

  static void expect_choice(const json& trial, const json& chains, const Row& row, Point& point) {
    const Point proposal = point_in(row.at("proposal"));
    ASSERT_EQ(proposal.size(), point.size());
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double low = chains.at("dimensions").at(i).at("low");
      const double high = chains.at("dimensions").at(i).at("high");
      const double by = trial.at("normals").at(i).get<double>() *
                        chains.at("deviation").get<double>() * (high - low);
      EXPECT_NEAR(proposal[i], folded(point[i] + by, low, high), 1e-12) << i;
    }
    EXPECT_EQ(row.at("is_proposal_first"), trial.at("proposal_first").get<bool>() ? "1" : "0");
    EXPECT_EQ(row.at("dimension") + row.at("value") + row.at("slider_start"), "");
    EXPECT_EQ(row.at("moves"), "0");
    if (row.at("chose_proposal") == "1") point = proposal;
  }

  /// What was done in each trial is what its row says.
  void expect_chosen(const json& told) const {
    const std::vector<Row> rows = by_trial(told);
    const json dimensions = experiment().at("chains").at("dimensions");
    ASSERT_EQ(told.at("chosen").size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double chosen = told.at("chosen").at(i);
      const Row& row = rows[i];
      if (row.at("dimension").empty()) {
        const bool is_first = chosen == 1.0;
        EXPECT_EQ(row.at("chose_proposal") == "1", is_first == (row.at("is_proposal_first") == "1"))
            << i;
        continue;
      }
      const double share = row.at("is_reversed") == "1" ? 1.0 - chosen : chosen;
      for (const json& dimension : dimensions) {
        if (dimension.at("name") != row.at("dimension")) continue;
        const double low = dimension.at("low"), high = dimension.at("high");
        EXPECT_NEAR(std::stod(row.at("value")), low + share * (high - low), 1e-9) << i;
      }
    }
  }

  /// The program reads what the browser saved.
  void expect_results(const json& told) const {
    const auto steps = scratch.write("steps.csv", told.at("steps").get<std::string>());
    const Ended ended = run_mien({"study", "chains", study().string(), steps.string(), "-o",
                                  (scratch.path() / "chains").string()},
                                 120.0);
    EXPECT_EQ(ended.code, 0) << ended.errors;
  }
};

TEST_F(ChainsPage, SlidersLeadTheirChainsWithoutAServer) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("whole");
  EXPECT_EQ(told.at("requests"), 0);
  expect_planned(by_trial(told));
  expect_chosen(told);
  expect_results(told);
  const auto people = rows_in(told.at("participant").get<std::string>());
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].at("finished"), "1");
}

TEST_F(ChainsPage, ChoicesLeadTheirChainsWithoutAServer) {
  use(choices);
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("whole");
  const std::vector<Row> rows = by_trial(told);
  expect_planned(rows);
  expect_chosen(told);
  for (const char* chosen : {"0", "1"})
    EXPECT_TRUE(std::ranges::any_of(rows, [&](const Row& row) {
      return row.at("chose_proposal") == chosen;
    })) << chosen;
  expect_results(told);
}

TEST_F(ChainsPage, ModificationsLeadTheirChainsWithoutAServer) {
  std::string text = std::string(adaptive_text) + gibbs;
  text.replace(text.find("{groups: all}"), 13,
               "{recipe: {of: normal, emotions: {sad: [0, 1.5], angry: [0, 1]}, posture: "
               "{head-flexion: [-10, 30]}, tempo: [0.7, 1.4]}}");
  scratch.write("study.yaml", text);
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("whole");
  EXPECT_EQ(told.at("requests"), 0);
  expect_planned(by_trial(told));
  expect_chosen(told);
  expect_results(told);
}

TEST_F(ChainsPage, GoesOnAfterAReloadWhereItsChainsWere) {
  for (const char* method : {gibbs, choices}) {
    use(method);
    if (!is_exported()) GTEST_SKIP() << no_browser_core;
    const std::vector<Row> rows = by_trial(played("reload"));
    expect_planned(rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_EQ(rows[i].at("attempt"), i == 3 ? "2" : "1") << method << i;
    std::filesystem::remove_all(folder());
  }
}

TEST_F(ChainsPage, IsTakenByKeyboardAloneAndByTouch) {
  for (const char* method : {gibbs, choices}) {
    use(method);
    if (!is_exported()) GTEST_SKIP() << no_browser_core;
    for (const char* how : {"keys", "touch"}) {
      const json told = played(how);
      expect_planned(by_trial(told));
      expect_chosen(told);
    }
    std::filesystem::remove_all(folder());
  }
}

TEST_F(ChainsPage, HasAttentionChecksThatLeadNowhere) {
  use(std::string(gibbs) + "  attention: {every: 3}\n");
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("whole");
  const std::vector<Row> rows = by_trial(told);
  expect_planned(rows);
  expect_chosen(told);
  expect_results(told);
  EXPECT_EQ(std::ranges::count_if(rows, [](const Row& row) { return row.at("is_check") == "1"; }),
            2);
}

TEST_F(ChainsPage, EndsTheSessionOfWhoFailsChecks) {
  use(std::string(gibbs) + "  attention: {every: 3, max_failed_checks: 0}\n");
  Running server = serve();
  const json told = played("careless", link_of(0));
  for (const char* page : {"said", "again"})
    EXPECT_NE(told.at(page).get<std::string>().find("attention checks were not answered"),
              std::string::npos)
        << told.at(page);
  EXPECT_FALSE(told.at("posted").contains("ending"));
  server.send(SIGINT);
  EXPECT_EQ(server.wait().code, 0);
}

TEST_F(ChainsPage, TurnsPhonesAwayWhereTheyAreRefused) {
  std::string text = std::string(adaptive_text) + gibbs;
  text.replace(text.find("phones: served"), 14, "phones: refused");
  scratch.write("study.yaml", text);
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("refused_phone");
  EXPECT_NE(told.at("text").get<std::string>().find("larger than a phone's"), std::string::npos);
  EXPECT_EQ(told.at("buttons"), 0);
}

TEST_F(ChainsPage, HandsItsStepsToJatos) {
  if (!is_exported()) GTEST_SKIP() << no_browser_core;
  const json told = played("jatos");
  const std::vector<Row> rows = rows_in(told.at("result").get<std::string>());
  expect_planned(rows);
  EXPECT_EQ(rows.at(3).at("attempt"), "2");
  const std::string participant = rows.front().at("participant");
  EXPECT_EQ(participant, "p002");  // that is taken least
  EXPECT_TRUE(told.at("files").contains(participant + "-participants.csv"));
  EXPECT_TRUE(told.at("files").contains(participant + "-records.json"));
}

TEST_F(ChainsPage, HasNoFaultOfAccessibility) {
  for (const char* method : {gibbs, choices}) {
    use(method);
    if (!is_exported()) GTEST_SKIP() << no_browser_core;
    const json checked = played("accessibility");
    EXPECT_GT(checked.at("checked").get<int>(), 20);
    EXPECT_EQ(checked.at("faults"), json::array()) << method;
    std::filesystem::remove_all(folder());
  }
}

TEST_F(ChainsPage, IsTakenOnAServerWithChainsOfItsOwn) {
  Running server = serve();
  const json posted = played("reload", link_of(0)).at("posted");
  for (int trial = 1; trial <= 9; ++trial) {
    const json& chain = posted.at("trial-" + std::to_string(trial)).at("chain");
    EXPECT_EQ(chain.at("person"), 0);
    EXPECT_EQ(chain.at("attempt"), trial == 4 ? 2 : 1);
  }
  EXPECT_TRUE(posted.contains("ending"));
  server.send(SIGINT);
  EXPECT_EQ(server.wait().code, 0);
}

/// A chain of four steps that two people lead in turns; the second finds it complete.
TEST_F(ChainsPage, LeadsChainsAcrossParticipantsUntilTheyAreComplete) {
  for (const std::string method : {gibbs, choices}) {
    std::string text =
        adaptive_text + method + "  across_participants: true\n  trials_per_participant: 3\n";
    text.replace(text.find("[sad, happy]"), 12, "[sad]");
    scratch.write("study.yaml", text);
    std::filesystem::remove(scratch.path() / "kept-links.csv");
    Running server = serve();
    std::vector<json> chain;
    for (int person = 0; person < 2; ++person) {
      const json posted = played("whole", link_of(person)).at("posted");
      for (int trial = 2; trial <= 4; ++trial) {  // the first is practice
        const json& record = posted.at("trial-" + std::to_string(trial));
        if (record.contains("chain")) chain.push_back(record.at("chain"));
      }
      EXPECT_TRUE(posted.contains("ending")) << person;
    }
    ASSERT_EQ(chain.size(), 4U) << method;
    for (std::size_t step = 0; step < chain.size(); ++step) {
      EXPECT_EQ(chain[step].at("step"), step);
      if (step == 0) continue;
      const json& former = chain[step - 1];
      json point = former.at("point");
      if (method == gibbs)
        point.at(former.at("dimension").get<std::size_t>()) = former.at("value");
      else if (former.at("chose_proposal"))
        point = former.at("proposal");
      EXPECT_EQ(chain[step].at("point"), point) << method << step;
    }
    server.send(SIGINT);
    EXPECT_EQ(server.wait().code, 0);
    std::filesystem::remove(store());
  }
}

/// Two chains of four steps, each by two people. Whatever a killed server has said was stored is
/// there, and no place of a step is given to two people.
TEST_F(ChainsPage, IsTakenByFiveAtOnceWhileTheServerIsKilled) {
  std::string text = std::string(adaptive_text) + gibbs +
                     "  chains: 2\n  across_participants: true\n  people_per_step: 2\n"
                     "  answer_within_s: 30\n  trials_per_participant: 5\n";
  text.replace(text.find("participants: 2"), 15, "participants: 5");
  text.replace(text.find("[sad, happy]"), 12, "[sad]");
  scratch.write("study.yaml", text);
  auto server = serving("0");
  std::string links = link_of(0);
  const std::size_t colon = links.find(':', 7);
  const std::string port = links.substr(colon + 1, links.find('/', colon) - colon - 1);
  for (int person = 1; person < 5; ++person) links += "," + link_of(person);
  const auto ready = scratch.path() / "ready";
  Running people(script_words("scenarios.mjs", {"together", links, ready.string()}));
  for (int tries = 0; tries < 1200 && !std::filesystem::exists(ready) && people.is_running();
       ++tries)
    pause_for(0.1);
  ASSERT_TRUE(std::filesystem::exists(ready));
  int kills = 0;
  for (; kills < 6 && people.is_running(); ++kills) {
    server->send(SIGKILL);
    server->wait();
    pause_for(0.5);
    server = serving(port);
    pause_for(4.0);
  }
  EXPECT_GE(kills, 2);
  const Ended ended = people.wait(300.0);
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const json told = json::parse(ended.output);
  EXPECT_EQ(told.at("troubles"), json::array());
  // Chain, step and person, and who gave the answer.
  std::map<std::tuple<int, int, int>, std::pair<std::size_t, json>> given;
  for (std::size_t who = 0; who < 5; ++who) {
    EXPECT_TRUE(told.at("posted").at(who).contains("ending"));
    for (const auto& [name, record] : told.at("posted").at(who).items()) {
      if (!record.contains("chain") || name == "trial-1") continue;  // practice
      const json& chain = record.at("chain");
      EXPECT_TRUE(given
                      .emplace(std::tuple(chain.at("chain").get<int>(), chain.at("step").get<int>(),
                                          chain.at("person").get<int>()),
                               std::pair(who, chain))
                      .second)
          << chain;
    }
  }
  ASSERT_EQ(given.size(), 16U);
  for (int chain = 1; chain <= 2; ++chain) {
    json point = given.at({chain, 0, 0}).second.at("point");
    for (int step = 0; step < 4; ++step) {
      const auto& [one, first] = given.at({chain, step, 0});
      const auto& [other, second] = given.at({chain, step, 1});
      EXPECT_NE(one, other);
      EXPECT_EQ(first.at("point"), point);
      EXPECT_EQ(second.at("point"), point);
      const std::size_t free = first.at("dimension");
      EXPECT_EQ(second.at("dimension"), free);
      // The median of two.
      point.at(free) = 0.5 * (first.at("value").get<double>() + second.at("value").get<double>());
    }
  }
  server->send(SIGINT);
  EXPECT_EQ(server->wait().code, 0);
}

TEST_F(ChainsPage, MovesTheFloorAsFarAsTheFigureWalks) {
  const Ended ended = run_script("../figure/floor.mjs", {});
  EXPECT_EQ(ended.code, 0) << ended.output;
}

/// With a fake motion core and a fake server, which loses connections and refuses records.
TEST_F(ChainsPage, BearsAServerThatFails) {
  const Ended ended = run_script("fake_served.mjs", {});
  EXPECT_EQ(ended.code, 0) << ended.output;
}

}  // namespace
}  // namespace mien::test
