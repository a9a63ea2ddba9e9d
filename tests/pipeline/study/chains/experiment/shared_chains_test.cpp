#include "pipeline/study/questionnaire/service/shared_chains.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/study/chains/experiment/chain_example.h"
#include "pipeline/study/chains/experiment/chain_results.h"
#include "pipeline/study/chains/experiment/simulated_chains.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

/// An answer to an assigned step: a slider at a share of its range.
ChainRecord answer_to(const ChainFacts& facts, const AssignedStep& step, double share) {
  const StepView view = step_view(facts.design, step.name, step.step, step.person);
  const DimensionRange& range = facts.design.space[view.dimension];
  return {.word = step.name.word,
          .chain = step.name.chain,
          .step = step.step,
          .person = step.person,
          .point = step.point,
          .dimension = view.dimension,
          .slider = view.slider,
          .value = range.low + share * (range.high - range.low),
          .moves = 1};
}

class SharedChainsTest : public testing::Test {
 protected:
  SharedChainsTest() : example_(shared_chains), facts_(chain_facts(example_.study.experiment)) {}

  std::optional<AssignedStep> assign(SharedChains& chains, int session, const std::string& trial,
                                     std::int64_t now = 0) {
    return chains.assign(session, trial, now, reason_);
  }

  ChainExample example_;
  ChainFacts facts_;
  NoStep reason_ = NoStep::busy;
};

TEST_F(SharedChainsTest, GiveNoPlaceToTwoPeople) {
  SharedChains chains(facts_);
  std::set<std::tuple<std::string, int, int>> places;
  // 2 words × 2 chains × 3 people.
  for (int session = 0; session < 12; ++session) {
    const auto step = assign(chains, session, "trial-2");
    ASSERT_TRUE(step) << session;
    EXPECT_EQ(step->step, 0);
    EXPECT_TRUE(places.emplace(step->name.key(), step->step, step->person).second);
  }
  EXPECT_FALSE(assign(chains, 12, "trial-2"));
  EXPECT_EQ(reason_, NoStep::busy);
}

TEST_F(SharedChainsTest, GiveTheSameStepAgainUntilItsTimeIsOver) {
  SharedChains chains(facts_);
  const auto first = assign(chains, 0, "trial-2", 100);
  const auto again = assign(chains, 0, "trial-2", 279);
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->name, again->name);
  EXPECT_EQ(first->person, again->person);
  for (int session = 1; session < 12; ++session) assign(chains, session, "trial-2", 279);
  EXPECT_FALSE(assign(chains, 12, "trial-2", 279));
  // After 180 s the first one's place is open.
  const auto later = assign(chains, 12, "trial-2", 280);
  ASSERT_TRUE(later);
  EXPECT_EQ(std::tuple(later->name, later->person), std::tuple(first->name, first->person));
  EXPECT_FALSE(chains.is_open(0, answer_to(facts_, *first, 0.5), 281));
  EXPECT_TRUE(chains.is_open(12, answer_to(facts_, *later, 0.5), 281));
}

TEST_F(SharedChainsTest, TakeAStepOnlyOnceAndOnlyAtThePresentPoint) {
  SharedChains chains(facts_);
  const auto step = assign(chains, 0, "trial-2");
  const ChainRecord answer = answer_to(facts_, *step, 0.25);
  ASSERT_TRUE(chains.is_open(0, answer, 0));
  chains.add(0, answer);
  EXPECT_FALSE(chains.is_open(0, answer, 0));
  EXPECT_FALSE(chains.is_open(1, answer, 0));
  ChainRecord elsewhere = answer;
  elsewhere.person = 1;
  EXPECT_FALSE(chains.is_open(0, elsewhere, 0)) << "the same participant twice in a step";
  EXPECT_TRUE(chains.is_open(1, elsewhere, 0));
  elsewhere.point[0] += 1e-6;
  EXPECT_FALSE(chains.is_open(1, elsewhere, 0));
  elsewhere = answer;
  elsewhere.step = 1;
  EXPECT_FALSE(chains.is_open(1, elsewhere, 0));
}

