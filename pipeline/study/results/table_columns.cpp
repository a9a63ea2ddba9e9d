#include "pipeline/study/results/table_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mien::pipeline {

namespace {

constexpr Column stimulus_column = {"stimulus", "", "stimulus id"};
constexpr Column made_column = {"made", "", "level of factor made: acted, modified or as-is"};
constexpr Column emotion_column = {"emotion", "", "level of factor emotion"};
constexpr Column setting_column = {
    "setting", "", "levels of the other factors; comparisons are made within a setting"};
constexpr Column scale_column = {"scale", "", "scale id"};
constexpr Column item_column = {"item", "", "scale or question id"};
constexpr Column adjusted_column = {
    "p_adjusted", "", "p corrected for multiple comparisons over the rows of the same kind"};

constexpr std::array means_columns = {
    stimulus_column,
    made_column,
    emotion_column,
    setting_column,
    scale_column,
    Column{"answers", "", "number of answers"},
    Column{"mean", "scale points", "mean rating; positive towards the high pole of the scale"},
    Column{"sd", "scale points", "standard deviation (n − 1)"},
    Column{"low", "scale points", "lower end of the 95 % interval of the mean (Student)"},
    Column{"high", "scale points", "upper end of that interval"},
    Column{"median", "scale points", "median rating"}};

constexpr std::array histogram_columns = {
    stimulus_column, scale_column, Column{"value", "scale points", "position on the scale"},
    Column{"answers", "", "number of answers at that position"},
    Column{"share", "0–1", "proportion of the answers about the stimulus on this scale"}};

constexpr Column all_alike_column = {"all_alike", "",
                                     "1 if all differences are equal, so that there is no t test"};

/// Of the tests within persons.
constexpr std::array within_columns = {
    Column{"paired_difference", "scale points", "mean within-participant difference"},
    Column{"paired_low", "scale points", "lower end of its 95 % interval"},
    Column{"paired_high", "scale points", "upper end"},
    Column{"paired_t", "", "paired t statistic"},
    Column{"paired_df", "", "degrees of freedom"},
    Column{"paired_p", "", "two-sided p; empty if all differences are equal"},
    Column{"paired_p_adjusted", "", "p corrected within the family"},
    Column{"cohens_dz", "",
           "Cohen's d_z: mean difference divided by the standard deviation of the differences"},
    Column{"hedges_gz", "", "the same with Hedges' bias correction"},
    Column{"wilcoxon_v", "", "sum of the ranks of positive differences, zeros excluded"},
    Column{"wilcoxon_n", "", "number of nonzero differences"},
    Column{"wilcoxon_zeros", "", "number of zero differences"},
    Column{"wilcoxon_tied", "", "number of tied differences"},
    Column{"wilcoxon_p", "", "two-sided p, exact, conditional on ties; zeros excluded"},
    Column{"wilcoxon_p_adjusted", "", "p corrected within the family"},
    Column{"wilcoxon_p_normal", "",
           "two-sided p, normal approximation without continuity correction"},
    Column{"wilcoxon_p_normal_corrected", "",
           "two-sided p, normal approximation with continuity correction"},
    Column{"pratt_v", "", "as wilcoxon_v, with zeros ranked together with the others (Pratt)"},
    Column{"pratt_p", "", "two-sided p, exact, of Pratt's ranks"},
    Column{
        "zsplit_p", "",
        "two-sided p, normal approximation, with the zeros' ranks split equally between the signs"},
    Column{"hodges_lehmann", "scale points",
           "Hodges–Lehmann estimate: median of all pairwise means of the differences"},
    Column{"hodges_lehmann_low", "scale points", "lower end of its 95 % interval"},
    Column{"hodges_lehmann_high", "scale points", "upper end"},
    Column{"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation, zeros excluded"},
    all_alike_column};

template <std::size_t First, std::size_t Second>
constexpr std::array<Column, First + Second> joined(const std::array<Column, First>& first,
                                                    const std::array<Column, Second>& second) {
  std::array<Column, First + Second> both{};
  std::ranges::copy(first, both.begin());
  std::ranges::copy(second, both.begin() + First);
  return both;
}

constexpr auto comparison_columns = joined(
    std::array{
        Column{
            "family", "",
            "best-seen (a video with all videos of its setting), modified-acted, modified-neutral, "
            "acted-neutral, modified-best (with the unmodified video of the setting rated highest "
            "for the emotion) or between-levels (stimuli that differ in one factor only, such as "
            "the actor); p values are corrected within a family (except for best-seen, separately "
            "on the intended emotion's scale and on the other scales)"},
        stimulus_column,
        made_column,
        emotion_column,
        setting_column,
        Column{"against", "", "stimulus it is compared with; empty: all of the setting"},
        Column{"factor", "", "for between-levels: the factor in which the two stimuli differ"},
        scale_column,
        Column{"own_end", "", "the pole of the scale that is the intended emotion, if any"},
        Column{"answers", "", "number of answers about the stimulus"},
        Column{"mean", "scale points", "mean of those answers"},
        Column{"answers_against", "", "number of answers about the stimuli it is compared with"},
        Column{"mean_against", "scale points", "mean of those answers"},
        Column{"welch_difference", "scale points",
               "difference of the two means, treating all answers as independent (best-seen: the "
               "test of the thesis, in which the video itself is among those it is compared with)"},
        Column{"welch_low", "scale points", "lower end of its 95 % interval"},
        Column{"welch_high", "scale points", "upper end"},
        Column{"welch_t", "", "Welch's t"},
        Column{"welch_df", "", "degrees of freedom"},
        Column{"welch_p", "", "two-sided p"},
        Column{"welch_p_adjusted", "", "p corrected within the family"},
        Column{"cohens_d", "", "Cohen's d: difference divided by the pooled standard deviation"},
        Column{"hedges_g", "", "the same with Hedges' bias correction"},
        Column{"people", "",
               "participants who saw both (best-seen: the video and another of its setting)"}},
    within_columns);

constexpr auto overall_columns = joined(
    std::array{
        Column{"family", "", "modified-acted, modified-neutral or acted-neutral"},
        Column{"emotion", "", "intended emotion; empty: all"},
        Column{"matched", "",
               "number of settings and emotions, over all participants, of which both sides were "
               "judged; only these are compared"},
        Column{"unmatched_people", "",
               "participants who judged both sides, but never for the same setting and emotion; "
               "excluded"},
        Column{"mean", "scale points",
               "mean over participants of the rating of the intended emotion, from the middle of "
               "its scale"},
        Column{"mean_against", "scale points", "the same for the stimuli it is compared with"},
        Column{"people", "", "participants who judged both sides of a setting and emotion"}},
    within_columns);

constexpr std::array group_columns = {
    Column{"question", "", "demographic question; its two most frequent answers are compared"},
    Column{"one", "", "first answer compared"},
    Column{"other", "", "second answer compared"},
    stimulus_column,
    scale_column,
    Column{"people_one", "", "participants with the first answer who judged the stimulus"},
    Column{"mean_one", "scale points", "mean of these participants' means"},
    Column{"people_other", "", "participants with the second answer who judged the stimulus"},
    Column{"mean_other", "scale points", "mean of these participants' means"},
    Column{"difference", "scale points", "first minus second"},
    Column{"low", "scale points", "lower end of its 95 % interval (Welch)"},
    Column{"high", "scale points", "upper end"},
    Column{"t", "", "Welch's t"},
    Column{"df", "", "degrees of freedom"},
    Column{"p", "", "two-sided p; empty if there is no variance"},
    adjusted_column,
    Column{"hedges_g", "",
           "Hedges' g: difference divided by the pooled standard deviation, bias-corrected"}};

constexpr Column by_column = {"by", "", "ratings (points rule) or choices"};
constexpr Column of_column = {"of", "", "level of factor made that the rows cover, or all"};
constexpr Column shown_column = {"shown", "", "intended emotion"};

constexpr std::array confusion_columns = {
    by_column,
    of_column,
    shown_column,
    Column{"seen", "", "perceived emotion"},
    Column{"points", "",
           "points: 2 for a rating at the end of a scale, 1 halfway, in proportion; for choices, "
           "their number"},
    Column{"share", "0–1", "proportion of the row's points"}};

constexpr std::array recall_columns = {
    by_column,
    of_column,
    shown_column,
    Column{"showings", "", "presentations of such stimuli"},
    Column{"judged", "", "presentations that received any points"},
    Column{"points", "", "total points of the row"},
    Column{"recall", "0–1", "proportion of the points on the intended emotion"},
    Column{"low", "0–1",
           "lower end of the 95 % Wilson interval, with each judged presentation as one trial"},
    Column{"high", "0–1", "upper end"},
    Column{"chance", "0–1", "1 / number of emotions that could be perceived"},
    Column{"hits", "", "presentations in which the intended emotion received the most points"},
    Column{"p", "", "exact two-sided binomial test of hits among judged against chance"},
    adjusted_column};

constexpr std::array correlation_columns = {
    Column{"one", "", "end of a scale"},
    Column{"other", "", "end of a scale"},
    Column{"same_scale", "",
           "1 for the two ends of the same scale, which are negatively correlated by construction"},
    Column{"showings", "", "judgements in which both scales were answered"},
    Column{"r", "-1–1", "Pearson's correlation of max(-a, 0) and max(a, 0)"},
    Column{"low", "-1–1", "lower end of its 95 % interval (Fisher's z)"},
    Column{"high", "-1–1", "upper end"},
    Column{"p", "", "two-sided p, treating all judgements as independent"},
    adjusted_column};

constexpr std::array agreement_columns = {
    scale_column,
    Column{"stimuli", "", "number of rated stimuli"},
    Column{"people", "", "number of raters"},
    Column{"answers", "", "answers"},
    Column{"answers_per_stimulus", "",
           "mean number of ratings per stimulus: k of the average-measures ICCs"},
    Column{"icc_1", "", "ICC(1): one-way, single rating"},
    Column{"icc_1_k", "", "ICC(1,k): one-way, mean of k ratings"},
    Column{"icc_2", "", "ICC(2,1): agreement, raters random"},
    Column{"icc_2_k", "", "ICC(2,k)"},
    Column{"icc_3", "", "ICC(3,1): consistency, raters fixed"},
    Column{"icc_3_k", "", "ICC(3,k)"},
    Column{"complete_people", "", "participants who rated every stimulus"},
    Column{"alpha", "", "Cronbach's alpha over these participants, with participants as items"}};

constexpr std::array preference_columns = {
    item_column,
    Column{"one", "", "stimulus"},
    Column{"other", "", "stimulus it was shown with"},
    Column{"trials", "", "number of presentations of the pair"},
    Column{"for_one", "", "number of choices of the first stimulus"},
    Column{"share", "0–1", "proportion of choices of the first stimulus"},
    Column{"low", "0–1", "lower end of Wilson's 95 % interval"},
    Column{"high", "0–1", "upper end"},
    Column{"p", "", "exact binomial test against one half, two-sided"},
    adjusted_column};

constexpr Column excluded_column = {"excluded", "",
                                    "1 for participants excluded by the report's rule"};

constexpr std::array people_columns = {
    Column{"participant", "", "participant id"},
    Column{"trials", "", "trials completed, including practice and checks"},
    Column{"answers", "", "answers analysed, unless the participant is excluded"},
    Column{"checks", "", "attention checks"},
    Column{"passed", "", "attention checks passed"},
    excluded_column,
    Column{"median_rt_ms", "ms", "median response time"},
    Column{"stalls", "", "buffering interruptions"},
    Column{"dropped_frames", "", "dropped video frames"},
    Column{"blurs", "", "tab switches"},
    Column{"constant", "", "1 for straight-lining: all answers at the same position; included"},
    Column{"unfinished", "", "1 if the participant answered fewer trials than planned"}};

constexpr std::array catch_columns = {
    Column{"participant", "", "participant id"},
    excluded_column,
    stimulus_column,
    Column{"against", "", "the other stimulus of a pair, or the reference shown beside it"},
    item_column,
    Column{"first_trial", "", "number of the first trial, which is analysed"},
    Column{"second_trial", "", "number of the repeated trial, which is not analysed"},
    Column{"first", "scale points",
           "first answer, which is analysed; for choices, pairs and words the answer itself"},
    Column{"second", "scale points", "answer in the repeated trial"},
    Column{"difference", "scale points", "second minus first; ratings only"},
    Column{"equal", "", "1 if both answers are the same"}};

constexpr std::array catch_summary_columns = {
    Column{"participant", "", "participant id; empty: all participants analysed"},
    Column{"item", "", "scale or question id; empty: all"},
    excluded_column,
    Column{"answers", "", "number of repeated questions"},
    Column{"equal", "", "number of identical answers"},
    Column{"share_equal", "0–1", "proportion of identical answers"},
    Column{"mean_absolute_difference", "scale points",
           "mean absolute difference between second and first rating"},
    Column{"retest_r", "-1–1",
           "test–retest correlation (Pearson) of first with second ratings; empty if either has no "
           "variance"},
    Column{"retest_low", "-1–1", "lower end of its 95 % interval (Fisher's z)"},
    Column{"retest_high", "-1–1", "upper end"}};

constexpr std::array demographics_columns = {
    Column{"question", "", "question id"},
    Column{"answer", "", "the answer, or for numbers the statistic"},
    Column{"value", "",
           "number of participants who gave this answer, or the value of the statistic"},
    Column{"people", "", "participants who answered the question"}};

constexpr std::array remark_columns = {Column{"participant", "", "participant id"}, stimulus_column,
                                       item_column, Column{"text", "", "text as written"}};

constexpr std::array word_count_columns = {
    stimulus_column, item_column,
    Column{"word", "", "a word; answers are split at commas, semicolons and line ends"},
    Column{"people", "", "number of participants who gave it"},
    Column{"asked", "", "number of participants who gave any word for the stimulus"}};

}  // namespace

