#include "pipeline/study/results/result_rows.h"
#include "pipeline/study/results/within_columns.h"

namespace mien::pipeline {

namespace {

using ComparisonRow = ResultRow<Comparison>;
using OverallRow = ResultRow<OverallComparison>;
using GroupRow = ResultRow<GroupComparison>;

constexpr auto comparison_columns = result_table<ComparisonRow>(
    "results/comparisons.csv", "comparison",
    {{"family", "",
      "best-seen (a video with all videos of its setting), modified-acted, modified-neutral, "
      "acted-neutral, modified-best (a modified video with the unmodified video of its setting "
      "that is rated highest on the intended emotion) or between-levels (two stimuli that differ "
      "in one factor only, such as the actor); p values are corrected within a family, and except "
      "for best-seen separately for the scale of the intended emotion and for the other scales",
      [](auto& r) { return word_of(family_words, r.of.family); }},
     stimulus_column,
     made_column,
     emotion_column,
     setting_column,
     {"against", "", "stimulus it is compared with; empty: all stimuli of the setting",
      [](auto& r) { return r.of.against ? r.in.stimuli[*r.of.against].id : ""; }},
     {"factor", "", "for between-levels: the factor in which the two stimuli differ",
      [](auto& r) { return r.of.factor; }},
     scale_column,
     {"own_end", "",
      "end of the scale that is the intended emotion: low or high; empty if neither is",
      [](auto& r) { return r.of.intended_end == 0  ? ""
                           : r.of.intended_end > 0 ? "high"
                                                   : "low"; }},
     {"answers", "", "number of answers about the stimulus", [](auto& r) { return r.of.answers; }},
     {"mean", "scale units", "mean of those answers", [](auto& r) { return r.of.mean; }},
     {"answers_against", "",
      "number of answers about the stimuli it is compared with (best-seen: including the video "
      "itself)",
      [](auto& r) { return r.of.answers_against; }},
     {"mean_against", "scale units", "mean of those answers",
      [](auto& r) { return r.of.mean_against; }},
     {"welch_difference", "scale units",
      "difference of the two means, treating all answers as independent (best-seen: the test of "
      "the emotion thesis, in which the video itself is among those it is compared with)",
      [](auto& r) { return r.of.welch.mean; }},
     {"welch_low", "scale units", "lower end of its 95 % interval",
      [](auto& r) { return r.of.welch.low(0.95); }},
     {"welch_high", "scale units", "upper end", [](auto& r) { return r.of.welch.high(0.95); }},
     {"welch_t", "", "Welch's t", [](auto& r) { return r.of.welch.t; }},
     {"welch_df", "", "degrees of freedom", [](auto& r) { return r.of.welch.degrees; }},
     {"welch_p", "", "two-sided p; empty if there is no variance",
      [](auto& r) { return p_field(r.of.welch.p); }},
     {"welch_p_adjusted", "", "p corrected within the family",
      [](auto& r) { return p_field(r.of.welch_adjusted); }},
     {"cohens_d", "", "Cohen's d: difference divided by the pooled standard deviation",
      [](auto& r) { return r.of.d; }},
     {"hedges_g", "", "the same with Hedges' bias correction", [](auto& r) { return r.of.g; }},
     {"people", "",
      "participants who rated both (best-seen: the video and any other of its setting)",
      [](auto& r) { return r.of.within.people; }}},
    within_columns<ComparisonRow>);

constexpr auto overall_columns = result_table<OverallRow>(
    "results/overall.csv", "comparison over all settings",
    {{"family", "", "modified-acted, modified-neutral or acted-neutral",
      [](auto& r) { return word_of(family_words, r.of.family); }},
     {"emotion", "", "intended emotion; empty: all", [](auto& r) { return r.of.emotion; }},
     {"matched", "",
      "number of settings and emotions, summed over participants, for which both motions "
      "were rated; only these are compared",
      [](auto& r) { return r.of.matched; }},
     {"unmatched_people", "",
      "participants who rated motions of both kinds, but never of the same setting and emotion; "
      "not included in this comparison",
      [](auto& r) { return r.of.unmatched; }},
     {"mean", "scale units",
      "mean over participants of the rating of the intended emotion, from the middle of its scale",
      [](auto& r) { return r.of.mean; }},
     {"mean_against", "scale units", "the same for the stimuli it is compared with",
      [](auto& r) { return r.of.mean_against; }},
     {"people", "", "participants who rated both motions of a setting and emotion",
      [](auto& r) { return r.of.within.people; }}},
    within_columns<OverallRow>);

constexpr auto group_columns = result_table<GroupRow>(
    "results/groups.csv", "stimulus, scale and pair of groups",
    {{"question", "", "demographic question; its two most frequent answers are compared",
      [](auto& r) { return r.of.question; }},
     {"one", "", "first answer compared", [](auto& r) { return r.of.one; }},
     {"other", "", "second answer compared", [](auto& r) { return r.of.other; }},
     stimulus_column,
     scale_column,
     {"people_one", "", "participants with the first answer who judged the stimulus",
      [](auto& r) { return r.of.people_one; }},
     {"mean_one", "scale units", "mean of these participants' means",
      [](auto& r) { return r.of.mean_one; }},
     {"people_other", "", "participants with the second answer who judged the stimulus",
      [](auto& r) { return r.of.people_other; }},
     {"mean_other", "scale units", "mean of these participants' means",
      [](auto& r) { return r.of.mean_other; }},
     {"difference", "scale units", "first minus second", [](auto& r) { return r.of.welch.mean; }},
     {"low", "scale units", "lower end of its 95 % interval (Welch)",
      [](auto& r) { return r.of.welch.low(0.95); }},
     {"high", "scale units", "upper end", [](auto& r) { return r.of.welch.high(0.95); }},
     {"t", "", "Welch's t", [](auto& r) { return r.of.welch.t; }},
     {"df", "", "degrees of freedom", [](auto& r) { return r.of.welch.degrees; }},
     {"p", "", "two-sided p; empty if there is no variance",
      [](auto& r) { return p_field(r.of.welch.p); }},
     adjusted_column,
     {"hedges_g", "",
      "Hedges' g: difference divided by the pooled standard deviation, bias-corrected",
      [](auto& r) { return r.of.g; }}});

}  // namespace

void add_comparisons(const Results& results, std::vector<WrittenTable>& tables) {
  add_results(comparison_columns, results.comparisons, results.answer_set, tables);
  add_results(overall_columns, results.overall, results.answer_set, tables);
  add_results(group_columns, results.groups, results.answer_set, tables);
}

}  // namespace mien::pipeline
