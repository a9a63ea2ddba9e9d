#include "pipeline/study/results/reliability.h"

#include <limits>

#include <Eigen/Core>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/study/results/summaries.h"

namespace mien::pipeline {

namespace {

/// Stimuli that were rated on the scale × people; NaN without an answer.
Eigen::MatrixXd table_on(const Gathered& gathered, std::size_t scale) {
  const auto people = static_cast<Eigen::Index>(gathered.people.size());
  Eigen::MatrixXd table(0, people);
  for (const auto& ratings : by_stimulus(gathered, scale)) {
    if (ratings.empty()) continue;
    Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(people);
    Eigen::RowVectorXd counts = Eigen::RowVectorXd::Zero(people);
    for (const CountedRating& rating : ratings) {
      sums[static_cast<Eigen::Index>(rating.person)] += rating.value;
      counts[static_cast<Eigen::Index>(rating.person)] += 1.0;
    }
    table.conservativeResize(table.rows() + 1, Eigen::NoChange);
    for (Eigen::Index i = 0; i < people; ++i)
      table(table.rows() - 1, i) =
          counts[i] > 0.0 ? sums[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return table;
}

}  // namespace

std::vector<Reliability> reliability_of(const Gathered& gathered) {
  std::vector<Reliability> all;
  if (gathered.ratings.empty()) return all;
  for (std::size_t scale = 0; scale < gathered.scales.size(); ++scale) {
    const Eigen::MatrixXd table = table_on(gathered, scale);
    const Agreement agreement = agreement_of(table);
    all.push_back({scale, agreement.all, agreement.complete_raters, agreement.alpha});
  }
  return all;
}

}  // namespace mien::pipeline
