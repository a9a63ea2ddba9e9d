// The shipped study of gestures and speech, answered by simulated people with known worths.

#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/pair_worth.h"

namespace mien::pipeline {
namespace {

Manifest gesture_study() {
  return load_manifest(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "gesture-study.yaml",
                       [](const std::string&) { return std::nullopt; });
}

/// Log-worths with a sum of zero.
const std::map<std::string, double> known_worths = {{"acted, matched", 0.9},
                                                    {"modified, matched", 0.4},
                                                    {"neutral, matched", -0.1},
                                                    {"acted, mismatched", -0.5},
                                                    {"modified, mismatched", -0.7}};
constexpr double known_order = 0.2;
constexpr double known_tie = -0.8;
// (0.9 + 0.5 + 0.4 + 0.7) / 2
constexpr double matched_against_mismatched = 1.25;

/// Draws every answer that counts by the model of Davidson and Beaver.
class KnownPeople {
 public:
  explicit KnownPeople(const Manifest& manifest)
      : rows_(simulated_sessions(manifest, plan_sessions(manifest), {})) {
    for (const Stimulus& stimulus : manifest.stimuli)
      worth_[stimulus.id] = known_worths.at(level_of(manifest, stimulus.id, "motion") + ", " +
                                            level_of(manifest, stimulus.id, "audio"));
  }

  std::vector<AnswerRow> answers(std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    std::vector<AnswerRow> rows = rows_;
    for (AnswerRow& row : rows) {
      if (!row.counts()) continue;
      const double left = worth_.at(row.stimulus) + 0.5 * known_order;
      const double right = worth_.at(row.against) - 0.5 * known_order;
      const double tie = known_tie + 0.5 * (left + right);
      const double all = std::exp(left) + std::exp(right) + std::exp(tie);
      const double drawn = static_cast<double>(random() >> 11) * 0x1p-53 * all;
      row.value_raw = drawn < std::exp(left)                     ? "left"
                      : drawn < std::exp(left) + std::exp(right) ? "right"
                                                                 : "tie";
      row.value = row.value_raw == "left"    ? row.stimulus
                  : row.value_raw == "right" ? row.against
                                             : "tie";
    }
    return rows;
  }

 private:
  std::vector<AnswerRow> rows_;
  std::map<std::string, double> worth_;
};

TEST(GestureStudy, ComparesVideosOfTheSameTakeEquallyOften) {
  const Manifest manifest = gesture_study();
  const auto pairs = questionnaire_subjects(manifest);
  EXPECT_EQ(pairs.size(), 40u);  // of four takes, those of five conditions
  for (const auto& pair : pairs)
    EXPECT_EQ(level_of(manifest, pair[0], "take"), level_of(manifest, pair[1], "take"));
  std::map<std::set<std::string>, int> shown;
  std::map<std::string, int> first;
  for (const SessionPlan& plan : plan_sessions(manifest)) {
    for (const Trial& trial : plan.trials) {
      if (trial.is_attention_check()) continue;
      ++shown[{trial.stimuli.begin(), trial.stimuli.end()}];
      ++first[trial.stimuli.front()];
    }
  }
  EXPECT_EQ(shown.size(), 40u);
  for (const auto& [pair, times] : shown) EXPECT_EQ(times, 20);
  for (const auto& [stimulus, times] : first) EXPECT_NEAR(times, 40, 12) << stimulus;
}

TEST(GestureStudy, SpeechIsMismatchedWhereItIsMeantToBe) {
  const Manifest manifest = gesture_study();
  for (const Stimulus& stimulus : manifest.stimuli)
    EXPECT_EQ(level_of(manifest, stimulus.id, "audio"),
              stimulus.id.ends_with('x') ? "mismatched" : "matched")
        << stimulus.id;
}

/// `least` and `most`: bounds of the share of intervals that hold the known value.
void expect_known_worths(int runs, double least, double most) {
  const Manifest manifest = gesture_study();
  const KnownPeople people(manifest);
  int holds = 0, holds_contrast = 0, holds_order = 0, holds_difference = 0, differences = 0;
  double sum = 0.0;
  for (int run = 0; run < runs; ++run) {
    const auto worths =
        worths_of(collect_answers(manifest, people.answers(900 + static_cast<std::uint64_t>(run))));
    const PairWorth& worth = worths.at(0);
    ASSERT_EQ(worth.stimuli.size(), 5u);
    ASSERT_TRUE(worth.is_by_participants);
    const auto hold = [](const Interval95& ends, double value) {
      return ends.low <= value && value <= ends.high ? 1 : 0;
    };
    for (const StimulusWorth& one : worth.stimuli)
      holds += hold(worth.ends_of(one), known_worths.at(one.name));
    holds_order += hold(worth.order_ends, known_order);
    holds_contrast += hold(worth.contrasts.at(0).ends, matched_against_mismatched);
    sum += worth.contrasts.at(0).difference;
    for (const WorthContrast& contrast : worth.contrasts) {
      if (contrast.kind != ContrastKind::pairwise) continue;
      double expected = 0.0;
      for (std::size_t i = 0; i < contrast.of.size(); ++i)
        expected += contrast.of[i] * known_worths.at(worth.stimuli[i].name);
      holds_difference += hold(contrast.ends, expected);
      ++differences;
    }
  }
  const auto expect_share = [&](int count, int of, const char* what) {
    const double share = static_cast<double>(count) / of;
    ::testing::Test::RecordProperty(what, std::to_string(share));
    EXPECT_GE(share, least) << what;
    EXPECT_LE(share, most) << what;
  };
  expect_share(holds, 5 * runs, "worths");
  expect_share(holds_difference, differences, "differences");
  expect_share(holds_contrast, runs, "contrast");
  expect_share(holds_order, runs, "order");
  // The mean of the estimates: the standard error of one is about 0.12.
  EXPECT_NEAR(sum / runs, matched_against_mismatched, 0.03 + 0.5 / std::sqrt(runs));
}

TEST(GestureStudy, FindsKnownWorths) { expect_known_worths(12, 0.8, 1.0); }

TEST(GestureStudy, FindsKnownWorthsIn500Runs) { expect_known_worths(500, 0.90, 0.98); }

}  // namespace
}  // namespace mien::pipeline
