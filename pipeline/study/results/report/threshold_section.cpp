#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

bool is_quest(const Results& results) {
  return results.answer_set.thresholds->procedure.method == AdaptiveMethod::quest;
}

std::string threshold_method(const Results& results) {
  const ThresholdDesign& design = *results.answer_set.thresholds;
  const std::string guess = results.answer_set.form == &two_interval_form
                                ? "a guess rate of 0.5"
                                : "a guess rate estimated between 0 and 0.5";
  return fmt::format(
      "The level of {} in each trial was chosen by the answers so far ({}). A logistic "
      "psychometric function with {} and a lapse rate estimated between 0 and 0.06 is fitted to "
      "all answers by maximum likelihood (Wichmann and Hill 2001). The threshold is the level at "
      "which it gives {} of positive answers (right, yes or different), and the slope the change "
      "of the proportion per unit at the threshold, towards easier levels. Intervals (95 %): "
      "parametric bootstrap, 999 resamples. They treat answers as independent, and levels as "
      "chosen in advance; that of “all answers” is too narrow if participants differ. p is the "
      "probability of a deviance at least as large if the function is right.",
      design.factor, is_quest(results) ? "QUEST+, Watson 2017" : "staircase, Levitt 1971", guess,
      percent_text(design.proportion));
}

std::string track_method(const Results& results) {
  if (is_quest(results))
    return "QUEST+: mean of the posterior distribution of the threshold, with its 95 % credible "
           "interval, from the answers of a participant’s tracks and equal prior probabilities.";
  return "Reversals: mean over a participant’s tracks of the mean level of the reversals after the "
         "first two. It estimates the level to which the staircase converges, whatever the "
         "proportion of the threshold.";
}

std::string group_text(const GroupThreshold& group) {
  const std::string_view kind = group.estimate;
  return fmt::format(
      "Mean threshold of {} of {} participants{}: {}, standard deviation {}, 95 % interval of the "
      "mean {} (Student; participants are independent).{}",
      group.people, group.all,
      kind == "fit"     ? ""
      : kind == "quest" ? " by QUEST+"
                        : " by reversals",
      decimal(group.mean, 3), decimal(group.deviation, 3),
      interval_text(group.ends.low, group.ends.high, 3),
      group.people < group.all
          ? " The answers of the others do not determine one: the mean is not of all participants."
          : "");
}

std::string estimate_cell(const Results& results, const ThresholdEstimate& one) {
  if (!is_quest(results)) return decimal(one.reversal_mean, 3);
  return std::isnan(one.quest_mean) ? decimal(one.quest_mean)
                                    : decimal(one.quest_mean, 3) + " " +
                                          interval_text(one.quest_ends.low, one.quest_ends.high, 3);
}

std::string thresholds_html(const Results& results) {
  std::string rows;
  for (const ThresholdEstimate& one : results.thresholds.estimates) {
    const PsychometricFunction& function = one.fit.function;
    rows += HtmlRow()
                .text(one.person ? results.answer_set.people[*one.person] : "all answers")
                .number(one.trials(), decimal(one.threshold, 3),
                        interval_text(one.threshold_ends.low, one.threshold_ends.high, 3),
                        decimal(one.slope), interval_text(one.slope_ends.low, one.slope_ends.high),
                        decimal(function.guess), decimal(function.lapse), decimal(one.fit.deviance),
                        p_text(one.deviance_p), estimate_cell(results, one))
                .text(threshold_remark(one))
                .html();
  }
  return wide_table(
      {"<participant", "answers", "threshold", "95 % interval", "slope", "95 % interval", "guess",
       "lapse", "deviance", "p", is_quest(results) ? "QUEST+" : "reversals", "<remark"},
      rows);
}

}  // namespace

std::string threshold_section_html(const Results& results, const std::string& figures) {
  const ThresholdResults& found = results.thresholds;
  if (found.estimates.empty()) return "";
  std::string html = html_paragraph(threshold_method(results)) + figures;
  for (const GroupThreshold& group : found.groups)
    if (group.people > 1) html += html_paragraph(group_text(group));
  return html + html_paragraph(track_method(results)) + thresholds_html(results);
}

}  // namespace mien::pipeline