TEST_F(SharedChainsTest, GoOnFromTheMedianOfThePeopleOfAStep) {
  SharedChains chains(facts_);
  std::map<std::string, std::vector<double>> values;
  std::map<std::string, std::size_t> dimension;
  for (int session = 0; session < 12; ++session) {
    const auto step = assign(chains, session, "trial-2");
    const ChainRecord answer = answer_to(facts_, *step, 0.05 * session);
    values[step->name.key()].push_back(answer.value);
    dimension[step->name.key()] = answer.dimension;
    chains.add(session, answer);
  }
  EXPECT_EQ(chains.complete_steps(), 4);
  for (int session = 0; session < 4; ++session) {
    const auto step = assign(chains, session, "trial-3");
    ASSERT_TRUE(step);
    EXPECT_EQ(step->step, 1);
    std::vector<double>& of = values.at(step->name.key());
    std::ranges::sort(of);
    EXPECT_EQ(step->point[dimension.at(step->name.key())], of[1]);
  }
}

/// The answers of many participants who come and go.
TEST_F(SharedChainsTest, FollowFromTheirAnswersInAnyOrderWithinAStep) {
  SharedChains chains(facts_);
  std::vector<std::pair<int, ChainRecord>> given;
  for (int turn = 0; !chains.is_finished() && turn < 1000; ++turn) {
    const int session = (7 * turn) % 11;
    const auto step = assign(chains, session, "trial-" + std::to_string(turn), turn);
    if (!step) continue;
    const ChainRecord answer = answer_to(facts_, *step, 0.01 * (turn % 100));
    ASSERT_TRUE(chains.is_open(session, answer, turn));
    chains.add(session, answer);
    given.emplace_back(session, answer);
  }
  ASSERT_TRUE(chains.is_finished());
  ASSERT_EQ(given.size(), 72u);
  EXPECT_FALSE(assign(chains, 99, "trial-1"));
  EXPECT_EQ(reason_, NoStep::finished);
  // Each step has answers of different participants.
  std::map<std::tuple<std::string, int, int>, std::set<int>> who;
  for (const auto& [session, answer] : given)
    EXPECT_TRUE((who[{answer.word, answer.chain, answer.step}].insert(session).second));
  // A server that starts again has the same chains.
  for (std::size_t until : {5u, 40u, 72u}) {
    SharedChains first(facts_), second(facts_);
    for (std::size_t i = 0; i < until; ++i) first.add(given[i].first, given[i].second);
    std::vector<std::pair<int, ChainRecord>> shuffled(given.begin(),
                                                      given.begin() + static_cast<long>(until));
    std::ranges::stable_sort(shuffled, {}, [](const auto& one) {
      return std::tuple(one.second.word, one.second.chain, one.second.step, -one.second.person);
    });
    for (const auto& [session, answer] : shuffled) second.add(session, answer);
    for (int session = 20; session < 35; ++session) {
      const auto a = assign(first, session, "trial-x"), b = assign(second, session, "trial-x");
      ASSERT_EQ(a.has_value(), b.has_value());
      if (a) {
        EXPECT_EQ(a->name, b->name);
        EXPECT_EQ(a->point, b->point);
      }
    }
  }
}

TEST(SharedChainsUntil, EndTheChainsOfAWordThatAgreeAndNoOthers) {
  const ChainExample example(chains_until);
  const ChainFacts facts = chain_facts(example.study.experiment);
  ASSERT_TRUE(facts.design.until);
  SharedChains chains(facts);
  std::vector<std::pair<int, ChainRecord>> given;
  NoStep reason = NoStep::busy;
  int number = 0;
  std::map<std::string, int> last;
  while (number < 2000) {
    const int session = number % 30;
    const auto step = chains.assign(session, std::to_string(number), 0, reason);
    if (!step) break;
    // Sliders of "sad" chains agree; those of "happy" stay apart by chain.
    const double share =
        step->name.word == "sad" ? 0.3 + 0.01 * ((number * 7) % 10) : 0.2 * step->name.chain;
    const ChainRecord record = answer_to(facts, *step, share + 0.001 * (number % 5));
    EXPECT_TRUE(chains.is_open(session, record, 0));
    chains.add(session, record);
    given.emplace_back(session, record);
    last[step->name.key()] = step->step + 1;
    ++number;
  }
  EXPECT_EQ(reason, NoStep::finished);
  EXPECT_TRUE(chains.is_finished());
  int sad = 0;
  for (const auto& [key, steps] : last) {
    if (key.starts_with("happy")) {
      EXPECT_EQ(steps, 80) << key;
    } else {
      EXPECT_GE(steps, 12) << key;
      EXPECT_LT(steps, 30) << key;
      sad += steps;
    }
  }
  EXPECT_EQ(chains.complete_steps(), 320 + sad);
  EXPECT_EQ(chains.all_steps(), 320 + sad);
  // Followed again, chain by chain, they have ended as well, and take nothing more.
  SharedChains again(facts);
  std::ranges::stable_sort(given, {}, [](const auto& one) {
    return std::tuple(one.second.word, one.second.chain, one.second.step);
  });
  for (const auto& [session, record] : given) again.add(session, record);
  EXPECT_TRUE(again.is_finished());
  // It would be the next step, at the point that the answers lead to.
  const ChainRecord* end = nullptr;
  for (const auto& [session, record] : given)
    if (record.word == "sad" && record.chain == 1) end = &record;
  ASSERT_NE(end, nullptr);
  AssignedStep next{{"sad", 1, ""}, end->step + 1, 0, end->point};
  next.point[end->dimension] = end->value;
  EXPECT_FALSE(again.is_open(1, answer_to(facts, next, 0.4), 0));
}

