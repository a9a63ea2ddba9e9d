#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

struct IterativeMotionWarpingOptions {
  double smoothness = 1e3;    ///< weight of the squared second differences of scale and offset
  double convergence = 1e-4;  ///< stops when the fit's error changes by a smaller share than this
  int most_iterations = 50;
};

/// A correspondence of two motions: y at row times(i) ≈ scale(i)·u(i) + offset(i).
struct MotionCorrespondence {
  std::vector<double> times;  ///< for each row of the input the row of the output, ascending
  Eigen::MatrixXd scale;      ///< as the input; varies smoothly over time
  Eigen::MatrixXd offset;
  double error = 0.0;  ///< root of the mean squared difference that is left
  int iterations = 0;
  bool converged = false;
};

/// Iterative motion warping (Hsu, Pulli and Popović 2005): time warp by dynamic programming of the
/// scaled and offset input onto the output, then scale and offset of each signal by least squares
/// for that time warp, in turn, from scale 1 and offset 0. Rows are moments, columns signals.
MotionCorrespondence iterative_motion_warping(const Eigen::MatrixXd& input,
                                              const Eigen::MatrixXd& output,
                                              const IterativeMotionWarpingOptions& options = {});

}  // namespace mien::motion
