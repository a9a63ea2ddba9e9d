#include "pipeline/study/results/threshold_results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/thresholds/threshold_posterior.h"

namespace mien::pipeline {

namespace {

constexpr double undetermined = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t threshold_seed = 1;  ///< of all answers; others follow

class ThresholdEstimator {
 public:
  explicit ThresholdEstimator(const AnswerSet& answer_set)
      : answer_set_(answer_set),
        design_(*answer_set.thresholds),
        model_(threshold_model(*answer_set.form)),
        levels_(design_.procedure) {
    for (const AnalysedLevel& one : answer_set.levels)
      if (one.track > 0) by_track_[{one.person, one.track}].push_back(&one);
  }

  ThresholdResults results() {
    ThresholdResults results;
    for (const auto& [of, answers] : by_track_)
      results.tracks.push_back(track_of(of.first, of.second, answers));
    std::set<std::size_t> people;
    for (const AnalysedLevel& one : answer_set_.levels)
      if (one.is_counted) people.insert(one.person);
    if (people.empty()) return results;
    results.estimates.push_back(estimate(std::nullopt, results.tracks));
    for (const std::size_t person : people)
      results.estimates.push_back(estimate(person, results.tracks));
    results.groups.push_back(group_of("fit", &ThresholdEstimate::threshold, results.estimates));
    results.groups.push_back(
        design_.procedure.method == AdaptiveMethod::quest
            ? group_of("quest", &ThresholdEstimate::quest_mean, results.estimates)
            : group_of("reversals", &ThresholdEstimate::reversal_mean, results.estimates));
    return results;
  }

 private:
  double ease_of(double level) const { return design_.sign * level; }

  /// An interval of ease as one of levels.
  IntervalEnds of_levels(IntervalEnds ends) const {
    if (design_.sign > 0.0) return ends;
    return {-ends.high, -ends.low};
  }

  std::vector<LevelCount> counts_of(std::optional<std::size_t> person) const {
    std::map<double, LevelCount> counts;  // by ease
    for (const AnalysedLevel& one : answer_set_.levels) {
      if (!one.is_counted || (person && one.person != *person)) continue;
      LevelCount& count = counts[ease_of(one.level)];
      count.level = one.level;
      ++count.trials;
      count.positive += one.is_positive ? 1 : 0;
    }
    std::vector<LevelCount> all;
    for (const auto& [ease, count] : counts) all.push_back(count);
    return all;
  }

  /// Of a step the middle of the two levels between which it is; both are equal if it is at a
  /// level.
  double threshold_in(const PsychometricFit& fit) const {
    if (fit.problem == FitProblem::step) return 0.5 * (fit.step.low + fit.step.high);
    return fit.problem == FitProblem::none ? level_at(fit.function, design_.proportion)
                                           : undetermined;
  }

  ThresholdEstimate estimate(std::optional<std::size_t> person,
                             const std::vector<TrackResult>& tracks) const {
    ThresholdEstimate estimate{.person = person, .counts = counts_of(person)};
    std::vector<LevelCount> by_ease = estimate.counts;
    for (LevelCount& count : by_ease) count.level = ease_of(count.level);
    estimate.fit = psychometric_fit(by_ease, model_);
    const double at = threshold_in(estimate.fit);
    estimate.threshold = ease_of(at);
    const bool has_slope = estimate.fit.problem == FitProblem::none && std::isfinite(at);
    estimate.slope = has_slope ? slope_at(estimate.fit.function, at) : undetermined;
    const PsychometricBootstrap bootstrap =
        psychometric_bootstrap(estimate.fit, by_ease, model_, {.proportion = design_.proportion},
                               threshold_seed + (person ? *person + 1 : 0));
    estimate.threshold_ends = of_levels(bootstrap.threshold);
    estimate.slope_ends = bootstrap.slope;
    estimate.deviance_p = bootstrap.deviance_p;
    add_posterior(estimate);
    estimate.reversal_mean = mean_of_tracks(person, tracks);
    return estimate;
  }

