#include "pipeline/base/statistics/agreement.h"

#include <cmath>
#include <limits>

namespace mien::pipeline {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double variance(const Eigen::VectorXd& values) {
  return (values.array() - values.mean()).square().sum() / static_cast<double>(values.size() - 1);
}

double ratio(double above, double below) { return below == 0.0 ? unknown : above / below; }

bool all_equal(const Eigen::MatrixXd& answers) { return (answers.array() == answers(0, 0)).all(); }

Eigen::MatrixXd complete_columns(const Eigen::MatrixXd& answers) {
  std::vector<Eigen::Index> complete;
  for (Eigen::Index r = 0; r < answers.cols(); ++r) {
    if (answers.col(r).allFinite()) complete.push_back(r);
  }
  return answers(Eigen::all, complete);
}

std::vector<std::vector<double>> answers_by_row(const Eigen::MatrixXd& answers) {
  std::vector<std::vector<double>> by_row(static_cast<size_t>(answers.rows()));
  for (Eigen::Index i = 0; i < answers.rows(); ++i) {
    for (Eigen::Index r = 0; r < answers.cols(); ++r) {
      if (std::isfinite(answers(i, r))) by_row[static_cast<size_t>(i)].push_back(answers(i, r));
    }
  }
  return by_row;
}

/// N − Σn²/N over stimuli − 1.
double usual_count(const std::vector<std::vector<double>>& by_stimulus) {
  double all = 0.0;
  double squares = 0.0;
  for (const auto& answers : by_stimulus) {
    const auto n = static_cast<double>(answers.size());
    all += n;
    squares += n * n;
  }
  if (by_stimulus.size() < 2 || all == 0.0) return all;
  return (all - squares / all) / static_cast<double>(by_stimulus.size() - 1);
}

}  // namespace

double cronbach_alpha(const Eigen::MatrixXd& answers) {
  if (answers.rows() < 2 || answers.cols() < 2) return unknown;
  double of_raters = 0.0;
  for (Eigen::Index r = 0; r < answers.cols(); ++r) of_raters += variance(answers.col(r));
  const auto k = static_cast<double>(answers.cols());
  return k / (k - 1.0) * (1.0 - ratio(of_raters, variance(answers.rowwise().sum())));
}

double icc_2_k(const Eigen::MatrixXd& answers) {
  if (answers.rows() < 2 || answers.cols() < 2 || all_equal(answers)) return unknown;
  const auto n = static_cast<double>(answers.rows());
  const auto k = static_cast<double>(answers.cols());
  const double mean = answers.mean();
  const Eigen::VectorXd by_stimulus = answers.rowwise().mean();
  const Eigen::RowVectorXd by_rater = answers.colwise().mean();
  const double rows = k * (by_stimulus.array() - mean).square().sum();
  const double columns = n * (by_rater.array() - mean).square().sum();
  const double rest =
      (((answers.colwise() - by_stimulus).rowwise() - by_rater).array() + mean).square().sum();
  const double msr = rows / (n - 1.0);
  const double msc = columns / (k - 1.0);
  const double mse = rest / ((n - 1.0) * (k - 1.0));
  return ratio(msr - mse, msr + (msc - mse) / n);
}

double icc_1_k(const std::vector<std::vector<double>>& answers_by_stimulus) {
  double sum = 0.0;
  double count = 0.0;
  for (const auto& answers : answers_by_stimulus) {
    for (const double answer : answers) sum += answer;
    count += static_cast<double>(answers.size());
  }
  const auto stimuli = static_cast<double>(answers_by_stimulus.size());
  if (stimuli < 2.0 || count <= stimuli) return unknown;
  double between = 0.0;
  double within = 0.0;
  for (const auto& answers : answers_by_stimulus) {
    if (answers.empty()) return unknown;
    double own = 0.0;
    for (const double answer : answers) own += answer;
    own /= static_cast<double>(answers.size());
    for (const double answer : answers) within += (answer - own) * (answer - own);
    between += static_cast<double>(answers.size()) * (own - sum / count) * (own - sum / count);
  }
  const double msb = between / (stimuli - 1.0);
  return ratio(msb - within / (count - stimuli), msb);
}

Agreement agreement_of(const Eigen::MatrixXd& answers) {
  Agreement result;
  for (Eigen::Index r = 0; r < answers.cols(); ++r) {
    if (answers.col(r).array().isFinite().any()) ++result.raters;
  }
  const Eigen::MatrixXd complete = complete_columns(answers);
  const auto by_stimulus = answers_by_row(answers);
  result.complete_raters = static_cast<int>(complete.cols());
  result.alpha = cronbach_alpha(complete);
  result.icc_2_k = icc_2_k(complete);
  result.answers_per_stimulus = usual_count(by_stimulus);
  result.icc_1_k = icc_1_k(by_stimulus);
  return result;
}

}  // namespace mien::pipeline
