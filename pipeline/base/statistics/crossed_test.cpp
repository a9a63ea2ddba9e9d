#include "pipeline/base/statistics/crossed_test.h"

#include <algorithm>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The means of columns within groups, one row for each group.
struct GroupMeans {
  MatrixXd means;
  std::vector<double> sizes;

  GroupMeans(const MatrixXd& values, const std::vector<std::size_t>& groups) {
    const std::size_t count = groups.empty() ? 1 : 1 + std::ranges::max(groups);
    means = MatrixXd::Zero(static_cast<Index>(count), values.cols());
    sizes.assign(count, 0.0);
    for (Index row = 0; row < values.rows(); ++row) {
      const std::size_t group = groups.empty() ? 0 : groups[static_cast<std::size_t>(row)];
      means.row(static_cast<Index>(group)) += values.row(row);
      sizes[group] += 1.0;
    }
    for (std::size_t g = 0; g < count; ++g) means.row(static_cast<Index>(g)) /= sizes[g];
  }
};

/// An estimated variance of a mean, in units of the mean square of the effect.
struct Term {
  double square;
  double degrees;
};

Term pooled(const Term& one, double one_scale, const Term& other, double other_scale) {
  const double degrees = one.degrees + other.degrees;
  return {
      (one.square / one_scale * one.degrees + other.square / other_scale * other.degrees) / degrees,
      degrees};
}

/// The mean square of error of the model with slopes. `scale` is the share of the variance of a
/// stimulus in that of an effect.
Term error_with_slopes(const Term& people, Term stimuli, Term within, double scale) {
  bool has_stimuli = stimuli.square > within.square;
  if (!has_stimuli) within = pooled(stimuli, 1.0, within, 1.0);
  if (people.square <= scale * within.square) {  // participants do not differ in the effect
    within = pooled(people, scale, within, 1.0);
    if (has_stimuli && stimuli.square > within.square)
      return {scale * stimuli.square, stimuli.degrees};
    if (has_stimuli) within = pooled(stimuli, 1.0, within, 1.0);
    return {scale * within.square, within.degrees};
  }
  if (!has_stimuli) return people;
  const double sum = people.square + scale * (stimuli.square - within.square);
  const auto part = [](double square, double degrees) { return square * square / degrees; };
  return {sum,
          sum * sum /
              (part(people.square, people.degrees) + part(scale * stimuli.square, stimuli.degrees) +
               part(scale * within.square, within.degrees))};
}

Term error_with_intercepts(const Term& stimuli, const Term& all, double scale) {
  const Term used = stimuli.square > all.square ? stimuli : pooled(stimuli, 1.0, all, 1.0);
  return {scale * used.square, used.degrees};
}

}  // namespace

CrossedSquares crossed_squares(const CrossedRatings& crossed) {
  const MatrixXd& ratings = crossed.ratings;
  const GroupMeans group_means(ratings, crossed.groups);
  const auto groups = static_cast<double>(group_means.sizes.size());
  CrossedSquares squares;
  double inverse = 0.0;
  for (const double size : group_means.sizes) inverse += 1.0 / size;
  squares.people = groups * groups / inverse;
  squares.person_degrees = static_cast<double>(ratings.rows()) - groups;

  const std::size_t cells = 1 + std::ranges::max(crossed.cells);
  squares.stimuli_of_cell.assign(cells, 0.0);
  MatrixXd of_cell = MatrixXd::Zero(ratings.cols(), static_cast<Index>(cells));
  for (std::size_t stimulus = 0; stimulus < crossed.cells.size(); ++stimulus) {
    of_cell(static_cast<Index>(stimulus), static_cast<Index>(crossed.cells[stimulus])) = 1.0;
    squares.stimuli_of_cell[crossed.cells[stimulus]] += 1.0;
  }
  MatrixXd averaging = of_cell;
  for (std::size_t cell = 0; cell < cells; ++cell)
    averaging.col(static_cast<Index>(cell)) /= squares.stimuli_of_cell[cell];

  const Eigen::RowVectorXd stimulus_means = group_means.means.colwise().mean();
  squares.cell_means = (stimulus_means * averaging).transpose();
  squares.stimulus_squares =
      (stimulus_means - squares.cell_means.transpose() * of_cell.transpose()).squaredNorm();
  squares.stimulus_degrees = static_cast<double>(crossed.cells.size() - cells);

  MatrixXd rest = ratings;
  for (Index row = 0; row < rest.rows(); ++row)
    rest.row(row) -= group_means.means.row(
        crossed.groups.empty() ? 0
                               : static_cast<Index>(crossed.groups[static_cast<std::size_t>(row)]));
  squares.person_deviations = rest * averaging;
  squares.within_squares = (rest - squares.person_deviations * of_cell.transpose()).squaredNorm();
  squares.within_degrees = squares.person_degrees * squares.stimulus_degrees;
  squares.all_squares = (rest.colwise() - rest.rowwise().mean()).squaredNorm();
  squares.all_degrees = squares.person_degrees * static_cast<double>(crossed.cells.size() - 1);
  return squares;
}

CrossedTest crossed_test(const CrossedSquares& squares, const MatrixXd& contrasts,
                         RandomParticipants participants, const VectorXd& shift) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto degrees = static_cast<double>(contrasts.cols());
  if (squares.stimulus_degrees < 1.0) return {none, degrees, none, none};
  const double length = contrasts.col(0).norm();
  const MatrixXd unit = contrasts / length;
  double scale = 0.0;
  for (Index cell = 0; cell < unit.rows(); ++cell)
    scale += unit.row(cell).squaredNorm() / squares.stimuli_of_cell[static_cast<std::size_t>(cell)];
  scale /= degrees;
  const double effect =
      squares.people * (unit.transpose() * (squares.cell_means + shift)).squaredNorm() / degrees;
  const Term stimuli = {squares.people * squares.stimulus_squares / squares.stimulus_degrees,
                        squares.stimulus_degrees};
  const Term error =
      participants == RandomParticipants::slopes
          ? error_with_slopes(
                {(squares.person_deviations * unit).squaredNorm() /
                     (degrees * squares.person_degrees),
                 degrees * squares.person_degrees},
                stimuli, {squares.within_squares / squares.within_degrees, squares.within_degrees},
                scale)
          : error_with_intercepts(
                stimuli, {squares.all_squares / squares.all_degrees, squares.all_degrees}, scale);
  if (!(error.square > 0.0)) return {none, degrees, none, none};
  const double f = effect / error.square;
  const boost::math::fisher_f distribution(degrees, error.degrees);
  return {f, degrees, error.degrees, cdf(complement(distribution, f))};
}

}  // namespace mien::pipeline
