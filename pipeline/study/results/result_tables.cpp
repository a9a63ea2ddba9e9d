#include "pipeline/study/results/result_tables.h"

#include <cmath>
#include <string_view>

#include "pipeline/base/documents/p_value.h"
#include "pipeline/study/results/table_columns.h"

namespace mien::pipeline {

namespace {

/// Writes rows of a form, and in simulated studies one column more.
class ResultWriter {
 public:
  ResultWriter(const TableForm& form, bool simulated)
      : form_(form), simulated_(simulated), writer_(header(form, simulated)) {}

  void row(std::vector<std::string> fields) {
    if (simulated_) fields.emplace_back("1");
    writer_.row(fields);
    ++rows_;
  }

  void finish(std::vector<ResultTable>& tables) const {
    if (rows_ > 0) tables.push_back({&form_, writer_.text()});
  }

 private:
  static std::vector<std::string> header(const TableForm& form, bool simulated) {
    std::vector<std::string> names = header_of(form);
    if (simulated) names.emplace_back("simulated");
    return names;
  }

  const TableForm& form_;
  bool simulated_;
  CsvWriter writer_;
  int rows_ = 0;
};

/// A p value, which is not rounded as other numbers are.
struct PValue {
  double p = 0.0;
};

std::string text_of(const std::string& text) { return text; }
std::string text_of(const char* text) { return text; }
std::string text_of(std::string_view text) { return std::string(text); }
std::string text_of(bool value) { return value ? "1" : "0"; }
std::string text_of(int number) { return std::to_string(number); }
std::string text_of(double number) { return field_of(number); }
std::string text_of(PValue value) { return p_of_table(value.p); }

std::vector<std::string> fields(const auto&... values) { return {text_of(values)...}; }

/// The beginning of a row about a stimulus: id, made, emotion, setting.
std::vector<std::string> about(const Gathered& gathered, std::size_t stimulus) {
  const ReportedStimulus& one = gathered.stimuli[stimulus];
  return {one.id, one.made, one.emotion, one.setting};
}

void add(std::vector<std::string>& row, const std::vector<std::string>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

void add_means(const Results& results, std::vector<ResultTable>& tables) {
  const Gathered& gathered = results.gathered;
  ResultWriter means(means_form, gathered.simulated);
  ResultWriter histograms(histograms_form, gathered.simulated);
  for (const RatingSummary& s : results.summaries) {
    const Scale& scale = gathered.scales[s.scale];
    std::vector<std::string> row = about(gathered, s.stimulus);
    add(row, fields(scale.id, s.answers, s.mean, s.deviation, s.low, s.high, s.median));
    means.row(row);
    const std::vector<double> places = places_of(scale, gathered.points);
    for (std::size_t i = 0; i < places.size(); ++i)
      histograms.row(fields(gathered.stimuli[s.stimulus].id, scale.id, places[i], s.counts[i],
                            1.0 * s.counts[i] / s.answers));
  }
  means.finish(tables);
  histograms.finish(tables);
}

/// As overall_columns and comparison_columns end.
std::vector<std::string> within_fields(const WithinPersons& w, double paired_adjusted,
                                       double wilcoxon_adjusted) {
  return fields(w.t.mean, w.t.low(0.95), w.t.high(0.95), w.t.t, w.t.degrees, PValue{w.t.p},
                PValue{paired_adjusted}, w.dz, w.gz, w.wilcoxon.w_plus, w.wilcoxon.used,
                w.wilcoxon.zeros, w.wilcoxon.tied, PValue{w.wilcoxon.p}, PValue{wilcoxon_adjusted},
                PValue{w.wilcoxon_normal}, PValue{w.wilcoxon_normal_corrected}, w.pratt.w_plus,
                PValue{w.pratt.p}, PValue{w.wilcoxon_zsplit}, w.location.estimate, w.location.low,
                w.location.high, w.wilcoxon.rank_biserial, w.all_alike);
}

std::vector<std::string> comparison_row(const Gathered& gathered, const Comparison& c) {
  std::vector<std::string> row = fields(word_of(family_words, c.family));
  add(row, about(gathered, c.stimulus));
  add(row, fields(c.against ? gathered.stimuli[*c.against].id : "", c.factor,
                  gathered.scales[c.scale].id,
                  c.own_end == 0  ? ""
                  : c.own_end > 0 ? "high"
                                  : "low"));
  add(row, fields(c.answers, c.mean, c.answers_against, c.mean_against, c.welch.mean,
                  c.welch.low(0.95), c.welch.high(0.95), c.welch.t, c.welch.degrees,
                  PValue{c.welch.p}, PValue{c.welch_adjusted}, c.d, c.g, c.within.people));
  add(row, within_fields(c.within, c.paired_adjusted, c.wilcoxon_adjusted));
  return row;
}

void add_comparisons(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(comparisons_form, results.gathered.simulated);
  for (const Comparison& c : results.comparisons) writer.row(comparison_row(results.gathered, c));
  writer.finish(tables);
  ResultWriter overall(overall_form, results.gathered.simulated);
  for (const OverallComparison& c : results.overall) {
    std::vector<std::string> row = fields(word_of(family_words, c.family), c.emotion, c.matched,
                                          c.unmatched, c.mean, c.mean_against, c.within.people);
    add(row, within_fields(c.within, c.paired_adjusted, c.wilcoxon_adjusted));
    overall.row(row);
  }
  overall.finish(tables);
}

void add_groups(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(groups_form, results.gathered.simulated);
  for (const GroupComparison& c : results.groups)
    writer.row(fields(c.question, c.one, c.other, results.gathered.stimuli[c.stimulus].id,
                      results.gathered.scales[c.scale].id, c.people_one, c.mean_one, c.people_other,
                      c.mean_other, c.welch.mean, c.welch.low(0.95), c.welch.high(0.95), c.welch.t,
                      c.welch.degrees, PValue{c.welch.p}, PValue{c.adjusted}, c.g));
  writer.finish(tables);
}

void add_confusion_tables(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter cells(confusion_form, results.gathered.simulated);
  ResultWriter recalls(recall_form, results.gathered.simulated);
  for (const Confusion& confusion : results.confusions) {
    const std::string by = confusion.by_points ? "ratings" : "choices";
    for (const ConfusionRow& row : confusion.rows) {
      for (std::size_t i = 0; i < confusion.columns.size(); ++i)
        cells.row(fields(by, confusion.of, row.emotion, confusion.columns[i], row.points[i],
                         row.points[i] / row.total));
      if (row.own < 0) continue;
      recalls.row(fields(by, confusion.of, row.emotion, row.showings, row.judged, row.total,
                         row.recall, row.low, row.high, confusion.chance, row.hits, PValue{row.p},
                         PValue{row.adjusted}));
    }
  }
  cells.finish(tables);
  recalls.finish(tables);
}

void add_correlations(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(correlations_form, results.gathered.simulated);
  const std::vector<std::string> ends = ends_of(results.gathered.scales);
  for (const EndCorrelation& pair : results.correlations) {
    const Correlation& c = pair.correlation;
    writer.row(fields(ends[pair.one], ends[pair.other], pair.same_scale, c.pairs, c.r, c.low,
                      c.high, PValue{c.p}, PValue{pair.adjusted}));
  }
  writer.finish(tables);
}

void add_reliability(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(agreement_form, results.gathered.simulated);
  for (const Reliability& r : results.reliability) {
    const Intraclass& icc = r.intraclass;
    writer.row(fields(results.gathered.scales[r.scale].id, icc.stimuli, icc.raters, icc.answers,
                      icc.answers_per_stimulus, icc.one, icc.one_k, icc.two, icc.two_k, icc.three,
                      icc.three_k, r.complete_people, r.alpha));
  }
  writer.finish(tables);
}

void add_preferences(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(preferences_form, results.gathered.simulated);
  for (const PreferenceCount& c : results.preferences)
    writer.row(fields(c.item, results.gathered.stimuli[c.one].id,
                      results.gathered.stimuli[c.other].id, c.trials, c.for_one,
                      1.0 * c.for_one / c.trials, c.low, c.high, PValue{c.p}, PValue{c.adjusted}));
  writer.finish(tables);
}

void add_people(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter people(people_form, results.gathered.simulated);
  for (const ParticipantSummary& p : results.participants)
    people.row(fields(p.participant, p.trials, p.answers, p.checks, p.passed, p.is_excluded,
                      p.median_rt_ms, p.stalls, p.dropped_frames, p.blurs, p.is_constant,
                      p.is_unfinished));
  people.finish(tables);
  ResultWriter demographics(demographics_form, results.gathered.simulated);
  for (const DemographicSummary& d : demographics_of(results.demographics, results.gathered))
    demographics.row(fields(d.question, d.answer, d.value, d.people));
  demographics.finish(tables);
}

void add_catch_trials(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter answers(catch_form, results.gathered.simulated);
  for (const CatchAnswer& a : results.catch_answers)
    answers.row(fields(a.participant, a.is_excluded, a.stimulus, a.against, a.item, a.first_trial,
                       a.second_trial, a.first, a.second,
                       a.difference ? field_of(*a.difference) : "", a.is_equal()));
  answers.finish(tables);
  ResultWriter summaries(catch_summary_form, results.gathered.simulated);
  for (const CatchSummary& s : results.catch_summaries)
    summaries.row(fields(s.participant, s.item, s.is_excluded, s.answers, s.equal,
                         1.0 * s.equal / s.answers, s.mean_difference, s.retest.r, s.retest.low,
                         s.retest.high));
  summaries.finish(tables);
}

void add_remarks(const Results& results, std::vector<ResultTable>& tables) {
  const auto write = [&](const TableForm& form, const std::vector<Remark>& remarks) {
    ResultWriter writer(form, results.gathered.simulated);
    for (const Remark& r : remarks) writer.row(fields(r.participant, r.stimulus, r.item, r.text));
    writer.finish(tables);
  };
  write(comments_form, results.gathered.remarks);
  write(words_form, results.gathered.words);
  ResultWriter counts(word_counts_form, results.gathered.simulated);
  for (const GivenWord& c : results.words)
    counts.row(fields(c.stimulus, c.item, c.word, c.people, c.asked));
  counts.finish(tables);
}

}  // namespace

std::string field_of(double value) { return !std::isfinite(value) ? "" : shortest_measured(value); }

std::vector<ResultTable> result_tables(const Results& results) {
  std::vector<ResultTable> tables;
  add_means(results, tables);
  add_comparisons(results, tables);
  add_groups(results, tables);
  add_confusion_tables(results, tables);
  add_correlations(results, tables);
  add_reliability(results, tables);
  add_preferences(results, tables);
  add_people(results, tables);
  add_catch_trials(results, tables);
  add_remarks(results, tables);
  return tables;
}

}  // namespace mien::pipeline
