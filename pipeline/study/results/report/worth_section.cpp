#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// Whether worths are of combinations of levels instead of stimuli.
bool compares_conditions(const Results& results) {
  return !results.answer_set.factorial.factors.empty();
}

std::string worth_rows(const AnswerSet& answer_set, const PairWorth& worth) {
  std::string rows;
  for (const StimulusWorth& one : worth.stimuli) {
    const Interval95 ends = worth.ends_of(one);
    rows += HtmlRow()
                .text(pair_question(answer_set, worth.item), one.name)
                .number(one.comparisons(), one.chosen, one.ties, one.worth,
                        interval_text(ends.low, ends.high), one.error,
                        interval_text(one.by_answers.low, one.by_answers.high),
                        fmt::format("{} (± {})", decimal(one.elo.mean, 0),
                                    decimal(one.elo.deviation, 0)))
                .text(std::isnan(one.worth) ? record_text(one) : fmt::format("group {}", one.group))
                .html();
  }
  return rows;
}

std::string worths_html(const Results& results) {
  std::string rows;
  for (const PairWorth& worth : results.worths) rows += worth_rows(results.answer_set, worth);
  return wide_table(
      {"<item", compares_conditions(results) ? "<condition" : "<stimulus", "comparisons", "chosen",
       "ties", "log-worth", "95 % interval", "standard error", "95 % interval, answers independent",
       "Elo (± SD over orders)", "<group, or why there is no worth"},
      rows);
}

std::string chi_text(const LikelihoodRatio& test) {
  return std::isnan(test.chi) ? "–" : fmt::format("{} ({})", decimal(test.chi), test.degrees);
}

/// By resampled participants or, as the intervals of the worths then are, for independent answers.
Interval95 order_interval(const PairWorth& worth) {
  if (worth.is_by_participants) return worth.order_ends;
  constexpr double normal = 1.959964;
  const double margin = normal * worth.fit.order_error;
  return {worth.fit.order - margin, worth.fit.order + margin};
}

std::string worth_tests_html(const Results& results) {
  std::string rows;
  for (const PairWorth& worth : results.worths)
    rows += HtmlRow()
                .text(pair_question(results.answer_set, worth.item))
                .number(worth.people, worth.comparisons, worth.ties, chi_text(worth.equal),
                        p_text(worth.equal.p), p_text(worth.equal_adjusted), worth.fit.order,
                        interval_text(order_interval(worth).low, order_interval(worth).high),
                        chi_text(worth.order), p_text(worth.order.p), p_text(worth.order_adjusted))
                .html(worth.equal_adjusted < results.answer_set.alpha);
  return wide_table(
      {"<item", "participants", "comparisons", "ties", "equal worth, χ² (df)", "p", "p, corrected",
       "order effect", "95 % interval", "order, χ² (df)", "p", "p, corrected"},
      rows);
}

std::string transitivity_html(const Results& results) {
  std::string rows;
  for (const PairWorth& worth : results.worths) {
    double zeta = 0.0;
    double circular = 0.0;
    for (const ParticipantTriads& one : worth.triads) {
      zeta += one.triads.zeta;
      circular += one.triads.circular;
    }
    const auto people = static_cast<double>(worth.triads.size());
    const TransitivityViolations& found = worth.transitivity;
    if (found.triads == 0) continue;
    rows += HtmlRow()
                .text(pair_question(results.answer_set, worth.item))
                .number(found.triads, found.weak, found.moderate, found.strong,
                        static_cast<int>(worth.triads.size()), circular / people,
                        worth.triads.empty() ? std::nan("") : worth.triads[0].triads.by_chance,
                        zeta / people)
                .html();
  }
  return wide_table({"<item", "triads", "violate weak", "violate moderate", "violate strong",
                     "participants with all pairs", "mean circular triads", "by chance", "mean ζ"},
                    rows);
}

