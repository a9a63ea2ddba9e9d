#include "pipeline/study/results/trace_results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Core>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/study/results/agreement_remark.h"

namespace mien::pipeline {

namespace {

/// The traces of a stimulus on a scale: sum and number by participant.
struct CourseTraces {
  std::map<std::size_t, std::pair<std::vector<double>, int>> by_person;
  std::size_t samples = 0;  ///< of the shortest trace; those of a film are equally long
  int unmoved = 0;

  void add(const AnalysedTrace& trace) {
    auto& [sum, count] = by_person[trace.person];
    sum.resize(std::max(sum.size(), trace.values.size()));
    for (std::size_t k = 0; k < trace.values.size(); ++k) sum[k] += trace.values[k];
    ++count;
    samples = samples == 0 ? trace.values.size() : std::min(samples, trace.values.size());
    const auto [least, most] = std::ranges::minmax(trace.values);
    unmoved += least == most ? 1 : 0;
  }

  /// Samples from `first` on × participants.
  Eigen::MatrixXd table(std::size_t first) const {
    const std::size_t count = samples > first ? samples - first : 0;
    Eigen::MatrixXd table(count, by_person.size());
    Eigen::Index column = 0;
    for (const auto& [person, own] : by_person) {
      for (std::size_t k = 0; k < count; ++k)
        table(static_cast<Eigen::Index>(k), column) = own.first[first + k] / own.second;
      ++column;
    }
    return table;
  }
};

TracePoint point_of(const Eigen::RowVectorXd& values, double time_s) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  TracePoint point{.time_s = time_s,
                   .people = static_cast<int>(values.size()),
                   .deviation = none,
                   .ends = {none, none}};
  const TTest test = paired_t_test({values.begin(), values.end()});
  point.mean = test.mean;
  if (point.people < 2) return point;
  point.deviation = test.standard_error * std::sqrt(static_cast<double>(point.people));
  point.ends = {test.low(0.95), test.high(0.95)};
  return point;
}

std::vector<TracePoint> points_of(const CourseTraces& traces, double lag_s, double film_s) {
  const std::size_t first = first_sample_from(lag_s);
  const Eigen::MatrixXd table = traces.table(first);
  std::vector<TracePoint> points;
  for (Eigen::Index k = 0; k < table.rows(); ++k) {
    const double time_s = sample_time(first + static_cast<std::size_t>(k), film_s) - lag_s;
    points.push_back(point_of(table.row(k), std::max(0.0, std::round(1e6 * time_s) / 1e6)));
  }
  return points;
}

/// What a participant contributes to the parts of a film.
struct Contributions {
  std::vector<double> levels;   ///< of the part
  std::vector<double> changes;  ///< from the part before
};

/// Mean of each participant's samples from one index to before another; empty if there are none.
std::vector<double> levels_between(const Eigen::MatrixXd& table, std::size_t first,
                                   std::size_t end) {
  const auto from = static_cast<Eigen::Index>(first);
  const Eigen::Index count = std::min(static_cast<Eigen::Index>(end), table.rows()) - from;
  if (count <= 0) return {};
  const Eigen::RowVectorXd means = table.middleRows(from, count).colwise().mean();
  return {means.begin(), means.end()};
}

void set_level(const Contributions& of, TraceSegment& segment) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  segment.deviation = segment.change = none;
  segment.ends = segment.change_ends = {none, none};
  segment.people = static_cast<int>(of.levels.size());
  const TTest level = paired_t_test(of.levels);
  segment.mean = level.mean;
  if (!of.changes.empty()) segment.change = paired_t_test(of.changes).mean;
  if (segment.people < 2) return;
  segment.deviation = level.standard_error * std::sqrt(static_cast<double>(segment.people));
  segment.ends = {level.low(0.95), level.high(0.95)};
  if (of.changes.empty()) return;
  const TTest change = paired_t_test(of.changes);
  segment.change_ends = {change.low(0.95), change.high(0.95)};
}

/// The parts of a film by its moods, of which there are several.
std::vector<TraceSegment> segments_of(const CourseTraces& traces, const ReportedStimulus& stimulus,
                                      double lag_s, double lead_s) {
  const std::vector<ShownMood>& moods = stimulus.moods;
  const Eigen::MatrixXd table = traces.table(0);
  const double end_s =
      sample_time(static_cast<std::size_t>(table.rows()) - 1, stimulus.film_s) - lag_s;
  std::vector<TraceSegment> segments;
  std::vector<double> before;
  for (std::size_t i = 0; i < moods.size(); ++i) {
    TraceSegment segment;
    segment.mood = moods[i].mood;
    segment.from_s = std::max(moods[i].from_s, lead_s);
    segment.to_s = i + 1 < moods.size() ? moods[i + 1].from_s : end_s;
    segment.to_s = std::min(segment.to_s, end_s);
    const std::size_t end = i + 1 < moods.size() ? first_sample_from(moods[i + 1].from_s + lag_s)
                                                 : static_cast<std::size_t>(table.rows());
    Contributions of;
    of.levels = levels_between(table, first_sample_from(segment.from_s + lag_s), end);
    if (of.levels.empty()) continue;
    for (std::size_t person = 0; person < before.size(); ++person)
      of.changes.push_back(of.levels[person] - before[person]);
    before = of.levels;
    set_level(of, segment);
    segments.push_back(segment);
  }
  return segments;
}

TraceAgreement agreement_on(const CourseTraces& traces, double from_s) {
  const Eigen::MatrixXd table = traces.table(first_sample_from(from_s));
  TraceAgreement result{.people = static_cast<int>(table.cols()),
                        .samples = static_cast<int>(table.rows()),
                        .unmoved = traces.unmoved};
  const Agreement agreement = agreement_of(table);
  result.alpha = agreement.alpha;
  result.intraclass = agreement.all;
  result.remark = agreement_remark(table, agreement, "times");
  if (states_none(result.remark)) set_none(result.intraclass, result.alpha);
  return result;
}

}  // namespace

TraceResults trace_results(const AnswerSet& answer_set) {
  std::map<std::pair<std::size_t, std::size_t>, CourseTraces> courses;  // by stimulus and scale
  for (const AnalysedTrace& trace : answer_set.traces)
    courses[{trace.stimulus, trace.scale}].add(trace);
  TraceResults results;
  for (const auto& [key, traces] : courses) {
    results.means.push_back(
        {key.first, key.second,
         points_of(traces, answer_set.trace_lag_s, answer_set.stimuli[key.first].film_s)});
    results.agreement.push_back(
        agreement_on(traces, answer_set.trace_lag_s + answer_set.trace_lead_s));
    results.agreement.back().stimulus = key.first;
    results.agreement.back().scale = key.second;
    for (TraceSegment& segment : segments_of(traces, answer_set.stimuli[key.first],
                                             answer_set.trace_lag_s, answer_set.trace_lead_s)) {
      segment.stimulus = key.first;
      segment.scale = key.second;
      results.segments.push_back(std::move(segment));
    }
  }
  return results;
}

}  // namespace mien::pipeline