  /// The posterior after all answers of a participant's tracks, in the order of the trials.
  void add_posterior(ThresholdEstimate& estimate) const {
    estimate.quest_mean = undetermined;
    estimate.quest_ends = {undetermined, undetermined};
    if (!estimate.person || design_.procedure.method != AdaptiveMethod::quest) return;
    std::vector<QuestAnswer> answers;
    for (const AnalysedLevel& one : answer_set_.levels)
      if (one.is_counted && one.track > 0 && one.person == *estimate.person)
        answers.push_back({one.place, one.is_positive ? 1 : 0});
    const QuestPlus& quest = levels_.quest();
    const ThresholdPosterior found =
        threshold_posterior(quest, posterior_after(quest, answers), design_.proportion);
    // Beyond the levels nothing is known: the prior distribution ends there, and the posterior one
    // becomes narrow at the end.
    const auto [least, most] = std::ranges::minmax(quest.stimuli);
    if (found.low > least && found.high < most) estimate.quest_mean = ease_of(found.mean);
    estimate.quest_ends = of_levels({found.low, found.high});
  }

  static double mean_of_tracks(std::optional<std::size_t> person,
                               const std::vector<TrackResult>& tracks) {
    double sum = 0.0;
    int count = 0;
    for (const TrackResult& track : tracks) {
      if (!person || track.person != *person || std::isnan(track.reversal_mean)) continue;
      sum += track.reversal_mean;
      ++count;
    }
    return count == 0 ? undetermined : sum / count;
  }

  TrackResult track_of(std::size_t person, int track,
                       const std::vector<const AnalysedLevel*>& answers) const {
    TrackResult result{.person = person, .track = track};
    std::vector<bool> positive;
    for (const AnalysedLevel* one : answers) {
      result.points.push_back({one->trial, one->level, one->is_positive});
      positive.push_back(one->is_positive);
    }
    if (design_.procedure.method != AdaptiveMethod::staircase) return result;
    StaircaseRun run = staircase_run(design_.procedure.staircase, positive);
    for (std::size_t i = 0; i < run.levels.size(); ++i) run.levels[i] = answers[i]->level;
    for (const std::size_t at : run.reversals) result.points[at].is_reversal = true;
    const StaircaseEstimate found = staircase_estimate(run, left_out_reversals);
    result.reversal_mean = found.level;
    result.reversal_deviation = found.deviation;
    result.reversals = static_cast<int>(run.reversals.size());
    return result;
  }

  static GroupThreshold group_of(const char* estimate, double ThresholdEstimate::*member,
                                 const std::vector<ThresholdEstimate>& estimates) {
    GroupThreshold group{.estimate = estimate,
                         .mean = undetermined,
                         .deviation = undetermined,
                         .ends = {undetermined, undetermined}};
    std::vector<double> thresholds;
    for (const ThresholdEstimate& one : estimates) {
      if (!one.person) continue;
      ++group.all;
      if (std::isfinite(one.*member)) thresholds.push_back(one.*member);
    }
    group.people = static_cast<int>(thresholds.size());
    if (group.people < 2) return group;
    const TTest test = paired_t_test(thresholds);
    group.mean = test.mean;
    group.deviation = test.standard_error * std::sqrt(1.0 * group.people);
    group.ends = {test.low(0.95), test.high(0.95)};
    return group;
  }

  const AnswerSet& answer_set_;
  const ThresholdDesign& design_;
  PsychometricModel model_;
  TrackLevels levels_;
  std::map<std::pair<std::size_t, int>, std::vector<const AnalysedLevel*>> by_track_;
};

}  // namespace

int ThresholdEstimate::trials() const {
  int all = 0;
  for (const LevelCount& count : counts) all += count.trials;
  return all;
}

PsychometricModel threshold_model(const TrialForm& form) {
  PsychometricModel model;
  if (&form != &two_interval_form) model.guess = {0.0, 0.5};
  return model;
}

ThresholdResults threshold_results(const AnswerSet& answer_set) {
  if (!answer_set.thresholds) return {};
  return ThresholdEstimator(answer_set).results();
}

std::string threshold_remark(const ThresholdEstimate& estimate) {
  switch (estimate.fit.problem) {
    case FitProblem::none:
      return std::isnan(estimate.threshold) ? "the function does not reach the proportion" : "";
    case FitProblem::no_trials:
      return "no answers";
    case FitProblem::all_negative:
      return "all answers are negative";
    case FitProblem::all_positive:
      return "all answers are positive";
    case FitProblem::too_few_levels:
      return "fewer levels than parameters";
    case FitProblem::not_rising:
      return "answers do not depend on the level";
    case FitProblem::step:
      return "a step at a level, or between two: the threshold is there, or in their middle";
  }
  return "";
}

}  // namespace mien::pipeline
