#include "pipeline/study/results/agreement_remark.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien::pipeline {

namespace {

/// Whether all numbers of a table that are not missing are equal but for rounding errors.
bool are_equal(const Eigen::MatrixXd& numbers) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double number : numbers.reshaped()) {
    if (std::isnan(number)) continue;
    least = std::min(least, number);
    most = std::max(most, number);
  }
  return most - least <= 1e-9 * std::max({1.0, std::abs(least), std::abs(most)});
}

}  // namespace

std::string agreement_remark(const Eigen::MatrixXd& answers, const Agreement& agreement,
                             const std::string& many) {
  const Intraclass& all = agreement.all;
  if (all.stimuli < 2) return "none: fewer than two " + many;
  if (all.raters < 2) return "none: one participant";
  if (all.answers <= all.stimuli) return "none: one answer each";
  if (are_equal(answers)) return "none: all answers are equal";
  if (answers.allFinite() && are_equal(answers.rowwise().mean()))
    return "none: the means of all " + many + " are equal";
  if (!all.is_connected) return "in part: participants without " + many + " in common";
  // ICC(1) does not count: it is also negative where raters differ in level.
  if (all.two < 0.0 || agreement.alpha < 0.0)
    return "negative: differences between " + many + " are no larger than by chance";
  if (agreement.complete_raters < 2) return "α: fewer than two participants rated all " + many;
  return "";
}

bool states_none(const std::string& remark) { return remark.starts_with("none"); }

void set_none(Intraclass& intraclass, double& alpha) {
  for (double* value : {&intraclass.one, &intraclass.one_k, &intraclass.two, &intraclass.two_k,
                        &intraclass.three, &intraclass.three_k, &alpha})
    *value = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mien::pipeline
