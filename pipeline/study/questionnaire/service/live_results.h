#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// Running counts for the experimenter's page: of answers in analysed trials (without practice,
/// warm-up, checks and repetitions), and of passed and failed attention checks.
class LiveResults {
 public:
  explicit LiveResults(const QuestionnaireFacts& facts) : facts_(facts) {}

  void add(const std::vector<AnswerRow>& rows);
  void clear();

  /// Answers by item: [{"item": …, "is_pair": false, "answers": 12, "mean": 0.5 or null, "bins":
  /// [{"label": "-2", "count": 3}, …]}, …]
  nlohmann::ordered_json histograms() const;

  /// Results of attention checks: {"passed": 3, "failed": 1}
  nlohmann::ordered_json checks() const;

 private:
  struct Tally {
    int answers = 0;
    bool is_measured = false;  ///< answers are numbers, so that they have a mean
    double sum = 0.0;
    std::vector<std::string> labels;
    std::vector<int> counts;
  };

  /// The scale of a row's item; nullptr if there is none.
  const ResponseScale* scale_of(const AnswerRow& row) const;
  Tally& tally_of(const AnswerRow& row);
  static void count(Tally& tally, const std::string& label);

  const QuestionnaireFacts& facts_;
  std::map<std::pair<std::string, bool>, Tally>
      tallies_;  ///< by item and whether it compares pairs
  int passed_ = 0;
  int failed_ = 0;
};

}  // namespace mien::pipeline
