#include "pipeline/base/statistics/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/QR>

namespace mien::pipeline {

namespace {

constexpr double no_reliability = std::numeric_limits<double>::quiet_NaN();

/// A whole that is this share of what it is the sum of is 0 but for rounding errors.
constexpr double rounding_share = 1e-12;

/// A rated cell of the table, rows and columns without answers left out.
struct RatedCell {
  Eigen::Index stimulus;
  Eigen::Index rater;
  double value;
};

struct RatedCells {
  std::vector<RatedCell> cells;
  Eigen::VectorXd per_stimulus;  ///< numbers of answers
  Eigen::VectorXd per_rater;
};

/// Indices of the lines that hold an answer; −1 of the others.
std::vector<Eigen::Index> numbered(Eigen::Index lines, const auto& holds) {
  std::vector<Eigen::Index> numbers;
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < lines; ++i) numbers.push_back(holds(i) ? next++ : -1);
  return numbers;
}

RatedCells cells_of(const Eigen::MatrixXd& answers) {
  const auto rows = numbered(
      answers.rows(), [&](Eigen::Index i) { return answers.row(i).array().isFinite().any(); });
  const auto columns = numbered(
      answers.cols(), [&](Eigen::Index r) { return answers.col(r).array().isFinite().any(); });
  RatedCells result;
  for (Eigen::Index i = 0; i < answers.rows(); ++i)
    for (Eigen::Index r = 0; r < answers.cols(); ++r)
      if (std::isfinite(answers(i, r)))
        result.cells.push_back({rows[static_cast<std::size_t>(i)],
                                columns[static_cast<std::size_t>(r)], answers(i, r)});
  Eigen::Index stimuli = 0;
  Eigen::Index raters = 0;
  for (const RatedCell& cell : result.cells) {
    stimuli = std::max(stimuli, cell.stimulus + 1);
    raters = std::max(raters, cell.rater + 1);
  }
  result.per_stimulus = Eigen::VectorXd::Zero(stimuli);
  result.per_rater = Eigen::VectorXd::Zero(raters);
  for (const RatedCell& cell : result.cells) {
    result.per_stimulus[cell.stimulus] += 1.0;
    result.per_rater[cell.rater] += 1.0;
  }
  return result;
}

/// What is left of the answers after the means of stimuli, of raters, and of both have been taken.
struct Residuals {
  double of_stimuli = 0.0;
  double of_raters = 0.0;
  double of_both = 0.0;
  bool is_connected = false;
};

/// The additive fit by its normal equations with the raters eliminated.
Residuals residuals_of(const RatedCells& rated) {
  const Eigen::Index stimuli = rated.per_stimulus.size();
  const Eigen::Index raters = rated.per_rater.size();
  Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(stimuli, raters);
  Eigen::VectorXd stimulus_sum = Eigen::VectorXd::Zero(stimuli);
  Eigen::VectorXd rater_sum = Eigen::VectorXd::Zero(raters);
  double mean = 0.0;
  for (const RatedCell& cell : rated.cells) mean += cell.value;
  mean /= static_cast<double>(rated.cells.size());
  for (const RatedCell& cell : rated.cells) {
    seen(cell.stimulus, cell.rater) = 1.0;
    stimulus_sum[cell.stimulus] += cell.value - mean;
    rater_sum[cell.rater] += cell.value - mean;
  }
  const Eigen::VectorXd rater_mean = rater_sum.cwiseQuotient(rated.per_rater);
  const Eigen::VectorXd stimulus_mean = stimulus_sum.cwiseQuotient(rated.per_stimulus);
  const Eigen::MatrixXd shares = seen * rated.per_rater.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd reduced =
      Eigen::MatrixXd(rated.per_stimulus.asDiagonal()) - shares * seen.transpose();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(reduced.rows(), reduced.cols());
  solver.setThreshold(1e-9);
  solver.compute(reduced);
  const Eigen::VectorXd stimulus_effect = solver.solve(stimulus_sum - seen * rater_mean);
  const Eigen::VectorXd rater_effect =
      (rater_sum - seen.transpose() * stimulus_effect).cwiseQuotient(rated.per_rater);
  Residuals residuals;
  residuals.is_connected = solver.rank() == stimuli - 1;
  const auto square = [](double value) { return value * value; };
  for (const RatedCell& cell : rated.cells) {
    const double value = cell.value - mean;
    residuals.of_stimuli += square(value - stimulus_mean[cell.stimulus]);
    residuals.of_raters += square(value - rater_mean[cell.rater]);
    residuals.of_both += square(value - stimulus_effect[cell.stimulus] - rater_effect[cell.rater]);
  }
  return residuals;
}

double total_squares(const RatedCells& rated) {
  double mean = 0.0;
  for (const RatedCell& cell : rated.cells) mean += cell.value;
  mean /= static_cast<double>(rated.cells.size());
  double sum = 0.0, size = 0.0;
  for (const RatedCell& cell : rated.cells) {
    sum += (cell.value - mean) * (cell.value - mean);
    size += cell.value * cell.value;
  }
  return sum <= rounding_share * rounding_share * size ? 0.0 : sum;
}

/// `size`: of the terms whose sum `whole` is. Sums of variances that are estimated as 0 or less
/// have no parts.
double part_of(double part, double whole, double size) {
  return whole <= rounding_share * size ? no_reliability : part / whole;
}

void set_one_way_icc(Intraclass& result, double total, double within) {
  const double n = result.stimuli;
  const double msb = (total - within) / (n - 1.0);
  const double msw = within / (result.answers - n);
  result.one = part_of(msb - msw, msb + (result.answers_per_stimulus - 1.0) * msw, msb + msw);
  result.one_k = part_of(msb - msw, msb, msb + msw);
}

void set_two_way_icc(Intraclass& result, const Residuals& residuals) {
  const double n = result.stimuli;
  const double k = result.raters;
  const double all = result.answers;
  const double degrees = all - n - k + 1.0;
  if (!residuals.is_connected || degrees <= 0.0 || k < 2.0) return;
  const double rest = residuals.of_both / degrees;
  const double stimuli = (residuals.of_raters - residuals.of_both - (n - 1.0) * rest) / (all - k);
  const double raters = (residuals.of_stimuli - residuals.of_both - (k - 1.0) * rest) / (all - n);
  const double usual = result.answers_per_stimulus;
  const double size = std::abs(stimuli) + std::abs(raters) + rest;
  result.two = part_of(stimuli, stimuli + raters + rest, size);
  result.two_k = part_of(stimuli, stimuli + (raters + rest) / usual, size);
  result.three = part_of(stimuli, stimuli + rest, size);
  result.three_k = part_of(stimuli, stimuli + rest / usual, size);
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double variance(const Eigen::VectorXd& values) {
  return (values.array() - values.mean()).square().sum() / static_cast<double>(values.size() - 1);
}

double ratio(double above, double below) {
  return below <= rounding_share * above || below == 0.0 ? unknown : above / below;
}

Eigen::MatrixXd complete_columns(const Eigen::MatrixXd& answers) {
  std::vector<Eigen::Index> complete;
  for (Eigen::Index r = 0; r < answers.cols(); ++r)
    if (answers.col(r).allFinite()) complete.push_back(r);
  return answers(Eigen::all, complete);
}

}  // namespace

Intraclass intraclass(const Eigen::MatrixXd& answers) {
  const RatedCells rated = cells_of(answers);
  Intraclass result;
  result.stimuli = static_cast<int>(rated.per_stimulus.size());
  result.raters = static_cast<int>(rated.per_rater.size());
  result.answers = static_cast<int>(rated.cells.size());
  for (double* value :
       {&result.one, &result.one_k, &result.two, &result.two_k, &result.three, &result.three_k})
    *value = no_reliability;
  if (result.stimuli < 2) return result;
  const double all = result.answers;
  result.answers_per_stimulus =
      (all - rated.per_stimulus.squaredNorm() / all) / (result.stimuli - 1.0);
  if (result.answers <= result.stimuli) return result;
  const double total = total_squares(rated);
  if (total == 0.0) return result;
  const Residuals residuals = residuals_of(rated);
  result.is_connected = residuals.is_connected;
  set_one_way_icc(result, total, residuals.of_stimuli);
  set_two_way_icc(result, residuals);
  return result;
}

double cronbach_alpha(const Eigen::MatrixXd& answers) {
  if (answers.rows() < 2 || answers.cols() < 2) return unknown;
  double of_raters = 0.0;
  for (Eigen::Index r = 0; r < answers.cols(); ++r) of_raters += variance(answers.col(r));
  const auto k = static_cast<double>(answers.cols());
  return k / (k - 1.0) * (1.0 - ratio(of_raters, variance(answers.rowwise().sum())));
}

Agreement agreement_of(const Eigen::MatrixXd& answers) {
  const Eigen::MatrixXd complete = complete_columns(answers);
  return {static_cast<int>(complete.cols()), cronbach_alpha(complete), intraclass(complete).two_k,
          intraclass(answers)};
}

}  // namespace mien::pipeline
