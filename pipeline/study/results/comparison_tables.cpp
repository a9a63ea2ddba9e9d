#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

using ComparisonRow = ResultRow<Comparison>;
using OverallRow = ResultRow<OverallComparison>;
using GroupRow = ResultRow<GroupComparison>;

/// Of the tests within persons.
template <class Row>
constexpr std::array within_columns = std::to_array<ResultColumn<Row>>({
    {"paired_difference", "scale points", "mean of their own differences",
     [](auto& r) { return r.of.within.t.mean; }},
    {"paired_low", "scale points", "lower end of its 95 % interval",
     [](auto& r) { return r.of.within.t.low(0.95); }},
    {"paired_high", "scale points", "upper end", [](auto& r) { return r.of.within.t.high(0.95); }},
    {"paired_t", "", "t of the differences", [](auto& r) { return r.of.within.t.t; }},
    {"paired_df", "", "its degrees of freedom", [](auto& r) { return r.of.within.t.degrees; }},
    {"paired_p", "", "two-sided p; empty where all differences are alike",
     [](auto& r) { return p_of_table(r.of.within.t.p); }},
    {"paired_p_adjusted", "", "p corrected within the family",
     [](auto& r) { return p_of_table(r.of.paired_adjusted); }},
    {"cohens_dz", "", "mean difference in units of the differences' standard deviation",
     [](auto& r) { return r.of.within.dz; }},
    {"hedges_gz", "", "the same without bias", [](auto& r) { return r.of.within.gz; }},
    {"wilcoxon_v", "", "sum of the ranks of the positive differences, zeros left out",
     [](auto& r) { return r.of.within.wilcoxon.w_plus; }},
    {"wilcoxon_n", "", "differences that are not 0",
     [](auto& r) { return r.of.within.wilcoxon.used; }},
    {"wilcoxon_zeros", "", "differences that are 0",
     [](auto& r) { return r.of.within.wilcoxon.zeros; }},
    {"wilcoxon_tied", "", "differences that share their size with another",
     [](auto& r) { return r.of.within.wilcoxon.tied; }},
    {"wilcoxon_p", "", "two-sided, exact, conditional on ties; zeros left out",
     [](auto& r) { return p_of_table(r.of.within.wilcoxon.p); }},
    {"wilcoxon_p_adjusted", "", "p corrected within the family",
     [](auto& r) { return p_of_table(r.of.wilcoxon_adjusted); }},
    {"wilcoxon_p_normal", "", "normal approximation without continuity correction",
     [](auto& r) { return p_of_table(r.of.within.wilcoxon_normal); }},
    {"wilcoxon_p_normal_corrected", "", "normal approximation with continuity correction",
     [](auto& r) { return p_of_table(r.of.within.wilcoxon_normal_corrected); }},
    {"pratt_v", "", "as wilcoxon_v, zeros ranked with the others (Pratt)",
     [](auto& r) { return r.of.within.pratt.w_plus; }},
    {"pratt_p", "", "two-sided, exact, of Pratt's ranks",
     [](auto& r) { return p_of_table(r.of.within.pratt.p); }},
    {"zsplit_p", "", "normal approximation, half of the zeros' ranks on either side",
     [](auto& r) { return p_of_table(r.of.within.wilcoxon_zsplit); }},
    {"hodges_lehmann", "scale points", "median of the means of any two differences",
     [](auto& r) { return r.of.within.location.estimate; }},
    {"hodges_lehmann_low", "scale points", "lower end of its 95 % interval",
     [](auto& r) { return r.of.within.location.low; }},
    {"hodges_lehmann_high", "scale points", "upper end",
     [](auto& r) { return r.of.within.location.high; }},
    {"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation, zeros left out",
     [](auto& r) { return r.of.within.wilcoxon.rank_biserial; }},
    {"all_alike", "", "1 where all differences are the same, so that there is no t test",
     [](auto& r) { return r.of.within.all_alike; }},
});