TEST_F(SharedChainsTest, ForgetAnswersToOpenStepsAlone) {
  SharedChains chains(facts_);
  // Session 0 answers the first step of a chain with two others, and the second one alone.
  const auto first = assign(chains, 0, "trial-2");
  chains.add(0, answer_to(facts_, *first, 0.9));
  int others = 0;
  for (int session = 1; session < 20 && others < 2; ++session) {
    const auto step = assign(chains, session, "trial-2");
    if (step && step->name == first->name) {
      chains.add(session, answer_to(facts_, *step, 0.9));
      ++others;
    }
  }
  const auto second = [&] {
    for (int trial = 3; trial < 30; ++trial) {
      const auto step = assign(chains, 0, "trial-" + std::to_string(trial));
      if (step && step->name == first->name) return step;
    }
    return std::optional<AssignedStep>();
  }();
  ASSERT_TRUE(second);
  ASSERT_EQ(second->step, 1);
  chains.add(0, answer_to(facts_, *second, 0.1));
  const std::vector<double> point = second->point;
  ASSERT_EQ(chains.open_answers(0).size(), 1u);
  EXPECT_EQ(chains.open_answers(0)[0].step, 1);
  chains.forget_open(0);
  EXPECT_TRUE(chains.open_answers(0).empty());
  // The step is open again for three people, at the point that the first answers led to.
  std::set<int> persons;
  for (int session = 30; session < 90; ++session) {
    const auto step = assign(chains, session, "trial-2");
    if (!step || step->name != first->name) continue;
    EXPECT_EQ(step->point, point);
    persons.insert(step->person);
  }
  EXPECT_EQ(persons, (std::set<int>{0, 1, 2}));
}

TEST_F(SharedChainsTest, ForgetWhichStepsWereGiven) {
  SharedChains chains(facts_);
  ASSERT_TRUE(assign(chains, 0, "trial-2"));
  ASSERT_TRUE(assign(chains, 0, "trial-3"));
  chains.forget_open(0);
  for (int session = 1; session <= 12; ++session)
    EXPECT_TRUE(assign(chains, session, "trial-2")) << session;
}

/// A served experiment, asked without a network.
class ChainService : public testing::Test {
 protected:
  explicit ChainService(const char* adaptive = shared_chains)
      : example_(adaptive), facts_(chain_facts(example_.study.experiment)) {
    make_folder(folder_.path() / "pages");
    write_file(folder_.path() / "pages/index.html",
               "<meta name=\"mien-mode\" content=\"static\"><p>a page</p>");
    study_ = served_chains(std::move(example_.study), folder_.path() / "pages");
    start();
  }

  void start() {
    service_.reset();
    store_.reset();
    store_.emplace(folder_.path() / "answers.db");
    service_.emplace(study_, *store_, ServiceRates{}, [this] { return now_; });
  }

  HttpResponse ask(const std::string& method, const std::string& target, const json& body = {}) {
    return service_->answer({.method = method,
                             .path = plain_path(target).value(),
                             .headers = {{"content-type", "application/json"}, {"host", "here:80"}},
                             .body = body.is_null() ? "" : body.dump(),
                             .address = "127.0.0.1"});
  }
  std::string of(int session) {
    return "/s/" + service_->sessions().state(session).session.link + "/";
  }
  HttpResponse give(int session, json record) {
    record["session"] = browser_of(session);
    record["comment"] = "";
    record["started_at"] = "2026-01-31T09:00:00.000Z";
    return ask("POST", of(session) + "records/" + record.at("record").get<std::string>(), record);
  }
  static std::string browser_of(int session) { return "browser-" + std::to_string(session); }

