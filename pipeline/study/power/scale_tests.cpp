#include "pipeline/study/power/scale_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double no_test = std::numeric_limits<double>::quiet_NaN();

/// The mean of a participant's ratings of some stimuli; NaN without any.
double mean_of(const MatrixXd& ratings, Index person, const std::vector<std::size_t>& stimuli) {
  double sum = 0.0;
  double count = 0.0;
  for (const std::size_t stimulus : stimuli) {
    const double rating = ratings(person, static_cast<Index>(stimulus));
    if (std::isnan(rating)) continue;
    sum += rating;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : no_test;
}

/// All ratings of the stimuli of some cells, by participants who rated all of them.
CrossedRatings crossed_ratings(const MatrixXd& ratings,
                               const std::vector<std::vector<std::size_t>>& cells,
                               const std::vector<std::size_t>& groups) {
  CrossedRatings crossed;
  std::vector<Index> columns;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    for (const std::size_t stimulus : cells[cell]) {
      columns.push_back(static_cast<Index>(stimulus));
      crossed.cells.push_back(cell);
    }
  }
  crossed.ratings = ratings(Eigen::all, columns);
  crossed.groups = groups;
  return crossed;
}

/// The mean of the groups of equal weight that is assumed for each cell.
VectorXd shift_of_cells(const MatrixXd& shift, const std::vector<std::vector<std::size_t>>& cells) {
  VectorXd means(static_cast<Index>(cells.size()));
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    means[static_cast<Index>(cell)] = shift.col(static_cast<Index>(cells[cell].front())).mean();
  return means;
}

}  // namespace

ScaleTests::ScaleTests(const PlannedDesign& design, std::size_t scale, const MatrixXd& ratings,
                       RandomParticipants random)
    : design_(design), random_(random) {
  if (!design.effects.empty()) add_cells(ratings);
  for (const DesignContrast& contrast : design.contrasts)
    if (contrast.scales[scale]) add_contrast(contrast, ratings);
}

void ScaleTests::add_cells(const MatrixXd& ratings) {
  const auto& cells = design_.crossing.cells;
  std::vector<VectorXd> rows;
  std::vector<int> sizes(design_.group_count, 0);
  for (Index person = 0; person < ratings.rows(); ++person) {
    VectorXd own(static_cast<Index>(cells.size()));
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      own[static_cast<Index>(cell)] = mean_of(ratings, person, cells[cell]);
    if (own.hasNaN()) continue;
    rows.push_back(own);
    if (design_.groups.empty()) continue;
    groups_.push_back(design_.groups[static_cast<std::size_t>(person)]);
    ++sizes[groups_.back()];
  }
  cells_.resize(static_cast<Index>(rows.size()), static_cast<Index>(cells.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) cells_.row(static_cast<Index>(i)) = rows[i];
  has_effects_ =
      rows.size() >= 2 && (design_.groups.empty() || *std::ranges::min_element(sizes) >= 2);
  is_crossed_ = has_effects_ && design_.is_complete;
  if (is_crossed_) squares_ = crossed_squares(crossed_ratings(ratings, cells, groups_));
}

void ScaleTests::add_contrast(const DesignContrast& contrast, const MatrixXd& ratings) {
  Scores& own = contrasts_.emplace_back();
  own.contrast = &contrast;
  for (Index person = 0; person < ratings.rows(); ++person) {
    double score = 0.0;
    for (std::size_t cell = 0; cell < contrast.cells.size(); ++cell)
      score += contrast.weights[cell] * mean_of(ratings, person, contrast.cells[cell]);
    if (!std::isnan(score)) own.scores.push_back(score);
  }
  own.is_crossed = design_.is_complete && ratings.rows() >= 2;
  if (!own.is_crossed) return;
  // The mixed model of the report has all cells of the analysis of variance, if the contrast
  // compares some of them.
  std::vector<std::vector<std::size_t>> cells = contrast.cells;
  own.weights = Eigen::Map<const VectorXd>(contrast.weights.data(),
                                           static_cast<Index>(contrast.weights.size()));
  const auto& all = design_.crossing.cells;
  const bool has_all = std::ranges::all_of(
      cells, [&](const auto& cell) { return std::ranges::find(all, cell) != all.end(); });
  if (has_all) {
    own.weights = VectorXd::Zero(static_cast<Index>(all.size()));
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      own.weights[std::ranges::find(all, cells[cell]) - all.begin()] = contrast.weights[cell];
    cells = all;
  }
  // Groups are not considered in contrasts.
  own.squares = crossed_squares(crossed_ratings(ratings, cells, {}));
}

int ScaleTests::people() const {
  if (has_effects_ || contrasts_.empty()) return static_cast<int>(cells_.rows());
  return static_cast<int>(contrasts_.front().scores.size());
}

void ScaleTests::add_effect_tests(const MatrixXd& shift, std::vector<TestedTwice>& tests) const {
  const auto& cells = design_.crossing.cells;
  MatrixXd shifted = cells_;
  for (Index row = 0; row < shifted.rows(); ++row) {
    const Index group =
        groups_.empty() ? 0 : static_cast<Index>(groups_[static_cast<std::size_t>(row)]);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      shifted(row, static_cast<Index>(cell)) +=
          shift(group, static_cast<Index>(cells[cell].front()));
  }
  const std::vector<int> levels = design_.levels();
  const std::vector<VarianceEffect> effects =
      analysis_of_variance(shifted, levels, groups_, EffectIntervals::omitted);
  const VectorXd means = shift_of_cells(shift, cells);
  for (const VarianceEffect& effect : effects) {
    // Stimuli are the same in all groups, so that their differences are no error of groups.
    const bool has_stimuli = is_crossed_ && !effect.by_group;
    tests.push_back(
        {effect.p_corrected,
         has_stimuli
             ? crossed_test(squares_, effect_contrasts(effect.factors, levels), random_, means).p
             : no_test});
  }
}

TestedTwice ScaleTests::test_of(const Scores& one, const MatrixXd& shift) const {
  double difference = 0.0;
  for (std::size_t cell = 0; cell < one.contrast->cells.size(); ++cell)
    difference +=
        one.contrast->weights[cell] * shift_of_cells(shift, {one.contrast->cells[cell]})[0];
  std::vector<double> scores = one.scores;
  for (double& score : scores) score += difference;
  TestedTwice result{paired_t_test(scores).p, no_test};
  if (!one.is_crossed) return result;
  // Only the contrast of the shift counts, whose shortest mean vector is this one.
  const VectorXd means = difference / one.weights.squaredNorm() * one.weights;
  result.by_both = crossed_test(one.squares, one.weights, random_, means).p;
  return result;
}

std::vector<TestedTwice> ScaleTests::tests(const MatrixXd& shift) const {
  std::vector<TestedTwice> tests;
  if (has_effects_)
    add_effect_tests(shift, tests);
  else
    tests.assign(design_.effects.size(), {no_test, no_test});
  for (const Scores& one : contrasts_) tests.push_back(test_of(one, shift));
  return tests;
}

}  // namespace mien::pipeline
