#include "motion/style_transfer/iterative_motion_warping.h"

#include <cmath>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "motion/math/dynamic_time_warp.h"

namespace mien::motion {

namespace {

/// Keeps the equations solvable where a signal stands still: there the scale stays 1.
constexpr double scale_held = 1e-9;

using Triplets = std::vector<Eigen::Triplet<double>>;

/// weight · (v(i−1) − 2v(i) + v(i+1))² of the unknowns `first`, `first` + 2, … as normal equations.
void add_smoothness(Triplets& triplets, Eigen::Index rows, Eigen::Index first, double weight) {
  const double taps[] = {1.0, -2.0, 1.0};
  for (Eigen::Index i = 0; i + 2 < rows; ++i) {
    for (int p = 0; p < 3; ++p) {
      for (int q = 0; q < 3; ++q) {
        triplets.emplace_back(first + 2 * (i + p), first + 2 * (i + q), weight * taps[p] * taps[q]);
      }
    }
  }
}

/// Scale (even) and offset (odd places) of one signal that bring `input` nearest to `target`.
Eigen::VectorXd fitted(const Eigen::VectorXd& input, const Eigen::VectorXd& target,
                       double smoothness) {
  const Eigen::Index rows = input.size();
  const double size = input.squaredNorm() / static_cast<double>(rows);
  Triplets triplets;
  Eigen::VectorXd right(2 * rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double u = input[i];
    triplets.emplace_back(2 * i, 2 * i, u * u + scale_held);
    triplets.emplace_back(2 * i, 2 * i + 1, u);
    triplets.emplace_back(2 * i + 1, 2 * i, u);
    triplets.emplace_back(2 * i + 1, 2 * i + 1, 1.0);
    right[2 * i] = u * target[i] + scale_held;
    right[2 * i + 1] = target[i];
  }
  add_smoothness(triplets, rows, 0, smoothness * (size + scale_held));
  add_smoothness(triplets, rows, 1, smoothness);
  Eigen::SparseMatrix<double> normal(2 * rows, 2 * rows);
  normal.setFromTriplets(triplets.begin(), triplets.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normal).solve(right);
}

void fit_scale_and_offset(MotionCorrespondence& found, const Eigen::MatrixXd& input,
                          const Eigen::MatrixXd& target, double smoothness) {
  for (Eigen::Index c = 0; c < input.cols(); ++c) {
    const Eigen::VectorXd both = fitted(input.col(c), target.col(c), smoothness);
    for (Eigen::Index i = 0; i < input.rows(); ++i) {
      found.scale(i, c) = both[2 * i];
      found.offset(i, c) = both[2 * i + 1];
    }
  }
}

}  // namespace

MotionCorrespondence iterative_motion_warping(const Eigen::MatrixXd& input,
                                              const Eigen::MatrixXd& output,
                                              const IterativeMotionWarpingOptions& options) {
  MotionCorrespondence found;
  found.scale = Eigen::MatrixXd::Ones(input.rows(), input.cols());
  found.offset = Eigen::MatrixXd::Zero(input.rows(), input.cols());
  const auto warped_input = [&]() -> Eigen::MatrixXd {
    return found.scale.cwiseProduct(input) + found.offset;
  };
  while (found.iterations < options.most_iterations && !found.converged) {
    ++found.iterations;
    found.times = dynamic_time_warp(warped_input(), output);
    const Eigen::MatrixXd target = rows_at(output, found.times);
    const bool is_input = (target - input).cwiseAbs().maxCoeff() == 0.0;
    if (!is_input) fit_scale_and_offset(found, input, target, options.smoothness);
    const double before = found.error;
    found.error =
        std::sqrt((warped_input() - target).squaredNorm() / static_cast<double>(input.size()));
    found.converged = is_input || (found.iterations > 1 &&
                                   std::abs(before - found.error) <= options.convergence * before);
  }
  return found;
}

}  // namespace mien::motion