const TableForm means_form = {"results/means.csv", "stimulus and scale", means_columns};
const TableForm histograms_form = {"results/histograms.csv",
                                   "stimulus, scale and position on the scale", histogram_columns};
const TableForm comparisons_form = {"results/comparisons.csv", "comparison", comparison_columns};
const TableForm overall_form = {"results/overall.csv", "comparison over all settings",
                                overall_columns};
const TableForm groups_form = {"results/groups.csv", "stimulus, scale and pair of groups",
                               group_columns};
const TableForm confusion_form = {"results/confusion.csv", "cell of a confusion matrix",
                                  confusion_columns};
const TableForm recall_form = {"results/recall.csv", "intended emotion", recall_columns};
const TableForm correlations_form = {"results/correlations.csv", "pair of scale ends",
                                     correlation_columns};
const TableForm agreement_form = {"results/agreement.csv", "scale", agreement_columns};
const TableForm preferences_form = {"results/preferences.csv", "pair of stimuli",
                                    preference_columns};
const TableForm people_form = {"results/sessions.csv", "participant", people_columns};
const TableForm catch_form = {"results/catch_trials.csv", "repeated question", catch_columns};
const TableForm catch_summary_form = {"results/catch_summary.csv",
                                      "participant and question, and over all of them",
                                      catch_summary_columns};
const TableForm demographics_form = {"results/demographics.csv", "question and answer",
                                     demographics_columns};
const TableForm comments_form = {"results/comments.csv", "comment", remark_columns};
const TableForm words_form = {"results/words.csv", "free-text answer", remark_columns};
const TableForm word_counts_form = {"results/word_counts.csv", "stimulus and word",
                                    word_count_columns};

}  // namespace mien::pipeline
