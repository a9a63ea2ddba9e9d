#include "pipeline/study/results/table_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mien::pipeline {

namespace {

constexpr Column stimulus_column = {"stimulus", "", "the stimulus"};
constexpr Column made_column = {"made", "", "level of the factor made: acted, modified, as-is"};
constexpr Column emotion_column = {"emotion", "", "level of the factor emotion"};
constexpr Column setting_column = {"setting", "",
                                   "levels of the other factors, within which is compared"};
constexpr Column scale_column = {"scale", "", "the scale"};
constexpr Column item_column = {"item", "", "the scale or question"};
constexpr Column adjusted_column = {"p_adjusted", "",
                                    "p corrected for the number of rows of its kind"};

constexpr std::array means_columns = {
    stimulus_column,
    made_column,
    emotion_column,
    setting_column,
    scale_column,
    Column{"answers", "", "number of answers"},
    Column{"mean", "scale points", "mean answer; the high pole of the scale is positive"},
    Column{"sd", "scale points", "standard deviation, n - 1"},
    Column{"low", "scale points", "lower end of the 95 % interval of the mean (Student)"},
    Column{"high", "scale points", "its upper end"},
    Column{"median", "scale points", "median answer"}};

constexpr std::array histogram_columns = {
    stimulus_column, scale_column, Column{"value", "scale points", "place on the scale"},
    Column{"answers", "", "number of answers there"},
    Column{"share", "0–1", "share of the answers about the stimulus on this scale"}};

constexpr Column all_alike_column = {
    "all_alike", "", "1 where all differences are the same, so that there is no t test"};

/// Of the tests within persons.
constexpr std::array within_columns = {
    Column{"paired_difference", "scale points", "mean of their own differences"},
    Column{"paired_low", "scale points", "lower end of its 95 % interval"},
    Column{"paired_high", "scale points", "upper end"},
    Column{"paired_t", "", "t of the differences"},
    Column{"paired_df", "", "its degrees of freedom"},
    Column{"paired_p", "", "two-sided p; empty where all differences are alike"},
    Column{"paired_p_adjusted", "", "p corrected within the family"},
    Column{"cohens_dz", "", "mean difference in units of the differences' standard deviation"},
    Column{"hedges_gz", "", "the same without bias"},
    Column{"wilcoxon_v", "", "sum of the ranks of the positive differences, zeros left out"},
    Column{"wilcoxon_n", "", "differences that are not 0"},
    Column{"wilcoxon_zeros", "", "differences that are 0"},
    Column{"wilcoxon_tied", "", "differences that share their size with another"},
    Column{"wilcoxon_p", "", "two-sided, exact, conditional on ties; zeros left out"},
    Column{"wilcoxon_p_adjusted", "", "p corrected within the family"},
    Column{"wilcoxon_p_normal", "", "normal approximation without continuity correction"},
    Column{"wilcoxon_p_normal_corrected", "", "normal approximation with continuity correction"},
    Column{"pratt_v", "", "as wilcoxon_v, zeros ranked with the others (Pratt)"},
    Column{"pratt_p", "", "two-sided, exact, of Pratt's ranks"},
    Column{"zsplit_p", "", "normal approximation, half of the zeros' ranks on either side"},
    Column{"hodges_lehmann", "scale points", "median of the means of any two differences"},
    Column{"hodges_lehmann_low", "scale points", "lower end of its 95 % interval"},
    Column{"hodges_lehmann_high", "scale points", "upper end"},
    Column{"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation, zeros left out"},
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
            "acted-neutral, modified-best (with the video of the setting, itself not modified, in "
            "which the emotion is seen most) or between-levels (what differs in one factor alone: "
            "two actors); p values are corrected within a family (but for best-seen: comparisons "
            "on the scale of the emotion that was meant by themselves, and those on other "
            "scales)"},
        stimulus_column,
        made_column,
        emotion_column,
        setting_column,
        Column{"against", "", "the stimulus it is compared with; empty: all of the setting"},
        Column{"factor", "", "of between-levels: the factor in whose level the two differ"},
        scale_column,
        Column{"own_end", "", "the pole of the scale that is the emotion of the stimulus, if any"},
        Column{"answers", "", "answers about the stimulus"},
        Column{"mean", "scale points", "their mean"},
        Column{"answers_against", "", "answers about what it is compared with"},
        Column{"mean_against", "scale points", "their mean"},
        Column{"welch_difference", "scale points",
               "difference of the two means, all answers as if independent (best-seen: the test of "
               "the thesis, in which the video is one of those it is compared with)"},
        Column{"welch_low", "scale points", "lower end of its 95 % interval"},
        Column{"welch_high", "scale points", "upper end"},
        Column{"welch_t", "", "Welch's t"},
        Column{"welch_df", "", "its degrees of freedom"},
        Column{"welch_p", "", "two-sided p"},
        Column{"welch_p_adjusted", "", "p corrected within the family"},
        Column{"cohens_d", "", "difference in units of the pooled standard deviation"},
        Column{"hedges_g", "", "the same without bias"},
        Column{"people", "",
               "persons who saw both (best-seen: the video and another of its setting)"}},
    within_columns);

