#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

std::string grid_means_html(const GridResults& grid) {
  std::string rows;
  for (const GridMean& one : grid.means) {
    const GridCondition& condition = grid.conditions[one.condition];
    rows += HtmlRow()
                .text(condition.name,
                      condition.role == "reference" ? "hidden reference" : condition.role)
                .number(one.people, one.answers, decimal(one.mean, 1), decimal(one.deviation, 1),
                        interval_text(one.ends.low, one.ends.high, 1))
                .html();
  }
  return wide_table(
      {"<condition", "<role", "participants", "ratings", "mean", "SD", "95 % interval"}, rows);
}

std::string grid_differences_html(const AnswerSet& answer_set, const GridResults& grid) {
  std::string rows;
  for (const GridDifference& one : grid.differences) {
    const WithinParticipants& within = one.within;
    rows += HtmlRow()
                .text(grid.conditions[one.one].name + " − " + grid.conditions[one.other].name)
                .number(within.people, decimal(within.t.mean, 1),
                        interval_text(within.t.low(0.95), within.t.high(0.95), 1),
                        within.all_equal
                            ? "all equal"
                            : fmt::format("{} ({:g})", decimal(within.t.t), within.t.degrees),
                        p_text(within.t.p), p_text(one.paired_adjusted), within.gz,
                        p_text(within.wilcoxon.p), p_text(one.wilcoxon_adjusted))
                .html(one.paired_adjusted < answer_set.alpha);
  }
  return wide_table({"<conditions", "participants", "difference", "95 % interval", "t (df)", "p",
                     "p, corrected", "g_z", "Wilcoxon p", "p, corrected"},
                    rows);
}

}  // namespace

std::string grid_section_html(const Results& results, const std::string& figures) {
  const GridResults& grid = results.grid;
  if (grid.means.empty()) return "";
  return html_paragraph(
             "Participants rated the stimuli of a set on sliders from 0 to 100, in one trial and "
             "as often played as they liked (multiple stimuli with hidden reference and anchor, "
             "ITU-R BS.1534-3). A condition comprises the stimuli with equal levels of the factors "
             "that differ within sets. Means are those of the participants’ means; their intervals "
             "(Student) treat participants, not ratings, as independent.") +
         figures + grid_means_html(grid) +
         html_paragraph(fmt::format(
             "Differences between conditions: for each participant, the mean over the sets in "
             "which both were rated; paired t test and exact Wilcoxon signed-rank test over "
             "participants. Correction for multiple comparisons over all pairs: {}. Rows marked * "
             "are significant by the t test after correction (α = {:g}).",
             name_of(results.answer_set.correction), results.answer_set.alpha)) +
         grid_differences_html(results.answer_set, grid);
}

}  // namespace mien::pipeline
