#include "motion/interpolation/reach.h"

#include <cassert>

#include "motion/math/convex_weights.h"

namespace mien::motion {

namespace {

/// How much more a miss of a held parameter counts than a weight that is not the basis'. Squared,
/// it keeps rounding errors in double precision six digits below the misses that are reported.
constexpr double held_share = 1e3;

/// A linear programme is solved as the quadratic one that also keeps Σ w² small, by this share: its
/// optimum is off by half of it at most.
constexpr double roundness = 1e-6;

/// The extreme of slopes · w among weights of the same mean as `start`.
double least_of(const Eigen::MatrixXd& points, const Eigen::VectorXd& start,
                const Eigen::VectorXd& slopes) {
  const auto count = points.cols();
  const Eigen::VectorXd weights = least_squares_at_mean(
      points, start, Eigen::MatrixXd::Identity(count, count), -slopes / roundness);
  return slopes.dot(weights);
}

}  // namespace

Reach fit_reach(const Eigen::MatrixXd& places, Eigen::Index held) {
  assert(held >= 0 && held < places.cols());
  const Eigen::Index asked = places.cols() - held;
  return {fit_cardinal_basis(places.leftCols(asked)), places.leftCols(asked).transpose(),
          places.rightCols(held).transpose()};
}

Eigen::VectorXd weights(const Reach& reach, const Eigen::RowVectorXd& parameters) {
  const Eigen::Index held = reach.held_rows.rows();
  const Eigen::RowVectorXd asked = parameters.leftCols(reach.asked.rows());
  const Eigen::VectorXd start = weights_nearest_to(reach.asked, asked.transpose());
  const auto count = reach.asked.cols();
  Eigen::MatrixXd c(held + count, count);
  c << held_share * reach.held_rows, Eigen::MatrixXd::Identity(count, count);
  Eigen::VectorXd d(held + count);
  d << held_share * parameters.rightCols(held).transpose(), weights(reach.basis, asked);
  return least_squares_at_mean(reach.asked, start, c, d);
}

ParameterRange feasible_range(const Eigen::MatrixXd& places, const Eigen::RowVectorXd& request,
                              Eigen::Index which) {
  assert(which >= 0 && which < places.cols() && request.size() == places.cols());
  const Eigen::Index others = places.cols() - 1;
  Eigen::MatrixXd points(others, places.rows());
  Eigen::VectorXd target(others);
  for (Eigen::Index m = 0, row = 0; m < places.cols(); ++m) {
    if (m == which) continue;
    points.row(row) = places.col(m).transpose();
    target[row++] = request[m];
  }
  const Eigen::VectorXd slopes = places.col(which);
  const Eigen::VectorXd start = weights_nearest_to(points, target);
  return {least_of(points, start, slopes), -least_of(points, start, -slopes),
          (points * start - target).norm()};
}

double effective_examples(const Eigen::VectorXd& weights) { return 1.0 / weights.squaredNorm(); }

}  // namespace mien::motion
