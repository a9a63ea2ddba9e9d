#include "pipeline/study/results/result_tables.h"

#include <cmath>

#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

using MeanRow = ResultRow<RatingSummary>;
using CorrelationRow = ResultRow<EndCorrelation>;
using AgreementRow = ResultRow<Reliability>;
using PreferenceRow = ResultRow<PreferenceCount>;

/// A bin of a scale's histogram.
struct HistogramBar {
  MeanRow summary;
  double value;
  int count;

  const ReportedStimulus& stimulus() const { return summary.stimulus(); }
  const Scale& scale() const { return summary.scale(); }
};

struct ConfusionCell {
  const Confusion& all;
  const ConfusionRow& of;
  std::size_t column;
};

struct RecallRow {
  const Confusion& all;
  const ConfusionRow& of;
};

constexpr auto means_columns = result_table<MeanRow>(
    "results/means.csv", "stimulus and scale",
    {stimulus_column,
     made_column,
     emotion_column,
     setting_column,
     scale_column,
     {"answers", "", "number of answers", [](auto& r) { return r.of.answers; }},
     {"mean", "scale units", "mean rating; positive towards the high pole of the scale",
      [](auto& r) { return r.of.mean; }},
     {"sd", "scale units", "standard deviation (n − 1)", [](auto& r) { return r.of.deviation; }},
     {"low", "scale units", "lower end of the 95 % interval of the mean (Student)",
      [](auto& r) { return r.of.low; }},
     {"high", "scale units", "upper end of that interval", [](auto& r) { return r.of.high; }},
     {"median", "scale units", "median rating", [](auto& r) { return r.of.median; }}});

constexpr auto histogram_columns = result_table<HistogramBar>(
    "results/histograms.csv", "stimulus, scale and position on the scale",
    {stimulus_column,
     scale_column,
     {"value", "scale units", "position on the scale", [](auto& r) { return r.value; }},
     {"answers", "", "number of answers at that position", [](auto& r) { return r.count; }},
     {"share", "0–1", "proportion of the answers about the stimulus on this scale",
      [](auto& r) { return 1.0 * r.count / r.summary.of.answers; }}});

constexpr SharedColumn by_column{"by", "", "ratings (points rule) or choices",
                                 [](auto& r) { return r.all.by_points ? "ratings" : "choices"; }};
constexpr SharedColumn of_column{"of", "", "level of factor made that the rows cover, or all",
                                 [](auto& r) { return r.all.of; }};
constexpr SharedColumn shown_column{"shown", "", "intended emotion",
                                    [](auto& r) { return r.of.emotion; }};

constexpr auto confusion_columns = result_table<ConfusionCell>(
    "results/confusion.csv", "cell of a confusion matrix",
    {by_column,
     of_column,
     shown_column,
     {"seen", "", "perceived emotion", [](auto& r) { return r.all.columns[r.column]; }},
     {"points", "",
      "points: 2 for a rating at the end of a scale, 1 halfway between middle and end, others in "
      "proportion; for choices, their number",
      [](auto& r) { return r.of.points[r.column]; }},
     {"share", "0–1", "proportion of the row's points",
      [](auto& r) { return r.of.points[r.column] / r.of.total; }}});

constexpr auto recall_columns = result_table<RecallRow>(
    "results/recall.csv", "intended emotion",
    {by_column,
     of_column,
     shown_column,
     {"showings", "", "presentations of such stimuli", [](auto& r) { return r.of.showings; }},
     {"judged", "", "presentations that received any points", [](auto& r) { return r.of.judged; }},
     {"points", "", "total points of the row", [](auto& r) { return r.of.total; }},
     {"recall", "0–1", "proportion of the points on the intended emotion",
      [](auto& r) { return r.of.recall; }},
     {"low", "0–1",
      "lower end of the 95 % Wilson interval, with each judged presentation as one trial",
      [](auto& r) { return r.of.low; }},
     {"high", "0–1", "upper end", [](auto& r) { return r.of.high; }},
     {"chance", "0–1", "1 / number of emotions that could be perceived",
      [](auto& r) { return r.all.chance; }},
     {"hits", "", "presentations in which the intended emotion alone received the most points",
      [](auto& r) { return r.of.hits; }},
     {"decided", "", "presentations in which any one emotion alone received the most points",
      [](auto& r) { return r.of.decided; }},
     {"p", "",
      "exact two-sided binomial test of hits among the decided presentations against chance",
      [](auto& r) { return p_field(r.of.p); }},
     adjusted_column});

constexpr auto correlation_columns = result_table<CorrelationRow>(
    "results/correlations.csv", "pair of scale ends",
    {{"one", "", "end of a scale", [](auto& r) { return ends_of(r.in.scales)[r.of.one]; }},
     {"other", "", "end of a scale", [](auto& r) { return ends_of(r.in.scales)[r.of.other]; }},
     {"same_scale", "",
      "1 for the two ends of the same scale, which are negatively correlated by construction",
      [](auto& r) { return r.of.same_scale; }},
     {"showings", "",
      "number of presentations (one participant, one stimulus) in which both scales were answered",
      [](auto& r) { return r.of.correlation.pairs; }},
     {"r", "-1–1", "Pearson's correlation of the points of the two ends over presentations",
      [](auto& r) { return r.of.correlation.r; }},
     {"low", "-1–1", "lower end of its 95 % interval (Fisher's z)",
      [](auto& r) { return r.of.correlation.low; }},
     {"high", "-1–1", "upper end", [](auto& r) { return r.of.correlation.high; }},
     {"p", "", "two-sided p, treating all presentations as independent",
      [](auto& r) { return p_field(r.of.correlation.p); }},
     adjusted_column});

