#include <cmath>

#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

struct ThresholdRow {
  const AnswerSet& in;
  const ThresholdEstimate& of;

  std::string scope() const { return of.person ? "participant" : "all"; }
  std::string person() const { return of.person ? in.people[*of.person] : ""; }
};

struct ThresholdLevelRow {
  ThresholdRow estimate;
  const LevelCount& count;

  double fitted() const {
    const PsychometricFit& fit = estimate.of.fit;
    if (fit.problem != FitProblem::none) return std::nan("");
    return answer_probability(fit.function, estimate.in.thresholds->sign * count.level).positive;
  }
};

struct TrackRow {
  const AnswerSet& in;
  const TrackResult& of;
};

struct TrackPointRow {
  TrackRow track;
  const TrackPoint& point;
};

using MeanThresholdRow = ResultRow<GroupThreshold>;

constexpr SharedColumn factor_column{"factor", "", "the factor of adaptive trials",
                                     [](auto& r) { return r.in.thresholds->factor; }};

constexpr auto threshold_columns = result_table<ThresholdRow>(
    "results/thresholds.csv", "participant, and all answers together",
    {factor_column,
     {"scope", "", "all answers, or participant", [](auto& r) { return r.scope(); }},
     {"participant", "", "participant id", [](auto& r) { return r.person(); }},
     {"trials", "", "number of answers", [](auto& r) { return r.of.trials(); }},
     {"proportion", "0–1", "proportion of positive answers at the threshold",
      [](auto& r) { return r.in.thresholds->proportion; }},
     {"threshold", "level", "level at which the fitted function gives this proportion",
      [](auto& r) { return r.of.threshold; }},
     {"low", "level",
      "lower end of its 95 % interval (parametric bootstrap, answers independent; empty if it has "
      "no bound)",
      [](auto& r) { return r.of.threshold_ends.low; }},
     {"high", "level", "upper end", [](auto& r) { return r.of.threshold_ends.high; }},
     {"slope", "1/level",
      "change of the proportion per unit towards easier levels, at the "
      "threshold",
      [](auto& r) { return r.of.slope; }},
     {"slope_low", "1/level", "lower end of its 95 % interval (bootstrap)",
      [](auto& r) { return r.of.slope_ends.low; }},
     {"slope_high", "1/level", "upper end", [](auto& r) { return r.of.slope_ends.high; }},
     {"location", "level", "level at which the logistic function is one half",
      [](auto& r) { return r.in.thresholds->sign * r.of.fit.function.location; }},
     {"width", "level", "width of the logistic function: 1/(1 + exp(−(level − location)/width))",
      [](auto& r) { return r.of.fit.function.width; }},
     {"guess", "0–1", "guess rate: proportion of positive answers without the signal",
      [](auto& r) { return r.of.fit.function.guess; }},
     {"lapse", "0–1", "lapse rate: proportion of negative answers however strong the signal is",
      [](auto& r) { return r.of.fit.function.lapse; }},
     {"deviance", "", "deviance of the fit from the observed proportions",
      [](auto& r) { return r.of.fit.deviance; }},
     {"deviance_p", "",
      "probability of a deviance at least as large if the function is right (bootstrap)",
      [](auto& r) { return r.of.deviance_p; }},
     {"quest", "level", "QUEST+: mean of the posterior distribution of the threshold",
      [](auto& r) { return r.of.quest_mean; }},
     {"quest_low", "level", "lower end of its 95 % credible interval",
      [](auto& r) { return r.of.quest_ends.low; }},
     {"quest_high", "level", "upper end", [](auto& r) { return r.of.quest_ends.high; }},
     {"reversals", "level",
      "staircases: mean over the tracks of their mean levels of reversals after the first two",
      [](auto& r) { return r.of.reversal_mean; }},
     {"remark", "", "why there is no threshold, or no interval",
      [](auto& r) { return threshold_remark(r.of); }}});