std::string worth_contrasts_html(const Results& results, ContrastKind kind) {
  std::string rows;
  for (const PairWorth& worth : results.worths) {
    for (const WorthContrast& one : worth.contrasts) {
      if (one.kind != kind) continue;
      HtmlRow row;
      row.text(pair_question(results.answer_set, worth.item), one.name);
      if (kind == ContrastKind::planned) row.text(one.weights);
      rows += row.number(one.difference, interval_text(one.ends.low, one.ends.high), one.error,
                         std::isnan(one.degrees)
                             ? "z = " + decimal(one.statistic)
                             : fmt::format("t({:.0f}) = {}", one.degrees, decimal(one.statistic)),
                         p_text(one.p), p_text(one.adjusted))
                  .html(one.adjusted < results.answer_set.alpha);
    }
  }
  if (rows.empty()) return "";
  std::vector<std::string_view> columns = {"<item", "<contrast"};
  if (kind == ContrastKind::planned) columns.push_back("<weights");
  for (const char* column : {"difference in log-worth", "95 % interval", "standard error",
                             "statistic", "p", "p, corrected"})
    columns.push_back(column);
  return wide_table(columns, rows);
}

std::string why_not_by_participants(const PairWorth& worth) {
  if (worth.people < fewest_resampled_people)
    return fmt::format("there are fewer than {} participants", fewest_resampled_people);
  return worth.resamples == 0 ? "there are several groups of stimuli"
                              : "too many resamples of participants have no finite worths";
}

/// A sentence on each item whose worths are not all finite, or not reported as the others are.
std::vector<std::string> worth_remarks(const Results& results) {
  std::vector<std::string> remarks;
  for (const PairWorth& worth : results.worths) {
    const std::string question = pair_question(results.answer_set, worth.item);
    const auto without = std::ranges::count_if(
        worth.stimuli, [](const StimulusWorth& one) { return std::isnan(one.worth); });
    if (without > 0)
      remarks.push_back(fmt::format(
          "{}: {} of {} have no finite worth. No number can be given for a stimulus that was "
          "always or never chosen, or if the answers do not determine the model.",
          question, without, counted_noun(worth.stimuli.size(), "stimulus", "stimuli")));
    if (!worth.is_by_participants && without < std::ssize(worth.stimuli))
      remarks.push_back(fmt::format(
          "{}: {}, because {}.", question,
          worth.has_intervals() ? "the intervals treat all answers as independent" : "no intervals",
          why_not_by_participants(worth)));
    if (worth.within_conditions > 0)
      remarks.push_back(fmt::format("{}: {} of two stimuli of the same condition {} not used.",
                                    question,
                                    counted_noun(static_cast<std::size_t>(worth.within_conditions),
                                                 "further comparison", "further comparisons"),
                                    worth.within_conditions == 1 ? "is" : "are"));
    if (!worth.has_order)
      remarks.push_back(
          fmt::format("{}: an order effect cannot be determined from these answers and is not "
                      "part of the model.",
                      question));
  }
  return remarks;
}

/// What a condition is, if worths are of conditions.
std::string conditions_paragraph(const Results& results) {
  if (!compares_conditions(results)) return "";
  return html_paragraph(fmt::format(
      "The stimuli are compared by their levels of {}: answers about all stimuli with the same "
      "levels (a condition) are counted together.",
      fmt::join(results.answer_set.factorial.factors, " and ")));
}

constexpr char difference_method[] =
    "Differences are sums of log-worths times their weights; those of planned contrasts are "
    "averaged "
    "over the combinations of the other factors’ levels in which all compared levels were "
    "compared. "
    "Intervals, standard errors and p (Student’s t with one degree of freedom less than there are "
    "participants) come from the resampled participants, or, with z, treat all answers as "
    "independent. p values are corrected over all planned contrasts, and over all pairs, on all "
    "scales.";

std::string differences_html(const Results& results) {
  const std::string planned = worth_contrasts_html(results, ContrastKind::planned);
  const std::string pairs = worth_contrasts_html(results, ContrastKind::pairwise);
  if (planned.empty() && pairs.empty()) return "";
  std::string html = "<h3>Differences in log-worth</h3>\n" + html_paragraph(difference_method);
  if (!planned.empty()) html += "<h4>Planned contrasts</h4>\n" + planned;
  return html + closed_table(compares_conditions(results) ? "All pairs of conditions"
                                                          : "All pairs of stimuli",
                             pairs);
}

