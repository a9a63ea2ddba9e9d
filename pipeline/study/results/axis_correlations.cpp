#include "pipeline/study/results/axis_correlations.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/confusion.h"

namespace mien::pipeline {

namespace {

/// Of each end, the points of every showing; NaN where its scale was not answered.
std::vector<std::vector<double>> points_by_end(const Gathered& gathered) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> showings;
  for (const CountedRating& rating : gathered.ratings)
    showings.emplace(std::pair(rating.stimulus, rating.person), showings.size());
  const std::vector<double> unanswered(showings.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::vector<double>> ends(2 * gathered.scales.size(), unanswered);
  for (const CountedRating& rating : gathered.ratings) {
    const std::size_t showing = showings.at({rating.stimulus, rating.person});
    const EndPoints points = points_of(gathered.scales[rating.scale], rating.value);
    ends[2 * rating.scale][showing] = points.low;
    ends[2 * rating.scale + 1][showing] = points.high;
  }
  return ends;
}

}  // namespace

std::vector<EndCorrelation> end_correlations(const Gathered& gathered) {
  if (gathered.ratings.empty()) return {};
  const auto ends = points_by_end(gathered);
  std::vector<EndCorrelation> all;
  std::vector<double> p_values;
  for (std::size_t one = 0; one < ends.size(); ++one) {
    for (std::size_t other = one + 1; other < ends.size(); ++other) {
      EndCorrelation pair{one, other, one / 2 == other / 2, pearson(ends[one], ends[other]), 1.0};
      p_values.push_back(pair.same_scale ? std::nan("") : pair.correlation.p);
      all.push_back(pair);
    }
  }
  const std::vector<double> adjusted = corrected(p_values, gathered.correction);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].adjusted = adjusted[i];
  return all;
}

}  // namespace mien::pipeline
