#include "pipeline/study/chains/chain_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "pipeline/manifest/adaptive_plan.h"
#include "pipeline/study/chains/experiment/chain_example.h"

namespace mien::pipeline {
namespace {

TEST(ChainPlan, FreesEachDimensionOnceInASweep) {
  const ChainExample example(own_chains);
  const ChainDesign& design = example.study.design;
  ASSERT_EQ(design.dimensions.size(), 4u);
  ASSERT_EQ(design.steps, 16);
  for (const ChainSession& session : example.study.sessions) {
    std::map<std::string, std::map<int, std::set<std::size_t>>> freed;
    for (std::size_t i = 0; i < session.steps.size(); ++i)
      if (!session.plan.trials[i].practice)
        freed[session.steps[i].name.word][session.steps[i].step / 4].insert(
            session.steps[i].view.dimension);
    ASSERT_EQ(freed.size(), 2u);
    for (const auto& [word, sweeps] : freed) {
      ASSERT_EQ(sweeps.size(), 4u) << word;
      for (const auto& [sweep, dimensions] : sweeps) EXPECT_EQ(dimensions.size(), 4u);
    }
  }
}

TEST(ChainPlan, StartsWithinWhatTheExamplesReach) {
  const ChainExample example(own_chains);
  const Eigen::MatrixXd& at = example.study.dimensions.at_examples;
  std::set<std::vector<double>> starts;
  for (int chain = 1; chain <= 200; ++chain) {
    const std::vector<double> start = chain_start(example.study.design, at, {"sad", chain, "p001"});
    starts.insert(start);
    for (std::size_t d = 0; d < start.size(); ++d) {
      EXPECT_GE(start[d], example.study.design.space[d].low);
      EXPECT_LE(start[d], example.study.design.space[d].high);
    }
  }
  EXPECT_GT(starts.size(), 195u);
  // A blend cannot be farther in any direction than the farthest example.
  for (const std::vector<double>& start : starts)
    for (int direction = 0; direction < 16; ++direction) {
      Eigen::RowVectorXd to(4);
      for (int d = 0; d < 4; ++d) to[d] = (direction >> d) % 2 == 0 ? 1.0 : -1.0;
      const Eigen::Map<const Eigen::VectorXd> place(start.data(), 4);
      EXPECT_LE(to.dot(place), (to * at).maxCoeff() + 0.003);
    }
}

TEST(ChainPlan, DoesNotChangeWithMoreParticipants) {
  const ChainExample few(own_chains);
  Motions motions(few.manifest);
  const ChainStudy more = chain_study(few.manifest, motions, 7);
  ASSERT_EQ(more.sessions.size(), 7u);
  for (std::size_t i = 0; i < few.study.sessions.size(); ++i) {
    EXPECT_EQ(more.sessions[i].plan, few.study.sessions[i].plan);
    EXPECT_EQ(more.sessions[i].starts, few.study.sessions[i].starts);
  }
}

TEST(ChainPlan, GivesEachWordFirstToAsManyParticipants) {
  const ChainExample example(own_chains);
  std::map<std::string, int> first;
  for (const ChainSession& session : example.study.sessions)
    ++first[std::ranges::find(session.plan.trials, false, &Trial::practice)->block];
  EXPECT_EQ(first["sad"], 2);
  EXPECT_EQ(first["happy"], 2);
}

TEST(ChainPlan, HasWeightsFeaturesAndComponents) {
  const ChainExample weights(
      "{participants: 1, method: gibbs, words: [sad], space: {weights: [sad, happy, normal]}}");
  EXPECT_EQ(weights.study.dimensions.kind, motion::InterfaceKind::weights);
  EXPECT_EQ(weights.study.design.space.front().low, 0.01);
  const ChainExample features(
      "{participants: 1, method: gibbs, words: [sad], space: {features: all}}");
  EXPECT_EQ(features.study.design.dimensions.size(), 4u);
  const ChainExample components(
      "{participants: 1, method: gibbs, words: [sad], space: {components: 3}}");
  EXPECT_EQ(components.study.design.dimensions,
            (std::vector<std::string>{"component-1", "component-2", "component-3"}));
}

TEST(ChainPlan, HasComponentsInTheOrderOfWhatTheyExplain) {
  Eigen::MatrixXd features = Eigen::MatrixXd::Random(6, 12);
  features.row(1) = features.row(0);
  features.row(2) = -features.row(0);
  const Eigen::MatrixXd scores = component_scores(features, 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(scores.row(i).minCoeff(), 0.0, 1e-12);
    EXPECT_NEAR(scores.row(i).maxCoeff(), 1.0, 1e-12);
    for (int j = i + 1; j < 3; ++j) {
      const Eigen::RowVectorXd a = scores.row(i).array() - scores.row(i).mean();
      const Eigen::RowVectorXd b = scores.row(j).array() - scores.row(j).mean();
      EXPECT_NEAR(a.dot(b), 0.0, 1e-9);
    }
  }
  // The first has what three of six features share.
  const Eigen::RowVectorXd first = scores.row(0).array() - scores.row(0).mean();
  const Eigen::RowVectorXd shared = features.row(0).array() - features.row(0).mean();
  EXPECT_GT(std::abs(first.normalized().dot(shared.normalized())), 0.9);
  // High values of a component are high values of the feature that it is most about.
  for (int i = 0; i < 3; ++i) {
    double most = 0.0;
    for (int f = 0; f < 6; ++f) {
      const Eigen::RowVectorXd score = scores.row(i).array() - scores.row(i).mean();
      const Eigen::RowVectorXd feature = features.row(f).array() - features.row(f).mean();
      const double correlation = score.normalized().dot(feature.normalized());
      if (std::abs(correlation) > std::abs(most) + 1e-9) most = correlation;
    }
    EXPECT_GT(most, 0.0) << i;
  }
  EXPECT_THROW(component_scores(features, 6), Error);
}

TEST(AdaptiveChecks, RefuseWhatCannotBe) {
  EXPECT_EQ(chain_fault(own_chains), "");
  const auto with = [](const std::string& more) {
    return chain_fault("{participants: 4, method: gibbs, words: [sad], " + more + "}");
  };
  EXPECT_NE(with("space: {groups: [quicknes]}").find("quickness"), std::string::npos);
  EXPECT_NE(with("space: {features: [step-lenght]}").find("step-length"), std::string::npos);
  EXPECT_NE(with("space: {weights: [sad]}").find("single example"), std::string::npos);
  EXPECT_NE(with("space: {groups: all, features: all}").find("several kinds: groups, features"),
            std::string::npos);
  EXPECT_NE(with("space: {}").find("no dimensions"), std::string::npos);
  EXPECT_NE(chain_fault("{participants: 10000, method: gibbs, words: [sad], space: {groups: all}, "
                        "iterations: 100}")
                .find("4000000 answers are needed"),
            std::string::npos);
  // Films are named after words.
  for (const char* word : {"[../sad]", "{../sad: sad}", "[\"\"]", "[a/b]"})
    EXPECT_NE(chain_fault("{participants: 4, method: gibbs, words: " + std::string(word) +
                          ", space: {groups: all}}"),
              "")
        << word;
  EXPECT_NE(with("space: {groups: all}, people_per_step: 2").find("across_participants"),
            std::string::npos);
  EXPECT_NE(with("space: {groups: all}, aggregate: mean").find("people_per_step"),
            std::string::npos);
  EXPECT_NE(with("space: {groups: all}, deviation: 0.2").find("no effect"), std::string::npos);
  EXPECT_NE(with("space: {groups: all}, iterations: 1000").find("4000 trials"), std::string::npos);
  EXPECT_NE(with("space: {groups: all}, across_participants: true, people_per_step: 5")
                .find("more than the number of participants"),
            std::string::npos);
  EXPECT_NE(with("space: {groups: all}, iterations: 0").find("adaptive.iterations"),
            std::string::npos);
  EXPECT_NE(chain_fault("{participants: 4, method: mcmc, words: [sad], space: {groups: all}, "
                        "across_participants: true, people_per_step: 2}")
                .find("cannot be combined"),
            std::string::npos);
  EXPECT_NE(chain_fault("{participants: 4, method: gibbs, words: [sad], space: {groups: all}}\n"
                        "questionnaire: {participants: 2, scales: all}")
                .find("a manifest has one of them"),
            std::string::npos);
  // One message for each, with its place.
  EXPECT_NE(with("space: {groups: [quicknes]}").find("words.yaml:6:"), std::string::npos);
}

TEST(ChainPlan, HasAttentionChecksBetweenItsTrials) {
  const ChainExample with(checked_chains);
  const ChainExample without(
      "{participants: 4, method: gibbs, words: [sad, happy], space: {groups: all}, iterations: 4, "
      "practice: 1}");
  std::set<std::string> sides;
  for (std::size_t s = 0; s < with.study.sessions.size(); ++s) {
    const ChainSession& session = with.study.sessions[s];
    std::vector<PlannedStep> others;
    int checks = 0, since = 0;
    for (std::size_t i = 0; i < session.steps.size(); ++i) {
      const Trial& trial = session.plan.trials[i];
      EXPECT_EQ(trial.number, static_cast<int>(i) + 1);
      if (!trial.is_attention_check()) {
        others.push_back(session.steps[i]);
        since += trial.practice ? 0 : 1;
        continue;
      }
      // Every six trials, at most one and a half earlier or later.
      EXPECT_GE(since, 4);
      EXPECT_LE(since, 8);
      since = 0;
      sides.insert(trial.expected);
      EXPECT_EQ(session.steps[i].name, (ChainName{check_word, 1, session.plan.participant}));
      EXPECT_EQ(session.steps[i].step, checks++);
      EXPECT_FALSE(trial.is_analysed());
    }
    EXPECT_EQ(checks, 5);  // 32 trials
    EXPECT_TRUE(session.starts.contains("check/1"));
    // The steps of the chains are those without checks.
    ASSERT_EQ(others.size(), without.study.sessions[s].steps.size());
    for (std::size_t i = 0; i < others.size(); ++i) {
      EXPECT_EQ(others[i].name, without.study.sessions[s].steps[i].name);
      EXPECT_EQ(others[i].view.slider.start, without.study.sessions[s].steps[i].view.slider.start);
    }
  }
  EXPECT_EQ(sides, (std::set<std::string>{"left", "right"}));
}

TEST(AdaptiveChecks, RefuseEndsAndChecksThatCannotBe) {
  const auto refused = [](const std::string& more, const std::string& wrong) {
    EXPECT_NE(chain_fault("{participants: 4, method: gibbs, space: {groups: all}, " + more + "}")
                  .find(wrong),
              std::string::npos)
        << more << ": "
        << chain_fault("{participants: 4, method: gibbs, space: {groups: all}, " + more + "}");
  };
  const std::string shared = "words: [sad], across_participants: true, ";
  EXPECT_EQ(chain_fault("{participants: 4, method: gibbs, space: {groups: all}, " + shared +
                        "chains: 2, until: {r_hat: 1.1, at_most: 20}, attention: {every: 4}}"),
            "");
  refused(shared + "until: {r_hat: 1.1, at_most: 20}", "there is one");
  refused("words: [sad], chains: 2, until: {r_hat: 1.1, at_most: 20}",
          "needs chains that a server follows");
  refused(shared + "chains: 2, iterations: 4, until: {r_hat: 1.1, at_most: 20}",
          "stated in `until` as well");
  refused(shared + "chains: 2, until: {r_hat: 1.1, at_most: 8}", "is less than at_least, 10");
  refused(shared + "chains: 2, until: {r_hat: 1, at_most: 20}", "until.r_hat");
  refused(shared + "chains: 2, until: {r_hat: 1.1}", "at_most");
  refused("words: [sad], attention: {max_failed_checks: 2}", "no effect without attention checks");
  refused("words: [sad, happy, Sad]", "Sad appears twice");
  refused("words: [check]", "check is the name of other trials");
  refused("words: [sad, practice]", "practice is the name of other trials");
}

TEST(AdaptiveChecks, RefuseExamplesThatDoNotVary) {
  ManifestReading read = chain_reading(
      "{participants: 1, method: gibbs, words: [sad], space: {weights: [sad, hapy]}}");
  ASSERT_FALSE(read.faults.empty());
  EXPECT_NE(std::string(Faults(read.faults).what()).find("happy"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