constexpr auto agreement_columns = result_table<AgreementRow>(
    "results/agreement.csv", "scale",
    {scale_column,
     {"stimuli", "", "number of stimuli rated on the scale",
      [](auto& r) { return r.of.intraclass.stimuli; }},
     {"people", "", "number of participants who rated any of them",
      [](auto& r) { return r.of.intraclass.raters; }},
     {"answers", "",
      "number of ratings; further ratings of a stimulus by the same participant are averaged",
      [](auto& r) { return r.of.intraclass.answers; }},
     {"answers_per_stimulus", "",
      "k of the average-measures ICCs: number of ratings per stimulus, (N − Σn²/N)/(stimuli − 1) "
      "for unequal numbers n",
      [](auto& r) { return r.of.intraclass.answers_per_stimulus; }},
     {"icc_1", "", "ICC(1): one-way, single rating", [](auto& r) { return r.of.intraclass.one; }},
     {"icc_1_k", "", "ICC(1,k): one-way, mean of k ratings",
      [](auto& r) { return r.of.intraclass.one_k; }},
     {"icc_2", "", "ICC(2,1): agreement, raters random",
      [](auto& r) { return r.of.intraclass.two; }},
     {"icc_2_k", "", "ICC(2,k)", [](auto& r) { return r.of.intraclass.two_k; }},
     {"icc_3", "", "ICC(3,1): consistency, raters fixed",
      [](auto& r) { return r.of.intraclass.three; }},
     {"icc_3_k", "", "ICC(3,k)", [](auto& r) { return r.of.intraclass.three_k; }},
     {"complete_people", "", "participants who rated all these stimuli",
      [](auto& r) { return r.of.complete_people; }},
     {"alpha", "",
      "Cronbach's alpha of the participants who rated all stimuli, with participants as items",
      [](auto& r) { return r.of.alpha; }},
     {"remark", "", "why there are no coefficients, or what negative ones mean",
      [](auto& r) { return r.of.remark; }}});

constexpr auto preference_columns = result_table<PreferenceRow>(
    "results/preferences.csv", "pair of stimuli",
    {{"item", "", "scale or question id", [](auto& r) { return r.of.item; }},
     {"one", "", "stimulus", [](auto& r) { return r.in.stimuli[r.of.one].id; }},
     {"other", "", "stimulus it was shown with",
      [](auto& r) { return r.in.stimuli[r.of.other].id; }},
     {"trials", "", "number of choices between the two, without ties",
      [](auto& r) { return r.of.trials; }},
     {"for_one", "", "number of choices of the stimulus in column one",
      [](auto& r) { return r.of.for_one; }},
     {"ties", "", "number of answers that prefer neither", [](auto& r) { return r.of.ties; }},
     {"share", "0–1", "proportion of choices of the stimulus in column one",
      [](auto& r) { return 1.0 * r.of.for_one / r.of.trials; }},
     {"low", "0–1", "lower end of Wilson's 95 % interval", [](auto& r) { return r.of.low; }},
     {"high", "0–1", "upper end", [](auto& r) { return r.of.high; }},
     {"p", "", "exact binomial test against one half, two-sided",
      [](auto& r) { return p_field(r.of.p); }},
     adjusted_column});

void add_means(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  add_results(means_columns, results.summaries, answer_set, tables);
  std::vector<HistogramBar> bars;
  for (const RatingSummary& summary : results.summaries) {
    const std::vector<double> places =
        scale_points(answer_set.scales[summary.scale], answer_set.points);
    for (std::size_t i = 0; i < places.size(); ++i)
      bars.push_back({{answer_set, summary}, places[i], summary.counts[i]});
  }
  add_table(histogram_columns, bars, answer_set.simulated, tables);
}

void add_confusions(const Results& results, std::vector<WrittenTable>& tables) {
  std::vector<ConfusionCell> cells;
  std::vector<RecallRow> recalls;
  for (const Confusion& confusion : results.confusions) {
    for (const ConfusionRow& row : confusion.rows) {
      for (std::size_t i = 0; i < confusion.columns.size(); ++i)
        cells.push_back({confusion, row, i});
      if (row.own >= 0) recalls.push_back({confusion, row});
    }
  }
  add_table(confusion_columns, cells, results.answer_set.simulated, tables);
  add_table(recall_columns, recalls, results.answer_set.simulated, tables);
}

}  // namespace

std::string number_field(double value) {
  return !std::isfinite(value) ? "" : shortest_measured(value);
}

std::vector<WrittenTable> result_tables(const Results& results) {
  std::vector<WrittenTable> tables;
  add_means(results, tables);
  add_comparisons(results, tables);
  add_factors(results, tables);
  add_confusions(results, tables);
  add_results(correlation_columns, results.correlations, results.answer_set, tables);
  add_results(agreement_columns, results.reliability, results.answer_set, tables);
  add_results(preference_columns, results.preferences, results.answer_set, tables);
  add_worths(results, tables);
  add_detection(results, tables);
  add_thresholds(results, tables);
  add_grid(results, tables);
  add_traces(results, tables);
  add_participants(results, tables);
  return tables;
}

}  // namespace mien::pipeline