std::string scores_html(const Results& results) {
  std::string rows;
  for (const BestWorstScore& one : results.best_worst)
    rows += HtmlRow()
                .text(pair_question(results.answer_set, one.scale),
                      results.answer_set.stimuli[one.stimulus].id)
                .number(one.shown, one.best, one.worst, one.score(),
                        interval_text(one.ends.low, one.ends.high), one.people)
                .html();
  return wide_table(
      {"<item", "<stimulus", "sets", "best", "worst", "score", "95 % interval", "participants"},
      rows);
}

/// The worths without what holds for comparisons of pairs only.
std::string set_section_html(const Results& results, const std::string& figures) {
  return html_paragraph(
             "Best–worst scaling: of each set of stimuli, participants chose the one that is "
             "closest to the high end of the scale (best) and the one that is closest to the low "
             "end (worst). Score: the number of times that a stimulus was best less the number of "
             "times that it was worst, divided by the number of sets with it, from −1 to 1; its "
             "interval is that of the mean of the participants’ scores (Student).") +
         scores_html(results) +
         html_paragraph(
             "Log-worths by the model of Bradley and Terry with an order effect, from the "
             "comparisons that the answers imply: the best of a set is preferred to all others, "
             "and all others to the worst. This is an approximation of the maximum-difference "
             "model. A difference of 1 in log-worth means odds of e to 1 of being chosen; "
             "log-worths have a sum of 0. Implied comparisons of one set depend on each other; "
             "intervals are therefore those of resampled participants with all of their answers "
             "(bootstrap percentiles), and tests of equal worth and of transitivity are not given. "
             "Standard errors and the second intervals treat implied comparisons as independent, "
             "so that they are too small. Elo ratings are averaged over random orders and have no "
             "intervals.") +
         html_list("warnings", worth_remarks(results)) + figures + worths_html(results) +
         differences_html(results);
}

}  // namespace

std::string worth_section_html(const Results& results, const std::string& figures) {
  if (results.worths.empty()) return "";
  if (!results.best_worst.empty()) return set_section_html(results, figures);
  std::string html =
      html_paragraph(
          "All comparisons for an item together, by the model of Bradley and Terry with ties "
          "(Davidson) and an order effect (Davidson and Beaver). A difference of 1 in log-worth "
          "between two stimuli means odds of e to 1 (2.7 to 1, 73 % of the choices) of being "
          "chosen, a difference of 2 odds of 7.4 to 1 (88 %). Log-worths have a sum of 0, so that "
          "they state differences from the mean of the stimuli; 0 is not the middle of a scale. "
          "Intervals: participants resampled with all of their answers (bootstrap percentiles), "
          "as answers of the same participant depend on each other. The tests (likelihood ratio), "
          "standard errors and the second intervals (profile likelihood) treat all answers as "
          "independent, so that their p values are too small if answers of the same "
          "participant depend on each other. Order effect: log-odds in favour of the stimulus on "
          "the left (of pairs shown in turn, the first) if both are of "
          "equal worth. Elo ratings contain nothing more than the worths and depend on the order "
          "of the comparisons: they are averaged over random orders, and have no intervals.") +
      conditions_paragraph(results) + html_list("warnings", worth_remarks(results)) + figures +
      worths_html(results) + differences_html(results) + "<h3>Equal worth and order effect</h3>\n" +
      worth_tests_html(results);
  const std::string transitivity = transitivity_html(results);
  if (!transitivity.empty())
    html += "<h3>Transitivity</h3>\n" +
            html_paragraph(
                "A single scale of worth requires that preferences are transitive. For three "
                "stimuli a, b and c with proportions of choices P(ab) and P(bc) of at least one "
                "half, weak transitivity demands that P(ac) is at least one half, moderate "
                "transitivity that it is at least the smaller of the two, and strong "
                "transitivity that it is at least the larger; violations also occur by chance. "
                "Circular triads (a preferred to b, b to c, c to a) are counted for participants "
                "who compared all stimuli with each other; ζ is Kendall’s coefficient of "
                "consistence, 1 without circular triads. Each participant is in "
                "results/circular_triads.csv.") +
            transitivity;
  return html;
}

}  // namespace mien::pipeline
