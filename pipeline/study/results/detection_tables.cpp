#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

struct DetectionRow {
  const AnswerSet& in;
  const DetectionResult& of;

  const DetectionCounts& counts() const { return of.counts; }

  std::string scope() const {
    if (of.person) return "participant";
    if (!of.stimulus) return "all";
    return of.other ? "pair" : "stimulus";
  }

  std::string name_of(std::optional<std::size_t> stimulus) const {
    return stimulus ? in.stimuli[*stimulus].id : "";
  }
};

struct MeanSensitivityRow {
  const AnswerSet& in;
  const DetectionResults& of;
};

constexpr auto detection_columns = result_table<DetectionRow>(
    "results/sensitivity.csv", "participant, stimulus with the signal, or pair, and all together",
    {{"kind", "", "kind of trial: same_different, yes_no or two_interval",
      [](auto& r) { return r.in.form->name; }},
     {"scope", "",
      "all answers, participant, stimulus (with the signal, against all without it) or pair",
      [](auto& r) { return r.scope(); }},
     {"participant", "", "participant id",
      [](auto& r) { return r.of.person ? r.in.people[*r.of.person] : ""; }},
     {"stimulus", "", "stimulus with the signal, or one of the pair",
      [](auto& r) { return r.name_of(r.of.stimulus); }},
     {"other", "", "the other stimulus of the pair", [](auto& r) { return r.name_of(r.of.other); }},
     {"signal_trials", "",
      "trials with the signal (yes_no), with the signal in the first interval (two_interval), or "
      "with two different stimuli (same_different)",
      [](auto& r) { return r.counts().signal_trials; }},
     {"hits", "", "of these, those answered with yes, first or different",
      [](auto& r) { return r.counts().hits; }},
     {"noise_trials", "",
      "trials without the signal, with the signal in the second interval, or with the same "
      "stimulus "
      "twice",
      [](auto& r) { return r.counts().noise_trials; }},
     {"false_alarms", "", "of these, those answered with yes, first or different",
      [](auto& r) { return r.counts().false_alarms; }},
     {"hit_rate", "0–1", "H = (hits + 0.5) / (signal trials + 1): log-linear correction",
      [](auto& r) { return log_linear_rates(r.counts()).hit; }},
     {"false_alarm_rate", "0–1",
      "F = (false alarms + 0.5) / (noise trials + 1): log-linear correction",
      [](auto& r) { return log_linear_rates(r.counts()).false_alarm; }},
     {"correct", "0–1",
      "share of right answers: mean of those to signal and to noise trials, without correction",
      [](auto& r) { return r.of.correct(); }},
     {"d", "standard deviations",
      "d′: z(H) − z(F) for yes_no, (z(H) − z(F))/√2 for two_interval, by the differencing model "
      "for "
      "same_different",
      [](auto& r) { return r.of.sensitivity.d; }},
     {"d_se", "standard deviations",
      "its standard error (Gourevitch and Galanter), treating all answers as independent; empty "
      "for same_different",
      [](auto& r) { return r.of.sensitivity.error; }},
     {"d_low", "standard deviations",
      "lower end of the 95 % interval of d′, treating all answers as independent: ± 1.96 standard "
      "errors, for same_different profile likelihood",
      [](auto& r) { return r.of.sensitivity.d_ends.low; }},
     {"d_high", "standard deviations", "upper end",
      [](auto& r) { return r.of.sensitivity.d_ends.high; }},
     {"criterion", "standard deviations",
      "c = −(z(H) + z(F))/2, positive if no or the second interval is preferred; for "
      "same_different the difference of observations above which the answer is different",
      [](auto& r) { return r.of.sensitivity.criterion; }},
     {"criterion_low", "standard deviations",
      "lower end of the 95 % interval of c; empty for same_different",
      [](auto& r) { return r.of.sensitivity.criterion_ends.low; }},
     {"criterion_high", "standard deviations", "upper end",
      [](auto& r) { return r.of.sensitivity.criterion_ends.high; }}});

constexpr auto mean_sensitivity_columns = result_table<MeanSensitivityRow>(
    "results/mean_sensitivity.csv", "kind of trial",
    {{"kind", "", "kind of trial: same_different, yes_no or two_interval",
      [](auto& r) { return r.in.form->name; }},
     {"people", "", "participants with signal and noise trials",
      [](auto& r) { return r.of.people; }},
     {"d", "standard deviations", "mean of the participants' d′",
      [](auto& r) { return r.of.mean_d; }},
     {"low", "standard deviations", "lower end of its 95 % interval (Student)",
      [](auto& r) { return r.of.mean_ends.low; }},
     {"high", "standard deviations", "upper end", [](auto& r) { return r.of.mean_ends.high; }}});

}  // namespace

void add_detection(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  if (results.detection.rows.empty()) return;
  add_results(detection_columns, results.detection.rows, answer_set, tables);
  if (results.detection.people > 1)
    add_table(mean_sensitivity_columns, {{answer_set, results.detection}}, answer_set.simulated,
              tables);
}

}  // namespace mien::pipeline
