#include "pipeline/study/analysis/rating_estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr double normal_reach = 1.6448536269514722;
constexpr int fewest_styles = 4;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Variance of the raters' error of each mean; 0 where it is not known.
VectorXd noise_of(const MeanRatings& ratings, const RatingReliability& reliability) {
  if (std::isnan(reliability.answer_variance)) return VectorXd::Zero(ratings.mean.size());
  return reliability.answer_variance * ratings.answers.cast<double>().cwiseInverse();
}

std::map<int, std::vector<Index>> members_of(const std::vector<int>& style) {
  std::map<int, std::vector<Index>> members;
  for (std::size_t i = 0; i < style.size(); ++i) members[style[i]].push_back(static_cast<Index>(i));
  return members;
}

/// A style that is left out, and the other motions, standardised without it.
struct Fold {
  std::vector<Index> left_out, kept;
  MatrixXd left_out_features;
  GroupedObservations others;  ///< without values and noise
};

std::vector<Fold> folds_of(const RatedMotions& motions) {
  std::vector<Fold> folds;
  for (const auto& [style, members] : members_of(motions.style)) {
    Fold fold;
    fold.left_out = members;
    for (std::size_t i = 0; i < motions.style.size(); ++i) {
      if (motions.style[i] == style) continue;
      fold.kept.push_back(static_cast<Index>(i));
      fold.others.group.push_back(motions.style[i]);
    }
    const MatrixXd kept = motions.features(fold.kept, Eigen::all);
    const Standardisation by = standardisation_of(kept);
    fold.others.predictors = by.of(kept);
    fold.left_out_features = by.of(motions.features(members, Eigen::all));
    folds.push_back(std::move(fold));
  }
  return folds;
}

EstimateCheck checked(const std::vector<Fold>& folds, const RatedMotions& motions,
                      const VectorXd& values, const VectorXd& noise) {
  EstimateCheck check;
  for (VectorXd* column : {&check.estimated, &check.variance, &check.mean_of_others})
    column->resize(values.size());
  for (const Fold& fold : folds) {
    GroupedObservations others = fold.others;
    others.values = values(fold.kept);
    others.noise_variance = noise(fold.kept);
    const GaussianProcess process = fit_process(motions.families, others);
    for (std::size_t k = 0; k < fold.left_out.size(); ++k) {
      const ProcessPrediction p =
          predicted(process, fold.left_out_features.row(static_cast<Index>(k)));
      check.estimated[fold.left_out[k]] = p.mean;
      check.variance[fold.left_out[k]] = p.variance;
      check.mean_of_others[fold.left_out[k]] = others.values.mean();
    }
  }
  const double of_mean = (values - check.mean_of_others).squaredNorm();
  check.r_squared = of_mean > 0.0 ? 1.0 - (values - check.estimated).squaredNorm() / of_mean : 0.0;
  check.ceiling = of_mean > 0.0 ? 1.0 - noise.sum() / of_mean : 0.0;
  return check;
}

/// The motions in an order in which whole styles have been exchanged: motion i gets the rating of
/// motion order[i].
std::vector<Index> shuffled_styles(const RatedMotions& motions, std::uint64_t seed, int shuffle) {
  std::map<std::size_t, std::vector<std::vector<Index>>> by_size;
  for (const auto& [style, members] : members_of(motions.style))
    by_size[members.size()].push_back(members);
  std::vector<Index> order(motions.style.size());
  for (const auto& [size, styles] : by_size) {
    std::vector<std::pair<double, std::size_t>> drawn;
    for (std::size_t s = 0; s < styles.size(); ++s)
      drawn.emplace_back(uniform(seed, "shuffle/" + std::to_string(shuffle) + "/" +
                                           std::to_string(styles[s].front())),
                         s);
    std::sort(drawn.begin(), drawn.end());
    for (std::size_t s = 0; s < styles.size(); ++s)
      for (std::size_t k = 0; k < size; ++k)
        order[static_cast<std::size_t>(styles[s][k])] = styles[drawn[s].second][k];
  }
  return order;
}