constexpr auto overall_columns = joined(
    std::array{
        Column{"family", "", "modified-acted, modified-neutral or acted-neutral"},
        Column{"emotion", "", "the emotion that was meant; empty: all"},
        Column{"matched", "",
               "settings and emotions of all people of which both sides were judged: these alone "
               "are compared"},
        Column{"unmatched_people", "",
               "people who judged both sides, but never of one setting and emotion; left out"},
        Column{
            "mean", "scale points",
            "mean over the people of how far they saw the emotion that was meant, from the middle "
            "of its scale"},
        Column{"mean_against", "scale points", "the same, of what it is compared with"},
        Column{"people", "", "persons who saw both sides of a setting and emotion"}},
    within_columns);

constexpr std::array group_columns = {
    Column{"question", "", "about the participants; the two answers that most gave are compared"},
    Column{"one", "", "an answer"},
    Column{"other", "", "another answer"},
    stimulus_column,
    scale_column,
    Column{"people_one", "", "persons of the first answer who judged the stimulus"},
    Column{"mean_one", "scale points", "mean of their own means"},
    Column{"people_other", "", "persons of the other answer"},
    Column{"mean_other", "scale points", "mean of theirs"},
    Column{"difference", "scale points", "first less other"},
    Column{"low", "scale points", "lower end of its 95 % interval (Welch)"},
    Column{"high", "scale points", "upper end"},
    Column{"t", "", "Welch's t"},
    Column{"df", "", "its degrees of freedom"},
    Column{"p", "", "two-sided p; empty where nothing varies"},
    adjusted_column,
    Column{"hedges_g", "", "difference in units of the pooled standard deviation, without bias"}};

constexpr Column by_column = {"by", "", "ratings (points rule) or choices"};
constexpr Column of_column = {"of", "", "level of the factor made that the rows are of, or all"};
constexpr Column shown_column = {"shown", "", "emotion that was shown"};

constexpr std::array confusion_columns = {
    by_column,
    of_column,
    shown_column,
    Column{"seen", "", "emotion that was seen"},
    Column{"points", "",
           "points: 2 for an answer at the end of a scale, 1 half way, in proportion; of choices "
           "their number"},
    Column{"share", "0–1", "share of the row's points"}};

constexpr std::array recall_columns = {
    by_column,
    of_column,
    shown_column,
    Column{"showings", "", "times that somebody judged such a stimulus"},
    Column{"judged", "", "of these, those that got any points"},
    Column{"points", "", "all points of the row"},
    Column{"recall", "0–1", "share of the points at the emotion itself"},
    Column{"low", "0–1", "lower end of Wilson's 95 % interval, a judged showing being one trial"},
    Column{"high", "0–1", "upper end"},
    Column{"chance", "0–1", "one of the emotions that can be seen"},
    Column{"hits", "", "showings in which the emotion itself got the most points"},
    Column{"p", "", "exact binomial test of the hits among the judged against chance, two-sided"},
    adjusted_column};

constexpr std::array correlation_columns = {
    Column{"one", "", "end of a scale"},
    Column{"other", "", "end of a scale"},
    Column{"same_scale", "", "1 for the two ends of one scale, negative by their making"},
    Column{"showings", "", "judgements in which both scales were answered"},
    Column{"r", "-1–1", "Pearson's correlation of max(-a, 0) and max(a, 0)"},
    Column{"low", "-1–1", "lower end of its 95 % interval (Fisher's z)"},
    Column{"high", "-1–1", "upper end"},
    Column{"p", "", "two-sided p, all judgements as if independent"},
    adjusted_column};

constexpr std::array agreement_columns = {
    scale_column,
    Column{"stimuli", "", "stimuli that were rated"},
    Column{"people", "", "persons who rated"},
    Column{"answers", "", "answers"},
    Column{"answers_per_stimulus", "", "the k of the ICCs of means"},
    Column{"icc_1", "", "ICC(1): reliability of one answer, one-way"},
    Column{"icc_1_k", "", "ICC(1,k): of the mean of k answers"},
    Column{"icc_2", "", "ICC(2,1): agreement, persons a random sample"},
    Column{"icc_2_k", "", "ICC(2,k)"},
    Column{"icc_3", "", "ICC(3,1): consistency of these persons"},
    Column{"icc_3_k", "", "ICC(3,k)"},
    Column{"complete_people", "", "persons who rated every stimulus"},
    Column{"alpha", "", "Cronbach's alpha of these, persons as items"}};