  void begin(int session) {
    ASSERT_EQ(give(session, {{"record", "consent"},
                             {"responses", {{{"item", "consent"}, {"value_raw", "agreed"}}}}})
                  .status,
              200);
    // One practice trial.
    const json own = json::parse(ask("GET", of(session) + "session.json").body);
    const json& session_json = own.at("sessions").at(0);
    const json& trial = session_json.at("trials").at(0);
    ASSERT_TRUE(trial.at("practice").get<bool>());
    json chain = {{"word", trial.at("word")},
                  {"chain", trial.at("chain")},
                  {"step", trial.at("step")},
                  {"person", 0},
                  {"point", session_json.at("starts").at("practice/1")},
                  {"dimension", trial.at("dimension")},
                  {"start", trial.at("slider").at("start")},
                  {"reversed", trial.at("slider").at("reversed")},
                  {"value", session_json.at("starts").at("practice/1").at(0)},
                  {"moves", 1},
                  {"attempt", 1}};
    const json& dimension =
        own.at("chains").at("dimensions").at(trial.at("dimension").get<std::size_t>());
    chain["value"] = dimension.at("low");
    const HttpResponse response =
        give(session, {{"record", "trial-1"}, {"responses", json::array()}, {"chain", chain}});
    ASSERT_EQ(response.status, 200) << response.body;
  }

  HttpResponse step(int session, int trial) {
    return ask("POST", of(session) + "step/trial-" + std::to_string(trial),
               {{"session", browser_of(session)}});
  }

  static json chain_of(json step, const json& dimensions, double share) {
    const json& range = dimensions.at(step.at("dimension").get<std::size_t>());
    const double low = range.at("low"), high = range.at("high");
    step["start"] = step["slider"]["start"];
    step["reversed"] = step["slider"]["reversed"];
    step.erase("slider");
    step["value"] = low + share * (high - low);
    step["moves"] = 3;
    step["attempt"] = 1;
    return step;
  }
  HttpResponse answer(int session, int trial, const json& step, double share) {
    return give(
        session,
        {{"record", "trial-" + std::to_string(trial)},
         {"responses", json::array()},
         {"trial_ms", 9000},
         {"chain", chain_of(step, study_.experiment.at("chains").at("dimensions"), share)}});
  }

  ChainExample example_;
  ChainFacts facts_;
  test::TemporaryFolder folder_;
  ServedStudy study_;
  std::int64_t now_ = 1'800'000'000;
  std::optional<SessionStore> store_;
  std::optional<QuestionnaireService> service_;
};

TEST_F(ChainService, LeadsChainsFromOneParticipantToTheNext) {
  std::map<int, int> trials;
  for (int session = 0; session < 6; ++session) {
    begin(session);
    trials[session] = 2;
  }
  int answers = 0;
  for (int turn = 0; turn < 200 && answers < 72; ++turn) {
    const int session = turn % 6;
    if (turn % 10 == 9) start();  // the server is killed and started again
    const HttpResponse given = step(session, trials[session]);
    if (given.status != 200) continue;
    const HttpResponse kept =
        answer(session, trials[session], json::parse(given.body), 0.01 * (turn % 90));
    ASSERT_EQ(kept.status, 200) << kept.body;
    ++trials[session];
    ++answers;
  }
  EXPECT_EQ(answers, 72);
  EXPECT_EQ(service_->sessions().step_progress(), std::pair(24, 24));
  // The rest of the trials have no step, and then comes the ending.
  EXPECT_EQ(step(0, trials[0]).status, 409);
  EXPECT_EQ(json::parse(step(0, trials[0]).body).at("error"), "finished");
  for (int trial = trials[0]; trial <= 41; ++trial)
    ASSERT_EQ(give(0, {{"record", "trial-" + std::to_string(trial)}, {"responses", json::array()}})
                  .status,
              200);
  EXPECT_EQ(give(0, {{"record", "ending"}, {"responses", json::array()}}).status, 200);
  EXPECT_TRUE(service_->sessions().state(0).has_finished());

  // Its table is read again, and its chains are those that the server followed.
  write_file(folder_.path() / "steps.csv", steps_csv(study_, service_->sessions()));
  const ChainExample again(shared_chains);
  const ChainAnswers read = read_chain_answers({folder_.path() / "steps.csv"}, again.study);
  EXPECT_EQ(read.answers.size(), 72u);
  const std::vector<ChainPath> paths = chain_paths(again.study, true, read);
  ASSERT_EQ(paths.size(), 4u);
  for (const ChainPath& path : paths) EXPECT_TRUE(path.is_complete);
}

