#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

std::string trace_agreement_html(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const TraceAgreement& one : results.traces.agreement) {
    const Scale& scale = answer_set.scales[one.scale];
    rows += HtmlRow()
                .text(answer_set.stimuli[one.stimulus].id, scale.low + " – " + scale.high)
                .number(one.people, one.unmoved, one.samples, decimal(one.alpha),
                        decimal(one.intraclass.two), decimal(one.intraclass.two_k))
                .text(one.remark)
                .html();
  }
  return wide_table({"<stimulus", "<scale", "participants", "not moved", "times", "α", "ICC(2,1)",
                     "ICC(2,k)", "<remark"},
                    rows);
}

std::string trace_segments_html(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string rows;
  for (const TraceSegment& one : results.traces.segments) {
    const Scale& scale = answer_set.scales[one.scale];
    const bool is_first = std::isnan(one.change);
    rows += HtmlRow()
                .text(answer_set.stimuli[one.stimulus].id, scale.low + " – " + scale.high, one.mood)
                .number(fmt::format("{:.1f}–{:.1f}", one.from_s, one.to_s), one.people,
                        decimal(one.mean, 1), interval_text(one.ends.low, one.ends.high, 1),
                        decimal(one.deviation, 1), is_first ? "" : decimal(one.change, 1),
                        is_first ? "" : interval_text(one.change_ends.low, one.change_ends.high, 1))
                .html();
  }
  const std::string table = wide_table({"<stimulus", "<scale", "<mood", "time (s)", "participants",
                                        "mean", "95 %", "SD", "change", "95 %"},
                                       rows);
  if (table.empty()) return "";
  return html_paragraph(
             "Mean level in each mood: the mean of each participant’s trace from the time at which "
             "the mood begins to change to the next change, moved back by the lag of the analysis, "
             "and the mean over participants with its 95 % interval (Student). Change: the "
             "difference from the mood before, paired by participant. An impression takes a while "
             "to follow a change, so that differences of the settled levels are larger.") +
         table;
}

std::string lag_sentence(double lag_s) {
  if (lag_s == 0.0)
    return "Ratings follow what is seen with the participants’ reaction lag, which is not taken "
           "off here (analysis: {lag: …} moves traces back).";
  return fmt::format(
      "Traces were moved back by {:g} s, the assumed reaction lag of the participants: a rating at "
      "{:g} s is taken to be about the beginning of the film.",
      lag_s, lag_s);
}

}  // namespace

std::string trace_section_html(const Results& results, const std::string& figures) {
  if (results.traces.means.empty()) return "";
  const AnswerSet& answer_set = results.answer_set;
  return html_paragraph(
             fmt::format("Participants moved a marker from 0 to 100 while a film played; its "
                         "position was sampled ten times in each second of the film. {} The means "
                         "of trials, of which the other sections are, leave out the first {:g} s "
                         "of the film. The intervals (Student, over participants) are of each time "
                         "alone: over a whole course they hold less often than in 95 %.",
                         lag_sentence(answer_set.trace_lag_s), answer_set.trace_lead_s)) +
         figures + trace_segments_html(results) +
         html_paragraph(
             "Agreement about the course of a film after the lead: times are what is rated, "
             "participants the raters. Cronbach’s α and intraclass correlations ICC(2,1) and "
             "ICC(2,k) (Shrout and Fleiss 1979), the latter also of levels; times in succession "
             "are not independent, so no intervals are given. All means are in "
             "results/mean_traces.csv.") +
         trace_agreement_html(results);
}

}  // namespace mien::pipeline
