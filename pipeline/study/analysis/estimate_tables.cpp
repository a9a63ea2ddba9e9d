#include "pipeline/study/analysis/estimate_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mien::pipeline {

namespace {

std::optional<double> known(double value) {
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

struct ScaleRow {
  bool simulated;
  std::size_t motions;
  const ScaleEstimator& of;
};

struct LeftOutRow {
  bool simulated;
  std::string motion;
  double rating;
  Eigen::Index index;
  const ScaleEstimator& of;
};

struct EstimateRow {
  bool simulated;
  std::string motion;
  const RatingEstimate& estimate;
  const ScaleEstimator& of;
};

constexpr SharedColumn scale_column{"scale", "", "id of the scale",
                                    [](auto& r) { return r.of.scale; }};
constexpr SharedColumn usable_column{"usable", "0/1",
                                     "1: cross-validated R² above 0, and p at most 0.05",
                                     [](auto& r) { return r.of.is_usable(); }};

constexpr auto estimate_checks_columns = table_of<ScaleRow>(
    "estimate_checks.csv", "scale",
    {scale_column,
     whose_ratings_column,
     {"motions", "", "number of rated motions", [](auto& r) { return r.motions; }},
     {"icc_1_k", "", "reliability ICC(1,k) of the mean ratings; empty if only means are given",
      [](auto& r) { return known(r.of.reliability.icc_one_k); }},
     {"ceiling", "",
      "R² expected of an estimator that knows the mean answer of all people, in the same "
      "cross-validation; empty if only means are given",
      [](auto& r) { return known(r.of.check.ceiling); }},
     {"r_squared", "",
      "cross-validated R² with all motions of a style left out; below 0: worse than the mean",
      [](auto& r) { return r.of.check.r_squared; }},
     {"share_of_ceiling", "", "r_squared / ceiling; empty if the ceiling is not above 0",
      [](auto& r) { return known(r.of.share_of_ceiling()); }},
     {"reaches_aim", "0/1", "1: share_of_ceiling is at least 0.6",
      [](auto& r) { return r.of.reaches_aim(); }},
     {"p", "", "share of permutations of the styles' ratings with at least this R²",
      [](auto& r) { return r.of.check.p; }},
     {"permutations", "", "number of permutations",
      [](auto& r) { return r.of.check.permutations; }},
     usable_column,
     {"covered", "0–1",
      "share of the left-out ratings within the 90 % intervals of the process, raters' error added",
      [](auto& r) { return r.of.check.covered; }},
     {"reach", "", "half width of the intervals given, in predicted standard deviations",
      [](auto& r) { return r.of.reach; }}});

constexpr auto left_out_estimates_columns =
    table_of<LeftOutRow>("left_out_estimates.csv", "scale and rated motion",
                         {scale_column,
                          whose_ratings_column,
                          {"motion", "", "label of the motion", [](auto& r) { return r.motion; }},
                          {"observed", "0–1", "mean rating", [](auto& r) { return r.rating; }},
                          {"estimated", "0–1", "estimate by a fit without its style",
                           [](auto& r) { return r.of.check.estimated[r.index]; }},
                          {"sd", "0–1", "predicted standard deviation, without raters' error",
                           [](auto& r) { return std::sqrt(r.of.check.variance[r.index]); }},
                          {"mean_of_others", "0–1", "mean rating of the motions of other styles",
                           [](auto& r) { return r.of.check.mean_of_others[r.index]; }}});

constexpr auto estimates_columns = table_of<EstimateRow>(
    "estimates.csv", "motion and scale",
    {{"motion", "", "name of the file", [](auto& r) { return r.motion; }},
     scale_column,
     whose_ratings_column,
     {"estimated", "0–1",
      "estimated mean rating, as a proportion of the scale; not rated by anyone; may lie outside "
      "0–1",
      [](auto& r) { return r.estimate.value; }},
     {"low_90", "0–1", "lower end of its 90 % interval", [](auto& r) { return r.estimate.low_90; }},
     {"high_90", "0–1", "its upper end", [](auto& r) { return r.estimate.high_90; }},
     usable_column});

struct RatingRow {
  std::string stimulus, scale;
  double value, low, high;
};

constexpr auto estimated_ratings_columns = table_of<RatingRow>(
    "estimated_ratings.csv", "motion and usable scale",
    {{"stimulus", "", "name of the file", [](auto& r) { return r.stimulus; }},
     {"scale", "", "id of the scale", [](auto& r) { return r.scale; }},
     {"value", "scale", "estimated mean answer", [](auto& r) { return r.value; }},
     {"low_90", "scale", "lower end of its 90 % interval", [](auto& r) { return r.low; }},
     {"high_90", "scale", "its upper end", [](auto& r) { return r.high; }},
     {"estimated", "", "always 1: estimated from the motion", [](auto&) { return true; }},
     {"simulated", "", "always 1: not rated by participants", [](auto&) { return true; }}});

}  // namespace

WrittenTable estimate_checks_table(const RatingEstimators& estimators) {
  std::vector<ScaleRow> rows;
  for (const ScaleEstimator& of : estimators.estimators)
    rows.push_back({estimators.simulated, estimators.motions.size(), of});
  return estimate_checks_columns.of(rows);
}

WrittenTable left_out_estimates_table(const RatingEstimators& estimators) {
  std::vector<LeftOutRow> rows;
  for (std::size_t s = 0; s < estimators.estimators.size(); ++s)
    for (std::size_t i = 0; i < estimators.motions.size(); ++i) {
      const auto index = static_cast<Eigen::Index>(i);
      rows.push_back({estimators.simulated, estimators.motions[i],
                      estimators.ratings[s].mean[index], index, estimators.estimators[s]});
    }
  return left_out_estimates_columns.of(rows);
}

WrittenTable estimates_table(const std::vector<EstimatedMotion>& motions,
                             const RatingEstimators& estimators) {
  std::vector<EstimateRow> rows;
  for (const EstimatedMotion& motion : motions)
    for (std::size_t s = 0; s < motion.estimates.size(); ++s)
      rows.push_back(
          {estimators.simulated, motion.motion, motion.estimates[s], estimators.estimators[s]});
  return estimates_columns.of(rows);
}

WrittenTable estimated_ratings_table(const std::vector<EstimatedMotion>& motions,
                                     const RatingEstimators& estimators, const ScaleSet& scales) {
  std::vector<RatingRow> rows;
  for (const EstimatedMotion& motion : motions) {
    for (std::size_t s = 0; s < motion.estimates.size(); ++s) {
      const ScaleEstimator& of = estimators.estimators[s];
      const Scale* scale = find_scale(scales, of.scale);
      if (scale == nullptr || !of.is_usable()) continue;
      const auto answer = [scale](double share) {
        return scale->least + std::clamp(share, 0.0, 1.0) * (scale->most - scale->least);
      };
      const RatingEstimate& e = motion.estimates[s];
      rows.push_back(
          {motion.motion, of.scale, answer(e.value), answer(e.low_90), answer(e.high_90)});
    }
  }
  return estimated_ratings_columns.of(rows);
}

}  // namespace mien::pipeline