TEST_F(ChainService, KeepsChainsWhenAParticipantWithdraws) {
  begin(0);
  begin(1);
  const json first = json::parse(step(0, 2).body);
  ASSERT_EQ(answer(0, 2, first, 0.7).status, 200);
  const std::string before = steps_csv(study_, service_->sessions());
  ASSERT_EQ(ask("POST", of(0) + "withdrawal", {{"session", browser_of(0)}}).status, 200);
  const std::string after = steps_csv(study_, service_->sessions());
  EXPECT_NE(before.find("p001"), std::string::npos);
  EXPECT_EQ(after.find("p001"), std::string::npos);
  EXPECT_EQ(after.find("browser-0"), std::string::npos);
  EXPECT_NE(after.find(first.at("word").get<std::string>()), std::string::npos);
  start();
  // Its place in the step is not open to others.
  ChainFacts facts = facts_;
  std::set<std::tuple<std::string, int, int>> places;
  for (int session : {1}) {
    const json next = json::parse(step(session, 2).body);
    places.emplace(next.at("word"), next.at("chain"), next.at("person"));
  }
  EXPECT_FALSE(
      places.contains(std::tuple{first.at("word").get<std::string>(), first.at("chain").get<int>(),
                                 first.at("person").get<int>()}));
}

TEST_F(ChainService, RefusesAnAnswerThatSomebodyElseHasGivenMeanwhile) {
  begin(0);
  begin(1);
  const json slow = json::parse(step(0, 2).body);
  now_ += 200;
  // Every place that is open is given to others, the first one's too.
  for (int session = 1; session < 6; ++session) {
    if (session > 1) begin(session);
    for (int trial = 2; trial < 6; ++trial) {
      const HttpResponse given = step(session, trial);
      if (given.status == 200) {
        ASSERT_EQ(answer(session, trial, json::parse(given.body), 0.5).status, 200);
      }
    }
  }
  const HttpResponse late = answer(0, 2, slow, 0.1);
  EXPECT_EQ(late.status, 409);
  EXPECT_EQ(json::parse(late.body).at("error"), "taken");
  const json other = json::parse(step(0, 2).body);
  EXPECT_EQ(answer(0, 2, other, 0.1).status, 200);
  // Sent again, it is the same answer.
  EXPECT_EQ(answer(0, 2, other, 0.1).status, 200);
  EXPECT_EQ(answer(0, 2, other, 0.2).status, 409);
}

TEST_F(ChainService, RefusesRecordsThatCannotBe) {
  begin(0);
  const json given = json::parse(step(0, 2).body);
  const json& dimensions = study_.experiment.at("chains").at("dimensions");
  const auto refused = [&](const std::function<void(json&)>& change) {
    json chain = chain_of(given, dimensions, 0.4);
    change(chain);
    return give(0, {{"record", "trial-2"}, {"responses", json::array()}, {"chain", chain}}).status;
  };
  EXPECT_EQ(refused([](json& c) { c["value"] = 1.0; }), 400);
  EXPECT_EQ(refused([](json& c) { c["value"] = "0.5"; }), 400);
  EXPECT_EQ(refused([](json& c) { c["word"] = "glad"; }), 400);
  EXPECT_EQ(refused([](json& c) { c["chain"] = 3; }), 400);
  EXPECT_EQ(refused([](json& c) { c["step"] = 6; }), 400);
  EXPECT_EQ(refused([](json& c) { c["person"] = 3; }), 400);
  EXPECT_EQ(refused([](json& c) { c["dimension"] = 1 - c["dimension"].get<int>(); }), 400);
  EXPECT_EQ(refused([](json& c) { c["start"] = 0.123456; }), 400);
  EXPECT_EQ(refused([](json& c) { c["reversed"] = !c["reversed"].get<bool>(); }), 400);
  EXPECT_EQ(refused([](json& c) { c["point"].push_back(0.5); }), 400);
  EXPECT_EQ(refused([](json& c) { c["point"][0] = 7; }), 400);
  EXPECT_EQ(refused([](json& c) { c["attempt"] = 0; }), 400);
  EXPECT_EQ(refused([](json& c) { c["more"] = 1; }), 400);
  EXPECT_EQ(refused([](json& c) { c.erase("moves"); }), 400);
  EXPECT_EQ(refused([](json& c) { c["point"][0] = c["point"][0].get<double>() + 1e-4; }), 409);
  // No step is left out while there are some.
  EXPECT_EQ(give(0, {{"record", "trial-2"}, {"responses", json::array()}}).status, 409);
  EXPECT_EQ(refused([](json&) {}), 200);
  // Practice and unknown trials have no step of the server.
  EXPECT_EQ(step(0, 1).status, 404);
  EXPECT_EQ(step(0, 99).status, 404);
  EXPECT_EQ(ask("GET", of(0) + "step/trial-3").status, 405);
  EXPECT_EQ(ask("POST", of(0) + "step/trial-3", {{"session", "another"}}).status, 409);
  EXPECT_EQ(ask("POST", of(0) + "step/trial-3", json::array()).status, 400);
}

