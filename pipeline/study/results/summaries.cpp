#include "pipeline/study/results/summaries.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/agreement_remark.h"

namespace mien::pipeline {

namespace {

std::size_t point_index(const Scale& scale, int points, double value) {
  const double place = (points - 1) * (value - scale.least) / (scale.most - scale.least);
  return static_cast<std::size_t>(std::clamp(std::lround(place), 0L, points - 1L));
}

RatingSummary summary_of(const std::vector<AnalysedRating>& ratings, const Scale& scale,
                         int points) {
  RatingSummary summary;
  summary.stimulus = ratings.front().stimulus;
  summary.scale = ratings.front().scale;
  summary.answers = static_cast<int>(ratings.size());
  summary.counts.resize(static_cast<std::size_t>(points));
  std::vector<double> values;
  for (const AnalysedRating& rating : ratings) {
    values.push_back(rating.value);
    ++summary.counts[point_index(scale, points, rating.value)];
  }
  const TTest of_mean = paired_t_test(values);
  summary.mean = of_mean.mean;
  summary.deviation = of_mean.standard_error * std::sqrt(static_cast<double>(values.size()));
  summary.low = of_mean.low(0.95);
  summary.high = of_mean.high(0.95);
  summary.median = median_of(values);
  return summary;
}

/// Ratings on a scale, rated stimuli × participants; NaN where missing.
Eigen::MatrixXd table_on(const AnswerSet& answer_set, std::size_t scale) {
  const auto people = static_cast<Eigen::Index>(answer_set.people.size());
  Eigen::MatrixXd table(0, people);
  for (const auto& ratings : ratings_by_stimulus(answer_set, scale)) {
    if (ratings.empty()) continue;
    Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(people);
    Eigen::RowVectorXd counts = Eigen::RowVectorXd::Zero(people);
    for (const AnalysedRating& rating : ratings) {
      sums[static_cast<Eigen::Index>(rating.person)] += rating.value;
      counts[static_cast<Eigen::Index>(rating.person)] += 1.0;
    }
    table.conservativeResize(table.rows() + 1, Eigen::NoChange);
    for (Eigen::Index i = 0; i < people; ++i)
      table(table.rows() - 1, i) =
          counts[i] > 0.0 ? sums[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return table;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::vector<double> scale_points(const Scale& scale, int points) {
  std::vector<double> places;
  for (int i = 0; i < points; ++i)
    places.push_back(scale.least + (scale.most - scale.least) * i / std::max(1, points - 1));
  return places;
}

std::vector<std::vector<AnalysedRating>> ratings_by_stimulus(const AnswerSet& answer_set,
                                                             std::size_t scale) {
  std::vector<std::vector<AnalysedRating>> ratings(answer_set.stimuli.size());
  for (const AnalysedRating& rating : answer_set.ratings)
    if (rating.scale == scale) ratings[rating.stimulus].push_back(rating);
  return ratings;
}

std::vector<RatingSummary> summaries_of(const AnswerSet& answer_set) {
  std::vector<RatingSummary> summaries;
  for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale)
    for (const auto& ratings : ratings_by_stimulus(answer_set, scale))
      if (!ratings.empty())
        summaries.push_back(summary_of(ratings, answer_set.scales[scale], answer_set.points));
  std::ranges::stable_sort(summaries, {}, &RatingSummary::stimulus);
  return summaries;
}

std::vector<Reliability> reliability_of(const AnswerSet& answer_set) {
  std::vector<Reliability> all;
  if (answer_set.ratings.empty()) return all;
  for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
    const Eigen::MatrixXd table = table_on(answer_set, scale);
    const Agreement agreement = agreement_of(table);
    all.push_back({scale, agreement.all, agreement.complete_raters, agreement.alpha,
                   agreement_remark(table, agreement, "videos")});
    Reliability& own = all.back();
    if (states_none(own.remark)) set_none(own.intraclass, own.alpha);
    if (own.remark.empty() && own.intraclass.one < 0.0)
      own.remark = "ICC(1) is negative: participants differ in level more than videos do";
  }
  return all;
}

}  // namespace mien::pipeline