double share_as_good(const std::vector<Fold>& folds, const RatedMotions& motions,
                     const VectorXd& values, const VectorXd& noise, double r_squared,
                     const EstimatorOptions& options) {
  int as_good = 1;  // the ratings as they are
  for (int shuffle = 0; shuffle < options.permutations; ++shuffle) {
    const std::vector<Index> order = shuffled_styles(motions, options.seed, shuffle);
    if (checked(folds, motions, values(order), noise(order)).r_squared >= r_squared) ++as_good;
    options.progress((shuffle + 1.0) / options.permutations);
  }
  return as_good / (1.0 + options.permutations);
}

/// Standardised errors of the left-out motions.
VectorXd standardised_errors(const EstimateCheck& check, const VectorXd& values,
                             const VectorXd& noise) {
  return (values - check.estimated).cwiseQuotient((check.variance + noise).cwiseSqrt());
}

double reach_of(const VectorXd& errors) {
  std::vector<double> sizes;
  for (const double error : errors) sizes.push_back(std::abs(error));
  std::sort(sizes.begin(), sizes.end());
  const auto count = static_cast<double>(sizes.size());
  const auto place = static_cast<std::size_t>(std::ceil(0.9 * (count + 1.0)));
  return std::max(normal_reach, sizes[std::min(place, sizes.size()) - 1]);
}

}  // namespace

RatingReliability reliability_of(const MeanRatings& ratings) {
  const VectorXd count = ratings.answers.cast<double>();
  const double all = count.sum();
  const auto motions = static_cast<double>(count.size());
  if (!ratings.deviation.allFinite() || all <= motions || motions < 2.0)
    return {not_known, not_known};
  const double within = count.dot(ratings.deviation.cwiseAbs2()) / (all - motions);
  const double mean = count.dot(ratings.mean) / all;
  const double between =
      count.dot((ratings.mean.array() - mean).square().matrix()) / (motions - 1.0);
  return {within, between > 0.0 ? 1.0 - within / between : not_known};
}

bool ScaleEstimator::is_usable() const { return check.r_squared > 0.0 && check.p <= 0.05; }

double ScaleEstimator::share_of_ceiling() const {
  return check.ceiling > 0.0 ? check.r_squared / check.ceiling : not_known;
}

bool ScaleEstimator::reaches_aim() const { return share_of_ceiling() >= aimed_share_of_ceiling; }

EstimateCheck check_without_styles(const RatedMotions& motions, const MeanRatings& ratings) {
  const RatingReliability reliability = reliability_of(ratings);
  EstimateCheck check =
      checked(folds_of(motions), motions, ratings.mean, noise_of(ratings, reliability));
  if (std::isnan(reliability.answer_variance)) check.ceiling = not_known;
  return check;
}

ScaleEstimator fit_estimator(const RatedMotions& motions, const MeanRatings& ratings,
                             const EstimatorOptions& options) {
  if (members_of(motions.style).size() < fewest_styles)
    throw Error("there are too few styles to check estimates of ratings",
                "rate motions of four styles or more");
  ScaleEstimator estimator;
  estimator.scale = ratings.scale;
  estimator.reliability = reliability_of(ratings);
  const VectorXd noise = noise_of(ratings, estimator.reliability);
  estimator.check = check_without_styles(motions, ratings);
  EstimateCheck& check = estimator.check;
  check.permutations = options.permutations;
  check.p =
      share_as_good(folds_of(motions), motions, ratings.mean, noise, check.r_squared, options);
  const VectorXd errors = standardised_errors(check, ratings.mean, noise);
  check.covered = static_cast<double>((errors.array().abs() <= normal_reach).count()) /
                  static_cast<double>(errors.size());
  estimator.reach = reach_of(errors);

  const Standardisation by = standardisation_of(motions.features);
  estimator.feature_mean = by.mean;
  estimator.feature_spread = by.spread;
  estimator.process =
      fit_process(motions.families, {by.of(motions.features), ratings.mean, noise, motions.style});
  return estimator;
}

RatingEstimate estimate(const ScaleEstimator& estimator, const RowVectorXd& features) {
  const Standardisation by{estimator.feature_mean, estimator.feature_spread};
  const ProcessPrediction p = predicted(estimator.process, RowVectorXd(by.of(features)));
  const double half = estimator.reach * std::sqrt(p.variance);
  return {p.mean, p.mean - half, p.mean + half};
}

}  // namespace mien::pipeline