constexpr char shared_recipes[] =
    "{participants: 4, method: gibbs, words: [sad], space: {recipe: {of: normal, posture: "
    "{head-flexion: [-10, 30]}, tempo: [0.7, 1.4]}}, across_participants: true, practice: 1}";

class RecipeChainService : public ChainService {
 protected:
  RecipeChainService() : ChainService(shared_recipes) {}
};

/// Degrees and factors are beyond 0 to 1.
TEST_F(RecipeChainService, TakesValuesInTheUnitsOfItsDimensions) {
  begin(0);
  begin(1);
  std::set<double> given;
  for (int turn = 0; turn < 4; ++turn) {
    const int session = turn % 2, trial = 2 + turn / 2;
    const json next = json::parse(step(session, trial).body);
    const json& range =
        study_.experiment.at("chains").at("dimensions").at(next.at("dimension").get<std::size_t>());
    const double share = turn < 2 ? 0.0 : 1.0;
    const HttpResponse kept = answer(session, trial, next, share);
    ASSERT_EQ(kept.status, 200) << kept.body;
    given.insert(range.at(share > 0.0 ? "high" : "low").get<double>());
  }
  EXPECT_EQ(given, (std::set<double>{-10.0, 0.7, 1.4, 30.0}));
  write_file(folder_.path() / "steps.csv", steps_csv(study_, service_->sessions()));
  const ChainExample again(shared_recipes);
  const ChainAnswers read = read_chain_answers({folder_.path() / "steps.csv"}, again.study);
  EXPECT_EQ(read.answers.size(), 4u);
  chain_paths(again.study, true, read);
}

constexpr char checked_shared[] =
    "{participants: 6, method: gibbs, words: [sad, happy], space: {groups: [quickness, "
    "largeness]}, chains: 2, iterations: 3, across_participants: true, people_per_step: 3, "
    "trials_per_participant: 40, practice: 1, attention: {every: 2, max_failed_checks: 1}}";

class CheckedChainService : public ChainService {
 protected:
  CheckedChainService() : ChainService(checked_shared) {}

  /// The answer to a check, and whether it is what the check asks for.
  HttpResponse give_check(int session, int trial, bool passes) {
    const json own = json::parse(ask("GET", of(session) + "session.json").body).at("sessions")[0];
    const json& planned = own.at("trials").at(static_cast<std::size_t>(trial) - 1);
    const json& range =
        study_.experiment.at("chains").at("dimensions").at(planned.at("dimension").get<int>());
    const bool is_left = (planned.at("expected") == "left") == passes;
    const bool is_low = is_left != planned.at("slider").at("reversed").get<bool>();
    return give(session, {{"record", "trial-" + std::to_string(trial)},
                          {"responses", json::array()},
                          {"chain",
                           {{"word", "check"},
                            {"chain", 1},
                            {"step", planned.at("step")},
                            {"person", 0},
                            {"point", own.at("starts").at("check/1")},
                            {"dimension", planned.at("dimension")},
                            {"start", planned.at("slider").at("start")},
                            {"reversed", planned.at("slider").at("reversed")},
                            {"value", is_low ? range.at("low") : range.at("high")},
                            {"moves", 1},
                            {"attempt", 1}}}});
  }