constexpr auto comparison_columns = result_table<ComparisonRow>(
    "results/comparisons.csv", "a comparison",
    {{"family", "",
      "best-seen (a video with all videos of its setting), modified-acted, modified-neutral, "
      "acted-neutral, modified-best (with the video of the setting, itself not modified, in "
      "which the emotion is seen most) or between-levels (what differs in one factor alone: "
      "two actors); p values are corrected within a family (but for best-seen: comparisons "
      "on the scale of the emotion that was meant by themselves, and those on other "
      "scales)",
      [](auto& r) { return word_of(family_words, r.of.family); }},
     stimulus_column,
     made_column,
     emotion_column,
     setting_column,
     {"against", "", "the stimulus it is compared with; empty: all of the setting",
      [](auto& r) { return r.of.against ? r.in.stimuli[*r.of.against].id : ""; }},
     {"factor", "", "of between-levels: the factor in whose level the two differ",
      [](auto& r) { return r.of.factor; }},
     scale_column,
     {"own_end", "", "the pole of the scale that is the emotion of the stimulus, if any",
      [](auto& r) { return r.of.own_end == 0  ? ""
                           : r.of.own_end > 0 ? "high"
                                              : "low"; }},
     {"answers", "", "answers about the stimulus", [](auto& r) { return r.of.answers; }},
     {"mean", "scale points", "their mean", [](auto& r) { return r.of.mean; }},
     {"answers_against", "", "answers about what it is compared with",
      [](auto& r) { return r.of.answers_against; }},
     {"mean_against", "scale points", "their mean", [](auto& r) { return r.of.mean_against; }},
     {"welch_difference", "scale points",
      "difference of the two means, all answers as if independent (best-seen: the test of the "
      "thesis, in which the video is one of those it is compared with)",
      [](auto& r) { return r.of.welch.mean; }},
     {"welch_low", "scale points", "lower end of its 95 % interval",
      [](auto& r) { return r.of.welch.low(0.95); }},
     {"welch_high", "scale points", "upper end", [](auto& r) { return r.of.welch.high(0.95); }},
     {"welch_t", "", "Welch's t", [](auto& r) { return r.of.welch.t; }},
     {"welch_df", "", "its degrees of freedom", [](auto& r) { return r.of.welch.degrees; }},
     {"welch_p", "", "two-sided p", [](auto& r) { return p_of_table(r.of.welch.p); }},
     {"welch_p_adjusted", "", "p corrected within the family",
      [](auto& r) { return p_of_table(r.of.welch_adjusted); }},
     {"cohens_d", "", "difference in units of the pooled standard deviation",
      [](auto& r) { return r.of.d; }},
     {"hedges_g", "", "the same without bias", [](auto& r) { return r.of.g; }},
     {"people", "", "persons who saw both (best-seen: the video and another of its setting)",
      [](auto& r) { return r.of.within.people; }}},
    within_columns<ComparisonRow>);

constexpr auto overall_columns = result_table<OverallRow>(
    "results/overall.csv", "a comparison over all settings",
    {{"family", "", "modified-acted, modified-neutral or acted-neutral",
      [](auto& r) { return word_of(family_words, r.of.family); }},
     {"emotion", "", "the emotion that was meant; empty: all",
      [](auto& r) { return r.of.emotion; }},
     {"matched", "",
      "settings and emotions of all people of which both sides were judged: these alone are "
      "compared",
      [](auto& r) { return r.of.matched; }},
     {"unmatched_people", "",
      "people who judged both sides, but never of one setting and emotion; left out",
      [](auto& r) { return r.of.unmatched; }},
     {"mean", "scale points",
      "mean over the people of how far they saw the emotion that was meant, from the middle of its "
      "scale",
      [](auto& r) { return r.of.mean; }},
     {"mean_against", "scale points", "the same, of what it is compared with",
      [](auto& r) { return r.of.mean_against; }},
     {"people", "", "persons who saw both sides of a setting and emotion",
      [](auto& r) { return r.of.within.people; }}},
    within_columns<OverallRow>);

constexpr auto group_columns = result_table<GroupRow>(
    "results/groups.csv", "a stimulus on a scale, by two groups",
    {{"question", "", "about the participants; the two answers that most gave are compared",
      [](auto& r) { return r.of.question; }},
     {"one", "", "an answer", [](auto& r) { return r.of.one; }},
     {"other", "", "another answer", [](auto& r) { return r.of.other; }},
     stimulus_column,
     scale_column,
     {"people_one", "", "persons of the first answer who judged the stimulus",
      [](auto& r) { return r.of.people_one; }},
     {"mean_one", "scale points", "mean of their own means", [](auto& r) { return r.of.mean_one; }},
     {"people_other", "", "persons of the other answer", [](auto& r) { return r.of.people_other; }},
     {"mean_other", "scale points", "mean of theirs", [](auto& r) { return r.of.mean_other; }},
     {"difference", "scale points", "first less other", [](auto& r) { return r.of.welch.mean; }},
     {"low", "scale points", "lower end of its 95 % interval (Welch)",
      [](auto& r) { return r.of.welch.low(0.95); }},
     {"high", "scale points", "upper end", [](auto& r) { return r.of.welch.high(0.95); }},
     {"t", "", "Welch's t", [](auto& r) { return r.of.welch.t; }},
     {"df", "", "its degrees of freedom", [](auto& r) { return r.of.welch.degrees; }},
     {"p", "", "two-sided p; empty where nothing varies",
      [](auto& r) { return p_of_table(r.of.welch.p); }},
     adjusted_column,
     {"hedges_g", "", "difference in units of the pooled standard deviation, without bias",
      [](auto& r) { return r.of.g; }}});

}  // namespace

void add_comparisons(const Results& results, std::vector<WrittenTable>& tables) {
  add_results(comparison_columns, results.comparisons, results.gathered, tables);
  add_results(overall_columns, results.overall, results.gathered, tables);
  add_results(group_columns, results.groups, results.gathered, tables);
}

}  // namespace mien::pipeline
