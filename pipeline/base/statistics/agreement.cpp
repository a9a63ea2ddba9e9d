#include "pipeline/base/statistics/agreement.h"

#include <limits>

namespace mien::pipeline {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double variance(const Eigen::VectorXd& values) {
  return (values.array() - values.mean()).square().sum() / static_cast<double>(values.size() - 1);
}

double ratio(double above, double below) { return below == 0.0 ? unknown : above / below; }

Eigen::MatrixXd complete_columns(const Eigen::MatrixXd& answers) {
  std::vector<Eigen::Index> complete;
  for (Eigen::Index r = 0; r < answers.cols(); ++r)
    if (answers.col(r).allFinite()) complete.push_back(r);
  return answers(Eigen::all, complete);
}

}  // namespace

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
