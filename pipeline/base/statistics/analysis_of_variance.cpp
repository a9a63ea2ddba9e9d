#include "pipeline/base/statistics/analysis_of_variance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "pipeline/base/statistics/noncentral_interval.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double no_test = std::numeric_limits<double>::quiet_NaN();

/// Orthonormal contrasts between levels, one a column (Helmert).
MatrixXd helmert(Index levels) {
  MatrixXd contrasts = MatrixXd::Zero(levels, levels - 1);
  for (Index i = 1; i < levels; ++i) {
    const double scale = 1.0 / std::sqrt(static_cast<double>(i * (i + 1)));
    contrasts.col(i - 1).head(i).setConstant(scale);
    contrasts(i, i - 1) = -static_cast<double>(i) * scale;
  }
  return contrasts;
}

MatrixXd kronecker(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd product(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index k = 0; k < a.cols(); ++k)
      product.block(i * b.rows(), k * b.cols(), b.rows(), b.cols()) = a(i, k) * b;
  return product;
}

/// All subsets of factors, the empty one included, by size and then by their members.
std::vector<std::vector<std::size_t>> subsets(std::size_t factors) {
  std::vector<std::vector<std::size_t>> all;
  for (unsigned bits = 0; bits < (1U << factors); ++bits) {
    all.emplace_back();
    for (std::size_t i = 0; i < factors; ++i)
      if ((bits >> i & 1U) != 0U) all.back().push_back(i);
  }
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return all;
}

/// ‖RᵀR‖², by whichever product is smaller.
double squared_norm_of_product(const MatrixXd& r) {
  return r.cols() <= r.rows() ? (r.transpose() * r).squaredNorm()
                              : (r * r.transpose()).squaredNorm();
}

/// Scores of participants on contrasts, divided into group means and residuals.
struct GroupedScores {
  MatrixXd means;  ///< a row for each group
  std::vector<double> sizes;
  MatrixXd residuals;

  GroupedScores(const MatrixXd& scores, const std::vector<std::size_t>& groups) {
    const std::size_t count = groups.empty() ? 1 : 1 + std::ranges::max(groups);
    means = MatrixXd::Zero(static_cast<Index>(count), scores.cols());
    sizes.assign(count, 0.0);
    const auto group_of = [&](Index row) {
      return groups.empty() ? 0 : groups[static_cast<std::size_t>(row)];
    };
    for (Index i = 0; i < scores.rows(); ++i) {
      means.row(static_cast<Index>(group_of(i))) += scores.row(i);
      sizes[group_of(i)] += 1.0;
    }
    for (std::size_t g = 0; g < count; ++g) means.row(static_cast<Index>(g)) /= sizes[g];
    residuals = scores;
    for (Index i = 0; i < scores.rows(); ++i)
      residuals.row(i) -= means.row(static_cast<Index>(group_of(i)));
  }

  /// Sum of squares of the mean over groups of equal weight.
  double squares_of_mean() const {
    double variance = 0.0;  // of the mean, in units of the error variance
    for (const double size : sizes) variance += 1.0 / size;
    const auto count = static_cast<double>(sizes.size());
    return means.colwise().mean().squaredNorm() / (variance / (count * count));
  }

  /// Sum of squares of the differences between groups.
  double squares_of_groups() const {
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(means.cols());
    double all = 0.0;
    for (std::size_t g = 0; g < sizes.size(); ++g) {
      mean += sizes[g] * means.row(static_cast<Index>(g));
      all += sizes[g];
    }
    mean /= all;
    double squares = 0.0;
    for (std::size_t g = 0; g < sizes.size(); ++g)
      squares += sizes[g] * (means.row(static_cast<Index>(g)) - mean).squaredNorm();
    return squares;
  }
};

void finish(VarianceEffect& effect, EffectIntervals intervals) {
  if (effect.error_squares <= 0.0) {
    effect.f = effect.p = effect.p_corrected = effect.partial_eta = effect.generalized_eta =
        effect.partial_eta_low = effect.partial_eta_high = no_test;
    return;
  }
  effect.f = (effect.squares / effect.degrees) / (effect.error_squares / effect.error_degrees);
  const auto p_of = [&](double epsilon) {
    return cdf(complement(
        boost::math::fisher_f(epsilon * effect.degrees, epsilon * effect.error_degrees), effect.f));
  };
  effect.p = p_of(1.0);
  effect.p_corrected = p_of(effect.epsilon);
  effect.partial_eta = effect.squares / (effect.squares + effect.error_squares);
  if (intervals == EffectIntervals::omitted) {
    effect.partial_eta_low = effect.partial_eta_high = no_test;
    return;
  }
  const EffectInterval interval = partial_eta_interval(effect.f, effect.epsilon * effect.degrees,
                                                       effect.epsilon * effect.error_degrees);
  effect.partial_eta_low = interval.low;
  effect.partial_eta_high = interval.high;
}

