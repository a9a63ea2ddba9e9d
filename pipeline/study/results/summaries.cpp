#include "pipeline/study/results/summaries.h"

#include <algorithm>
#include <cmath>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::size_t place_on(const Scale& scale, int points, double value) {
  const double place = (points - 1) * (value - scale.least) / (scale.most - scale.least);
  return static_cast<std::size_t>(std::clamp(std::lround(place), 0L, points - 1L));
}

RatingSummary summary_of(const std::vector<CountedRating>& ratings, const Scale& scale,
                         int points) {
  RatingSummary summary;
  summary.stimulus = ratings.front().stimulus;
  summary.scale = ratings.front().scale;
  summary.answers = static_cast<int>(ratings.size());
  summary.counts.resize(static_cast<std::size_t>(points));
  std::vector<double> values;
  for (const CountedRating& rating : ratings) {
    values.push_back(rating.value);
    ++summary.counts[place_on(scale, points, rating.value)];
  }
  const TTest of_mean = paired_t_test(values);
  summary.mean = of_mean.mean;
  summary.deviation = of_mean.standard_error * std::sqrt(static_cast<double>(values.size()));
  summary.low = of_mean.low(0.95);
  summary.high = of_mean.high(0.95);
  summary.median = median_of(values);
  return summary;
}

}  // namespace

std::vector<double> places_of(const Scale& scale, int points) {
  std::vector<double> places;
  for (int i = 0; i < points; ++i)
    places.push_back(scale.least + (scale.most - scale.least) * i / std::max(1, points - 1));
  return places;
}

std::vector<std::vector<CountedRating>> by_stimulus(const Gathered& gathered, std::size_t scale) {
  std::vector<std::vector<CountedRating>> ratings(gathered.stimuli.size());
  for (const CountedRating& rating : gathered.ratings)
    if (rating.scale == scale) ratings[rating.stimulus].push_back(rating);
  return ratings;
}

std::vector<RatingSummary> summaries_of(const Gathered& gathered) {
  std::vector<RatingSummary> summaries;
  for (std::size_t scale = 0; scale < gathered.scales.size(); ++scale)
    for (const auto& ratings : by_stimulus(gathered, scale))
      if (!ratings.empty())
        summaries.push_back(summary_of(ratings, gathered.scales[scale], gathered.points));
  std::ranges::stable_sort(summaries, {}, &RatingSummary::stimulus);
  return summaries;
}

}  // namespace mien::pipeline