  bool is_check(int trial) const {
    return study_.plans[0].trials.at(static_cast<std::size_t>(trial) - 1).is_attention_check();
  }
};

TEST_F(CheckedChainService, ReplacesParticipantsWhoFailChecks) {
  // Trials 2 and 3, 5 and 6 and so on are steps; 4, 7 and so on are checks.
  ASSERT_TRUE(is_check(4) && is_check(7) && !is_check(5) && !is_check(6));
  for (const int session : {0, 1, 2}) begin(session);
  const auto answered = [&](int session, int trial) {
    const HttpResponse given = step(session, trial);
    ASSERT_EQ(given.status, 200) << session << " " << trial << given.body;
    ASSERT_EQ(answer(session, trial, json::parse(given.body), 0.5).status, 200);
  };
  for (const int trial : {2, 3}) answered(0, trial);
  EXPECT_FALSE(json::parse(give_check(0, 4, false).body).contains("ended"));
  EXPECT_EQ(service_->sessions().state(0).failed_checks, 1);
  // The others answer four steps and two.
  for (const int trial : {2, 3}) answered(2, trial);
  for (const int trial : {2, 3}) answered(1, trial);
  EXPECT_EQ(give_check(1, 4, true).status, 200);
  for (const int trial : {5, 6}) answered(1, trial);
  for (const int trial : {5, 6}) answered(0, trial);
  const std::size_t before = store_->steps().size();
  EXPECT_EQ(before, 10u);
  const int complete = service_->sessions().step_progress().first;
  const HttpResponse failed = give_check(0, 7, false);
  EXPECT_EQ(json::parse(failed.body).at("ended"), "failed_attention");
  EXPECT_EQ(service_->sessions().state(0).ended, SessionEnd::failed_attention);
  EXPECT_EQ(service_->sessions().step_progress().first, complete);
  // The others go on as they would after a restart.
  for (const int session : {3, 4}) {
    begin(session);
    for (const int trial : {2, 3}) answered(session, trial);
  }
  const std::pair<int, int> progress = service_->sessions().step_progress();
  const std::size_t by_others = 4;
  start();
  EXPECT_EQ(service_->sessions().step_progress(), progress);
  // What it answered of complete steps is there, and nothing else, also after a restart.
  for (int round = 0; round < 2; ++round) {
    std::map<std::pair<std::string, int>, std::vector<int>> people;
    for (const StoredStep& one : store_->steps())
      people[{one.chain, one.step}].push_back(one.session.value_or(-1));
    int own = 0;
    for (const auto& [place, sessions] : people) {
      const auto count = std::ranges::count(sessions, 0);
      own += static_cast<int>(count);
      if (sessions.size() < 3) {
        EXPECT_EQ(count, 0) << place.first;
      }
    }
    EXPECT_GE(own, 2);
    EXPECT_LT(own, 4);
    EXPECT_EQ(store_->steps().size(), before + by_others - static_cast<std::size_t>(4 - own));
    // The table is what the chains followed from.
    write_file(folder_.path() / "steps.csv", steps_csv(study_, service_->sessions()));
    const ChainExample again(checked_shared);
    const ChainAnswers read = read_chain_answers({folder_.path() / "steps.csv"}, again.study);
    EXPECT_EQ(read.answers.size(), store_->steps().size());
    EXPECT_EQ(read.failed_checks.at("p001"), 2);
    chain_paths(again.study, true, read);
    // Others may take the steps that are open again.
    start();
    EXPECT_EQ(service_->sessions().state(0).ended, SessionEnd::failed_attention);
  }
  EXPECT_EQ(step(0, 8).status, 404);
  begin(5);
  answered(5, 2);
}

TEST_F(CheckedChainService, DoesNotLetChecksBeLeftOut) {
  begin(0);
  int trial = 2;
  for (; !is_check(trial); ++trial) {
    const HttpResponse given = step(0, trial);
    ASSERT_EQ(given.status, 200);
    ASSERT_EQ(answer(0, trial, json::parse(given.body), 0.5).status, 200);
  }
  EXPECT_EQ(step(0, trial).status, 404);
  EXPECT_EQ(
      give(0, {{"record", "trial-" + std::to_string(trial)}, {"responses", json::array()}}).status,
      409);
  EXPECT_EQ(give_check(0, trial, true).status, 200);
  EXPECT_EQ(service_->sessions().state(0).failed_checks, 0);
}

}  // namespace
}  // namespace mien::pipeline
