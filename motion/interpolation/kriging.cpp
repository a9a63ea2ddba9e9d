#include "motion/interpolation/kriging.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/interpolation/parameter_table.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

constexpr double least_rcond = 1e-11;

double median_distance(const Eigen::MatrixXd& places) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      distances.push_back((places.row(i) - places.row(k)).norm());
    }
  }
  if (distances.empty()) return 1.0;
  const auto middle = distances.begin() + static_cast<long>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// Least squares over all pairs: the sill in closed form for each of a ladder of ranges.
Variogram fitted_variogram(const Eigen::MatrixXd& places, const Eigen::MatrixXd& differences,
                           double median) {
  Variogram best;
  double least = std::numeric_limits<double>::infinity();
  for (int step = -8; step <= 8; ++step) {
    const Variogram shape{1.0, median * std::exp2(step / 4.0)};
    double cross = 0.0, square = 0.0, total = 0.0;
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      for (Eigen::Index k = 0; k < i; ++k) {
        const double g = shape((places.row(i) - places.row(k)).norm());
        cross += g * differences(i, k);
        square += g * g;
        total += differences(i, k) * differences(i, k);
      }
    }
    if (square <= 0.0) continue;
    const double error = total - cross * cross / square;
    if (error >= least) continue;
    least = error;
    best = {cross / square, shape.range};
  }
  // Motions that are all the same say nothing: any positive sill gives the same weights.
  if (!(best.sill > 0.0)) best.sill = 1.0;
  return best;
}

Eigen::MatrixXd directions_of_spread(const Eigen::MatrixXd& centred) {
  if (centred.rows() < 2 || centred.cols() == 0) return Eigen::MatrixXd(centred.cols(), 0);
  const SingularValues svd = singular_values(centred);
  return svd.v.leftCols(svd.rank(singular_share));
}

/// The functions that weights reproduce, at parameters: 1 and the coordinates along the axes.
Eigen::VectorXd drift_at(const Kriging& kriging, const Eigen::RowVectorXd& parameters) {
  Eigen::VectorXd drift(kriging.drift_axes.cols() + 1);
  drift << 1.0, ((parameters - kriging.mean) * kriging.drift_axes).transpose();
  return drift;
}

Eigen::MatrixXd system_matrix(const Kriging& kriging, double nugget) {
  const Eigen::Index count = kriging.places.rows();
  const Eigen::Index drifts = kriging.drift_axes.cols() + 1;
  const Variogram shape{1.0, kriging.variogram.range};
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + drifts, count + drifts);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const double distance = (kriging.places.row(i) - kriging.places.row(k)).norm();
      matrix(i, k) = i == k ? -nugget : shape(distance);
    }
    const Eigen::VectorXd drift = drift_at(kriging, kriging.places.row(i));
    matrix.block(i, count, 1, drifts) = drift.transpose();
    matrix.block(count, i, drifts, 1) = drift;
  }
  return matrix;
}

}  // namespace

double Variogram::operator()(double distance) const {
  const double share = distance / range;
  return sill * -std::expm1(-share * share);
}

Kriging fit_kriging(const Eigen::MatrixXd& places, const KrigingOptions& options,
                    const std::optional<Eigen::MatrixXd>& half_squared_differences) {
  assert(places.rows() > 0);
  Kriging kriging;
  kriging.places = places;
  kriging.mean = places.colwise().mean();
  kriging.drift_axes = options.linear_drift ? directions_of_spread(places.rowwise() - kriging.mean)
                                            : Eigen::MatrixXd(places.cols(), 0);
  const double median = median_distance(places);
  kriging.variogram = {1.0, median};
  if (half_squared_differences && places.rows() > 2) {
    kriging.variogram = fitted_variogram(places, *half_squared_differences, median);
    kriging.fitted = true;
  }
  kriging.system = LinearSystem(system_matrix(kriging, options.nugget));
  while (kriging.system.reciprocal_condition() < least_rcond && kriging.halvings < 30) {
    kriging.variogram.range *= 0.5;
    ++kriging.halvings;
    kriging.system = LinearSystem(system_matrix(kriging, options.nugget));
  }
  return kriging;
}

KrigedWeights kriged_weights(const Kriging& kriging, const Eigen::RowVectorXd& parameters) {
  assert(parameters.size() == kriging.places.cols());
  const Eigen::Index count = kriging.places.rows();
  const Variogram shape{1.0, kriging.variogram.range};
  Eigen::VectorXd right(count + kriging.drift_axes.cols() + 1);
  for (Eigen::Index k = 0; k < count; ++k) {
    right[k] = shape((parameters - kriging.places.row(k)).norm());
  }
  right.tail(kriging.drift_axes.cols() + 1) = drift_at(kriging, parameters);
  const Eigen::VectorXd solved = kriging.system.solve(right);
  return {solved.head(count), kriging.variogram.sill * std::max(0.0, solved.dot(right))};
}

}  // namespace mien::motion