/// All error terms, and the effects in which groups, which are measured, take part, are variation
/// between participants that a manipulation did not cause.
void set_generalized_eta(std::vector<VarianceEffect>& effects, double error_squares) {
  double measured = 0.0;
  for (const VarianceEffect& effect : effects) measured += effect.by_group ? effect.squares : 0.0;
  for (VarianceEffect& effect : effects) {
    if (std::isnan(effect.f)) continue;
    const double rest = measured - (effect.by_group ? effect.squares : 0.0);
    effect.generalized_eta = effect.squares / (effect.squares + error_squares + rest);
  }
}

}  // namespace

std::vector<VarianceTerm> variance_terms(std::size_t factors, bool has_groups) {
  std::vector<VarianceTerm> terms;
  for (const std::vector<std::size_t>& members : subsets(factors)) {
    if (!members.empty()) terms.push_back({members, false});
    if (has_groups) terms.push_back({members, true});
  }
  return terms;
}

MatrixXd effect_contrasts(const std::vector<std::size_t>& factors, const std::vector<int>& levels) {
  MatrixXd contrasts = MatrixXd::Ones(1, 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Index n = levels[i];
    const bool is_in = std::ranges::find(factors, i) != factors.end();
    contrasts =
        kronecker(contrasts,
                  is_in ? helmert(n)
                        : MatrixXd(VectorXd::Constant(n, 1.0 / std::sqrt(static_cast<double>(n)))));
  }
  return contrasts;
}

std::vector<VarianceEffect> analysis_of_variance(const MatrixXd& cells,
                                                 const std::vector<int>& levels,
                                                 const std::vector<std::size_t>& groups,
                                                 EffectIntervals intervals) {
  const bool has_groups = !groups.empty() && std::ranges::max(groups) > 0;
  const double group_count = has_groups ? 1.0 + static_cast<double>(std::ranges::max(groups)) : 1.0;
  const auto people = static_cast<double>(cells.rows());
  assert(people > group_count);
  // Rounding errors of scores that are equal for all participants.
  const double rounding = 1e-24 * cells.squaredNorm();
  std::vector<VarianceEffect> effects;
  double all_errors = 0.0;
  for (const std::vector<std::size_t>& factors : subsets(levels.size())) {
    const MatrixXd scores = cells * effect_contrasts(factors, levels);
    const GroupedScores grouped(scores, has_groups ? groups : std::vector<std::size_t>());
    VarianceEffect effect;
    effect.factors = factors;
    effect.degrees = static_cast<double>(scores.cols());
    effect.error_squares = grouped.residuals.squaredNorm();
    if (effect.error_squares <= rounding) effect.error_squares = 0.0;
    effect.error_degrees = effect.degrees * (people - group_count);
    all_errors += effect.error_squares;
    if (scores.cols() > 1 && effect.error_squares > 0.0)
      effect.epsilon = effect.error_squares * effect.error_squares /
                       (effect.degrees * squared_norm_of_product(grouped.residuals));
    if (!factors.empty()) {
      effect.squares = grouped.squares_of_mean();
      finish(effect, intervals);
      effects.push_back(effect);
    }
    if (!has_groups) continue;
    effect.by_group = true;
    effect.degrees *= group_count - 1.0;
    effect.squares = grouped.squares_of_groups();
    finish(effect, intervals);
    effects.push_back(effect);
  }
  set_generalized_eta(effects, all_errors);
  return effects;
}

VectorXd within_participant_margins(const MatrixXd& cells, double confidence) {
  assert(cells.rows() > 1 && cells.cols() > 1);
  const auto people = static_cast<double>(cells.rows());
  const auto count = static_cast<double>(cells.cols());
  MatrixXd own = cells.colwise() - cells.rowwise().mean();
  own.rowwise() -= Eigen::RowVectorXd(own.colwise().mean());
  const double t = quantile(boost::math::students_t(people - 1.0), 0.5 + 0.5 * confidence);
  const double scale = t * std::sqrt(count / (count - 1.0) / (people * (people - 1.0)));
  return scale * own.colwise().norm().transpose();
}

}  // namespace mien::pipeline
