#include "pipeline/study/results/result_rows.h"

namespace mien::pipeline {

namespace {

struct TracePointRow {
  const AnswerSet& in;
  const MeanTrace& of;
  const TracePoint& point;

  const ReportedStimulus& stimulus() const { return in.stimuli[of.stimulus]; }
  const Scale& scale() const { return in.scales[of.scale]; }
};

using TraceAgreementRow = ResultRow<TraceAgreement>;

constexpr auto mean_trace_columns = result_table<TracePointRow>(
    "results/mean_traces.csv", "time of a stimulus on a scale (continuous trials)",
    {stimulus_column,
     scale_column,
     {"time_s", "s", "time of the film; traces are moved back by the lag of the analysis",
      [](auto& r) { return r.point.time_s; }},
     {"people", "", "number of participants", [](auto& r) { return r.point.people; }},
     {"mean", "0–100", "mean of the participants' markers", [](auto& r) { return r.point.mean; }},
     {"sd", "0–100", "standard deviation (n − 1) over participants",
      [](auto& r) { return r.point.deviation; }},
     {"low", "0–100",
      "lower end of the 95 % interval of the mean (Student, over participants), of this time alone",
      [](auto& r) { return r.point.ends.low; }},
     {"high", "0–100", "upper end", [](auto& r) { return r.point.ends.high; }}});

using TraceSegmentRow = ResultRow<TraceSegment>;

constexpr auto trace_segment_columns = result_table<TraceSegmentRow>(
    "results/trace_segments.csv",
    "mood of a stimulus whose mood changes, on a scale (continuous trials)",
    {stimulus_column,
     scale_column,
     {"mood", "", "the mood that is shown", [](auto& r) { return r.of.mood; }},
     {"from_s", "s", "time of the video from which it is shown; of the first mood, after the lead",
      [](auto& r) { return r.of.from_s; }},
     {"to_s", "s",
      "time of the video at which the next mood begins, or the end of the video minus the lag of "
      "the analysis",
      [](auto& r) { return r.of.to_s; }},
     {"people", "", "number of participants", [](auto& r) { return r.of.people; }},
     {"mean", "0–100",
      "mean over participants of the means of their traces in this time, moved back by the lag of "
      "the analysis",
      [](auto& r) { return r.of.mean; }},
     {"sd", "0–100", "standard deviation (n − 1) over participants",
      [](auto& r) { return r.of.deviation; }},
     {"low", "0–100", "lower end of the 95 % interval of the mean (Student, over participants)",
      [](auto& r) { return r.of.ends.low; }},
     {"high", "0–100", "upper end", [](auto& r) { return r.of.ends.high; }},
     {"change", "", "mean difference from the mood before; empty for the first",
      [](auto& r) { return r.of.change; }},
     {"change_low", "",
      "lower end of the 95 % interval of the difference (Student, paired by participant)",
      [](auto& r) { return r.of.change_ends.low; }},
     {"change_high", "", "upper end", [](auto& r) { return r.of.change_ends.high; }}});

constexpr auto trace_agreement_columns = result_table<TraceAgreementRow>(
    "results/trace_agreement.csv", "stimulus and scale of continuous trials",
    {stimulus_column,
     scale_column,
     {"people", "", "number of participants", [](auto& r) { return r.of.people; }},
     {"samples", "", "number of times, after lag and lead", [](auto& r) { return r.of.samples; }},
     {"unmoved", "", "traces in which the marker was not moved",
      [](auto& r) { return r.of.unmoved; }},
     {"alpha", "", "Cronbach's alpha over times, with participants as items",
      [](auto& r) { return r.of.alpha; }},
     {"icc_2", "", "ICC(2,1) over times: agreement, participants random",
      [](auto& r) { return r.of.intraclass.two; }},
     {"icc_2_k", "", "ICC(2,k) of the mean of all participants",
      [](auto& r) { return r.of.intraclass.two_k; }},
     {"remark", "", "why there are no coefficients, or what negative ones mean",
      [](auto& r) { return r.of.remark; }}});

}  // namespace

void add_traces(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  std::vector<TracePointRow> points;
  for (const MeanTrace& mean : results.traces.means)
    for (const TracePoint& point : mean.points) points.push_back({answer_set, mean, point});
  add_table(mean_trace_columns, points, answer_set.simulated, tables);
  add_results(trace_segment_columns, results.traces.segments, answer_set, tables);
  add_results(trace_agreement_columns, results.traces.agreement, answer_set, tables);
}

}  // namespace mien::pipeline