constexpr std::array preference_columns = {
    item_column,
    Column{"one", "", "a stimulus"},
    Column{"other", "", "the one it was shown with"},
    Column{"trials", "", "times that they were shown together"},
    Column{"for_one", "", "times that the first was chosen"},
    Column{"share", "0–1", "share of the first"},
    Column{"low", "0–1", "lower end of Wilson's 95 % interval"},
    Column{"high", "0–1", "upper end"},
    Column{"p", "", "exact binomial test against one half, two-sided"},
    adjusted_column};

constexpr Column excluded_column = {"excluded", "",
                                    "1 for who is left out, by the rule of the report"};

constexpr std::array people_columns = {
    Column{"participant", "", "who answered"},
    Column{"trials", "", "trials done, practice and checks among them"},
    Column{"answers", "", "answers that are analysed, unless the participant is excluded"},
    Column{"checks", "", "attention checks"},
    Column{"passed", "", "of these passed"},
    excluded_column,
    Column{"median_rt_ms", "ms", "median time of an answer"},
    Column{"stalls", "", "times that a video stopped for want of data"},
    Column{"dropped_frames", "", "frames that were not shown"},
    Column{"blurs", "", "times that the window was left"},
    Column{"constant", "", "1 for who answered everything at the same place; kept"},
    Column{"unfinished", "", "1 for who answered fewer trials than were planned"}};

constexpr std::array catch_columns = {
    Column{"participant", "", "who answered twice"},
    excluded_column,
    stimulus_column,
    Column{"against", "", "the other one of a pair, or the reference beside"},
    item_column,
    Column{"first_trial", "", "number of the trial that counts"},
    Column{"second_trial", "", "number of the catch trial, which does not count"},
    Column{"first", "scale points", "answer that counts; of choices, pairs and words what it was"},
    Column{"second", "scale points", "answer of the catch trial"},
    Column{"difference", "scale points", "second less first; of ratings alone"},
    Column{"equal", "", "1 where both are the same"}};

constexpr std::array catch_summary_columns = {
    Column{"participant", "", "whose answers; empty: of all who count"},
    Column{"item", "", "the scale or question; empty: all"},
    excluded_column,
    Column{"answers", "", "questions answered twice"},
    Column{"equal", "", "of these the same both times"},
    Column{"share_equal", "0–1", "their share"},
    Column{"mean_absolute_difference", "scale points", "mean size of second less first"},
    Column{"retest_r", "-1–1",
           "test-retest correlation: Pearson's of first with second ratings; empty where one of "
           "them does not vary"},
    Column{"retest_low", "-1–1", "lower end of its 95 % interval (Fisher's z)"},
    Column{"retest_high", "-1–1", "upper end"}};

constexpr std::array demographics_columns = {
    Column{"question", "", "the question"},
    Column{"answer", "", "a word, or which number of numbers"},
    Column{"value", "", "how many gave it, or the number"},
    Column{"people", "", "who answered the question"}};

constexpr std::array remark_columns = {Column{"participant", "", "who wrote it"}, stimulus_column,
                                       item_column, Column{"text", "", "what was written"}};

constexpr std::array word_count_columns = {
    stimulus_column, item_column,
    Column{"word", "", "a word: answers are divided at commas, semicolons and ends of lines"},
    Column{"people", "", "who gave it"},
    Column{"asked", "", "who gave any word about the stimulus"}};

}  // namespace

const TableForm means_form = {"results/means.csv", "a stimulus on a scale", means_columns};
const TableForm histograms_form = {"results/histograms.csv", "a place on a scale of a stimulus",
                                   histogram_columns};
const TableForm comparisons_form = {"results/comparisons.csv", "a comparison", comparison_columns};
const TableForm overall_form = {"results/overall.csv", "a comparison over all settings",
                                overall_columns};
const TableForm groups_form = {"results/groups.csv", "a stimulus on a scale, by two groups",
                               group_columns};
const TableForm confusion_form = {"results/confusion.csv", "a cell of a confusion matrix",
                                  confusion_columns};
const TableForm recall_form = {"results/recall.csv", "an emotion that was shown", recall_columns};
const TableForm correlations_form = {"results/correlations.csv", "a pair of ends of scales",
                                     correlation_columns};
const TableForm agreement_form = {"results/agreement.csv", "a scale", agreement_columns};
const TableForm preferences_form = {"results/preferences.csv", "a pair of stimuli",
                                    preference_columns};
const TableForm people_form = {"results/sessions.csv", "a participant", people_columns};
const TableForm catch_form = {"results/catch_trials.csv", "a question answered twice",
                              catch_columns};
const TableForm catch_summary_form = {"results/catch_summary.csv", "some who answered twice",
                                      catch_summary_columns};
const TableForm demographics_form = {"results/demographics.csv", "an answer to a question",
                                     demographics_columns};
const TableForm comments_form = {"results/comments.csv", "a comment", remark_columns};
const TableForm words_form = {"results/words.csv", "an answer in words", remark_columns};
const TableForm word_counts_form = {"results/word_counts.csv", "a word for a stimulus",
                                    word_count_columns};

}  // namespace mien::pipeline
