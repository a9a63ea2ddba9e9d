#include "pipeline/study/results/result_tables.h"

#include <cmath>
#include <utility>

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

std::string whole(int value) { return std::to_string(value); }

/// The beginning of a row about a stimulus: id, made, emotion, setting.
std::vector<std::string> about(const Gathered& gathered, std::size_t stimulus) {
  const ReportedStimulus& one = gathered.stimuli[stimulus];
  return {one.id, one.made, one.emotion, one.setting};
}

void add(std::vector<std::string>& row, std::vector<std::string> more) {
  row.insert(row.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void add_means(const Results& results, std::vector<ResultTable>& tables) {
  const Gathered& gathered = results.gathered;
  ResultWriter means(means_form, gathered.simulated);
  ResultWriter histograms(histograms_form, gathered.simulated);
  for (const RatingSummary& s : results.summaries) {
    const Scale& scale = gathered.scales[s.scale];
    std::vector<std::string> row = about(gathered, s.stimulus);
    add(row, {scale.id, whole(s.answers), field_of(s.mean), field_of(s.deviation), field_of(s.low),
              field_of(s.high), field_of(s.median)});
    means.row(row);
    const std::vector<double> places = places_of(scale, gathered.points);
    for (std::size_t i = 0; i < places.size(); ++i)
      histograms.row({gathered.stimuli[s.stimulus].id, scale.id, field_of(places[i]),
                      whole(s.counts[i]), field_of(1.0 * s.counts[i] / s.answers)});
  }
  means.finish(tables);
  histograms.finish(tables);
}

/// As overall_columns and comparison_columns end.
std::vector<std::string> within_fields(const WithinPersons& w, double paired_adjusted,
                                       double wilcoxon_adjusted) {
  return {field_of(w.t.mean),
          field_of(w.t.low(0.95)),
          field_of(w.t.high(0.95)),
          field_of(w.t.t),
          field_of(w.t.degrees),
          p_of_table(w.t.p),
          p_of_table(paired_adjusted),
          field_of(w.dz),
          field_of(w.gz),
          field_of(w.wilcoxon.w_plus),
          whole(w.wilcoxon.used),
          whole(w.wilcoxon.zeros),
          whole(w.wilcoxon.tied),
          p_of_table(w.wilcoxon.p),
          p_of_table(wilcoxon_adjusted),
          p_of_table(w.wilcoxon_normal),
          p_of_table(w.wilcoxon_normal_corrected),
          field_of(w.pratt.w_plus),
          p_of_table(w.pratt.p),
          p_of_table(w.wilcoxon_zsplit),
          field_of(w.location.estimate),
          field_of(w.location.low),
          field_of(w.location.high),
          field_of(w.wilcoxon.rank_biserial),
          w.all_alike ? "1" : "0"};
}

std::vector<std::string> comparison_row(const Gathered& gathered, const Comparison& c) {
  std::vector<std::string> row = {std::string(word_of(family_words, c.family))};
  add(row, about(gathered, c.stimulus));
  add(row, {c.against ? gathered.stimuli[*c.against].id : "", c.factor, gathered.scales[c.scale].id,
            c.own_end == 0  ? ""
            : c.own_end > 0 ? "high"
                            : "low"});
  add(row, {whole(c.answers), field_of(c.mean), whole(c.answers_against), field_of(c.mean_against),
            field_of(c.welch.mean), field_of(c.welch.low(0.95)), field_of(c.welch.high(0.95)),
            field_of(c.welch.t), field_of(c.welch.degrees), p_of_table(c.welch.p),
            p_of_table(c.welch_adjusted), field_of(c.d), field_of(c.g)});
  add(row, {whole(c.within.people)});
  add(row, within_fields(c.within, c.paired_adjusted, c.wilcoxon_adjusted));
  return row;
}

void add_comparisons(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(comparisons_form, results.gathered.simulated);
  for (const Comparison& c : results.comparisons) writer.row(comparison_row(results.gathered, c));
  writer.finish(tables);
  ResultWriter overall(overall_form, results.gathered.simulated);
  for (const OverallComparison& c : results.overall) {
    std::vector<std::string> row = {std::string(word_of(family_words, c.family)),
                                    c.emotion,
                                    whole(c.matched),
                                    whole(c.unmatched),
                                    field_of(c.mean),
                                    field_of(c.mean_against),
                                    whole(c.within.people)};
    add(row, within_fields(c.within, c.paired_adjusted, c.wilcoxon_adjusted));
    overall.row(row);
  }
  overall.finish(tables);
}

void add_groups(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(groups_form, results.gathered.simulated);
  for (const GroupComparison& c : results.groups)
    writer.row({c.question, c.one, c.other, results.gathered.stimuli[c.stimulus].id,
                results.gathered.scales[c.scale].id, whole(c.people_one), field_of(c.mean_one),
                whole(c.people_other), field_of(c.mean_other), field_of(c.welch.mean),
                field_of(c.welch.low(0.95)), field_of(c.welch.high(0.95)), field_of(c.welch.t),
                field_of(c.welch.degrees), p_of_table(c.welch.p), p_of_table(c.adjusted),
                field_of(c.g)});
  writer.finish(tables);
}

void add_confusion_tables(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter cells(confusion_form, results.gathered.simulated);
  ResultWriter recalls(recall_form, results.gathered.simulated);
  for (const Confusion& confusion : results.confusions) {
    const std::string by = confusion.by_points ? "ratings" : "choices";
    for (const ConfusionRow& row : confusion.rows) {
      for (std::size_t i = 0; i < confusion.columns.size(); ++i)
        cells.row({by, confusion.of, row.emotion, confusion.columns[i], field_of(row.points[i]),
                   field_of(row.points[i] / row.total)});
      if (row.own < 0) continue;
      recalls.row({by, confusion.of, row.emotion, whole(row.showings), whole(row.judged),
                   field_of(row.total), field_of(row.recall), field_of(row.low), field_of(row.high),
                   field_of(confusion.chance), whole(row.hits), p_of_table(row.p),
                   p_of_table(row.adjusted)});
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
    writer.row({ends[pair.one], ends[pair.other], pair.same_scale ? "1" : "0", whole(c.pairs),
                field_of(c.r), field_of(c.low), field_of(c.high), p_of_table(c.p),
                p_of_table(pair.adjusted)});
  }
  writer.finish(tables);
}

void add_reliability(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(agreement_form, results.gathered.simulated);
  for (const Reliability& r : results.reliability) {
    const Intraclass& icc = r.intraclass;
    writer.row({results.gathered.scales[r.scale].id, whole(icc.stimuli), whole(icc.raters),
                whole(icc.answers), field_of(icc.answers_per_stimulus), field_of(icc.one),
                field_of(icc.one_k), field_of(icc.two), field_of(icc.two_k), field_of(icc.three),
                field_of(icc.three_k), whole(r.complete_people), field_of(r.alpha)});
  }
  writer.finish(tables);
}

void add_preferences(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter writer(preferences_form, results.gathered.simulated);
  for (const PreferenceCount& c : results.preferences)
    writer.row({c.item, results.gathered.stimuli[c.one].id, results.gathered.stimuli[c.other].id,
                whole(c.trials), whole(c.for_one), field_of(1.0 * c.for_one / c.trials),
                field_of(c.low), field_of(c.high), p_of_table(c.p), p_of_table(c.adjusted)});
  writer.finish(tables);
}

void add_people(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter people(people_form, results.gathered.simulated);
  for (const ParticipantSummary& p : results.participants)
    people.row({p.participant, whole(p.trials), whole(p.answers), whole(p.checks), whole(p.passed),
                p.is_excluded ? "1" : "0", field_of(p.median_rt_ms), whole(p.stalls),
                whole(p.dropped_frames), whole(p.blurs), p.is_constant ? "1" : "0",
                p.is_unfinished ? "1" : "0"});
  people.finish(tables);
  ResultWriter demographics(demographics_form, results.gathered.simulated);
  for (const DemographicSummary& d : demographics_of(results.demographics, results.gathered))
    demographics.row({d.question, d.answer, field_of(d.value), whole(d.people)});
  demographics.finish(tables);
}

void add_catch_trials(const Results& results, std::vector<ResultTable>& tables) {
  ResultWriter answers(catch_form, results.gathered.simulated);
  for (const CatchAnswer& a : results.catch_answers)
    answers.row({a.participant, a.is_excluded ? "1" : "0", a.stimulus, a.against, a.item,
                 whole(a.first_trial), whole(a.second_trial), a.first, a.second,
                 a.difference ? field_of(*a.difference) : "", a.is_equal() ? "1" : "0"});
  answers.finish(tables);
  ResultWriter summaries(catch_summary_form, results.gathered.simulated);
  for (const CatchSummary& s : results.catch_summaries)
    summaries.row({s.participant, s.item, s.is_excluded ? "1" : "0", whole(s.answers),
                   whole(s.equal), field_of(1.0 * s.equal / s.answers), field_of(s.mean_difference),
                   field_of(s.retest.r), field_of(s.retest.low), field_of(s.retest.high)});
  summaries.finish(tables);
}

void add_remarks(const Results& results, std::vector<ResultTable>& tables) {
  const auto write = [&](const TableForm& form, const std::vector<Remark>& remarks) {
    ResultWriter writer(form, results.gathered.simulated);
    for (const Remark& r : remarks) writer.row({r.participant, r.stimulus, r.item, r.text});
    writer.finish(tables);
  };
  write(comments_form, results.gathered.remarks);
  write(words_form, results.gathered.words);
  ResultWriter counts(word_counts_form, results.gathered.simulated);
  for (const GivenWord& c : results.words)
    counts.row({c.stimulus, c.item, c.word, whole(c.people), whole(c.asked)});
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