constexpr auto level_columns = result_table<ThresholdLevelRow>(
    "results/threshold_levels.csv", "level of a participant, and of all answers together",
    {{"scope", "", "all answers, or participant", [](auto& r) { return r.estimate.scope(); }},
     {"participant", "", "participant id", [](auto& r) { return r.estimate.person(); }},
     {"level", "level", "level of the factor; that of stimuli without the signal is among them",
      [](auto& r) { return r.count.level; }},
     {"trials", "", "number of answers", [](auto& r) { return r.count.trials; }},
     {"positive", "", "of these, the positive ones (right, yes or different)",
      [](auto& r) { return r.count.positive; }},
     {"share", "0–1", "proportion of positive answers",
      [](auto& r) { return 1.0 * r.count.positive / r.count.trials; }},
     {"fitted", "0–1", "proportion by the fitted function", [](auto& r) { return r.fitted(); }}});

constexpr auto track_columns = result_table<TrackRow>(
    "results/tracks.csv", "track of a participant",
    {{"participant", "", "participant id", [](auto& r) { return r.in.people[r.of.person]; }},
     {"track", "", "number of the track, from 1", [](auto& r) { return r.of.track; }},
     {"trials", "", "number of answers", [](auto& r) { return r.of.points.size(); }},
     {"last_level", "level", "level of the last answer",
      [](auto& r) { return r.of.points.back().level; }},
     {"reversals", "", "staircases: number of reversals", [](auto& r) { return r.of.reversals; }},
     {"reversal_mean", "level",
      "staircases: mean level of the reversals after the first two (an even number of them)",
      [](auto& r) { return r.of.reversal_mean; }},
     {"reversal_sd", "level", "standard deviation of these levels (n − 1)",
      [](auto& r) { return r.of.reversal_deviation; }}});

constexpr auto point_columns = result_table<TrackPointRow>(
    "results/track_trials.csv", "trial of a track",
    {{"participant", "", "participant id",
      [](auto& r) { return r.track.in.people[r.track.of.person]; }},
     {"track", "", "number of the track, from 1", [](auto& r) { return r.track.of.track; }},
     {"trial", "", "number of the trial in the session", [](auto& r) { return r.point.trial; }},
     {"level", "level", "level shown", [](auto& r) { return r.point.level; }},
     {"positive", "0/1", "1: the answer was positive (right, yes or different)",
      [](auto& r) { return r.point.is_positive; }},
     {"reversal", "0/1", "staircases: 1 if the answer changed the direction of the steps",
      [](auto& r) { return r.point.is_reversal; }}});

constexpr auto mean_threshold_columns = result_table<MeanThresholdRow>(
    "results/mean_threshold.csv", "kind of estimate of the participants' thresholds",
    {factor_column,
     {"estimate", "", "fit (of psychometric functions), quest (posterior means) or reversals",
      [](auto& r) { return r.of.estimate; }},
     {"people", "", "participants whose answers determine it", [](auto& r) { return r.of.people; }},
     {"all", "", "participants with answers", [](auto& r) { return r.of.all; }},
     {"threshold", "level", "mean over participants", [](auto& r) { return r.of.mean; }},
     {"sd", "level", "standard deviation over participants (n − 1)",
      [](auto& r) { return r.of.deviation; }},
     {"low", "level", "lower end of the 95 % interval of the mean (Student)",
      [](auto& r) { return r.of.ends.low; }},
     {"high", "level", "upper end", [](auto& r) { return r.of.ends.high; }}});

}  // namespace

void add_thresholds(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  const ThresholdResults& found = results.thresholds;
  add_results(threshold_columns, found.estimates, answer_set, tables);
  std::vector<ThresholdLevelRow> levels;
  for (const ThresholdEstimate& one : found.estimates)
    for (const LevelCount& count : one.counts) levels.push_back({{answer_set, one}, count});
  add_table(level_columns, levels, answer_set.simulated, tables);
  add_results(track_columns, found.tracks, answer_set, tables);
  std::vector<TrackPointRow> points;
  for (const TrackResult& track : found.tracks)
    for (const TrackPoint& point : track.points) points.push_back({{answer_set, track}, point});
  add_table(point_columns, points, answer_set.simulated, tables);
  add_results(mean_threshold_columns, found.groups, answer_set, tables);
}

}  // namespace mien::pipeline
