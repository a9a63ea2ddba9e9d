#include "pipeline/study/results/detection_results.h"

#include <cmath>
#include <set>
#include <utility>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

Sensitivity sensitivity_of(const TrialForm& form, const DetectionCounts& counts) {
  if (&form == &same_different_form) return same_different_sensitivity(counts);
  if (&form == &two_interval_form) return two_interval_sensitivity(counts);
  return yes_no_sensitivity(counts);
}

class DetectionCounter {
 public:
  explicit DetectionCounter(const AnswerSet& answer_set) : answer_set_(answer_set) {}

  /// The result of the answers for which `is_counted` holds.
  DetectionResult result(auto is_counted) const {
    DetectionResult result;
    DetectionCounts& counts = result.counts;
    for (const AnalysedDetection& one : answer_set_.detections) {
      if (!is_counted(one)) continue;
      (one.is_signal ? counts.signal_trials : counts.noise_trials) += 1;
      (one.is_signal ? counts.hits : counts.false_alarms) += one.is_positive ? 1 : 0;
    }
    result.sensitivity = sensitivity_of(*answer_set_.form, counts);
    return result;
  }

  DetectionResult of_person(std::size_t person) const {
    DetectionResult own = result([=](const auto& one) { return one.person == person; });
    own.person = person;
    return own;
  }

  /// The result of a pair or, without `other`, of a stimulus with the signal.
  DetectionResult of_subject(std::size_t stimulus, std::optional<std::size_t> other) const {
    const bool is_same_different = answer_set_.form == &same_different_form;
    DetectionResult own = result([&](const AnalysedDetection& one) {
      if (!other) return one.is_signal ? one.stimulus == stimulus : true;
      if (is_same_different && !one.is_signal)
        return one.stimulus == stimulus || one.stimulus == *other;
      return one.stimulus == stimulus && one.other == other;
    });
    own.stimulus = stimulus;
    own.other = other;
    return own;
  }

 private:
  const AnswerSet& answer_set_;
};

}  // namespace

double DetectionResult::correct() const {
  if (counts.signal_trials == 0 || counts.noise_trials == 0)
    return std::numeric_limits<double>::quiet_NaN();
  return 0.5 + 0.5 * (1.0 * counts.hits / counts.signal_trials -
                      1.0 * counts.false_alarms / counts.noise_trials);
}

DetectionResults detection_results(const AnswerSet& answer_set) {
  DetectionResults results;
  if (answer_set.detections.empty()) return results;
  const DetectionCounter counter(answer_set);
  results.rows.push_back(counter.result([](const auto&) { return true; }));
  std::set<std::size_t> people;
  std::set<std::pair<std::size_t, std::optional<std::size_t>>> subjects;
  const bool has_noise_pairs = answer_set.form == &two_interval_form;
  for (const AnalysedDetection& one : answer_set.detections) {
    people.insert(one.person);
    if (one.is_signal || has_noise_pairs) subjects.insert({one.stimulus, one.other});
  }
  std::vector<double> sensitivities;
  for (const std::size_t person : people) {
    results.rows.push_back(counter.of_person(person));
    const double d = results.rows.back().sensitivity.d;
    if (std::isfinite(d)) sensitivities.push_back(d);
  }
  results.people = static_cast<int>(sensitivities.size());
  if (results.people > 1) {
    const TTest test = paired_t_test(sensitivities);
    results.mean_d = test.mean;
    results.mean_ends = {test.low(0.95), test.high(0.95)};
  }
  for (const auto& [stimulus, other] : subjects)
    results.rows.push_back(counter.of_subject(stimulus, other));
  return results;
}

}  // namespace mien::pipeline
