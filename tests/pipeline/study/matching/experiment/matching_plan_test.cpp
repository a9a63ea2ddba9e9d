#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {
namespace {

Manifest experiment(int targets, std::vector<std::string> interfaces, int practice) {
  Manifest manifest;
  manifest.study = "s";
  manifest.seed = 7;
  manifest.matching.emplace();
  manifest.matching->participants = 12;
  manifest.matching->interfaces = std::move(interfaces);
  for (int i = 0; i < targets; ++i) manifest.matching->targets.push_back("t" + std::to_string(i));
  for (int i = 0; i < practice; ++i) manifest.matching->practice.push_back("p" + std::to_string(i));
  return manifest;
}

const std::vector<std::string> three = {"adjectives", "features", "weights"};

TEST(MatchingPlan, HasEveryTargetOnceWithEachInterface) {
  for (const int targets : {1, 2, 5}) {
    for (const SessionPlan& plan : plan_matching(experiment(targets, three, 2))) {
      std::set<std::pair<std::string, std::string>> seen;
      int analysed = 0;
      for (const Trial& trial : plan.trials) {
        EXPECT_EQ(trial.number, &trial - plan.trials.data() + 1);
        EXPECT_EQ(trial.kind, &matching_trials);
        if (!trial.is_analysed()) continue;
        ++analysed;
        seen.emplace(trial.stimuli.front(), trial.items.front().item);
        EXPECT_EQ(trial.block, trial.items.front().item);
      }
      EXPECT_EQ(analysed, 3 * targets);
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(analysed));
    }
  }
}

TEST(MatchingPlan, PractisesEveryInterfaceAndEveryMotionFirst) {
  for (const int practice : {1, 3, 5}) {
    for (const SessionPlan& plan : plan_matching(experiment(2, three, practice))) {
      std::set<std::string> motions, interfaces;
      const auto first_of_main = std::ranges::find(plan.trials, false, &Trial::practice);
      for (auto trial = plan.trials.begin(); trial != first_of_main; ++trial) {
        motions.insert(trial->stimuli.front());
        interfaces.insert(trial->items.front().item);
      }
      EXPECT_TRUE(std::none_of(first_of_main, plan.trials.end(), std::mem_fn(&Trial::practice)));
      EXPECT_EQ(motions.size(), static_cast<std::size_t>(practice));
      EXPECT_EQ(interfaces.size(), 3u);
    }
  }
}

TEST(MatchingPlan, IsTheSameWithMoreParticipants) {
  const Manifest manifest = experiment(5, three, 3);
  const auto few = plan_matching(manifest), many = plan_matching(manifest, 40);
  ASSERT_EQ(few.size(), 12u);
  ASSERT_EQ(many.size(), 40u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(MatchingPlan, IsBalancedOnceEveryRowOfBothSquaresHasCome) {
  for (const auto& interfaces : {std::vector<std::string>{"weights"},
                                 std::vector<std::string>{"features", "weights"}, three}) {
    for (const int targets : {2, 3, 5}) {
      const auto participants =
          williams_rows(interfaces.size()) * williams_rows(static_cast<std::size_t>(targets));
      std::map<std::pair<std::string, std::size_t>, int> block_at;
      std::map<std::tuple<std::string, std::string, std::size_t>, int> target_at;
      for (const SessionPlan& plan :
           plan_matching(experiment(targets, interfaces, 0), static_cast<int>(participants))) {
        for (std::size_t i = 0; i < plan.trials.size(); ++i) {
          const std::string& interface = plan.trials[i].items.front().item;
          const auto in_block = static_cast<std::size_t>(targets);
          ++block_at[{interface, i / in_block}];
          ++target_at[{interface, plan.trials[i].stimuli.front(), i % in_block}];
        }
      }
      for (const auto& [what, times] : block_at) EXPECT_EQ(times, block_at.begin()->second);
      for (const auto& [what, times] : target_at) EXPECT_EQ(times, target_at.begin()->second);
      EXPECT_EQ(block_at.size(), interfaces.size() * interfaces.size());
      EXPECT_EQ(target_at.size(), interfaces.size() * static_cast<std::size_t>(targets * targets));
    }
  }
}

/// What comes at a place of a session, counted over participants.
template <class Key>
void expect_equally_often(const std::map<Key, int>& times, std::size_t kinds) {
  EXPECT_EQ(times.size(), kinds);
  for (const auto& [what, count] : times) EXPECT_EQ(count, times.begin()->second);
}

TEST(MatchingPlan, HasEveryInterfaceAtATargetBeforeTheNextWhereGuessesComeFirst) {
  for (const int targets : {1, 2, 3, 5}) {
    Manifest manifest = experiment(targets, three, 2);
    manifest.matching->order = MatchingOrder::guesses_first;
    const auto count = static_cast<std::size_t>(targets);
    const std::size_t participants = williams_rows(3) * williams_rows(count);
    std::map<std::pair<std::string, std::size_t>, int> target_at;
    std::map<std::tuple<std::size_t, std::string, std::size_t>, int> interface_at;
    for (const SessionPlan& plan : plan_matching(manifest, static_cast<int>(participants))) {
      ASSERT_EQ(plan.trials.size(), 3 * (2 + count));
      std::set<std::string> done;
      for (std::size_t block = 0; block < 2 + count; ++block) {
        const std::string target = plan.trials[3 * block].stimuli.front();
        EXPECT_TRUE(done.insert(target).second) << target;
        std::set<std::string> interfaces;
        for (std::size_t i = 0; i < 3; ++i) {
          const Trial& trial = plan.trials[3 * block + i];
          EXPECT_EQ(trial.number, static_cast<int>(3 * block + i) + 1);
          EXPECT_EQ(trial.stimuli.front(), target);
          EXPECT_EQ(trial.practice, block < 2);
          interfaces.insert(trial.items.front().item);
          if (block < 2) continue;
          EXPECT_EQ(trial.block, target);
          ++interface_at[{block, trial.items.front().item, i}];
        }
        EXPECT_EQ(interfaces.size(), 3u);
        if (block >= 2) ++target_at[{target, block}];
      }
    }
    expect_equally_often(target_at, count * count);
    expect_equally_often(interface_at, count * 3 * 3);
  }
}

TEST(MatchingPlan, TellsHowLongASessionTakes) {
  Manifest manifest = experiment(5, three, 3);
  const double before = plan_matching(manifest)[0].expected_seconds;
  manifest.matching->limit_s = 100.0;
  EXPECT_NEAR(before - plan_matching(manifest)[0].expected_seconds, 18 * 100.0, 1e-9);
}

}  // namespace
}  // namespace mien::pipeline
